//! Salman, Hamzah and Bakhy, a stepper-driven arm with three joints in MATLAB: lengths in mm.

use denhart::numeric::Task;
use denhart::{Arm, Elbow, JointMask, Shoulder};
use serde::Deserialize;

use crate::agreement::Both;
use crate::tables::{apart, half_digit, off, radians, rows, same_solutions};

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/salman_rrr.yaml")]
struct Salman;

/// Table 1 as it is printed.
#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/salman_rrr_table1.yaml")]
struct Printed;

/// Rounding of a reach of 645 mm, with room for a dozen operations.
const ROUNDING: f64 = 2e-12;

/// A row of Table 4: degrees, mm.
#[derive(Deserialize)]
struct Forward {
    q_deg: [f64; 3],
    theoretical: [f64; 3],
    pulses_from_home: [i32; 3],
    q_actual_deg: [f64; 3],
    actual: [f64; 3],
    absdiff: [f64; 3],
}

/// A row of Table 5: degrees, mm.
#[derive(Deserialize)]
struct Inverse {
    case: String,
    q_deg: [f64; 3],
    within_table3_limits: bool,
    pulses_from_home: [i32; 3],
    q_actual_deg: [f64; 3],
    offset_deg: [f64; 3],
    fk_check: [f64; 3],
}

/// Where the target of Table 5 is.
const TARGET: [f64; 3] = [390.0, 80.0, 300.0];

/// Table 5 as it is printed: the paper's name of the branch, degrees.
const TABLE_5: [(&str, [f64; 3]); 4] = [
    ("left elbow up", [10.1529, 44.6560, -46.5354]),
    ("left elbow down", [10.1529, -8.4781, 46.5354]),
    ("right elbow up", [-166.9685, 135.3440, 46.5354]),
    ("right elbow down", [-166.9685, -171.5219, -46.5354]),
];

/// Equations (8) to (10): the tool's position, written out.
fn equations_8_to_10([q1, q2, q3]: [f64; 3]) -> [f64; 3] {
    let reach = 197.0 * q2.cos() + 258.0 * (q2 + q3).cos();
    let height = 170.0 + 197.0 * q2.sin() + 258.0 * (q2 + q3).sin();
    [reach * q1.cos() - 10.0 * q1.sin(), reach * q1.sin() + 10.0 * q1.cos(), height]
}

#[test]
fn table_4_forward_and_pulses() {
    let table: Vec<Forward> = rows("salman_rrr_forward_pulses");
    assert_eq!(table.len(), 2);
    for row in table {
        let q = radians(row.q_deg);
        let tool = Salman.forward(&q).translation;
        assert!(off(&tool, &row.theoretical) < ROUNDING && off(&tool, &equations_8_to_10(q)) < ROUNDING, "{tool:?}");
        assert_eq!(Salman.to_pulses(&q), row.pulses_from_home);
        let end = Salman.quantized_error(&q);
        assert_eq!((end.pulses, end.saturated), (row.pulses_from_home, JointMask::NONE));
        assert!(off(&end.q, &radians(row.q_actual_deg)) < 1e-14, "{:?}", end.q);
        let reached = end.pose.translation;
        assert!(off(&reached, &row.actual) < ROUNDING, "{reached:?}");
        let difference: [f64; 3] = std::array::from_fn(|axis| (reached[axis] - tool[axis]).abs());
        assert!(off(&difference, &row.absdiff) < 2.0 * ROUNDING, "{difference:?}");
    }
}

/// Case 2 as it is printed, to four decimals: theory, and where the steppers leave the tool.
#[test]
fn table_4_to_the_digits_printed() {
    let q = radians([-30.0, 5.0, -5.0]);
    assert!(off(&Salman.forward(&q).translation, &[398.3923, -218.4649, 187.1697]) <= half_digit(4));
    assert!(off(&Salman.quantized_error(&q).pose.translation, &[398.3570, -218.5304, 187.1793]) <= half_digit(4));
}

/// Case 1 needs q = (0, 90, -90): the position of the table, on zero pulses, and the only way to it within the limits.
#[test]
fn misprint_table_4_case_1_is_the_home_position() {
    let (point, home) = ([258.0, 10.0, 367.0], radians([0.0, 90.0, -90.0]));
    assert!(off(&Salman.forward(&home).translation, &point) < ROUNDING);
    assert_eq!(Salman.to_pulses(&home), [0; 3]);
    // Zeros, as joint values, are the stretched arm.
    assert!(off(&Salman.forward(&[0.0; 3]).translation, &[455.0, 10.0, 170.0]) < ROUNDING);
    let solutions = Salman.inverse(&point);
    assert_eq!(solutions.exact().count(), 4);
    let within: Vec<_> = solutions.within_limits().map(|solution| solution.q).collect();
    assert!(within.iter().any(|q| apart(q, &home) < 1e-11), "{solutions:?}");
}

