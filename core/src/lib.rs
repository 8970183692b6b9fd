//! Mathematics that denhart's generator and its generated code share.
//!
//! The generator chooses at build time how an arm without a closed form is solved. For this choice it runs the numeric
//! kernels that the generated code calls, so the kernels stand in a crate on which both depend. The crate `denhart`
//! re-exports all of this one: generated code and its callers name `denhart` alone.
//!
//! # Features
//! `std`, `libm` and `fpu` choose the square root, as the features of `denhart` with the same names do. `batch` gives
//! `lanes`: numbers of several poses at once.

#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

#[cfg(any(feature = "std", test))]
extern crate std;

mod branches;
pub mod chain;
pub mod choice;
pub mod general;
pub mod held_joint;
#[cfg(feature = "batch")]
pub mod lanes;
pub mod math;
pub mod meet;
mod pair;
pub mod refine;
pub mod slides;
pub mod transform;
pub mod trig_polynomial;
mod wave;

pub use chain::Chain;
pub use held_joint::{Candidate, Outcome, Visitor};
pub use math::Scalar;
pub use transform::Transform;
