use super::double_double::{self, Wide, ulps, ulps_single};
use super::hard_cases::HARD_CASES;
use super::random::Random;
use crate::math;

/// Error bound in the documentation of [`math::sin_cos`], ulp.
const BOUND: f64 = 1.1;

fn error(x: f64) -> f64 {
    let (sine, cosine) = math::sin_cos(x);
    let (exact_sine, exact_cosine) = double_double::sin_cos(x);
    ulps(sine, exact_sine).max(ulps(cosine, exact_cosine))
}

#[test]
fn double_random_of_several_magnitudes() {
    let mut random = Random(1);
    for scale in [1e-9, 1e-3, 0.785, 3.2, 100.0, 205_887.0, 1e8] {
        for _ in 0..40_000 {
            let x = random.signed() * scale;
            let error = error(x);
            assert!(error <= BOUND, "{x:e}: {error} ulp");
        }
    }
}

#[test]
fn double_beside_multiples_of_quarter_pi() {
    for n in 1..40_000 {
        let bits = (f64::from(n) * core::f64::consts::FRAC_PI_4).to_bits();
        for bits in bits - 2..=bits + 2 {
            let x = f64::from_bits(bits);
            let error = error(x);
            assert!(error <= BOUND, "{x:e}: {error} ulp");
        }
    }
}

#[test]
fn double_hard_cases() {
    for (x, sine, cosine) in HARD_CASES {
        let wide = |[hi, lo]: [u64; 2]| Wide { hi: f64::from_bits(hi), lo: f64::from_bits(lo) };
        let x = f64::from_bits(x);
        for (x, exact_sine) in [(x, wide(sine)), (-x, -wide(sine))] {
            let (s, c) = math::sin_cos(x);
            let error = ulps(s, exact_sine).max(ulps(c, wide(cosine)));
            assert!(error <= BOUND, "{x:e}: {error} ulp");
        }
    }
}

/// Doubling the angle is exact, so its sine and cosine follow from those of the angle: no reference is needed.
#[test]
fn double_of_any_magnitude_satisfies_the_double_angle_formulas() {
    let mut random = Random(2);
    for _ in 0..40_000 {
        let x = random.finite();
        if x.abs() > 1e307 {
            continue;
        }
        let ((s, c), (s2, c2)) = (math::sin_cos(x), math::sin_cos(2.0 * x));
        assert!((s * s + c * c - 1.0).abs() < 1e-15, "{x:e}");
        assert!((2.0 * s * c - s2).abs() < 1e-15 && (c * c - s * s - c2).abs() < 1e-15, "{x:e}");
    }
}

#[test]
fn single_against_double() {
    let mut random = Random(3);
    let scaled = |random: &mut Random, scale: f64| (random.signed() * scale) as f32;
    for i in 0..600_000 {
        let x = match i % 6 {
            0 => scaled(&mut random, 0.8),
            1 => scaled(&mut random, 3.2),
            2 => scaled(&mut random, 201.0),
            3 => scaled(&mut random, 1e5),
            4 => (f64::from(i / 6) * core::f64::consts::FRAC_PI_4) as f32,
            _ => random.finite_single(),
        };
        let (sine, cosine) = math::sin_cos(x);
        let (exact_sine, exact_cosine) = math::sin_cos(f64::from(x));
        let error = ulps_single(sine, exact_sine).max(ulps_single(cosine, exact_cosine));
        assert!(error <= BOUND, "{x:e}: {error} ulp");
    }
}

#[test]
fn signs_and_not_a_number() {
    let (s, c) = math::sin_cos(0.0_f64);
    assert_eq!((s.to_bits(), c), (0, 1.0));
    let (s, c) = math::sin_cos(-0.0_f64);
    assert_eq!((s.to_bits(), c), ((-0.0_f64).to_bits(), 1.0));
    let (s, c) = math::sin_cos(-0.0_f32);
    assert_eq!((s.to_bits(), c), ((-0.0_f32).to_bits(), 1.0));
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (s, c) = math::sin_cos(x);
        assert!(s.is_nan() && c.is_nan());
        let (s, c) = math::sin_cos(x as f32);
        assert!(s.is_nan() && c.is_nan());
    }
    let mut random = Random(4);
    for _ in 0..20_000 {
        let x = if random.bits() & 1 == 0 { random.finite() } else { random.signed() * 10.0 };
        let ((s, c), (s_minus, c_minus)) = (math::sin_cos(x), math::sin_cos(-x));
        assert_eq!((s_minus.to_bits(), c_minus.to_bits()), ((-s).to_bits(), c.to_bits()), "{x:e}");
        let x = random.finite_single();
        let ((s, c), (s_minus, c_minus)) = (math::sin_cos(x), math::sin_cos(-x));
        assert_eq!((s_minus.to_bits(), c_minus.to_bits()), ((-s).to_bits(), c.to_bits()), "{x:e}");
    }
}

fn array_has_the_bits_of_single_calls<const N: usize>(random: &mut Random) {
    for scale in [3.2, 150.0, 1e5, 1e12] {
        let angles: [f64; N] = core::array::from_fn(|_| random.signed() * scale);
        let (sines, cosines) = math::sin_cos_array(angles);
        let angles_single = angles.map(|v| v as f32);
        let (sines_single, cosines_single) = math::sin_cos_array(angles_single);
        for i in 0..N {
            let (s, c) = math::sin_cos(angles[i]);
            assert_eq!((sines[i].to_bits(), cosines[i].to_bits()), (s.to_bits(), c.to_bits()));
            let (s, c) = math::sin_cos(angles_single[i]);
            assert_eq!((sines_single[i].to_bits(), cosines_single[i].to_bits()), (s.to_bits(), c.to_bits()));
        }
    }
}

#[test]
fn arrays() {
    let mut random = Random(5);
    for _ in 0..200 {
        array_has_the_bits_of_single_calls::<0>(&mut random);
        array_has_the_bits_of_single_calls::<1>(&mut random);
        array_has_the_bits_of_single_calls::<3>(&mut random);
        array_has_the_bits_of_single_calls::<6>(&mut random);
        array_has_the_bits_of_single_calls::<7>(&mut random);
        array_has_the_bits_of_single_calls::<10>(&mut random);
        array_has_the_bits_of_single_calls::<23>(&mut random);
    }
    let (sines, cosines) = math::sin_cos_array([1.0, f64::NAN, f64::INFINITY, 2.0]);
    assert_eq!((sines[0], cosines[3]), (math::sin_cos(1.0).0, math::sin_cos(2.0).1));
    assert!(sines[1].is_nan() && cosines[2].is_nan());
}
