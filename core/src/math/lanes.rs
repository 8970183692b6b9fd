//! The functions of [`math`](super) for numbers of several poses at once: the same operations in the same order on the
//! same polynomials, so that every lane has the bits of the scalar function.
//!
//! They stand here a second time because a scalar function chooses by branches, or by masks of integers, what lanes
//! choose by selecting. Where the scalar function takes a path that is not for ordinary numbers, the lane is in doubt,
//! and its number is worked out by the scalar function.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI, TAU};

use super::double::angle::{F, RATIO};
use super::double::atan2::{A, BASE, LEAST, MOST, TAN_PI_8};
use super::double::sin_cos::{C, LIMIT, PI_2, ROUNDER, S};
use super::wrap::NEAR;
use crate::lanes::Lanes;

/// [`sin_cos`](super::sin_cos) in rad, and where the angle is too large for it: in doubt.
#[inline(always)]
pub fn sin_cos<L: Lanes>(angle: L) -> ((L, L), L::Mask) {
    let of = |value: f64| angle.of(value);
    let magnitude = angle.abs();
    let rounded = magnitude * of(FRAC_2_PI) + of(ROUNDER);
    let n = rounded - of(ROUNDER);
    let first = magnitude - n * of(PI_2[0]);
    let second = n * of(PI_2[1]);
    let hi = first - second;
    let lo = ((first - hi) - second) - n * of(PI_2[2]);
    let z = hi * hi;
    let z2 = z * z;
    let sine_tail = (of(S[0]) + z * of(S[1])) + z2 * ((of(S[2]) + z * of(S[3])) + z2 * (of(S[4]) + z * of(S[5])));
    let cosine_tail = (of(C[0]) + z * of(C[1])) + z2 * ((of(C[2]) + z * of(C[3])) + z2 * (of(C[4]) + z * of(C[5])));
    let sine = hi + (lo + (hi * z) * sine_tail);
    let cosine = of(1.0) + ((z2 * cosine_tail - hi * lo) - of(0.5) * z);
    (L::quarters(rounded, sine, cosine, angle), L::not(magnitude.at_most(of(LIMIT))))
}

/// Sines and cosines of several angles in rad, and where one of them is too large.
#[inline(always)]
pub fn sin_cos_array<L: Lanes, const N: usize>(set: L::Set, angles: [L; N]) -> (([L; N], [L; N]), L::Mask) {
    let (mut results, mut doubt) = ((angles, angles), L::mask(set, false));
    // One by one: a loop would keep the arrays in memory, where they are copied.
    for_one(&angles, 0, &mut results, &mut doubt);
    for_one(&angles, 1, &mut results, &mut doubt);
    for_one(&angles, 2, &mut results, &mut doubt);
    for_one(&angles, 3, &mut results, &mut doubt);
    for_one(&angles, 4, &mut results, &mut doubt);
    for_one(&angles, 5, &mut results, &mut doubt);
    for_one(&angles, 6, &mut results, &mut doubt);
    for_one(&angles, 7, &mut results, &mut doubt);
    for index in 8..N {
        for_one(&angles, index, &mut results, &mut doubt);
    }
    (results, doubt)
}

/// Sine and cosine of one of the angles, if it is there.
#[inline(always)]
fn for_one<L: Lanes, const N: usize>(
    angles: &[L; N],
    index: usize,
    (sines, cosines): &mut ([L; N], [L; N]),
    doubt: &mut L::Mask,
) {
    if let (Some(angle), Some(sine), Some(cosine)) = (angles.get(index), sines.get_mut(index), cosines.get_mut(index)) {
        let far;
        ((*sine, *cosine), far) = sin_cos(*angle);
        *doubt = L::either(*doubt, far);
    }
}

/// [`sqrt`](super::sqrt).
#[inline(always)]
pub fn sqrt<L: Lanes>(x: L) -> L {
    x.sqrt()
}

