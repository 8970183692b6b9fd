//! A first arm file: defaults that say why, and reasons of an unsupported arm that name what to look at.
#![allow(clippy::unwrap_used)]

use denhart_codegen::Report;

fn check(convention: &str, rows: &[&str], more: &str) -> Report {
    let rows: String = rows.iter().map(|row| format!("  - {{{row}}}\n")).collect();
    let text =
        format!("name: first\nconvention: {convention}\nunits: {{length: m, angle: deg}}\njoints:\n{rows}{more}\n");
    denhart_codegen::check(&text, "first.yaml").unwrap()
}

const YAW_PITCHES_ROLL: [&str; 5] = [
    "a: 0, alpha: 90, d: 0.3, theta: 0",
    "a: 0.4, alpha: 0, d: 0, theta: 0",
    "a: 0.3, alpha: 0, d: 0, theta: 0",
    "a: 0, alpha: 90, d: 0, theta: 90",
    "a: 0, alpha: 0, d: 0.1, theta: 0",
];

#[test]
fn five_joints_have_the_pose_where_they_can() {
    let report = check("standard", &YAW_PITCHES_ROLL, "");
    assert_eq!(report.task.as_deref(), Some("pose"), "{report}");
    assert!(report.to_string().contains("the file names no task: `pose` is the most specific one"), "{report}");
}

#[test]
fn five_joints_without_a_pose_point_the_tools_z() {
    // Three axes that meet at the shoulder, then two more in no special place.
    let rows = [
        "a: 0, alpha: 90, d: 0.3, theta: 0",
        "a: 0, alpha: 90, d: 0, theta: 0",
        "a: 0.1, alpha: 90, d: 0.4, theta: 0",
        "a: 0.2, alpha: 60, d: 0.1, theta: 0",
        "a: 0, alpha: 0, d: 0.1, theta: 0",
    ];
    let report = check("standard", &rows, "tool: {xyz: [0.1, 0, 0.1], rpy: [40, 30, 0]}");
    assert_eq!(report.task.as_deref(), Some("position_axis, axis z"), "{report}");
    assert!(
        report.to_string().contains("along the tool's z axis, because these five joints have no `pose`"),
        "{report}"
    );
}

#[test]
fn an_axis_that_is_not_z_says_why() {
    let report = check("standard", &YAW_PITCHES_ROLL, "inverse: {task: position_axis}");
    assert_eq!(report.task.as_deref(), Some("position_axis, axis x"), "{report}");
    assert!(report.to_string().contains("  axis z cannot be asked for: the arm is singular everywhere"), "{report}");
}

#[test]
fn a_given_joint_that_changes_the_task_is_told() {
    let rows = [
        "a: 0, alpha: 90, d: 0.3, theta: 0",
        "a: 0.4, alpha: 0, d: 0, theta: 0",
        "a: 0.3, alpha: 0, d: 0, theta: 0",
        "a: 0, alpha: 90, d: 0.1, theta: 0",
        "a: 0, alpha: -90, d: 0.1, theta: 0",
        "a: 0, alpha: 0, d: 0.1, theta: 0",
    ];
    let report = check("standard", &rows, "inverse: {redundant: q6}");
    let said: Vec<String> = report.warnings.iter().map(ToString::to_string).collect();
    let task = report.task.clone().unwrap_or_default();
    let task = task.split(',').next().unwrap();
    assert!(
        matches!(&said[..], [one] if one.contains(&format!("the task is `{task}`, not `pose`"))),
        "{said:?}\n{report}"
    );
    assert!(check("standard", &rows, "").warnings.is_empty());
}

/// The table of a Puma 560 by Craig, typed as a standard one.
#[test]
fn a_table_of_the_other_convention_is_named() {
    let rows = [
        "a: 0, alpha: 0, d: 0, theta: 0",
        "a: 0, alpha: -90, d: 0, theta: 0",
        "a: 0.4318, alpha: 0, d: 0.1491, theta: 0",
        "a: 0.0203, alpha: -90, d: 0.4318, theta: 0",
        "a: 0, alpha: 90, d: 0, theta: 0",
        "a: 0, alpha: -90, d: 0, theta: 0",
    ];
    assert_eq!(check("modified", &rows, "").max_solutions, Some(8));
    let report = check("standard", &rows, "");
    let text = report.to_string();
    assert!(text.contains("read as `convention: modified` the table has an inverse (task pose)"), "{text}");
    let unsupported = report.unsupported.unwrap();
    assert!(!unsupported.contains("work"), "{unsupported}");
}

