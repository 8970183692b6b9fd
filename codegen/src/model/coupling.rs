//! Linked joints: motor = A q + b, and the way back.

use super::joint::{Joint, JointKind};
use super::joint_names::{referred, value};
use super::rational::{Matrix, inverse};
use crate::error::Diagnostic;
use crate::spec::{CouplingSpec, Factor, MotorSpec, Place, Spec, TermSpec};

/// Largest product of the norms of a matrix and its inverse. Beyond, joint values that come back from motor values
/// have fewer than four digits left.
const MOST_CONDITION: f64 = 1e12;

/// `motor = matrix q + offset`, and `q = inverse (motor - offset)`. Motor i is in the unit of joint i.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupling {
    /// `[motor][joint]`
    pub matrix: Matrix,
    /// `[joint][motor]`
    pub inverse: Matrix,
    /// Motor values where all joints are 0, rad or length.
    pub offset: Vec<f64>,
}

/// The coupling of a file, if it has one.
pub fn coupling(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Option<Coupling> {
    let written = spec.coupling.as_ref()?;
    let before = mistakes.len();
    if joints.is_empty() || (written.matrix && !square(spec, written, joints, mistakes)) {
        return None;
    }
    let n = joints.len();
    let unit = |row: usize| (0..n).map(|column| if row == column { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let mut matrix: Matrix = (0..n).map(unit).collect();
    let mut offset = vec![0.0; n];
    let mut places: Vec<&Place> = vec![&written.place; n];
    let mut listed = Vec::new();
    for motor in &written.motors {
        let Some((index, joint)) = referred(spec, joints, "coupling", (&motor.joint, &motor.place), mistakes) else {
            continue;
        };
        if listed.contains(&index) {
            let message = format!("`coupling`: the motor of joint `{}` is listed twice", joint.name);
            mistakes.push(spec.source.mistake(&motor.place, message).help("remove one of the two"));
        }
        listed.push(index);
        let row = row(spec, joints, joint, motor, mistakes);
        let of_motor = motor.offset.as_ref().and_then(|offset| value(spec, "offset", joint.kind, offset, mistakes));
        if let (Some(to_row), Some(to_offset), Some(to_place)) =
            (matrix.get_mut(index), offset.get_mut(index), places.get_mut(index))
        {
            (*to_row, *to_offset, *to_place) = (row, of_motor.unwrap_or(0.0), &motor.place);
        }
    }
    if mistakes.len() > before {
        return None;
    }
    match inverse(&matrix) {
        Ok(inverse) if norm(&matrix) * norm(&inverse) <= MOST_CONDITION => Some(Coupling { matrix, inverse, offset }),
        Ok(_) => {
            let message = "`coupling`: the matrix is singular but for rounding: the motors hardly determine the joints";
            let help = "make its rows independent; a factor that is an exact ratio can be written with more digits";
            mistakes.push(spec.source.mistake(&written.place, message).help(help));
            None
        }
        Err(row) => {
            let place = places.get(row).copied().unwrap_or(&written.place);
            mistakes.push(singular(spec, joints, &matrix, row, place));
            None
        }
    }
}

/// As many rows as joints, and as many factors in each.
fn square(spec: &Spec, written: &CouplingSpec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> bool {
    let (n, rows) = (joints.len(), written.motors.len());
    let help = format!("the arm has {n} joints: write {n} rows of {n} factors");
    let before = mistakes.len();
    if rows != n {
        let message = format!("`coupling`: expected a matrix of {n} rows, one for each motor, found {rows}");
        mistakes.push(spec.source.mistake(&written.place, message).help(help));
        return false;
    }
    for (index, motor) in written.motors.iter().enumerate().filter(|(_, motor)| motor.terms.len() != n) {
        let (row, found) = (index + 1, motor.terms.len());
        let message = format!("`coupling`: expected {n} factors in row {row}, one for each joint, found {found}");
        mistakes.push(spec.source.mistake(&motor.place, message).help(help.clone()));
    }
    mistakes.len() == before
}

fn row(spec: &Spec, joints: &[Joint], of: &Joint, motor: &MotorSpec, mistakes: &mut Vec<Diagnostic>) -> Vec<f64> {
    let mut row = vec![0.0; joints.len()];
    let mut seen = Vec::new();
    for TermSpec { joint, factor, place } in &motor.terms {
        let Some((index, joint)) = referred(spec, joints, "coupling", (joint, place), mistakes) else { continue };
        if seen.contains(&index) {
            // Once by its name and once by its number.
            let message =
                format!("`coupling`: joint `{}` is in the sum of the motor of `{}` twice", joint.name, of.name);
            mistakes.push(spec.source.mistake(place, message).help("remove one of the two"));
        }
        seen.push(index);
        let factor = match (*factor, of.kind, joint.kind) {
            (Factor::Plain(factor), motor, joint) if factor == 0.0 || motor == joint => factor,
            (Factor::LengthPerRad(factor), JointKind::Prismatic, JointKind::Revolute) => factor,
            (factor, ..) => {
                mistakes.push(mixed(spec, of, joint, factor, place));
                continue;
            }
        };
        if let Some(to) = row.get_mut(index) {
            *to = factor;
        }
    }
    row
}

/// A factor whose unit does not lead from the joint to the motor.
fn mixed(spec: &Spec, motor: &Joint, joint: &Joint, factor: Factor, place: &Place) -> Diagnostic {
    let kind = |joint: &Joint| if joint.kind == JointKind::Revolute { "turns" } else { "slides" };
    let (of, from, motor_kind, joint_kind) = (&motor.name, &joint.name, kind(motor), kind(joint));
    let (message, help) = match (factor, motor.kind, joint.kind) {
        (Factor::Plain(factor), JointKind::Prismatic, JointKind::Revolute) => (
            format!("`coupling`: joint `{from}` {joint_kind} and `{of}` {motor_kind}: the factor needs a unit"),
            format!("write the travel for a turn of `{from}` in the file's length unit, such as `{factor} per rev`"),
        ),
        (_, JointKind::Revolute, JointKind::Prismatic) => (
            format!("`coupling`: joint `{from}` {joint_kind} and cannot turn the motor of `{of}`, which {motor_kind}"),
            format!(
                "let the motor of `{from}`, in length units, depend on `{of}` instead: `{from}: {{{from}: 1, {of}: 20 per rev}}`"
            ),
        ),
        _ => (
            format!("`coupling`: a length for a turn from joint `{from}` to the motor of `{of}`: each {motor_kind}"),
            "`per rev` is for a sliding motor that a turning joint moves; write a plain number".to_owned(),
        ),
    };
    spec.source.mistake(place, message).help(help)
}

fn singular(spec: &Spec, joints: &[Joint], matrix: &[Vec<f64>], row: usize, place: &Place) -> Diagnostic {
    let name = |index: usize| joints.get(index).map_or("", |joint| joint.name.as_str());
    let column = (0..joints.len()).find(|column| matrix.iter().all(|row| row.get(*column) == Some(&0.0)));
    let empty = matrix.get(row).is_some_and(|row| row.iter().all(|factor| *factor == 0.0));
    let why = match column {
        _ if empty => format!("nothing moves the motor of `{}`", name(row)),
        Some(column) => format!("joint `{}` moves no motor", name(column)),
        None => format!("the motor of `{}` follows from the other motors", name(row)),
    };
    let message = format!("`coupling`: the matrix is singular: {why}");
    let help = "each joint moves a motor of its own, possibly with others: the rows of the matrix are independent";
    spec.source.mistake(place, message).help(help)
}

/// Largest sum of magnitudes of a row.
fn norm(matrix: &[Vec<f64>]) -> f64 {
    matrix.iter().map(|row| row.iter().map(|factor| factor.abs()).sum()).fold(0.0, f64::max)
}
