//! `denhart import` on the URDF kinematics of real robots.
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use poses::{by_name, joints, model, random, table_pose, urdf_pose, worst};

mod inverse;
mod made_up;
mod measured;
mod poses;
mod tools;

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_denhart")).args(arguments).output().unwrap()
}

fn urdf(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf").join(name).with_extension("urdf")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The arm file of a chain, and what was said.
fn import(name: &str, arguments: &[&str]) -> (String, String) {
    let path = urdf(name);
    let output = run(&[&["import", path.to_str().unwrap()], arguments].concat());
    assert!(output.status.success(), "{name}: {}", text(&output.stderr));
    (text(&output.stdout), text(&output.stderr))
}

/// Imports the text of a URDF, from a file of its own.
fn written(urdf: &str, arguments: &[&str]) -> Output {
    let mut hasher = DefaultHasher::new();
    (urdf, arguments).hash(&mut hasher);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{:x}.urdf", hasher.finish()));
    fs::write(&path, urdf).unwrap();
    run(&[&["import", path.to_str().unwrap()], arguments].concat())
}

fn refused(urdf: &str, arguments: &[&str]) -> String {
    let output = written(urdf, arguments);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stdout));
    assert!(output.stdout.is_empty());
    text(&output.stderr)
}

const ROBOTS: [(&str, &[&str], [&str; 2], usize); 10] = [
    ("ur5", &[], ["base_link", "tool0"], 6),
    ("abb_irb2400", &[], ["base_link", "tool0"], 6),
    ("kuka_kr6_r700", &[], ["base_link", "tool0"], 6),
    ("fanuc_lrmate200id", &[], ["base_link", "tool0"], 6),
    ("kuka_iiwa7", &[], ["iiwa_link_0", "iiwa_link_ee"], 7),
    ("franka_panda", &["--tool", "panda_hand_tcp"], ["panda_link0", "panda_hand_tcp"], 7),
    ("kinova_gen3", &[], ["base_link", "end_effector_link"], 7),
    ("ufactory_xarm6", &[], ["link_base", "link6"], 6),
    ("fetch", &[], ["base_link", "gripper_link"], 8),
    ("baxter_left", &[], ["torso", "left_hand"], 7),
];

#[test]
fn real_robots_move_as_their_urdf_says() {
    for (name, arguments, ends, dof) in ROBOTS {
        // As written, to rounding; with exact angles, to what was changed.
        for (within, most) in [("0", 1e-12), ("1e-6", 2e-8)] {
            let (text, _) = import(name, &[arguments, &["--exact-within", within]].concat());
            let file = model(&text);
            assert_eq!(file.joints.len(), dof, "{name}");
            let error = worst(name, ends, &file, by_name(&file));
            assert!(error < most, "{name}, exact within {within}: {error:e}");
        }
    }
}

#[test]
fn names_and_limits_are_kept() {
    let (text, _) = import("fetch", &[]);
    let file = model(&text);
    let names: Vec<&str> = file.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names[..3], ["torso_lift_joint", "shoulder_pan_joint", "shoulder_lift_joint"]);
    assert_eq!(file.joints[0].limits, Some([0.0, 0.38615]));
    assert_eq!(file.joints[2].limits, Some([-1.221, 1.518]));
    assert_eq!(file.joints[3].limits, None, "continuous");
}

#[test]
fn exact_angles_are_told_and_give_the_textbook_table() {
    let (text, said) = import("ur5", &[]);
    assert!(text.contains("{name: wrist_1_joint, a: 0, alpha: -90, d: 0.10915, theta: 0,"), "{text}");
    assert!(
        said.contains("made exact: pitch of joint `shoulder_lift_joint`, 1.570796325 rad, is 90 deg now (1.8e-9 rad)"),
        "{said}"
    );
    assert!(text.contains("# 3 angles were made exact before that, by at most 1.8e-9 rad."), "{text}");
    let (text, said) = import("ufactory_xarm6", &[]);
    assert!(said.contains("`--exact-within 1e-5` makes that exact") && text.contains("1.5708 rad"), "{said}\n{text}");
    let (text, _) = import("ufactory_xarm6", &["--exact-within", "1e-5"]);
    assert!(!text.contains("1.5708"), "{text}");
}

