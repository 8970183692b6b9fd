//! Frames far from the arm: nearly parallel axes have their common normal far away. Their rows have lengths that cancel.
//!
//! A shift along an axis commutes with the joint's motion. So the frame behind a twist `(a, alpha)` may slide along the
//! next axis by `s = d / cos(alpha)`, to the foot of the frame before:
//! `Tz(d) Tx(a) Rx(alpha) Tz(-s) = Rz(phi) Tx(rho) Rz(-phi) Rx(alpha)`, with `(a, s sin(alpha))` as
//! `rho (cos(phi), sin(phi))`. The `d` of the next row grows by s.

use super::angle::Angle;
use super::arm::Model;
use super::reach::reach;
use crate::error::Diagnostic;
use crate::spec::{AngleUnit, Convention, Place, RowKind, RowSpec, Spec, WrittenAngle};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};

/// Axes with a smaller sine of their angle count as nearly parallel.
const NEARLY_PARALLEL: f64 = 0.2;
/// A `d` is far from the arm beyond so many lengths of the arm. An upright column is as long as the rest of an arm.
const FAR: f64 = 3.0;
/// Digits of a new number below this part of the arm's length, or of a rad, are rounding.
const ROUNDING: f64 = 1e-13;

/// A row of the table with its frame slid.
#[derive(Clone, Copy)]
struct Slid<'s> {
    /// The row of the file; none of a row that is added.
    of: Option<&'s RowSpec>,
    a: f64,
    alpha: WrittenAngle,
    d: f64,
    theta: WrittenAngle,
    /// True if its frame has slid, or the one before. The numbers of such a row may be those of the file all the same:
    /// a shift that goes on to the next row leaves none.
    moved: bool,
}

impl<'s> Slid<'s> {
    fn of(row: &'s RowSpec) -> Self {
        let (a, d) = (row.a.default_value(), row.d.default_value());
        Slid { of: Some(row), a, alpha: row.alpha, d, theta: row.theta, moved: false }
    }

    /// The row as a file has it, with the name and all that belongs to its joint.
    fn written(&self, spec: &Spec) -> String {
        let mut keys = Vec::new();
        let kind = self.of.map_or(RowKind::Fixed, |row| row.kind);
        if let Some((_, place)) = self.of.and_then(|row| row.name.as_ref()) {
            keys.push(format!("name: {}", spec.source.written(place)));
        }
        if kind != RowKind::Revolute {
            keys.push(format!("type: {}", kind.name()));
        }
        let [alpha, theta] = [self.alpha, self.theta].map(|angle| angle.text(spec.angle_unit));
        keys.push(format!("a: {}, alpha: {alpha}, d: {}, theta: {theta}", self.a, self.d));
        let limits = self.of.and_then(|row| row.limits.as_ref()).map(|(_, place)| ("limits", place));
        let rates = self.of.into_iter().flat_map(|row| {
            let rates = [("max_velocity", &row.max_velocity), ("max_acceleration", &row.max_acceleration)];
            rates.into_iter().filter_map(|(key, rate)| rate.as_ref().map(|rate| (key, &rate.place)))
        });
        let actuator = self.of.and_then(|row| row.actuator.as_ref()).map(|actuator| ("actuator", &actuator.place));
        keys.extend(
            limits
                .into_iter()
                .chain(rates)
                .chain(actuator)
                .map(|(key, place)| format!("{key}: {}", spec.source.written(place))),
        );
        format!("- {{{}}}", keys.join(", "))
    }
}

/// Warns of rows whose frames are farther away than [`FAR`] lengths of the arm, with rows of the same poses that keep
/// the frames near.
/// Rows with parameters are left alone: `rho` is no multiple of one.
pub fn far_frames(spec: &Spec, model: &Model) -> Vec<Diagnostic> {
    let typed: Vec<Slid> = spec.rows.iter().map(Slid::of).collect();
    let long = |rows: &[Slid]| rows.iter().map(|row| row.a.abs() + row.d.abs()).sum::<f64>();
    let near = slid(spec, &typed, 0.0, 0.0);
    let arm = reach(model, &HashMap::new()) - long(&typed) + long(&near);
    let rows = slid(spec, &typed, FAR * arm, ROUNDING * arm);
    let groups = rows.chunk_by(|a, b| a.moved == b.moved);
    groups.filter_map(|group| warning(spec, group, arm)).collect()
}

