//! The calibration of an arm of Universal Robots: the file that its driver extracts, and `calibration.conf` of its controller.
//!
//! `kinematics: {shoulder: {x, y, z, roll, pitch, yaw}, upper_arm: .., forearm: .., wrist_1: .., wrist_2: .., wrist_3: ..}`: the
//! frame of each joint in that of the joint before, turned last about z by the joint. The base is that of the controller.
//! `delta_theta = [..]` and the like: six numbers each, added to the rows of the maker's table, lengths in m and angles in rad.

use std::fmt::Write;

use serde_yaml::Value;

use super::rigid::V;

/// The links in order, as the driver names them.
const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];
/// The joints, as the driver names them.
const JOINTS: [&str; 6] =
    ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"];

/// An angle of the driver's file is within a turn, rad.
const MOST_ANGLE: f64 = 6.4;

/// The joints of a URDF from the text of a calibration.
///
/// # Errors
/// Text that is no such file; a link that is missing or has not six numbers.
pub fn urdf(text: &str) -> Result<String, String> {
    let example = "expected `kinematics: {shoulder: {x: 0, y: 0, z: 0.1625, roll: 0, pitch: 0, yaw: 0}, upper_arm: ..}`, as \
                   `ur_calibration` of the driver writes it";
    if text.contains("delta_theta") {
        return Err("this is a `calibration.conf`: name the arm file it belongs to with `--nominal ARM`".to_owned());
    }
    let file: Value = serde_yaml::from_str(text).map_err(|error| format!("this is not YAML: {error}"))?;
    let Some(links) = file.get("kinematics").and_then(Value::as_mapping) else {
        return Err(format!("no calibration: {example}"));
    };
    let known = |name: &str| LINKS.contains(&name) || name == "hash";
    if let Some(other) = links.keys().filter_map(Value::as_str).find(|name| !known(name)) {
        return Err(format!("`{other}` is no link of a UR arm: the links are {}", LINKS.join(", ")));
    }
    let mut out = "<robot name=\"ur_calibrated\">\n<link name=\"base\"/>\n".to_owned();
    let mut parent = "base";
    for (link, joint) in LINKS.into_iter().zip(JOINTS) {
        let Some(frame) = links.get(link) else {
            return Err(format!("the link `{link}` is missing: {example}"));
        };
        let numbers = |keys: [&str; 3]| -> Result<V, String> {
            let mut values = [0.0; 3];
            for (value, key) in values.iter_mut().zip(keys) {
                let found = frame.get(key).and_then(Value::as_f64).filter(|number| number.is_finite());
                *value = found.ok_or_else(|| format!("`{link}` has no number `{key}`: {example}"))?;
            }
            Ok(values)
        };
        let (xyz, rpy) = (numbers(["x", "y", "z"])?, numbers(["roll", "pitch", "yaw"])?);
        if let Some(angle) = rpy.iter().find(|angle| angle.abs() > MOST_ANGLE) {
            return Err(format!("`{link}` is turned by {angle}: angles of this file are rad, at most a turn"));
        }
        turning(&mut out, joint, [parent, link], xyz, rpy, "0 0 1");
        parent = link;
    }
    out += "</robot>\n";
    Ok(out)
}

/// A joint that turns, and its child.
pub(super) fn turning(out: &mut String, name: &str, [parent, child]: [&str; 2], xyz: V, rpy: V, axis: &str) {
    let [xyz, rpy] = [xyz, rpy].map(|values| values.map(|value| value.to_string()).join(" "));
    // A string takes every text.
    let _ = write!(
        out,
        "<link name=\"{child}\"/>\n<joint name=\"{name}\" type=\"continuous\">\n<parent link=\"{parent}\"/>\n<child \
         link=\"{child}\"/>\n<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>\n<axis xyz=\"{axis}\"/>\n</joint>\n"
    );
}

