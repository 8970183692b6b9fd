//! Kinematics of serial robot arms, generated from their Denavit-Hartenberg table.
//!
//! An arm is described once, by its table. From the table come plain Rust functions for the pose of the tool, the
//! Jacobian and every branch of the inverse kinematics. The functions are straight-line arithmetic: no allocation, no
//! panic, no `std` needed. This crate holds what the generated code and its callers share: poses, Jacobians, solutions
//! with their status, and the traits [`Arm`](trait@Arm) and [`InverseKinematics`]. It also holds the scalar kernels
//! that the generated code calls.
//!
//! # Conventions
//! - Angles are radians. Lengths are in the unit of the arm's table, see [`LengthUnit`].
//! - A [`Pose`] maps tool coordinates to base coordinates. A [`Jacobian`] is geometric, in the base frame, at the tool
//!   point, with rows `vx vy vz wx wy wz`.
//! - Joints count from 0 in code and from 1 in printed text (`q1` is `q[0]`).
//!
//! # Features
//! | feature | default | gives |
//! |---|---|---|
//! | `std` | yes | the square root of the standard library, faster than the one here |
//! | `derive` | yes | `#[derive(Arm)]` |
//! | `nalgebra` | no | conversions to and from nalgebra; with `std` also `Chain`, an arm from its table at run time |
//! | `libm` | no | the square root of the `libm` crate, for targets without `std` |
//! | `fpu` | no | the square root instruction of the processor, for targets without `std` that have one |
//! | `batch` | no | many poses at a time, with the instructions of the vector unit; needs `std` |
//!
//! Only `Chain` allocates.

#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod actuator;
mod analytic;
mod arm;
#[cfg(feature = "batch")]
pub mod batch;
mod branch;
#[cfg(all(feature = "nalgebra", feature = "std"))]
mod chain;
mod combined_limit;
mod delegate;
mod deviation;
mod dh;
pub mod effort;
mod flags;
pub mod follow;
pub mod held_joint;
mod jacobian;
mod limits;
mod manipulability;
mod margin;
mod motion;
#[cfg(feature = "nalgebra")]
mod nalgebra_convert;
pub mod numeric;
mod orientation;
mod pose;
mod solution;
mod solutions;
pub mod solve;
mod target;
mod vector;
mod windings;

pub use actuator::{Actuator, Quantized};
pub use analytic::AnalyticJacobian;
pub use arm::{Arm, InverseBranch, InverseKinematics};
pub use branch::{Branch, Elbow, ParseBranchError, Shoulder, Wrist};
#[cfg(all(feature = "nalgebra", feature = "std"))]
pub use chain::{Chain, ChainError};
pub use combined_limit::CombinedLimit;
pub use denhart_core::math;
pub use deviation::Deviation;
pub use dh::{Convention, DhFrame, DhRow, DhTable, JointKind, LengthUnit};
pub use flags::{Flags, JointMask};
pub use jacobian::Jacobian;
pub use margin::Margin;
pub use math::Scalar;
pub use motion::{Acceleration, Twist};
pub use orientation::{AxisAngle, Euler, EulerOrder};
pub use pose::Pose;
pub use solution::{OneSolution, Residual, Solution, Status};
pub use solutions::Solutions;
pub use target::{PlanarPose, PointAngle, PointAxis, Target};
pub use windings::Windings;

/// Derives [`Arm`](trait@Arm), and where the arm has a closed form [`InverseKinematics`], from a table in YAML.
#[cfg(feature = "derive")]
pub use denhart_macros::Arm;
