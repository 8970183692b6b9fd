//! The joint that a name means, and values of joints.

use super::angle::Angle;
use super::joint::{Joint, JointKind};
use crate::error::Diagnostic;
use crate::spec::{ANGLE, JointRef, POSITION, Place, Spec, WrittenValue, nearest};

/// The joint of that name; `qK` also means the K-th joint where no joint has that name. `what` is the key that names
/// it, for the message.
pub fn named(
    spec: &Spec,
    joints: &[Joint],
    what: &str,
    name: &str,
    place: &Place,
    mistakes: &mut Vec<Diagnostic>,
) -> Option<usize> {
    let by_name = joints.iter().position(|joint| joint.name == name);
    let by_number = || (0..joints.len()).find(|index| name == format!("q{}", index + 1));
    let found = by_name.or_else(by_number);
    // Without a table there is no joint to name, and that is known already.
    if found.is_none() && !joints.is_empty() {
        let names: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
        let meant = nearest(name, names.iter().copied()).map(|word| format!("did you mean `{word}`? "));
        let help = format!("{}the joints are {}", meant.unwrap_or_default(), names.join(", "));
        mistakes.push(spec.source.mistake(place, format!("`{what}`: no joint is named `{name}`")).help(help));
    }
    found
}

/// The joint that is referred to, with its index.
pub fn referred<'j>(
    spec: &Spec,
    joints: &'j [Joint],
    what: &str,
    (joint, place): (&JointRef, &Place),
    mistakes: &mut Vec<Diagnostic>,
) -> Option<(usize, &'j Joint)> {
    let index = match joint {
        JointRef::Named(name) => named(spec, joints, what, name, place, mistakes)?,
        JointRef::Numbered(index) => *index,
    };
    joints.get(index).map(|joint| (index, joint))
}

/// A value of a joint of that kind: rad or length.
pub fn value(
    spec: &Spec,
    what: &str,
    kind: JointKind,
    (written, place): &(WrittenValue, Place),
    mistakes: &mut Vec<Diagnostic>,
) -> Option<f64> {
    match kind {
        JointKind::Revolute => {
            let rad = Angle::from(written.angle).rad();
            within(spec, what, ANGLE.missed(rad), place, mistakes).then_some(rad)
        }
        JointKind::Prismatic => {
            if written.length.is_none() {
                let message = format!("`{what}`: expected a length, found the angle {}", spec.source.written(place));
                let help = "the joint slides: write a number, in the file's length unit";
                mistakes.push(spec.source.mistake(place, message).help(help));
            }
            let length = written.length?;
            within(spec, what, POSITION.missed(length), place, mistakes).then_some(length)
        }
    }
}

/// The ends of a range, infinite where there is none; the first must not be the greater one.
pub fn range(spec: &Spec, ends: [Option<f64>; 2], place: &Place, mistakes: &mut Vec<Diagnostic>) -> [f64; 2] {
    let (low, high) = (ends[0].unwrap_or(f64::NEG_INFINITY), ends[1].unwrap_or(f64::INFINITY));
    if low > high {
        let [first, second] = spec.source.written_ends(place);
        let message = format!("`limits`: the lowest value {first} is greater than the highest value {second}");
        mistakes.push(spec.source.mistake(place, message).help(format!("write [{second}, {first}]")));
    }
    [low, high]
}

/// Returns true if nothing is `expected` in place of the written value. Otherwise adds the mistake.
fn within(spec: &Spec, what: &str, expected: Option<String>, place: &Place, mistakes: &mut Vec<Diagnostic>) -> bool {
    if let Some(expected) = &expected {
        let message = format!("`{what}`: expected {expected}, found {}", spec.source.written(place));
        let help = match what {
            "limits" => "write null for an end without a limit",
            _ => "write where the motor stands when all joints are at 0",
        };
        mistakes.push(spec.source.mistake(place, message).help(help));
    }
    expected.is_none()
}
