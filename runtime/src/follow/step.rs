//! Answer of a follower to one target.

use core::fmt;

use crate::branch::Branch;
use crate::flags::JointMask;
use crate::solution::Residual;

/// How a follower stands to its target.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Tracking {
    /// The joint values are a solution that `inverse_near` flags [`EXACT`](crate::Flags::EXACT), within all limits.
    Exact,
    /// The branch reaches the target, but not in this tick.
    Rates,
    /// The branch leaves the range of joints. They stand at their limit, the others miss the target least.
    Limits,
    /// The branch does not reach the target: the arm comes as near as it can.
    Reach,
    /// The target is not finite or its matrix no rotation, or there is none: the arm brakes.
    Target,
}

impl Tracking {
    /// Returns true for [`Tracking::Exact`].
    #[must_use]
    pub const fn is_exact(self) -> bool {
        matches!(self, Self::Exact)
    }
}

/// The name in lower case.
impl fmt::Display for Tracking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exact => "exact",
            Self::Rates => "rates",
            Self::Limits => "limits",
            Self::Reach => "reach",
            Self::Target => "target",
        })
    }
}

/// One tick of a [`Follower`](super::Follower).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step<T, const N: usize> {
    /// Joint values of the end of the tick, rad or length unit.
    pub q: [T; N],
    /// The step to `q` over the period, rad/s or length unit / s.
    pub velocity: [T; N],
    /// How the step stands to the target.
    pub tracking: Tracking,
    /// Twist from the tool to the target, `vx vy vz wx wy wz` in the base frame; 0 in rows that the task leaves open, in
    /// exact ticks and without a target.
    pub deviation: [T; 6],
    /// Sizes of `deviation`: a length and an angle.
    pub residual: Residual<T>,
    /// The branch that `q` lies on, without a component that a singularity leaves open there; [`Branch::NONE`] of an arm that has
    /// no names for its branches.
    pub branch: Branch,
    /// The branch that was left, in the tick in which a factor of the arm's `margins` changes its sign.
    pub crossed: Option<Branch>,
    /// With [`Tracking::Rates`] the joints that cannot be at the goal in this tick; with linked joints the motors of these
    /// numbers; none where the goal is near and its motion alone is too fast. With [`Tracking::Limits`] the joints whose range
    /// the target asks to leave. Else none.
    pub held: JointMask,
    /// The least time to the goal at full velocities, s, without the time of their accelerations: 0 in exact ticks, infinite
    /// where no goal is known.
    pub remaining: T,
}
