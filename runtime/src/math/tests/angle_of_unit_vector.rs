use super::angle_of_vector::error_of;
use super::double_double::ulps_single;
use super::random::Random;
use crate::math;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// What the documentation of [`math::angle`] promises.
const BOUND: f64 = 2.0;

/// Angles over the circle, beside its axes and diagonals.
fn some_angle(random: &mut Random, i: u32) -> f64 {
    let offset = match i % 3 {
        0 => random.signed() * FRAC_PI_4,
        1 => random.signed() * f64::from_bits((1023 - random.bits() % 60) << 52) * FRAC_PI_4,
        _ => random.signed() * 0.01,
    };
    (random.bits() % 8) as f64 * FRAC_PI_4 - PI + offset
}

#[test]
fn double_sines_and_cosines() {
    let mut random = Random(41);
    let mut greatest = 0.0f64;
    for i in 0..6_000_000 {
        let (sin, cos) = math::sin_cos(some_angle(&mut random, i));
        let error = error_of(math::angle(sin, cos), sin, cos);
        if error > greatest { greatest = error; std::println!("{error} {sin} {cos} {}", math::atan2(sin, cos)); }
        assert!(error <= BOUND, "{sin:e} {cos:e}: {error} ulp");
    }
    std::println!("{greatest}");
}
#[test]
fn single_sines_and_cosines() {
    let mut random = Random(41);
    let mut greatest = 0.0f64;
    for i in 0..6_000_000 {
        let (sin, cos) = math::sin_cos(some_angle(&mut random, i));
        let (sin, cos) = (sin as f32, cos as f32);
        let error = ulps_single(math::angle(sin, cos), math::atan2(f64::from(sin), f64::from(cos)));
        if error > greatest { greatest = error; std::println!("{error} {sin} {cos} {}", math::atan2(sin, cos)); }
        assert!(error <= BOUND, "{sin:e} {cos:e}: {error} ulp");
    }
    std::println!("{greatest} {FRAC_PI_2}");
}
