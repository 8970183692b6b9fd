//! `actuator:` of a row, the pulses that a motor counts.

use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::AngleRole;
use super::place::Place;
use super::reader::{Field, Reader};
use super::row_kind::RowKind;

/// A motor that counts pulses.
#[derive(Debug, Clone)]
pub struct ActuatorSpec {
    /// For a revolution of the joint, or for a length unit of its travel; positive.
    pub pulses: f64,
    /// Where the count is zero.
    pub home: HomeSpec,
    /// True if the count falls where the joint value rises.
    pub reversed: bool,
    /// Where the actuator stands.
    pub place: Place,
}

/// The value at which an actuator counts zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HomeSpec {
    /// Of a revolute joint.
    Angle(WrittenAngle),
    /// Of a prismatic joint, length unit of the file.
    Length(f64),
}

const KEYS: &[&str] = &["pulses_per_rev", "pulses_per_unit", "gear_ratio", "home", "direction"];

impl Reader<'_> {
    /// The actuator of a row of `kind`.
    pub fn actuator(&mut self, field: &Field<'_>, kind: RowKind, unit: Option<AngleUnit>) -> Option<ActuatorSpec> {
        if kind == RowKind::Fixed {
            let mistake = self.source.mistake(&field.place, "`actuator` on a fixed row: nothing moves there");
            self.mistakes.push(mistake.help("remove `actuator`, or make the row revolute or prismatic"));
            return None;
        }
        let mistakes = self.mistakes.len();
        let fields = self.mapping(field, "`actuator`", KEYS)?;
        let (key, other, help) = match kind {
            RowKind::Prismatic => (
                "pulses_per_unit",
                "pulses_per_rev",
                "a sliding joint has `pulses_per_unit`, pulses for one length unit of the file: those of a turn of its \
                 screw over the screw's lead",
            ),
            _ => (
                "pulses_per_rev",
                "pulses_per_unit",
                "a turning joint has `pulses_per_rev`, pulses for a whole turn of the joint",
            ),
        };
        if let Some(wrong) = fields.get(other) {
            let kind = if kind == RowKind::Prismatic { "prismatic" } else { "revolute" };
            let mistake = self.source.mistake(&wrong.place, format!("`{other}` of a {kind} joint"));
            self.mistakes.push(mistake.help(help));
        } else if !fields.has(key) && self.mistakes.len() == mistakes {
            // After an unknown key it is not known what is missing.
            self.mistakes.push(self.source.mistake(&field.place, format!("`actuator` has no `{key}`")).help(help));
        }
        let mut pulses = fields.get(key).and_then(|field| self.positive_factor(&field)).unwrap_or(1.0);
        if let Some(ratio) = fields.get("gear_ratio") {
            if kind == RowKind::Prismatic {
                let mistake = self.source.mistake(&ratio.place, "`gear_ratio` of a prismatic joint");
                self.mistakes.push(mistake.help("give the pulses of one length unit as `pulses_per_unit`"));
            } else if let Some(ratio) = self.positive_factor(&ratio) {
                pulses *= ratio;
            }
        }
        let home = match (fields.get("home"), kind) {
            (Some(field), RowKind::Prismatic) => HomeSpec::Length(self.number(&field).unwrap_or(0.0)),
            (Some(field), _) => {
                HomeSpec::Angle(self.angle(&field, unit, AngleRole::Position).unwrap_or(WrittenAngle::ZERO))
            }
            (None, RowKind::Prismatic) => HomeSpec::Length(0.0),
            (None, _) => HomeSpec::Angle(WrittenAngle::ZERO),
        };
        let reversed = fields.get("direction").is_some_and(|field| self.reversed(&field));
        (self.mistakes.len() == mistakes).then_some(ActuatorSpec { pulses, home, reversed, place: field.place.clone() })
    }

    fn positive_factor(&mut self, field: &Field<'_>) -> Option<f64> {
        let value = self.factor(field)?;
        if value <= 0.0 {
            let help = "for a motor that counts the other way, write `direction: -1`";
            self.unexpected(field, "a number greater than zero", Some(help.to_owned()));
        }
        Some(value).filter(|value| *value > 0.0)
    }

    fn reversed(&mut self, field: &Field<'_>) -> bool {
        let direction = self.factor(field);
        if direction.is_some_and(|direction| direction.abs() != 1.0) {
            self.unexpected(field, "1 or -1", Some("the direction in which the count rises".to_owned()));
        }
        direction == Some(-1.0)
    }
}
