//! Nguyen, Pham and Chi 2023, forward kinematics of the Denso VS-6556: lengths in mm.

use denhart::numeric::Task;
use denhart::{Arm, Chain, Pose};
use serde::Deserialize;

use crate::agreement::Both;
use crate::tables::{apart, off, radians, rows};

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/denso_vs6556.yaml")]
struct Denso;

/// Sum of `|a| + |d|`.
const REACH: f64 = 1145.0;
/// Rounding of the reach, with room for two dozen operations.
const ROUNDING: f64 = 1e-12;
/// Table 2 has seven decimals, of which the last is off by up to four.
const PRINTED: f64 = 5e-7;

/// A row of Table 2: s, degrees, mm.
#[derive(Deserialize)]
struct Row {
    t: f64,
    q_deg: [f64; 6],
    #[serde(rename = "X")]
    x: f64,
    #[serde(rename = "Y")]
    y: f64,
    #[serde(rename = "Z")]
    z: f64,
    #[serde(rename = "R")]
    rotation: [[f64; 3]; 3],
}

fn table_2() -> Vec<Row> {
    rows("denso_vs6556_trajectory")
}

/// The motion law (23) at `t` s: joint values, rad.
fn law(t: f64) -> [f64; 6] {
    radians([3.0 * t, -90.0 + 3.0 * t, 90.0 + 3.0 * t, 3.0 * t, 3.0 * t, 3.0 * t])
}

#[test]
fn table_2_eleven_positions() {
    let table = table_2();
    assert_eq!(table.len(), 11);
    for Row { t, q_deg, x, y, z, rotation } in table {
        assert!(apart(&law(t), &radians(q_deg)) < 1e-15);
        let tool = Denso.forward(&law(t));
        assert!(off(&tool.translation, &[x, y, z]) < PRINTED, "t = {t}: {tool}");
        // The table has them in double precision.
        assert!(off(&tool.translation, &[x, y, z]) < ROUNDING, "t = {t}: {tool}");
        for (found, expected) in tool.rotation.iter().zip(&rotation) {
            assert!(off(found, expected) < 1e-14, "t = {t}: {tool}");
        }
    }
}

/// The inverse leads from the eleven poses back to the motion law, and its other branches to the same poses.
#[test]
fn the_inverse_leads_back_to_the_law() {
    for Row { t, .. } in table_2() {
        let target = Denso.forward(&law(t));
        let near = Denso.inverse_near(&target, &law(t));
        // 1e-12 over the wrist's amplitude, which is at least sin 3 degrees; straight, at t = 0, it stays where it is.
        assert!(apart(&near.nearest().unwrap().q, &law(t)) < 1e-10, "t = {t}: {near:?}");
        let solutions = Denso.inverse(&target);
        assert!(solutions.iter().all(|solution| solution.is_exact()), "t = {t}: {solutions:?}");
        for residual in solutions.verify(&Denso, &target) {
            assert!(residual.position < 1e-12 * REACH && residual.orientation < 1e-12, "t = {t}: {residual}");
        }
        for (k, a) in solutions.iter().enumerate() {
            assert!(solutions.iter().skip(k + 1).all(|b| apart(&a.q, &b.q) > 1e-3), "t = {t}: {solutions:?}");
        }
    }
}

