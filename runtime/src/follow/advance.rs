//! Answer of a path follower to one tick.

use super::step::Tracking;
use crate::branch::Branch;

/// How a path follower gets on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Progress {
    /// The path advances by a whole period.
    Full,
    /// The path advances by less: the rates of the joints allow no more.
    Slowed,
    /// The path does not go on from here, for this reason: [`Limits`](Tracking::Limits), [`Reach`](Tracking::Reach),
    /// [`Target`](Tracking::Target), or [`Rates`](Tracking::Rates) where the joints would have to jump.
    Blocked(Tracking),
    /// The end of the path is reached.
    Done,
}

/// One tick of a [`PathFollower`](super::PathFollower).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advance<T, const N: usize> {
    /// Joint values of the end of the tick, rad or length unit: an exact solution of the path at `at`.
    pub q: [T; N],
    /// The step to `q` over the period, rad/s or length unit / s.
    pub velocity: [T; N],
    /// Time on the path, s.
    pub at: T,
    /// Advance of the path in this tick over the period: 1 at full speed.
    pub rate: T,
    /// How the follower gets on.
    pub state: Progress,
    /// The branch that `q` lies on, without a component that a singularity leaves open there; [`Branch::NONE`] of an arm that has
    /// no names for its branches.
    pub branch: Branch,
    /// The branch that was left, in the tick in which a factor of the arm's `margins` changes its sign.
    pub crossed: Option<Branch>,
}
