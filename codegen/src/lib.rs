//! The code generator of denhart: from an arm file to Rust code.
//!
//! The pipeline, one direction only:
//!
//! ```text
//! spec (YAML text) -> model (checked chain) -> symbolic (expressions) -> kinematics, solve -> lower (programs) -> emit (Rust tokens)
//! ```
//!
//! The derive macro, the [`Builder`] of a build script and the command `denhart expand` all call [`generate`].

#![cfg_attr(docsrs, feature(doc_cfg))]

mod arm_file;
#[cfg(feature = "file")]
mod builder;
mod emit;
pub mod error;
mod generate;
mod kinematics;
pub mod lower;
pub mod model;
mod report;
mod settings;
mod solve;
pub mod spec;
mod stages;
mod symbolic;

pub use arm_file::{ReadError, decode, read as read_file};
#[cfg(feature = "file")]
pub use builder::{BuildError, Builder};
pub use emit::{Scalar as ScalarKind, UnknownScalar};
pub use error::{Diagnostic, Errors, Location, Severity};
pub use generate::{Generated, Options, Program, check, generate, program};
#[doc(hidden)]
pub use generate::{stages_text, takes_a_choice};
pub use model::Bound;
pub use report::Report;
pub use solve::{AxesRelation, Choice, DecidingAxes, Way};
