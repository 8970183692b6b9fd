//! The general solver of six joints: complete at random, round and singular poses, on published and made-up arms.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

#[path = "general/support.rs"]
#[allow(dead_code)]
mod support;
#[path = "general/tables.rs"]
mod tables;
#[path = "data/truth.rs"]
mod truth;

use core::ops::ControlFlow::Continue;

use denhart_core::math::radians;
use denhart_core::{Candidate, Chain, Transform};
use support::*;
use tables::Table;

/// Arms that have no closed form of another kind.
const SIX: [&str; 3] = ["gen6r_a", "manseur_doty_16", "two_parallel_6r"];
const SEVEN: [&str; 3] = ["sawyer", "baxter_left", "ufactory_xarm7"];

fn arms() -> impl Iterator<Item = (&'static str, Arm)> {
    let six = SIX.iter().map(|name| (*name, Arm::of(&chain(table(name), 0, 0.0)).unwrap()));
    six.chain(SEVEN.iter().map(|name| (*name, Arm::given(table(name), 2, 0.7).unwrap())))
}

fn random_chain(rng: &mut Random, is_prismatic: [bool; 6]) -> Chain<f64> {
    let links = core::array::from_fn(|i| {
        if i == 0 {
            return Transform::IDENTITY;
        }
        shift([rng.within(-1.0, 1.0), 0.0, rng.within(-1.0, 1.0)]) * rx(rng.within(-180.0, 180.0))
    });
    Chain::new(links, is_prismatic)
}

#[test]
fn all_solutions_of_the_truth_files_are_found() {
    for truth in truth::TRUTHS.iter().filter(|truth| SIX.contains(&truth.arm)) {
        let arm = Arm::of(&chain(table(truth.arm), 0, 0.0)).unwrap();
        let target =
            Transform { rotation: truth.pose.map(|[x, y, z, _]| [x, y, z]), translation: truth.pose.map(|[.., t]| t) };
        let found = arm.solve(&target);
        for solution in truth.solutions {
            assert!(found.distance(&arm.chain, solution) < 1e-5, "{} {solution:?}", truth.arm);
        }
        assert_eq!(found.list.len(), truth.solutions.len(), "{}", truth.arm);
        assert!(found.is_complete);
    }
}

#[test]
fn random_poses_of_published_arms_lose_nothing() {
    for (name, arm) in arms() {
        let mut rng = Random(5);
        for _ in 0..2000 {
            let joints = rng.joints();
            let found = arm.solve(&arm.chain.pose(&joints));
            assert!(found.distance(&arm.chain, &joints) < SAME, "{name} {joints:?}");
            assert!(found.is_complete, "{name} {joints:?}");
        }
    }
}

#[test]
fn round_poses_lose_nothing() {
    for (name, arm) in arms() {
        let mut rng = Random(99);
        for degrees in [15.0, 30.0, 45.0, 90.0] {
            let step = radians::<f64>(degrees);
            for _ in 0..400 {
                let joints = rng.joints().map(|q| (q / step).round() * step);
                let found = arm.solve(&arm.chain.pose(&joints));
                assert!(!found.list.is_empty(), "{name} {joints:?}");
                let is_regular = least_singular_value(&arm.chain, &joints) > 1e-6;
                assert!(!is_regular || found.distance(&arm.chain, &joints) < SAME, "{name} {joints:?}");
            }
        }
    }
}

