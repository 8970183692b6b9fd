//! `coupling:`, which motor moves which joint: motor = A q + b.

use super::angle::AngleUnit;
use super::place::Place;
use super::range;
use super::reader::{Field, Fields, Reader};
use super::value::{JointRef, Named, WrittenValue};
use super::yaml::Node;
use std::f64::consts::TAU;

/// The motors that are not those of their joints alone. A joint that is not listed is driven one to one by its own motor.
#[derive(Debug, Clone)]
pub struct CouplingSpec {
    /// The motors listed.
    pub motors: Vec<MotorSpec>,
    /// True if all motors are listed in order, as `matrix` and `offset`.
    pub matrix: bool,
    /// Where the coupling stands.
    pub place: Place,
}

/// One motor: the sum of its terms and an offset.
#[derive(Debug, Clone)]
pub struct MotorSpec {
    /// The joint it is the motor of.
    pub joint: JointRef,
    /// Terms of the sum, by joint. An entry of a matrix may be 0.
    pub terms: Vec<TermSpec>,
    /// The motor's value where all joints are 0, and where it stands.
    pub offset: Option<(WrittenValue, Place)>,
    /// The motor's name or row.
    pub place: Place,
}

/// A joint's share in a sum.
#[derive(Debug, Clone)]
pub struct TermSpec {
    /// Which joint.
    pub joint: JointRef,
    /// How much of it.
    pub factor: Factor,
    /// The joint's name, or the entry of the matrix.
    pub place: Place,
}

/// A factor, with or without a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Factor {
    /// Angle to angle, or length to length.
    Plain(f64),
    /// File's length unit per rad.
    LengthPerRad(f64),
}

const HELP: &str =
    "write `coupling: {q3: {q2: 1, q3: 1}}`, motor 3 = q2 + q3, or `coupling: {matrix: [[1, 0], [1, 1]]}`";
const MATRIX_HELP: &str = "write one row a motor and in it one factor a joint, such as `matrix: [[1, 0], [1, 1]]`";

