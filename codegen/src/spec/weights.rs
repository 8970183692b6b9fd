//! `inverse: weights:`, how much each joint counts in the distance from a reference.

use super::place::Place;
use super::range;
use super::reader::{Field, Reader};
use super::value::Named;
use super::yaml::Node;

/// The weights as written, each finite and not negative.
#[derive(Debug, Clone)]
pub enum WeightsSpec {
    /// One a joint, in order, and where the list stands.
    List(Vec<f64>, Place),
    /// By joint name or `qK`, each with the place of the name.
    Named(Vec<(String, Place, f64)>),
}

const EXPECTED: &str = "a weight for some joints, or a list with one for each joint";
const HELP: &str =
    "write `weights: {q1: 2, q2: 0.5}` (joints that are not named have weight 1) or `weights: [2, 0.5, 1]`";

impl Reader<'_> {
    pub fn weights(&mut self, field: &Field<'_>) -> Option<WeightsSpec> {
        match field.node {
            Node::List(nodes) => {
                let weights: Vec<f64> = field.items(nodes).iter().filter_map(|entry| self.weight(entry)).collect();
                (weights.len() == nodes.len()).then(|| WeightsSpec::List(weights, field.place.clone()))
            }
            Node::Mapping(_) => {
                let named = self.by_joint(field, "`weights`", HELP)?.into_iter();
                let weight = |Named { name, at, field }| self.weight(&field).map(|weight| (name, at, weight));
                Some(WeightsSpec::Named(named.filter_map(weight).collect()))
            }
            _ => {
                self.unexpected(field, EXPECTED, Some(HELP.to_owned()));
                None
            }
        }
    }

    fn weight(&mut self, field: &Field<'_>) -> Option<f64> {
        match field.node.number() {
            Some(value) if value >= 0.0 => {
                self.within(range::WEIGHT, field, value, "a weight of 1 is that of a joint without a weight")
            }
            _ => {
                self.unexpected(field, "a weight, a finite number that is not negative", None);
                None
            }
        }
    }
}