#[test]
fn axes_nearly_parallel_are_named_and_not_rounded() {
    let rows = [
        "a: 0.05, alpha: 90, d: 0.3, theta: 0",
        "a: 0.4, alpha: 0.02, d: 0, theta: 0",
        "a: 0.3, alpha: 0, d: 0, theta: 0",
        "a: 0.02, alpha: 90, d: 0.1, theta: 0",
        "a: 0.03, alpha: -90, d: 0.1, theta: 0",
        "a: 0, alpha: 0, d: 0.1, theta: 0",
    ];
    let report = check("standard", &rows, "");
    let text = report.to_string();
    assert!(text.contains("axes 2, 3, 4 are parallel but for 0.02 deg\n"), "{text}");
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
}

#[test]
fn without_an_inverse_there_is_the_iteration_and_the_files_unit() {
    let rows = [
        "a: 0.1, alpha: 90, d: 0.3, theta: 0",
        "a: 0.4, alpha: 70, d: 0.1, theta: 0",
        "a: 0.3, alpha: 50, d: 0.2, theta: 0",
        "a: 0.2, alpha: 80, d: 0.1, theta: 0",
        "a: 0.3, alpha: -60, d: 0.1, theta: 0",
        "a: 0.1, alpha: 40, d: 0.1, theta: 0",
    ];
    let report = check("standard", &rows, "");
    let text = report.to_string();
    assert!(text.contains("miss by 0.") && text.contains(" m\n") && !text.contains(" mm"), "{text}");
    // Axes 5 and 6 are one line.
    let rows = rows.map(|row| row.replace("a: 0.3, alpha: -60", "a: 0, alpha: 0"));
    let text = check("standard", &rows.each_ref().map(String::as_str), "").to_string();
    assert!(text.contains("`denhart::numeric` solves any arm by iteration"), "{text}");
}

#[test]
fn position_angle_does_not_ask_for_a_joint_and_then_refuse_it() {
    let unsupported = |more: &str| check("standard", &YAW_PITCHES_ROLL, more).unsupported.unwrap();
    let plain = unsupported("inverse: {task: position_angle}");
    assert!(!plain.contains("the one whose value is given"), "{plain}");
    let given = unsupported("inverse: {redundant: q2}");
    assert!(!given.contains("takes no joint's value"), "{given}");
    assert!(given.ends_with("; leaving out `redundant` works"), "{given}");
}

#[test]
fn a_given_joint_that_the_task_cannot_spare_is_the_reason() {
    // A wrist whose axes meet.
    let rows = [
        "a: 0, alpha: 90, d: 0.4, theta: 0",
        "a: 0.5, alpha: 0, d: 0, theta: 0",
        "a: 0, alpha: 90, d: 0, theta: 90",
        "a: 0, alpha: -90, d: 0.5, theta: 0",
        "a: 0, alpha: 90, d: 0, theta: 0",
        "a: 0, alpha: 0, d: 0.1, theta: 0",
    ];
    let said = |more: &str| check("standard", &rows, more).unsupported.unwrap();
    assert_eq!(
        said("inverse: {task: pose, redundant: q3}"),
        "`redundant: q3` leaves 5 joints, fewer than `pose` needs; `task: position_axis` or leaving out `redundant` work"
    );
    assert_eq!(
        said("inverse: {task: position, redundant: q3}"),
        "`redundant: q3` leaves 5 joints, two more than `position` needs; `task: position_axis` or \
         `redundant: [q1, q3, q6]` work"
    );
    let planar = ["a: 1, alpha: 0, d: 0, theta: 0", "a: 1, alpha: 0, d: 0, theta: 0"];
    let alone = check("standard", &planar, "inverse: {redundant: q1}").unsupported.unwrap();
    assert_eq!(
        alone,
        "`redundant: q1` leaves 1 joint, fewer than `planar_position` needs; leaving out `redundant` works"
    );
    let pose = check("standard", &planar, "inverse: {task: pose, redundant: q1}").unsupported.unwrap();
    assert_eq!(pose, "the task `pose` is not covered for the 1 moving joint that `redundant: q1` leaves");
    let none = check("standard", &planar, "inverse: {task: planar_position, redundant: q1}").unsupported.unwrap();
    assert_eq!(
        none,
        "`redundant: q1` leaves 1 joint, fewer than `planar_position` needs; leaving out `redundant` works"
    );
}

