//! Kinematics of robot arms that are known only at run time.
//!
//! An arm file is read, planned, and evaluated. The expressions and the plan are the very ones that `denhart` generates
//! code from, and the kernels are those of its runtime. There is no second derivation and no second solver, so the
//! results are those of the generated code in `f64`, to the bit. Evaluation takes a few times as long as compiled code.
//!
//! ```
//! use denhart_dynamic::{DynamicArm, DynamicError};
//!
//! # fn main() -> Result<(), DynamicError> {
//! let arm = DynamicArm::from_yaml(
//!     "
//! name: elbow
//! convention: standard
//! units: {length: m, angle: deg}
//! joints:
//!   - {a: 0.3, alpha: 0, d: 0, theta: 0}
//!   - {a: 0.2, alpha: 0, d: 0, theta: 0}
//! ",
//! )?;
//! let target = arm.target_at(&[0.4, -1.1])?;
//! let solutions = arm.inverse(&target, &[])?;
//! assert_eq!(solutions.len(), 2);
//! assert!(solutions.iter().any(|solution| (solution.q[1] + 1.1).abs() < 1e-12));
//! # Ok(())
//! # }
//! ```
//!
//! # What generated code has besides
//! - Lengths bound at run time (`parameters` as fields): here they have the values of the file.
//! - `f32`.
//!
//! An inverse whose number of solutions is not one that the planner is known to give is refused as
//! [`DynamicError::Unsupported`]. So is one of ten joints in WebAssembly, where code is downloaded.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod arm;
mod arm_constants;
#[cfg(feature = "batch")]
mod batch;
mod branches;
mod error;
mod function;
mod held_joint;
mod inverse;
mod joints;
mod kernel;
mod margins;
mod motion;
mod nest;
pub mod plan;
mod pulses;
mod redundancy;
mod run;
mod solutions;
mod solver;
mod tape;
mod target;
mod trace;
mod view;
mod why;

pub use arm::{DynamicArm, DynamicJacobian};
pub use error::DynamicError;
pub use joints::Joints;
pub use margins::DynamicMargin;
pub use pulses::DynamicQuantized;
pub use solutions::{DynamicSolution, DynamicSolutions};
pub use target::DynamicTarget;
pub use view::{DynamicView, ViewSolutions, WholeTarget};
pub use why::DynamicMiss;
