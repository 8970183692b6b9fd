//! Orientations in other terms than a matrix: Euler angles, unit quaternions, rotation vectors, and the pose error as a
//! twist. Plain arrays; the conversions to nalgebra's types stand behind the feature `nalgebra`.
//!
//! | form | from | to | where it is not unique |
//! |---|---|---|---|
//! | roll, pitch, yaw | [`Pose::from_xyz_rpy`] | [`Pose::rpy`] | pitch +-90 degrees: roll is 0, reported |
//! | Euler angles, 12 orders | [`Pose::from_xyz_euler`] | [`Pose::euler`] | [`EulerOrder`]: the third angle is 0, reported |
//! | unit quaternion `w x y z` | [`Pose::from_xyz_quaternion`] | [`Pose::quaternion`] | two signs: `w >= 0` |
//! | rotation vector | [`Pose::from_xyz_rotation_vector`] | [`Pose::rotation_vector`] | half a turn: two signs |
//! | axis and angle | [`Pose::from_xyz_axis_angle`] | [`Pose::axis_angle`] | no turn: the axis is z |
//! | twist to another pose | | [`Pose::error_to`] | half a turn: two signs |
//!
//! [`Pose::orthonormalized`] gives the rotation nearest to a matrix that is one only roughly.
//!
//! Nothing uses `asin` or `acos`: every angle comes from two components of which one is not stationary. So accuracy
//! does not fade near a singular orientation. Converted back to a matrix, every entry is off by a few roundings at most.

mod axis_angle;
mod euler;
mod nearest;
mod quaternion;

pub use axis_angle::AxisAngle;
pub use euler::{Euler, EulerOrder};

#[cfg(test)]
mod tests;
