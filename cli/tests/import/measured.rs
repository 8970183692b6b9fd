//! Calibrations of UR arms and OPW parameters as arm files.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::{run, text};

fn file(name: &str, content: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, content).unwrap();
    path.display().to_string()
}

/// The place of the tool of an arm file at joint values, deg.
fn position(arm: &str, name: &str, q: &str) -> Vec<f64> {
    let output = run(&["forward", &file(name, arm), "--q", q, "--json"]);
    let value: Value = serde_json::from_slice(&output.stdout).unwrap();
    value["pose"]["position"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn near(found: &[f64], expected: [f64; 3]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}, not {expected:?}");
}

const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];

#[test]
fn a_calibration_of_a_driver_is_an_arm_file() {
    // Links that turn little add up their lengths at zero.
    let mut yaml = "kinematics:\n".to_owned();
    for (number, link) in LINKS.iter().enumerate() {
        yaml +=
            &format!("  {link}: {{x: 0.{number}1, y: 0, z: 0.1, roll: 0, pitch: 0, yaw: {}}}\n", 1e-5 * number as f64);
    }
    yaml += "  hash: calib_1\n";
    let path = file("ur_calibration.yaml", &yaml);
    let output = run(&["import", "--ur-calibration", &path]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    // Nothing advises to round what was measured.
    assert!(!text(&output.stderr).contains("--exact-within"), "{}", text(&output.stderr));
    let mut expected = [0.0, 0.0, 0.0];
    let mut turn = 0.0_f64;
    for number in 0..6 {
        let x = 0.1 * f64::from(number) + 0.01;
        expected = [expected[0] + x * turn.cos(), expected[1] + x * turn.sin(), expected[2] + 0.1];
        turn += 1e-5 * f64::from(number);
    }
    near(&position(&text(&output.stdout), "ur_measured.yaml", "0 0 0 0 0 0"), expected);
    let missing = run(&[
        "import",
        "--ur-calibration",
        &file("ur_short.yaml", &yaml.replace("  hash: calib_1\n", "").replace("wrist_3", "hash")),
    ]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(text(&missing.stderr).contains("the link `wrist_3` is missing"), "{}", text(&missing.stderr));
}

#[test]
fn a_calibration_of_a_controller_goes_into_the_makers_table() {
    let six = "[ 1e-05, 2e-05, 0, 0, 0, 0 ]";
    let conf = format!("[mounting]\ndelta_theta = {six}\ndelta_a = {six}\ndelta_d = {six}\ndelta_alpha = {six}\n");
    let nominal = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5e.yaml").display().to_string();
    let path = file("calibration.conf", &conf);
    let output = run(&["import", "--ur-calibration", &path, "--nominal", &nominal]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let arm = text(&output.stdout);
    assert!(
        arm.contains("calibration:\n  q1: {a: 0.00001, alpha: 0.00001 rad, d: 0.00001, theta: 0.00001 rad}\n"),
        "{arm}"
    );
    let checked = run(&["check", &file("ur5e_measured.yaml", &arm)]);
    let said = text(&checked.stdout);
    assert!(said.contains("calibrated: links are up to ") && said.contains("  q2: a +0.00002 m"), "{said}");
    let alone = run(&["import", "--ur-calibration", &path]);
    assert!(text(&alone.stderr).contains("--nominal ARM"), "{}", text(&alone.stderr));
}

#[test]
fn opw_parameters_are_an_arm_file() {
    let opw = "opw_kinematics_geometric_parameters: {a1: 0.1, a2: -0.135, b: 0.02, c1: 0.615, c2: 0.705, c3: 0.755, c4: 0.085}\n";
    let output = run(&["import", "--opw", &file("opw.yaml", opw)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let arm = text(&output.stdout);
    near(&position(&arm, "opw_arm.yaml", "0 0 0 0 0 0"), [0.1 - 0.135, 0.02, 0.615 + 0.705 + 0.755 + 0.085]);
    // Joint 2 turns the upper arm forward: what was up is along x.
    near(&position(&arm, "opw_arm.yaml", "0 90 0 0 0 0"), [0.1 + 0.705 + 0.755 + 0.085, 0.02, 0.615 + 0.135]);
    // An offset is taken off, a sign turns the joint.
    let turned = format!(
        "{opw}opw_kinematics_joint_offsets: [0, deg(-90), 0, 0, 0, 0]\nopw_kinematics_joint_sign_corrections: [1, -1, 1, 1, 1, 1]\n"
    );
    let output = run(&["import", "--opw", &file("opw_turned.yaml", &turned)]);
    let arm = text(&output.stdout);
    near(&position(&arm, "opw_turned_arm.yaml", "0 90 0 0 0 0"), [0.1 - 0.135, 0.02, 0.615 + 0.705 + 0.755 + 0.085]);
}
