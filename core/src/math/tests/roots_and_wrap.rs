use super::double_double::two_product;
use super::random::Random;
use crate::math::{self, Scalar, sqrt::integer};

/// The exact square of the root lies within half a unit of the argument, on both sides.
#[test]
fn integer_root_is_correctly_rounded() {
    let mut random = Random(21);
    for _ in 0..100_000 {
        let x = f64::from_bits((random.bits() >> 12) | ((1000 + random.bits() % 50) << 52));
        let root = integer::double(x);
        let half = (f64::from_bits(root.to_bits() + 1) - root) * 0.5;
        let square = two_product(root, root);
        // (root + half)^2 - x > 0 > (root - half)^2 - x, half^2 being far below the product's own precision.
        let excess = (square.hi - x) + square.lo;
        assert!(excess + 2.0 * root * half > 0.0 && excess - 2.0 * root * half < 0.0, "{x:e}");
    }
}

/// The processor's root is the oracle of the one in integers.
fn check_double(x: f64) {
    assert_eq!(integer::double(x).to_bits(), math::sqrt(x).to_bits(), "{x:e}");
}

fn check_single(bits: u32) {
    let x = f32::from_bits(bits);
    assert_eq!(integer::single(x).to_bits(), math::sqrt(x).to_bits(), "{x:e}");
}

/// The root of every `f32` follows from those of two octaves, an exponent and a shift.
#[test]
fn single_roots() {
    for bits in 0x3f80_0000..0x4080_0000 {
        check_single(bits);
    }
    let mut random = Random(22);
    for exponent in 1..255_u32 {
        for _ in 0..1000 {
            check_single((exponent << 23) | (random.bits() >> 41) as u32);
        }
        for end in [0, 1, 2, 0x3f_ffff, 0x40_0000, 0x7f_fffe, 0x7f_ffff] {
            check_single((exponent << 23) | end);
        }
    }
    for i in 0..1_000_000 {
        check_single((random.bits() >> (41 + i % 23)) as u32);
    }
}

#[test]
#[ignore = "every float: a minute"]
fn every_single_root() {
    for bits in 0..f32::INFINITY.to_bits() {
        check_single(bits);
    }
}

#[test]
fn double_roots() {
    let mut random = Random(24);
    for i in 0..2_000_000 {
        check_double(random.finite().abs());
        // The range of lengths, and subnormals of all magnitudes.
        check_double(f64::from_bits((random.bits() >> 12) | ((1000 + random.bits() % 50) << 52)));
        check_double(f64::from_bits(random.bits() >> (12 + i % 52)));
    }
}

/// Roots next to halfway between two floats, next to floats, and at the ends of the chords.
#[test]
fn hard_double_roots() {
    let mut random = Random(25);
    for i in 0..1_000_000 {
        // An odd number of 54 bits: its square is that of a root halfway between two floats.
        let halfway = (random.bits() >> 11) | (1 << 53) | 1;
        let even = (random.bits() >> 12) | (1 << 52);
        for square in [u128::from(halfway) * u128::from(halfway), u128::from(even) * u128::from(even)] {
            // The cast rounds to the nearest float.
            let x = square as f64;
            for bits in x.to_bits() - 1..=x.to_bits() + 1 {
                check_double(f64::from_bits(bits));
            }
        }
        let end = (i % 64) << 47;
        let beside = random.bits() >> (17 + i % 47);
        for mantissa in [(end + beside) & ((1 << 52) - 1), (end + (1 << 52) - 1 - beside) & ((1 << 52) - 1)] {
            for exponent in [1022, 1023] {
                check_double(f64::from_bits((exponent << 52) | mantissa));
            }
        }
    }
}

#[test]
fn unusual_roots() {
    for x in [0.0, -0.0, 1.0, 4.0, f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1), f64::INFINITY, 0.9999999999999999] {
        check_double(x);
        check_single((x as f32).to_bits());
    }
    for x in [-1.0, -f64::MAX, -f64::from_bits(1), f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
        assert!(integer::double(x).is_nan() && math::sqrt(x).is_nan());
    }
    for x in [-1.0, -f32::MAX, -f32::from_bits(1), f32::NEG_INFINITY, f32::NAN, -f32::NAN] {
        assert!(integer::single(x).is_nan() && math::sqrt(x).is_nan());
    }
}