/// Arms of few lengths and angles at round poses: axes fall together there, and the elimination loses the joints of roots.
#[test]
fn round_poses_of_round_arms_lose_nothing() {
    let apart = Table {
        name: "apart",
        is_modified: true,
        rows: &[
            [0.0, 90.0, 0.5, 15.0],
            [0.0823, 180.0, 0.1, 0.0],
            [0.1, 90.0, 0.0, 90.0],
            [0.0, -90.0, 0.0, 90.0],
            [0.5, 90.0, 0.0, 90.0],
            [0.3, 0.0, 0.0, 90.0],
        ],
    };
    let flat = Table {
        name: "flat",
        is_modified: true,
        rows: &[
            [0.0, 90.0, 0.39225, 0.0],
            [0.0823, 90.0, -0.1, 0.0],
            [-0.5, 90.0, 0.0, 15.0],
            [-0.425, 180.0, 0.5, 15.0],
            [0.0, -90.0, 0.0, 30.0],
            [0.425, 0.0, 0.0, 0.0],
        ],
    };
    for table in [apart, flat] {
        let arm = Arm::of(&chain(&table, 0, 0.0)).unwrap();
        let (mut rng, mut regular) = (Random(99), 0);
        for degrees in [15.0, 30.0, 45.0, 90.0] {
            let step = radians::<f64>(degrees);
            for _ in 0..200 {
                let joints = rng.joints().map(|q| (q / step).round() * step);
                if least_singular_value(&arm.chain, &joints) < 0.01 {
                    continue;
                }
                regular += 1;
                let found = arm.solve(&arm.chain.pose(&joints));
                assert!(found.distance(&arm.chain, &joints) < SAME, "{} {joints:?}", table.name);
            }
        }
        assert!(regular > 400, "{}: {regular}", table.name);
    }
}

/// On made-up arms nothing is lost, and many starts find nothing more.
#[test]
fn random_arms_lose_nothing() {
    let mut rng = Random(2025);
    for number in 0..60 {
        let arm = Arm::of(&random_chain(&mut rng, [false; 6])).unwrap();
        for pose in 0..20 {
            let joints = rng.joints();
            let target = arm.chain.pose(&joints);
            let found = arm.solve(&target);
            assert!(found.distance(&arm.chain, &joints) < SAME, "{number} {joints:?}");
            assert!(found.residuals.iter().all(|residual| *residual < 1e-13));
            assert_eq!(found.list.len() % 2, 0, "{number} {joints:?}");
            if pose < 2 {
                for _ in 0..60 {
                    let start = rng.joints();
                    let end = arm.chain.refined(&start, &target, 40);
                    let is_new = end.residual < EXACT && found.distance(&arm.chain, &end.joints) > 1e-4;
                    assert!(!is_new, "{number} {joints:?} {end:?}");
                }
            }
        }
    }
}

#[test]
fn one_prismatic_joint_at_each_place_loses_nothing() {
    let mut rng = Random(7);
    for place in 0..6 {
        for number in 0..20 {
            let arm = Arm::of(&random_chain(&mut rng, core::array::from_fn(|joint| joint == place))).unwrap();
            for _ in 0..10 {
                let mut joints = rng.joints();
                joints[place] /= 3.0;
                let found = arm.solve(&arm.chain.pose(&joints));
                assert!(found.distance(&arm.chain, &joints) < SAME, "{place} {number} {joints:?}");
            }
        }
    }
}

/// With a joint given, the cuts serve for all of its values, and the constants of the call are those of the build.
#[test]
fn given_joints_lose_nothing() {
    let mut rng = Random(17);
    for name in SEVEN {
        for given in 0..7 {
            // Others have three axes that meet or are parallel.
            let Some(arm) = Arm::given(table(name), given, 0.0) else { continue };
            for _ in 0..40 {
                let arm = Arm { chain: chain(table(name), given, rng.angle()).gathered(), ..arm };
                let joints = rng.joints();
                let found = arm.solve_anew(&arm.chain.pose(&joints));
                assert!(found.distance(&arm.chain, &joints) < SAME, "{name} {given} {joints:?}");
            }
        }
    }
    let (_, arm) = arms().next().unwrap();
    let target = arm.chain.pose(&rng.joints());
    assert_eq!(arm.solve(&target).list, arm.solve_anew(&target).list);
}

/// Cuts whose constants are those of the arm have no polynomial here, as most links have no length. Those of the target have.
#[test]
fn links_without_length_lose_nothing() {
    for name in ["zero_lengths", "four_zero_lengths"] {
        let arm = Arm::of(&chain(table(name), 0, 0.0)).unwrap();
        assert!(arm.general.is_none() && arm.cuts.first.is_of_target(), "{name}");
        let mut rng = Random(31);
        for degrees in [0.0, 15.0, 45.0, 90.0] {
            let step = radians::<f64>(degrees);
            for _ in 0..300 {
                let joints = rng.joints().map(|q| if step > 0.0 { (q / step).round() * step } else { q });
                if least_singular_value(&arm.chain, &joints) < 1e-4 {
                    continue;
                }
                let found = arm.solve(&arm.chain.pose(&joints));
                assert!(found.distance(&arm.chain, &joints) < SAME, "{name} {joints:?}");
                assert!(found.is_complete || step > 0.0, "{name} {joints:?}");
            }
        }
    }
}

