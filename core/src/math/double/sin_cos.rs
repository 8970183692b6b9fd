//! Sine and cosine of an `f64`.
//!
//! Reduction by pi/2 in three parts (Cody and Waite, Software Manual for the Elementary Functions, 1980), then one
//! polynomial each on [-pi/4, pi/4]. Branch-free up to [`LIMIT`], so that independent calls interleave and arrays of
//! angles vectorize; beyond it the reduction of Payne and Hanek.

use super::far;
use super::{MAGNITUDE, ONE_COPY, SIGN};

/// Largest magnitude the three-part reduction is good for: its quotient is below 2^17.
pub(in crate::math) const LIMIT: f64 = 205_887.0;
/// 1.5 * 2^52: adding it rounds to an integer, which is then in the low bits.
pub(in crate::math) const ROUNDER: f64 = 6_755_399_441_055_744.0;
/// pi/2 in three parts. The first two have at most 35 bits, so their products with a quotient below 2^17 are exact.
#[allow(clippy::approx_constant)]
pub(in crate::math) const PI_2: [f64; 3] = [1.5707963267923333, 2.5633441515839558e-12, 1.0562999066987428e-23];
/// sin(r) = r + r^3 (S0 + S1 r^2 + ...), relative error 2^-57.9.
pub(in crate::math) const S: [f64; 6] = [
    -0.1666666666666663,
    0.008333333333321976,
    -0.00019841269829525102,
    2.7557313608989658e-06,
    -2.505074680127172e-08,
    1.5896212152140264e-10,
];
/// cos(r) = 1 - r^2 / 2 + r^4 (C0 + C1 r^2 + ...), relative error 2^-63.8.
pub(in crate::math) const C: [f64; 6] = [
    0.04166666666666659,
    -0.0013888888888872349,
    2.480158728846967e-05,
    -2.755731408153641e-07,
    2.0875688861484736e-09,
    -1.1357969733649917e-11,
];

/// A magnitude less a multiple of pi/2.
#[derive(Clone, Copy)]
pub(in crate::math) struct Reduced {
    /// Remainder, in [-pi/4, pi/4] up to rounding.
    pub(in crate::math) hi: f64,
    /// Low part of the remainder, beyond the digits of `hi`.
    pub(super) lo: f64,
    /// The multiple of pi/2; only the two lowest bits count.
    pub(in crate::math) quarters: u64,
}

impl Reduced {
    /// Low part of the remainder, beyond the digits of `hi`.
    pub(in crate::math) fn lo(&self) -> f64 {
        self.lo
    }
}

/// Sine and cosine, at most 1.1 ulp off; not a number for one that is not finite.
#[inline]
pub(in crate::math) fn sin_cos(x: f64) -> (f64, f64) {
    if !ONE_COPY && f64::from_bits(x.to_bits() & MAGNITUDE) <= LIMIT { near(x) } else { distant(x) }
}

/// Sines and cosines of several angles, the same bits as [`sin_cos`] of each: one range check for all.
#[inline]
pub(in crate::math) fn sin_cos_array<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    // One sum bounds every magnitude, and is not a number if one of them is not.
    let mut sum = 0.0;
    for angle in &angles {
        sum += f64::from_bits(angle.to_bits() & MAGNITUDE);
    }
    if !ONE_COPY && sum <= LIMIT { near_array(angles) } else { distant_array(angles) }
}

/// Sines and cosines of angles within [`LIMIT`]. Their results stay in registers because the others are made elsewhere.
#[inline(always)]
fn near_array<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let mut results = ([0.0; N], [0.0; N]);
    let (angles, sines, cosines) = (angles.as_slice(), results.0.as_mut_slice(), results.1.as_mut_slice());
    // In blocks whose loops the compiler turns into vector code; it leaves loops of other lengths alone.
    let (angles, sines, cosines) = near_blocks::<8>(angles, sines, cosines);
    let (angles, sines, cosines) = near_blocks::<6>(angles, sines, cosines);
    let (angles, sines, cosines) = near_blocks::<4>(angles, sines, cosines);
    near_blocks::<1>(angles, sines, cosines);
    results
}

/// Sines and cosines of angles of which one may be far off or not a number.
#[cold]
#[inline(never)]
fn distant_array<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let mut results = ([0.0; N], [0.0; N]);
    for ((angle, sine), cosine) in angles.iter().zip(&mut results.0).zip(&mut results.1) {
        (*sine, *cosine) = distant(*angle);
    }
    results
}

/// As many blocks of `L` angles as there are; returns what is left. The slices have the same length.
#[inline(always)]
fn near_blocks<'a, const L: usize>(
    angles: &'a [f64],
    sines: &'a mut [f64],
    cosines: &'a mut [f64],
) -> (&'a [f64], &'a mut [f64], &'a mut [f64]) {
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

/// The magnitude of a finite `x` less the nearest multiple of pi/2 (of the real number, not of its nearest double).
#[inline]
pub(in crate::math) fn reduce(x: f64) -> Reduced {
    let magnitude = f64::from_bits(x.to_bits() & MAGNITUDE);
    if magnitude <= LIMIT { reduce_near(magnitude) } else { far::reduce(magnitude) }
}

#[inline(always)]
fn near(x: f64) -> (f64, f64) {
    let bits = x.to_bits();
    evaluate(reduce_near(f64::from_bits(bits & MAGNITUDE)), bits)
}

/// Sine and cosine of any angle, whatever its magnitude.
#[cold]
#[inline(never)]
fn distant(x: f64) -> (f64, f64) {
    let bits = x.to_bits();
    if !x.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    evaluate(reduce(x), bits)
}

#[inline(always)]
fn reduce_near(magnitude: f64) -> Reduced {
    let rounded = magnitude * core::f64::consts::FRAC_2_PI + ROUNDER;
    let n = rounded - ROUNDER;
    // Exact: the product has at most 52 bits and cancels against the magnitude.
    let first = magnitude - n * PI_2[0];
    let second = n * PI_2[1];
    let hi = first - second;
    // The part in brackets is exactly what the line above rounded off.
    let lo = ((first - hi) - second) - n * PI_2[2];
    Reduced { hi, lo, quarters: rounded.to_bits() }
}

/// `bits`: of the angle, for its sign.
#[inline(always)]
fn evaluate(angle: Reduced, bits: u64) -> (f64, f64) {
    let Reduced { hi, lo, quarters } = angle;
    let z = hi * hi;
    let z2 = z * z;
    let sine_tail = (S[0] + z * S[1]) + z2 * ((S[2] + z * S[3]) + z2 * (S[4] + z * S[5]));
    let cosine_tail = (C[0] + z * C[1]) + z2 * ((C[2] + z * C[3]) + z2 * (C[4] + z * C[5]));
    let sine = (hi + (lo + (hi * z) * sine_tail)).to_bits();
    let cosine = (1.0 + ((z2 * cosine_tail - hi * lo) - 0.5 * z)).to_bits();
    // Odd quadrants swap the two; a select on floats would be a branch.
    let swap = (sine ^ cosine) & 0u64.wrapping_sub(quarters & 1);
    let sine_sign = ((quarters << 62) ^ bits) & SIGN;
    let cosine_sign = ((quarters ^ (quarters << 1)) << 62) & SIGN;
    (f64::from_bits(sine ^ swap ^ sine_sign), f64::from_bits(cosine ^ swap ^ cosine_sign))
}
