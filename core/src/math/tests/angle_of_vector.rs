use super::double_double::{self, Wide, ulps_single};
use super::random::Random;
use crate::math;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Error bound in the documentation of [`math::atan2`], ulp.
const BOUND: f64 = 1.5;

fn error(y: f64, x: f64) -> f64 {
    error_of(math::atan2(y, x), y, x)
}

/// Error in ulp: the direction (cos, sin) of the result, in double-double, leaves an angle against the vector.
pub(super) fn error_of(angle: f64, y: f64, x: f64) -> f64 {
    let (sine, cosine) = double_double::sin_cos(angle);
    let (y, x) = (Wide::from(y), Wide::from(x));
    let (across, along) = (y * cosine - x * sine, x * cosine + y * sine);
    assert!(along.hi > 0.0);
    let unit = f64::from_bits(angle.abs().to_bits() + 1) - angle.abs();
    (across.hi / along.hi / unit).abs()
}

#[test]
fn double_random_pairs() {
    let mut random = Random(11);
    for i in 0..400_000 {
        let (a, b) = (random.signed(), random.signed());
        let tiny = f64::from_bits((1023 - random.bits() % 90) << 52);
        let (y, x) = match i % 5 {
            0 => (a, b),
            1 => (a * tiny, b),
            2 => (a, b * tiny),
            // Beside the change of formula, where the error is greatest.
            3 => (b * (0.4143 + 0.04 * a), b),
            _ => (b, b * (0.4143 + 0.04 * a)),
        };
        if y == 0.0 || x == 0.0 {
            continue;
        }
        let error = error(y, x);
        assert!(error <= BOUND, "{y:e} {x:e}: {error} ulp");
    }
}

/// The angle depends on the ratio only: scaling by powers of two changes no bit, overflow and underflow apart.
#[test]
fn scaled_pairs_have_the_same_angle() {
    let mut random = Random(12);
    for _ in 0..20_000 {
        let (y, x) = (random.signed(), random.signed());
        for exponent in [-900, -600, -501, -499, -100, 300, 499, 501, 800, 1020] {
            let scale = f64::from_bits(((1023 + exponent) as u64) << 52);
            assert_eq!(
                math::atan2(y * scale, x * scale).to_bits(),
                math::atan2(y, x).to_bits(),
                "{y:e} {x:e} {scale:e}"
            );
        }
        let (y, x) = (y as f32, x as f32);
        for exponent in [-90, -60, -51, -49, 49, 51, 100, 120] {
            let scale = f32::from_bits(((127 + exponent) as u32) << 23);
            assert_eq!(
                math::atan2(y * scale, x * scale).to_bits(),
                math::atan2(y, x).to_bits(),
                "{y:e} {x:e} {scale:e}"
            );
        }
    }
}

#[test]
fn single_against_double() {
    let mut random = Random(13);
    for i in 0..600_000 {
        let (a, b) = (random.signed(), random.signed());
        let (y, x) = match i % 4 {
            0 => (a as f32, b as f32),
            1 => ((b * (0.4143 + 0.04 * a)) as f32, b as f32),
            2 => (b as f32, (b * (0.4143 + 0.04 * a)) as f32),
            _ => (random.finite_single(), random.finite_single()),
        };
        let error = ulps_single(math::atan2(y, x), math::atan2(f64::from(y), f64::from(x)));
        assert!(error <= BOUND, "{y:e} {x:e}: {error} ulp");
    }
}

#[test]
fn special_cases() {
    const INF: f64 = f64::INFINITY;
    let table = [
        (0.0, 1.0, 0.0),
        (-0.0, 1.0, -0.0),
        (0.0, -1.0, PI),
        (-0.0, -1.0, -PI),
        (0.0, 0.0, 0.0),
        (-0.0, 0.0, -0.0),
        (0.0, -0.0, PI),
        (-0.0, -0.0, -PI),
        (1.0, 0.0, FRAC_PI_2),
        (1.0, -0.0, FRAC_PI_2),
        (-1.0, 0.0, -FRAC_PI_2),
        (INF, 1.0, FRAC_PI_2),
        (-INF, -1.0, -FRAC_PI_2),
        (1.0, INF, 0.0),
        (-1.0, INF, -0.0),
        (1.0, -INF, PI),
        (-1.0, -INF, -PI),
        (INF, INF, FRAC_PI_4),
        (-INF, INF, -FRAC_PI_4),
        (INF, -INF, 3.0 * FRAC_PI_4),
        (-INF, -INF, -3.0 * FRAC_PI_4),
        (1.0, 1.0, FRAC_PI_4),
        (-1.0, -1.0, -3.0 * FRAC_PI_4),
        (f64::from_bits(1), 1.0, f64::from_bits(1)),
        (f64::from_bits(1), f64::MAX, 0.0),
        (f64::from_bits(1), -f64::MAX, PI),
        (-f64::MAX, f64::from_bits(1), -FRAC_PI_2),
        (f64::from_bits(1), f64::from_bits(1), FRAC_PI_4),
        (f64::MAX, f64::MAX, FRAC_PI_4),
        (f64::MIN_POSITIVE, 3.0, f64::MIN_POSITIVE / 3.0),
        (1e-200, 1e200, 0.0),
        (1e-300, 0.5, 2e-300),
    ];
    for (y, x, angle) in table {
        assert_eq!(math::atan2(y, x).to_bits(), angle.to_bits(), "{y:e} {x:e}");
        assert_eq!(math::atan2(y as f32, x as f32).is_sign_negative(), y.is_sign_negative(), "{y:e} {x:e}");
    }
    for (y, x, angle) in table.iter().take(23) {
        assert_eq!(math::atan2(*y as f32, *x as f32).to_bits(), (*angle as f32).to_bits(), "{y:e} {x:e}");
    }
    for other in [0.0, 1.0, INF, f64::NAN] {
        assert!(math::atan2(f64::NAN, other).is_nan() && math::atan2(other, f64::NAN).is_nan());
        assert!(math::atan2(f32::NAN, other as f32).is_nan() && math::atan2(other as f32, f32::NAN).is_nan());
    }
}

#[test]
fn least_floats() {
    for (y, x) in [(3_u32, 7_u32), (1, 2), (9, 4), (1_000, 999)] {
        let exact = math::atan2(f64::from(y), f64::from(x));
        assert_eq!(math::atan2(f64::from_bits(y.into()), f64::from_bits(x.into())), exact);
        assert!(ulps_single(math::atan2(f32::from_bits(y), f32::from_bits(x)), exact) <= BOUND);
    }
}
