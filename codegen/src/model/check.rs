//! From the file as written to the checked chain.

use super::actuator::actuators;
use super::angle::Angle;
use super::arm::{Frame, InverseRequest, MOST_JOINTS, Model, Parameter, Row};
use super::calibration;
use super::combined_limits::combined_limits;
use super::coupling::coupling;
use super::joint::{Joint, JointKind};
use super::joint_names::range;
use super::reach::Sizes;
use super::redundant::redundant;
use super::weights::weights;
use crate::error::{Diagnostic, Errors};
use crate::spec::{FrameSpec, LimitsSpec, Place, RateSize, RateSpec, RowKind, Spec};

/// Checks what the values mean together, and converts them: angles exact, limits in rad, names filled in.
///
/// # Errors
/// All mistakes of the file, those of form that were found on reading it among them.
pub fn check(spec: &Spec) -> Result<Model, Errors> {
    let mut mistakes = spec.mistakes.clone();
    let joints = joints(spec, &mut mistakes);
    count(spec, &joints, &mut mistakes);
    unique_names(spec, &joints, &mut mistakes);
    let parameters = parameters(spec, &joints, &mut mistakes);
    let inverse = inverse(spec, &joints, &mut mistakes);
    let coupling = coupling(spec, &joints, &mut mistakes);
    let combined_limits = combined_limits(spec, &joints, &mut mistakes);
    let actuators = actuators(spec, &joints, &mut mistakes);
    let mut rows: Vec<Row> = spec
        .rows
        .iter()
        .enumerate()
        .map(|(index, row)| Row {
            kind: row.kind,
            a: row.a.clone(),
            alpha: row.alpha.into(),
            d: row.d.clone(),
            theta: row.theta.into(),
            name: row.name.as_ref().map(|(name, _)| name.clone()),
            joint: joints.iter().position(|joint| joint.row == index),
        })
        .collect();
    let nominal_rows = rows.clone();
    let deltas = calibration::added(spec, &joints, &mut rows, &mut mistakes);
    if !mistakes.is_empty() {
        return Err(Errors::new(mistakes));
    }
    let mut model = Model {
        name: spec.name.clone(),
        source: spec.source.leading_comment(),
        convention: spec.convention,
        length_unit: spec.length_unit,
        rows,
        base: frame(&spec.base),
        tool: frame(&spec.tool),
        joints,
        parameters,
        calibration: None,
        inverse,
        coupling,
        combined_limits,
        actuators,
    };
    if let Some((written, deltas)) = spec.calibration.as_ref().zip(deltas) {
        let nominal = Model { rows: nominal_rows, ..model.clone() };
        model.calibration = Some(calibration::compared(spec, written, deltas, [&nominal, &model], &mut mistakes));
    }
    if !mistakes.is_empty() {
        return Err(Errors::new(mistakes));
    }
    match Sizes::DOUBLE.missed(spec, &model) {
        Some(mistake) => Err(Errors::from(mistake)),
        None => Ok(model),
    }
}

fn frame(spec: &FrameSpec) -> Frame {
    Frame { xyz: spec.xyz.clone(), rpy: spec.rpy.map(Angle::from) }
}

/// The moving joints, named.
fn joints(spec: &Spec, mistakes: &mut Vec<Diagnostic>) -> Vec<Joint> {
    let mut joints = Vec::new();
    for (index, row) in spec.rows.iter().enumerate() {
        let kind = match row.kind {
            RowKind::Revolute => JointKind::Revolute,
            RowKind::Prismatic => JointKind::Prismatic,
            RowKind::Fixed => continue,
        };
        let name = row.name.as_ref().map_or_else(|| format!("q{}", joints.len() + 1), |(name, _)| name.clone());
        let limits = row.limits.as_ref().and_then(|(limits, place)| ordered(spec, *limits, place, mistakes));
        let (max_velocity, max_acceleration) = (rate(row.max_velocity.as_ref()), rate(row.max_acceleration.as_ref()));
        joints.push(Joint { name, row: index, kind, limits, max_velocity, max_acceleration });
    }
    joints
}

/// A rate in rad or length; infinite where there is none.
fn rate(written: Option<&RateSpec>) -> f64 {
    written.map_or(f64::INFINITY, |rate| match rate.size {
        RateSize::Angle(angle) => Angle::from(angle).rad(),
        RateSize::Length(length) => length,
    })
}

