//! Damped least-squares steps towards a target.

use super::facts::Evaluate;
use super::{Facts, Goal, Tolerances};
use crate::math::wrap;
use crate::{JointMask, Residual};

/// The most steps for one solution.
pub(super) const MOST_STEPS: usize = 16;
/// So many steps in a row that stall are the last ones; one, once the solution is exact.
const MOST_STALLS: usize = 3;
/// A step stalls that leaves more than this part of the squared error. Where several singularities meet, a step that takes
/// little may come before one that takes nearly all.
const PROGRESS: f64 = 0.95;
/// Residuals up to so many roundings say nothing about where the solution is, and where the arm is nearly singular a step
/// that chases them leads far away.
const NOISE: f64 = 20.0;

/// A joint vector with what it misses the target by. Lengths are relative to reach throughout.
#[derive(Debug, Clone, Copy)]
pub(super) struct Iterate<T, const N: usize> {
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
    /// The columns of the Jacobian.
    columns: [[T; 6]; N],
    error: [T; 6],
    /// Its squared length.
    size: T,
}

impl<T: Tolerances, const N: usize> Iterate<T, N> {
    /// Evaluates the arm at `q`.
    #[inline]
    pub(super) fn at(facts: &Facts<T, N>, goal: &dyn Goal<T, N>, arm: &dyn Evaluate<T, N>, q: [T; N]) -> Self {
        let mut iterate =
            Self { q, residual: Residual::ZERO, columns: [[T::ZERO; 6]; N], error: [T::ZERO; 6], size: T::ZERO };
        iterate.evaluate(facts, goal, arm);
        iterate
    }

    /// Evaluates the arm at its joint vector.
    #[inline(never)]
    fn evaluate(&mut self, facts: &Facts<T, N>, goal: &dyn Goal<T, N>, arm: &dyn Evaluate<T, N>) {
        let mut evaluated = arm.evaluate(&self.q);
        let (pose, jacobian) = &mut evaluated;
        goal.restrict(pose, jacobian);
        let k = T::ONE / facts.reach;
        let [x, y, z, u, v, w] = &jacobian.rows;
        let rows = x.iter().zip(y).zip(z).zip(u.iter().zip(v).zip(w));
        for (column, (((x, y), z), ((u, v), w))) in self.columns.iter_mut().zip(rows) {
            *column = [*x * k, *y * k, *z * k, *u, *v, *w];
        }
        for joint in facts.prismatic.iter() {
            let column = self.columns.get_mut(joint).into_iter().flatten();
            column.for_each(|entry| *entry *= facts.reach);
        }
        let [x, y, z, u, v, w] = goal.error(&self.q, pose);
        self.error = [x * k, y * k, z * k, u, v, w];
        self.size = dot(&self.error, &self.error);
        self.residual = goal.misses(&self.q, pose);
    }
}

