//! The size of an arm, which every length is compared to.

use super::numeric::length;
use super::{JointKind, Length, Model};
use crate::error::Diagnostic;
use crate::spec::Spec;
use std::collections::HashMap;

/// What an arm may measure: the kernels compute fourth powers of lengths, which must stay in the range of the scalar.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    least: f64,
    most: f64,
    /// What has this range, and what to do about an arm that is not in it.
    of: &'static str,
    help: &'static str,
}

impl Sizes {
    /// In double precision.
    pub const DOUBLE: Self = Sizes {
        least: 1e-60,
        most: 1e60,
        of: "an arm",
        help: "this is the largest length: lengths are in the unit that `units` names",
    };
    /// In single precision.
    pub const SINGLE: Self = Sizes {
        least: 1e-4,
        most: 1e8,
        of: "an arm in single precision",
        help: "choose another unit of length, or generate the arm for `f64`",
    };

    /// The mistake of a file whose arm is too large or too small.
    pub fn missed(&self, spec: &Spec, model: &Model) -> Option<Diagnostic> {
        let Sizes { least, most, of, help } = self;
        let (value, place) = spec.lengths.iter().max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
        let (reach, unit) = (reach(model, &HashMap::new()), model.length_unit.symbol());
        let (what, found) = match reach < *most && reach > *least {
            false => ("the lengths add up to", reach),
            // A length that is no part of the arm, such as where a motor stands.
            true if value.abs() > *most => ("a length is", *value),
            true => return None,
        };
        let message = format!("{what} {found:e} {unit}: expected {of} of {least:e} to {most:e} {unit}");
        Some(spec.source.mistake(place, message).help(*help))
    }
}

/// `sum(|a| + |d|) + |base| + |tool| + sum of max |limit|` of the sliding joints, parameters at the given values (else
/// at their defaults); 1 if that is zero.
pub fn reach(model: &Model, values: &HashMap<String, f64>) -> f64 {
    let rows: f64 = model.rows.iter().map(|row| row.a.at(values).abs() + row.d.at(values).abs()).sum();
    let total = beside_rows(model, values).into_iter().fold(rows, |sum, term| sum + term);
    if total > 0.0 { total } else { 1.0 }
}

/// What a reach has beside the lengths of the rows: strokes, base and tool.
pub fn beside_rows(model: &Model, values: &HashMap<String, f64>) -> [f64; 3] {
    let frame = |xyz: &[Length; 3]| length(xyz.each_ref().map(|x| x.at(values)));
    [strokes(model), frame(&model.base.xyz), frame(&model.tool.xyz)]
}

/// The longest strokes of the sliding joints together.
pub fn strokes(model: &Model) -> f64 {
    let sliding = model.joints.iter().filter(|joint| joint.kind == JointKind::Prismatic);
    let longest = |ends: [f64; 2]| {
        ends.iter().filter(|end| end.is_finite()).fold(0.0, |longest: f64, end| longest.max(end.abs()))
    };
    sliding.filter_map(|joint| joint.limits).map(longest).sum()
}
