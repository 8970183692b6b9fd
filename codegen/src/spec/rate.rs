//! `max_velocity` and `max_acceleration` of a row, the greatest rates of a joint.

use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::AngleRole;
use super::place::Place;
use super::reader::{Field, Fields, Reader};
use super::row_kind::RowKind;
use super::yaml::Node;

/// A rate in the file's unit per s or per s^2.
#[derive(Debug, Clone)]
pub struct RateSpec {
    /// The size in a second.
    pub size: RateSize,
    /// Where it stands.
    pub place: Place,
}

/// The size of a rate.
#[derive(Debug, Clone, Copy)]
pub enum RateSize {
    /// Of a revolute joint.
    Angle(WrittenAngle),
    /// Of a prismatic joint, length unit of the file.
    Length(f64),
}

impl Reader<'_> {
    /// The rate under `key`, greater than zero. None where there is no such key, or null.
    pub fn rate(&mut self, fields: &Fields<'_>, key: &str, kind: RowKind, unit: Option<AngleUnit>) -> Option<RateSpec> {
        let field = fields.get(key).filter(|field| *field.node != Node::Null)?;
        let help = format!("write `{key}` greater than zero, or leave it out where the joint has no such bound");
        let size = match kind {
            RowKind::Fixed => {
                let mistake = self.source.mistake(&field.place, format!("`{key}` on a fixed row: nothing moves there"));
                self.mistakes.push(mistake.help(format!("remove `{key}`, or make the row revolute or prismatic")));
                return None;
            }
            RowKind::Revolute => RateSize::Angle(self.angle(&field, unit, AngleRole::Rate)?),
            RowKind::Prismatic => RateSize::Length(self.rate_of_slide(&field, &help)?),
        };
        let is_positive = match size {
            RateSize::Angle(angle) => angle.rad() > 0.0,
            RateSize::Length(length) => length > 0.0,
        };
        if !is_positive {
            self.unexpected(&field, "a rate greater than zero", Some(help));
            return None;
        }
        Some(RateSpec { size, place: field.place.clone() })
    }

    /// A rate is no length of the arm: it says nothing about the unit of the table.
    fn rate_of_slide(&mut self, field: &Field<'_>, help: &str) -> Option<f64> {
        let lengths = self.lengths.len();
        let value = self.displacement(field, help);
        self.lengths.truncate(lengths);
        value
    }
}
