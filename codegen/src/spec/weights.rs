//! `inverse: weights:`, how much each joint counts in the distance from a reference.

use super::place::{Place, Step};
use super::range;
use super::reader::{Field, Reader};
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
                let entry =
                    |(index, node)| Field { node, place: field.place.to(Step::Item(index)), key: field.key.clone() };
                let entries: Vec<Field<'_>> = nodes.iter().enumerate().map(entry).collect();
                let weights: Vec<f64> = entries.iter().filter_map(|entry| self.weight(entry)).collect();
                (weights.len() == nodes.len()).then(|| WeightsSpec::List(weights, field.place.clone()))
            }
            Node::Mapping(entries) => {
                let mut weights: Vec<(String, Place, f64)> = Vec::new();
                for (index, (key, node)) in entries.iter().enumerate() {
                    let at_key = field.place.to(Step::Key(index));
                    let Node::Text(name) = key else {
                        let written = self.source.written(&at_key);
                        let message = format!("`weights`: expected a joint's name, found {written}");
                        let mistake = self.source.mistake(&at_key, message);
                        self.mistakes.push(mistake.help(format!("did you mean `q{written}`?")));
                        continue;
                    };
                    if weights.iter().any(|(earlier, ..)| earlier == name) {
                        let message = format!("`weights`: the joint `{name}` occurs twice");
                        self.mistakes.push(self.source.mistake(&at_key, message).help("remove one of them"));
                        continue;
                    }
                    let place = if *node == Node::Null { at_key.clone() } else { field.place.to(Step::Value(index)) };
                    let weight = self.weight(&Field { node, place, key: name.clone() });
                    weights.extend(weight.map(|weight| (name.clone(), at_key, weight)));
                }
                Some(WeightsSpec::Named(weights))
            }
            _ => {
                self.unexpected(field, EXPECTED, Some(HELP.to_owned()));
                None
            }
        }
    }

    fn weight(&mut self, field: &Field<'_>) -> Option<f64> {
        match field.node {
            Node::Number(value) if value.is_finite() && *value >= 0.0 => {
                self.within(range::WEIGHT, field, *value, "a weight of 1 is that of a joint without a weight")
            }
            _ => {
                self.unexpected(field, "a weight, a finite number that is not negative", None);
                None
            }
        }
    }
}
