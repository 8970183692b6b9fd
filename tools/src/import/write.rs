//! The arm file of an import.

use super::mimic_coupling::MimicCoupling;
use super::number::{angle, shortest};
use super::rigid::{Transform, V, rpy};
use super::table::{Row, Table};

/// The rounding of the digits of the file, relative to the size of the arm, or rad.
const DIGITS: f64 = 1e-13;

/// Writes the file. `head` are the lines of its comment.
///
/// # Errors
/// Motors that the joints do not determine.
pub fn file(name: &str, head: &[String], table: &Table, coupling: &MimicCoupling) -> Result<String, String> {
    let mut lines: Vec<String> = head.iter().map(|line| comment(line)).collect();
    lines.push(format!("name: {}", arm_name(name)));
    lines.push("convention: standard".to_owned());
    lines.push("units: {length: m, angle: deg}".to_owned());
    let length = |value: f64| shortest(value, DIGITS * table.size);
    lines.extend(frame("base", &table.base, table.size));
    lines.push("joints:".to_owned());
    lines.extend(table.rows.iter().map(|row| row_text(row, coupling, &length)));
    lines.extend(frame("tool", &table.tool, table.size));
    if !coupling.is_identity() {
        lines.extend(coupling_lines(coupling, &length)?);
    }
    Ok(lines.join("\n") + "\n")
}

fn row_text(row: &Row, coupling: &MimicCoupling, length: &dyn Fn(f64) -> String) -> String {
    let mut entries = Vec::new();
    let motor = row.axis.and_then(|axis| coupling.motors.get(axis));
    let turns = motor.is_none_or(|motor| motor.turns);
    match motor {
        Some(motor) => entries.push(format!("name: {}", quoted(&motor.file_name))),
        None => entries.push("type: fixed".to_owned()),
    }
    if !turns {
        entries.push("type: prismatic".to_owned());
    }
    let Row { a, alpha, d, theta, .. } = row;
    entries.push(format!("a: {}, alpha: {}, d: {}, theta: {}", length(*a), turn(*alpha), length(*d), turn(*theta)));
    if let Some([low, high]) = row.axis.and_then(|axis| coupling.limits.get(axis).copied().flatten()) {
        let end = |value: f64| if turns { turn(value) } else { length(value) };
        let end = |value: f64| if value.is_infinite() { "null".to_owned() } else { end(value) };
        entries.push(format!("limits: [{}, {}]", end(low), end(high)));
    }
    if let Some(velocity) = row.axis.and_then(|axis| coupling.velocities.get(axis).copied().flatten()) {
        entries.push(format!("max_velocity: {}", if turns { turn(velocity) } else { length(velocity) }));
    }
    format!("  - {{{}}}", entries.join(", "))
}

fn turn(value: f64) -> String {
    angle(value, DIGITS)
}

/// A constant frame, unless it is none.
fn frame(key: &str, frame: &Transform, size: f64) -> Option<String> {
    let list = |values: V, text: &dyn Fn(f64) -> String| values.map(text).join(", ");
    let xyz = list(frame.p, &|value| shortest(value, DIGITS * size));
    let rpy = list(rpy(frame), &turn);
    (xyz != "0, 0, 0" || rpy != "0, 0, 0").then(|| format!("{key}: {{xyz: [{xyz}], rpy: [{rpy}]}}"))
}

/// The motors that are not their joints, and the ranges of those.
fn coupling_lines(coupling: &MimicCoupling, length: &dyn Fn(f64) -> String) -> Result<Vec<String>, String> {
    let (matrix, offset) = coupling.inverted()?;
    let names: Vec<String> = coupling.motors.iter().map(|motor| quoted(&motor.file_name)).collect();
    let (mut motors, mut ranges) = (Vec::new(), Vec::new());
    for (index, ((row, offset), motor)) in matrix.iter().zip(&offset).zip(&coupling.motors).enumerate() {
        let value = |value: f64| if motor.turns { turn(value) } else { length(value) };
        let terms: Vec<String> = row
            .iter()
            .zip(&names)
            .filter(|(factor, _)| factor.abs() > DIGITS)
            .map(|(factor, name)| format!("{name}: {}", shortest(*factor, DIGITS)))
            .collect();
        let own = matches!(&terms[..], [one] if names.get(index).is_some_and(|name| *one == format!("{name}: 1")));
        if own && *offset == 0.0 {
            continue;
        }
        let constant = if value(*offset) == "0" { String::new() } else { format!(", offset: {}", value(*offset)) };
        let name = quoted(&motor.file_name);
        motors.push(format!("  {name}: {{{}{constant}}}", terms.join(", ")));
        // A row that several motors drive has no range of its own.
        if let (Some([low, high]), Some(None)) = (motor.limits, coupling.limits.get(index)) {
            let end = |end: f64| if end.is_infinite() { "null".to_owned() } else { value(end - offset) };
            let ends = [low, high].map(end).join(", ");
            ranges.push(format!("  - {{sum: {{{}}}, limits: [{ends}]}}", terms.join(", ")));
        }
    }
    let mut lines =
        vec!["# The motors, in the values of the joints: motor = A q + offset.".to_owned(), "coupling:".to_owned()];
    lines.extend(motors);
    if !ranges.is_empty() {
        lines.push("combined_limits:".to_owned());
        lines.extend(ranges);
    }
    Ok(lines)
}

/// A line of the head comment. Line breaks in a name of the URDF do not end the comment.
fn comment(line: &str) -> String {
    format!("# {}", line.replace(breaks, " ")).trim_end().to_owned()
}

/// True for a character that may end a line of YAML or cannot be seen.
fn breaks(c: char) -> bool {
    c.is_control() || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}')
}

/// A name as YAML: in quotes unless it is a plain word.
pub fn quoted(name: &str) -> String {
    let plain = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    let word = ["true", "false", "yes", "no", "on", "off", "null", "y", "n", "nan", "inf", "offset", "matrix"];
    if plain && !word.contains(&name.to_lowercase().as_str()) {
        name.to_owned()
    } else {
        let escaped = name.chars().map(|c| match c {
            '\\' => "\\\\".to_owned(),
            '"' => "\\\"".to_owned(),
            c if breaks(c) => format!("\\u{:04x}", u32::from(c)),
            c => c.to_string(),
        });
        format!("\"{}\"", escaped.collect::<String>())
    }
}

/// The arm's name: letters, digits and `_`, which any name of a type can be made of.
fn arm_name(name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let name = name.trim_matches('_').to_owned();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { quoted(&name) } else { format!("robot_{name}") }
}

#[cfg(test)]
mod tests {
    use super::{arm_name, comment, quoted};

    #[test]
    fn names_are_yaml() {
        assert_eq!(quoted("joint_a1"), "joint_a1");
        assert_eq!(quoted("arm/joint 1"), "\"arm/joint 1\"");
        assert_eq!(quoted("j\n1\u{2028}"), "\"j\\u000a1\\u2028\"");
        assert_eq!(comment("from `base\nname: evil`\r\n"), "# from `base name: evil`");
        assert_eq!(quoted("no"), "\"no\"");
        assert_eq!(quoted("7"), "\"7\"");
        assert_eq!(arm_name("kuka-kr6 r700"), "kuka_kr6_r700");
        assert_eq!(arm_name("7dof"), "robot_7dof");
    }
}
