//! The size of an arm, which every length is compared to.

use super::numeric::length;
use super::{JointKind, Length, Model};
use std::collections::HashMap;

/// `sum(|a| + |d|) + |base| + |tool| + sum of max |limit|` of the sliding joints, parameters at the given values (else
/// at their defaults); 1 if that is zero.
pub fn reach(model: &Model, values: &HashMap<String, f64>) -> f64 {
    let rows: f64 = model.rows.iter().map(|row| row.a.at(values).abs() + row.d.at(values).abs()).sum();
    let frame = |xyz: &[Length; 3]| length(xyz.each_ref().map(|x| x.at(values)));
    let total = rows + strokes(model) + frame(&model.base.xyz) + frame(&model.tool.xyz);
    if total > 0.0 { total } else { 1.0 }
}

/// The longest strokes of the sliding joints together.
pub fn strokes(model: &Model) -> f64 {
    let sliding = model.joints.iter().filter(|joint| joint.kind == JointKind::Prismatic);
    let longest = |ends: [f64; 2]| {
        ends.iter().filter(|end| end.is_finite()).fold(0.0, |longest: f64, end| longest.max(end.abs()))
    };
    sliding.filter_map(|joint| joint.limits).map(longest).sum()
}