/// A joint's frame may stand anywhere on its axis.
#[test]
fn far_frames_give_the_same_list() {
    let near = Arm::of(&chain(table("gen6r_a"), 0, 0.0)).unwrap();
    let mut links = near.chain.links;
    for (joint, height) in [(1, 263.0), (2, -257.0), (4, -31.0)] {
        links[joint] = links[joint].then_slide(height);
        links[joint + 1] = shift([0.0, 0.0, -height]) * links[joint + 1];
    }
    let far = Arm::of(&Chain::new(links, [false; 6])).unwrap();
    assert!(far.chain.reach < 6.0);
    let mut rng = Random(3);
    for _ in 0..200 {
        let target = near.chain.pose(&rng.joints());
        let (a, b) = (near.solve(&target), far.solve(&target));
        assert_eq!(a.list.len(), b.list.len());
        assert!(a.list.iter().all(|joints| b.distance(&near.chain, joints) < 1e-9));
    }
}

/// The unit of length does not matter.
#[test]
fn millimeters_give_the_same_list() {
    let meters = Arm::of(&chain(table("gen6r_a"), 0, 0.0)).unwrap();
    let thousand = |x: &Transform<f64>| Transform { rotation: x.rotation, translation: x.translation.map(|t| 1e3 * t) };
    let millimeters = Arm::of(&Chain::new(meters.chain.links.each_ref().map(thousand), [false; 6])).unwrap();
    let mut rng = Random(4);
    for _ in 0..100 {
        let target = meters.chain.pose(&rng.joints());
        let (a, b) = (meters.solve(&target), millimeters.solve(&thousand(&target)));
        assert_eq!(a.list.len(), b.list.len());
        assert!(a.list.iter().all(|joints| b.distance(&meters.chain, joints) < 1e-9));
    }
}

fn candidates(arm: &Arm, target: &Transform<f64>) -> Vec<Candidate<f64>> {
    let mut list = Vec::new();
    let _ = arm.search(target, &[0.0; 6], &mut |candidate| {
        list.push(*candidate);
        Continue(())
    });
    list
}

#[test]
fn targets_that_are_not_poses_end() {
    for (name, arm) in arms() {
        let pose = arm.chain.pose(&[0.3, -0.8, 1.1, 2.0, -0.4, 0.7]);
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..12 {
                let mut target = pose;
                if place < 9 {
                    target.rotation[place / 3][place % 3] = value;
                } else {
                    target.translation[place - 9] = value;
                }
                assert!(candidates(&arm, &target).is_empty(), "{name} {value} {place}");
            }
        }
        for factor in [0.0, -1.0, 1e-300, 1e-8, 3.0, 1e8, 1e300] {
            let rotation = pose.rotation.map(|row| row.map(|x| factor * x));
            let targets = [
                Transform { rotation, ..pose },
                Transform { translation: pose.translation.map(|x| factor * x), ..pose },
                Transform { rotation: [[factor; 3]; 3], ..pose },
            ];
            for target in targets {
                assert!(candidates(&arm, &target).iter().all(Candidate::is_finite));
            }
        }
    }
}