/// A modified table typed as a standard one, of an arm that has no inverse by either.
#[test]
fn a_singular_table_that_is_not_by_the_other_convention_is_named() {
    let specs = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    for name in ["fanuc_crx10ial", "kinova_gen3_lite", "ufactory_xarm6"] {
        let text = std::fs::read_to_string(specs.join(name).with_extension("yaml")).unwrap();
        let typed = text.replacen("convention: modified", "convention: standard", 1);
        assert_ne!(text, typed, "{name}");
        let found = denhart_codegen::check(&typed, name).unwrap().to_string();
        let hint = "read as `convention: modified` the table is not singular everywhere: look which frames its rows";
        assert!(found.contains("the arm is singular everywhere") && found.contains(hint), "{name}: {found}");
        let right = denhart_codegen::check(&text, name).unwrap().to_string();
        assert!(!right.contains("read as"), "{name}: {right}");
    }
    // Singular by both conventions.
    let stacked = ["a: 0, alpha: 0, d: 0.1, theta: 0"; 6];
    let report = check("standard", &stacked, "").to_string();
    assert!(report.contains("singular everywhere") && !report.contains("read as"), "{report}");
}

#[test]
fn a_structure_that_an_arm_misses_by_more_than_rounding_is_verified() {
    let rows = |right: &str, wrist: &str| {
        [
            format!("a: 0, alpha: {right}, d: 0.6, theta: 0"),
            "a: 0.4, alpha: 0, d: 0, theta: 0".into(),
            format!("a: 0.1, alpha: -{right}, d: 0.2, theta: 0"),
            format!("a: 0, alpha: {right}, d: 0.4, theta: 0"),
            format!("a: {wrist}, alpha: -{right}, d: 0, theta: 0"),
            "a: 0, alpha: 0, d: 0, theta: 0".into(),
        ]
    };
    let code = |right: &str, wrist: &str| {
        let rows: String = rows(right, wrist).iter().map(|row| format!("  - {{{row}}}\n")).collect();
        let text = format!("name: first\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n{rows}");
        let report = denhart_codegen::check(&text, "first.yaml").unwrap().to_string();
        let options = denhart_codegen::Options::new("First");
        (report, denhart_codegen::generate(&text, "first.yaml", &options).unwrap().to_file().unwrap())
    };
    for (right, wrist) in [("90", "0"), ("1.5707963267948966 rad", "0"), ("90", "1e-15")] {
        let (report, code) = code(right, wrist);
        assert!(!report.contains("miss this structure") && !code.contains("in_doubt"), "{right} {wrist}: {report}");
    }
    // Ten decimals of an angle, and a wrist whose axes nearly meet.
    for (right, wrist) in [("1.57079632679 rad", "0"), ("90", "3e-12")] {
        let (report, code) = code(right, wrist);
        assert!(report.contains("the axes miss this structure by "), "{right} {wrist}: {report}");
        assert!(code.contains(".in_doubt()") && code.contains("every branch is verified"), "{right} {wrist}: {code}");
    }
}

/// Joints of an arm whose shoulder and wrist axes meet, on a rail.
const RAIL: [&str; 8] = [
    "type: prismatic, a: 0, alpha: -90, d: 0, theta: 0",
    "a: 0, alpha: 90, d: 0.34, theta: 0",
    "a: 0, alpha: -90, d: 0, theta: 0",
    "a: 0, alpha: 90, d: 0.4, theta: 0",
    "a: 0, alpha: -90, d: 0, theta: 0",
    "a: 0, alpha: 90, d: 0.4, theta: 0",
    "a: 0, alpha: -90, d: 0, theta: 0",
    "a: 0, alpha: 90, d: 0.126, theta: 0",
];

#[test]
fn a_list_of_another_length_is_told_with_lists_that_work() {
    let said = |more: &str| check("modified", &RAIL, more).unsupported.unwrap();
    let works = "`redundant: [q1, q2]` works";
    assert_eq!(said(""), format!("8 moving joints are two more than `pose` needs: give two values; {works}"));
    assert_eq!(
        said("inverse: {redundant: q1}"),
        format!("`redundant: q1` leaves 7 joints, one more than `pose` needs; {works}")
    );
    let many = said("inverse: {task: pose, redundant: [q1, q2, q4]}");
    assert!(many.starts_with("`redundant: [q1, q2, q4]` leaves 5 joints, fewer than `pose` needs; "), "{many}");
}

#[test]
fn the_values_that_may_be_given_are_listed_cheapest_first() {
    let report = check("modified", &RAIL, "inverse: {redundant: [q1, q4]}");
    let text = report.to_string();
    assert!(text.contains("values that may be given (`redundant`), the cheapest first:\n"), "{text}");
    assert_eq!(text.matches("(cheapest)").count(), 1, "{text}");
    assert!(report.choices.is_sorted_by_key(|choice| choice.way), "{text}");
    let named = |names: &str| report.choices.iter().any(|choice| choice.names == names);
    assert!(named("[q1, q4]") && named("[q1, arm_angle]"), "{text}");
    // One that needs all of its joints has none.
    let six = check("modified", &RAIL[1..7], "");
    assert!(six.choices.is_empty() && !six.to_string().contains("redundant"), "{six}");
}
