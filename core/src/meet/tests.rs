//! Made-up rings.
#![allow(clippy::unwrap_used)]

use super::branch::Posed;
use super::{Meet, Structure};
use crate::Transform;
use crate::branches::Branches;
use crate::math::sin_cos;

/// A fixed sequence of numbers between -1 and 1.
fn numbers(seed: f64) -> impl FnMut() -> f64 {
    let mut angle = seed;
    move || {
        angle = (1.7 * angle + 2.3) % 97.0;
        sin_cos(angle).0
    }
}

/// A transform without any structure.
fn any(next: &mut impl FnMut() -> f64) -> Transform<f64> {
    let (s, c) = sin_cos(2.0 * next());
    let tilt =
        Transform { rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]], translation: [next(), next(), next()] };
    Transform::IDENTITY.then_turn(sin_cos(3.0 * next())) * tilt.then_turn(sin_cos(3.0 * next()))
}

/// K1 to K6 of a ring with x3 parallel to x4, and u that meets v.
fn ring(seed: f64, is_antiparallel: bool) -> (Structure, [Transform<f64>; 6]) {
    let mut next = numbers(seed);
    let mut ring = core::array::from_fn(|_| any(&mut next));
    let [_, _, k3, _, k5, _] = &mut ring;
    let half = Transform { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], translation: [0.0; 3] };
    let turn = Transform::IDENTITY.then_turn(sin_cos(3.0 * next()));
    *k3 = Transform { translation: k3.translation, ..if is_antiparallel { turn * half } else { turn } };
    let (wu, wv) = (next(), next());
    let z = k5.z();
    k5.translation = [-wv * z[0], -wv * z[1], wu - wv * z[2]];
    let structure = Structure { joints: [5, 0, 1, 2, 3, 4], is_mirrored: false, is_antiparallel, is_constant: true };
    (structure, ring)
}

/// K1 that closes the ring at the joints x1, x2, x3, x4, u, v.
fn closing([x1, x2, x3, x4, u, v]: [f64; 6], [_, k2, k3, k4, k5, k6]: &[Transform<f64>; 6]) -> Transform<f64> {
    let turn = |angle: f64| Transform::IDENTITY.then_turn(sin_cos(angle));
    let rest = turn(x2) * *k2 * turn(x3) * *k3 * turn(x4) * *k4 * turn(u) * *k5 * turn(v) * *k6;
    (rest * turn(x1)).inverse()
}

const ANGLES: [f64; 6] = [0.4, -1.1, 2.3, 0.9, -2.0, 1.3];

#[test]
fn a_branch_closes_where_the_ring_does() {
    for seed in 0..40 {
        let (structure, ring) = ring(f64::from(seed), seed % 2 == 1);
        let meet = Meet::of(&structure, &ring).unwrap();
        let posed = Posed::of(&meet, &closing(ANGLES, &ring));
        let [t, ..] = ANGLES;
        let closes = (0..4).any(|number| {
            let [a, b, c, d, e, f] = posed.joints(number, t);
            let joints = [f, a, b, c, d, e];
            posed.branch(number, t).miss.abs() < 1e-11 && joints.iter().zip(ANGLES).all(|(x, y)| (x - y).abs() < 1e-10)
        });
        assert!(closes, "{seed}");
    }
}

#[test]
fn the_product_of_the_branches_has_no_harmonic_above_the_eighth() {
    for seed in 0..20 {
        let (structure, ring) = ring(f64::from(seed), seed % 2 == 1);
        let meet = Meet::of(&structure, &ring).unwrap();
        assert!(!meet.has_equal_pairs);
        assert!(highest_harmonic(&Posed::of(&meet, &closing(ANGLES, &ring))) == 8, "{seed}");
    }
}

#[test]
fn equal_pairs_of_branches_leave_degree_four() {
    // The arm of a CRX: W on the axis of x2 in the plane, and all axes at right angles.
    let turned = |[x, y, z]: [f64; 3], s: f64| Transform {
        rotation: [[1.0, 0.0, 0.0], [0.0, 0.0, -s], [0.0, s, 0.0]],
        translation: [x, y, z],
    };
    let (structure, mut ring) = ring(0.3, false);
    ring[1] = turned([0.0, 0.0, 0.0], -1.0);
    ring[2] = Transform { translation: [0.71, 0.0, 0.0], ..Transform::IDENTITY };
    ring[3] = turned([0.0, 0.54, 0.0], -1.0);
    ring[4] = turned([0.0, 0.0, 0.0], 1.0);
    let meet = Meet::of(&structure, &ring).unwrap();
    assert!(meet.has_equal_pairs);
    assert!(highest_harmonic(&Posed::of(&meet, &closing(ANGLES, &ring))) == 4);
}

/// The highest harmonic of the product that is more than rounding, of 64 samples.
fn highest_harmonic(posed: &Posed<'_, f64>) -> usize {
    let sample = |turn: u32| posed.product(sin_cos(core::f64::consts::TAU * f64::from(turn) / 64.0 + 0.1)).0;
    let samples: std::vec::Vec<f64> = (0..64).map(sample).collect();
    let size = |harmonic: u32| {
        let (mut even, mut odd) = (0.0, 0.0);
        for (turn, value) in (0..64).zip(&samples) {
            let (s, c) = sin_cos(core::f64::consts::TAU * f64::from(turn * harmonic % 64) / 64.0);
            even += value * c;
            odd += value * s;
        }
        (even * even + odd * odd).sqrt()
    };
    let sizes: std::vec::Vec<f64> = (0..32).map(size).collect();
    let greatest = sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
    sizes.iter().rposition(|size| *size > 1e-12 * greatest).unwrap_or(0)
}

#[test]
fn a_target_that_is_not_finite_has_no_candidates() {
    let (structure, ring) = ring(1.0, false);
    let meet = Meet::of(&structure, &ring).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
        for place in 0..4 {
            let mut k1 = closing(ANGLES, &ring);
            match place {
                3 => k1.translation[1] = bad,
                row => k1.rotation[row][2] = bad,
            }
            let mut count = 0;
            let outcome = meet.search(&k1, &[f64::NAN; 6], &mut |candidate| {
                assert!(candidate.is_finite());
                count += 1;
                core::ops::ControlFlow::Continue(())
            });
            assert!(bad == f64::MAX || (count == 0 && outcome.is_complete));
        }
    }
}
