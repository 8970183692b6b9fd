//! Functions over lanes beside the scalar ones.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use std::vec::Vec;

use super::random::Random;
use crate::lanes::{BLOCK, InstructionSet, Lanes, Row, Work};
use crate::math;
use crate::math::lanes::{angle, atan2, sin_cos, wrap};

/// A function of two numbers over a block, and its doubts.
struct Block<F>(F, Row, Row);

trait OfTwo {
    fn of<L: Lanes>(&self, a: L, b: L) -> (L, L, L::Mask);
    fn scalar(&self, a: f64, b: f64) -> (f64, f64);
}

impl<F: OfTwo> Work for Block<F> {
    type Output = (Row, Row, u32);

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) -> Self::Output {
        let Self(function, a, b) = self;
        let (mut first, mut second, mut doubts) = (Row::all(0.0), Row::all(0.0), 0);
        for at in 0..BLOCK / L::WIDTH {
            let (x, y, doubt) = function.of(L::load(set, &a, at), L::load(set, &b, at));
            x.store(&mut first, at);
            y.store(&mut second, at);
            doubts |= L::bits(doubt) << (at * L::WIDTH);
        }
        (first, second, doubts)
    }
}

#[derive(Clone, Copy)]
struct SinCos;
impl OfTwo for SinCos {
    #[inline(always)]
    fn of<L: Lanes>(&self, a: L, _: L) -> (L, L, L::Mask) {
        let ((sin, cos), doubt) = sin_cos(a);
        (sin, cos, doubt)
    }
    fn scalar(&self, a: f64, _: f64) -> (f64, f64) {
        math::sin_cos(a)
    }
}

/// Of the direction of a vector.
#[derive(Clone, Copy)]
struct Angle;
impl OfTwo for Angle {
    #[inline(always)]
    fn of<L: Lanes>(&self, a: L, b: L) -> (L, L, L::Mask) {
        let k = a.of(1.0) / (a * a + b * b).sqrt();
        let angle = angle(a * k, b * k);
        (angle, angle, angle.less(angle))
    }
    fn scalar(&self, a: f64, b: f64) -> (f64, f64) {
        let k = 1.0 / (a * a + b * b).sqrt();
        let angle = math::angle(a * k, b * k);
        (angle, angle)
    }
}

#[derive(Clone, Copy)]
struct Atan2;
impl OfTwo for Atan2 {
    #[inline(always)]
    fn of<L: Lanes>(&self, a: L, b: L) -> (L, L, L::Mask) {
        let (angle, doubt) = atan2(a, b);
        (angle, angle, doubt)
    }
    fn scalar(&self, a: f64, b: f64) -> (f64, f64) {
        let angle = math::atan2(a, b);
        (angle, angle)
    }
}

#[derive(Clone, Copy)]
struct Wrap;
impl OfTwo for Wrap {
    #[inline(always)]
    fn of<L: Lanes>(&self, a: L, _: L) -> (L, L, L::Mask) {
        let (angle, doubt) = wrap(a);
        (angle, angle, doubt)
    }
    fn scalar(&self, a: f64, _: f64) -> (f64, f64) {
        let angle = math::wrap(a);
        (angle, angle)
    }
}

/// Compares lanes that are not in doubt; returns how many there are.
fn compare<F: OfTwo + Copy>(function: F, numbers: &[(f64, f64)]) -> usize {
    let mut compared = 0;
    for set in InstructionSet::available().into_iter().flatten() {
        for chunk in numbers.chunks(BLOCK) {
            let (mut a, mut b) = (Row::all(1.0), Row::all(1.0));
            for ((x, y), (to_a, to_b)) in chunk.iter().zip(a.0.iter_mut().zip(&mut b.0)) {
                (*to_a, *to_b) = (*x, *y);
            }
            let (first, second, doubts) = set.run(Block(function, a, b));
            for (lane, ((a, b), (x, y))) in chunk.iter().zip(first.0.iter().zip(&second.0)).enumerate() {
                if doubts >> lane & 1 == 0 {
                    let (p, q) = function.scalar(*a, *b);
                    let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                    assert!(same(p, *x) && same(q, *y), "{set}: {a:e} {b:e}: {p:e} {q:e}, in lanes {x:e} {y:e}");
                    compared += 1;
                }
            }
        }
    }
    compared
}

/// Pairs of numbers: at random, of all magnitudes, and those of which one is zero, extreme or no number.
fn pairs() -> Vec<(f64, f64)> {
    /// The largest angle that is reduced in three parts.
    const LIMIT: f64 = 205_887.0;
    let special = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        -0.5,
        PI,
        -PI,
        FRAC_PI_2,
        TAU,
        -TAU,
        9.42,
        -9.42,
        9.43,
        1e-300,
        -1e-300,
        1e300,
        -1e300,
        1e-160,
        1e160,
        LIMIT,
        -LIMIT,
        LIMIT * 1.01,
        f64::MIN_POSITIVE,
        5e-324,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        0.41421356237309503,
        3.0,
        4.0,
        -4.0,
    ];
    let mut pairs = Vec::new();
    for a in special {
        pairs.extend(special.map(|b| (a, b)));
    }
    let mut random = Random(7);
    for _ in 0..40_000 {
        pairs.push((10.0 * random.signed(), 10.0 * random.signed()));
        pairs.push((random.signed(), 1e-3 * random.signed()));
        let scale = 10.0_f64.powf(150.0 * random.signed());
        pairs.push((scale * random.signed(), scale * random.signed()));
        pairs.push((LIMIT * random.signed(), random.signed()));
    }
    pairs
}

#[test]
fn every_lane_has_the_bits_of_the_scalar_function() {
    let pairs = pairs();
    let all = pairs.len() * InstructionSet::available().iter().flatten().count();
    for (compared, part) in [
        (compare(SinCos, &pairs), 0.7),
        (compare(Angle, &pairs), 1.0),
        (compare(Atan2, &pairs), 0.9),
        (compare(Wrap, &pairs), 0.3),
    ] {
        assert!(compared as f64 >= part * all as f64, "{compared} of {all}");
    }
}
