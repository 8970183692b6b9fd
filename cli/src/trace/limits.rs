//! The limits that a motion breaks.

use denhart_codegen::model::{JointKind, Model};

use crate::numbers::Units;

/// Beyond a limit by less than this part of a rad or length unit is rounding.
const ROUNDING: f64 = 1e-12;

/// The ranges of a file: of its joints, and of sums of them.
pub struct Limits {
    ranges: Vec<Range>,
    length_unit: &'static str,
    units: Units,
}

struct Range {
    name: String,
    turns: bool,
    /// One for each joint.
    factors: Vec<f64>,
    ends: [f64; 2],
}

impl Limits {
    /// The limits of the arm: one for each joint, then one for each sum. In words, angles are in `units`.
    pub fn of(model: &Model, units: Units) -> Self {
        let count = model.joints.len();
        let joint = |(index, joint): (usize, &denhart_codegen::model::Joint)| Range {
            name: format!("joint `{}`", joint.name),
            turns: joint.kind == JointKind::Revolute,
            factors: (0..count).map(|other| f64::from(u8::from(other == index))).collect(),
            ends: joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]),
        };
        let sum = |(index, limit): (usize, &denhart_codegen::model::CombinedLimit)| Range {
            name: format!("sum {} of `combined_limits`", index + 1),
            turns: limit.kind == JointKind::Revolute,
            factors: limit.factors.clone(),
            ends: limit.limits,
        };
        let joints = model.joints.iter().enumerate().map(joint);
        let ranges = joints.chain(model.combined_limits.iter().enumerate().map(sum)).collect();
        Self { ranges, length_unit: model.length_unit.symbol(), units }
    }

    /// 0, or the sum of `2^(k-1)` for each joint k that is beyond its limits; sums count on after the joints.
    pub fn broken(&self, q: &[f64]) -> f64 {
        let bits = self.ranges.iter().enumerate().filter(|(_, range)| range.is_broken(q));
        bits.map(|(index, _)| 2_f64.powi(i32::try_from(index).unwrap_or(0))).sum()
    }

    /// The first limit that is broken, in words.
    pub fn first(&self, q: &[f64]) -> Option<String> {
        let range = self.ranges.iter().find(|range| range.is_broken(q))?;
        let (size, unit) =
            if range.turns { (self.units.in_rad(), self.units.symbol()) } else { (1.0, self.length_unit) };
        let shown = |value: f64| ((value / size) * 1e9).round() / 1e9;
        let [low, high] = range.ends.map(shown);
        Some(format!("{} is at {} {unit}, beyond its limits {low} to {high}", range.name, shown(range.value(q))))
    }
}

impl Range {
    fn value(&self, q: &[f64]) -> f64 {
        self.factors.iter().zip(q).map(|(factor, q)| factor * q).sum()
    }

    fn is_broken(&self, q: &[f64]) -> bool {
        let [low, high] = self.ends;
        let value = self.value(q);
        value < low - ROUNDING * (1.0 + low.abs()) || value > high + ROUNDING * (1.0 + high.abs())
    }
}
