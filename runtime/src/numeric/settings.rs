//! The solver's settings, and its calls.

use super::model::Generated;
use super::report::NumericSolution;
use super::{Task, descent};
use crate::arm::Arm;
use crate::pose::Pose;
use crate::solution::Residual;
use crate::solve::Tolerances;

/// How a step follows from the error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Method {
    /// Damping in proportion to the squared error (Levenberg and Marquardt).
    #[default]
    DampedLeastSquares,
    /// No damping: the inverse of the Jacobian, or its pseudoinverse.
    NewtonRaphson,
}

/// Numeric inverse kinematics: the settings of the iteration. See the [module](crate::numeric) for the method.
///
/// ```
/// use denhart::Arm;
/// use denhart::numeric::NumericInverse;
/// # use denhart::{Jacobian, JointKind, Pose, math};
/// # struct Slide;
/// # impl Arm<f64, 2> for Slide {
/// #     const LIMITS: [[f64; 2]; 2] = [[-3.0, 3.0], [0.1, 1.0]];
/// #     const JOINT_NAMES: [&'static str; 2] = ["q1", "q2"];
/// #     const JOINT_KINDS: [JointKind; 2] = [JointKind::Revolute, JointKind::Prismatic];
/// #     fn forward(&self, &[q1, q2]: &[f64; 2]) -> Pose<f64> {
/// #         let (s1, c1) = math::sin_cos(q1);
/// #         let rotation = [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]];
/// #         Pose { rotation, translation: [q2 * c1, q2 * s1, 0.0] }
/// #     }
/// #     fn link_poses(&self, q: &[f64; 2]) -> [Pose<f64>; 2] {
/// #         [Pose { translation: [0.0; 3], ..self.forward(q) }, self.forward(q)]
/// #     }
/// #     fn jacobian(&self, &[q1, q2]: &[f64; 2]) -> Jacobian<f64, 2> {
/// #         let (s1, c1) = math::sin_cos(q1);
/// #         Jacobian { rows: [[-q2 * s1, c1], [q2 * c1, s1], [0.0; 2], [0.0; 2], [0.0; 2], [1.0, 0.0]] }
/// #     }
/// #     fn forward_and_jacobian(&self, q: &[f64; 2]) -> (Pose<f64>, Jacobian<f64, 2>) {
/// #         (self.forward(q), self.jacobian(q))
/// #     }
/// # }
/// # let arm = Slide;
///
/// // An arm that turns by q1 and reaches out by q2.
/// let target = arm.forward(&[1.2, 0.7]);
/// let solution = NumericInverse::new().restarts(5).solve(&arm, &target, &[0.0, 0.3]);
/// assert!(solution.converged(), "{solution}");
/// assert!((solution.q[0] - 1.2).abs() < 1e-8 && (solution.q[1] - 0.7).abs() < 1e-8);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumericInverse<T> {
    pub(super) method: Method,
    pub(super) task: Task<T>,
    pub(super) max_iterations: usize,
    pub(super) patience: usize,
    pub(super) tolerance: Option<Residual<T>>,
    pub(super) max_step: T,
    pub(super) damping: T,
    pub(super) length: Option<T>,
    pub(super) within_limits: bool,
    pub(super) restarts: usize,
    pub(super) seed: u64,
    pub(super) posture_gain: T,
}

impl<T: Tolerances> Default for NumericInverse<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Tolerances> NumericInverse<T> {
    /// Damped least squares for the full pose, with the defaults that the methods name.
    #[must_use]
    pub fn new() -> Self {
        Self {
            method: Method::DampedLeastSquares,
            task: Task::Pose,
            max_iterations: 100,
            patience: 60,
            tolerance: None,
            max_step: T::from_f64(3.0),
            damping: T::from_f64(0.01),
            length: None,
            within_limits: true,
            restarts: 0,
            seed: 0,
            posture_gain: T::from_f64(0.2),
        }
    }

    /// How a step follows from the error. Default: damped least squares.
    #[must_use]
    pub fn method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// Components of the target pose that count. Default: all of them.
    #[must_use]
    pub fn task(self, task: Task<T>) -> Self {
        Self { task, ..self }
    }

