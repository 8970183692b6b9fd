//! Forward kinematics and the geometric Jacobian as expressions.

mod link;
mod poses;
mod sweep;

pub use link::elementary;
pub use poses::{LinkPoses, link_poses};
pub use sweep::{Column, Kinematics, Wanted, kinematics};