/// The rows with every frame at the foot of the frame before where `d` is beyond `far`. New lengths are rounded.
fn slid<'s>(spec: &Spec, typed: &[Slid<'s>], far: f64, rounding: f64) -> Vec<Slid<'s>> {
    let rounded = |value: f64, unit: f64| if unit > 0.0 { digits(value, unit) } else { value };
    let mut rows: Vec<Slid> = Vec::new();
    let mut left = typed.iter().copied();
    let mut next = left.next();
    while let Some(mut row) = next {
        next = left.next();
        let Some(after) = next.as_mut() else {
            rows.push(row);
            break;
        };
        let twist = if spec.convention == Convention::Standard { row } else { *after };
        let alpha = Angle::from(twist.alpha);
        if alpha.sin().abs() >= NEARLY_PARALLEL || row.d.abs() <= far {
            rows.push(row);
            continue;
        }
        let shift = row.d / alpha.cos();
        row.d = 0.0;
        (row.moved, after.moved) = (true, true);
        after.d = rounded(after.d + shift, rounding);
        if alpha.sin() == 0.0 {
            rows.push(row);
            continue;
        }
        let (rho, phi) = polar(twist.a, shift * alpha.sin());
        let rho = rounded(rho, rounding);
        let theta = turned(spec, WrittenAngle::ZERO, -phi);
        let added = Slid { of: None, a: 0.0, alpha: WrittenAngle::ZERO, d: 0.0, theta, moved: true };
        row.theta = turned(spec, row.theta, phi);
        match spec.convention {
            Convention::Standard => {
                rows.push(Slid { a: rho, alpha: WrittenAngle::ZERO, ..row });
                rows.push(Slid { alpha: twist.alpha, ..added });
            }
            Convention::Modified => {
                rows.push(row);
                rows.push(Slid { a: rho, ..added });
                after.a = 0.0;
            }
        }
    }
    rows
}

/// Length and angle of a plane vector; the angle is in -90 to 90 degrees, and the length has a sign.
fn polar(x: f64, y: f64) -> (f64, f64) {
    let (length, angle) = (x.hypot(y), y.atan2(x));
    if angle.abs() <= FRAC_PI_2 { (length, angle) } else { (-length, angle - PI.copysign(angle)) }
}

/// The sum of an angle and a turn in rad, in the file's unit.
fn turned(spec: &Spec, angle: WrittenAngle, turn: f64) -> WrittenAngle {
    let sum = angle.rad() + turn;
    match spec.angle_unit {
        AngleUnit::Degree => WrittenAngle::Degrees(digits(sum.to_degrees(), ROUNDING.to_degrees())),
        AngleUnit::Radian => WrittenAngle::Radians(digits(sum, ROUNDING)),
    }
}

/// The value without digits below `unit`.
fn digits(value: f64, unit: f64) -> f64 {
    let places = usize::try_from(-unit.log10().floor().clamp(-300.0, 300.0) as i32).unwrap_or(0);
    // A number in place of -0.
    format!("{value:.places$}").parse().unwrap_or(value) + 0.0
}

