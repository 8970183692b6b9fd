//! How far the tool is from a target, and how that depends on the joints.

use crate::flags::JointMask;
use crate::jacobian::Jacobian;
use crate::pose::Pose;
use crate::solve::{Goal, Tolerances};

/// Twist from the tool to a target, and its derivative by the joints.
///
/// Only what the target asks for counts: a row that the task leaves open is 0, in the twist and in the Jacobian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation<T, const N: usize> {
    /// `vx vy vz wx wy wz` from the tool to the target, in the base frame; of the task `position_angle` and of a pose in
    /// the plane the angle stands in the fourth place.
    pub twist: [T; 6],
    /// Change of the tool in those six rows for each joint: `jacobian dq = twist` is Newton's step. Joints whose value
    /// the target gives have columns of 0.
    pub jacobian: Jacobian<T, N>,
    /// Joints whose value comes with the target.
    pub given: JointMask,
}

impl<T: Tolerances, const N: usize> Deviation<T, N> {
    /// The deviation of the tool at `q`, from its pose and Jacobian there.
    #[doc(hidden)]
    pub fn new<G: Goal<T, N>>(goal: &G, q: &[T; N], (pose, jacobian): &(Pose<T>, Jacobian<T, N>)) -> Self {
        let mut jacobian = *jacobian;
        goal.restrict(pose, &mut jacobian);
        Self { twist: goal.twist(q, pose), jacobian, given: goal.given() }
    }
}
