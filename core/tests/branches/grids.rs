//! Joint vectors of round angles: most poses are singular, or have solutions that share the held joint.

use denhart_core::math::wrap;

use crate::arms;
use crate::support::{Arm, Joints, Random, SAME, least_singular_value};

const POSES: usize = 2000;

/// Joints of a singular pose are known no better.
const SINGULAR: f64 = 1e-2;

fn tolerance(arm: &Arm, joints: &Joints) -> f64 {
    let sigma = least_singular_value(&arm.chain, joints);
    if sigma > 1e-6 { (1e-14 / sigma).max(SAME) } else { SINGULAR }
}

#[test]
fn no_joint_vector_of_a_grid_is_lost() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        for step in [15.0, 30.0, 45.0, 90.0] {
            let mut random = Random(99);
            let mut most = 0;
            for _ in 0..POSES {
                let joints = random.grid(step);
                let found = arm.solve(&arm.chain.pose(&joints), &joints);
                let distance = found.distance(&arm.chain, &joints);
                assert!(distance <= tolerance(&arm, &joints), "{name}, {step} degrees: {joints:?} {distance:.0e}");
                assert!(found.is_complete, "{name}, {step} degrees: {joints:?}");
                most = most.max(found.evaluations);
            }
            println!("{name}, {step} degrees: at most {most} evaluations");
        }
    }
}

/// The elbow folded and joint 5 at 0 or 180 degrees: several singularities meet in one point.
#[test]
fn a_folded_elbow_with_a_singular_wrist_is_found() {
    for name in ["jaco", "mico", "gen3_lite"] {
        let arm = Arm::of(arms::named(name));
        let mut random = Random(3);
        for _ in 0..500 {
            let mut joints = random.grid(45.0);
            let half = core::f64::consts::PI;
            joints[2] = half;
            joints[4] = if random.unit() < 0.5 { 0.0 } else { half };
            let found = arm.solve(&arm.chain.pose(&joints), &joints);
            let distance = found.distance(&arm.chain, &joints);
            assert!(distance <= tolerance(&arm, &joints), "{name}: {joints:?} {distance:.0e}");
        }
    }
}

/// Four branches meet at q4 = 0 and 180 degrees, in a root of order four.
#[test]
fn roots_of_order_four_and_their_neighborhood_are_resolved() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(31);
        for offset in [0.0, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
            for _ in 0..150 {
                let mut joints = random.joints();
                let round = if random.unit() < 0.5 { 0.0 } else { core::f64::consts::PI };
                joints[3] = wrap(round + if random.unit() < 0.5 { offset } else { -offset });
                let found = arm.solve(&arm.chain.pose(&joints), &joints);
                let distance = found.distance(&arm.chain, &joints);
                assert!(distance <= tolerance(&arm, &joints), "{name}, {offset}: {joints:?} {distance:.0e}");
            }
        }
    }
}

/// All joints beside round angles: clusters of up to eight roots. Some of these poses are lost, at most so many of 500.
#[test]
fn few_joint_vectors_beside_round_ones_are_lost() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        for (step, most) in [(30.0, 1), (90.0, 4)] {
            for digits in 2..10 {
                let mut random = Random(1234 + digits);
                let offset = 0.1_f64.powi(i32::try_from(digits).unwrap());
                let (mut lost, mut unreachable) = (0, 0);
                for _ in 0..500 {
                    let share = random.unit();
                    let joints = random.grid(step).map(|angle| {
                        let is_moved = random.unit() < share;
                        wrap(if is_moved { angle + offset * random.within(-1.0, 1.0) } else { angle })
                    });
                    let found = arm.solve(&arm.chain.pose(&joints), &joints);
                    lost += usize::from(found.distance(&arm.chain, &joints) > tolerance(&arm, &joints));
                    unreachable += usize::from(found.list.is_empty());
                }
                println!("{name}, {step} degrees, beside by {offset:.0e}: lost {lost}, unreachable {unreachable}");
                assert!(lost <= most && unreachable <= 1, "{name} {step} {offset:.0e}: {lost} {unreachable}");
            }
        }
    }
}
