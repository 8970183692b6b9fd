//! Reduction by pi/2 of angles too large for Cody and Waite.
//!
//! M. Payne and R. Hanek, Radian reduction for trigonometric functions, SIGNUM Newsletter 18 (1983). Only the bits of
//! 2/pi matter whose product with the angle is neither a multiple of four nor below the precision wanted.

use super::sin_cos::Reduced;

/// 64 zero bits, then the bits of 2/pi after the binary point.
const TWO_OVER_PI: [u64; 20] = [
    0,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
];
/// pi/2 * 2^63.
const PI_2: u64 = 0xc90fdaa22168c234;

/// `magnitude`: finite, at least 2^9.
#[cold]
#[inline(never)]
pub(super) fn reduce(magnitude: f64) -> Reduced {
    let bits = magnitude.to_bits();
    let mantissa = u128::from((bits & ((1 << 52) - 1)) | (1 << 52));
    // magnitude = mantissa * 2^exponent. Bits of 2/pi down to weight 2^(2 - exponent) only add multiples of four.
    let exponent = (bits >> 52) as i32 - 1075;
    let start = (exponent - 2 + 64).max(0) as u32;
    let word = |i: u32| TWO_OVER_PI.get((start / 64 + i) as usize).copied().unwrap_or(0);
    let window = |i: u32| {
        let pair = (u128::from(word(i)) << 64) | u128::from(word(i + 1));
        u128::from((pair >> (64 - start % 64)) as u64)
    };
    // The product modulo 2^192; its two top bits are the quadrant.
    let low = mantissa * window(2);
    let middle = mantissa * window(1) + (low >> 64);
    let high = mantissa * window(0) + (middle >> 64);
    let turn = (high << 64) | u128::from(middle as u64);
    let quarters = (turn >> 126).wrapping_add((turn >> 125) & 1) as u64;
    // The fraction of a quarter turn, 2^-126 a unit, then normalized and times pi/2.
    let fraction = (turn << 2) as i128 >> 2;
    let rest = fraction.unsigned_abs();
    let shift = rest.leading_zeros().min(127);
    let angle = u128::from(((rest << shift) >> 64) as u64) * u128::from(PI_2);
    let power = |exponent: u32| f64::from_bits(u64::from(1023 - exponent) << 52);
    let top = (angle >> 75) as u64 as f64 * power(50 + shift);
    let rest = ((angle >> 22) as u64 & ((1 << 53) - 1)) as f64 * power(103 + shift);
    let hi = top + rest;
    let lo = rest - (hi - top);
    if fraction < 0 { Reduced { hi: -hi, lo: -lo, quarters } } else { Reduced { hi, lo, quarters } }
}
