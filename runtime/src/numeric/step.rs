//! The damped least squares step.

use super::linear;
use super::model::Joints;
use crate::math::Scalar;

/// The step `dq` that minimizes `|W (J dq - e)|^2 + damping |C^-1 dq|^2`. `W` divides the rows of lengths by `length`.
/// `C` is the diagonal of `columns` (none: ones). A joint whose column is 0 does not move.
///
/// `damping` must be above 0. Nothing then divides by zero, and what is finite stays finite unless it overflows.
#[inline(always)]
pub(super) fn damped<T: Scalar, Q: Joints<T>>(
    rows: &[Q; 6],
    error: &[T; 6],
    damping: T,
    length: T,
    columns: Option<&Q>,
    step: &mut Q,
) {
    let per_length = T::ONE / length;
    let [ex, ey, ez, ax, ay, az] = *error;
    let error = [ex * per_length, ey * per_length, ez * per_length, ax, ay, az];
    if step.as_ref().len() <= 6 {
        narrow(rows, &error, damping, per_length, columns, step);
    } else {
        wide(rows, &error, damping, per_length, columns, step);
    }
    if let Some(columns) = columns {
        for (change, scale) in step.as_mut().iter_mut().zip(columns.as_ref()) {
            *change *= *scale;
        }
    }
}

/// At most six joints: `(J^T J + damping I) x = J^T e`. The joints that are not there have columns of zeros.
#[inline(always)]
fn narrow<T: Scalar, Q: Joints<T>>(
    rows: &[Q; 6],
    error: &[T; 6],
    damping: T,
    per_length: T,
    columns: Option<&Q>,
    step: &mut Q,
) {
    let mut scaled = [[T::ZERO; 6]; 6];
    for (index, (to, from)) in scaled.iter_mut().zip(rows).enumerate() {
        for (to, from) in to.iter_mut().zip(from.as_ref()) {
            *to = if index < 3 { *from * per_length } else { *from };
        }
        if let Some(columns) = columns {
            for (to, scale) in to.iter_mut().zip(columns.as_ref()) {
                *to *= *scale;
            }
        }
    }
    let mut right = [T::ZERO; 6];
    for (row, error) in scaled.iter().zip(error) {
        for (sum, entry) in right.iter_mut().zip(row) {
            *sum += *entry * *error;
        }
    }
    // The upper triangle, from an even column on, so that entries pair up in a register. As in `linear`, row by row.
    let mut matrix = [[T::ZERO; 6]; 6];
    macro_rules! products {
        ($($i:literal)*) => {$(
            for row in &scaled {
                for j in ($i & !1)..6 {
                    matrix[$i][j] += row[$i] * row[j];
                }
            }
            matrix[$i][$i] += damping;
        )*};
    }
    products! { 0 1 2 3 4 5 }
    let solution = linear::solve(matrix, right, T::EPSILON);
    for (to, from) in step.as_mut().iter_mut().zip(solution) {
        *to = from;
    }
}

/// More than six joints: `(J J^T + damping I) y = e`, `x = J^T y`: the shortest step of those that reach.
#[inline(always)]
fn wide<T: Scalar, Q: Joints<T>>(
    rows: &[Q; 6],
    error: &[T; 6],
    damping: T,
    per_length: T,
    columns: Option<&Q>,
    step: &mut Q,
) {
    let mut scaled = rows.clone();
    for (index, row) in scaled.iter_mut().enumerate() {
        for entry in row.as_mut() {
            *entry = if index < 3 { *entry * per_length } else { *entry };
        }
        if let Some(columns) = columns {
            for (entry, scale) in row.as_mut().iter_mut().zip(columns.as_ref()) {
                *entry *= *scale;
            }
        }
    }
    let mut matrix = [[T::ZERO; 6]; 6];
    macro_rules! products {
        ($($i:literal)*) => {$(
            for j in $i..6 {
                let pairs = scaled[$i].as_ref().iter().zip(scaled[j].as_ref());
                matrix[$i][j] = pairs.fold(T::ZERO, |sum, (a, b)| sum + *a * *b);
            }
            matrix[$i][$i] += damping;
        )*};
    }
    products! { 0 1 2 3 4 5 }
    let solution = linear::solve(matrix, *error, T::EPSILON);
    step.as_mut().fill(T::ZERO);
    for (row, factor) in scaled.iter().zip(solution) {
        for (sum, entry) in step.as_mut().iter_mut().zip(row.as_ref()) {
            *sum += *entry * factor;
        }
    }
}
