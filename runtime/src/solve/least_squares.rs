//! Damped least-squares steps towards a target.

use super::arm_constants::{ArmConstants, Evaluate};
use super::best_part::best_part;
use super::damped_step::{damped_step, dot_out_of_line};
use super::goal::Goal;
use super::kernel::tolerances::Tolerances;
use crate::math::wrap;
use crate::{JointMask, Residual};

/// The most steps for one solution.
pub(super) const MOST_STEPS: usize = 16;
/// So many steps in a row that stall are the last ones; one, once the solution is exact.
const MOST_STALLS: usize = 3;
/// A step stalls that leaves more than this part of the squared error. Where several singularities meet, a step that
/// takes little may come before one that takes nearly all. On 6,000 random arms 0.7 and 0.9 lose as many poses, in part
/// other ones, and 0.9 takes 1.35 times the evaluations at worst.
const PROGRESS: f64 = 0.8;
/// The gain of a step is the part of the squared error that the step takes by its linear model. A descent is taken to
/// converge to an error above zero where the gain is below `LITTLE`, and below `FALL` of the gain before. If all
/// further gains fall like that, they take 4/3 of this gain in all. Near a saddle a gain falls as well, before the next
/// ones rise: hence the first bound. No pose of 6,000 random arms depends on the steps that are left out.
const LITTLE: f64 = 0.02;
const FALL: f64 = 0.25;
/// Residuals up to so many roundings say nothing about where the solution is. Where the arm is nearly singular, a step
/// that would remove such residuals leads far away.
const NOISE: f64 = 20.0;

/// A step closes a target if by its linear model it leaves at most this part of the squared error. Measured in `f32` with
/// followers off their targets beside singularities. Of 83,833 ticks of followers that dwell there, iteration from the joint
/// values led to a solution less than half as far as those listed in 17,347. In 17,010 of these the first step closed the target
/// and went less than half of the way. Of 1,775 ticks of followers that swing past none led to one; the first step did so in 11.
const CLOSES: f64 = 0.01;

/// A joint vector with what it misses the target by. Lengths are relative to reach throughout.
#[derive(Debug, Clone, Copy)]
pub(super) struct Iterate<T, const N: usize> {
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
    /// The columns of the Jacobian, unless the error is rounding.
    columns: [[T; 6]; N],
    error: [T; 6],
    /// Its squared length.
    size: T,
}

impl<T: Tolerances, const N: usize> Iterate<T, N> {
    /// A joint vector before its evaluation.
    #[inline]
    pub(super) const fn at(q: [T; N]) -> Self {
        Self { q, residual: Residual::ZERO, columns: [[T::ZERO; 6]; N], error: [T::ZERO; 6], size: T::ZERO }
    }

    /// Evaluates the arm at its joint vector.
    #[inline(never)]
    pub(super) fn evaluate(&mut self, constants: &ArmConstants<T, N>, goal: &dyn Goal<T, N>, arm: &dyn Evaluate<T, N>) {
        let mut evaluated = arm.evaluate(&self.q);
        let (pose, jacobian) = &mut evaluated;
        let k = T::ONE / constants.reach;
        let [x, y, z, u, v, w] = goal.error(&self.q, pose);
        self.error = [x * k, y * k, z * k, u, v, w];
        self.size = dot_out_of_line(&self.error, &self.error);
        self.residual = goal.misses(&self.q, pose);
        if self.is_rounding() {
            return;
        }
        goal.restrict(pose, jacobian);
        let [x, y, z, u, v, w] = &jacobian.rows;
        let rows = x.iter().zip(y).zip(z).zip(u.iter().zip(v).zip(w));
        for (column, (((x, y), z), ((u, v), w))) in self.columns.iter_mut().zip(rows) {
            *column = [*x * k, *y * k, *z * k, *u, *v, *w];
        }
        for joint in constants.prismatic.iter() {
            let column = self.columns.get_mut(joint).into_iter().flatten();
            column.for_each(|entry| *entry *= constants.reach);
        }
    }