/// The warning of one run of rows with slid frames, if one of its twists is far. The run ends with the row that takes up
/// the last shift.
fn warning(spec: &Spec, group: &[Slid], arm: f64) -> Option<Diagnostic> {
    let of: Vec<&RowSpec> = group.iter().filter_map(|row| row.of).collect();
    let has_parameter = of.iter().any(|row| row.a.parameter().or(row.d.parameter()).is_some());
    if of.len() == group.len() || has_parameter {
        return None;
    }
    let number = |row: &RowSpec| spec.rows.iter().position(|other| other.place == row.place).map(|index| index + 1);
    let (first, last) = (of.first()?, of.last()?);
    let farthest = of.iter().map(|row| row.d.default_value()).max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let is_of = |place: &Place, row: &RowSpec| place.steps().starts_with(row.place.steps());
    let place = spec.lengths.iter().find(|(value, place)| *value == farthest && of.iter().any(|row| is_of(place, row)));
    let unit = spec.length_unit.symbol();
    let message = format!(
        "`d` of {farthest} {unit}: the axes of rows {} to {} are nearly parallel, and their common normals are far from the \
         arm of about {} {unit}",
        number(first)?,
        number(last)?,
        digits(arm, 1e-2 * arm)
    );
    let rows: Vec<String> = group.iter().map(|row| row.written(spec)).collect();
    let help = format!(
        "write these rows in their place: the poses are the same, with the frames at the arm\n{}",
        rows.join("\n")
    );
    Some(spec.source.warning(place.map_or(&first.place, |(_, place)| place), message).help(help))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::super::chain::{Chain, Elementary};
    use super::super::numeric::{Transform, distance};
    use super::super::{Model, check, plausibility_warnings};
    use crate::error::Diagnostic;
    use crate::spec;

    fn read(text: &str) -> (Model, Vec<Diagnostic>) {
        let (spec, _) = spec::read(text, "a.yaml").unwrap();
        let model = check(&spec).unwrap();
        let found = plausibility_warnings(&spec, &model);
        (model, found)
    }

    fn pose(model: &Model, q: impl Fn(usize) -> f64) -> Transform {
        Chain::of(model).transforms.iter().fold(Transform::IDENTITY, |pose, step| {
            let motion = match step {
                Elementary::Revolute { joint, .. } => Transform::rotate_z(q(*joint).sin(), q(*joint).cos()),
                Elementary::Prismatic { joint } => Transform::shift([0.0, 0.0, q(*joint)]),
                _ => Transform::IDENTITY,
            };
            pose.then(&motion).then(&Transform::of(step))
        })
    }

    /// Puts the rows of the warning in the place of lines `first` to `last` of the text, from 1, and compares the arms.
    #[track_caller]
    fn replaced(text: &str, first: usize, last: usize, size: f64) -> String {
        let (far, found) = read(text);
        let [warning] = found.as_slice() else { unreachable!("{found:#?}") };
        let help = warning.help.as_ref().unwrap();
        let (_, rows) = help.split_once('\n').unwrap();
        let rows: Vec<String> = rows.lines().map(|row| format!("  {row}")).collect();
        assert!(rows.iter().any(|row| row.contains("type: fixed, ")), "{help}");
        let mut lines: Vec<&str> = text.lines().collect();
        lines.splice(first - 1..last, rows.iter().map(String::as_str));
        let text = lines.join("\n");
        let (near, left) = read(&text);
        assert!(left.is_empty(), "{text}\n{left:?}");
        assert_eq!(near.joints.len(), far.joints.len());
        for (near, far) in near.joints.iter().zip(&far.joints) {
            assert_eq!((&near.name, near.kind, near.limits), (&far.name, far.kind, far.limits));
        }
        for trial in 0..20 {
            let q = |joint: usize| (3.7 * f64::from(trial) + 1.3 * joint as f64).sin() * 2.5;
            let (near, far) = (pose(&near, q), pose(&far, q));
            assert!(distance(near.p, far.p) < 1e-11 * size, "{text}: {near:?} {far:?}");
            for column in 0..3 {
                assert!(distance(near.axis(column), far.axis(column)) < 1e-11, "{text}: {near:?} {far:?}");
            }
        }
        assert!(super::reach(&near, &std::collections::HashMap::new()) < size, "{text}");
        warning.to_string()
    }

    #[test]
    fn rows_that_keep_the_frames_near_have_the_poses_of_the_table() {
        let head = "convention: standard\nunits: {length: m, angle: deg}\njoints:\n";
        let text = head.to_owned()
            + "  - {a: 0, alpha: 90, d: 0.089, theta: 0}
  - {name: lift, a: -0.425, alpha: 0.0974, d: 298.2, theta: 1.5, limits: [-180, 170.5]}
  - {a: -0.392, alpha: -0.08, d: -298.1, theta: -0.3}
  - {name: 'wrist 1', a: 0, alpha: 90, d: 0.1, theta: 0}
  - {a: 0, alpha: -90, d: 0.095, theta: 0}
  - {a: 0, alpha: 0, d: 0.082, theta: 0}
";
        let said = replaced(&text, 5, 6, 3.0);
        assert!(
            said.starts_with("a.yaml:5:47: warning: `d` of 298.2 m: the axes of rows 2 to 3 are nearly parallel"),
            "{said}"
        );
        // Three axes whose common normals are far: two rows are added.
        let three = text.replace("d: 298.2", "d: 43").replace("d: -298.1", "d: -156").replace("d: 0.1,", "d: 113.1,");
        let said = replaced(&three, 5, 7, 3.0);
        assert!(
            said.contains("`d` of -156 m") && said.contains("rows 2 to 4") && said.contains("name: 'wrist 1'"),
            "{said}"
        );
        // In other units.
        let rad = text.replace("angle: deg", "angle: rad").replace(": 90,", ": pi/2,").replace(": -90,", ": -pi/2,");
        let rad = rad.replace("0.0974", "0.0017").replace("-0.08", "-1.4e-3").replace("-180, 170.5", "-3, 2.9");
        replaced(&rad, 5, 6, 3.0);
        let inches = text.replace("length: m", "length: in").replace("}\n", ", actuator: {pulses_per_rev: 400}}\n");
        let inches = inches.replace("deg, actuator: {pulses_per_rev: 400}}", "deg}");
        let said = replaced(&inches, 5, 6, 3.0);
        assert!(
            said.contains("298.2 in") && said.contains("limits: [-180, 170.5], actuator: {pulses_per_rev: 400}}"),
            "{said}"
        );
    }

    #[test]
    fn both_conventions_slides_and_fixed_rows_keep_their_frames_near() {
        let head = "convention: modified\nunits: {length: mm, angle: deg}\njoints:\n";
        let text = head.to_owned()
            + "  - {a: 0, alpha: 0, d: 150, theta: 0}
  - {a: 20, alpha: 90, d: 160000, theta: 10}
  - {a: 420, alpha: -179.9, d: 160050, theta: 20}
  - {type: prismatic, a: 300, alpha: 0.1, d: 90, theta: 20, limits: [0, 300]}
  - {a: 0, alpha: 90, d: 90, theta: 20}
";
        replaced(&text, 5, 6, 3000.0);
        let slide =
            text.replace("a: 420", "type: prismatic, a: 420").replace("type: prismatic, a: 300", "type: fixed, a: 300");
        replaced(&slide.replace("limits: [0, 300]", "name: plate"), 5, 6, 3000.0);
        let standard =
            text.replace("modified", "standard").replace("d: 160000", "d: 90").replace("d: 160050", "d: 90000");
        let slide = "type: prismatic, a: 300, alpha: 0.1, d: 90, theta: 20, limits: [0, 300]";
        let standard = standard.replace(slide, "type: fixed, a: 30, alpha: 0, d: 90, theta: 20");
        // The shift goes on through a row without a tilt.
        let standard = standard.replace("{a: 0, alpha: 90, d: 90,", "{a: 0, alpha: 90, d: 90000,");
        replaced(&standard, 6, 8, 3000.0);
    }

    /// A row without a tilt takes a shift and hands it on whole: its own numbers are those of the file.
    #[test]
    fn a_row_that_hands_a_shift_on_is_among_the_rows() {
        let text = "convention: standard\nunits: {length: m, angle: rad}\njoints:
  - {a: 0, alpha: pi/2, d: 0.1, theta: 0}
  - {a: 1e-5, alpha: 0.0017, d: 113, theta: 0.2}
  - {a: 0.3, alpha: 0, d: 0, theta: -0.2}
  - {a: 0.2, alpha: 0, d: -112.9, theta: -0.9}
";
        let said = replaced(text, 5, 7, 3.0);
        assert!(said.contains("rows 2 to 4 are nearly parallel"), "{said}");
        // The twist of a modified row stands in the row behind.
        let modified = "convention: modified\nunits: {length: m, angle: rad}\njoints:
  - {a: 0, alpha: 0, d: 0.3, theta: 0}
  - {a: 0, alpha: pi/2, d: 300.1, theta: 0.2}
  - {a: 0.4, alpha: 0.001, d: 0, theta: -0.2}
  - {a: 0.3, alpha: 0, d: 0, theta: 0.5}
  - {a: 0.1, alpha: 0, d: -300, theta: -0.9}
";
        replaced(modified, 5, 8, 3.0);
    }

    #[test]
    fn no_warning_where_frames_are_near_or_lengths_have_names() {
        let arm = |rows: &str| read(&format!("convention: standard\nunits: {{length: mm, angle: deg}}\n{rows}")).1;
        // A tilted column, as tall as the rest of the arm; parallel axes without a tilt.
        let column = "joints:
  - {a: 300, alpha: 0.01, d: 700, theta: 0}
  - {a: 250, alpha: 180, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 650, theta: 0}
";
        assert_eq!(arm(column), []);
        let parallel = column.replace("alpha: 0.01, d: 700", "alpha: 0, d: 7000").replace("d: 650", "d: 6950");
        assert_eq!(arm(&parallel), []);
        let far = column.replace("d: 700", "d: 7000").replace("d: 650", "d: 6950");
        assert_eq!(arm(&far).len(), 1);
        let named = far.replace("a: 300", "a: l1").replace("joints:", "parameters: {l1: 300}\njoints:");
        assert_eq!(arm(&named), []);
    }
}
