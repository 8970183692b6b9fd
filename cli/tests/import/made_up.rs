//! `denhart import` on small URDF files made up for what is hard about them.

use crate::{model, refused, text, written};

/// A joint of a chain: type, xyz and rpy of the origin, axis.
type Joint<'t> = (&'t str, &'t str, &'t str, &'t str);

/// A chain of joints j1, j2, .. from link l0 on.
pub fn chain(joints: &[Joint]) -> String {
    let links = (0..=joints.len()).map(|index| format!("<link name=\"l{index}\"/>\n"));
    let joints = joints.iter().enumerate().map(|(index, (kind, xyz, rpy, axis))| {
        let next = index + 1;
        format!(
            "<joint name=\"j{next}\" type=\"{kind}\"><parent link=\"l{index}\"/><child link=\"l{next}\"/>\
             <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"{axis}\"/><limit lower=\"-2\" upper=\"2\"/></joint>\n"
        )
    });
    format!("<robot name=\"chain\">\n{}{}</robot>\n", links.collect::<String>(), joints.collect::<String>())
}

/// The arm file of a URDF, and what was said.
pub fn imported(urdf: &str, arguments: &[&str]) -> (String, String) {
    let output = written(urdf, arguments);
    assert!(output.status.success(), "{}\n{urdf}", text(&output.stderr));
    (text(&output.stdout), text(&output.stderr))
}

#[test]
fn an_angle_made_exact_moves_links_that_cancel_at_zero() {
    let cancelling = [
        ("revolute", "-0.25 0 0", "0 -7.8e-07 -5.9e-07", "-1 0 0"),
        ("revolute", "0.3 0 0", "-3.14159 0 0", "0.39 0.21 0.82"),
    ];
    let (_, said) = imported(&chain(&cancelling), &[]);
    assert!(said.contains("2 angles were made exact before that"), "{said}");
    // A slide of 2 m beyond the angle moves as far as a link of 2 m.
    let sliding = [("revolute", "0 0 0", "0 0 0", "0 0 1"), ("prismatic", "0.01 0 0", "0 9e-7 0", "1 0 0")];
    imported(&chain(&sliding), &[]);
    // A range with one end is tried up to 2 m above that end.
    let (_, said) = imported(
        &chain(&sliding).replacen("upper=\"2\"/></joint>\n</robot>", "upper=\"inf\"/></joint>\n</robot>", 1),
        &[],
    );
    assert!(said.contains("an end beyond 1e6 is taken as none"), "{said}");
}

#[test]
fn a_table_that_misses_the_urdf_is_told_with_the_bound_it_misses() {
    let far =
        [("revolute", "0.3e9 0.7e9 0", "0 0.3 0.2", "0 0 1"), ("revolute", "1.1e9 0 0", "1 0 0", "0.39 0.21 0.82")];
    let said = refused(&chain(&far), &[]);
    assert!(
        said.contains("the table misses the URDF by ") && said.contains(": expected at most 1.0e-9 m and 1.0e-9 rad"),
        "{said}"
    );
}

/// The `d` of each row, m.
fn offsets(file: &str) -> Vec<f64> {
    model(file).rows.iter().map(|row| row.d.default_value()).collect()
}

#[test]
fn a_calibrated_arm_has_no_offset_beyond_its_size() {
    let tilts = [
        "0.0017 -0.0012 0",
        "1.5719 0.0014 0.002",
        "-0.0017 0.0009 0.001",
        "0.0011 -0.0016 0",
        "1.5703 0.0005 0",
        "-1.5712 0.0003 0",
    ];
    let origins = ["0 0 0.1521", "0.0001 0 0", "-0.2435 0.0002 0", "-0.2134 0 0.1311", "0 -0.0853 0", "0 0.0921 0"];
    let joints: Vec<_> = tilts.iter().zip(origins).map(|(rpy, xyz)| ("revolute", xyz, *rpy, "0 0 1")).collect();
    let (file, said) = imported(&chain(&joints), &[]);
    let most = offsets(&file).into_iter().fold(0.0, |most: f64, d| most.max(d.abs()));
    assert!(most < 0.6, "{file}");
    assert!(!said.contains("millimeters"), "{said}");
    assert_eq!(file.matches("type: fixed").count(), 2, "{file}");
    // Joint 1 and the wrist are far from parallel: their rows have the common normal.
    assert_eq!(model(&file).rows.len(), 8);
    assert!(said.contains("from the URDF's by at most "), "{said}");
}

#[test]
fn velocities_of_the_urdf_are_those_of_the_file() {
    let joints = [
        ("revolute", "0 0 0.3", "0 0 0", "0 0 1"),
        ("prismatic", "0.2 0 0", "0 0 0", "0 0 1"),
        ("continuous", "0.2 0 0", "0 0 0", "0 0 1"),
    ];
    let limit = "<limit lower=\"-2\" upper=\"2\"/>";
    let with = |velocity: &str| format!("<limit lower=\"-2\" upper=\"2\" effort=\"9\" velocity=\"{velocity}\"/>");
    let urdf = chain(&joints).replacen(limit, &with("3.1"), 1).replacen(limit, &with("0.25"), 1).replacen(
        limit,
        &with("0"),
        1,
    );
    let (file, _) = imported(&urdf, &[]);
    let rates: Vec<(f64, f64)> =
        model(&file).joints.iter().map(|joint| (joint.max_velocity, joint.max_acceleration)).collect();
    assert_eq!(rates, [(3.1, f64::INFINITY), (0.25, f64::INFINITY), (f64::INFINITY, f64::INFINITY)], "{file}");
    assert!(file.contains("max_velocity: 3.1 rad") && file.contains("max_velocity: 0.25"), "{file}");
    // Beyond a mimic joint on its own line a joint turns twice as fast as its motor, against which that counts.
    let doubled = [
        ("revolute", "0 0 0.3", "0 0 0", "0 0 1"),
        ("revolute", "0 0 0", "0 0 0", "0 0 1"),
        ("revolute", "0.2 0 0", "1 0 0", "0 0 1"),
    ];
    let urdf = chain(&doubled).replacen(limit, &with("3"), 1).replacen(limit, &with("0.5"), 1);
    let second = urdf.find("name=\"j2\"").and_then(|from| urdf[from..].find("</joint>").map(|at| from + at)).unwrap();
    let urdf = format!("{}<mimic joint=\"j1\"/>{}", &urdf[..second], &urdf[second..]);
    let (file, _) = imported(&urdf, &[]);
    let rates: Vec<f64> = model(&file).joints.iter().map(|joint| joint.max_velocity).collect();
    assert_eq!(rates, [1.0, f64::INFINITY], "{file}");
}
