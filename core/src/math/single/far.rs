//! Reduction by pi/2 of an `f32` too large for Cody and Waite, after Payne and Hanek, in integers of 32 and 64 bits.

use super::sin_cos::Reduced;

/// 32 zero bits, then the bits of 2/pi after the binary point.
const TWO_OVER_PI: [u32; 8] = [0, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab];
/// pi/2 * 2^31.
const PI_2: u32 = 0xc90fdaa2;

/// `magnitude`: finite, at least 2^6.
#[cold]
#[inline(never)]
pub(super) fn reduce(magnitude: f32) -> Reduced {
    let bits = magnitude.to_bits();
    let mantissa = u64::from((bits & ((1 << 23) - 1)) | (1 << 23));
    // magnitude = mantissa * 2^exponent. Bits of 2/pi down to weight 2^(2 - exponent) only add multiples of four.
    let exponent = (bits >> 23) as i32 - 150;
    let start = (exponent - 2 + 32).max(0) as u32;
    let word = |i: u32| TWO_OVER_PI.get((start / 32 + i) as usize).copied().unwrap_or(0);
    let window = |i: u32| {
        let pair = (u64::from(word(i)) << 32) | u64::from(word(i + 1));
        u64::from((pair >> (32 - start % 32)) as u32)
    };
    // The product modulo 2^96; its two top bits are the quadrant.
    let low = mantissa * window(2);
    let middle = mantissa * window(1) + (low >> 32);
    let high = mantissa * window(0) + (middle >> 32);
    let turn = (high << 32) | u64::from(middle as u32);
    let quarters = (turn >> 62).wrapping_add((turn >> 61) & 1) as u32;
    // The fraction of a quarter turn, 2^-62 a unit, then normalized and times pi/2.
    let fraction = (turn << 2) as i64 >> 2;
    let rest = fraction.unsigned_abs();
    let shift = rest.leading_zeros().min(63);
    let angle = u64::from(((rest << shift) >> 32) as u32) * u64::from(PI_2);
    let power = |exponent: u32| f32::from_bits((127 - exponent) << 23);
    let top = (angle >> 40) as u32 as f32 * power(21 + shift);
    let rest = ((angle >> 16) as u32 & ((1 << 24) - 1)) as f32 * power(45 + shift);
    let hi = top + rest;
    let over = (hi - top) - rest;
    if fraction < 0 { Reduced { hi: -hi, over: -over, quarters } } else { Reduced { hi, over, quarters } }
}
