//! `calibration:`, by how much the rows of the arm that was measured differ from those of the table.

use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::AngleRole;
use super::place::Place;
use super::reader::{Field, Fields, Reader};
use super::value::Named;

/// The numbers that are added to the rows of the table.
#[derive(Debug, Clone)]
pub struct CalibrationSpec {
    /// One entry a joint that is named.
    pub deltas: Vec<DeltaSpec>,
    /// Where the calibration stands.
    pub place: Place,
}

/// The numbers that are added to the row of a joint.
#[derive(Debug, Clone)]
pub struct DeltaSpec {
    /// The joint's name, or `qK`.
    pub joint: String,
    /// Length unit of the file.
    pub a: f64,
    /// To the angle between the axes.
    pub alpha: WrittenAngle,
    /// Length unit of the file.
    pub d: f64,
    /// To the angle about the joint's axis.
    pub theta: WrittenAngle,
    /// Where the joint is named.
    pub place: Place,
}

const HELP: &str =
    "write what is added to the rows of the table, by joint: `calibration: {q2: {a: 0.0003, alpha: -0.01}}`";
const KEYS: &[&str] = &["a", "alpha", "d", "theta"];

impl Reader<'_> {
    /// The calibration, where there is one.
    pub fn calibration(&mut self, root: &Fields<'_>, unit: Option<AngleUnit>) -> Option<CalibrationSpec> {
        let field = root.get("calibration")?;
        let named = self.by_joint(&field, "`calibration`", HELP)?;
        if named.is_empty() {
            let mistake = self.source.mistake(&field.place, "`calibration` names no joint".to_owned());
            self.mistakes.push(mistake.help(HELP));
        }
        let deltas = named.into_iter().filter_map(|joint| self.delta(joint, unit)).collect();
        Some(CalibrationSpec { deltas, place: field.place })
    }

    /// `q2: {a: 0.0003, alpha: -0.01}`
    fn delta(&mut self, joint: Named<'_>, unit: Option<AngleUnit>) -> Option<DeltaSpec> {
        let Named { name, at, field } = joint;
        let fields = self.mapping(&field, &format!("the calibration of `{name}`"), KEYS)?;
        let lengths = ["a", "d"].map(|key| fields.get(key).and_then(|field: Field<'_>| self.number(&field)));
        let angles =
            ["alpha", "theta"].map(|key| fields.get(key).and_then(|field| self.angle(&field, unit, AngleRole::Delta)));
        let ([a, d], [alpha, theta]) =
            (lengths.map(Option::unwrap_or_default), angles.map(|angle| angle.unwrap_or(WrittenAngle::ZERO)));
        Some(DeltaSpec { joint: name, a, alpha, d, theta, place: at })
    }
}
