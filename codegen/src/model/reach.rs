//! The size of an arm, which every length is compared to.

use super::arm::Model;
use super::joint::JointKind;
use super::numeric::length;
use crate::error::Diagnostic;
use crate::spec::{Length, Spec};
use std::collections::HashMap;

/// Range of an arm's reach: the kernels compute fourth powers of lengths, which must stay in the range of the scalar.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    least: f64,
    most: f64,
    /// The kind of arm that has this range, and advice for an arm outside it.
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

/// A term of an arm's reach.
#[derive(Debug, Clone, Copy)]
pub enum ReachTerm<'a> {
    /// Of a row `|a| + |d|`.
    Row([&'a Length; 2]),
    /// The longest displacements of all prismatic joints.
    Displacements(f64),
    /// Of the base or the tool the distance of its origin.
    Frame(&'a [Length; 3]),
}

impl ReachTerm<'_> {
    /// Its value with the parameters at these values, else at their defaults.
    pub fn at(&self, values: &HashMap<String, f64>) -> f64 {
        match self {
            ReachTerm::Row([a, d]) => a.at(values).abs() + d.at(values).abs(),
            ReachTerm::Displacements(value) => *value,
            ReachTerm::Frame(xyz) => length(xyz.each_ref().map(|x| x.at(values))),
        }
    }
}

/// The terms of an arm's reach, `sum(|a| + |d|) + sum of max |limit| + |base| + |tool|`, in the order of their sum. The
/// limits are those of prismatic joints; where there is none, a displacement counts 0.
pub fn reach_terms(model: &Model) -> impl Iterator<Item = ReachTerm<'_>> {
    let sliding = model.joints.iter().filter(|joint| joint.kind == JointKind::Prismatic);
    let longest = |ends: [f64; 2]| {
        ends.iter().filter(|end| end.is_finite()).fold(0.0, |longest: f64, end| longest.max(end.abs()))
    };
    let displacements = sliding.filter_map(|joint| joint.limits).map(longest).sum();
    let rows = model.rows.iter().map(|row| ReachTerm::Row([&row.a, &row.d]));
    let frames = [&model.base, &model.tool].map(|frame| ReachTerm::Frame(&frame.xyz));
    rows.chain([ReachTerm::Displacements(displacements)]).chain(frames)
}

/// The reach, parameters at the given values (else at their defaults); 1 if that is zero.
pub fn reach(model: &Model, values: &HashMap<String, f64>) -> f64 {
    let total = reach_terms(model).fold(0.0, |sum, term| sum + term.at(values));
    if total > 0.0 { total } else { 1.0 }
}
