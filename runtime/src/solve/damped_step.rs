//! A damped least-squares step.

use super::kernel::tolerances::Tolerances;
use crate::JointMask;

/// A damped step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<T, const N: usize> {
    /// Change of each joint; of a prismatic joint relative to reach.
    pub(super) changes: [T; N],
    /// Its squared length.
    pub(super) square: T,
    /// Squared error after the step by the linear model, including the damping term.
    pub(super) remaining_error: T,
}

/// The step that minimizes `|J step - error|^2 + damping |step|^2`, and that minimum. J is reflected (Householder 1958)
/// into the triangle that starts as `sqrt(damping) I`. Unlike the normal equations this keeps singular values down to
/// the rounding of J itself, which is what the steps near a fold need. Joints that are `held` stay. A step that
/// overflows has a `square` that is not finite. At most seven joints are not held.
#[inline(never)]
pub(super) fn damped_step<T: Tolerances, const N: usize>(
    held: JointMask,
    jacobian: &[[T; 6]; N],
    error: &[T; 6],
    damping: T,
) -> Step<T, N> {
    if N <= MOST_MOVING {
        return step(held, jacobian, error, damping);
    }
    // Those that move in front, so that each has a place in the lines of those before it.
    let mut columns = [[T::ZERO; 6]; N];
    let moving = || (0..N).filter(|joint| !held.contains(*joint));
    for (column, own) in columns.iter_mut().zip(moving().filter_map(|joint| jacobian.get(joint))) {
        *column = *own;
    }
    let packed = step(JointMask::NONE, &columns, error, damping);
    let mut changes = [T::ZERO; N];
    for (joint, change) in moving().zip(packed.changes) {
        if let Some(place) = changes.get_mut(joint) {
            *place = change;
        }
    }
    Step { changes, ..packed }
}

/// A line of the triangle has six entries beside the diagonal.
const MOST_MOVING: usize = 7;

/// The step, of at most [`MOST_MOVING`] joints in front that are not held.
#[inline(always)]
fn step<T: Tolerances, const N: usize>(
    held: JointMask,
    jacobian: &[[T; 6]; N],
    error: &[T; 6],
    damping: T,
) -> Step<T, N> {
    // A line of the triangle takes the place of its column.
    let (mut columns, mut error) = (*jacobian, *error);
    let mut changes = [T::ZERO; N];
    let start = damping.sqrt();
    let mut rest = columns.as_mut_slice();
    for (joint, right) in changes.iter_mut().enumerate() {
        let Some((column, behind)) = rest.split_first_mut() else { break };
        if held.contains(joint) {
            *column = [T::ZERO; 6];
        } else {
            *right = reflect(column, behind, &mut error, start);
        }
        rest = behind;
    }
    for (joint, line) in columns.iter().enumerate().rev() {
        if let Some((value, behind)) = changes.get_mut(joint..).and_then(<[T]>::split_first_mut) {
            *value = line.iter().zip(behind).fold(*value, |value, (entry, x)| value - *entry * *x);
        }
    }
    let square = changes.iter().fold(T::ZERO, |sum, x| sum + *x * *x);
    Step { changes, square, remaining_error: dot_out_of_line(&error, &error) }
}

/// Reflects a column into `start` on the diagonal, and with it the columns `behind` and the error. The column becomes
/// the new line of the triangle, divided by its diagonal: the entries of the columns behind. The right side is returned.
#[inline(never)]
fn reflect<T: Tolerances>(line: &mut [T; 6], behind: &mut [[T; 6]], error: &mut [T; 6], start: T) -> T {
    let across = *line;
    // The reflection takes (start, across) to (-length, 0).
    let length = (start * start + dot(&across, &across)).sqrt();
    let (inverse, share) = (T::ONE / length, T::ONE / (start + length));
    let mirror = |column: &mut [T; 6]| {
        let along = dot(column, &across) * inverse;
        let part = along * share;
        for (entry, across) in column.iter_mut().zip(&across) {
            *entry -= part * *across;
        }
        along * inverse
    };
    for (entry, column) in line.iter_mut().zip(behind) {
        *entry = mirror(column);
    }
    mirror(error)
}

/// Even and odd terms apart: two sums at a time.
#[inline]
fn dot<T: Tolerances>([a, b, c, d, e, f]: &[T; 6], [u, v, w, x, y, z]: &[T; 6]) -> T {
    (*a * *u + *c * *w + *e * *y) + (*b * *v + *d * *x + *f * *z)
}

/// [`dot`] as a function of its own, for code that seldom runs.
#[inline(never)]
pub(super) fn dot_out_of_line<T: Tolerances>(a: &[T; 6], b: &[T; 6]) -> T {
    dot(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns without structure, the last two nearly parallel.
    fn columns<const N: usize>() -> [[f64; 6]; N] {
        let entry = |row: usize, joint: usize| ((7 * row + 3 * joint + row * joint) as f64).sin();
        let mut columns = core::array::from_fn(|joint| core::array::from_fn(|row| entry(row, joint)));
        if let [.., before, last] = columns.as_mut_slice() {
            *last = before.map(|x| x * (1.0 + 1e-9));
        }
        columns
    }

    /// `J^T (J x - error) + damping x` vanishes at the minimum, for each joint that moves. `|x|` is at most
    /// `|error| / (2 sqrt(damping))`, 700 here, so its rounding is 1e-13.
    fn is_least<const N: usize>(held: JointMask, damping: f64) {
        let (jacobian, error) = (columns::<N>(), [0.3, -0.2, 0.9, 0.1, -0.7, 0.4]);
        let step = damped_step(held, &jacobian, &error, damping);
        let mut missed = error;
        for (column, change) in jacobian.iter().zip(&step.changes) {
            for (miss, entry) in missed.iter_mut().zip(column) {
                *miss -= entry * change;
            }
        }
        for (joint, (column, change)) in jacobian.iter().zip(&step.changes).enumerate() {
            if held.contains(joint) {
                assert_eq!(*change, 0.0, "joint {joint}");
            } else {
                let slope = damping * change - dot(column, &missed);
                assert!(slope.abs() < 1e-12, "{N} joints, damping {damping:e}, joint {joint}: {slope:e}");
            }
        }
        let square: f64 = step.changes.iter().map(|x| x * x).sum();
        let wanted = dot(&missed, &missed) + damping * square;
        assert!((step.square - square).abs() <= 1e-12 * square, "{N} joints: {} {square}", step.square);
        assert!((step.remaining_error - wanted).abs() < 1e-12, "{N} joints: {} {wanted}", step.remaining_error);
    }

    #[test]
    fn a_step_is_the_minimum_of_its_squares() {
        for damping in [1.0, 1e-3, 1e-6] {
            for held in [JointMask::NONE, JointMask::single(0), JointMask::single(1) | JointMask::single(2)] {
                is_least::<3>(held, damping);
                is_least::<6>(held, damping);
                is_least::<7>(held, damping);
            }
            let held = JointMask::single(0) | JointMask::single(4) | JointMask::single(9);
            is_least::<10>(held, damping);
            is_least::<10>(held | JointMask::single(5), damping);
            is_least::<8>(JointMask::single(7), damping);
        }
    }

    #[test]
    fn what_overflows_is_no_step() {
        let huge = damped_step(JointMask::NONE, &[[1e200_f64; 6]; 3], &[1e200; 6], 1.0);
        let unknown = damped_step(JointMask::NONE, &[[f64::NAN; 6]; 3], &[1.0; 6], 1.0);
        assert!(!huge.square.is_finite() && !unknown.square.is_finite());
    }
}