/// Velocity and acceleration of the tool under the law. Both are held beside those of the chain, which shares no code
/// with them. Both are also held beside differences of the positions of the table, as near as steps of 1 s come.
#[test]
fn velocity_and_acceleration_along_the_motion() {
    let (rates, rest) = ([3.0_f64.to_radians(); 6], [0.0; 6]);
    let chain = Chain::from(Denso::DH);
    for t in 0..=10 {
        let q = law(f64::from(t));
        let (velocity, acceleration) = (Denso.velocity(&q, &rates), Denso.acceleration(&q, &rates, &rest));
        let (v, a) = (chain.velocity(&q, &rates).unwrap(), chain.acceleration(&q, &rates, &rest).unwrap());
        assert!(off(&velocity.to_array(), &v.to_array()) < ROUNDING, "t = {t}");
        assert!(off(&acceleration.to_array(), &a.to_array()) < ROUNDING, "t = {t}");
        // The tool is on the last link.
        let (link_v, link_a) = (Denso.link_velocities(&q, &rates)[5], Denso.link_accelerations(&q, &rates, &rest)[5]);
        assert!(off(&link_v.to_array(), &velocity.to_array()) < ROUNDING, "t = {t}");
        assert!(off(&link_a.to_array(), &acceleration.to_array()) < ROUNDING, "t = {t}");
    }
    let table = table_2();
    for rows in table.windows(3) {
        let [before, here, after] = [&rows[0], &rows[1], &rows[2]].map(|row| [row.x, row.y, row.z]);
        let q = law(rows[1].t);
        let velocity = Denso.velocity(&q, &rates).linear;
        let acceleration = Denso.acceleration(&q, &rates, &rest).linear;
        // With angles up to 6 at a rate w = 3 degrees/s, a position of reach r has derivatives up to r (6 w)^n.
        let bound = |order: i32| REACH * (6.0 * rates[0]).powi(order);
        for axis in 0..3 {
            let first = 0.5 * (after[axis] - before[axis]);
            let second = after[axis] - 2.0 * here[axis] + before[axis];
            assert!((first - velocity[axis]).abs() < bound(3) / 6.0, "t = {}", rows[1].t);
            assert!((second - acceleration[axis]).abs() < bound(4) / 12.0, "t = {}", rows[1].t);
        }
    }
}

/// The transform of row `row`, counted from 1, by the poses of the links.
fn row(row: usize, q: &[f64; 6]) -> Pose<f64> {
    let links = Denso.link_poses(q);
    if row == 1 { links[0] } else { links[row - 2].inverse() * links[row - 1] }
}

/// Printed in (5): 1T2 and 2T3 with another translation. True: the link of Table 1 in the direction its joint turns to.
#[test]
fn misprint_equation_5_translates_1t2_and_2t3_wrongly() {
    for t in 0..=10 {
        let q = law(f64::from(t));
        let along = |a: f64, angle: f64| [a * angle.cos(), a * angle.sin(), 0.0];
        assert!(off(&row(2, &q).translation, &along(270.0, q[1])) < ROUNDING);
        // Row 3 has an offset of -90 degrees.
        assert!(off(&row(3, &q).translation, &along(90.0, q[2] - 90.0_f64.to_radians())) < ROUNDING);
    }
}

/// Printed in (5): an improper 5T6. True: rows (-c, 0, -s), (-s, 0, c), (0, 1, 0), determinant +1, as every rotation has.
#[test]
fn misprint_equation_5_has_an_improper_5t6() {
    for t in 0..=10 {
        let q = law(f64::from(t));
        let (s, c) = q[5].sin_cos();
        let Pose { rotation, translation } = row(6, &q);
        for (found, expected) in rotation.iter().zip(&[[-c, 0.0, -s], [-s, 0.0, c], [0.0, 1.0, 0.0]]) {
            assert!(off(found, expected) < 1e-14, "{rotation:?}");
        }
        assert!((nalgebra::Matrix3::from(rotation).determinant() - 1.0).abs() < 1e-14);
        assert!(off(&translation, &[0.0, 0.0, -80.0]) < ROUNDING, "{translation:?}");
    }
}

/// The rest pose, (450, 0, 695), needs q2 = -90 degrees (and q3 = 90), not zeros: with zeros the arm lies stretched ahead.
#[test]
fn misprint_the_rest_pose_is_not_at_zeros() {
    let rest = Denso.forward(&law(0.0)).translation;
    assert!(off(&rest, &[450.0, 0.0, 695.0]) < ROUNDING, "{rest:?}");
    let zeros = Denso.forward(&[0.0; 6]).translation;
    assert!(off(&zeros, &[75.0 + 270.0 + 295.0 + 80.0, 0.0, 335.0 + 90.0]) < ROUNDING, "{zeros:?}");
}

#[test]
fn closed_form_and_iteration_agree() {
    let both = Both { arm: Denso, task: Task::Pose, length: REACH };
    both.agree("denso", |arm, q| arm.inverse(&arm.forward(q)).iter().map(|solution| solution.q).collect());
}