    /// The squared length of the first step from here; infinite if the step does not close the target ([`CLOSES`]).
    pub(super) fn first_step(&self, held: JointMask) -> T {
        if self.is_rounding() {
            return T::ZERO;
        }
        let step = damped_step(held, &self.columns, &self.error, damping(self.size));
        if step.remaining_error <= self.size * T::from_f64(CLOSES) { step.square } else { T::INFINITY }
    }

    /// The joint vector to which a step from here leads that is taken so many times, angles on any turn. `None` if the step overflows.
    pub(super) fn step(
        &self,
        constants: &ArmConstants<T, N>,
        held: JointMask,
        times: T,
        is_damped: bool,
    ) -> Option<[T; N]> {
        let damping = damping(if is_damped { self.size } else { T::ZERO });
        let step = damped_step(held, &self.columns, &self.error, damping);
        let mut q = self.q;
        for (joint, (value, change)) in q.iter_mut().zip(&step.changes).enumerate() {
            *value += *change * times * constants.unit(joint);
        }
        step.square.is_finite().then_some(q)
    }

    /// Returns true if the error is rounding, and so tells nothing about where the solution is. No step starts there.
    #[inline]
    fn is_rounding(&self) -> bool {
        let floor = T::from_f64(NOISE) * T::EPSILON;
        !(self.size > floor * floor)
    }
}

