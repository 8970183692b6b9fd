//! One row of the joint table.

use super::actuator::ActuatorSpec;
use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::{AngleRole, NO_LIMIT};
use super::length::Length;
use super::parameter::Context;
use super::place::Place;
use super::rate::RateSpec;
use super::reader::{Field, Fields, Reader};
use super::row_kind::{KIND_SYNONYMS, KINDS, RowKind};
use super::yaml::Node;

/// A row as written. What could not be read is zero; the mistake is on record.
#[derive(Debug, Clone)]
pub struct RowSpec {
    /// `type`
    pub kind: RowKind,
    /// The name, where there is one, and its place.
    pub name: Option<(String, Place)>,
    /// Length unit of the file.
    pub a: Length,
    /// Angle between the axes.
    pub alpha: WrittenAngle,
    /// Length unit of the file.
    pub d: Length,
    /// Angle about the joint's axis.
    pub theta: WrittenAngle,
    /// The range, where there is one, and its place.
    pub limits: Option<(LimitsSpec, Place)>,
    /// `max_velocity`, where there is one.
    pub max_velocity: Option<RateSpec>,
    /// `max_acceleration`, where there is one.
    pub max_acceleration: Option<RateSpec>,
    /// The motor's pulses, where they are given.
    pub actuator: Option<ActuatorSpec>,
    /// The row itself.
    pub place: Place,
}

/// The ends of a joint's range; `None` where there is no end on that side.
#[derive(Debug, Clone, Copy)]
pub enum LimitsSpec {
    /// Of a revolute joint.
    Angles([Option<WrittenAngle>; 2]),
    /// Of a prismatic joint, length unit of the file.
    Lengths([Option<f64>; 2]),
}

const KEYS: &[&str] =
    &["type", "name", "a", "alpha", "d", "theta", "limits", "max_velocity", "max_acceleration", "actuator"];

impl Reader<'_> {
    /// Reads row `number` (from 1).
    pub fn row(&mut self, field: &Field<'_>, number: usize, context: Context<'_>) -> RowSpec {
        let mut row = RowSpec {
            kind: RowKind::Revolute,
            name: None,
            a: Length::ZERO,
            alpha: WrittenAngle::ZERO,
            d: Length::ZERO,
            theta: WrittenAngle::ZERO,
            limits: None,
            max_velocity: None,
            max_acceleration: None,
            actuator: None,
            place: field.place.clone(),
        };
        let Some(fields) = self.mapping(field, "a joint row", KEYS) else { return row };
        self.missing(&fields, number);
        let kind = fields.get("type").map(|field| (self.choice(&field, KINDS, KIND_SYNONYMS), field.place));
        row.kind = kind.as_ref().map_or(Some(RowKind::Revolute), |(kind, _)| *kind).unwrap_or(RowKind::Revolute);
        // With an unknown type nothing is said about the limits: their unit is not known either.
        let kind_known = kind.is_none_or(|(kind, _)| kind.is_some());
        if let Some(field) = fields.get("name") {
            row.name = self
                .text(
                    &field,
                    "a name",
                    "write a name, or remove `name`: the joint is then called by its number, q1, q2, ...",
                )
                .map(|name| (name, field.place));
        }
        row.a = self.length_of(&fields, "a", context);
        row.d = self.length_of(&fields, "d", context);
        let mut angle = |key, role| fields.get(key).and_then(|field| self.angle(&field, context.angle, role));
        row.alpha = angle("alpha", AngleRole::Twist).unwrap_or(WrittenAngle::ZERO);
        row.theta = angle("theta", AngleRole::Offset).unwrap_or(WrittenAngle::ZERO);
        if let Some(field) = fields.get("limits").filter(|_| kind_known) {
            row.limits = self.limits(&field, row.kind, context.angle).map(|limits| (limits, field.place));
        }
        if kind_known {
            let mut rate = |key| self.rate(&fields, key, row.kind, context.angle);
            (row.max_velocity, row.max_acceleration) = (rate("max_velocity"), rate("max_acceleration"));
        }
        if let Some(field) = fields.get("actuator").filter(|_| kind_known) {
            row.actuator = self.actuator(&field, row.kind, context.angle);
        }
        row
    }

    fn missing(&mut self, fields: &Fields<'_>, number: usize) {
        let missing: Vec<String> =
            ["a", "alpha", "d", "theta"].iter().filter(|key| !fields.has(key)).map(|key| format!("`{key}`")).collect();
        if missing.is_empty() {
            return;
        }
        let list = missing.join(", ");
        let mistake = self.source.mistake(&fields.place, format!("row {number} of `joints` has no {list}"));
        self.mistakes.push(mistake.help("every row has a, alpha, d and theta; write 0 where there is none"));
    }

    /// The length under `key`; zero if there is none that can be read.
    fn length_of(&mut self, fields: &Fields<'_>, key: &str, context: Context<'_>) -> Length {
        let length = fields.get(key).and_then(|field| self.length(&field, context.parameters));
        length.unwrap_or(Length::ZERO)
    }

    fn limits(&mut self, field: &Field<'_>, kind: RowKind, unit: Option<AngleUnit>) -> Option<LimitsSpec> {
        if *field.node == Node::Null {
            return None;
        }
        if kind == RowKind::Fixed {
            let mistake = self.source.mistake(&field.place, "`limits` on a fixed row: nothing moves there");
            self.mistakes.push(mistake.help("remove `limits`, or make the row revolute or prismatic"));
            return None;
        }
        let help = match kind {
            RowKind::Prismatic => "write `limits: [0, 0.5]`, the lowest and the highest value; null is no limit",
            _ => "write `limits: [-90, 90]`, the lowest and the highest value; null is no limit",
        };
        let ends: [Field<'_>; 2] = self.list(field, "null or [lowest, highest]", help)?;
        let warnings = self.warnings.len();
        let mut whole = true;
        let mut end = |field: Field<'_>, reader: &mut Self| -> (Option<WrittenAngle>, Option<f64>) {
            if *field.node == Node::Null {
                return (None, None);
            }
            let read = match kind {
                RowKind::Prismatic => (None, reader.displacement(&field, NO_LIMIT)),
                _ => (reader.angle(&field, unit, AngleRole::Limit), None),
            };
            whole &= read != (None, None);
            read
        };
        let [low, high] = ends.map(|field| end(field, self));
        // Both ends are in the wrong unit, if one is.
        self.warnings.truncate(warnings + 1);
        let limits = match kind {
            RowKind::Prismatic => LimitsSpec::Lengths([low.1, high.1]),
            _ => LimitsSpec::Angles([low.0, high.0]),
        };
        whole.then_some(limits)
    }
}
