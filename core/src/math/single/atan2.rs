//! Angle of a vector, `f32`: the method of the `f64` kernel with constants for 24 bits.

use super::{MAGNITUDE, SIGN};

const TAN_PI_8: f32 = 0.41421356;
/// 2^-50 and 2^50: between them nothing below overflows or loses bits.
const LEAST: u32 = 0x2680_0000;
const MOST: u32 = 0x5880_0000;
/// Keeps the upper 12 of 24 bits.
const UPPER: u32 = !((1 << 12) - 1);
/// atan(q) = q + q^3 (A0 + A1 q^2 + ...) for |q| <= tan(pi/8), relative error 2^-30.3.
const A: [f32; 5] = [-0.33333314, 0.1999839, -0.14242241, 0.10585514, -0.06059475];
/// Where the angle is counted from, by octant: bit 0 for t above tan(pi/8), bit 1 for y the greater, bit 2 for x < 0.
/// Multiples of pi/4 rounded to 2^-12, and what they lack.
#[allow(clippy::approx_constant)]
const BASE: [(f32, f32); 8] = {
    const PI_4: (f32, f32) = (0.7854004, -2.2272275e-06);
    const PI_2: (f32, f32) = (1.5708008, -4.454455e-06);
    const PI_4_3: (f32, f32) = (2.3562012, -6.681683e-06);
    const PI: (f32, f32) = (3.1416016, -8.90891e-06);
    [(0.0, 0.0), PI_4, PI_2, PI_4, PI, PI_4_3, PI_2, PI_4_3]
};

/// Angle of (x, y) in [-pi, pi], at most 1.5 ulp off; signed zeros and infinities as IEEE 754 says.
#[inline]
pub(in crate::math) fn atan2(y: f32, x: f32) -> f32 {
    let (y_bits, x_bits) = (y.to_bits() & MAGNITUDE, x.to_bits() & MAGNITUDE);
    let (less, more) = (y_bits.min(x_bits), y_bits.max(x_bits));
    let inside = less.wrapping_sub(LEAST) <= MOST - LEAST || less == 0;
    if inside & (more.wrapping_sub(LEAST) <= MOST - LEAST) { octants(y, x) } else { unusual(y, x) }
}

/// The greater coordinate is within 2^-50 and 2^50, so is the lesser or it is zero.
#[inline(always)]
fn octants(y: f32, x: f32) -> f32 {
    let (y_bits, x_bits) = (y.to_bits() & MAGNITUDE, x.to_bits() & MAGNITUDE);
    let steep = u32::from(y_bits > x_bits);
    let backward = x.to_bits() >> 31;
    let less = f32::from_bits(y_bits.min(x_bits));
    let more = f32::from_bits(y_bits.max(x_bits));
    // By its sign bit: a comparison would come back as a branch.
    let excess = (TAN_PI_8 * more - less).to_bits();
    let wide = excess >> 31;

    let shift = (excess as i32 >> 31) as u32;
    let less_shifted = f32::from_bits(less.to_bits() & shift);
    let more_shifted = f32::from_bits(more.to_bits() & shift);
    let falling = (steep ^ backward) << 31;
    let numerator = f32::from_bits((less - more_shifted).to_bits() ^ falling);
    let denominator = more + less_shifted;
    let reciprocal = 1.0 / denominator;
    let quotient = numerator * reciprocal;

    // quotient_hi + quotient_lo = numerator / (denominator_hi + denominator_lo): the first product is exact.
    let denominator_hi = f32::from_bits(denominator.to_bits() & UPPER);
    let denominator_lo = (more - denominator_hi) + less_shifted;
    let quotient_hi = f32::from_bits(quotient.to_bits() & UPPER);
    let remainder = (numerator - quotient_hi * denominator_hi) - quotient_hi * denominator_lo;
    let quotient_lo = remainder * reciprocal;

    let z = quotient * quotient;
    let z2 = z * z;
    let tail = (quotient * z) * ((A[0] + z * A[1]) + z2 * ((A[2] + z * A[3]) + z2 * A[4]));

    let (base, base_lo) = BASE[((wide | steep << 1 | backward << 2) & 7) as usize];
    let angle = (base + quotient_hi) + (base_lo + (quotient_lo + tail));
    f32::from_bits(angle.to_bits() ^ (y.to_bits() & SIGN))
}

/// Zeros, infinities, not a number, and magnitudes that have to be scaled first.
#[cold]
#[inline(never)]
fn unusual(y: f32, x: f32) -> f32 {
    const DOWN: f32 = f32::from_bits((127 - 70) << 23);
    const UP: f32 = f32::from_bits((127 + 100) << 23);
    const NEGLIGIBLE: f32 = f32::from_bits((127 - 30) << 23);

    if y.is_nan() || x.is_nan() {
        return f32::NAN;
    }
    let more = y.abs().max(x.abs());
    if more == 0.0 {
        return octants(y, 1.0f32.copysign(x));
    }
    if more == f32::INFINITY {
        let side = |v: f32| if v.is_infinite() { 1.0f32.copysign(v) } else { 0.0f32.copysign(v) };
        return octants(side(y), side(x));
    }
    let scale = if more < 1.0 { UP } else { DOWN };
    let scaled =
        if more < f32::from_bits(LEAST) || more > f32::from_bits(MOST) { (y * scale, x * scale) } else { (y, x) };
    let (less, more) = (scaled.0.abs().min(scaled.1.abs()), scaled.0.abs().max(scaled.1.abs()));
    if less > NEGLIGIBLE * more {
        octants(scaled.0, scaled.1)
    } else if x > 0.0 && y.abs() < x {
        y / x
    } else if y.abs() < x.abs() {
        octants(0.0f32.copysign(y), -1.0)
    } else {
        octants(1.0f32.copysign(y), 0.0)
    }
}
