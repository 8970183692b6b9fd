//! Vectors of three numbers.

use crate::math::Scalar;

/// `a x b`
#[inline]
pub(crate) fn cross<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// `a + b`
#[inline]
pub(crate) fn add<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a + x, b + y, c + z]
}

/// `a - b`
#[inline]
pub(crate) fn sub<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a - x, b - y, c - z]
}

/// `k a`
#[inline]
pub(crate) fn scale<T: Scalar>(k: T, a: [T; 3]) -> [T; 3] {
    a.map(|x| k * x)
}

/// `a . b`
#[inline]
pub(crate) fn dot<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> T {
    a * x + b * y + c * z
}

/// `|a|`
#[inline]
pub(crate) fn norm<T: Scalar>(a: [T; 3]) -> T {
    dot(a, a).sqrt()
}

/// A column of a matrix given by rows.
#[inline]
pub(crate) fn column<T: Scalar>(rows: &[[T; 3]; 3], index: usize) -> [T; 3] {
    rows.map(|row| row.get(index).copied().unwrap_or(T::ZERO))
}