/// Damped least squares (Levenberg 1944, Marquardt 1963), damped in proportion to the squared error, so that convergence
/// is quadratic. Returns the joint vector of least error and its residual.
///
/// There are up to 16 steps, and no more after three in a row that stall (`PROGRESS`); after one, if the solution is exact.
/// Of two steps in a row one has to reduce the error, else neither is taken (the watchdog of Chamberlain, Powell,
/// Lemarechal, Pedersen 1982). Each step takes one from `left`; without any left there is no step.
#[cold]
#[inline(never)]
pub(super) fn refined<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &dyn Goal<T, N>,
    arm: &dyn Evaluate<T, N>,
    start: &mut Iterate<T, N>,
    left: &mut usize,
) -> ([T; N], Residual<T>) {
    let floor = T::from_f64(NOISE) * T::EPSILON;
    if !(start.size > floor * floor) {
        return (start.q, start.residual);
    }
    let held = goal.given();
    let mut other = *start;
    let (mut best, mut tried) = (start, &mut other);
    // Whether the next step starts at the best joint vector, or at the one tried last.
    let mut from_best = true;
    let (mut boost, mut stretch) = (T::ONE, T::ONE);
    let (mut stalls, mut folds) = (0, true);
    for _ in 0..MOST_STEPS {
        let exact = facts.relative(&best.residual) <= T::EXACT;
        let done = if exact { stalls > 0 } else { stalls >= MOST_STALLS };
        let place = if from_best { &*best } else { &*tried };
        let (start, size) = (place.q, place.size);
        if !(size > floor * floor) || *left == 0 || done {
            break;
        }
        *left -= 1;
        let damping = (size + T::EPSILON * T::EPSILON * T::from_f64(16.0)) * boost;
        let Some((step, model)) = damped_step(facts, held, &place.columns, place.error, damping) else { break };
        tried.q = start;
        for ((value, change), joint) in tried.q.iter_mut().zip(step).zip(0..) {
            *value += change * stretch;
            if !(facts.prismatic | held).contains(joint) {
                *value = wrap(*value);
            }
        }
        tried.evaluate(facts, goal, arm);
        // At a fold a step goes half of the way and leaves a quarter of the error, the model nothing: the next one is taken
        // twice (Decker, Keller, Kelley 1983).
        let ratio = tried.size / size * T::from_f64(16.0);
        let twice = stretch == T::TWO;
        let quarter = ratio > T::HALF * T::HALF && ratio < T::TWO * T::TWO;
        let fold = folds && !twice && quarter && model < tried.size * T::HALF;
        stretch = if fold { T::TWO } else { T::ONE };
        stalls = if tried.size < best.size * T::from_f64(PROGRESS) { 0 } else { stalls + 1 };
        if tried.size < best.size {
            core::mem::swap(&mut best, &mut tried);
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
    (best.q, best.residual)
}

/// The step that minimizes `|J step - error|^2 + damping |step|^2`; a slide's in the unit of its joint. J is reflected
/// (Householder 1958) into the triangle that starts as `sqrt(damping) I`. Unlike the normal equations this keeps singular
/// values down to the rounding of J itself, which is what the steps near a fold need. Joints that are `held` stay.
/// Returns the step and that minimum: what the linear model leaves of the squared error.
fn damped_step<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    held: JointMask,
    jacobian: &[[T; 6]; N],
    mut error: [T; 6],
    damping: T,
) -> Option<([T; N], T)> {
    let mut columns = *jacobian;
    let mut triangle = [[T::ZERO; N]; N];
    let mut step = [T::ZERO; N];
    let start = damping.sqrt();
    let mut rest = columns.as_mut_slice();
    for (j, (line, value)) in triangle.iter_mut().zip(&mut step).enumerate() {
        let (across, behind) = rest.split_first_mut()?;
        if !held.contains(j) {
            *value = reflect(across, behind, line.get_mut(j + 1..)?, &mut error, start);
        }
        rest = behind;
    }
    for (j, line) in triangle.iter().enumerate().rev() {
        let (value, behind) = step.get_mut(j..)?.split_first_mut()?;
        *value = line.iter().skip(j + 1).zip(behind).fold(*value, |value, (entry, x)| value - *entry * *x);
    }
    for joint in facts.prismatic.iter() {
        *step.get_mut(joint)? *= facts.reach;
    }
    step.iter().all(|x| x.is_finite()).then_some((step, dot(&error, &error)))
}

/// Reflects a column into `start` on the diagonal, and with it the columns `behind` and the error. Of the new line of the
/// triangle, divided by its diagonal, `entries` are those of the columns behind; the right side is returned.
#[inline(never)]
fn reflect<T: Tolerances>(
    across: &[T; 6],
    behind: &mut [[T; 6]],
    entries: &mut [T],
    error: &mut [T; 6],
    start: T,
) -> T {
    let length = (start * start + dot(across, across)).sqrt();
    let inverse = T::ONE / length;
    // The reflection that takes (start, across) to (-length, 0), in parts of the first entry's change.
    let parts = across.map(|entry| entry / (start + length));
    let reflected = |column: &mut [T; 6]| {
        let along = dot(column, across) * inverse;
        for (entry, part) in column.iter_mut().zip(&parts) {
            *entry -= along * *part;
        }
        along * inverse
    };
    for (entry, column) in entries.iter_mut().zip(behind) {
        *entry = reflected(column);
    }
    reflected(error)
}

/// Even and odd terms apart: two sums at a time.
#[inline]
fn dot<T: Tolerances>([a, b, c, d, e, f]: &[T; 6], [u, v, w, x, y, z]: &[T; 6]) -> T {
    (*a * *u + *c * *w + *e * *y) + (*b * *v + *d * *x + *f * *z)
}
