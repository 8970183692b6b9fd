//! `denhart import` on what exporters of URDF write: grippers, units, limits and names.
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A joint of a URDF. `more` stands inside.
fn joint(name: &str, kind: &str, [parent, child]: [&str; 2], xyz: &str, axis: &str, more: &str) -> String {
    let limit = if more.contains("<limit") { "" } else { "<limit lower=\"-2\" upper=\"2\"/>" };
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
         <origin xyz=\"{xyz}\"/><axis xyz=\"{axis}\"/>{limit}{more}</joint>\n"
    )
}

/// Three joints from `base` to `l3`, in m times `scale`, with these names; `more` stands in the first.
fn arm(names: [&str; 3], scale: f64, more: &str) -> String {
    let [first, second, third] = names;
    let [up, along, out] =
        [format!("0 0 {}", 0.3 * scale), format!("{} 0 0", 0.4 * scale), format!("{} 0 0", 0.5 * scale)];
    [
        joint(first, "revolute", ["base", "l1"], &up, "0 0 1", more),
        joint(second, "revolute", ["l1", "l2"], &along, "0 1 0", ""),
        joint(third, "revolute", ["l2", "l3"], &out, "0 1 0", ""),
    ]
    .concat()
}

const NAMES: [&str; 3] = ["turn", "lift", "bend"];

fn robot(joints: &str) -> String {
    let mut links: Vec<&str> = joints.split("link=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    links.sort_unstable();
    links.dedup();
    let links: String = links.iter().map(|link| format!("<link name=\"{link}\"/>\n")).collect();
    format!("<robot name=\"made\">\n{links}{joints}</robot>\n")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn run(name: &str, joints: &str, arguments: &[&str]) -> Output {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("exported_{name}.urdf"));
    fs::write(&path, robot(joints)).unwrap();
    let command = [&["import", path.to_str().unwrap()], arguments].concat();
    Command::new(env!("CARGO_BIN_EXE_denhart")).args(command).output().unwrap()
}

/// The arm file, and what is said beside it.
fn import(name: &str, joints: &str, arguments: &[&str]) -> [String; 2] {
    let output = run(name, joints, arguments);
    assert!(output.status.success(), "{name}: {}", text(&output.stderr));
    [text(&output.stdout), text(&output.stderr)]
}

fn refused(name: &str, joints: &str) -> String {
    let output = run(name, joints, &[]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(1), 0), "{name}");
    text(&output.stderr)
}

#[test]
fn the_tool_that_is_advised_is_no_finger() {
    let plain = arm(NAMES, 1.0, "");
    let hand = joint("mount", "fixed", ["l3", "hand"], "0 0 0", "0 0 1", "");
    let flange = joint("flange", "fixed", ["l3", "arm_tool0"], "0 0 0", "0 0 1", "");
    let left = joint("close", "prismatic", ["hand", "left"], "0 0 0.1", "0 1 0", "");
    let right = joint("follow", "prismatic", ["hand", "right"], "0 0 0.1", "0 -1 0", "<mimic joint=\"close\"/>");
    let rigid = joint("follow", "fixed", ["hand", "right"], "0 0 0.1", "0 -1 0", "");
    let finger = left.replace("close", "left_finger_joint");
    let object = joint("held", "floating", ["l3", "object"], "0 0 0", "0 0 1", "");
    let world = joint("drive", "planar", ["world", "base"], "0 0 0", "0 0 1", "");
    for (name, joints, help) in [
        (
            "mimic",
            [&plain, &hand, &left, &right].map(String::as_str).concat(),
            "--tool hand (the last link before they part)",
        ),
        (
            "tool0",
            [&plain, &hand, &flange, &left, &right].map(String::as_str).concat(),
            "--tool arm_tool0, or --tool hand (the",
        ),
        ("floats", [&plain, &object].map(String::as_str).concat(), "end the chain before it: --tool l3 (the last link"),
        ("held", [&plain, &flange, &object].map(String::as_str).concat(), ""),
        ("rolls", [&world, &plain].map(String::as_str).concat(), "begin the chain after it: --base base"),
    ] {
        if help.is_empty() {
            // What floats has fewer names than the flange.
            assert!(import(name, &joints, &[])[1].starts_with("chain: `base` to `arm_tool0`"));
            continue;
        }
        let said = refused(name, &joints);
        assert!(said.contains(&format!("\nhelp: {help}")), "{name}: {said}");
    }
    // One finger moves, and the chain is plain: it ends before the hand's joint, and says so.
    let [file, said] = import("one", &[&plain, &hand, &finger, &rigid].map(String::as_str).concat(), &[]);
    assert!(said.starts_with("chain: `base` to `hand`") && !file.contains("finger_joint,"), "{said}{file}");
    let told = "the chain ends before joint `left_finger_joint`, which moves a gripper or a hand\nhelp: --tool left takes it in";
    assert!(said.contains(told), "{said}");
    let joints = [&plain, &hand, &left, &right].map(String::as_str).concat();
    let [file, _] = import("asked", &joints, &["--tool", "left"]);
    assert!(file.contains("name: close, type: prismatic"), "{file}");
}