/// With the last axis on the first one, joints 1 and 6 are free: the members of the family with the held joint at its
/// reference are listed.
#[test]
fn families_are_found_at_the_reference() {
    let mut rng = Random(11);
    for number in 0..20 {
        let mut chain = random_chain(&mut rng, [false; 6]);
        let mut joints = rng.joints();
        let before = Chain {
            links: {
                let mut l = chain.links;
                l[5] = Transform::IDENTITY;
                l[6] = Transform::IDENTITY;
                l
            },
            ..chain
        };
        let mut at_sixth = joints;
        at_sixth[5] = 0.0;
        // The sixth axis on the first one, at some height and angle.
        let place =
            Transform::IDENTITY.then_turn(denhart_core::math::sin_cos(rng.angle())).then_slide(rng.within(-0.5, 0.5));
        chain.links[5] = before.pose(&at_sixth).inverse() * place;
        let arm = Arm::of(&Chain::new(chain.links, [false; 6])).unwrap();
        let reference = rng.joints();
        let target = arm.chain.pose(&joints);
        let found = arm.solve_at(&target, &reference);
        assert!(!found.list.is_empty(), "{number}");
        // The family runs through the joint vector: joint 1 at a solution's value, joint 6 by the same turn back.
        let near = found.list.iter().any(|solution| {
            let turn = solution[0] - joints[0];
            let member = [solution[0], joints[1], joints[2], joints[3], joints[4], joints[5] - turn];
            apart(&arm.chain, &member, solution) < 1e-5
        });
        assert!(near, "{number} {joints:?} {:?}", found.list);
        if found.free & 0b10_0001 != 0 {
            let held = if found.free & 1 != 0 { 0 } else { 5 };
            let is_listed = found.list.iter().any(|x| denhart_core::math::wrap(x[held] - reference[held]).abs() < 1e-6);
            assert!(is_listed, "{number}");
        }
        joints[0] = 0.0;
    }
}

/// Just out of reach at a fold, candidates miss by little.
#[test]
fn folds_have_candidates_on_both_sides() {
    let arm = Arm::of(&chain(table("gen6r_a"), 0, 0.0)).unwrap();
    let mut rng = Random(23);
    let mut count = 0;
    for _ in 0..200 {
        // A sign change of the determinant along a line is a fold: by bisection of the least singular value's sign.
        let (a, b) = (rng.joints(), rng.joints());
        let at = |s: f64| core::array::from_fn(|i| a[i] + s * (b[i] - a[i]));
        let sign = |s: f64| determinant(&arm.chain, &at(s)) > 0.0;
        let (mut low, mut high) = (0.0, 0.2);
        if sign(low) == sign(high) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if sign(middle) == sign(low) { low = middle } else { high = middle }
        }
        count += 1;
        let joints = at(low);
        for push in [0.0, 1e-9, -1e-9] {
            let mut target = arm.chain.pose(&joints);
            target.translation[2] += push;
            let mut least = f64::INFINITY;
            for candidate in candidates(&arm, &target) {
                least = least.min(arm.chain.refined(&candidate.joints, &target, 30).residual);
            }
            assert!(least < 1e-8, "{joints:?} {push} {least}");
        }
    }
    assert!(count > 20, "{count}");
}

fn determinant(chain: &Chain<f64>, joints: &[f64; 6]) -> f64 {
    let mut m = chain.miss(joints, &chain.pose(joints)).jacobian;
    let mut product = 1.0;
    for k in 0..6 {
        let pivot = (k..6).max_by(|i, j| m[*i][k].abs().total_cmp(&m[*j][k].abs())).unwrap();
        if pivot != k {
            m.swap(pivot, k);
            product = -product;
        }
        product *= m[k][k];
        for i in k + 1..6 {
            let factor = m[i][k] / m[k][k];
            for j in k..6 {
                m[i][j] -= factor * m[k][j];
            }
        }
    }
    product
}

/// Calibrated tables of an arm with a closed form: small deviations break its families up.
#[test]
fn calibrated_arms_lose_nothing() {
    let mut rng = Random(29);
    for name in ["ur5", "puma560", "ufactory_xarm6", "kinova_jaco"] {
        for size in [1e-3, 1e-4] {
            let mut chain = chain(table(name), 0, 0.0);
            for link in &mut chain.links[1..6] {
                let [x, y, z] = [(); 3].map(|()| rng.within(-size, size));
                let turn = rx(rng.within(-size, size).to_degrees()).then_turn(denhart_core::math::sin_cos(x));
                *link = *link * turn * shift([x, y, z]);
            }
            let arm = Arm::of(&Chain::new(chain.links, [false; 6])).unwrap();
            for _ in 0..100 {
                let joints = rng.joints();
                let found = arm.solve(&arm.chain.pose(&joints));
                assert!(found.distance(&arm.chain, &joints) < SAME, "{name} {size} {joints:?}");
            }
        }
    }
}

#[test]
fn the_choice_is_repeatable() {
    let chain = chain(table("gen6r_a"), 0, 0.0).gathered();
    let choose = || denhart_core::choice::choose(&chain).unwrap();
    assert_eq!(choose(), choose());
}
