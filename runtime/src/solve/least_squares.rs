//! Damped least-squares steps towards a target.

use super::facts::Evaluate;
use super::{Facts, Goal, Tolerances};
use crate::math::wrap;
use crate::{Jacobian, Residual};

/// The most steps for one solution.
const MOST_STEPS: usize = 24;
/// So many steps in a row that take less than a twentieth of the squared error are the last ones; one, once the solution is
/// exact.
const MOST_STALLS: usize = 3;
/// The squared error that a step has to leave less than, as a part of what it was.
const PROGRESS: f64 = 0.95;
/// Residuals up to so many roundings say nothing about where the solution is, and where the arm is nearly singular a step
/// that chases them leads far away.
const NOISE: f64 = 20.0;

/// A joint vector with what it misses the target by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Iterate<T, const N: usize> {
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
    jacobian: Jacobian<T, N>,
    /// Lengths over reach.
    error: [T; 6],
    /// Its squared length.
    size: T,
}

impl<T: Tolerances, const N: usize> Iterate<T, N> {
    /// Evaluates the arm at `q`.
    pub(super) fn at(facts: &Facts<T, N>, goal: &dyn Goal<T, N>, arm: &dyn Evaluate<T, N>, q: [T; N]) -> Self {
        let (pose, jacobian) = arm.evaluate(&q);
        let k = T::ONE / facts.reach;
        let [x, y, z, u, v, w] = goal.error(&q, &pose);
        let error = [x * k, y * k, z * k, u, v, w];
        let size = error.iter().fold(T::ZERO, |sum, e| sum + *e * *e);
        let residual = goal.misses(&q, &pose);
        Self { q, residual, jacobian: goal.rows(&pose, &jacobian), error, size }
    }
}

/// Damped least squares (Levenberg 1944, Marquardt 1963), damped in proportion to the squared error, so that convergence
/// is quadratic. Up to 24 steps, and no more after three in a row that take less than a twentieth of the squared error;
/// after one, if the solution is exact. Of two steps in a row one has to reduce the error, else neither is taken (the watchdog of
/// Chamberlain, Powell, Lemarechal, Pedersen 1982). Each step takes one from `left`; without any left there is no step.
#[cold]
#[inline(never)]
pub(super) fn refined<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &dyn Goal<T, N>,
    arm: &dyn Evaluate<T, N>,
    start: Iterate<T, N>,
    left: &mut usize,
) -> Iterate<T, N> {
    let (mut best, mut place) = (start, start);
    let (mut boost, mut stretch) = (T::ONE, T::ONE);
    let floor = T::from_f64(NOISE) * T::EPSILON;
    let (mut stalls, mut folds) = (0, true);
    for _ in 0..MOST_STEPS {
        let exact = facts.relative(&best.residual) <= T::EXACT;
        let done = if exact { stalls > 0 } else { stalls >= MOST_STALLS };
        if !(place.size > floor * floor) || *left == 0 || done {
            break;
        }
        *left -= 1;
        let damping = (place.size + T::EPSILON * T::EPSILON * T::from_f64(16.0)) * boost;
        let Some(step) = damped_step(facts, &place.jacobian, &place.error, damping) else { break };
        let mut q = place.q;
        for ((value, change), joint) in q.iter_mut().zip(step).zip(0..) {
            *value += change * stretch;
            if !facts.prismatic.contains(joint) && !goal.given().contains(joint) {
                *value = wrap(*value);
            }
        }
        let next = Iterate::at(facts, goal, arm, q);
        // At a fold a step goes half of the way and leaves a quarter of the error: the next one is taken twice (Decker,
        // Keller, Kelley 1983).
        let ratio = next.size / place.size * T::from_f64(16.0);
        let twice = stretch == T::TWO;
        let fold = folds && !twice && ratio > T::HALF * T::HALF && ratio < T::TWO * T::TWO;
        stretch = if fold { T::TWO } else { T::ONE };
        // A step along a narrow curved valley leaves it, and the next one leads back: one step may make it worse.
        let second = place.size > best.size;
        stalls = if next.size < best.size * T::from_f64(PROGRESS) { 0 } else { stalls + 1 };
        if next.size < best.size {
            (best, place) = (next, next);
            boost = (boost * T::from_f64(0.1)).max(T::ONE);
        } else if twice {
            // No fold: where three roots meet, a step leaves 8/27 of the error.
            (place, folds) = (best, false);
        } else if second || !next.size.is_finite() {
            place = best;
            boost *= T::from_f64(100.0);
        } else {
            place = next;
        }
    }
    best
}

