use super::angle_of_vector::error_of;
use super::double_double::{Wide, ulps_single};
use super::random::Random;
use crate::math;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Bounds that the documentation of [`math::angle`] promises. The first is in ulp, for a length of 1. The others are
/// for what the length differs from 1, in rad and as a share of the angle from the nearest axis.
const BOUND: f64 = 1.7;
const BOUND_RAD: f64 = 0.6;
const BOUND_SHARE: f64 = 0.75;

/// Unit vectors over the circle, beside its axes and diagonals, not all of them of unit length.
fn some_vector(random: &mut Random, i: u32) -> (f64, f64) {
    let offset = match i % 3 {
        0 => random.signed() * FRAC_PI_4,
        1 => random.signed() * f64::from_bits((1023 - random.bits() % 60) << 52) * FRAC_PI_4,
        // With the y axis in front, the sum of two of three terms crosses 1 here: the greatest error.
        _ => 0.19 + 0.01 * random.signed(),
    };
    let (sin, cos) = math::sin_cos((random.bits() % 8) as f64 * FRAC_PI_4 - PI + offset);
    let scale = match i % 4 {
        0 => 1.0 + 1e-6 * random.signed(),
        1 => 1.0 + 1e-13 * random.signed(),
        _ => 1.0,
    };
    (sin * scale, cos * scale)
}

/// Permitted error for the length `1 + excess`, rad.
fn allowance(sin: f64, cos: f64, excess: f64, ulp: f64) -> f64 {
    let turn = sin.abs().min(cos.abs()) * FRAC_PI_4 * core::f64::consts::SQRT_2;
    BOUND * ulp + excess.abs() * BOUND_RAD.min(BOUND_SHARE * turn)
}

#[test]
fn double_vectors() {
    let mut random = Random(41);
    for i in 0..400_000 {
        let (sin, cos) = some_vector(&mut random, i);
        let angle = math::angle(sin, cos);
        let (s, c) = (Wide::from(sin), Wide::from(cos));
        let excess = (s * s + c * c - Wide::from(1.0)).hi / 2.0;
        let ulp = f64::from_bits(angle.abs().to_bits() + 1) - angle.abs();
        let error = error_of(angle, sin, cos) * ulp;
        assert!(error <= allowance(sin, cos, excess, ulp), "{sin:e} {cos:e}: {error:e}");
        assert!(angle.abs() <= PI);
        // An ulp of the vector moves the whole by less than the bound for what `math::sin_cos` gives.
        assert!(i % 4 < 2 || error <= 2.2 * ulp, "{sin:e} {cos:e}: {error:e}");
        assert_eq!(math::angle(-sin, cos), -angle);
    }
}

#[test]
fn single_vectors() {
    let mut random = Random(42);
    for i in 0..600_000 {
        let (sin, cos) = some_vector(&mut random, i);
        let (sin, cos) = (sin as f32, cos as f32);
        let angle = math::angle(sin, cos);
        assert!(angle.abs() <= core::f32::consts::PI);
        assert_eq!(math::angle(-sin, cos), -angle);
        let (s, c) = (f64::from(sin), f64::from(cos));
        let exact = math::atan2(s, c);
        let ulp = f64::from_bits((exact.to_bits() & (0x7ff << 52)) - (23 << 52));
        let error = ulps_single(angle, exact) * ulp;
        assert!(error <= allowance(s, c, (s * s + c * c - 1.0) / 2.0, ulp), "{sin:e} {cos:e}: {error:e}");
    }
}

#[test]
fn axes_and_diagonals() {
    let diagonal = FRAC_PI_4.sin();
    let table: [(f64, f64, f64); 15] = [
        (0.0, 1.0, 0.0),
        (-0.0, 1.0, 0.0),
        (0.0, -1.0, PI),
        (-0.0, -1.0, PI),
        (1.0, 0.0, FRAC_PI_2),
        (1.0, -0.0, FRAC_PI_2),
        (-1.0, 0.0, -FRAC_PI_2),
        (-1.0, -0.0, -FRAC_PI_2),
        (1e-30, 1.0, 1e-30),
        (-1e-30, 1.0, -1e-30),
        (1e-30, -1.0, PI),
        (-1e-30, -1.0, -PI),
        (1.0, -1e-30, FRAC_PI_2),
        (1e-45, 1.0, 1e-45),
        (5e-324, 1.0, 5e-324),
    ];
    for (sin, cos, angle) in table {
        assert_eq!(math::angle(sin, cos).to_bits(), angle.to_bits(), "{sin:e} {cos:e}");
        assert_eq!(math::angle(sin as f32, cos as f32).to_bits(), (angle as f32).to_bits(), "{sin:e} {cos:e}");
    }
    for (sin, cos, eighths) in [(1.0, 1.0, 1.0), (1.0, -1.0, 3.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, -3.0)] {
        let angle = eighths * FRAC_PI_4;
        assert!((math::angle(sin * diagonal, cos * diagonal) - angle).abs() <= 2.3e-16 * eighths.abs());
        let single = math::angle((sin * diagonal) as f32, (cos * diagonal) as f32);
        assert!((f64::from(single) - angle).abs() <= 1.2e-7 * eighths.abs());
    }
}

#[test]
fn not_a_number_and_no_unit_vector() {
    const INF: f64 = f64::INFINITY;
    for other in [0.0, -0.0, 1.0, -1.0, 5e-324, 1e300, INF, -INF, f64::NAN] {
        for nan in [f64::NAN, -f64::NAN] {
            assert!(math::angle(nan, other).is_nan() && math::angle(other, nan).is_nan());
            let (nan, other) = (nan as f32, other as f32);
            assert!(math::angle(nan, other).is_nan() && math::angle(other, nan).is_nan());
        }
    }
    // The zero vector: unspecified, but kept.
    for (zero, angle) in [(0.0_f64, 0.0_f64), (-0.0, PI)] {
        assert_eq!(math::angle(0.0, zero).to_bits(), angle.to_bits());
        assert_eq!(math::angle(0.0, zero as f32).to_bits(), (angle as f32).to_bits());
    }
}

/// Lengths with every combination of blocks; bit patterns of every kind.
#[test]
fn arrays_have_the_same_bits() {
    fn check<const N: usize>(random: &mut Random) {
        for i in 0..500 {
            let vectors: [(f64, f64); N] = core::array::from_fn(|_| match i % 4 {
                0 => (random.finite(), f64::from_bits(random.bits())),
                _ => some_vector(random, i),
            });
            let (sines, cosines) = (vectors.map(|v| v.0), vectors.map(|v| v.1));
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            for (angle, (sin, cos)) in math::angle_array(sines, cosines).into_iter().zip(vectors) {
                assert!(same(angle, math::angle(sin, cos)), "{sin:e} {cos:e}");
            }
            let singles = math::angle_array(sines.map(|v| v as f32), cosines.map(|v| v as f32));
            for (angle, (sin, cos)) in singles.into_iter().zip(vectors) {
                let one = math::angle(sin as f32, cos as f32);
                assert!(same(f64::from(angle), f64::from(one)), "{sin:e} {cos:e}");
            }
        }
    }
    let mut random = Random(43);
    check::<0>(&mut random);
    check::<1>(&mut random);
    check::<2>(&mut random);
    check::<3>(&mut random);
    check::<4>(&mut random);
    check::<5>(&mut random);
    check::<6>(&mut random);
    check::<7>(&mut random);
    check::<9>(&mut random);
    check::<15>(&mut random);
    check::<20>(&mut random);
}
