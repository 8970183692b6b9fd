//! Square roots in integers, for processors whose root Rust without `std` cannot reach.
//!
//! The argument is scaled by an even power of two to `1 <= m < 4`. The steps are those of many a processor. Source:
//! Muller and others, Handbook of Floating-Point Arithmetic, second edition 2018, the chapters on division and square
//! root.
//! 1. `y = 1 / sqrt(m)` from a table of 64 chords, off by at most 5e-5 of it.
//! 2. For `f64`, Newton's step on `1 / y^2 = m`: `y (3 - m y^2) / 2` is off by at most 3e-9.
//! 3. Newton's step on the root, without a division: `r + (m - r^2) y / 2` with `r = m y`.
//! 4. Its last bit: of two neighbors `c` and `c + 1`, the exact remainder `m - c^2` tells the nearer one.
//!
//! Step 3 is off by less than 0.2 units of the last place for either type. So rounded down, the root is the nearest
//! integer or the one below. No root lies halfway between two floats: its square would have twice their bits. Every
//! product is one of two 32-bit numbers, which a Cortex-M3 and its successors multiply in one instruction.

/// For each 32nd of an octave, of [2, 4) and then of [1, 2): `1 / sqrt(m)` at its beginning, 2^-32 a unit.
/// The 13 low bits hold its fall to the end, 2^-19 a unit.
const CHORDS: [u32; 64] = {
    let mut chords = [0; 64];
    let mut i = 0;
    while i < 64 {
        let two = if i < 32 { 1 } else { 2 };
        let n = 32 + (i as u128 & 31);
        let first = ((two << 68) / n).isqrt();
        let middle = ((two << 69) / (2 * n + 1)).isqrt();
        let last = ((two << 68) / (n + 1)).isqrt();
        // The chord lies above the curve, by most in the middle; half of that is the least error.
        let start = first - ((first + last) / 2 - middle) / 2;
        let fall = (first - last + (1 << 12)) >> 13;
        let upper = (start - fall + (1 << 12)) >> 13;
        chords[i] = ((upper << 13) + fall) as u32;
        i += 1;
    }
    chords
};

/// `1 / sqrt(m)`, 2^-32 a unit. `top`: the lowest bit of the exponent and 23 bits of the mantissa, whatever is above.
#[inline(always)]
fn reciprocal(top: u32) -> u32 {
    let chord = CHORDS[((top >> 18) & 63) as usize];
    chord - (((chord & 0x1fff) * (top & 0x3_ffff)) >> 5)
}

/// The upper half of a product.
#[inline(always)]
fn upper(a: u32, b: u32) -> u32 {
    ((u64::from(a) * u64::from(b)) >> 32) as u32
}

/// Correctly rounded square root of an `f64`.
#[inline(never)]
pub(in crate::math) fn double(x: f64) -> f64 {
    const LEAST: u64 = 1 << 52;
    const INFINITY: u64 = f64::INFINITY.to_bits();
    // What Newton's step falls short by, on average, with what is cut off; 2^-30 a unit.
    const SHORT: u32 = 3;

    let (mut bits, mut scale) = (x.to_bits(), 0);
    if bits.wrapping_sub(LEAST) >= INFINITY - LEAST {
        if bits == 0 || bits >= INFINITY {
            return if bits > 1 << 63 { f64::NAN } else { x };
        }
        // A subnormal times 2^54, so that its exponent is that of a normal number.
        let shift = bits.leading_zeros() - 11;
        (bits, scale) = ((bits << shift) + (u64::from(54 - shift) << 52), 27 << 52);
    }
    let top = (bits >> 29) as u32;
    // m, 2^-62 a unit, and its upper half.
    let m = ((bits << 11) | (1 << 63)) >> ((top >> 23) & 1);
    let coarse = (m >> 32) as u32;
    // 2^-31 a unit.
    let y = reciprocal(top);
    let y = upper(y, (3 << 30) + SHORT - upper(coarse, upper(y, y)));
    // 2^-29 a unit; its remainder, 2^-54 a unit, fits 31 bits.
    let root = upper(coarse, y);
    let rest = ((m >> 4) as i64 - (u64::from(root) * u64::from(root)) as i64) >> 4;
    // 2^-60 a unit, then 2^-52.
    let root = ((i64::from(root) << 31) + ((i64::from(rest as i32) * i64::from(y)) >> 26)) >> 8;
    // Modulo 2^64: it has 54 bits.
    let rest = (m << 42).wrapping_sub(root.wrapping_mul(root) as u64) as i64;
    let root = root as u64 + u64::from(rest > root);
    f64::from_bits((((bits + (1021 << 52)) >> 53) << 52) + root - scale)
}

/// Correctly rounded square root of an `f32`.
#[inline(never)]
pub(in crate::math) fn single(x: f32) -> f32 {
    const LEAST: u32 = 1 << 23;
    const INFINITY: u32 = f32::INFINITY.to_bits();

    let (mut bits, mut scale) = (x.to_bits(), 0);
    if bits.wrapping_sub(LEAST) >= INFINITY - LEAST {
        if bits == 0 || bits >= INFINITY {
            return if bits > 1 << 31 { f32::NAN } else { x };
        }
        // A subnormal times 2^24, so that its exponent is that of a normal number.
        let shift = bits.leading_zeros() - 8;
        (bits, scale) = ((bits << shift) + ((24 - shift) << 23), 12 << 23);
    }
    let y = reciprocal(bits);
    // m and its root, 2^-30 a unit; the remainder, 2^-28 a unit.
    let m = ((bits << 8) | (1 << 31)) >> ((bits >> 23) & 1);
    let root = upper(m, y);
    let rest = (m >> 2) as i32 - upper(root, root) as i32;
    let correction = ((i64::from(rest) * i64::from(y >> 1)) >> 32) as i32;
    // 2^-23 a unit.
    let root = (root as i32 + 4 * correction) >> 7;
    // Modulo 2^32: it has 25 bits.
    let rest = (m << 16).wrapping_sub(root.wrapping_mul(root) as u32) as i32;
    let root = root as u32 + u32::from(rest > root);
    f32::from_bits((((bits + (125 << 23)) >> 24) << 23) + root - scale)
}
