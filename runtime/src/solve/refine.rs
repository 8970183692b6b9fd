//! Full check and damped Newton steps for solutions near a singularity or at the edge of reach.

use super::{Facts, Goal, Tolerances};
use crate::math::wrap;
use crate::{Jacobian, Pose, Residual};

/// Forward kinematics and Jacobian of an arm, as a function.
pub trait Evaluate<T, const N: usize>: Fn(&[T; N]) -> (Pose<T>, Jacobian<T, N>) {}
impl<T, const N: usize, F: Fn(&[T; N]) -> (Pose<T>, Jacobian<T, N>)> Evaluate<T, N> for F {}

/// Residuals up to so many roundings say nothing about where the solution is, and where the arm is nearly singular a step
/// that chases them leads far away.
pub(super) const NOISE: f64 = 20.0;

/// A step that takes less than this part of the error takes nothing.
const STILL: f64 = 1e-3;

/// The residual, lengths relative to reach, as one number; infinite if it is not a number.
pub(super) fn relative<T: Tolerances, const N: usize>(facts: &Facts<T, N>, residual: &Residual<T>) -> T {
    let position = residual.position / facts.reach;
    let known = position.is_finite() && residual.orientation.is_finite();
    if known { position.max(residual.orientation) } else { T::INFINITY }
}

/// How much an angle counts beside a length over reach where the orientation is to stay: its share of a miss falls with
/// the square, from the tolerance for positions to what counts as exact.
pub(super) const STIFF: f64 = 1e3;

/// Damped least squares (Levenberg-Marquardt, damping in proportion to the squared error, so that convergence is
/// quadratic) from `start`. Of two steps in a row one has to reduce the error, else neither is taken (the watchdog of
/// Chamberlain, Powell, Lemarechal, Pedersen 1982). Returns the joint vector and its residual.
pub(super) fn refine<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &impl Goal<T, N>,
    start: &[T; N],
    evaluate: &impl Evaluate<T, N>,
    steps: usize,
) -> ([T; N], Residual<T>) {
    weighted(facts, goal, start, evaluate, steps, Manner { stiffness: T::ONE, brief: false })
}

/// The same from one of several starts: not followed to the end where a step leads on neither to first nor to second
/// order, as out of reach, where the error has a least value.
pub(super) fn refine_briefly<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &impl Goal<T, N>,
    start: &[T; N],
    evaluate: &impl Evaluate<T, N>,
    steps: usize,
) -> ([T; N], Residual<T>) {
    weighted(facts, goal, start, evaluate, steps, Manner { stiffness: T::ONE, brief: true })
}

/// The same towards a target out of reach, with the orientation kept: the tool comes as close as it goes.
#[cold]
#[inline(never)]
pub(super) fn approached<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &impl Goal<T, N>,
    start: &[T; N],
    evaluate: &impl Evaluate<T, N>,
    steps: usize,
) -> ([T; N], Residual<T>) {
    weighted(facts, goal, start, evaluate, steps, Manner { stiffness: T::from_f64(STIFF), brief: false })
}

/// How the iteration goes: how much angles count, and whether it gives up early.
struct Manner<T> {
    stiffness: T,
    brief: bool,
}

fn weighted<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    goal: &impl Goal<T, N>,
    start: &[T; N],
    evaluate: &impl Evaluate<T, N>,
    steps: usize,
    Manner { stiffness, brief }: Manner<T>,
) -> ([T; N], Residual<T>) {
    let measured = |q: [T; N]| {
        let (pose, jacobian) = evaluate(&q);
        let error = scaled(facts, goal.error(&q, &pose), stiffness);
        Place { q, pose, jacobian: goal.rows(&pose, &jacobian), error, size: square(&error) }
    };
    let mut best = measured(*start);
    let mut place = best;
    let mut boost = T::ONE;
    let floor = T::from_f64(NOISE) * T::EPSILON;
    let floor = floor * floor;
    for _ in 0..steps {
        if !(place.size > floor) {
            break;
        }
        let damping = (place.size + T::EPSILON * T::EPSILON * T::from_f64(16.0)) * boost;
        let Some(Step { step, left, square }) = damped_step(facts, &place.jacobian, &place.error, damping, stiffness)
        else {
            boost *= T::from_f64(100.0);
            place = best;
            continue;
        };
        let still = T::from_f64(STILL);
        let stays = left > place.size * (T::ONE - still) && square * square < place.size * still * still;
        if brief && stays && !(place.size > best.size) {
            break;
        }
        let mut next = place.q;
        for ((value, change), joint) in next.iter_mut().zip(step).zip(0..) {
            *value += change;
            if !facts.prismatic.contains(joint) && !goal.given().contains(joint) {
                *value = wrap(*value);
            }
        }
        let next = measured(next);
        // A step along a narrow curved valley leaves it, and the next one leads back: one step may make it worse.
        let second = place.size > best.size;
        if next.size < best.size {
            (best, place) = (next, next);
            boost = (boost * T::from_f64(0.1)).max(T::ONE);
        } else if second || !next.size.is_finite() {
            place = best;
            boost *= T::from_f64(100.0);
        } else {
            place = next;
        }
    }
    let residual = goal.residual(&best.q, &best.pose);
    (best.q, residual)
}

