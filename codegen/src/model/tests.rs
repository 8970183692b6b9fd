//! Every mistake of meaning, and the conversion of what is right.

#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;
use crate::error::Errors;
use crate::spec;
use std::f64::consts::{FRAC_PI_2, PI};
use std::{fs, path::Path};

fn model(text: &str) -> Result<Model, Errors> {
    let (spec, _) = spec::read(text, "f")?;
    check(&spec)
}

fn arm(rows: &[&str], more: &str) -> String {
    let rows: String = rows.iter().map(|row| format!("  - {row}\n")).collect();
    format!("# Source.\nconvention: modified\nunits: {{length: mm, angle: deg}}\njoints:\n{rows}{more}")
}

#[track_caller]
fn only(text: &str, place: &str, words: &[&str]) {
    let errors = model(text).unwrap_err();
    let found: Vec<String> = errors.iter().map(ToString::to_string).collect();
    let [mistake] = found.as_slice() else { panic!("expected one, found {found:#?}") };
    assert!(mistake.starts_with(&format!("f:{place}: ")), "{mistake}");
    for word in words {
        assert!(mistake.contains(word), "`{word}` is not in\n{mistake}");
    }
}

const PLAIN: &str = "{a: 1, alpha: 0, d: 0, theta: 0}";
const FIXED: &str = "{type: fixed, a: 1, alpha: 0, d: 0, theta: 0}";

#[test]
fn values_are_converted() {
    let rows = [
        FIXED,
        "{a: 1, alpha: 90, d: 2, theta: -45, limits: [-90, pi]}",
        "{name: slide, type: prismatic, a: 0, alpha: 1 rad, d: 3, theta: 0, limits: [null, 7]}",
        "{a: 0, alpha: 0, d: 0, theta: 0, limits: [null, null]}",
    ];
    let more = "tool: {xyz: [0, 0, 5], rpy: [0, 90, 0]}\ninverse: {redundant: q2, tolerance: {angle: 180}}\n";
    let model = model(&arm(&rows, more)).unwrap();
    assert_eq!((model.source.as_deref(), model.name.as_str()), (Some("Source."), "f"));
    assert_eq!((model.convention, model.length_unit), (Convention::Modified, LengthUnit::Millimeter));
    let joints: Vec<_> =
        model.joints.iter().map(|joint| (joint.name.as_str(), joint.row, joint.kind, joint.limits)).collect();
    let expected = [
        ("q1", 1, JointKind::Revolute, Some([-FRAC_PI_2, PI])),
        ("slide", 2, JointKind::Prismatic, Some([f64::NEG_INFINITY, 7.0])),
        ("q3", 3, JointKind::Revolute, None),
    ];
    assert_eq!(joints, expected);
    let rows: Vec<_> = model.rows.iter().map(|row| (row.joint, row.a, row.alpha, row.d, row.theta)).collect();
    assert_eq!(rows.first(), Some(&(None, 1.0, Angle::ZERO, 0.0, Angle::ZERO)));
    assert_eq!(rows.get(1), Some(&(Some(0), 1.0, Angle::pi_fraction(1, 2), 2.0, Angle::degrees(-45.0))));
    assert_eq!(rows.get(2), Some(&(Some(1), 0.0, Angle::radians(1.0), 3.0, Angle::ZERO)));
    assert_eq!(model.base, Frame { xyz: [0.0; 3], rpy: [Angle::ZERO; 3] });
    assert_eq!(model.tool.rpy, [Angle::ZERO, Angle::degrees(90.0), Angle::ZERO]);
    // `q2` is no name here: it means the second joint.
    assert_eq!((model.inverse.redundant, model.inverse.tolerance_angle), (Some(1), Some(PI)));
    assert_eq!(model.inverse.at.map(|at| (at.line, at.column)), Some((10, 10)));
}

#[test]
fn limits_the_wrong_way_round() {
    let row = |limits: &str| format!("{{a: 0, alpha: 0, d: 0, theta: 0, limits: {limits}}}");
    only(&arm(&[&row("[90, -90]")], ""), "5:46", &["lowest value 90", "highest value -90", "write [-90, 90]"]);
    only(&arm(&[&row("[3 rad, 90]")], ""), "5:46", &["write [90, 3 rad]"]);
    assert!(model(&arm(&[&row("[5, 5]")], "")).is_ok());
}

#[test]
fn names_that_occur_twice() {
    let named = |name: &str| format!("{{name: {name}, a: 1, alpha: 0, d: 0, theta: 0}}");
    only(&arm(&[&named("x"), PLAIN, &named("x")], ""), "7:12", &["joints 1 and 3 have the same name `x`"]);
    only(&arm(&[&named("q2"), PLAIN], ""), "5:12", &["joints 1 and 2", "`q2`", "called by its number"]);
    only(&arm(&[PLAIN, &named("q1")], ""), "6:12", &["joints 1 and 2", "`q1`", "called by its number"]);
}

#[test]
fn too_few_or_too_many_joints() {
    only(&arm(&[FIXED], ""), "5:5", &["no joint moves"]);
    let ten = [PLAIN; 10];
    assert_eq!(model(&arm(&[&ten[..], &[FIXED]].concat(), "")).unwrap().joints.len(), 10);
    only(&arm(&[PLAIN; 12], ""), "15:5", &["12 moving joints", "at most 10", "joint 11"]);
}

#[test]
fn a_redundant_joint_that_is_none() {
    let named = "{name: elbow, a: 1, alpha: 0, d: 0, theta: 0}";
    let help = ["no joint is named `elbw`", "did you mean `elbow`?", "the joints are elbow, q2"];
    only(&arm(&[named, PLAIN], "inverse: {redundant: elbw}\n"), "7:22", &help);
    only(&arm(&[PLAIN], "inverse: {redundant: q7}\n"), "6:22", &["no joint is named `q7`"]);
}

#[test]
fn mistakes_of_form_and_of_meaning_come_together_in_order() {
    let rows =
        ["{name: x, a: 0, alpha: 0, d: 0, theta: 0, limits: [2, 1]}", "{name: x, b: 0, alpha: 0, d: 0, theta: 0}"];
    let errors = model(&arm(&rows, "inverse: {redundant: y}\ntool: 5\n")).unwrap_err();
    let places: Vec<_> =
        errors.iter().filter_map(|mistake| mistake.at.as_ref()).map(|at| (at.line, at.column)).collect();
    assert_eq!(places, [(5, 55), (6, 5), (6, 12), (6, 15), (7, 22), (8, 7)], "{errors}");
}

#[test]
fn all_arms_of_the_collection_are_right() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.display().to_string();
        let (spec, warnings) = spec::read(&fs::read_to_string(&path).unwrap(), &name).unwrap();
        let model = check(&spec).unwrap_or_else(|errors| panic!("{errors}"));
        assert_eq!(warnings, [], "{name}");
        assert_eq!(Some(model.name.as_str()), path.file_stem().and_then(|stem| stem.to_str()));
        assert!(model.source.is_some(), "{name} cites no source");
        count += 1;
    }
    assert!(count >= 53, "{count} files");
}