/// [`angle`](super::angle) of a unit vector, rad.
#[inline(always)]
pub fn angle<L: Lanes>(sin: L, cos: L) -> L {
    let of = |value: f64| sin.of(value);
    let (sin_size, cos_size) = (sin.abs(), cos.abs());
    let steep = cos_size.less(sin_size);
    let flat = sin_size.less(cos_size);
    let (less, more) = (sin_size.where_or(flat, cos_size), cos_size.where_or(flat, sin_size));
    let less = less.copysign(cos);
    let less = (-less).where_or(steep, less);
    let base = of(FRAC_PI_2).where_or(steep, of(FRAC_PI_2) - of(FRAC_PI_2).copysign(cos));
    let u = of(1.0) - more;
    let u2 = u * u;
    let u4 = u2 * u2;
    let low = (of(F[0]) + u * of(F[1])) + u2 * (of(F[2]) + u * of(F[3]));
    let middle = (of(F[4]) + u * of(F[5])) + u2 * (of(F[6]) + u * of(F[7]));
    let high = (of(F[8]) + u * of(F[9])) + u2 * of(F[10]);
    let rise = less * u;
    let tail = (base * of(RATIO) + rise * low) + (rise * u4) * (middle + u4 * high);
    let angle = (base + less) + tail;
    angle.turned_by(sin + of(0.0))
}

/// [`atan2`](super::atan2) in rad, and where a coordinate is extreme, zero beside another one or no number: in doubt.
#[inline(always)]
pub fn atan2<L: Lanes>(y: L, x: L) -> (L, L::Mask) {
    let of = |value: f64| x.of(value);
    let (y_size, x_size) = (y.abs(), x.abs());
    let steep = x_size.less(y_size);
    let (less, more) = (x_size.where_or(steep, y_size), y_size.where_or(steep, x_size));
    let least = of(f64::from_bits(LEAST));
    let inside = L::both(
        L::either(least.at_most(less), less.at_most(of(0.0))),
        L::both(least.at_most(more), more.at_most(of(f64::from_bits(MOST)))),
    );
    let backward = of(1.0).copysign(x).less(of(0.0));
    let wide = (of(TAN_PI_8) * more - less).less(of(0.0));

    let less_shifted = less.where_or(wide, of(0.0));
    let more_shifted = more.where_or(wide, of(0.0));
    let difference = (less - more_shifted).turned_by(x);
    let numerator = (-difference).where_or(steep, difference);
    let denominator = more + less_shifted;
    let reciprocal = of(1.0) / denominator;
    let quotient = numerator * reciprocal;

    let denominator_hi = denominator.upper();
    let denominator_lo = (more - denominator_hi) + less_shifted;
    let quotient_hi = quotient.upper();
    let remainder = (numerator - quotient_hi * denominator_hi) - quotient_hi * denominator_lo;
    let quotient_lo = remainder * reciprocal;

    let z = quotient * quotient;
    let z2 = z * z;
    let z4 = z2 * z2;
    let low = (of(A[0]) + z * of(A[1])) + z2 * (of(A[2]) + z * of(A[3]));
    let middle = (of(A[4]) + z * of(A[5])) + z2 * (of(A[6]) + z * of(A[7]));
    let high = (of(A[8]) + z * of(A[9])) + z2 * of(A[10]);
    let tail = (quotient * z) * (low + z4 * (middle + z4 * high));

    // The table by octant, of which each number stands at two places at least.
    let by_octant = |[flat, wide_ahead, upright, backwards, wide_behind]: [f64; 5]| {
        let wide_base = of(wide_behind).where_or(backward, of(wide_ahead));
        let narrow_base = of(upright).where_or(steep, of(backwards).where_or(backward, of(flat)));
        wide_base.where_or(wide, narrow_base)
    };
    let (base, base_lo) = (
        by_octant([BASE[0].0, BASE[1].0, BASE[2].0, BASE[4].0, BASE[5].0]),
        by_octant([BASE[0].1, BASE[1].1, BASE[2].1, BASE[4].1, BASE[5].1]),
    );
    let angle = (base + quotient_hi) + (base_lo + (quotient_lo + tail));
    (angle.turned_by(y), L::not(inside))
}

/// [`wrap`](super::wrap()) in rad, and where the angle is more than three half turns or no number: in doubt.
#[inline(always)]
pub fn wrap<L: Lanes>(angle: L) -> (L, L::Mask) {
    let of = |value: f64| angle.of(value);
    let above = of(TAU).where_or(of(PI).less(angle), of(0.0));
    let below = of(TAU).where_or(angle.at_most(of(-PI)), of(0.0));
    (angle - (above - below), L::not(angle.abs().at_most(of(NEAR))))
}
