//! Full check and damped Newton steps for solutions near a singularity or at the edge of reach.

use super::{Facts, Tolerances};
use crate::math::wrap;
use crate::{Jacobian, Pose, Residual};

/// Forward kinematics and Jacobian of an arm, as a function.
pub trait Evaluate<T, const N: usize>: Fn(&[T; N]) -> (Pose<T>, Jacobian<T, N>) {}
impl<T, const N: usize, F: Fn(&[T; N]) -> (Pose<T>, Jacobian<T, N>)> Evaluate<T, N> for F {}

/// The residual, lengths relative to reach, as one number.
pub(super) fn relative<T: Tolerances, const N: usize>(facts: &Facts<T, N>, residual: &Residual<T>) -> T {
    (residual.position / facts.reach).max(residual.orientation)
}

/// Damped least squares (Levenberg-Marquardt, damping in proportion to the squared error, so that convergence is
/// quadratic) from `q`. Steps that do not reduce the error are not taken. Returns the joint vector and its residual.
pub(super) fn refine<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    target: &Pose<T>,
    start: &[T; N],
    evaluate: &impl Evaluate<T, N>,
    steps: usize,
) -> ([T; N], Residual<T>) {
    let mut q = *start;
    let (mut pose, mut jacobian) = evaluate(&q);
    let mut error = twist(facts, target, &pose);
    let mut size = square(&error);
    let mut boost = T::ONE;
    let floor = T::EPSILON * T::EPSILON * T::from_f64(4.0);
    for _ in 0..steps {
        if !(size > floor) {
            break;
        }
        let damping = (size + T::EPSILON * T::EPSILON * T::from_f64(16.0)) * boost;
        let Some(step) = damped_step(facts, &jacobian, &error, damping) else {
            boost = boost * T::from_f64(100.0);
            continue;
        };
        let mut next = q;
        for ((value, change), joint) in next.iter_mut().zip(step).zip(0..) {
            *value += change;
            if !facts.prismatic.contains(joint) {
                *value = wrap(*value);
            }
        }
        let (next_pose, next_jacobian) = evaluate(&next);
        let next_error = twist(facts, target, &next_pose);
        let next_size = square(&next_error);
        if next_size < size {
            (q, pose, jacobian, error, size) = (next, next_pose, next_jacobian, next_error, next_size);
            boost = (boost * T::from_f64(0.1)).max(T::ONE);
        } else {
            boost = boost * T::from_f64(100.0);
        }
    }
    (q, pose.residual(target))
}

/// The error as a twist: translation over reach, and the rotation's axis times the sine of its angle.
fn twist<T: Tolerances, const N: usize>(facts: &Facts<T, N>, target: &Pose<T>, pose: &Pose<T>) -> [T; 6] {
    let ([tx, ty, tz], [px, py, pz]) = (target.translation, pose.translation);
    let k = T::ONE / facts.reach;
    let mut turn = [T::ZERO; 3];
    for j in 0..3 {
        let column = |m: &[[T; 3]; 3]| m.map(|row| row.get(j).copied().unwrap_or(T::ZERO));
        let ([a, b, c], [d, e, f]) = (column(&pose.rotation), column(&target.rotation));
        let [x, y, z] = turn;
        turn = [x + b * f - c * e, y + c * d - a * f, z + a * e - b * d];
    }
    let [x, y, z] = turn.map(|w| w * T::HALF);
    [(tx - px) * k, (ty - py) * k, (tz - pz) * k, x, y, z]
}

fn square<T: Tolerances>(error: &[T; 6]) -> T {
    error.iter().fold(T::ZERO, |sum, e| sum + *e * *e)
}

/// Solves `(J^T J + damping I) step = J^T error` by Cholesky's factorization, with lengths over reach throughout.
fn damped_step<T: Tolerances, const N: usize>(
    facts: &Facts<T, N>,
    jacobian: &Jacobian<T, N>,
    error: &[T; 6],
    damping: T,
) -> Option<[T; N]> {
    let k = T::ONE / facts.reach;
    let mut rows = jacobian.rows;
    for (i, row) in rows.iter_mut().enumerate() {
        for (entry, joint) in row.iter_mut().zip(0..) {
            if i < 3 {
                *entry *= k;
            }
            if facts.prismatic.contains(joint) {
                *entry *= facts.reach;
            }
        }
    }
    let mut matrix = [[T::ZERO; N]; N];
    let mut right = [T::ZERO; N];
    for (row, e) in rows.iter().zip(error) {
        for ((line, sum), a) in matrix.iter_mut().zip(&mut right).zip(row) {
            *sum += *a * *e;
            for (entry, b) in line.iter_mut().zip(row) {
                *entry += *a * *b;
            }
        }
    }
    for (i, line) in matrix.iter_mut().enumerate() {
        if let Some(diagonal) = line.get_mut(i) {
            *diagonal += damping;
        }
    }
    let mut step = cholesky_solve(matrix, right)?;
    for (change, joint) in step.iter_mut().zip(0..) {
        if facts.prismatic.contains(joint) {
            *change *= facts.reach;
        }
    }
    step.iter().all(|x| x.is_finite()).then_some(step)
}

/// Solves a symmetric positive definite system; `None` if it is not positive definite to rounding.
fn cholesky_solve<T: Tolerances, const N: usize>(mut a: [[T; N]; N], mut b: [T; N]) -> Option<[T; N]> {
    for j in 0..N {
        let done = a;
        let pivot_row = done.get(j)?;
        let sum = pivot_row.iter().take(j).fold(T::ZERO, |sum, x| sum + *x * *x);
        let pivot = (*pivot_row.get(j)? - sum).sqrt();
        if !(pivot > T::ZERO) {
            return None;
        }
        for (i, line) in a.iter_mut().enumerate().skip(j) {
            let dot = line.iter().zip(pivot_row).take(j).fold(T::ZERO, |sum, (x, y)| sum + *x * *y);
            let entry = line.get_mut(j)?;
            *entry = if i == j { pivot } else { (*entry - dot) / pivot };
        }
    }
    for j in 0..N {
        let row = a.get(j)?;
        let sum = row.iter().zip(&b).take(j).fold(T::ZERO, |sum, (x, y)| sum + *x * *y);
        let value = (*b.get(j)? - sum) / *row.get(j)?;
        *b.get_mut(j)? = value;
    }
    for j in (0..N).rev() {
        let sum = a.iter().zip(&b).skip(j + 1).try_fold(T::ZERO, |sum, (row, y)| Some(sum + *row.get(j)? * *y))?;
        let value = (*b.get(j)? - sum) / *a.get(j)?.get(j)?;
        *b.get_mut(j)? = value;
    }
    Some(b)
}
