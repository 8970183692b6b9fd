//! Parameters bound at run time: a struct of fields beside the unit struct of the same file, and beside the chain, over
//! many lengths.
#![allow(clippy::unwrap_used)]

mod arms;
mod code;
mod inverse;

use arms::{Askew, Jupiter, Parametric, Planar2r, Planar3r, Puma560, Reacher, Tilted, Ur5};
use denhart::{Arm, Jacobian, Pose};
use denhart_tests::random::Random;
use denhart_tests::subject::largest;
use std::f64::consts::PI;

/// A product of ten transforms rounds about fifty times, each time by at most 1.1e-16 of the value or of reach.
const ROUNDING: f64 = 1e-13;

/// Largest difference of two poses, positions in `reach`.
fn pose_error(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let positions = a.translation.iter().zip(&b.translation).map(|(x, y)| (x - y) / reach);
    let rotations = a.rotation.as_flattened().iter().zip(b.rotation.as_flattened()).map(|(x, y)| x - y);
    largest(positions.chain(rotations))
}

/// Largest difference of two Jacobians, velocities in `reach`.
fn jacobian_error<const N: usize>(a: &Jacobian<f64, N>, b: impl Fn(usize, usize) -> f64, reach: f64) -> f64 {
    let difference =
        |row: usize, joint: usize| (a.rows[row][joint] - b(row, joint)) / if row < 3 { reach } else { 1.0 };
    largest((0..6).flat_map(|row| (0..N).map(move |joint| (row, joint))).map(|(row, joint)| difference(row, joint)))
}

/// The scale of an arm's rounding: all its lengths.
fn reach<A: Parametric<N>, const N: usize>(arm: &A) -> f64 {
    let (rows, base, tool) = arm.bound();
    let rows: f64 = rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
    let frames: f64 = base.xyz.iter().chain(&tool.xyz).map(|x| x.abs()).sum();
    match rows + frames {
        0.0 => 1.0,
        reach => reach,
    }
}

fn joints<const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|_| random.uniform(-PI, PI))
}

/// Every forward function of `arm` at `q` beside another arm and the chain.
fn check_at<A: Parametric<N>, const N: usize>(arm: &A, q: &[f64; N]) {
    let (chain, reach) = (arm.chain(), reach(arm));
    let expected = Pose::from(chain.forward(q).unwrap());
    let pose = arm.forward(q);
    let error = pose_error(&pose, &expected, reach);
    assert!(error < ROUNDING, "forward of {:?} at {q:?}: {error:e}", arm.values());
    for (link, expected) in arm.link_poses(q).iter().zip(chain.link_poses(q).unwrap()) {
        let error = pose_error(link, &Pose::from(expected), reach);
        assert!(error < ROUNDING, "link poses of {:?} at {q:?}: {error:e}", arm.values());
    }
    let expected = chain.jacobian(q).unwrap();
    let (both, jacobian) = arm.forward_and_jacobian(q);
    assert!(pose_error(&both, &pose, reach) < ROUNDING);
    for jacobian in [jacobian, arm.jacobian(q)] {
        let error = jacobian_error(&jacobian, |row, joint| expected[(row, joint)], reach);
        assert!(error < ROUNDING, "jacobian of {:?} at {q:?}: {error:e}", arm.values());
    }
}

/// Random lengths, of either sign, over several orders of magnitude, some of them zero.
fn lengths<A: Parametric<N>, const N: usize>(random: &mut Random) -> A {
    let scale = 10f64.powf(random.uniform(-4.0, 4.0));
    let values: Vec<f64> =
        (0..A::COUNT).map(|_| if random.below(5) == 0 { 0.0 } else { scale * random.uniform(-1.0, 1.0) }).collect();
    A::with(&values)
}

fn forward_beside_chain<A: Parametric<N>, const N: usize>(name: &str) {
    let mut random = Random::named(name);
    for _ in 0..200 {
        let arm: A = lengths(&mut random);
        for _ in 0..5 {
            check_at(&arm, &joints(&mut random));
        }
    }
}

/// With the values of the file the two structs are one arm, and `DH` is its table.
fn nominal_is_folded<A: Parametric<N>, const N: usize>(name: &str) {
    let (arm, folded) = (A::file(), A::Folded::default());
    let (rows, base, tool) = arm.bound();
    assert_eq!((rows.as_slice(), base, tool), (A::TABLE.rows, A::TABLE.base, A::TABLE.tool));
    let (mut random, reach) = (Random::named(name), reach(&arm));
    for _ in 0..200 {
        let q = joints(&mut random);
        assert!(pose_error(&arm.forward(&q), &folded.forward(&q), reach) < ROUNDING);
        let expected = folded.jacobian(&q);
        assert!(jacobian_error(&arm.jacobian(&q), |row, joint| expected.rows[row][joint], reach) < ROUNDING);
    }
}

#[test]
fn forward_functions_follow_the_lengths() {
    forward_beside_chain::<Planar2r, 2>("planar2r");
    forward_beside_chain::<Planar3r, 3>("planar3r");
    forward_beside_chain::<Jupiter, 4>("jupiter");
    forward_beside_chain::<Puma560, 6>("puma560");
    forward_beside_chain::<Ur5, 6>("ur5");
    forward_beside_chain::<Askew, 6>("askew");
    forward_beside_chain::<Tilted, 6>("tilted");
    forward_beside_chain::<Reacher, 3>("reacher");
}

#[test]
fn the_values_of_the_file_give_the_arm_of_the_file() {
    nominal_is_folded::<Planar2r, 2>("planar2r");
    nominal_is_folded::<Planar3r, 3>("planar3r");
    nominal_is_folded::<Jupiter, 4>("jupiter");
    nominal_is_folded::<Puma560, 6>("puma560");
    nominal_is_folded::<Ur5, 6>("ur5");
    nominal_is_folded::<Askew, 6>("askew");
    nominal_is_folded::<Tilted, 6>("tilted");
    nominal_is_folded::<Reacher, 3>("reacher");
}

/// A struct with some of the fields binds those.
#[test]
fn some_fields_bind_some_parameters() {
    #[derive(denhart::Arm)]
    #[arm(
        scalar = "f32",
        yaml = "
name: elbow
convention: standard
units: {length: m, angle: deg}
parameters: {upper: 0.5, Lower: 0.25}
joints:
  - {type: revolute, a: upper, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: -Lower, alpha: 0, d: 0, theta: 0}
"
    )]
    #[allow(non_snake_case)]
    struct Elbow {
        Lower: f32,
    }
    let tip = Elbow { Lower: 2.0 }.forward(&[0.0; 2]).translation;
    assert_eq!(tip.map(f32::to_bits), [-1.5_f32, 0.0, 0.0].map(f32::to_bits));
    let [first, second] = Elbow { Lower: 2.0 }.dh_rows();
    assert_eq!([first.a, second.a], [0.5, -2.0]);
    assert_eq!(Elbow::nominal().dh_rows().as_slice(), Elbow::DH.rows);
}
