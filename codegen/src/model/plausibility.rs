//! Plausibility of the numbers in a file: warnings of values that are in range and still look wrong, as in another unit
//! than the file's.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::arm::{InverseRequest, Model};
use super::calibration::implausible;
use super::far_frames::far_frames;
use super::joint::{Joint, JointKind};
use crate::error::Diagnostic;
use crate::spec::{LengthUnit, LimitsSpec, Place, RowSpec, Spec, Task, WrittenAngle, looks_like_radians};

/// No link of an arm is as long as this, m.
const LONGEST_LINK: f64 = 30.0;
/// An angle so near to a right one is that angle, rounded, rad ..
const ROUNDED: f64 = 1e-4;
/// .. and one so near was measured.
const NEARLY: f64 = 0.03;

/// Warnings of entries to look at again. The file is used as it stands.
pub fn plausibility_warnings(spec: &Spec, model: &Model) -> Vec<Diagnostic> {
    let mut found = far_frames(spec, model);
    if found.is_empty() {
        found.extend(too_long(spec));
    }
    found.extend(limits_in_radians(spec));
    found.extend(measured_twice(spec));
    found.extend(model.calibration.as_ref().and_then(|calibration| implausible(spec, calibration)));
    found.extend(model.joints.iter().filter_map(|joint| {
        let [low, high] = joint.limits?;
        let row = spec.rows.get(joint.row)?;
        let (_, place) = row.limits.as_ref().filter(|_| low == high)?;
        let message = format!("`limits`: joint `{}` cannot move, its limits are equal", joint.name);
        let add = if joint.kind == JointKind::Revolute { "theta" } else { "d" };
        let help = format!("write `type: fixed` and add the value to `{add}`, or other limits");
        Some(spec.source.warning(place, message).help(help))
    }));
    found
}

/// A length of a house: millimeters in a file of meters.
fn too_long(spec: &Spec) -> Option<Diagnostic> {
    let (meter, symbol) = match spec.length_unit {
        LengthUnit::Meter => (1.0, "m"),
        LengthUnit::Centimeter => (0.01, "cm"),
        LengthUnit::Millimeter => (0.001, "mm"),
        LengthUnit::Inch => (0.0254, "in"),
    };
    // Deltas of a calibration may be long and cancel: nearly parallel axes have their common normal far away.
    let deltas = || spec.calibration.iter().flat_map(|calibration| &calibration.deltas);
    let is_delta = |value: f64| deltas().any(|delta| [delta.a, delta.d].contains(&value));
    let lengths = spec.lengths.iter().filter(|(value, _)| !is_delta(*value));
    let (value, place) = lengths.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
    if value.abs() * meter <= LONGEST_LINK {
        return None;
    }
    let message = format!("{value} {symbol} is long for an arm");
    let help = match spec.length_unit {
        LengthUnit::Meter => "if the lengths are in mm, write `units: {length: mm}`",
        _ => "the lengths of the file are in the unit that `units` names",
    };
    Some(spec.source.warning(place, message).help(help))
}

/// Limits of less than a turn in rad, in a file of degrees: both within 2 pi, at least 0.5 apart, and no whole number.
fn limits_in_radians(spec: &Spec) -> Option<Diagnostic> {
    let small = |row: &RowSpec| -> Option<(Place, String)> {
        let (LimitsSpec::Angles(ends), place) = row.limits.as_ref()? else { return None };
        let degrees: Option<Vec<f64>> = ends
            .iter()
            .flatten()
            .map(|end| match end {
                WrittenAngle::Degrees(value) => Some(*value),
                _ => None,
            })
            .collect();
        let degrees = degrees.filter(|degrees| degrees.len() == 2)?;
        let within = degrees.iter().all(|value| value.abs() <= 1.001 * TAU);
        let apart = degrees.iter().fold(0.0, |width: f64, value| width.max(value.abs())) >= 0.5;
        let broken = degrees.iter().any(|value| value.fract() != 0.0);
        // One that is near a multiple of pi/4 has a warning already.
        let said = degrees.iter().any(|value| looks_like_radians(*value).is_some());
        let ends = degrees.iter().map(|value| format!("{value} rad")).collect::<Vec<_>>().join(", ");
        (within && apart && broken && !said).then(|| (place.clone(), format!("[{ends}]")))
    };
    let found: Vec<(Place, String)> = spec.rows.iter().filter_map(small).collect();
    let (first, in_radians) = found.first()?;
    let others = match found.len() - 1 {
        0 => String::new(),
        more => format!(" (and {more} more)"),
    };
    let written = spec.source.written(first);
    let message = format!("`limits`: {written} looks like radians{others}, and is degrees as the file's `units` say");
    let help = format!(
        "write `{in_radians}`, or the limits in degrees; `angle: rad` in `units` makes all angles of the file radians"
    );
    Some(spec.source.warning(first, message).help(help))
}

/// A table with the digits of a measurement, to which a calibration is added. Of drawn arms neighboring axes are parallel, at
/// right angles or far from both.
fn measured_twice(spec: &Spec) -> Option<Diagnostic> {
    spec.calibration.as_ref()?;
    let off = |row: &RowSpec| {
        let angle = row.alpha.rad();
        let quarters = (angle / FRAC_PI_2).round();
        (angle - quarters * FRAC_PI_2, 90.0 * quarters)
    };
    // What is nearer is the exact angle, rounded or cut off.
    let is_measured = |(off, _): &(f64, f64)| (ROUNDED..NEARLY).contains(&off.abs());
    let (row, (off, exact)) = spec.rows.iter().map(|row| (row, off(row))).find(|(_, off)| is_measured(off))?;
    let message = format!(
        "`alpha`: {} is off {exact} deg by {:.4} deg, as in a measured table, and `calibration` is added to it",
        row.alpha.text(spec.angle_unit),
        off.to_degrees()
    );
    let help = "write the maker's table under `joints`; if its rows are the measured ones, leave `calibration` out";
    Some(spec.source.warning(&row.place, message).help(help))
}

