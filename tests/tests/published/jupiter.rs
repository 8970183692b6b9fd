//! Shalash et al. 2024, "position and orientation analysis of the Jupiter robot arm": lengths in cm.

use std::f64::consts::PI;

use denhart::numeric::Task;
use denhart::{Arm, Flags, PointAngle, Pose};
use serde::Deserialize;

use crate::agreement::Both;
use crate::tables::{apart, off, radians, rows, same_solutions};

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/jupiter.yaml")]
struct Jupiter;

/// The arm with its last link, which the paper never gives, bound at run time.
#[derive(Clone, Copy, Arm)]
#[arm(yaml = "
    name: jupiter
    convention: modified
    units: {length: cm, angle: deg}
    parameters: {l4: 6}
    inverse: {task: position_angle}
    joints:
      - {a: 0, alpha: 0, d: 4, theta: 0}
      - {a: 0, alpha: -90, d: 0, theta: 0}
      - {a: 10, alpha: 0, d: 0, theta: 0}
      - {a: 10, alpha: 0, d: 0, theta: 0}
      - {type: fixed, a: l4, alpha: 0, d: 0, theta: 0}
")]
struct WithTool {
    l4: f64,
}

/// Rounding of a reach of 24 cm, with room for a dozen operations.
const ROUNDING: f64 = 1e-13;

#[derive(Deserialize)]
struct Validation {
    point: [f64; 3],
    paper_angles: PaperAngles,
    dh_q_deg: [f64; 4],
    /// Base, shoulder, elbow, degrees.
    all_solutions_geometric_deg: [[f64; 3]; 4],
    fk: [f64; 3],
    fk_all: [[f64; 3]; 4],
}

#[derive(Deserialize)]
struct PaperAngles {
    base_theta4: f64,
    shoulder_theta1: f64,
    elbow_theta2: f64,
}

fn validation() -> Validation {
    rows("jupiter_validation").pop().unwrap()
}

/// The joint vector at the paper's angles: pitch joints count the other way round, and joint 4 makes up the sum `angle`.
fn joints([base, shoulder, elbow]: [f64; 3], angle: f64) -> [f64; 4] {
    [base, -shoulder, -elbow, angle + shoulder + elbow]
}

#[test]
fn the_validation_point() {
    let Validation { point, paper_angles: paper, dh_q_deg, fk, .. } = validation();
    assert_eq!(point, [10.0, 0.0, 14.0]);
    assert_eq!(joints([paper.base_theta4, paper.shoulder_theta1, paper.elbow_theta2], -90.0), dh_q_deg);
    let tool = Jupiter.forward(&radians(dh_q_deg)).translation;
    assert!(off(&tool, &point) < ROUNDING && off(&tool, &fk) < ROUNDING, "{tool:?}");
}

/// The paper gives one of the four solutions.
#[test]
fn all_four_solutions() {
    let Validation { point, all_solutions_geometric_deg: paper, fk_all, .. } = validation();
    // Whatever the tool's angle in the plane is to be: joint 4 makes it up.
    for degrees in [-90.0, 0.0, 37.0, 180.0] {
        let expected = paper.map(|angles| radians(joints(angles, degrees)));
        let target = PointAngle::new(point, degrees.to_radians());
        let solutions = Jupiter.inverse(&target);
        assert!(solutions.iter().all(|s| s.is_exact() && !s.flags.contains(Flags::BOUNDARY)), "{solutions:?}");
        let found: Vec<_> = solutions.iter().map(|solution| solution.q).collect();
        // 1e-12 of reach, the bound of EXACT, over the elbow's amplitude, which is 1 here.
        same_solutions(&found, &expected, 1e-11);
        for (q, fk) in expected.iter().zip(fk_all) {
            assert!(off(&Jupiter.forward(q).translation, &fk) < ROUNDING);
        }
    }
    // The one of the paper, from where the paper starts.
    let target = PointAngle::new(point, -PI / 2.0);
    let nearest = Jupiter.inverse_near(&target, &[0.0; 4]);
    assert!(apart(&nearest[0].q, &radians([0.0, 0.0, -90.0, 0.0])) < 1e-11, "{nearest:?}");
}

