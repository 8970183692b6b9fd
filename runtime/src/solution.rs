//! One solution of the inverse kinematics, and the outcome of a call.

use core::fmt;

use crate::arm::{Arm, InverseKinematics};
use crate::branch::Branch;
use crate::dh::JointKind;
use crate::flags::{Flags, JointMask};
use crate::limits::within;
use crate::math::Scalar;
use crate::windings::{Windings, next_to};

/// How far a pose misses its target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual<T> {
    /// Distance of the tool point from the target, in the length unit.
    pub position: T,
    /// Angle between tool and target, rad.
    pub orientation: T,
}

impl<T: Scalar> Residual<T> {
    /// No deviation.
    pub const ZERO: Self = Self { position: T::ZERO, orientation: T::ZERO };
}

/// As in `position 2.0e-16, orientation 1.1e-16 rad`.
impl<T: fmt::LowerExp> fmt::Display for Residual<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision().unwrap_or(1);
        write!(f, "position {:.precision$e}, orientation {:.precision$e} rad", self.position, self.orientation)
    }
}

/// One joint vector that answers a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution<T, const N: usize> {
    /// Joint values: rad for revolute joints, the length unit for prismatic ones.
    pub q: [T; N],
    /// Facts about the solution: exact or approximate, singular, outside the limits.
    pub flags: Flags,
    /// The joints whose value the solver chose because the target does not determine it, see [`Flags::FREE`].
    pub free: JointMask,
    /// The branch that the solution lies on.
    pub branch: Branch,
    /// Error of the solution against the target. The residual is zero for a solution that the closed form gives to
    /// rounding. A solution at a singular pose or at the boundary of reach is verified: its residual is computed by
    /// forward kinematics.
    pub residual: Residual<T>,
}

impl<T: Scalar, const N: usize> Solution<T, N> {
    /// Filler of the unused places of [`Solutions`](crate::Solutions).
    pub(crate) const EMPTY: Self = Self {
        q: [T::ZERO; N],
        flags: Flags::NONE,
        free: JointMask::NONE,
        branch: Branch::NONE,
        residual: Residual::ZERO,
    };

    /// A solution that the closed form gives to rounding.
    #[inline(always)]
    pub(crate) const fn exact(q: [T; N], branch: Branch) -> Self {
        Self { q, flags: Flags::EXACT, free: JointMask::NONE, branch, residual: Residual::ZERO }
    }
}

impl<T, const N: usize> Solution<T, N> {
    /// Returns true if the solution reaches the target up to rounding.
    #[inline]
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.flags.contains(Flags::EXACT)
    }

    /// Returns true if every joint is within the arm's limits.
    #[inline]
    #[must_use]
    pub const fn is_within_limits(&self) -> bool {
        !self.flags.contains(Flags::OUT_OF_LIMITS)
    }
}

impl<T: Scalar, const N: usize> Solution<T, N> {
    /// Every joint vector within the arm's limits that differs from this solution by whole turns of its revolute
    /// joints, the nearest first. See [`Windings`] for the order and for joints without limits.
    ///
    /// ```
    /// # fn main() {}
    /// # use denhart::{Arm, Solution};
    /// /// The winding in which joint 6 has most turns left before its limit.
    /// fn most_room<A: Arm<f64, 6>>(arm: &A, solution: &Solution<f64, 6>) -> Option<[f64; 6]> {
    ///     solution.windings(arm).min_by(|a, b| a[5].abs().total_cmp(&b[5].abs()))
    /// }
    /// ```
    pub fn windings<A: Arm<T, N>>(&self, arm: &A) -> Windings<T, N> {
        Windings::new(&self.q, &arm.limits(), &arm.joint_kinds())
    }

    /// Returns the solution with each revolute joint on the turn next to `q_ref` (`[N]`), by the rule of
    /// [`inverse_near`](crate::InverseKinematics::inverse_near). A joint whose reference is not finite stays. The flag
    /// [`Flags::OUT_OF_LIMITS`] is that of the new joint values, as the inverse sets it.
    #[must_use]
    pub fn next_to<A: InverseKinematics<T, N>>(&self, arm: &A, q_ref: &[T; N]) -> Self {
        let mut solution = *self;
        let limits = arm.limits();
        let joints = solution.q.iter_mut().zip(q_ref).zip(limits.iter().zip(arm.joint_kinds()));
        let inside = joints.fold(true, |inside, ((value, reference), (limits, kind))| {
            if kind == JointKind::Revolute && reference.is_finite() {
                *value = next_to(*value, *reference, *limits);
            }
            inside & within(*value, *limits, value.abs())
        });
        let inside = inside && arm.combined_limits().iter().all(|limit| limit.holds(&solution.q));
        solution.flags.remove(Flags::OUT_OF_LIMITS);
        if !inside {
            solution.flags |= Flags::OUT_OF_LIMITS;
        }
        solution
    }

    /// The solution as text for people: revolute joints in degrees, prismatic ones in the length unit.
    ///
    /// `kinds`: the arm's [`JOINT_KINDS`](crate::Arm::JOINT_KINDS). A precision in the format applies to every joint
    /// value; the default is 3 decimals for degrees and 6 for lengths. [`display_for`](Self::display_for) takes the arm.
    pub fn display<'a>(&'a self, kinds: &'a [JointKind; N]) -> impl fmt::Display + 'a {
        InDegrees { solution: self, kinds: *kinds }
    }

    /// The solution as text for people, for the arm that it is of: as [`display`](Self::display) with the arm's kinds of
    /// joints.
    pub fn display_for<'a, A: Arm<T, N>>(&'a self, arm: &A) -> impl fmt::Display + use<'a, A, T, N> {
        InDegrees { solution: self, kinds: arm.joint_kinds() }
    }
}