impl InverseRequest {
    /// Remarks that the joints whose values are given leave an arm that has a pose another task.
    pub fn changed_task(&self, joints: &[Joint], task: Option<Task>) -> Option<Diagnostic> {
        let spare = joints.len().checked_sub(6).filter(|_| self.task.is_none() && !self.redundant.is_empty())?;
        let left = joints.len().checked_sub(self.redundant.values.len()).filter(|left| *left < 6)?;
        let (names, task) = (self.redundant.written(joints), task?.name());
        let left = if left == 1 { "one joint".to_owned() } else { format!("{} joints", in_words(left)) };
        let message = format!("`redundant: {names}` leaves {left}: the task is `{task}`, not `pose`");
        let fewer = match spare {
            0 => "remove `redundant`".to_owned(),
            spare => format!("name {} in `redundant`", in_words(spare)),
        };
        let help = format!("{fewer} for a pose, or name the task that is meant: `task: {task}`");
        Some(Diagnostic::warning(message).at(self.at.clone()).help(help))
    }
}

/// A small number as a word.
pub fn in_words(number: usize) -> String {
    let words = ["no", "one", "two", "three", "four", "five"];
    words.get(number).map_or_else(|| number.to_string(), |word| (*word).to_owned())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::super::check;
    use crate::error::Diagnostic;
    use crate::spec;

    fn of(unit: &str, rows: &str) -> Vec<Diagnostic> {
        let text = format!("name: a\nconvention: standard\nunits: {{length: {unit}, angle: deg}}\njoints:\n{rows}");
        let (spec, _) = spec::read(&text, "a.yaml").unwrap();
        let model = check(&spec).unwrap();
        super::plausibility_warnings(&spec, &model)
    }

    fn row(a: &str, limits: &str) -> String {
        format!("  - {{a: {a}, alpha: 0, d: 0, theta: 0, limits: {limits}}}\n")
    }

    /// Axes that are nearly parallel have their common normal far away.
    #[test]
    fn deltas_that_cancel_are_not_long() {
        let far = "calibration:\n  q1: {d: 203.75}\n  q2: {d: -203.75}\n";
        let found = of("m", &(row("0.4", "[-90, 90]").repeat(2) + far));
        assert!(found.is_empty(), "{found:?}");
    }

    #[test]
    fn a_calibration_of_a_measured_table_is_remarked() {
        let rows = |alpha: &str| format!("  - {{a: 0.1, alpha: {alpha}, d: 0.2, theta: 0}}\n{}", row("0.1", "null"));
        let calibration = "calibration:\n  q1: {a: 0.001, alpha: 0.02}\n";
        let found = of("m", &(rows("90.02") + calibration));
        assert_eq!(found.len(), 1);
        assert!(found[0].message.contains("off 90 deg by 0.0200 deg") && found[0].help.is_some(), "{found:?}");
        for rows in [rows("90") + calibration, rows("-55") + calibration, rows("90.02")] {
            assert_eq!(of("m", &rows).len(), 0, "{rows}");
        }
    }

    #[test]
    fn a_calibration_of_centimeters_or_degrees_is_remarked() {
        let rows = format!("{}{}", row("0.5", "null"), row("0.5", "null"));
        for (delta, is_remarked) in [("a: 0.05", true), ("alpha: 2", true), ("a: 0.005, alpha: 0.3", false)] {
            let found = of("m", &format!("{rows}calibration:\n  q2: {{{delta}}}\n"));
            assert_eq!(found.len(), usize::from(is_remarked), "{delta} {found:?}");
            assert!(found.iter().all(|found| found.message.contains("moves link 2")), "{found:?}");
        }
    }

    #[test]
    fn lengths_of_a_house_are_remarked() {
        let found = of("m", &(row("300", "null") + &row("500", "null")));
        assert_eq!(found.len(), 1);
        let text = found[0].to_string();
        assert!(
            text.starts_with("a.yaml:6:") && text.contains("500 m is long") && text.contains("length: mm"),
            "{text}"
        );
        assert_eq!(of("mm", &row("500", "null")), []);
        assert_eq!(of("m", &row("30", "null")), []);
    }

    #[test]
    fn limits_in_radians_are_remarked_once() {
        let found = of("m", &(row("1", "[-2.96, 2.96]") + &row("1", "[-2.09, 2]")));
        assert_eq!(found.len(), 1);
        let text = found[0].to_string();
        assert!(text.contains("[-2.96, 2.96] looks like radians (and 1 more)"), "{text}");
        for limits in ["[-5, 5]", "[-2.96 rad, 2.96 rad]", "[-0.1, 0.2]", "[-17.5, 17.5]", "[null, 2.5]"] {
            assert_eq!(of("m", &row("1", limits)), [], "{limits}");
        }
    }

    #[test]
    fn a_joint_that_cannot_move_is_remarked() {
        let found = of("m", &row("1", "[30, 30]"));
        assert_eq!(found.len(), 1);
        assert!(found[0].to_string().contains("joint `q1` cannot move"), "{}", found[0]);
    }
}
