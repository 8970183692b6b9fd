//! Further runs of the cascade keep to their bound, where nothing is to be found and where something is.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::Pose;
use denhart::effort::{Effort, MOST_CASCADES, MOST_EVALUATIONS, effort_of};
use denhart_tests::arms::{KukaIiwa7R800, Ur5};
use denhart_tests::random::Random;

fn is_bounded(Effort { cascades, evaluations, .. }: Effort) {
    assert!(cascades <= MOST_CASCADES && evaluations <= MOST_EVALUATIONS, "{cascades} {evaluations}");
}

/// Several singularities meet, and the target is moved out of reach.
#[test]
fn a_target_just_out_of_reach_has_no_solution() {
    let target = Pose {
        rotation: [
            [1.0, -5.7654238817580144e-12, 8.060303044967118e-14],
            [8.060303048444293e-14, 6.031083606801433e-12, -1.0],
            [5.765423881757528e-12, 1.0, 6.0310836068018975e-12],
        ],
        translation: [-0.9119000000006454, 0.026849999994291194, 0.08915900000860194],
    };
    let (solutions, effort) = effort_of(|| Ur5.inverse(&target));
    assert_eq!(solutions.exact().count(), 0, "{solutions:?}");
    is_bounded(effort);
}

/// Joints 1 and 2 are free, and the target is out of reach.
#[test]
fn two_free_joints_end_as_well() {
    let target = Pose {
        rotation: [
            [-1.0, 3.873392968711894e-10, -3.4611904222896984e-10],
            [-3.461190422395022e-10, -2.7191547088535445e-11, 1.0],
            [3.873392968617779e-10, 1.0, 2.719154722260095e-11],
        ],
        translation: [4.961787674656226e-10, 125.99999999972127, 340.0000000002756],
    };
    let (solutions, effort) = effort_of(|| KukaIiwa7R800.inverse(&target, FRAC_PI_2));
    assert_eq!(solutions.exact().count(), 0, "{solutions:?}");
    is_bounded(effort);
}

/// The wrist is straight, and with joint 6 at 0 the elbow does not reach. A joint vector at a right angle from there
/// stretches the elbow: the target has no other place of joint 6 beside it.
#[test]
fn a_straight_wrist_behind_a_stretched_elbow_is_found() {
    for q6 in [0.3, FRAC_PI_2, 2.5, -2.0] {
        let q = [0.4, -0.9, 0.0, 0.7, 0.0, q6];
        let (solutions, effort) = effort_of(|| Ur5.inverse(&Ur5.forward(&q)));
        assert!(solutions.exact().count() > 0, "{q6}: {solutions:?}");
        is_bounded(effort);
    }
}

/// The wrist's center is on the cylinder about axis 1 that bounds where it can be, and then inside by less than the
/// tolerance. The wrist is straight, and the elbow may reach with other places of joint 6 alone.
#[test]
fn a_target_within_the_tolerance_has_a_solution_behind_a_free_joint() {
    let [a2, a3, d4, d5, d6]: [f64; 5] = [-0.425, -0.39225, 0.10915, 0.09465, 0.0823];
    let mut random = Random::named("within the tolerance");
    let mut again = 0;
    for push in [1e-10, 1e-8, 5e-7] {
        for _ in 0..2000 {
            let [q1, q2, q3, q6] = std::array::from_fn(|_| random.uniform(-3.1, 3.1));
            let sine = -(a2 * f64::cos(q2) + a3 * f64::cos(q2 + q3)) / d5;
            if sine.abs() > 1.0 {
                continue;
            }
            let pitch = random.pick(&[sine.asin(), PI - sine.asin()]);
            let q = [q1, q2, q3, pitch - q2 - q3, random.pick(&[0.0, PI]), q6];
            let mut target = Ur5.forward(&q);
            let center: [f64; 2] = std::array::from_fn(|k| target.translation[k] - d6 * target.rotation[k][2]);
            let radius = center[0].hypot(center[1]);
            assert!((radius - d4).abs() < 1e-12, "{q:?}: {radius}");
            for (coordinate, away) in target.translation.iter_mut().zip(center) {
                *coordinate -= push * away / radius;
            }
            let (solutions, effort) = effort_of(|| Ur5.inverse(&target));
            assert!(!solutions.is_empty(), "{push:e} {q:?}: {:?}", solutions.status());
            is_bounded(effort);
            again += usize::from(effort.cascades > 1);
            for (solution, off) in solutions.iter().zip(solutions.verify(&Ur5, &target)) {
                let most = if solution.is_exact() { 1e-12 } else { 1e-6 };
                assert!(off.position <= most && off.orientation <= most, "{push:e} {solution:?} {off}");
            }
            assert!(!Ur5.inverse_near(&target, &q).is_empty(), "{push:e} {q:?}");
        }
    }
    assert!(again > 40, "{again}");
}