#[test]
fn an_import_in_json_has_the_proof_and_the_angles() {
    let json = |name: &str, arguments: &[&str]| -> serde_json::Value {
        let (out, err) = import(name, &[arguments, &["--json"]].concat());
        assert_eq!(err, "");
        serde_json::from_str(&out).unwrap()
    };
    let all = json("ur5", &[]);
    let (file, _) = import("ur5", &[]);
    assert_eq!(all["arm_file"].as_str().unwrap(), file);
    assert_eq!(all["chain"], serde_json::json!({"base": "base_link", "tool": "tool0"}));
    let made = all["made_exact"].as_array().unwrap();
    assert_eq!(made.len(), 3);
    assert_eq!(made[0]["angle"], "pitch of joint `shoulder_lift_joint`");
    assert_eq!((made[0]["from_rad"].as_f64(), made[0]["to_deg"].as_f64()), (Some(1.570796325), Some(90.0)));
    assert!((made[0]["changed_by_rad"].as_f64().unwrap() - 1.794_896_6e-9).abs() < 1e-15, "{all}");
    let proof = &all["proof"];
    assert_eq!(proof["configurations"], 1000);
    let [exact, written] = ["exact_angles", "as_written"].map(|key| proof[key]["angle_rad"].as_f64().unwrap());
    assert!(exact < 1e-12 && written > 1e-9 && written < 1e-8, "{proof}");

    let nearly = json("ufactory_xarm6", &[]);
    let nearly = nearly["nearly_exact"].as_array().unwrap();
    assert_eq!(nearly[0]["rad"].to_string().trim_start_matches('-'), "1.5708");
    assert!((nearly[0]["off_by_rad"].as_f64().unwrap() - 3.673_205_1e-6).abs() < 1e-12, "{nearly:?}");

    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("json_ur5.yaml");
    let to = path.to_str().unwrap();
    let all = json("ur5", &["-o", to, "--force"]);
    assert_eq!((all["output"].as_str(), all.get("arm_file")), (Some(to), None));
    assert_eq!(fs::read_to_string(&path).unwrap(), file);
}

#[test]
fn the_head_comment_has_the_proof() {
    let (text, said) = import("kuka_iiwa7", &[]);
    let line = "At 1000 random configurations the pose differs from the URDF's by at most ";
    assert!(text.contains(&format!("# {line}")) && said.contains(line), "{text}\n{said}");
    let number = text.split(line).nth(1).unwrap().split(' ').next().unwrap();
    assert!(number.parse::<f64>().unwrap() < 1e-12, "{number}");
}

#[test]
fn any_two_links_are_ends_of_a_chain() {
    // Backward through the arm, and across the tree from the head to the hand.
    for (base, tool, dof) in [("gripper_link", "base_link", 8), ("head_tilt_link", "gripper_link", 9)] {
        let (text, _) = import("fetch", &["--base", base, "--tool", tool]);
        let file = model(&text);
        assert_eq!(file.joints.len(), dof);
        let joints = joints("fetch");
        let mut state = 3;
        for _ in 0..100 {
            let q: Vec<f64> = file.joints.iter().map(|_| 3.0 * random(&mut state)).collect();
            let values = by_name(&file)(&q);
            let [from, to] = [base, tool].map(|link| urdf_pose(&joints, "base_link", link, &values));
            let (a, b) = (table_pose(&file, &q), from.inverse() * to);
            let error = (a.translation.vector - b.translation.vector).norm().max(a.rotation.angle_to(&b.rotation));
            assert!(error < 1e-12, "{base}: {error:e}");
        }
    }
}

#[test]
fn mimic_joints_on_one_line_become_a_coupling() {
    let (text, _) = import("palletizer", &[]);
    assert!(text.contains("coupling:\n  j3: {j2: 1, j3: 1}\n"), "{text}");
    assert!(text.contains("combined_limits:\n  - {sum: {j2: 1, j3: 1}, limits: [-20, 100]}\n"), "{text}");
    let file = model(&text);
    // The file's joint 3 is the bracket's turn and the forearm's: -j2 + j3.
    let values = |q: &[f64]| {
        let named = [("j1", q[0]), ("j2", q[1]), ("j2_level", -q[1]), ("j3", q[2] + q[1]), ("j4", q[3])];
        named.map(|(name, value)| (name.to_owned(), value)).into()
    };
    assert!(worst("palletizer", ["base", "flange"], &file, values) < 1e-12);
}

#[test]
fn a_finger_that_mimics_one_outside_the_chain_is_driven_by_it() {
    let (text, _) = import("franka_panda", &["--base", "panda_hand", "--tool", "panda_rightfinger"]);
    let file = model(&text);
    assert_eq!(file.joints.len(), 1);
    assert_eq!(file.joints[0].name, "panda_finger_joint1");
    let values = |q: &[f64]| [("panda_finger_joint2".to_owned(), q[0])].into();
    assert!(worst("franka_panda", ["panda_hand", "panda_rightfinger"], &file, values) < 1e-12);
}

/// A chain of three joints that turn; the second one, about `axis`, mimics another.
fn mimicking(axis: &str, mimic: &str, limits: [f64; 2]) -> String {
    let joint = |name: &str, [parent, child]: [&str; 2], axis: &str, [low, high]: [f64; 2], mimic: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"0 0 0.3\"/><axis xyz=\"{axis}\"/><limit lower=\"{low}\" upper=\"{high}\"/>{mimic}</joint>\n"
        )
    };
    let links = ["l0", "l1", "l2", "l3", "aside"].map(|name| format!("<link name=\"{name}\"/>\n")).concat();
    let joints = [
        joint("j1", ["l0", "l1"], "0 0 1", [-2.0, 2.0], ""),
        joint("j2", ["l1", "l2"], axis, limits, mimic),
        joint("j3", ["l2", "l3"], "0 1 0", [-1.0, 1.0], ""),
        joint("outside", ["l0", "aside"], "0 0 1", [-1.0, 0.5], ""),
    ];
    format!("<robot name=\"mimicking\">{links}{}</robot>", joints.concat())
}

