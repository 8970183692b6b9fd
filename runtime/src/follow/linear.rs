//! Linear functions of joint values: motors that are linked.

use crate::math::Scalar;

/// The matrix `A`, `[N, N]`, of an affine function `A q + b`, by the function's values at 0 and at unit vectors.
pub fn slopes<T: Scalar, const N: usize>(of: impl Fn(&[T; N]) -> [T; N]) -> [[T; N]; N] {
    let origin = of(&[T::ZERO; N]);
    let mut matrix = [[T::ZERO; N]; N];
    for column in 0..N {
        let mut unit = [T::ZERO; N];
        if let Some(entry) = unit.get_mut(column) {
            *entry = T::ONE;
        }
        for (row, (at, zero)) in matrix.iter_mut().zip(of(&unit).into_iter().zip(origin)) {
            if let Some(entry) = row.get_mut(column) {
                *entry = at - zero;
            }
        }
    }
    matrix
}

/// The product of a matrix `[N, N]` and a vector `[N]`.
pub fn product<T: Scalar, const N: usize>(matrix: &[[T; N]; N], vector: &[T; N]) -> [T; N] {
    let mut result = [T::ZERO; N];
    for (sum, row) in result.iter_mut().zip(matrix) {
        for (entry, x) in row.iter().zip(vector) {
            *sum += *entry * *x;
        }
    }
    result
}
