//! Angle of a unit vector, `f32`: the method of the `f64` kernel with constants for 24 bits. Magnitudes are compared as
//! integers, which small processors do in fewer instructions, and vector units as well.

use super::{MAGNITUDE, SIGN};
use core::f32::consts::{FRAC_PI_2, PI};

/// Difference of pi/2 from the nearest float, divided by that float.
const RATIO: f32 = -2.7827534e-08;
/// f(1 - u) = 1 + u (F0 + F1 u + ...) for 0 <= u <= 1 - sqrt(1/2), relative error 2^-28.2.
const F: [f32; 5] = [0.33333376, 0.13331243, 0.05746544, 0.02327359, 0.017612966];

/// Angle of the unit vector (`cos`, `sin`) in [-pi, pi], at most 2 ulp off if both are correctly rounded.
#[inline(always)]
pub(in crate::math) fn angle(sin: f32, cos: f32) -> f32 {
    let (sin_size, cos_size) = (sin.to_bits() & MAGNITUDE, cos.to_bits() & MAGNITUDE);
    // The order of the bits is that of the magnitudes, with what is not a number above all.
    let (less, more) = (sin_size.min(cos_size), sin_size.max(cos_size));
    let side = cos.to_bits() & SIGN;
    let steep = sin_size > cos_size;
    // Axis and vector are mirrored to the upper half plane. The turn from the axis to the vector is positive from the x
    // axis on the right and from the y axis on the left.
    let less = f32::from_bits(less ^ side ^ if steep { SIGN } else { 0 });
    // 0, pi/2 or pi.
    let along = PI.to_bits() & (side.cast_signed() >> 31).cast_unsigned();
    let base = f32::from_bits(if steep { FRAC_PI_2.to_bits() } else { along });

    let u = 1.0 - f32::from_bits(more);
    let u2 = u * u;
    // Multiplied out for fewer operations one after the other.
    let rise = less * u;
    let tail = (base * RATIO + rise * (F[0] + u * F[1])) + (rise * u2) * ((F[2] + u * F[3]) + u2 * F[4]);
    let angle = (base + less) + tail;
    // The sum makes -0 positive.
    f32::from_bits(angle.to_bits() ^ ((sin + 0.0).to_bits() & SIGN))
}

/// Angles of several unit vectors, the same bits as [`angle`] of each.
#[inline(always)]
pub(in crate::math) fn angle_array<const N: usize>(sines: [f32; N], cosines: [f32; N]) -> [f32; N] {
    let mut angles = [0.0; N];
    // In blocks whose loops the compiler turns into vector code; it leaves loops of other lengths alone.
    let (sines, cosines, left) = blocks::<8>(&sines, &cosines, &mut angles);
    let (sines, cosines, left) = blocks::<4>(sines, cosines, left);
    let (sines, cosines, left) = blocks::<2>(sines, cosines, left);
    blocks::<1>(sines, cosines, left);
    angles
}

/// As many blocks of `L` vectors as there are; returns what is left. The slices have the same length.
#[inline(always)]
fn blocks<'a, const L: usize>(
    sines: &'a [f32],
    cosines: &'a [f32],
    angles: &'a mut [f32],
) -> (&'a [f32], &'a [f32], &'a mut [f32]) {
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