#[test]
fn the_root_of_the_greatest_value() {
    assert_eq!(f64::SQRT_MAX, integer::double(f64::MAX));
    assert_eq!(f32::SQRT_MAX, integer::single(f32::MAX));
}

#[test]
fn hypotenuse() {
    assert_eq!(math::hypot(3.0_f64, -4.0), 5.0);
    assert_eq!(math::hypot(3.0_f32, -4.0), 5.0);
}

#[test]
fn wrap_keeps_the_direction_and_the_interval() {
    let mut random = Random(23);
    for i in 0..200_000_u32 {
        let x = match i % 5 {
            0 => random.signed() * 10.0,
            1 => random.signed() * 1e4,
            2 => f64::from(i / 5) * core::f64::consts::PI,
            3 => -f64::from(i / 5) * core::f64::consts::PI,
            _ => random.finite(),
        };
        check_wrap(x, 9e-16);
        check_wrap(x as f32, 5e-7);
    }
}

fn check_wrap<T: Scalar>(x: T, tolerance: f64) {
    if !x.is_finite() {
        return;
    }
    let wrapped = math::wrap(x);
    assert!(wrapped > -T::PI && wrapped <= T::PI, "{x}");
    let ((s, c), (sw, cw)) = (math::sin_cos(x), math::sin_cos(wrapped));
    assert!((s - sw).abs().to_f64() < tolerance && (c - cw).abs().to_f64() < tolerance, "{x} {wrapped}");
}

#[test]
fn wrap_ends() {
    use core::f64::consts::{PI, TAU};
    assert_eq!(math::wrap(PI), PI);
    assert_eq!(math::wrap(-PI), PI);
    assert_eq!(math::wrap(TAU), 0.0);
    assert_eq!(math::wrap(-TAU), 0.0);
    assert_eq!(math::wrap(1.5 * PI), -0.5 * PI);
    assert_eq!(math::wrap(-1.25), -1.25);
    assert_eq!(math::wrap(-0.0_f64).to_bits(), (-0.0_f64).to_bits());
    assert_eq!(math::wrap(-core::f32::consts::PI), core::f32::consts::PI);
    assert!(
        math::wrap(f64::INFINITY).is_nan() && math::wrap(f64::NAN).is_nan() && math::wrap(f32::NEG_INFINITY).is_nan()
    );
}

#[test]
fn rounding() {
    for (x, rounded) in [
        (0.5_f64, 0.0_f64),
        (1.5, 2.0),
        (2.5, 2.0),
        (-0.5, -0.0),
        (-1.2, -1.0),
        (1e300, 1e300),
        (4503599627370495.5, 4503599627370496.0),
    ] {
        assert_eq!(Scalar::round_ties_even(x).to_bits(), rounded.to_bits(), "{x}");
    }
    assert_eq!(Scalar::round_ties_even(8388607.5_f32), 8388608.0);
    assert_eq!(Scalar::round_ties_even(-3.5_f32), -4.0);
    assert!(Scalar::round_ties_even(f64::NAN).is_nan());
}

/// Eighths of a turn are exact; other angles are within 2.5 ulp of the standard library's, which rounds in another order.
#[test]
fn degrees() {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    for (degrees, rad) in [(0.0, 0.0), (45.0, FRAC_PI_4), (-90.0, -FRAC_PI_2), (180.0, PI), (360.0, 2.0 * PI)] {
        assert_eq!(math::radians::<f64>(degrees).to_bits(), f64::to_bits(rad), "{degrees}");
        // Each is a power of two times pi.
        assert_eq!(math::radians(degrees as f32).to_bits(), (rad as f32).to_bits(), "{degrees}");
    }
    for tenth in -7200..=7200 {
        let degrees = f64::from(tenth) / 10.0;
        let (double, single) = (math::radians(degrees), f64::from(math::radians(degrees as f32)));
        assert!((double - degrees.to_radians()).abs() <= 2.5 * f64::EPSILON * double.abs(), "{degrees}");
        let exact = f64::from(degrees as f32).to_radians();
        assert!((single - exact).abs() <= 2.5 * f64::from(f32::EPSILON) * exact.abs(), "{degrees}");
    }
    assert!(math::radians(f64::NAN).is_nan() && math::radians(f32::INFINITY).is_infinite());
}
