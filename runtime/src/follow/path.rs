//! The follower that keeps the path.

use super::advance::Advance;
use super::settings::{FollowError, FollowSettings};
use crate::arm::InverseKinematics;
use crate::math::Scalar;

/// Follows a path exactly; where the rates of the joints do not allow its time, the clock of the path slows down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathFollower<T, const N: usize> {
    settings: FollowSettings<T, N>,
    q: [T; N],
    at: T,
}

impl<T: Scalar, const N: usize> PathFollower<T, N> {
    /// An arm at rest at `q`, at time 0 of a path.
    ///
    /// # Errors
    /// Settings or a start with which no tick is possible.
    pub fn new<A: InverseKinematics<T, N>>(
        _arm: &A,
        settings: FollowSettings<T, N>,
        q: &[T; N],
    ) -> Result<Self, FollowError> {
        settings.check::<A>(q)?;
        Ok(Self { settings, q: *q, at: T::ZERO })
    }

    /// The step along a path of the duration `end`, s. `path` gives the target at a time from 0 to `end`. `found` is
    /// overwritten.
    pub fn step<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        path: impl Fn(T) -> A::Target,
        end: T,
        found: &mut A::Solutions,
    ) -> Advance<T, N> {
        let _ = (arm, path, end, found);
        todo!()
    }

    /// Time on the path, s.
    #[must_use]
    pub const fn at(&self) -> T {
        self.at
    }
}
