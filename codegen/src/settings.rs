//! Entries of an arm file beside its table, in words.

use crate::model::{Calibration, JointKind, Model, Parameter, joint_sum};

/// The lines of `denhart check` on names, parameters, linked joints, sums with limits and motors that count; none where
/// the file has none.
pub fn describe(model: &Model, parameters: &[Parameter]) -> Vec<String> {
    let unit = model.length_unit.symbol();
    let mut lines = Vec::new();
    let named = model.joints.iter().enumerate().filter(|(index, joint)| joint.name != format!("q{}", index + 1));
    let names: Vec<String> = named.map(|(index, joint)| format!("q{} is {}", index + 1, joint.name)).collect();
    if !names.is_empty() {
        lines.push(format!("joints: {}", names.join(", ")));
    }
    if !parameters.is_empty() {
        lines.push("parameters, constant in a unit struct, bound at run time by fields of these names:".into());
        lines.extend(parameters.iter().map(|p| format!("  {} = {} {unit}", p.name, short(p.default))));
    }
    if let Some(calibration) = &model.calibration {
        lines.extend(calibrated(calibration, model));
    }
    if let Some(coupling) = &model.coupling {
        lines.push("motors (the others have the value of their joint):".into());
        for (index, (row, offset)) in coupling.matrix.iter().zip(&coupling.offset).enumerate() {
            let own = row.iter().enumerate().all(|(joint, k)| *k == if joint == index { 1.0 } else { 0.0 });
            if !own || *offset != 0.0 {
                let kind = model.joints.get(index).map_or(JointKind::Revolute, |joint| joint.kind);
                let offset = (*offset != 0.0).then(|| value(*offset, kind, unit));
                lines.push(format!("  m{} = {}", index + 1, joint_sum(row, offset, short)));
            }
        }
    }
    lines.extend(rates(model));
    if !model.combined_limits.is_empty() {
        lines.push("limits of sums:".into());
        for limit in &model.combined_limits {
            let [low, high] = limit.limits.map(|end| end.is_finite().then(|| value(end, limit.kind, unit)));
            let low = low.map(|low| format!("{low} <= ")).unwrap_or_default();
            let high = high.map(|high| format!(" <= {high}")).unwrap_or_default();
            lines.push(format!("  {low}{}{high}", joint_sum(&limit.factors, None, short)));
        }
    }
    if let Some(actuators) = &model.actuators {
        lines.push("motors that count pulses:".into());
        for (index, (actuator, joint)) in actuators.iter().zip(&model.joints).enumerate() {
            let (per, whole) = match joint.kind {
                JointKind::Revolute => ("turn", std::f64::consts::TAU),
                JointKind::Prismatic => (unit, 1.0),
            };
            let home = value(actuator.home, joint.kind, unit);
            let pulses = short(actuator.pulses_per_unit * whole);
            lines.push(format!("  m{}: {pulses} pulses per {per}, zero at {home}", index + 1));
        }
    }
    lines
}

/// The greatest velocities and accelerations of the joints that have any.
fn rates(model: &Model) -> Vec<String> {
    let unit = model.length_unit.symbol();
    let joints = model.joints.iter().filter_map(|joint| {
        let rates = [(joint.max_velocity, "s"), (joint.max_acceleration, "s^2")];
        let rates = rates.iter().filter(|(rate, _)| rate.is_finite());
        let rates: Vec<String> = rates.map(|(rate, per)| format!("{}/{per}", value(*rate, joint.kind, unit))).collect();
        (!rates.is_empty()).then(|| format!("  {}: {}", joint.name, rates.join(", ")))
    });
    let joints: Vec<String> = joints.collect();
    let title = (!joints.is_empty()).then(|| "greatest rates of the joints:".to_owned());
    title.into_iter().chain(joints).collect()
}

/// How far a calibrated arm is from its table, and what is added to which row.
pub fn calibrated(calibration: &Calibration, model: &Model) -> Vec<String> {
    let unit = model.length_unit.symbol();
    let Calibration { deltas, displaced, turned, farthest: _, table: _ } = calibration;
    let mut lines = vec![format!(
        "calibrated: links are up to {displaced:.3e} {unit} and {:.3e} deg off the table, to which is added:",
        turned.to_degrees()
    )];
    lines.extend(deltas.iter().map(|(joint, [a, alpha, d, theta])| {
        let entries = [
            ("a", *a, unit),
            ("alpha", alpha.to_degrees(), "deg"),
            ("d", *d, unit),
            ("theta", theta.to_degrees(), "deg"),
        ];
        let entries = entries.iter().filter(|(_, value, _)| *value != 0.0);
        let entries: Vec<String> =
            entries.map(|(key, value, unit)| format!("{key} {} {unit}", signed(*value))).collect();
        let name = model.joints.get(*joint).map_or("", |joint| joint.name.as_str());
        format!("  {name}: {}", entries.join(", "))
    }));
    lines
}

/// With a sign, rounded to seven digits.
fn signed(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    format!("{rounded:+}")
}

/// An angle in degrees, or a length.
fn value(value: f64, kind: JointKind, unit: &str) -> String {
    match kind {
        JointKind::Revolute => format!("{} deg", short(value.to_degrees())),
        JointKind::Prismatic => format!("{} {unit}", short(value)),
    }
}

/// Up to six decimals, without trailing zeros.
pub fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::describe;
    use crate::{model, spec};

    #[test]
    fn everything_beside_the_table_is_told() {
        let text = "
name: linked
convention: standard
units: {length: mm, angle: deg}
parameters: {upper: 250}
joints:
  - {name: base, a: 0, alpha: 90, d: 0, theta: 0, actuator: {pulses_per_rev: 12800, home: 0, direction: 1}}
  - {a: upper, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_rev: 200, gear_ratio: 50, home: 90, direction: -1}}
  - {a: 200, alpha: 0, d: 0, theta: 0, max_velocity: 90, max_acceleration: pi, actuator: {pulses_per_rev: 400}}
coupling:
  q3: {q2: 1, q3: -0.5, offset: -90}
combined_limits:
  - {sum: {q2: 1, q3: 1}, limits: [-60, 200]}
";
        let (spec, _) = spec::read(text, "linked.yaml").unwrap();
        let model = model::check(&spec).unwrap();
        let lines = describe(&model, &model.parameters);
        let told = [
            "joints: q1 is base",
            "parameters, constant in a unit struct, bound at run time by fields of these names:",
            "  upper = 250 mm",
            "motors (the others have the value of their joint):",
            "  m3 = q2 - 0.5 q3 - 90 deg",
            "greatest rates of the joints:",
            "  q3: 90 deg/s, 180 deg/s^2",
            "limits of sums:",
            "  -60 deg <= q2 + q3 <= 200 deg",
            "motors that count pulses:",
            "  m1: 12800 pulses per turn, zero at 0 deg",
            "  m2: -10000 pulses per turn, zero at 90 deg",
            "  m3: 400 pulses per turn, zero at 0 deg",
        ];
        assert_eq!(lines, told);
    }
}
