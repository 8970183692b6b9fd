//! Sine and cosine of an `f32`: the method of the `f64` kernel with constants for 24 bits.

use super::far;
use super::{MAGNITUDE, SIGN};

/// Largest magnitude the three-part reduction is good for: its quotient is at most 2^7.
const LIMIT: f32 = 201.0;
/// 1.5 * 2^23: adding it rounds to an integer, which is then in the low bits.
const ROUNDER: f32 = 12_582_912.0;
/// pi/2 in three parts. The first two have at most 17 bits, so their products with a quotient up to 2^7 are exact.
#[allow(clippy::approx_constant)]
const PI_2: [f32; 3] = [1.5707855, 1.0804273e-05, 6.0771006e-11];
/// sin(r) = r - r^3 (S0 + S1 r^2 + ...), relative error 2^-28.0.
const S: [f32; 3] = [0.16666655, -0.008332192, 0.00019518791];
/// cos(r) = 1 - r^2 / 2 + r^4 (C0 + C1 r^2 + ...), relative error 2^-33.0.
const C: [f32; 3] = [0.041666646, -0.0013887311, 2.4432567e-05];

/// An angle less a multiple of pi/2.
#[derive(Clone, Copy)]
pub(in crate::math) struct Reduced {
    /// Remainder, in [-pi/4, pi/4] up to rounding.
    pub(in crate::math) hi: f32,
    /// Excess of `hi` over the remainder.
    pub(in crate::math) over: f32,
    /// The multiple of pi/2; only the two lowest bits count.
    pub(in crate::math) quarters: u32,
}

impl Reduced {
    /// Low part of the remainder, beyond the digits of `hi`.
    pub(in crate::math) fn lo(&self) -> f32 {
        -self.over
    }
}

/// Sine and cosine, at most 1.04 ulp off; not a number for one that is not finite.
#[inline]
pub(in crate::math) fn sin_cos(x: f32) -> (f32, f32) {
    if f32::from_bits(x.to_bits() & MAGNITUDE) <= LIMIT { near(x) } else { distant(x) }
}

/// Sines and cosines of several angles, the same bits as [`sin_cos`] of each: one range check for all.
#[inline]
pub(in crate::math) fn sin_cos_array<const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    // One sum bounds every magnitude, and is not a number if one of them is not.
    let mut sum = 0.0;
    for angle in &angles {
        sum += f32::from_bits(angle.to_bits() & MAGNITUDE);
    }
    if sum <= LIMIT { near_array(angles) } else { distant_array(angles) }
}

/// Sines and cosines of angles within [`LIMIT`]. Their results stay in registers because the others are made elsewhere.
#[inline(always)]
fn near_array<const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    let mut results = ([0.0; N], [0.0; N]);
    let (angles, sines, cosines) = (angles.as_slice(), results.0.as_mut_slice(), results.1.as_mut_slice());
    // In blocks whose loops the compiler turns into vector code; it leaves loops of other lengths alone.
    let (angles, sines, cosines) = near_blocks::<8>(angles, sines, cosines);
    let (angles, sines, cosines) = near_blocks::<4>(angles, sines, cosines);
    near_blocks::<1>(angles, sines, cosines);
    results
}

/// Sines and cosines of angles of which one may be far off or not a number.
#[cold]
#[inline(never)]
fn distant_array<const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    let mut results = ([0.0; N], [0.0; N]);
    for ((angle, sine), cosine) in angles.iter().zip(&mut results.0).zip(&mut results.1) {
        (*sine, *cosine) = distant(*angle);
    }
    results
}

/// As many blocks of `L` angles as there are; returns what is left. The slices have the same length.
#[inline(always)]
fn near_blocks<'a, const L: usize>(
    angles: &'a [f32],
    sines: &'a mut [f32],
    cosines: &'a mut [f32],
) -> (&'a [f32], &'a mut [f32], &'a mut [f32]) {
    let (angles, angles_left) = angles.as_chunks::<L>();
    let (sines, sines_left) = sines.as_chunks_mut::<L>();
    let (cosines, cosines_left) = cosines.as_chunks_mut::<L>();
    for ((angles, sines), cosines) in angles.iter().zip(sines).zip(cosines) {
        for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
            (*sine, *cosine) = near(*angle);
        }
    }
    (angles_left, sines_left, cosines_left)
}

/// The magnitude of a finite `x` less the nearest multiple of pi/2 (of the real number, not of its nearest float).
#[inline]
pub(in crate::math) fn reduce(x: f32) -> Reduced {
    let magnitude = f32::from_bits(x.to_bits() & MAGNITUDE);
    if magnitude <= LIMIT { reduce_near(magnitude) } else { far::reduce(magnitude) }
}

#[inline(always)]
fn near(x: f32) -> (f32, f32) {
    evaluate(reduce_near(x))
}

/// Sine and cosine of any angle, whatever its magnitude.
#[cold]
#[inline(never)]
fn distant(x: f32) -> (f32, f32) {
    if !x.is_finite() {
        return (f32::NAN, f32::NAN);
    }
    let (sine, cosine) = evaluate(reduce(x));
    (f32::from_bits(sine.to_bits() ^ (x.to_bits() & SIGN)), cosine)
}

/// Of `-x` everything is the negative, in every bit: rounding is symmetric.
#[inline(always)]
fn reduce_near(x: f32) -> Reduced {
    let rounded = x * core::f32::consts::FRAC_2_PI + ROUNDER;
    let n = rounded - ROUNDER;
    // Exact: the product has at most 24 bits and cancels against the angle.
    let first = x - n * PI_2[0];
    let second = n * PI_2[1];
    let hi = first - second;
    // The part in brackets is exactly what the line above rounded off.
    let over = n * PI_2[2] - ((first - hi) - second);
    Reduced { hi, over, quarters: rounded.to_bits() }
}

#[inline(always)]
fn evaluate(angle: Reduced) -> (f32, f32) {
    let Reduced { hi, over, quarters } = angle;
    let z = hi * hi;
    let z2 = z * z;
    let sine_tail = (S[0] + z * S[1]) + z2 * S[2];
    let cosine_tail = (C[0] + z * C[1]) + z2 * C[2];
    // A difference of zeros keeps the sign of the first, so that of an angle -0.
    let sine = (hi - (over + (hi * z) * sine_tail)).to_bits();
    let cosine = (1.0 + ((z2 * cosine_tail + hi * over) - 0.5 * z)).to_bits();
    // Odd quadrants swap the two; a select on floats would be a branch.
    let odd = ((quarters << 31).cast_signed() >> 31).cast_unsigned();
    let swap = (sine ^ cosine) & odd;
    let sine_sign = (quarters << 30) & SIGN;
    let cosine_sign = sine_sign ^ (quarters << 31);
    (f32::from_bits(sine ^ swap ^ sine_sign), f32::from_bits(cosine ^ swap ^ cosine_sign))
}