/// A joint vector with what it leads to.
#[derive(Clone, Copy)]
struct Place<T, const N: usize> {
    q: [T; N],
    pose: Pose<T>,
    jacobian: Jacobian<T, N>,
    error: [T; 6],
    size: T,
}

/// A step, the squared error that it leaves to first order, and its squared length (rad, strokes over reach).
struct Step<T, const N: usize> {
    step: [T; N],
    left: T,
    square: T,
}

/// The error with its lengths over reach and its angles times `stiffness`.
fn scaled<T: Tolerances, const N: usize>(facts: &Facts<T, N>, [x, y, z, u, v, w]: [T; 6], stiffness: T) -> [T; 6] {
    let k = T::ONE / facts.reach;
    [x * k, y * k, z * k, u * stiffness, v * stiffness, w * stiffness]
}

fn square<T: Tolerances>(error: &[T; 6]) -> T {
    error.iter().fold(T::ZERO, |sum, e| sum + *e * *e)
}

/// The step that minimizes `|J step - error|^2 + damping |step|^2`, and that minimum, with lengths over reach and angles
/// times `stiffness` throughout: the rows of J are rotated (Givens) into the triangle that starts as `sqrt(damping) I`.
/// Unlike the normal equations this keeps singular values down to the rounding of J itself, which is what the steps near
/// a fold need.
fn damped_step<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    jacobian: &Jacobian<T, N>,
    error: &[T; 6],
    damping: T,
    stiffness: T,
) -> Option<Step<T, N>> {
    let unit = |joint: usize| if facts.prismatic.contains(joint) { facts.reach } else { T::ONE };
    let k = T::ONE / facts.reach;
    let mut triangle = [[T::ZERO; N]; N];
    let mut right = [T::ZERO; N];
    let mut left = T::ZERO;
    for (i, line) in triangle.iter_mut().enumerate() {
        *line.get_mut(i)? = damping.sqrt();
    }
    for (i, (row, e)) in jacobian.rows.iter().zip(error).enumerate() {
        let (mut row, mut e) = (*row, *e);
        for (joint, entry) in row.iter_mut().enumerate() {
            *entry = *entry * unit(joint) * if i < 3 { k } else { stiffness };
        }
        for (j, (line, value)) in triangle.iter_mut().zip(&mut right).enumerate() {
            let (diagonal, below) = (*line.get(j)?, *row.get(j)?);
            let length = diagonal.hypot(below);
            if !(length > T::ZERO) {
                continue;
            }
            let (c, s) = (diagonal / length, below / length);
            for (upper, lower) in line.iter_mut().zip(&mut row).skip(j) {
                (*upper, *lower) = (c * *upper + s * *lower, c * *lower - s * *upper);
            }
            (*value, e) = (c * *value + s * e, c * e - s * *value);
        }
        left += e * e;
    }
    let mut step = [T::ZERO; N];
    for (j, line) in triangle.iter().enumerate().rev() {
        let known = line.iter().zip(&step).skip(j + 1).fold(T::ZERO, |sum, (a, x)| sum + *a * *x);
        *step.get_mut(j)? = (*right.get(j)? - known) / *line.get(j)?;
    }
    let square = step.iter().fold(T::ZERO, |sum, change| sum + *change * *change);
    for (joint, change) in step.iter_mut().enumerate() {
        *change *= unit(joint);
    }
    step.iter().all(|x| x.is_finite()).then_some(Step { step, left, square })
}
