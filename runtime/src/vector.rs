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
