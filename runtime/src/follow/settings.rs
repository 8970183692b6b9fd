//! The settings of a follower, and how they are checked.

use core::{error, fmt};

use super::linear::slopes;
use crate::arm::Arm;
use crate::flags::JointMask;
use crate::limits::rounding;
use crate::math::Scalar;

/// Greatest rates of the joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rates<T, const N: usize> {
    /// Greatest velocities, rad/s or length unit / s, above 0. Every one is finite.
    pub velocity: [T; N],
    /// Greatest accelerations, rad/s^2 or length unit / s^2, above 0; infinite: none.
    pub acceleration: [T; N],
}

impl<T: Scalar, const N: usize> Rates<T, N> {
    /// Velocities alone: accelerations have no limit.
    #[must_use]
    pub const fn velocity(velocity: [T; N]) -> Self {
        Self { velocity, acceleration: [T::INFINITY; N] }
    }
}

/// Singularities through which a deviation may lead to a branch that is nearer in time.
///
/// A step that is exact may cross any: there two branches meet, and the target goes on along the other one. An arm that
/// swings past another singularity comes back; where limits or reach then keep it from its target for a second, it stays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Crossing {
    /// None: only exact steps change the branch.
    Exact,
    /// The wrist: branches that differ in [`Branch::wrist`](crate::Branch::wrist) alone.
    #[default]
    Wrist,
    /// Any.
    Any,
}

/// How the motors depend on the joints: the matrix `A` of `motor = A q + b`, and its inverse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Linked<T, const N: usize> {
    /// `[motor][joint]`
    pub(super) to_motor: [[T; N]; N],
    /// `[joint][motor]`
    pub(super) from_motor: [[T; N]; N],
}

/// Settings of a follower.
///
/// ```
/// use denhart::follow::{Crossing, FollowSettings, Rates};
///
/// let rates = Rates { velocity: [3.0; 6], acceleration: [20.0; 6] };
/// let settings = FollowSettings::new(0.001, rates).length(0.05).crossing(Crossing::Any);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowSettings<T, const N: usize> {
    pub(super) period: T,
    pub(super) rates: Rates<T, N>,
    pub(super) length: Option<T>,
    pub(super) crossing: Crossing,
    pub(super) locked: JointMask,
    pub(super) held: bool,
    pub(super) linked: Option<Linked<T, N>>,
}

impl<T: Scalar, const N: usize> FollowSettings<T, N> {
    /// `period`: time from one tick to the next, s. `rates`: those of the joints; a generated arm has `MAX_VELOCITY` and
    /// `MAX_ACCELERATION`, infinite where its file has none.
    #[must_use]
    pub const fn new(period: T, rates: Rates<T, N>) -> Self {
        let (length, crossing, locked) = (None, Crossing::Wrist, JointMask::NONE);
        Self { period, rates, length, crossing, locked, held: false, linked: None }
    }

    /// Length, in the arm's unit, that a deviation weighs as much as 1 rad. A small one keeps the position, a large one
    /// the orientation. Default: 0.09 of the way along the links, about a tenth of what data sheets call the reach.
    #[must_use]
    pub const fn length(mut self, length: T) -> Self {
        self.length = Some(length);
        self
    }

    /// Singularities through which a deviation may lead. Default: [`Crossing::Wrist`].
    #[must_use]
    pub const fn crossing(mut self, crossing: Crossing) -> Self {
        self.crossing = crossing;
        self
    }

    /// Joints that stay where they are, for a [`Follower`](super::Follower). Of an arm whose target comes with the values of
    /// redundant joints, those values count no longer: name the redundant joints, and no others. With another joint locked
    /// the arm has no solution to most targets, and misses them by what is least.
    #[must_use]
    pub const fn locked(mut self, joints: JointMask) -> Self {
        self.locked = joints;
        self.held = true;
        self
    }

    /// Redundant joints, and an arm angle, keep the value that the arm has: those that come with the target do not count.
    #[must_use]
    pub const fn held(mut self) -> Self {
        self.held = true;
        self
    }

    /// The rates are those of motors that are linked, `motor = A q + b`: the arm's `to_motor` and `from_motor`. Ranges
    /// stay those of the joints.
    #[must_use]
    pub fn linked(mut self, to_motor: impl Fn(&[T; N]) -> [T; N], from_motor: impl Fn(&[T; N]) -> [T; N]) -> Self {
        self.linked = Some(Linked { to_motor: slopes(to_motor), from_motor: slopes(from_motor) });
        self
    }

    /// The settings hold for an arm at `q`.
    pub(super) fn check<A: Arm<T, N>>(&self, arm: &A, q: &[T; N]) -> Result<(), FollowError> {
        let positive = |x: T| x > T::ZERO;
        let Rates { velocity, acceleration } = &self.rates;
        if !(positive(self.period) && self.period.is_finite()) {
            return Err(FollowError::Period);
        }
        let slow = |(v, a): (&T, &T)| !(positive(*v) && v.is_finite() && positive(*a));
        let short = |v: &T| !(positive(*v * self.period) && (*v * self.period).is_finite());
        if let Some(joint) = velocity.iter().zip(acceleration).position(slow).or(velocity.iter().position(short)) {
            return Err(FollowError::Rate(joint));
        }
        if let Some(joint) = self.locked.iter().find(|joint| *joint >= N) {
            return Err(FollowError::Locked(joint));
        }
        if self.length.is_some_and(|length| !(positive(length) && length.is_finite())) {
            return Err(FollowError::Length);
        }
        let outside = |(q, [low, high]): (&T, [T; 2])| {
            let beyond = rounding(q.abs());
            !(q.is_finite() && *q >= low - beyond && *q <= high + beyond)
        };
        match q.iter().zip(arm.limits()).position(outside) {
            Some(joint) => Err(FollowError::Start(joint)),
            None => Ok(()),
        }
    }
}

/// Reasons for which a follower does not begin. Joints count from 0 here, and from 1 in the message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FollowError {
    /// The period is not a finite number above 0.
    Period,
    /// The velocity of a joint is not a finite number above 0, or its acceleration is not above 0.
    Rate(usize),
    /// The length that weighs as 1 rad is not a finite number above 0.
    Length,
    /// A joint that is locked is none of the arm's.
    Locked(usize),
    /// The start is outside the range of a joint, or not finite.
    Start(usize),
    /// The start is outside one of the arm's combined limits, counted from 0.
    Combined(usize),
}

impl fmt::Display for FollowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Period => f.write_str("the period is not a finite time above 0"),
            Self::Rate(joint) => {
                let number = joint + 1;
                write!(f, "joint {number} needs a finite velocity above 0, and an acceleration above 0")
            }
            Self::Locked(joint) => write!(f, "joint {} is locked, and the arm has no such joint", joint + 1),
            Self::Length => f.write_str("the length that weighs as 1 rad is not a finite length above 0"),
            Self::Start(joint) => write!(f, "the start is outside the range of joint {}", joint + 1),
            Self::Combined(limit) => write!(f, "the start is outside combined limit {}", limit + 1),
        }
    }
}

impl error::Error for FollowError {}