struct InDegrees<'a, T, const N: usize> {
    solution: &'a Solution<T, N>,
    kinds: [JointKind; N],
}

impl<T: Scalar, const N: usize> fmt::Display for InDegrees<'_, T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision();
        let mut separator = "[";
        for (q, kind) in self.solution.q.iter().zip(self.kinds) {
            let q = q.to_f64();
            match kind {
                JointKind::Revolute => {
                    write!(f, "{separator}{:.1$} deg", q.to_degrees(), precision.unwrap_or(3))?;
                }
                JointKind::Prismatic | JointKind::Fixed => write!(f, "{separator}{q:.0$}", precision.unwrap_or(6))?,
            }
            separator = ", ";
        }
        write_facts(f, self.solution)
    }
}

/// The joint values as they are (rad, length unit), the flags, the branch. The default precision is 6 decimals.
/// [`Solution::display`] gives degrees.
impl<T: fmt::Display, const N: usize> fmt::Display for Solution<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision().unwrap_or(6);
        let mut separator = "[";
        for q in &self.q {
            write!(f, "{separator}{q:.precision$}")?;
            separator = ", ";
        }
        write_facts(f, self)
    }
}

fn write_facts<T, const N: usize>(f: &mut fmt::Formatter<'_>, solution: &Solution<T, N>) -> fmt::Result {
    write!(f, "]  {}", solution.flags)?;
    if !solution.free.is_empty() {
        write!(f, " {}", solution.free)?;
    }
    write!(f, "  {}", solution.branch)
}

/// Result of a query for one solution: the solution, or the status that says why there is none.
pub type OneSolution<T, const N: usize> = Result<Solution<T, N>, Status<T>>;

/// Outcome of an inverse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Status<T> {
    /// At least one solution is [`EXACT`](Flags::EXACT).
    Reachable,
    /// No solution is exact. Those that come within the tolerance are still listed, as
    /// [`APPROXIMATE`](Flags::APPROXIMATE).
    Unreachable {
        /// The least gap over all branches: by how much the first equation of a branch without a root misses one. An
        /// equation of lengths gives a length, one of directions an angle in rad. If a solution is listed that misses by
        /// less, the larger part of its residual. The reach of the arm where no gap is known.
        ///
        /// This is not the distance to the workspace, as the equations after the one that is missed do not count.
        /// [`numeric`](crate::numeric#targets-out-of-reach) finds that distance.
        residual: T,
    },
    /// The target, or the reference joint vector, is not finite, or the matrix is no rotation: off by more
    /// than 1e-3, or of determinant -1. A rotation that is off by less stands for the nearest rotation, see
    /// [`Solutions::deviation`](crate::Solutions::deviation).
    BadTarget,
}

impl<T> Status<T> {
    /// Returns true if the target is reached.
    #[inline]
    #[must_use]
    pub const fn is_reachable(&self) -> bool {
        matches!(self, Self::Reachable)
    }
}

impl<T: fmt::LowerExp> fmt::Display for Status<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reachable => f.write_str("reachable"),
            Self::Unreachable { residual } => write!(
                f,
                "unreachable: the least gap of a branch is {residual:.1e}, a length in the arm's unit or an angle in rad"
            ),
            Self::BadTarget => f.write_str("bad target: not finite, or not a rotation"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::branch::Elbow;
    use std::format;

    const SOLUTION: Solution<f64, 2> = Solution {
        q: [core::f64::consts::FRAC_PI_2, 0.25],
        flags: Flags::EXACT.union(Flags::FREE),
        free: JointMask::single(1),
        branch: Branch::NONE.with_elbow(Elbow::Up),
        residual: Residual::ZERO,
    };

    #[test]
    fn display_keeps_the_units_of_q() {
        assert_eq!(format!("{SOLUTION}"), "[1.570796, 0.250000]  EXACT | FREE {q2}  elbow up");
        assert_eq!(format!("{SOLUTION:.2}"), "[1.57, 0.25]  EXACT | FREE {q2}  elbow up");
    }

    #[test]
    fn display_with_kinds_is_in_degrees_only_for_angles() {
        let mut plain = SOLUTION;
        plain.flags = Flags::EXACT;
        plain.free = JointMask::NONE;
        let kinds = [JointKind::Revolute, JointKind::Prismatic];
        assert_eq!(format!("{}", plain.display(&kinds)), "[90.000 deg, 0.250000]  EXACT  elbow up");
        assert_eq!(format!("{:.1}", plain.display(&[JointKind::Revolute; 2])), "[90.0 deg, 14.3 deg]  EXACT  elbow up");
    }

    #[test]
    fn flags_read_as_questions() {
        assert!(SOLUTION.is_exact() && SOLUTION.is_within_limits());
        let mut outside = SOLUTION;
        outside.flags = Flags::APPROXIMATE | Flags::OUT_OF_LIMITS;
        assert!(!outside.is_exact() && !outside.is_within_limits());
    }

    #[test]
    fn status_and_residual_read_as_text() {
        let far = Status::Unreachable { residual: 0.0123 };
        assert!(Status::<f64>::Reachable.is_reachable() && !far.is_reachable());
        assert_eq!(
            format!("{far}"),
            "unreachable: the least gap of a branch is 1.2e-2, a length in the arm's unit or an angle in rad"
        );
        assert_eq!(format!("{}", Status::<f32>::Reachable), "reachable");
        assert_eq!(
            format!("{}", Residual { position: 2e-16, orientation: 0.0 }),
            "position 2.0e-16, orientation 0.0e0 rad"
        );
    }
}