impl Reader<'_> {
    /// The coupling, where there is one.
    pub fn coupling(&mut self, root: &Fields<'_>, unit: Option<AngleUnit>) -> Option<CouplingSpec> {
        let field = root.get("coupling")?;
        let is = |key: &Node, word: &str| matches!(key, Node::Text(text) if text.trim() == word);
        let (motors, matrix) = match field.node {
            Node::List(_) => (self.matrix(&field)?, true),
            Node::Mapping(entries) if entries.iter().any(|(key, _)| is(key, "matrix") || is(key, "offset")) => {
                (self.matrix_and_offset(&field, unit)?, true)
            }
            _ => {
                let named = self.by_joint(&field, "`coupling`", HELP)?;
                (named.into_iter().filter_map(|motor| self.motor(motor, unit)).collect(), false)
            }
        };
        if motors.is_empty() {
            // Where something stood and was wrong, that has been said.
            if matches!(field.node, Node::Mapping(entries) if entries.is_empty()) {
                self.mistakes.push(self.source.mistake(&field.place, "`coupling` is empty").help(HELP));
            }
            return None;
        }
        Some(CouplingSpec { motors, matrix, place: field.place })
    }

    /// `q3: {q2: 1, q3: 1, offset: 90}`
    fn motor(&mut self, motor: Named<'_>, unit: Option<AngleUnit>) -> Option<MotorSpec> {
        let help = format!("write what moves the motor of `{0}`, such as `{0}: {{{0}: 1}}`", motor.name);
        let entries = self.by_joint(&motor.field, &format!("the motor of `{}`", motor.name), &help)?;
        let (mut terms, mut offset) = (Vec::new(), None);
        let mut whole = true;
        for Named { name, at, field } in entries {
            if name == "offset" {
                offset = self.value(&field, unit).map(|value| (value, field.place));
                whole &= offset.is_some();
            } else {
                match self.coupling_factor(&field) {
                    Some(factor) => terms.push(TermSpec { joint: JointRef::Named(name), factor, place: at }),
                    None => whole = false,
                }
            }
        }
        whole.then_some(MotorSpec { joint: JointRef::Named(motor.name), terms, offset, place: motor.at })
    }

    fn matrix_and_offset(&mut self, field: &Field<'_>, unit: Option<AngleUnit>) -> Option<Vec<MotorSpec>> {
        let fields = self.mapping(field, "`coupling`", &["matrix", "offset"])?;
        let Some(matrix) = fields.get("matrix") else {
            if !fields.has("matrix") {
                self.mistakes.push(self.source.mistake(&fields.place, "`coupling` has no `matrix`").help(MATRIX_HELP));
            }
            return None;
        };
        let mut motors = self.matrix(&matrix)?;
        let Some(offset) = fields.get("offset") else { return Some(motors) };
        let help = "write one offset a motor, such as `offset: [0, 90]`";
        let Node::List(nodes) = offset.node else {
            self.unexpected(&offset, "a list of offsets", Some(help.to_owned()));
            return None;
        };
        if nodes.len() != motors.len() {
            let (expected, found) = (motors.len(), nodes.len());
            let message = format!("`offset`: expected {expected} offsets, as many as `matrix` has rows, found {found}");
            self.mistakes.push(self.source.mistake(&offset.place, message).help(help));
            return None;
        }
        let mut whole = true;
        for (field, motor) in offset.items(nodes).into_iter().zip(&mut motors) {
            motor.offset = self.value(&field, unit).map(|value| (value, field.place));
            whole &= motor.offset.is_some();
        }
        whole.then_some(motors)
    }

    fn matrix(&mut self, field: &Field<'_>) -> Option<Vec<MotorSpec>> {
        let Node::List(rows) = field.node else {
            self.unexpected(field, "a matrix, a list of rows", Some(MATRIX_HELP.to_owned()));
            return None;
        };
        let mut motors = Vec::new();
        let mut whole = true;
        for (row, field) in field.items(rows).into_iter().enumerate() {
            let Node::List(entries) = field.node else {
                self.unexpected(&field, "a row of the matrix, a list of factors", Some(MATRIX_HELP.to_owned()));
                return None;
            };
            let mut terms = Vec::new();
            for (column, entry) in field.items(entries).into_iter().enumerate() {
                match self.coupling_factor(&entry) {
                    Some(factor) => {
                        terms.push(TermSpec { joint: JointRef::Numbered(column), factor, place: entry.place })
                    }
                    None => whole = false,
                }
            }
            motors.push(MotorSpec { joint: JointRef::Numbered(row), terms, offset: None, place: field.place });
        }
        whole.then_some(motors)
    }

    /// A number, or a length for a turn: `20 per rev`.
    fn coupling_factor(&mut self, field: &Field<'_>) -> Option<Factor> {
        match field.node {
            Node::Text(text) if field.node.number().is_none() => {
                let factor = length_per_angle(text);
                if let Some(Factor::LengthPerRad(size)) = factor {
                    self.within(range::FACTOR, field, size, "write the travel of the motor for a turn: `20 per rev`")?;
                }
                if factor.is_none() {
                    let help = "a sliding motor moves by a length for each turn of a joint: `20 per rev`, `per deg`, `per rad`";
                    self.unexpected(field, "a factor, a number", Some(help.to_owned()));
                }
                factor
            }
            _ => self.factor(field).map(Factor::Plain),
        }
    }
}

fn length_per_angle(text: &str) -> Option<Factor> {
    let (length, angle) = text.split_once(" per ")?;
    let length: f64 = length.trim().parse().ok().filter(|length: &f64| length.is_finite())?;
    let per_rad = match angle.trim() {
        "rev" | "turn" => length / TAU,
        "deg" => length * 360.0 / TAU,
        "rad" => length,
        _ => return None,
    };
    Some(Factor::LengthPerRad(per_rad))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_for_a_turn() {
        assert_eq!(length_per_angle("20 per rev"), Some(Factor::LengthPerRad(20.0 / TAU)));
        assert_eq!(length_per_angle("-1.5 per rad"), Some(Factor::LengthPerRad(-1.5)));
        assert_eq!(length_per_angle("1 per deg"), Some(Factor::LengthPerRad(360.0 / TAU)));
        for text in ["20", "20 rev", "per rev", "x per rev", "20 per mm", "inf per rad"] {
            assert_eq!(length_per_angle(text), None, "{text}");
        }
    }
}
