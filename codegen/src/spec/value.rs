//! Values and names whose meaning depends on a joint that may stand further down in the file.

use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::AngleRole;
use super::place::{Place, Step};
use super::range;
use super::reader::{Field, Reader};
use super::yaml::Node;

/// The value of a joint or of its motor: the joint's type says whether it is an angle or a length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrittenValue {
    /// As an angle; a plain number is in the file's unit.
    pub angle: WrittenAngle,
    /// As a length in the file's unit; `None` where it was written with the unit of an angle.
    pub length: Option<f64>,
}

/// A joint as the file names it.
#[derive(Debug, Clone, PartialEq)]
pub enum JointRef {
    /// By its name, or `qK`.
    Named(String),
    /// By its place in a list, from 0.
    Numbered(usize),
}

/// An entry of a mapping whose keys are names.
pub struct Named<'n> {
    /// The key.
    pub name: String,
    /// Where the key stands.
    pub at: Place,
    /// Its value.
    pub field: Field<'n>,
}

impl Reader<'_> {
    /// A value of a joint whose type is not known here.
    pub fn value(&mut self, field: &Field<'_>, unit: Option<AngleUnit>) -> Option<WrittenValue> {
        if let Some(value) = field.node.number() {
            let angle = WrittenAngle::number(value, unit.unwrap_or(AngleUnit::Degree));
            return Some(WrittenValue { angle, length: Some(value) });
        }
        self.angle(field, unit, AngleRole::Position).map(|angle| WrittenValue { angle, length: None })
    }

    /// The entries of a mapping from joints to values; `what` names it in messages.
    pub fn by_joint<'n>(&mut self, field: &Field<'n>, what: &str, help: &str) -> Option<Vec<Named<'n>>> {
        let Node::Mapping(entries) = field.node else {
            self.unexpected(field, "a mapping from joints", Some(help.to_owned()));
            return None;
        };
        let mut named = Vec::new();
        for (index, (key, node)) in entries.iter().enumerate() {
            let at = field.place.to(Step::Key(index));
            let Node::Text(name) = key else {
                let written = self.source.written(&at);
                let message = format!("expected a joint's name in {what}, found `{written}`");
                let number = matches!(key, Node::Number(_));
                let help = if number { format!("did you mean `q{written}`?") } else { help.to_owned() };
                self.mistakes.push(self.source.mistake(&at, message).help(help));
                continue;
            };
            let name = name.trim().to_owned();
            if named.iter().any(|earlier: &Named<'n>| earlier.name == name) {
                let mistake = self.source.mistake(&at, format!("`{name}` occurs twice in {what}"));
                self.mistakes.push(mistake.help("remove one of them"));
                continue;
            }
            let place = if *node == Node::Null { at.clone() } else { field.place.to(Step::Value(index)) };
            named.push(Named { field: Field { node, place, key: name.clone() }, name, at });
        }
        Some(named)
    }

    /// A finite number without a unit.
    pub fn factor(&mut self, field: &Field<'_>) -> Option<f64> {
        match field.node.number() {
            Some(value) => {
                self.within(range::FACTOR, field, value, "use units in which the factor is a number of ordinary size")
            }
            None => {
                self.unexpected(field, "a factor, a finite number", None);
                None
            }
        }
    }
}
