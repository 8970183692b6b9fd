//! Parameters bound at run time: a struct of fields beside the unit struct of the same file, and beside the chain, over
//! many lengths.
#![allow(clippy::unwrap_used)]

#[macro_use]
mod arms;
mod code;
mod inverse;
mod kernel_arms;
mod kernels;

use arms::*;
use denhart::{Arm, Jacobian, JointKind, Pose};
use denhart_tests::random::Random;
use denhart_tests::subject::largest;
use kernel_arms::*;
use std::f64::consts::PI;

/// A product of ten transforms rounds about fifty times, each time by at most 1.1e-16 of the value or of reach.
const ROUNDING: f64 = 1e-13;

/// Largest difference of two poses, positions in `reach`.
fn pose_error(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let positions = a.translation.iter().zip(&b.translation).map(|(x, y)| (x - y) / reach);
    let rotations = a.rotation.as_flattened().iter().zip(b.rotation.as_flattened()).map(|(x, y)| x - y);
    largest(positions.chain(rotations))
}

/// Largest difference of two Jacobians of the arm `A`, velocities in `reach`; what slides moves by a direction.
fn jacobian_error<A: Arm<f64, N>, const N: usize>(
    a: &Jacobian<f64, N>,
    b: impl Fn(usize, usize) -> f64,
    reach: f64,
) -> f64 {
    let difference = |row: usize, joint: usize| {
        let is_length = row < 3 && A::JOINT_KINDS[joint] == JointKind::Revolute;
        (a.rows[row][joint] - b(row, joint)) / if is_length { reach } else { 1.0 }
    };
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

/// Unit of a joint: 1 rad, or the reach of the arm for a prismatic joint.
fn unit<A: Parametric<N>, const N: usize>(arm: &A, joint: usize) -> f64 {
    if A::JOINT_KINDS[joint] == JointKind::Prismatic { reach(arm) } else { 1.0 }
}

/// Any angles, and strokes of up to half the reach.
fn joints<A: Parametric<N>, const N: usize>(arm: &A, random: &mut Random) -> [f64; N] {
    std::array::from_fn(|joint| match A::JOINT_KINDS[joint] {
        JointKind::Prismatic => random.uniform(-0.5, 0.5) * reach(arm),
        _ => random.uniform(-PI, PI),
    })
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
        let error = jacobian_error::<A, N>(&jacobian, |row, joint| expected[(row, joint)], reach);
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
            check_at(&arm, &joints(&arm, &mut random));
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
        let q = joints(&arm, &mut random);
        assert!(pose_error(&arm.forward(&q), &folded.forward(&q), reach) < ROUNDING);
        let expected = folded.jacobian(&q);
        assert!(jacobian_error::<A, N>(&arm.jacobian(&q), |row, joint| expected.rows[row][joint], reach) < ROUNDING);
    }
}

#[test]
fn forward_functions_follow_the_lengths() {
    arms!(check forward_beside_chain);
}

#[test]
fn the_values_of_the_file_give_the_arm_of_the_file() {
    arms!(check nominal_is_folded);
}

/// Margins have no unit: an arm of twice the size has the same.
#[test]
fn margins_are_relative_to_the_bound_reach() {
    let (arm, mut random) = (Puma560::file(), Random::named("margins"));
    let large = Puma560::with(&arm.values().iter().map(|length| 2.0 * length).collect::<Vec<_>>());
    for _ in 0..100 {
        let q = joints(&arm, &mut random);
        for (margin, expected) in large.margins(&q).iter().zip(&arm.margins(&q)) {
            assert!((margin.value - expected.value).abs() < ROUNDING, "{margin:?}, {expected:?}");
        }
    }
}

/// A parameter that nothing uses, on an arm without any length.
#[test]
fn an_arm_without_lengths_compiles() {
    #[derive(denhart::Arm)]
    #[arm(yaml = "
name: ball
convention: standard
units: {length: m, angle: deg}
parameters: {unused: 0.5}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
")]
    struct Ball {
        #[allow(dead_code)]
        unused: f64,
    }
    assert_eq!(Ball { unused: 1.0 }.forward(&[0.0; 3]), Pose::identity());
}

/// A redundant joint that slides, without limits, is walked over the reach of the arm as it is bound.
#[test]
fn a_redundant_slide_is_walked_over_the_bound_reach() {
    #[derive(denhart::Arm)]
    #[arm(yaml = "
name: rail
convention: standard
units: {length: m, angle: deg}
parameters: {upper: 0.5}
inverse: {task: planar_position, redundant: q1, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90}
  - {type: fixed, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: upper, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: upper, alpha: 0, d: 0, theta: 0}
")]
    struct Rail {
        upper: f64,
    }
    let walked: Vec<f64> = Rail { upper: 3.0 }.sample_redundancy(&[1.0, 1.0], 2).map(|(q1, _)| q1).collect();
    assert_eq!(walked, [-3.0, 3.0]);
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
