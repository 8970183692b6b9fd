//! A damped least-squares step.

use super::kernel::tolerances::Tolerances;

/// The most columns of a Jacobian that are not zero.
pub(super) const MOST_COLUMNS: usize = 7;

/// A damped step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<T, const N: usize> {
    /// The change for each column.
    pub(super) changes: [T; N],
    /// Its squared length.
    pub(super) square: T,
    /// Squared error after the step by the linear model, including the damping term.
    pub(super) remaining_error: T,
}

/// The step that minimizes `|J step - error|^2 + damping |step|^2`, and that minimum. J is reflected (Householder 1958)
/// into the triangle that starts as `sqrt(damping) I`. Unlike the normal equations this keeps singular values down to
/// the rounding of J itself, which is what the steps near a fold need. `16 eps^2` are added to the damping, so that a column
/// of zeros has a diagonal. Columns behind the seventh have to be zero ([`MOST_COLUMNS`]): a line of the triangle has six
/// entries beside the diagonal. A step that overflows has a `square` that is not finite.
#[inline(never)]
pub(super) fn damped_step<T: Tolerances, const N: usize>(
    jacobian: &[[T; 6]; N],
    error: &[T; 6],
    damping: T,
) -> Step<T, N> {
    // A line of the triangle takes the place of its column.
    let (mut columns, mut error, mut changes) = (*jacobian, *error, [T::ZERO; N]);
    let start = (damping + T::EPSILON * T::EPSILON * T::from_f64(16.0)).sqrt();
    let mut rest = columns.as_mut_slice();
    for right in &mut changes {
        let Some((column, behind)) = rest.split_first_mut() else { break };
        *right = reflect(column, behind, &mut error, start);
        rest = behind;
    }
    for (place, line) in columns.iter().enumerate().rev() {
        if let Some((value, behind)) = changes.get_mut(place..).and_then(<[T]>::split_first_mut) {
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

    /// `J^T (J x - error) + damping x` vanishes at the minimum, for each of the first `moving` columns. `|x|` is at most
    /// `|error| / (2 sqrt(damping))`, 700 here, so its rounding is 1e-13. Columns of zeros behind change nothing.
    fn is_least<const N: usize>(moving: usize, damping: f64) {
        let (mut jacobian, error) = (columns::<N>(), [0.3, -0.2, 0.9, 0.1, -0.7, 0.4]);
        jacobian[moving..].fill([0.0; 6]);
        let step = damped_step(&jacobian, &error, damping);
        let mut missed = error;
        for (column, change) in jacobian.iter().zip(&step.changes) {
            for (miss, entry) in missed.iter_mut().zip(column) {
                *miss -= entry * change;
            }
        }
        for (place, (column, change)) in jacobian.iter().zip(&step.changes).enumerate() {
            let slope = damping * change - dot(column, &missed);
            assert!(slope.abs() < 1e-12, "{N} columns, damping {damping:e}, column {place}: {slope:e}");
        }
        assert!(step.changes[moving..].iter().all(|change| *change == 0.0), "{:?}", step.changes);
        let square: f64 = step.changes.iter().map(|x| x * x).sum();
        let wanted = dot(&missed, &missed) + damping * square;
        assert!((step.square - square).abs() <= 1e-12 * square, "{N} columns: {} {square}", step.square);
        assert!((step.remaining_error - wanted).abs() < 1e-12, "{N} columns: {} {wanted}", step.remaining_error);
    }

    #[test]
    fn a_step_is_the_minimum_of_its_squares() {
        for damping in [1.0, 1e-3, 1e-6] {
            is_least::<3>(3, damping);
            is_least::<6>(6, damping);
            for moving in [0, 1, 5, 6, 7] {
                is_least::<7>(moving, damping);
                is_least::<8>(moving, damping);
                is_least::<10>(moving, damping);
            }
        }
    }

    #[test]
    fn a_column_of_zeros_has_no_change_without_damping() {
        let column = [0.6, 0.0, 0.8, 0.0, 0.0, 0.0];
        let step = damped_step(&[[0.0; 6], column, [0.0; 6]], &column, 0.0_f64);
        assert!(step.changes.iter().zip([0.0, 1.0, 0.0]).all(|(x, wanted)| (x - wanted).abs() < 1e-14), "{step:?}");
    }

    #[test]
    fn what_overflows_is_no_step() {
        let huge = damped_step(&[[1e200_f64; 6]; 3], &[1e200; 6], 1.0);
        let unknown = damped_step(&[[f64::NAN; 6]; 3], &[1.0; 6], 1.0);
        assert!(!huge.square.is_finite() && !unknown.square.is_finite());
    }
}
