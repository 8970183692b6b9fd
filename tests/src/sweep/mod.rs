//! Random arms, evaluated: what rustc could not compile in a lifetime.
//!
//! An arm is drawn with a structure (`structure.rs`), written as an arm file, read, planned and evaluated. Forward
//! kinematics, link poses and Jacobian are held against the chain of the drawn numbers, the inverse against the rules of
//! the suites: [`recover`](crate::recover), [`boundary`](crate::boundary), [`bad_targets`](crate::bad_targets),
//! [`effort`](crate::effort). Everything comes from the seed and the index of the arm, whatever thread does it.

pub mod arm;
mod beside;
mod draw;
mod examine;
pub mod known;
pub mod outcome;
pub mod replay;
pub mod run;
mod structure;
mod table;

pub use draw::{Kind, draw};
pub use table::Table;
