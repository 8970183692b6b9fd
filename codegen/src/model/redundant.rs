//! Values that are given beside the target of an inverse.

use super::joint::Joint;
use super::joint_names::named;
use crate::error::Diagnostic;
use crate::spec::Spec;

/// Values that the caller of the inverse gives beside the target, in the order of the call.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Redundant {
    /// The values.
    pub values: Vec<RedundantValue>,
    /// True where the call takes an array of them, also of one.
    pub is_list: bool,
}

/// A value that is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RedundantValue {
    /// That of a joint, an index into [`Model::joints`](super::Model::joints).
    Joint(usize),
    /// How far the elbow is swung about the line from shoulder to wrist.
    ArmAngle,
}

/// The name of the arm angle in a file.
const ARM_ANGLE: &str = "arm_angle";

impl Redundant {
    /// The values of some joints: one as it is, more as a list.
    pub fn of(joints: &[usize]) -> Self {
        let values = joints.iter().copied().map(RedundantValue::Joint).collect();
        Redundant { values, is_list: joints.len() > 1 }
    }

    /// Returns true if nothing is given.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The joints whose values are given, in the order of the call.
    pub fn joints(&self) -> impl Iterator<Item = usize> {
        self.values.iter().filter_map(|value| match value {
            RedundantValue::Joint(joint) => Some(*joint),
            RedundantValue::ArmAngle => None,
        })
    }

    /// Returns true if the value of this joint is given.
    pub fn holds(&self, joint: usize) -> bool {
        self.values.contains(&RedundantValue::Joint(joint))
    }

    /// Returns true if the arm angle is given.
    pub fn has_arm_angle(&self) -> bool {
        self.values.contains(&RedundantValue::ArmAngle)
    }

    /// The names as the file writes them: `q3`, or `[q1, q4]`.
    pub fn written(&self, joints: &[Joint]) -> String {
        let name = |value: &RedundantValue| match value {
            RedundantValue::Joint(joint) => joints.get(*joint).map_or("", |joint| joint.name.as_str()),
            RedundantValue::ArmAngle => ARM_ANGLE,
        };
        let names = self.values.iter().map(name).collect::<Vec<_>>().join(", ");
        if self.is_list { format!("[{names}]") } else { names }
    }
}

/// The values that the file names.
pub fn redundant(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Redundant {
    let Some(written) = &spec.inverse.redundant else { return Redundant::default() };
    let mut redundant = Redundant { values: Vec::new(), is_list: written.is_list };
    for (name, place) in &written.names {
        let is_arm_angle = name == ARM_ANGLE && joints.iter().all(|joint| joint.name != ARM_ANGLE);
        let value = match is_arm_angle {
            true => Some(RedundantValue::ArmAngle),
            false => named(spec, joints, "redundant", name, place, mistakes).map(RedundantValue::Joint),
        };
        if let Some(value) = value.filter(|value| redundant.values.contains(value)) {
            let again = match value {
                RedundantValue::Joint(joint) => format!("joint {} is named twice", joint + 1),
                RedundantValue::ArmAngle => "the arm angle is named twice".to_owned(),
            };
            let mistake = spec.source.mistake(place, format!("`redundant`: {again}"));
            mistakes.push(mistake.help(format!("leave out the second one, `{name}`")));
            continue;
        }
        redundant.values.extend(value);
    }
    redundant
}
