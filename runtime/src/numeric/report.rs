//! Result of an iteration.

use core::fmt;

use crate::math::Scalar;
use crate::solution::Residual;

/// Why the iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stop {
    /// The error is within both tolerances.
    Converged,
    /// The iterations are used up.
    IterationBound,
    /// The error has not fallen for a long while: a local minimum, limits in the way, or a target out of reach.
    Stalled,
    /// The arm's forward kinematics or the solver's settings gave something that is not finite.
    NotFinite,
    /// The target is not finite, its matrix is no rotation (off by more than 1e-3), or the task's axis has no direction.
    /// No step was taken; `q` is the start.
    BadTarget,
    /// The start or the posture is not finite, or its length is not the number of joints. No step was taken; `q` is the
    /// start.
    BadStart,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Converged => "converged",
            Self::IterationBound => "iterations used up",
            Self::Stalled => "stalled: a local minimum, limits in the way, or out of reach",
            Self::NotFinite => "not finite: the arm's parameters or the settings",
            Self::BadTarget => "bad target: not finite, or not a rotation",
            Self::BadStart => "bad start: not finite",
        })
    }
}

/// Result of a numeric inverse: the joint vector that came closest, and a report.
///
/// `Q` is `[T; N]`, or `Vec<f64>` for a `Chain`, the arm from its table at run time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct NumericSolution<T, Q> {
    /// The joint values, rad or length unit: the iterate of the least error over all starts. It reaches the target only
    /// if [`converged`](Self::converged). Where [`stop`](Self::stop) is [`Stop::Stalled`], the iterate is close to a
    /// place that no small motion within the limits brings nearer. For a target out of reach, the arm comes closest at
    /// that place.
    pub q: Q,
    /// Why the last iteration ended.
    pub stop: Stop,
    /// Steps taken, from all starts.
    pub iterations: usize,
    /// How many of the [`restarts`](crate::numeric::NumericInverse::restarts) were used.
    pub restarts: usize,
    /// Error that is left in the components that the task counts; infinite if nothing could be computed.
    pub residual: Residual<T>,
}

impl<T, Q> NumericSolution<T, Q> {
    /// Returns true if `q` reaches the target within the tolerances.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.stop == Stop::Converged
    }
}

/// As in `converged after 7 iterations, 0 restarts: position 1.0e-12, orientation 2.1e-13 rad`.
impl<T: Scalar + fmt::LowerExp, Q> fmt::Display for NumericSolution<T, Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { stop, iterations, restarts, residual, .. } = self;
        write!(f, "{stop} after {iterations} iterations, {restarts} restarts: {residual}")
    }
}