    /// Greatest number of steps from one start. Default: 100.
    #[must_use]
    pub fn max_iterations(self, max_iterations: usize) -> Self {
        Self { max_iterations, ..self }
    }

    /// Number of steps without a smaller error that ends the iteration from a start, as
    /// [`Stop::Stalled`](super::Stop::Stalled).
    /// Default: 60. Fewer save time where a target is out of reach, or where random starts follow.
    #[must_use]
    pub fn patience(self, patience: usize) -> Self {
        Self { patience, ..self }
    }

    /// Largest errors of a converged solution: of the position in the length unit, of the orientation in rad. Default:
    /// 1e-9 (f32: 1e-5) of the [`length`](Self::length), and as many rad.
    #[must_use]
    pub fn tolerance(self, position: T, orientation: T) -> Self {
        Self { tolerance: Some(Residual { position, orientation }), ..self }
    }

    /// Greatest change of a joint in one step, rad; of a prismatic joint in [`length`](Self::length)s. A longer step is
    /// shortened in all joints alike. Default: 3, almost half a turn; near 0.2 the path is close to continuous, and more
    /// starts end in a local minimum.
    #[must_use]
    pub fn max_step(self, max_step: T) -> Self {
        Self { max_step, ..self }
    }

    /// Damping over the squared error (lengths over [`length`](Self::length)). Default: 0.01.
    #[must_use]
    pub fn damping(self, damping: T) -> Self {
        Self { damping, ..self }
    }

    /// The length that weighs lengths against angles: an error of this length counts as one of 1 rad. Default: the
    /// way along the links, from the origin of the first to the tool.
    #[must_use]
    pub fn length(self, length: T) -> Self {
        Self { length: Some(length), ..self }
    }

    /// Keeps joints within the arm's limits if true. Default: true.
    #[must_use]
    pub fn within_limits(self, within_limits: bool) -> Self {
        Self { within_limits, ..self }
    }

    /// How many pseudo-random starts within the limits follow where the given one does not converge. A joint without
    /// limits starts within half a turn, or one [`length`](Self::length), of the given start. Default: none.
    #[must_use]
    pub fn restarts(self, restarts: usize) -> Self {
        Self { restarts, ..self }
    }

    /// Seed of the pseudo-random starts: the same seed gives the same answer. Default: 0.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// Fraction of its distance to the preferred posture that a joint moves in a step, 0 to 1. Default: 0.2. Far from
    /// the posture a greater gain may oscillate about the nearest point.
    #[must_use]
    pub fn posture_gain(self, posture_gain: T) -> Self {
        Self { posture_gain, ..self }
    }

    /// A joint vector that brings the tool to `target`, from `start` `[N]` (rad or length unit).
    ///
    /// A start beyond the limits is moved to the limit. A joint that may turn freely ends within half a turn of
    /// `start`. Never panics; the report says whether and why the iteration ended, and `q` is finite whenever `start` is.
    pub fn solve<A: Arm<T, N>, const N: usize>(
        &self,
        arm: &A,
        target: &Pose<T>,
        start: &[T; N],
    ) -> NumericSolution<T, [T; N]> {
        descent::run(self, &Generated::new(arm), target, start, None)
    }

    /// As [`solve`](Self::solve), and as near to `posture` `[N]` as the target leaves free.
    ///
    /// An arm with more joints than the task needs goes on along the null space of its Jacobian. That motion lasts
    /// until a step is shorter than 1e-3 rad (or as much of the [`length`](Self::length)), or to the last ten
    /// iterations. Then the arm closes in on the target. The distance to the posture is then close to a local minimum,
    /// up to limits. Where the target determines every joint, the posture only changes the path.
    pub fn solve_towards<A: Arm<T, N>, const N: usize>(
        &self,
        arm: &A,
        target: &Pose<T>,
        start: &[T; N],
        posture: &[T; N],
    ) -> NumericSolution<T, [T; N]> {
        descent::run(self, &Generated::new(arm), target, start, Some(posture))
    }

    pub(super) fn tolerance_for(&self, length: T) -> Residual<T> {
        let single = T::EPSILON > T::from_f64(1e-10);
        let relative = T::from_f64(if single { 1e-5 } else { 1e-9 });
        self.tolerance.unwrap_or(Residual { position: relative * length, orientation: relative })
    }
}