/// The entry `calibration` of an arm file from a `calibration.conf`, for an arm with so many joints.
///
/// # Errors
/// A list that is missing, or has not six numbers; an arm of another number of joints.
pub fn entry(text: &str, joints: usize) -> Result<String, String> {
    if joints != LINKS.len() {
        return Err(format!("the arm of `--nominal` has {joints} joints, and the calibration is that of six"));
    }
    if text.contains("kinematics:") && !text.contains("delta_a") {
        return Err(
            "this is the file that the driver extracts, which has the whole arm: leave out `--nominal`".to_owned()
        );
    }
    let mut lists = Vec::new();
    for key in ["delta_a", "delta_alpha", "delta_d", "delta_theta"] {
        let numbers = list(text, key)?;
        lists.push(numbers.ok_or_else(|| format!("no `{key}`: expected `{key} = [0, 0, 0, 0, 0, 0]`"))?);
    }
    let mut out = "calibration:\n".to_owned();
    for joint in 0..joints {
        let of = |list: usize| lists.get(list).and_then(|numbers| numbers.get(joint)).copied().unwrap_or(0.0);
        let lengths = [("a", of(0)), ("d", of(2))].map(|(key, value)| format!("{key}: {value}"));
        let angles = [("alpha", of(1)), ("theta", of(3))].map(|(key, value)| format!("{key}: {value} rad"));
        let [[a, d], [alpha, theta]] = [lengths, angles];
        out += &format!("  q{}: {{{a}, {alpha}, {d}, {theta}}}\n", joint + 1);
    }
    Ok(out)
}

/// Lengths of the maker's table that the file may have beside the differences: `a` and `d`. None where it has none.
///
/// # Errors
/// A list that has not six numbers, or stands there twice.
pub fn lengths(text: &str) -> Result<Option<[Vec<f64>; 2]>, String> {
    Ok(list(text, "a")?.zip(list(text, "d")?).map(|(a, d)| [a, d]))
}

/// The six numbers of a line `key = [..]`; None where there is no such line.
fn list(text: &str, key: &str) -> Result<Option<Vec<f64>>, String> {
    let mut lines = text.lines().filter_map(|line| {
        let (name, list) = line.split_once('=')?;
        (name.trim() == key).then_some(list)
    });
    let example = format!("expected `{key} = [0, 0, 0, 0, 0, 0]`");
    let Some(list) = lines.next() else { return Ok(None) };
    if lines.next().is_some() {
        return Err(format!("`{key}` stands there twice: remove one of them"));
    }
    let inside = list.trim().strip_prefix('[').and_then(|list| list.strip_suffix(']'));
    let words = inside.ok_or_else(|| format!("`{key}` is no list in brackets: {example}"))?.split(',').map(str::trim);
    let numbers: Option<Vec<f64>> =
        words.map(|word| word.parse().ok().filter(|number: &f64| number.is_finite())).collect();
    let numbers = numbers.filter(|numbers| numbers.len() == LINKS.len());
    numbers.map(Some).ok_or_else(|| format!("`{key}` has not six numbers: {example}"))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn a_bad_calibration_is_told() {
        for (text, part) in [
            ("a: [", "this is not YAML"),
            ("delta_theta = [0]", "`--nominal ARM`"),
            ("name: ur5", "no calibration"),
            (
                "kinematics: {shoulder: {x: 0, y: 0, z: 0.1, roll: 0, pitch: 0, yaw: 0}}",
                "the link `upper_arm` is missing",
            ),
            ("kinematics: {shoulder: {x: 0, y: 0, z: 0.1, roll: 0, pitch: 0}}", "`shoulder` has no number `yaw`"),
            ("kinematics: {link_7: {x: 0}}", "`link_7` is no link of a UR arm"),
            (
                "kinematics: {shoulder: {x: 0, y: 0, z: 0.1, roll: 90.02, pitch: 0, yaw: 0}}",
                "`shoulder` is turned by 90.02: angles of this file are rad",
            ),
        ] {
            let error = urdf(text).unwrap_err();
            assert!(error.contains(part), "{error}");
        }
        let six = "[0, 0, 0, 0, 0, 1e-4]";
        let whole = format!("delta_a = {six}\ndelta_alpha = {six}\ndelta_d = {six}\ndelta_theta = {six}\n");
        assert!(
            entry(&whole, 6).unwrap().ends_with("q6: {a: 0.0001, alpha: 0.0001 rad, d: 0.0001, theta: 0.0001 rad}\n")
        );
        assert!(entry(&format!("{whole}delta_a = {six}\n"), 6).unwrap_err().contains("`delta_a` stands there twice"));
        assert_eq!(lengths(&whole).unwrap(), None);
        assert_eq!(lengths(&format!("a = {six}\nd = {six}")).unwrap().unwrap()[1][5], 1e-4);
        assert!(entry(&whole, 7).unwrap_err().contains("has 7 joints"));
        assert!(entry(&whole.replace("delta_d", "delta_x"), 6).unwrap_err().contains("no `delta_d`"));
        assert!(entry("kinematics: {shoulder: {x: 0}}", 6).unwrap_err().contains("leave out `--nominal`"));
        assert!(entry(&whole.replace(", 1e-4", ""), 6).unwrap_err().contains("has not six numbers"));
    }
}
