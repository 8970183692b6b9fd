//! Weights of the joints in the distance from a reference.

use super::joint::Joint;
use super::joint_names::named;
use crate::error::Diagnostic;
use crate::spec::{Spec, WeightsSpec};

/// One weight a joint; 1 for joints that the file gives none.
pub fn weights(spec: &Spec, joints: &[Joint], mistakes: &mut Vec<Diagnostic>) -> Option<Vec<f64>> {
    let (weights, place) = match spec.inverse.weights.as_ref()? {
        WeightsSpec::List(list, place) => {
            if list.len() != joints.len() && !joints.is_empty() {
                let (found, joints) = (list.len(), joints.len());
                let entries = if found == 1 { "entry" } else { "entries" };
                let message =
                    format!("`weights`: expected {joints} entries, one for each moving joint, found {found} {entries}");
                let help = "to weigh only some joints, write them by name, such as `weights: {q1: 2}`";
                mistakes.push(spec.source.mistake(place, message).help(help));
                return None;
            }
            (list.clone(), Some(place))
        }
        WeightsSpec::Named(list) => {
            let mut weights = vec![1.0; joints.len()];
            for (name, place, weight) in list {
                let joint = named(spec, joints, "weights", name, place, mistakes);
                if let Some(slot) = joint.and_then(|joint| weights.get_mut(joint)) {
                    *slot = *weight;
                }
            }
            (weights, list.first().map(|(_, place, _)| place))
        }
    };
    if let Some(place) = place
        && !weights.is_empty()
        && weights.iter().all(|weight| *weight == 0.0)
    {
        let message = "`weights`: all are 0, so every solution has the same distance from a reference";
        mistakes.push(spec.source.mistake(place, message).help("give at least one joint a weight greater than 0"));
    }
    Some(weights)
}