/// The step that minimizes `|J step - error|^2 + damping |step|^2`, with lengths over reach throughout. The rows of J are
/// reflected (Householder 1958) into the triangle that starts as `sqrt(damping) I`. Unlike the normal equations this keeps
/// singular values down to the rounding of J itself, which is what the steps near a fold need.
fn damped_step<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    jacobian: &Jacobian<T, N>,
    error: &[T; 6],
    damping: T,
) -> Option<[T; N]> {
    let k = T::ONE / facts.reach;
    let mut rows = jacobian.rows;
    for (i, row) in rows.iter_mut().enumerate() {
        measured(facts, row, if i < 3 { k } else { T::ONE });
    }
    let mut error = *error;
    let mut triangle = [[T::ZERO; N]; N];
    let mut step = [T::ZERO; N];
    let start = damping.sqrt();
    for (j, (line, right)) in triangle.iter_mut().zip(&mut step).enumerate() {
        *right = reflect(&mut rows, &mut error, line, start, j)?;
    }
    for (j, line) in triangle.iter().enumerate().rev() {
        substitute(line, &mut step, j)?;
    }
    measured(facts, &mut step, T::ONE);
    step.iter().all(|x| x.is_finite()).then_some(step)
}

/// Reflects column j of the rows into `start` on the diagonal. Returns the right side of the new line of the triangle.
#[inline(never)]
fn reflect<T: Tolerances, const N: usize>(
    rows: &mut [[T; N]; 6],
    error: &mut [T; 6],
    line: &mut [T; N],
    start: T,
    j: usize,
) -> Option<T> {
    let mut across = [T::ZERO; 6];
    for (entry, row) in across.iter_mut().zip(rows.iter()) {
        *entry = *row.get(j)?;
    }
    let square = across.iter().fold(start * start, |sum, entry| sum + *entry * *entry);
    let length = square.sqrt();
    let first = start + length;
    // The reflection that takes (start, across) to (-length, 0).
    let share = T::ONE / (length * first);
    *line.get_mut(j)? = -length;
    for column in j + 1..N {
        let mut sum = T::ZERO;
        for (row, entry) in rows.iter().zip(&across) {
            sum += *row.get(column)? * *entry;
        }
        let sum = sum * share;
        *line.get_mut(column)? = -(sum * first);
        for (row, entry) in rows.iter_mut().zip(&across) {
            *row.get_mut(column)? -= sum * *entry;
        }
    }
    let sum = error.iter().zip(&across).fold(T::ZERO, |sum, (e, entry)| sum + *e * *entry) * share;
    for (e, entry) in error.iter_mut().zip(&across) {
        *e -= sum * *entry;
    }
    Some(-(sum * first))
}

/// The unknown on the diagonal of line j of the triangle, from those behind it; its right side is in its place.
#[inline(never)]
fn substitute<T: Tolerances, const N: usize>(line: &[T; N], step: &mut [T; N], j: usize) -> Option<()> {
    let known = line.iter().zip(step.iter()).skip(j + 1).fold(T::ZERO, |sum, (a, x)| sum + *a * *x);
    let value = step.get_mut(j)?;
    *value = (*value - known) / *line.get(j)?;
    Some(())
}

/// A row with an entry for each joint, times `k`, and for a slide times the reach, in which its strokes are measured.
#[inline(never)]
fn measured<T: Tolerances, const N: usize>(facts: &Facts<T, N>, row: &mut [T; N], k: T) {
    for (joint, entry) in row.iter_mut().enumerate() {
        *entry *= if facts.prismatic.contains(joint) { facts.reach * k } else { k };
    }
}
