//! The follower that keeps the time.

use super::settings::{FollowError, FollowSettings};
use super::step::Step;
use crate::arm::{InverseBranch, InverseKinematics};
use crate::branch::Branch;
use crate::math::Scalar;

/// Follows a target that moves, one step a tick: exact where the rates of the joints allow, else with a deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Follower<T, const N: usize> {
    settings: FollowSettings<T, N>,
    q: [T; N],
    step: [T; N],
    wanted: Option<Branch>,
}

impl<T: Scalar, const N: usize> Follower<T, N> {
    /// An arm at rest at `q`.
    ///
    /// # Errors
    /// Settings or a start with which no tick is possible.
    pub fn new<A: InverseKinematics<T, N>>(
        _arm: &A,
        settings: FollowSettings<T, N>,
        q: &[T; N],
    ) -> Result<Self, FollowError> {
        settings.check::<A>(q)?;
        Ok(Self { settings, q: *q, step: [T::ZERO; N], wanted: None })
    }

    /// The step towards a target. `found` is overwritten.
    pub fn step<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        target: &A::Target,
        found: &mut A::Solutions,
    ) -> Step<T, N> {
        let _ = (target, found);
        self.stop(arm)
    }

    /// A step without a target: every joint brakes.
    pub fn stop<A: InverseKinematics<T, N>>(&mut self, _arm: &A) -> Step<T, N> {
        todo!()
    }

    /// Sends the arm to another branch. From the next tick on the solution there is the goal, through whatever
    /// singularities lie between; it is the only way to a branch that is far. Components unset in `branch` match any.
    pub fn go_to_branch<A: InverseBranch<T, N>>(&mut self, _arm: &A, branch: Branch) {
        self.wanted = Some(branch);
    }

    /// The joint values now, rad or length unit.
    #[must_use]
    pub const fn q(&self) -> &[T; N] {
        &self.q
    }
}
