//! Ranges of sums of joint values.

use super::joint::{Joint, JointKind};
use super::joint_names::{range, referred, value};
use crate::error::Diagnostic;
use crate::spec::{CombinedLimitSpec, Spec};

/// The range of a sum of joint values, all angles or all lengths.
#[derive(Debug, Clone, PartialEq)]
pub struct CombinedLimit {
    /// One for each joint, 0 for those not in the sum.
    pub factors: Vec<f64>,
    /// Lowest and highest value of the sum, rad or length; infinite on a side without an end.
    pub limits: [f64; 2],
    /// Kind of the joints in the sum.
    pub kind: JointKind,
}

/// The combined limits of a file.
pub fn combined_limits(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Vec<CombinedLimit> {
    spec.combined_limits.iter().filter_map(|written| combined_limit(spec, joints, written, mistakes)).collect()
}

fn combined_limit(
    spec: &Spec,
    joints: &[Joint],
    written: &CombinedLimitSpec,
    mistakes: &mut Vec<Diagnostic>,
) -> Option<CombinedLimit> {
    let before = mistakes.len();
    let mut factors = vec![0.0; joints.len()];
    let mut first: Option<&Joint> = None;
    for (joint, factor, place) in &written.terms {
        let Some((index, joint)) = referred(spec, joints, "sum", (joint, place), mistakes) else { continue };
        if let Some(other) = first.filter(|other| other.kind != joint.kind) {
            let message =
                format!("`sum`: joints `{}` and `{}` do not add up: one turns, one slides", other.name, joint.name);
            mistakes.push(spec.source.mistake(place, message).help("a sum is one of angles or one of lengths"));
        }
        first = first.or(Some(joint));
        if let Some(to) = factors.get_mut(index) {
            *to += factor;
        }
    }
    if mistakes.len() > before {
        return None;
    }
    let kind = first.map(|joint| joint.kind).filter(|_| factors.iter().any(|factor| *factor != 0.0));
    if kind.is_none() && !joints.is_empty() {
        let mistake = spec.source.mistake(&written.sum, "`sum`: no joint is in it");
        mistakes.push(mistake.help("write the joints with their factors, such as `sum: {q2: 1, q3: 1}`"));
    }
    let kind = kind?;
    let ends =
        written.limits.each_ref().map(|end| end.as_ref().and_then(|end| value(spec, "limits", kind, end, mistakes)));
    let limits = range(spec, ends, &written.place, mistakes);
    Some(CombinedLimit { factors, limits, kind })
}