#[test]
fn table_5_four_branches_limits_and_pulses() {
    let table: Vec<Inverse> = rows("salman_rrr_inverse");
    let solutions = Salman.inverse(&TARGET);
    assert!(solutions.iter().all(|solution| solution.is_exact()), "{solutions:?}");
    let found: Vec<_> = solutions.iter().map(|solution| solution.q).collect();
    let expected: Vec<_> = table.iter().map(|row| radians(row.q_deg)).collect();
    // 1e-12 of reach, the bound of EXACT, over the elbow's amplitude of 0.7.
    same_solutions(&found, &expected, 1e-11);
    for row in &table {
        let (_, printed) = TABLE_5.iter().find(|(case, _)| *case == row.case).unwrap();
        let solution = solutions.iter().find(|solution| apart(&solution.q, &radians(row.q_deg)) < 1e-11).unwrap();
        assert!(off(&solution.q.map(f64::to_degrees), printed) <= half_digit(4), "{}: {solution}", row.case);
        assert_eq!(solution.is_within_limits(), row.within_table3_limits, "{}: {solution}", row.case);
        assert!(off(&Salman.forward(&solution.q).translation, &row.fk_check) < ROUNDING && row.fk_check == TARGET);
        let end = Salman.quantized_error(&solution.q);
        assert_eq!(end.pulses, row.pulses_from_home, "{}", row.case);
        assert!(off(&end.q, &radians(row.q_actual_deg)) < 1e-14, "{}", row.case);
        let offset: [f64; 3] = std::array::from_fn(|joint| (end.q[joint] - solution.q[joint]).abs().to_degrees());
        // Rounding of the closed form, in degrees.
        assert!(off(&offset, &row.offset_deg) < 1e-11, "{}: {offset:?}", row.case);
    }
}

/// In the paper, left is the arm that faces the target. Up is the elbow above the line from the shoulder to the tool.
/// The names of denhart are those of roots. The root that faces the target is the second one, right. Up is a positive
/// joint 3.
#[test]
fn names_of_the_branches() {
    let solutions = Salman.inverse(&TARGET);
    for (case, degrees) in TABLE_5 {
        let solution = solutions.iter().find(|solution| apart(&solution.q, &radians(degrees)) < 2e-6).unwrap();
        let side = if case.starts_with("left") { Shoulder::Right } else { Shoulder::Left };
        assert_eq!(solution.branch.shoulder(), Some(side), "{case}: {solution}");
        let elbow = if degrees[2] > 0.0 { Elbow::Up } else { Elbow::Down };
        assert_eq!(solution.branch.elbow(), Some(elbow), "{case}: {solution}");
        // The elbow's height over the line, by the paper's name.
        let [_, elbow_point, tool] = [0, 1, 2].map(|link| Salman.link_poses(&solution.q)[link].translation);
        let [along, up] = [f64::hypot(elbow_point[0], elbow_point[1]), elbow_point[2] - 170.0];
        let slope = (tool[2] - 170.0) / f64::hypot(tool[0], tool[1]);
        let forward = elbow_point[0] * tool[0] + elbow_point[1] * tool[1] > 0.0;
        let above = up > slope * if forward { along } else { -along };
        assert_eq!(case.ends_with("up"), above, "{case}");
    }
}

/// Printed: alpha_1 = -90, d_2 = 10. True: +90 and -10, by which equations (8) to (10) and Tables 4 and 5 come out. As
/// printed the arm pitches the other way: the same arm with joints 2 and 3 negated.
#[test]
fn misprint_table_1_pitches_the_other_way() {
    let q = radians([-30.0, 5.0, -5.0]);
    let printed = Printed.forward(&q).translation;
    assert!(off(&printed, &Salman.forward(&radians([-30.0, -5.0, 5.0])).translation) < ROUNDING, "{printed:?}");
    assert!(off(&printed, &[398.3923, -218.4649, 152.8303]) <= half_digit(4), "{printed:?}");
}

/// Printed: a left-handed T01. True: rows (cos, 0, sin), (sin, 0, -cos), (0, 1, 0), determinant +1, as every rotation has.
#[test]
fn misprint_t01_is_left_handed() {
    for q1 in [-2.0_f64, -0.3, 0.0, 1.1] {
        // The first row ends after joint 1.
        let first = Salman.link_poses(&[q1, 0.4, -0.7])[0];
        let (s, c) = q1.sin_cos();
        assert!(
            off(first.rotation.as_flattened().first_chunk::<9>().unwrap(), &[c, 0.0, s, s, 0.0, -c, 0.0, 1.0, 0.0])
                < 1e-15
        );
        assert_eq!(first.translation, [0.0, 0.0, 170.0]);
        let [x, y, z] = [0, 1, 2].map(|column| nalgebra::Vector3::from(first.rotation.map(|row| row[column])));
        assert!((x.cross(&y) - z).norm() < 1e-15);
    }
}

#[test]
fn closed_form_and_iteration_agree() {
    let both = Both { arm: Salman, task: Task::POSITION, length: 645.0 };
    both.agree("salman", |arm, q| arm.inverse(&arm.forward(q).translation).iter().map(|s| s.q).collect());
}