#[test]
fn every_joint_that_follows_a_motor_keeps_its_limits() {
    let limits = |urdf: &str| -> Vec<Option<[f64; 2]>> {
        let output = written(urdf, &["--tool", "l3"]);
        model(&text(&output.stdout)).joints.iter().map(|joint| joint.limits).collect()
    };
    // On one line with j1, the sum 2 j1: the limits of j2 let j1 move by 0.1 only.
    assert_eq!(limits(&mimicking("0 0 1", "<mimic joint=\"j1\"/>", [-0.1, 0.1]))[0], Some([-0.2, 0.2]));
    // Driven by a joint outside the chain, 2 u + 0.1 with u from -1 to 0.5.
    let outside = "<mimic joint=\"outside\" multiplier=\"2\" offset=\"0.1\"/>";
    assert_eq!(limits(&mimicking("1 0 0", outside, [-9.0, 9.0]))[1], Some([-1.9, 1.1]));
    // Limits without a value in common.
    let said = refused(&mimicking("1 0 0", outside, [8.0, 9.0]), &["--tool", "l3"]);
    assert!(
        said.contains("joint `outside` and the joints that mimic it have no value within the limits of all"),
        "{said}"
    );
}

#[test]
fn what_no_arm_file_can_say_is_refused_with_a_way_out() {
    let palletizer = fs::read_to_string(urdf("palletizer")).unwrap();
    // The level keeper moved off the forearm's line.
    let apart = palletizer.replace(
        "<child link=\"forearm\"/>\n    <origin xyz=\"0 0 0\"",
        "<child link=\"forearm\"/>\n    <origin xyz=\"0.1 0 0\"",
    );
    assert_ne!(apart, palletizer);
    let said = refused(&apart, &[]);
    assert!(said.contains("joint `j2_level` moves with `j2`") && said.contains("help:"), "{said}");
    let floating = palletizer.replace("name=\"j1\" type=\"revolute\"", "name=\"j1\" type=\"floating\"");
    let said = refused(&floating, &[]);
    assert!(said.contains("joint `j1` is floating") && said.contains("--base column"), "{said}");
    let misspelt = palletizer.replace("name=\"j1\" type=\"revolute\"", "name=\"j1\" type=\"revolut\"");
    let said = refused(&misspelt, &[]);
    assert!(said.contains("joint `j1`: a URDF has no joints of type `revolut`\nhelp: write revolute"), "{said}");
    let said = refused(&palletizer, &["--tool", "flnge"]);
    assert!(said.contains("no link is named `flnge`") && said.contains("flange"), "{said}");
    let fetch = fs::read_to_string(urdf("franka_panda")).unwrap();
    let said = refused(&fetch, &[]);
    let help =
        "--tool panda_hand_tcp, or --tool panda_hand (the last link before they part); the ends are panda_leftfinger";
    assert!(said.contains(&format!("several chains have 8 moving joints\nhelp: {help}, ")), "{said}");
    let said = refused("<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:arm/></robot>", &[]);
    assert!(said.contains("xacro robot.urdf.xacro > robot.urdf"), "{said}");
}

#[test]
fn a_urdf_in_place_of_an_arm_file_is_named() {
    let path = urdf("ur5");
    let path = path.to_str().unwrap();
    for command in [&["check", path][..], &["forward", path, "--q", "0 0 0 0 0 0"], &["export", "c", path, "-o", "no"]]
    {
        let output = run(command);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(&format!("this is a URDF\nhelp: denhart import {path} -o arm.yaml")), "{said}");
    }
}

#[test]
fn imported_files_are_checked_without_advice_about_their_own_digits() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("imported_kr6.yaml");
    let to = path.to_str().unwrap();
    let (nothing, _) = import("kuka_kr6_r700", &["-o", to, "--force"]);
    assert!(nothing.is_empty());
    let output = run(&["check", to]);
    let said = text(&output.stdout);
    assert!(output.status.success() && said.contains("inverse (task pose): at most 8 solutions"), "{said}");
    assert!(!said.contains("warning"), "{said}");
}

#[test]
fn a_file_is_overwritten_only_if_asked_to() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("kept.yaml");
    let urdf = format!("{}/tests/urdf/ur5.urdf", env!("CARGO_MANIFEST_DIR"));
    let command = ["import", &urdf, "-o", path.to_str().unwrap()];
    std::fs::write(&path, "mine").unwrap();
    let output = run(&command);
    let said = text(&output.stderr);
    assert!(
        !output.status.success() && said.contains("kept.yaml` is there already\nhelp: --force overwrites it"),
        "{said}"
    );
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    assert!(run(&[&command[..], &["--force"]].concat()).status.success());
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("# Imported from ur5.urdf"));
    // The same again is no change.
    assert!(run(&command).status.success());
    let output = run(&["import", &urdf, "--force"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
}