/// Damped least squares (Levenberg 1944, Marquardt 1963), damped in proportion to the squared error, so that
/// convergence is quadratic. Joint vector and residual of `start` become those of the iterate of least error. If there
/// is a step, angles come into (-pi, pi]. What else is in `start` stays that of the first joint vector.
///
/// There are at most 16 evaluations. No more follow after three steps in a row that stall (`PROGRESS`), after one if
/// the solution is exact, or where the descent converges (`LITTLE`). Of two steps in a row one has to reduce the error,
/// else neither is taken (the watchdog of Chamberlain, Powell, Lemarechal, Pedersen 1982). No step is tried whose
/// linear model predicts a stall, if the model decides. The model decides for a step no longer than the error, and for
/// the shorter step after a step that was not taken. A step that stalls is replaced by the best part of it
/// ([`best_part`]), if that leaves less than half of the squared error. Each evaluation takes one from `left`; without
/// any left there is none.
#[cold]
#[inline(never)]
pub(super) fn refine<T: Tolerances, const N: usize>(
    constants: &ArmConstants<T, N>,
    goal: &dyn Goal<T, N>,
    arm: &dyn Evaluate<T, N>,
    start: &mut Iterate<T, N>,
    evaluations_left: &mut usize,
) {
    if start.is_rounding() {
        return;
    }
    let held = goal.given();
    // A free joint may stay at a reference that is wound by turns.
    wrap_angles(&mut start.q, held, constants.prismatic);
    let mut other = *start;
    let (mut best, mut tried) = (&mut *start, &mut other);
    // Whether the best one is `other`.
    let mut swapped = false;
    // Whether the next step starts at the best joint vector, or at the one tried last.
    let mut from_best = true;
    let (mut boost, mut stretch) = (T::ONE, T::ONE);
    let (mut stalls, mut folds) = (0, true);
    // The gain of the last step from the best joint vector.
    let mut last_gain = T::ZERO;
    let most = MOST_STEPS.min(*evaluations_left);
    let mut taken = 0;
    // Every turn takes an evaluation, or is the last one.
    while taken < most {
        let exact = constants.relative(&best.residual) <= T::EXACT;
        let done = if exact { stalls > 0 } else { stalls >= MOST_STALLS };
        let place = if from_best { &*best } else { &*tried };
        let (from, size) = (place.q, place.size);
        if place.is_rounding() || done {
            break;
        }
        let damping = damping(size) * boost;
        let step = damped_step(held, &place.columns, &place.error, damping);
        if !step.square.is_finite() {
            break;
        }
        // A step changes singular values by about its length, and those below the error are damped away.
        let decides = boost > T::ONE || step.square <= size;
        if from_best {
            let gain = T::ONE - step.remaining_error / size;
            let little = gain < T::from_f64(LITTLE) && gain < last_gain * T::from_f64(FALL);
            // A step of length s changes the error by about s^2 beside its linear part.
            let straight = step.square * step.square <= size * T::from_f64(16.0);
            if little && straight || decides && step.remaining_error > size * T::from_f64(PROGRESS) {
                break;
            }
            last_gain = gain;
        }
        let stalled = best.size * T::from_f64(PROGRESS);
        let (mut error, mut slope) = ([T::ZERO; 6], [T::ZERO; 6]);
        if !from_best {
            // The place is overwritten.
            (error, slope) = (tried.error, slope_along(&tried.columns, &step.changes));
        }
        let mut part = stretch;
        let may_cut = stretch == T::ONE;
        for last in [false, true] {
            tried.q = from;
            for (joint, (value, change)) in tried.q.iter_mut().zip(&step.changes).enumerate() {
                *value += *change * part * constants.unit(joint);
            }
            tried.evaluate(constants, goal, arm);
            taken += 1;
            if last || !may_cut || tried.size < stalled || taken >= most {
                break;
            }
            if from_best {
                (error, slope) = (best.error, slope_along(&best.columns, &step.changes));
            }
            let least;
            (part, least) = best_part(&error, &slope, &tried.error);
            // A part that is not a number is none.
            if !(least < best.size * T::HALF) {
                break;
            }
        }
        // At a fold a step goes half of the way and leaves a quarter of the error, and the model leaves nothing. The
        // next step is taken twice (Decker, Keller, Kelley 1983).
        let ratio = tried.size / size * T::from_f64(16.0);
        let twice = stretch == T::TWO;
        let quarter = ratio > T::HALF * T::HALF && ratio < T::TWO * T::TWO;
        let fold = folds && !twice && quarter && step.remaining_error < tried.size * T::HALF;
        stretch = if fold { T::TWO } else { T::ONE };
        stalls = if tried.size < stalled { 0 } else { stalls + 1 };
        if tried.size < best.size {
            core::mem::swap(&mut best, &mut tried);
            swapped = !swapped;
            from_best = true;
            boost = (boost * T::from_f64(0.1)).max(T::ONE);
        } else if twice {
            // No fold: where three roots meet, a step leaves 8/27 of the error.
            (from_best, folds) = (true, false);
        } else if size > best.size || !tried.size.is_finite() {
            from_best = true;
            boost *= T::from_f64(100.0);
        } else {
            // A step along a narrow curved valley leaves it, and the next one leads back: one step may make it worse.
            from_best = false;
        }
    }
    *evaluations_left -= taken;
    if swapped {
        (start.q, start.residual) = (other.q, other.residual);
    }
    wrap_angles(&mut start.q, held, constants.prismatic);
}

/// The damping of a step from a place with this squared error.
#[inline(always)]
fn damping<T: Tolerances>(size: T) -> T {
    size + T::EPSILON * T::EPSILON * T::from_f64(16.0)
}

/// Change of the error by a step to first order, `-J step`.
#[inline(never)]
fn slope_along<T: Tolerances>(jacobian: &[[T; 6]], changes: &[T]) -> [T; 6] {
    let mut slope = [T::ZERO; 6];
    for (column, change) in jacobian.iter().zip(changes) {
        for (sum, entry) in slope.iter_mut().zip(column) {
            *sum -= *entry * *change;
        }
    }
    slope
}

/// Brings the angles of a joint vector into (-pi, pi]. Those that are `held` stay as they are.
#[inline(never)]
pub(super) fn wrap_angles<T: Tolerances>(q: &mut [T], held: JointMask, prismatic: JointMask) {
    for (joint, value) in q.iter_mut().enumerate() {
        if !(held | prismatic).contains(joint) {
            *value = wrap(*value);
        }
    }
}
