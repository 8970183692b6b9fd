//! Constants of an arm, as the search needs them.

use super::kernel::tolerances::Tolerances;
use crate::{Arm, CombinedLimit, Jacobian, JointMask, Pose, Residual};

/// Constants of an arm that the search reads: limits, weights, reach and tolerances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmConstants<'a, T, const N: usize> {
    /// Lower and upper limit of every joint, infinite where there is none.
    pub limits: &'a [[T; 2]; N],
    /// Limits of sums of joint values.
    pub combined: &'a [CombinedLimit<T, N>],
    /// How much each joint counts in the distance from a reference, the squared norm `sum w (q - q_ref)^2`.
    pub weights: &'a [T; N],
    /// True if any joint has limits.
    pub limited: bool,
    /// The sliding joints.
    pub prismatic: JointMask,
    /// The joint that moves with a virtual one, and is named in its place where that is free.
    pub stands_for: JointMask,
    /// The joints a, b, c of a spherical wrist with axes at right angles, where it is the last step. Its two roots differ
    /// by the wrist flip `(a + pi, -b, c + pi)`.
    pub wrist: Option<[usize; 3]>,
    /// Reach of the arm, in its length unit.
    pub reach: T,
    /// Residuals up to this are listed as approximate solutions.
    pub tolerance: Residual<T>,
}

impl<T: Tolerances, const N: usize> ArmConstants<'_, T, N> {
    /// Sets lengths that are known at run time: the reach, and the largest position residual of a listed solution. An
    /// arm without any length has the reach 1.
    ///
    /// `None` if the reach is not finite, or not between 1e-60 and 1e60 (f32: 1e-4 and 1e8) of the length unit. Beyond,
    /// products of four of the arm's lengths, which the kernels compute, come near the ends of the scalar's range.
    #[inline]
    pub fn with_reach(mut self, reach: T, position: T) -> Option<Self> {
        if reach == T::ZERO {
            self.tolerance.position = position.max(T::from_f64(1e-6));
            self.reach = T::ONE;
            return Some(self);
        }
        self.reach = reach;
        self.tolerance.position = position;
        (reach < T::LARGEST_REACH && reach > T::SMALLEST_REACH).then_some(self)
    }

    /// Returns true if a joint vector can be a reference: it is finite, and its angles are not wound too far. Beyond
    /// `MOST_WOUND` the rounding of an angle is more than an exact solution may miss by.
    #[inline]
    pub(super) fn can_refer(&self, near: &[T; N]) -> bool {
        let mut joints = near.iter().enumerate();
        joints.all(|(joint, q)| q.is_finite() && (self.prismatic.contains(joint) || q.abs() <= T::MOST_WOUND))
    }

    /// Where each joint stays if it is free: its reference value; without one 0, or the limit nearest to 0.
    #[inline]
    pub(super) fn defaults(&self, near: Option<&[T; N]>) -> [T; N] {
        let Some(near) = near else {
            return self.limits.map(|[low, high]| if low > T::ZERO { low } else { high.min(T::ZERO) });
        };
        let mut defaults = *near;
        for joint in self.prismatic.iter() {
            // A slide farther off than the arm reaches beyond its limits is no place to stay.
            if let (Some(default), Some([low, high])) = (defaults.get_mut(joint), self.limits.get(joint)) {
                let (low, high) = (low.max(-self.reach * T::TWO), high.min(self.reach * T::TWO));
                *default = default.max(low - self.reach).min(high + self.reach);
            }
        }
        defaults
    }

    /// The unit in which a joint is measured: 1 rad, or the reach for a prismatic joint.
    #[inline]
    pub(super) fn unit(&self, joint: usize) -> T {
        if self.prismatic.contains(joint) { self.reach } else { T::ONE }
    }

    /// The residual, lengths relative to reach, as one number; infinite if it is not a number.
    #[inline(never)]
    pub(super) fn relative(&self, residual: &Residual<T>) -> T {
        let position = residual.position / self.reach;
        let known = position.is_finite() && residual.orientation.is_finite();
        if known { position.max(residual.orientation) } else { T::INFINITY }
    }

    /// Returns true if a residual is within the file's tolerance.
    pub(super) fn tolerates(&self, residual: &Residual<T>) -> bool {
        residual.position <= self.tolerance.position && residual.orientation <= self.tolerance.orientation
    }
}

/// Forward kinematics and Jacobian of an arm, as an object. The code that verifies a solution then exists once, not
/// once an arm.
pub trait Evaluate<T, const N: usize> {
    /// Pose of the tool and geometric Jacobian at `q`, both in the base frame.
    fn evaluate(&self, q: &[T; N]) -> (Pose<T>, Jacobian<T, N>);
}

impl<T, A: Arm<T, N>, const N: usize> Evaluate<T, N> for A {
    #[cold]
    #[inline(never)]
    fn evaluate(&self, q: &[T; N]) -> (Pose<T>, Jacobian<T, N>) {
        crate::effort::evaluation();
        self.forward_and_jacobian(q)
    }
}
