//! Angle of a vector, `f64`.
//!
//! The lesser coordinate over the greater, t, is at most 1. Above tan(pi/8), atan t = pi/4 + atan((t - 1) / (t + 1)).
//! There is one division. The quotient is completed to double precision and a half from its exact remainder (as in
//! Dekker, Numerische Mathematik 18, 1971). A mask cuts the operands to half their bits. Octants are chosen without a
//! branch.

use super::{MAGNITUDE, ONE_COPY, SIGN};

pub(in crate::math) const TAN_PI_8: f64 = 0.41421356237309503;
/// 2^-500 and 2^500: between them nothing below overflows or loses bits.
pub(in crate::math) const LEAST: u64 = 0x20b0_0000_0000_0000;
pub(in crate::math) const MOST: u64 = 0x5f30_0000_0000_0000;
/// Keeps the upper 26 of 53 bits.
pub(crate) const UPPER: u64 = !((1 << 27) - 1);
/// atan(q) = q + q^3 (A0 + A1 q^2 + ...) for |q| <= tan(pi/8), relative error 2^-59.3.
pub(in crate::math) const A: [f64; 11] = [
    -0.33333333333333187,
    0.19999999999951212,
    -0.14285714279994793,
    0.1111111077466772,
    -0.09090897532787201,
    0.0769205660402164,
    -0.06663066615076015,
    0.058476388368726546,
    -0.05038260145167243,
    0.03803986862173861,
    -0.01788194309188691,
];
/// Where the angle is counted from, by octant: bit 0 for t above tan(pi/8), bit 1 for y the greater, bit 2 for x < 0.
/// Multiples of pi/4 rounded to 2^-26, and what they lack.
#[allow(clippy::approx_constant)]
pub(in crate::math) const BASE: [(f64, f64); 8] = {
    const PI_4: (f64, f64) = (0.7853981703519821, -6.954533807083558e-09);
    const PI_2: (f64, f64) = (1.570796325802803, 9.920935796805404e-10);
    const PI_4_3: (f64, f64) = (2.356194496154785, -5.962440227403018e-09);
    const PI: (f64, f64) = (3.141592651605606, 1.984187159361081e-09);
    [(0.0, 0.0), PI_4, PI_2, PI_4, PI, PI_4_3, PI_2, PI_4_3]
};

/// Angle of (x, y) in [-pi, pi], at most 1.5 ulp off; signed zeros and infinities as IEEE 754 says.
#[inline]
pub(in crate::math) fn atan2(y: f64, x: f64) -> f64 {
    if !ONE_COPY && is_usual(y, x) { octants(y, x) } else { any(y, x) }
}

/// Returns true where nothing below overflows or loses bits.
#[inline(always)]
fn is_usual(y: f64, x: f64) -> bool {
    let (y_bits, x_bits) = (y.to_bits() & MAGNITUDE, x.to_bits() & MAGNITUDE);
    let (less, more) = (y_bits.min(x_bits), y_bits.max(x_bits));
    let inside = less.wrapping_sub(LEAST) <= MOST - LEAST || less == 0;
    inside & (more.wrapping_sub(LEAST) <= MOST - LEAST)
}

/// Angle of any vector.
#[cold]
#[inline(never)]
fn any(y: f64, x: f64) -> f64 {
    match if is_usual(y, x) { Ok((y, x)) } else { unusual(y, x) } {
        Ok((y, x)) => octants(y, x),
        Err(angle) => angle,
    }
}

/// The greater coordinate is within 2^-500 and 2^500, so is the lesser or it is zero.
#[inline(always)]
fn octants(y: f64, x: f64) -> f64 {
    let (y_bits, x_bits) = (y.to_bits() & MAGNITUDE, x.to_bits() & MAGNITUDE);
    let steep = u64::from(y_bits > x_bits);
    let backward = x.to_bits() >> 63;
    let less = f64::from_bits(y_bits.min(x_bits));
    let more = f64::from_bits(y_bits.max(x_bits));
    // By its sign bit: a comparison would come back as a branch.
    let excess = (TAN_PI_8 * more - less).to_bits();
    let wide = excess >> 63;

    let shift = (excess as i64 >> 63) as u64;
    let less_shifted = f64::from_bits(less.to_bits() & shift);
    let more_shifted = f64::from_bits(more.to_bits() & shift);
    let falling = (steep ^ backward) << 63;
    let numerator = f64::from_bits((less - more_shifted).to_bits() ^ falling);
    let denominator = more + less_shifted;
    let reciprocal = 1.0 / denominator;
    let quotient = numerator * reciprocal;

    // quotient_hi + quotient_lo = numerator / (denominator_hi + denominator_lo): the first product is exact.
    let denominator_hi = f64::from_bits(denominator.to_bits() & UPPER);
    let denominator_lo = (more - denominator_hi) + less_shifted;
    let quotient_hi = f64::from_bits(quotient.to_bits() & UPPER);
    let remainder = (numerator - quotient_hi * denominator_hi) - quotient_hi * denominator_lo;
    let quotient_lo = remainder * reciprocal;

    let z = quotient * quotient;
    let z2 = z * z;
    let z4 = z2 * z2;
    let low = (A[0] + z * A[1]) + z2 * (A[2] + z * A[3]);
    let middle = (A[4] + z * A[5]) + z2 * (A[6] + z * A[7]);
    let high = (A[8] + z * A[9]) + z2 * A[10];
    let tail = (quotient * z) * (low + z4 * (middle + z4 * high));

    let (base, base_lo) = BASE[((wide | steep << 1 | backward << 2) & 7) as usize];
    let angle = (base + quotient_hi) + (base_lo + (quotient_lo + tail));
    f64::from_bits(angle.to_bits() ^ (y.to_bits() & SIGN))
}

/// Zeros, infinities, not a number, and magnitudes that have to be scaled first: a vector of the same angle for [`octants`], or
/// the angle.
fn unusual(y: f64, x: f64) -> Result<(f64, f64), f64> {
    const DOWN: f64 = f64::from_bits((1023 - 600) << 52);
    const UP: f64 = f64::from_bits((1023 + 600) << 52);
    const NEGLIGIBLE: f64 = f64::from_bits((1023 - 60) << 52);

    // Magnitudes are compared as bits, as routines compare numbers where there is no processor for them.
    const INFINITY: u64 = f64::INFINITY.to_bits();
    let (y_bits, x_bits) = (y.to_bits() & MAGNITUDE, x.to_bits() & MAGNITUDE);
    let more = y_bits.max(x_bits);
    if more > INFINITY {
        return Err(f64::NAN);
    }
    let scale = if more < 1.0f64.to_bits() { UP } else { DOWN };
    let scaled = if (LEAST..=MOST).contains(&more) { (y, x) } else { (y * scale, x * scale) };
    let [y_scaled, x_scaled] = [scaled.0, scaled.1].map(|value: f64| value.to_bits() & MAGNITUDE);
    let least = f64::from_bits(y_scaled.max(x_scaled)) * NEGLIGIBLE;
    Ok(if more == 0 {
        (y, 1.0f64.copysign(x))
    } else if more == INFINITY {
        let side = |v: f64, bits: u64| if bits == INFINITY { 1.0f64.copysign(v) } else { 0.0f64.copysign(v) };
        (side(y, y_bits), side(x, x_bits))
    } else if y_scaled.min(x_scaled) > least.to_bits() {
        scaled
    } else if y_bits < x_bits && x.to_bits() == x_bits {
        return Err(y / x);
    } else if y_bits < x_bits {
        (0.0f64.copysign(y), -1.0)
    } else {
        (1.0f64.copysign(y), 0.0)
    })
}
