//! The parameters of an arm with an orthogonal base and a spherical wrist, as ROS-Industrial writes them.
//!
//! `T = Tz(c1) Rz(q1) T(a1, b, 0) Ry(q2) Tz(c2) Ry(q3) T(a2, 0, c3) Rz(q4) Ry(q5) Rz(q6) Tz(c4)`, with the turn `sign q - offset` of
//! each joint. Source: Brandstötter, Angerer, Hofbaur 2014; offsets and signs as in `opw_kinematics`.

use serde_yaml::Value;

use super::rigid::V;
use super::ur_calibration::turning;

const LENGTHS: [&str; 7] = ["a1", "a2", "b", "c1", "c2", "c3", "c4"];

/// The joints of a URDF from the text of the parameters.
///
/// # Errors
/// Text that is no such file; a parameter that is missing or is no number.
pub fn urdf(text: &str) -> Result<String, String> {
    let file: Value = serde_yaml::from_str(text).map_err(|error| format!("this is not YAML: {error}"))?;
    let lengths = find(&file, "opw_kinematics_geometric_parameters").ok_or(
        "no OPW parameters: expected `opw_kinematics_geometric_parameters: {a1: 0, a2: 0, b: 0, c1: 0, c2: 0, c3: 0, c4: 0}`",
    )?;
    let mut values = [0.0; 7];
    for (value, key) in values.iter_mut().zip(LENGTHS) {
        *value = lengths.get(key).and_then(number).ok_or_else(|| {
            format!(
                "`opw_kinematics_geometric_parameters` has no number `{key}`: all of {} are needed",
                LENGTHS.join(", ")
            )
        })?;
    }
    let offsets = six(&file, "opw_kinematics_joint_offsets", 0.0)?;
    let signs = six(&file, "opw_kinematics_joint_sign_corrections", 1.0)?;
    if let Some(sign) = signs.iter().find(|sign| sign.abs() != 1.0) {
        return Err(format!("`opw_kinematics_joint_sign_corrections`: expected 1 and -1, found {sign}"));
    }
    let [a1, a2, b, c1, c2, c3, c4] = values;
    // Where the frame of each joint is in that of the joint before, and its axis: y or z.
    let frames: [(V, bool); 6] = [
        ([0.0, 0.0, c1], false),
        ([a1, b, 0.0], true),
        ([0.0, 0.0, c2], true),
        ([a2, 0.0, c3], false),
        ([0.0; 3], true),
        ([0.0; 3], false),
    ];
    let mut out = "<robot name=\"opw\">\n<link name=\"base\"/>\n".to_owned();
    let mut parent = "base".to_owned();
    for (index, ((xyz, is_y), (offset, sign))) in frames.into_iter().zip(offsets.into_iter().zip(signs)).enumerate() {
        let (name, child) = (format!("joint_{}", index + 1), format!("link_{}", index + 1));
        let rpy = if is_y { [0.0, -offset, 0.0] } else { [0.0, 0.0, -offset] };
        let axis = match (is_y, sign < 0.0) {
            (true, false) => "0 1 0",
            (true, true) => "0 -1 0",
            (false, false) => "0 0 1",
            (false, true) => "0 0 -1",
        };
        turning(&mut out, &name, [&parent, &child], xyz, rpy, axis);
        parent = child;
    }
    out += &format!(
        "<link name=\"tool0\"/>\n<joint name=\"flange\" type=\"fixed\">\n<parent link=\"{parent}\"/>\n<child link=\"tool0\"/>\n<origin \
         xyz=\"0 0 {c4}\" rpy=\"0 0 0\"/>\n</joint>\n</robot>\n"
    );
    Ok(out)
}

/// The value of a key, at the top or one level below: the file is often a part of a group.
fn find<'v>(file: &'v Value, key: &str) -> Option<&'v Value> {
    file.get(key).or_else(|| file.as_mapping()?.values().find_map(|value| value.get(key)))
}

/// Six numbers; `default` each without the key.
fn six(file: &Value, key: &str, default: f64) -> Result<[f64; 6], String> {
    let Some(list) = find(file, key) else { return Ok([default; 6]) };
    let numbers: Option<Vec<f64>> = list.as_sequence().and_then(|list| list.iter().map(number).collect());
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| format!("`{key}`: expected six numbers, such as `[0, 0, deg(-90), 0, 0, 0]`"))
}

/// A finite number; `deg(..)` in degrees, `rad(..)` in radians.
fn number(value: &Value) -> Option<f64> {
    let text = match value {
        Value::String(text) => text.trim(),
        _ => return value.as_f64().filter(|number| number.is_finite()),
    };
    let within = |name: &str| text.strip_prefix(name)?.trim().strip_prefix('(')?.strip_suffix(')');
    let (digits, unit) = match (within("deg"), within("rad")) {
        (Some(inside), _) => (inside, 1_f64.to_radians()),
        (_, Some(inside)) => (inside, 1.0),
        _ => (text, 1.0),
    };
    digits.trim().parse().ok().map(|number: f64| number * unit).filter(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn bad_parameters_are_told() {
        let whole = "opw_kinematics_geometric_parameters: {a1: 0.1, a2: -0.13, b: 0, c1: 0.615, c2: 0.705, c3: 0.755, c4: 0.085}\n";
        assert!(urdf(whole).is_ok());
        for (text, part) in [
            ("{a1: 1}".to_owned(), "no OPW parameters"),
            (whole.replace("c4: 0.085", "c5: 1"), "no number `c4`"),
            (format!("{whole}opw_kinematics_joint_offsets: [0, 0]\n"), "expected six numbers"),
            (format!("{whole}opw_kinematics_joint_sign_corrections: [1, 1, 1, 1, 1, 2]\n"), "expected 1 and -1"),
        ] {
            let error = urdf(&text).unwrap_err();
            assert!(error.contains(part), "{error}");
        }
        assert_eq!(number(&Value::String("deg(-90)".into())), Some((-90_f64).to_radians()));
        assert_eq!(number(&Value::String("deg(x)".into())), None);
    }
}
