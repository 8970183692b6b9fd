//! Scalar mathematics of generated kinematics: the same bits on every processor, with or without the standard library.
//!
//! Every function is generic over [`Scalar`] (`f64` or `f32`), total and without allocation. Sine, cosine and arc
//! tangent are computed here, from multiplications and additions that are never fused; the `f32` ones use no `f64`.
//!
//! Error in units of the last place, as guaranteed and as the greatest found:
//!
//! | function | `f64` | `f32` | measured on |
//! |---|---|---|---|
//! | [`sin_cos`] | 1.1 (1.03) | 1.04 (1.037) | `f64`: random, hardest cases of all exponents; `f32`: every float |
//! | [`atan2`] | 1.5 (1.35) | 1.5 (1.34) | random pairs of all magnitudes and octants |
//! | [`angle`] | 2 (1.88) | 2 (1.88) | correctly rounded sines and cosines |
//! | [`sqrt`] | 0.5 | 0.5 | correctly rounded |
//! | [`hypot`] | 1.5 | 1.5 | bound, if the squares neither overflow nor vanish |

/// True where size counts more than a call: on bare metal, where most processors compute `f64` by routines, and in a module for
/// browsers. Each equation that long ones are made of has one copy there; elsewhere it is inlined.
pub(crate) const ONE_COPY: bool = cfg!(any(target_os = "none", target_family = "wasm"));

mod double;
#[cfg(feature = "batch")]
pub mod lanes;
mod scalar;
mod single;
mod sqrt;
#[cfg(test)]
mod tests;
mod wrap;

#[cfg(feature = "batch")]
pub(crate) use double::{SIGN, atan2::UPPER};
pub use scalar::Scalar;
pub use wrap::wrap;

/// `(sin, cos)` of an angle in rad, in one go.
///
/// At most 1.1 ulp (`f64`; greatest found 1.03) or 1.04 ulp (`f32`) off for every finite angle. Huge angles and the
/// neighbors of multiples of pi/2 are included. The sign of zero is kept, and `sin_cos(-x)` is `(-sin, cos)` of `x` to
/// the bit. Both are not a number for an angle that is not finite. Fast up to 205887 rad (`f64`) or 201 rad (`f32`),
/// some tens of nanoseconds beyond.
///
/// ```
/// let (sin, cos) = denhart_core::math::sin_cos(0.5_f64);
/// assert_eq!((sin, cos), (0.479425538604203, 0.8775825618903728));
/// ```
#[inline]
pub fn sin_cos<T: Scalar>(angle: T) -> (T, T) {
    angle.sin_cos()
}

/// `(sines, cosines)` of several angles in rad: the same bits as [`sin_cos`] of each, `f64` in about half the time. One
/// range check serves all of them and the rest is free of branches and vectorizes.
///
/// ```
/// let ([s1, s2], [c1, c2]) = denhart_core::math::sin_cos_array([0.0_f64, 0.5]);
/// assert_eq!((s1, c1), (0.0, 1.0));
/// assert_eq!((s2, c2), denhart_core::math::sin_cos(0.5));
/// ```
#[inline]
pub fn sin_cos_array<T: Scalar, const N: usize>(angles: [T; N]) -> ([T; N], [T; N]) {
    T::sin_cos_array(angles)
}

/// Angle of the vector (`x`, `y`) from the x axis, in [-pi, pi] rad.
///
/// At most 1.5 ulp off (greatest found: 1.35 for `f64`, 1.34 for `f32`). Signed zeros and infinities are those of
/// IEEE 754: `atan2(0, -1)` is pi, `atan2(-0.0, -1)` is -pi, `atan2(0, 0)` is 0; not a number if one of the two is not.
#[inline]
pub fn atan2<T: Scalar>(y: T, x: T) -> T {
    y.atan2(x)
}

/// Angle in [-pi, pi] rad of a vector of unit length, from its sine and cosine, in half the time of [`atan2`].
///
/// At most 2 ulp off for a correctly rounded sine and cosine (greatest found: 1.88). In general at most 1.7 ulp, and
/// for a length of `1 + e` with |e| up to 1e-6 another `0.6 |e|` rad. If `0.75 |e|` of the angle from the nearest axis
/// is less than `0.6 |e|` rad, the smaller bound holds. On the axes as [`atan2`], save that a zero sine has no sign:
/// `angle(-0.0, -1)` is pi, `angle(-0.0, 1)` is 0. Not a number if one of the two is not. Any float or not a number,
/// and never a panic, for vectors far from unit length, zero and infinite ones included.
///
/// ```
/// let (sin, cos) = denhart_core::math::sin_cos(2.5_f64);
/// assert!((denhart_core::math::angle(sin, cos) - 2.5).abs() < 1e-15);
/// ```
#[inline]
pub fn angle<T: Scalar>(sin: T, cos: T) -> T {
    sin.angle(cos)
}

/// Angles of several vectors of unit length: the same bits as [`angle`] of each. Free of branches, so it vectorizes:
/// about half the time for a few `f64`, a quarter for four `f32`.
///
/// ```
/// let angles = denhart_core::math::angle_array([0.0_f64, 1.0], [-1.0, 0.0]);
/// assert_eq!(angles, [core::f64::consts::PI, core::f64::consts::FRAC_PI_2]);
/// ```
#[inline(always)]
pub fn angle_array<T: Scalar, const N: usize>(sines: [T; N], cosines: [T; N]) -> [T; N] {
    T::angle_array(sines, cosines)
}

/// An angle typed in degrees, in rad: `degrees / 180 * pi`, within 2.5 ulp.
///
/// Quarters and eighths of a turn have the bits of the constants in `core`: `radians(90.0)` is `FRAC_PI_2`. Not finite
/// where the argument is not.
#[inline]
#[must_use]
pub fn radians<T: Scalar>(degrees: T) -> T {
    degrees / T::from_f64(180.0) * T::PI
}

/// Square root, correctly rounded; not a number below zero.
#[inline]
pub fn sqrt<T: Scalar>(x: T) -> T {
    x.sqrt()
}

/// `sqrt(x * x + y * y)`, within 1.5 ulp. The squares are not scaled: meant for lengths of robot arms, not for
/// magnitudes whose square overflows or vanishes.
#[inline]
pub fn hypot<T: Scalar>(x: T, y: T) -> T {
    x.hypot(y)
}
