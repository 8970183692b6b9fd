//! Angle of a unit vector, `f64`.
//!
//! With l the lesser and m the greater magnitude of sine and cosine, the angle from the nearest axis is l f(m). Here
//! f(m) = acos(m) / sqrt(1 - m^2) is smooth on [sqrt(1/2), 1]: a polynomial in 1 - m, a difference without rounding. So
//! the second coordinate takes the place of the division, square root or table an inverse function needs. Every choice
//! is a comparison of floats that masks floats: no branch, and arrays vectorize.

use super::SIGN;
use core::f64::consts::FRAC_PI_2;

/// Difference of pi/2 from the nearest double, divided by that double.
pub(in crate::math) const RATIO: f64 = 3.8981718325193755e-17;
/// f(1 - u) = 1 + u (F0 + F1 u + ...) for 0 <= u <= 1 - sqrt(1/2), relative error 2^-56.7.
pub(in crate::math) const F: [f64; 11] = [
    0.33333333333333803,
    0.1333333333324169,
    0.05714285720533929,
    0.025396823272502905,
    0.011544053428100219,
    0.005327487866500805,
    0.002490567543527707,
    0.0011479731166437318,
    0.0006303558845262148,
    0.00010288254759448374,
    0.00030716509450586877,
];

/// Angle of the unit vector (`cos`, `sin`) in [-pi, pi], at most 2 ulp off if both are correctly rounded.
#[inline(always)]
pub(in crate::math) fn angle(sin: f64, cos: f64) -> f64 {
    let (sin_size, cos_size) = (sin.abs(), cos.abs());
    // In this form one instruction each; and what is not a number gets into one of the two.
    let less = if sin_size < cos_size { sin_size } else { cos_size };
    let more = if sin_size < cos_size { cos_size } else { sin_size };
    // The sign of a difference: of a comparison the compiler would make a branch.
    let steep = ((cos_size - sin_size).to_bits().cast_signed() >> 63).cast_unsigned();
    let side = cos.to_bits() & SIGN;
    // Axis and vector are mirrored to the upper half plane. The turn from the axis to the vector is positive from the x
    // axis on the right and from the y axis on the left.
    let less = f64::from_bits(less.to_bits() ^ side ^ (steep & SIGN));
    // 0, pi/2 or pi.
    let base = FRAC_PI_2 - f64::from_bits((FRAC_PI_2.to_bits() | side) & !steep);

    let u = 1.0 - more;
    let u2 = u * u;
    let u4 = u2 * u2;
    let low = (F[0] + u * F[1]) + u2 * (F[2] + u * F[3]);
    let middle = (F[4] + u * F[5]) + u2 * (F[6] + u * F[7]);
    let high = (F[8] + u * F[9]) + u2 * F[10];
    // Multiplied out for fewer operations one after the other.
    let rise = less * u;
    let tail = (base * RATIO + rise * low) + (rise * u4) * (middle + u4 * high);
    let angle = (base + less) + tail;
    // The sum makes -0 positive.
    f64::from_bits(angle.to_bits() ^ ((sin + 0.0).to_bits() & SIGN))
}

/// Angles of several unit vectors, the same bits as [`angle`] of each.
#[inline(always)]
pub(in crate::math) fn angle_array<const N: usize>(sines: [f64; N], cosines: [f64; N]) -> [f64; N] {
    let mut angles = [0.0; N];
    // In blocks whose loops the compiler turns into vector code; it leaves loops of other lengths alone.
    let (sines, cosines, left) = blocks::<8>(&sines, &cosines, &mut angles);
    let (sines, cosines, left) = blocks::<6>(sines, cosines, left);
    let (sines, cosines, left) = blocks::<4>(sines, cosines, left);
    let (sines, cosines, left) = blocks::<2>(sines, cosines, left);
    blocks::<1>(sines, cosines, left);
    angles
}

/// As many blocks of `L` vectors as there are; returns what is left. The slices have the same length.
#[inline(always)]
fn blocks<'a, const L: usize>(
    sines: &'a [f64],
    cosines: &'a [f64],
    angles: &'a mut [f64],
) -> (&'a [f64], &'a [f64], &'a mut [f64]) {
    let (sines, sines_left) = sines.as_chunks::<L>();
    let (cosines, cosines_left) = cosines.as_chunks::<L>();
    let (angles, angles_left) = angles.as_chunks_mut::<L>();
    for ((sines, cosines), angles) in sines.iter().zip(cosines).zip(angles) {
        for ((sin, cos), result) in sines.iter().zip(cosines).zip(angles) {
            *result = angle(*sin, *cos);
        }
    }
    (sines_left, cosines_left, angles_left)
}