/// The product of the rows `[a, alpha, d, theta]` by equation (1), modified DH, with what stands in the place of `a`.
fn by_equation_1(rows: &[[f64; 4]], in_place_of_a: impl Fn(f64, f64) -> f64) -> Pose<f64> {
    rows.iter().fold(Pose::identity(), |pose, &[a, alpha, d, theta]| {
        let ((sa, ca), (s, c)) = (alpha.sin_cos(), theta.sin_cos());
        let rotation = [[c, -s, 0.0], [s * ca, c * ca, -sa], [s * sa, c * sa, ca]];
        pose * Pose { rotation, translation: [in_place_of_a(a, alpha), -sa * d, ca * d] }
    })
}

/// Printed: alpha at the place of a. True: a. With alpha there the links have no length: the tool stays at the shoulder.
#[test]
fn misprint_equation_1_has_alpha_in_place_of_a() {
    let down = -PI / 2.0;
    let table = [[0.0, 0.0, 4.0, 0.0], [0.0, down, 0.0, 0.0], [10.0, 0.0, 0.0, down], [10.0, 0.0, 0.0, 0.0]];
    let printed = by_equation_1(&table, |_, alpha| alpha).translation;
    let mended = by_equation_1(&table, |a, _| a).translation;
    assert!(off(&printed, &[down, 0.0, 4.0]) < ROUNDING, "{printed:?}");
    assert!(off(&mended, &[10.0, 0.0, 14.0]) < ROUNDING, "{mended:?}");
}

/// Printed: elbow +90 degrees. True in the DH table: -90, since alpha_1 = -90 makes positive joints pitch down.
#[test]
fn misprint_the_paper_counts_pitch_upward() {
    let printed = Jupiter.forward(&radians([0.0, 0.0, 90.0, 0.0])).translation;
    let mended = Jupiter.forward(&radians([0.0, 0.0, -90.0, 0.0])).translation;
    assert!(off(&printed, &[10.0, 0.0, -6.0]) < ROUNDING, "{printed:?}");
    assert!(off(&mended, &[10.0, 0.0, 14.0]) < ROUNDING, "{mended:?}");
}

/// Printed: none, L4 is never given. True for the validation point: 0, since (10, 0, 14) is the wrist; a tool goes beyond.
#[test]
fn misprint_the_last_link_has_no_length() {
    let q = radians(validation().dh_q_deg);
    for l4 in [0.0, 2.5, 6.0] {
        let arm = WithTool { l4 };
        let point = [10.0, 0.0, 14.0 + l4];
        assert!(off(&arm.forward(&q).translation, &point) < ROUNDING, "{l4}");
        let found: Vec<_> = arm.inverse(&PointAngle::new(point, -PI / 2.0)).iter().map(|s| s.q).collect();
        let expected = validation().all_solutions_geometric_deg.map(|angles| radians(joints(angles, -90.0)));
        same_solutions(&found[..], &expected, 1e-11);
    }
}

#[test]
fn closed_form_and_iteration_agree() {
    let closed = |target: PointAngle<f64>| Jupiter.inverse(&target).iter().map(|s| s.q).collect::<Vec<_>>();
    let target = |q: &[f64; 4]| PointAngle::new(Jupiter.forward(q).translation, q[1] + q[2] + q[3]);
    // The whole pose fixes the yaw too: of the four solutions two.
    let poses = Both { arm: Jupiter, task: Task::Pose, length: 24.0 };
    poses.agree("jupiter, pose", |arm, q| {
        let same_turn = |found: &[f64; 4]| arm.forward(found).residual(&arm.forward(q)).orientation < 1e-9;
        closed(target(q)).into_iter().filter(same_turn).collect()
    });
    // Seen from behind, with the yaw half a turn on, the tool's direction is at the supplement of the angle.
    let axes = Both { arm: Jupiter, task: Task::PositionAxis([1.0, 0.0, 0.0]), length: 24.0 };
    axes.agree("jupiter, axis", |arm, q| {
        let PointAngle { point, angle } = target(q);
        let direction = |q: &[f64; 4]| arm.forward(q).rotation.map(|row| row[0]);
        let both = [PointAngle::new(point, angle), PointAngle::new(point, PI - angle)].map(closed).concat();
        both.into_iter().filter(|found| off(&direction(found), &direction(q)) < 1e-9).collect()
    });
}
