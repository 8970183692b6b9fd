//! Motors that count pulses.

use super::angle::Angle;
use super::joint::{Joint, JointKind};
use crate::error::Diagnostic;
use crate::spec::{ActuatorSpec, HomeSpec, Spec};
use std::f64::consts::TAU;

/// A motor that counts pulses: `pulses = pulses_per_unit (motor - home)`, rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actuator {
    /// Pulses per rad or length unit, negative where the count falls as the motor's value rises.
    pub pulses_per_unit: f64,
    /// Motor value per pulse, rad or length, positive.
    pub resolution: f64,
    /// Where the count is zero, rad or length.
    pub home: f64,
}

/// The actuators of a file, one for each joint or none at all.
pub fn actuators(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Option<Vec<Actuator>> {
    let of = |joint: &Joint| spec.rows.get(joint.row).and_then(|row| row.actuator.as_ref());
    let first = joints.iter().find_map(of)?;
    // An actuator that could not be read is not missing; with mistakes nothing is said of the others.
    let lacking: Vec<String> =
        joints.iter().filter(|joint| of(joint).is_none()).map(|joint| format!("`{}`", joint.name)).collect();
    if !lacking.is_empty() {
        if mistakes.is_empty() {
            let lacking = lacking.join(", ");
            let mistake = spec.source.mistake(&first.place, format!("`actuator`: there is none for {lacking}"));
            mistakes.push(mistake.help("give an actuator to each moving joint, or to none"));
        }
        return None;
    }
    joints.iter().map(|joint| of(joint).map(|written| actuator(written, joint.kind))).collect()
}

fn actuator(written: &ActuatorSpec, kind: JointKind) -> Actuator {
    let sign = if written.reversed { -1.0 } else { 1.0 };
    let (per_unit, resolution) = match kind {
        JointKind::Revolute => (written.pulses / TAU, TAU / written.pulses),
        JointKind::Prismatic => (written.pulses, 1.0 / written.pulses),
    };
    let home = match written.home {
        HomeSpec::Angle(angle) => Angle::from(angle).rad(),
        HomeSpec::Length(length) => length,
    };
    Actuator { pulses_per_unit: sign * per_unit, resolution, home }
}