#[test]
fn a_chain_in_millimeters_is_remarked() {
    let [_, said] = import("mm", &arm(NAMES, 1000.0, ""), &[]);
    assert!(
        said.contains("the chain is 1200 m long: is this URDF in millimeters?\nhelp: lengths of a URDF are m."),
        "{said}"
    );
    assert!(said.contains("write `length: mm` under `units`"), "{said}");
    let [_, said] = import("m", &arm(NAMES, 1.0, ""), &[]);
    assert!(!said.contains("millimeters"), "{said}");
}

#[test]
fn names_that_mean_another_joint_are_changed_and_told() {
    for names in [["q0", "q1", "q2"], ["q3", "q2", "q1"]] {
        let [file, said] = import(names[0], &arm(names, 1.0, ""), &[]);
        let [a, b, c] = names;
        let line = format!(
            "In an arm file `q1` means joint 1. So the URDF's joint `{a}` is `joint_{a}`, `{b}` is `joint_{b}`, `{c}` is `joint_{c}` here."
        );
        assert!(file.contains(&format!("# {line}\n")) && said.contains(&line), "{file}\n{said}");
        assert!(file.contains(&format!("  - {{name: joint_{a}, ")), "{file}");
    }
    let [file, said] = import("own", &arm(["q1", "q2", "q3"], 1.0, ""), &[]);
    assert!(file.contains("{name: q1, ") && !said.contains("joint_q1"), "{file}");
    let [file, _] = import("taken", &arm(["q2", "joint_q2", "bend"], 1.0, ""), &[]);
    assert!(file.contains("{name: joint_q2_, ") && file.contains("{name: joint_q2, "), "{file}");
}

#[test]
fn limits_that_are_none_are_none() {
    for (limit, written, told) in [
        ("lower=\"-1e16\" upper=\"1e16\"", "theta: 0}", "-1e16 to 1e16"),
        ("lower=\"-inf\" upper=\"1.5\"", "limits: [null, 1.5 rad]}", "-inf to 1.5"),
        ("lower=\"-1\" upper=\"1e9\"", "limits: [-1 rad, null]}", "-1 to 1e9"),
    ] {
        let [file, said] = import("endless", &arm(NAMES, 1.0, &format!("<limit {limit}/>")), &[]);
        let row = file.lines().find(|line| line.contains("name: turn")).unwrap();
        assert!(row.ends_with(written), "{row}");
        let line = format!("Joint `turn` has the limits {told}: an end beyond 1e6 is taken as none.");
        assert!(file.contains(&format!("# {line}")) && said.contains(&line), "{said}");
    }
}

#[test]
fn a_long_axis_is_a_direction() {
    let [file, _] = import("axis", &arm(NAMES, 1.0, "").replace("0 0 1", "0 0 1e200"), &[]);
    let [same, _] = import("axis", &arm(NAMES, 1.0, ""), &[]);
    assert_eq!(file, same);
}

#[test]
fn lengths_nearly_short_are_short() {
    let joints = arm(NAMES, 1.0, "").replace("0.5 0 0", "0.4999999998 0 0");
    let [file, said] = import("nearly", &joints, &[]);
    let line = "1 length was rounded to a micrometer, by at most 2.0e-10 m.";
    assert!(file.contains("a: 0.5, ") && file.contains(line) && said.contains(line), "{file}\n{said}");
    let [file, said] = import("nearly", &joints, &["--exact-within", "0"]);
    assert!(file.contains("a: 0.4999999998, ") && !said.contains("rounded"), "{file}");
    // Further off, or in an arm of which that is a larger part.
    let [file, _] = import("off", &joints.replace("0.4999999998", "0.499999998"), &[]);
    assert!(file.contains("a: 0.499999998, "), "{file}");
    let [file, _] = import("small", &arm(NAMES, 0.001, "").replace("0.0005 0 0", "0.0004999998 0 0"), &[]);
    assert!(file.contains("a: 0.0004999998, "), "{file}");
}
