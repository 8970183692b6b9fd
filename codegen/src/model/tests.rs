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
    let rows: Vec<_> = model
        .rows
        .iter()
        .map(|row| (row.joint, row.a.default_value(), row.alpha, row.d.default_value(), row.theta))
        .collect();
    assert_eq!(rows.first(), Some(&(None, 1.0, Angle::ZERO, 0.0, Angle::ZERO)));
    assert_eq!(rows.get(1), Some(&(Some(0), 1.0, Angle::pi_fraction(1, 2), 2.0, Angle::degrees(-45.0))));
    assert_eq!(rows.get(2), Some(&(Some(1), 0.0, Angle::radians(1.0), 3.0, Angle::ZERO)));
    assert_eq!(model.base, Frame { xyz: [const { Length::ZERO }; 3], rpy: [Angle::ZERO; 3] });
    assert_eq!(model.tool.rpy, [Angle::ZERO, Angle::degrees(90.0), Angle::ZERO]);
    // `q2` is no name here: it means the second joint.
    assert_eq!((model.inverse.redundant, model.inverse.tolerance_angle), (Redundant::of(&[1]), Some(PI)));
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
    only(&arm(&[&named("q2"), &named("x")], ""), "5:12", &["joint 1 has the name `q2`", "means joint 2"]);
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
fn a_list_of_redundant_joints() {
    let named = "{name: elbow, a: 1, alpha: 0, d: 0, theta: 0}";
    let redundant = |list: &str| model(&arm(&[named, PLAIN, PLAIN], &format!("inverse: {{redundant: {list}}}\n")));
    let of = |list: &str| redundant(list).unwrap().inverse.redundant;
    assert_eq!(of("[q3, elbow]"), Redundant::of(&[2, 0]));
    assert_eq!(of("[q1, arm_angle]").values, [RedundantValue::Joint(0), RedundantValue::ArmAngle]);
    // A list of one is a list.
    assert_eq!((of("[q2]").is_list, of("q2").is_list), (true, false));
    let mistake = |list: &str, at: &str, parts: &[&str]| {
        only(&arm(&[named, PLAIN, PLAIN], &format!("inverse: {{redundant: {list}}}\n")), at, parts);
    };
    mistake("[q1, q2, elbow]", "8:31", &["joint 1 is named twice", "leave out the second one, `elbow`"]);
    mistake("[arm_angle, arm_angle]", "8:34", &["the arm angle is named twice"]);
    mistake("[q2, q5]", "8:27", &["no joint is named `q5`", "the joints are elbow, q2, q3"]);
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

#[test]
fn couplings() {
    let rows = [PLAIN, PLAIN, "{name: z, type: prismatic, a: 0, alpha: 0, d: 0, theta: 0}"];
    let coupling = |text: &str| model(&arm(&rows, &format!("coupling: {text}\n"))).unwrap().coupling.unwrap();
    let linked = coupling("{q2: {q1: 1, q2: 2, offset: -90}, z: {z: -1, q1: 10 per rad}}");
    assert_eq!(linked.matrix, [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [10.0, 0.0, -1.0]]);
    assert_eq!(linked.inverse, [[1.0, 0.0, 0.0], [-0.5, 0.5, 0.0], [10.0, 0.0, -1.0]]);
    assert_eq!(linked.offset, [0.0, -FRAC_PI_2, 0.0]);
    let written = "[[1, 0, 0], [1, 2, 0], [10 per rad, 0, -1]]";
    assert_eq!(coupling(&format!("{{matrix: {written}, offset: [0, -pi/2, 0]}}")), linked);
    assert_eq!(coupling(written).offset, [0.0; 3]);

    let wrong =
        |text: &str, place: &str, words: &[&str]| only(&arm(&rows, &format!("coupling: {text}\n")), place, words);
    wrong("{q9: {q1: 1}}", "8:12", &["`coupling`: no joint is named `q9`", "q1, q2, z"]);
    wrong("{q2: {zz: 1}}", "8:17", &["no joint is named `zz`", "did you mean `z`?"]);
    // `q3` is the third joint, which has another name.
    wrong("{q3: {z: 2}, z: {z: 1}}", "8:24", &["the motor of joint `z` is listed twice"]);
    wrong("{z: {z: 1, q3: 2}}", "8:22", &["joint `z` is in the sum of the motor of `z` twice"]);
    wrong("{z: {z: 1, q1: 20}}", "8:22", &["joint `q1` turns and `z` slides", "`20 per rev`"]);
    wrong(
        "{q1: {q1: 1, z: 1}}",
        "8:24",
        &["joint `z` slides and cannot turn the motor of `q1`", "z: {z: 1, q1: 20 per rev}"],
    );
    wrong("{q1: {q1: 20 per rev}}", "8:17", &["a length for a turn", "each turns", "a plain number"]);
    wrong("{z: {z: 1, offset: 90 deg}}", "8:30", &["`offset`: expected a length, found the angle 90 deg"]);
    wrong("[[1, 0], [0, 1]]", "8:11", &["a matrix of 3 rows, one for each motor, found 2", "3 rows of 3 factors"]);
    wrong("[[1, 0, 0], [0, 1], [0, 0, 1]]", "8:23", &["expected 3 factors in row 2", "found 2"]);
    wrong("{q2: {q1: 1}}", "8:12", &["singular: joint `q2` moves no motor"]);
    wrong("{q2: {}}", "8:12", &["singular: nothing moves the motor of `q2`"]);
    wrong("{q1: {q1: 0.1, q2: 0.2}, q2: {q1: 0.3, q2: 0.6}}", "8:36", &["singular: the motor of `q2` follows from"]);
    wrong("{q1: {q1: 1, q2: 1}, q2: {q1: 1, q2: 1.0000000000001}}", "8:11", &["singular but for rounding"]);
}

#[test]
fn combined_limits() {
    let rows = [PLAIN, PLAIN, "{name: z, type: prismatic, a: 0, alpha: 0, d: 0, theta: 0}"];
    let text = |entry: &str| arm(&rows, &format!("combined_limits:\n  - {entry}\n"));
    let read = |entry: &str| model(&text(entry)).unwrap().combined_limits;
    let both = CombinedLimit { factors: vec![1.0, -2.0, 0.0], limits: [-FRAC_PI_2, PI], kind: JointKind::Revolute };
    assert_eq!(read("{sum: {q1: 1, q2: -2}, limits: [-90, pi]}"), [both]);
    let one =
        CombinedLimit { factors: vec![0.0, 0.0, 1.0], limits: [f64::NEG_INFINITY, 7.0], kind: JointKind::Prismatic };
    assert_eq!(read("{sum: [z], limits: [null, 7]}"), [one]);
    let wrong = |entry: &str, place: &str, words: &[&str]| only(&text(entry), place, words);
    wrong("{sum: [q7], limits: [0, 1]}", "9:12", &["`sum`: no joint is named `q7`"]);
    wrong("{sum: [q1, z], limits: [0, 1]}", "9:16", &["`q1` and `z` do not add up"]);
    wrong("{sum: [], limits: [0, 1]}", "9:11", &["`sum`: no joint is in it"]);
    wrong("{sum: {q1: 0}, limits: [0, 1]}", "9:11", &["`sum`: no joint is in it"]);
    wrong("{sum: [q1], limits: [2, 1]}", "9:25", &["2 is greater than the highest value 1", "[1, 2]"]);
    wrong("{sum: [z], limits: [0, 90 deg]}", "9:28", &["expected a length, found the angle 90 deg"]);
}

#[test]
fn actuators_come_all_or_none() {
    let turning = "{a: 1, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_rev: 3600, home: 90, direction: -1}}";
    let sliding = "{type: prismatic, a: 1, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_unit: 4, home: 5}}";
    let found = model(&arm(&[FIXED, turning, sliding], "")).unwrap().actuators.unwrap();
    let turns = Actuator { pulses_per_unit: -1800.0 / PI, resolution: PI / 1800.0, home: FRAC_PI_2 };
    assert_eq!(found, [turns, Actuator { pulses_per_unit: 4.0, resolution: 0.25, home: 5.0 }]);
    assert_eq!(model(&arm(&[PLAIN], "")).unwrap().actuators, None);
    only(&arm(&[PLAIN, turning, PLAIN], ""), "6:48", &["`actuator`: there is none for `q1`, `q3`", "to none"]);
}

#[test]
fn a_parameter_may_not_have_the_name_of_a_joint() {
    let row = "{a: q1, alpha: 0, d: 0, theta: 0}";
    only(&arm(&[row], "parameters: {q1: 1}\n"), "6:14", &["the parameter `q1` has the name of joint 1"]);
}

/// Two links in a plane and a wrist off the plane by `off`.
fn parametric(off: &str, bound: &Bound) -> Model {
    let rows = ["{a: l1, alpha: 0, d: 0, theta: 0}", "{a: 2*l2, alpha: 90, d: 0, theta: 0}"];
    let wrist = format!("{{a: {off}, alpha: 90, d: 0, theta: 0}}");
    let rows = [rows[0], rows[1], &wrist, "{a: 0, alpha: 90, d: 0, theta: 0}", "{a: 0, alpha: 0, d: 0, theta: 0}"];
    model(&arm(&rows, "parameters: {l1: 3, l2: 2, off: 0}\n")).unwrap().bind(bound)
}

#[test]
fn a_parameter_without_a_field_is_a_number() {
    let lengths = |bound: &Bound| parametric("0", bound).rows.iter().map(|row| row.a.clone()).collect::<Vec<_>>();
    let folded = lengths(&Bound::None);
    assert_eq!(folded.get(..2), Some(&[Length::Constant(3.0), Length::Constant(4.0)][..]));
    let one = Bound::Fields(vec!["l2".into()]);
    let half = Length::Multiple { factor: 2.0, parameter: "l2".into(), default: 4.0 };
    assert_eq!(lengths(&one).get(..2), Some(&[Length::Constant(3.0), half][..]));
    assert_eq!(parametric("0", &one).parameters.len(), 1);
}

#[test]
fn structure_rests_on_symbols_not_on_their_defaults() {
    let triples = |off: &str, bound: &Bound| {
        let model = parametric(off, bound);
        geometry::geometry(&model, &chain::Chain::of(&model)).triples.iter().map(|t| t.first).collect::<Vec<_>>()
    };
    // Axes 2, 3 and 4 meet in a point while the offset between them is the number 0, which is the default.
    assert_eq!(triples("0", &Bound::All), [1]);
    assert_eq!(triples("off", &Bound::None), [1]);
    assert_eq!(triples("off", &Bound::All), []);
    assert_eq!(triples("off", &Bound::Fields(vec!["l1".into(), "l2".into()])), [1]);
}

#[test]
fn rates_are_in_rad_or_the_length_unit() {
    let rows = [
        "{a: 1, alpha: 0, d: 0, theta: 0, max_velocity: 180, max_acceleration: 2*pi}",
        "{type: prismatic, a: 1, alpha: 0, d: 0, theta: 0, max_velocity: 0.5}",
        PLAIN,
    ];
    let model = model(&arm(&rows, "")).unwrap();
    let rates: Vec<_> = model.joints.iter().map(|joint| (joint.max_velocity, joint.max_acceleration)).collect();
    assert_eq!(rates, [(PI, 2.0 * PI), (0.5, f64::INFINITY), (f64::INFINITY, f64::INFINITY)]);
}