/// The limits in rad or length, the lowest first.
fn ordered(spec: &Spec, limits: LimitsSpec, place: &Place, mistakes: &mut Vec<Diagnostic>) -> Option<[f64; 2]> {
    let [low, high] = match limits {
        LimitsSpec::Angles(ends) => ends.map(|end| end.map(|angle| Angle::from(angle).rad())),
        LimitsSpec::Lengths(ends) => ends,
    };
    if low.is_none() && high.is_none() {
        return None;
    }
    Some(range(spec, [low, high], place, mistakes))
}

/// At least one joint moves, and not too many.
fn count(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) {
    let at = |row: usize| spec.rows.get(row).map(|row| spec.source.location(&row.place));
    // An empty table is a mistake of form and known already.
    if joints.is_empty() && !spec.rows.is_empty() {
        let message = "no joint moves: expected at least one row of type revolute or prismatic";
        let help =
            "write `type: revolute` or `type: prismatic` in the rows that move; without `type` a row is revolute";
        mistakes.push(Diagnostic::error(message).at(at(0)).help(help));
    }
    if let Some(joint) = joints.get(MOST_JOINTS) {
        let message = format!("{} moving joints: expected at most {MOST_JOINTS}", joints.len());
        let mistake = Diagnostic::error(message).at(at(joint.row)).label(format!("joint {}", MOST_JOINTS + 1));
        mistakes.push(mistake.help("write `type: fixed` in the rows that do not move"));
    }
}

/// No two joints have one name, given or filled in.
fn unique_names(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) {
    let given = |joint: &Joint| spec.rows.get(joint.row).and_then(|row| row.name.as_ref()).map(|(_, place)| place);
    for (index, joint) in joints.iter().enumerate() {
        let Some(first) = joints.iter().take(index).position(|earlier| earlier.name == joint.name) else { continue };
        let (name, number) = (&joint.name, index + 1);
        // A default name is nowhere in the file; then the given name is the one to change.
        let place = given(joint).or_else(|| joints.get(first).and_then(given));
        let nameless = [joints.get(first), Some(joint)].into_iter().flatten().any(|joint| given(joint).is_none());
        let default = if nameless { ": a joint without a name is called by its number" } else { "" };
        let message = format!("joints {} and {number} have the same name `{name}`{default}", first + 1);
        let mistake = Diagnostic::error(message).at(place.map(|place| spec.source.location(place)));
        mistakes.push(mistake.help("give each joint a name of its own"));
    }
    // `q3` means joint 3 everywhere: no other joint may be called so, even where that one has another name.
    for (index, joint) in joints.iter().enumerate() {
        let number = |other: usize| other != index && joint.name == format!("q{}", other + 1);
        let named_apart = |other: &usize| joints.get(*other).is_some_and(|other| other.name != joint.name);
        if let Some(other) = (0..joints.len()).find(|other| number(*other)).filter(named_apart) {
            let message = format!("joint {} has the name `{}`, which means joint {}", index + 1, joint.name, other + 1);
            let mistake = Diagnostic::error(message).at(given(joint).map(|place| spec.source.location(place)));
            mistakes.push(mistake.help("give it another name, or none"));
        }
    }
}

/// The parameters, none with the name of a joint.
fn parameters(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Vec<Parameter> {
    let parameter = |written: &crate::spec::ParameterSpec| {
        if let Some(joint) = joints.iter().position(|joint| joint.name == written.name) {
            let message = format!("the parameter `{}` has the name of joint {}", written.name, joint + 1);
            let mistake = spec.source.mistake(&written.place, message);
            mistakes.push(mistake.help("give the parameter a name of its own"));
        }
        Parameter { name: written.name.clone(), default: written.default }
    };
    spec.parameters.iter().map(parameter).collect()
}

fn inverse(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> InverseRequest {
    let request = &spec.inverse;
    let list = request.redundant.as_ref().filter(|redundant| redundant.is_list).map(|redundant| &redundant.place);
    let place = list.or(request.place.as_ref());
    InverseRequest {
        task: request.task,
        require: request.require,
        redundant: redundant(spec, joints, mistakes),
        axis: request.axis,
        tolerance_length: request.tolerance_length,
        tolerance_angle: request.tolerance_angle.map(|angle| Angle::from(angle).rad()),
        weights: weights(spec, joints, mistakes),
        at: place.map(|place| spec.source.location(place)),
        present: request.place.is_some(),
    }
}
