//! Deciding on numbers whether an expression vanishes for every target.

use super::kernel::Unit;
use crate::model::Model;
use crate::model::geometry::Decisions;
use crate::symbolic::{Expr, Graph, Input, Node, Symbol};
use std::collections::HashMap;

/// Values of leaves.
pub type Sample = HashMap<Symbol, f64>;

/// A few generic targets, as values of the target's leaves, and generic values of what is given beside it.
#[derive(Debug, Clone)]
pub struct GenericSamples {
    samples: Vec<Sample>,
    angles: Vec<Symbol>,
    positions: usize,
    reach: f64,
    /// Decisions made on the samples.
    pub decisions: Decisions,
}

impl GenericSamples {
    /// Targets within the reach of an arm, with no special orientation.
    pub fn new(reach: f64) -> GenericSamples {
        let samples = [0.37, 1.91, -2.63]
            .map(|seed: f64| {
                // A rotation from a quaternion that is special for no arm.
                let q = [seed.sin(), (1.3 * seed).cos(), (2.1 * seed).sin() + 0.2, (0.7 * seed).cos()];
                let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
                let [w, x, y, z] = q.map(|c| c / norm);
                let r = [
                    [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                    [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
                    [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
                ];
                let p = [0.31 * reach * seed.cos(), 0.27 * reach * (seed + 1.0).sin(), 0.23 * reach];
                let rotation =
                    Input::ROTATION.into_iter().zip(r).flat_map(|(entries, row)| entries.into_iter().zip(row));
                let position = Input::POSITION.into_iter().zip(p);
                rotation.chain(position).map(|(input, value)| (input.into(), value)).collect()
            })
            .to_vec();
        GenericSamples { samples, angles: Vec::new(), positions: 0, reach, decisions: Decisions::default() }
    }

    /// Run-time parameters are symbols with generic values.
    pub fn parameters(&mut self, g: &Graph, model: &Model) {
        for (sample, values) in self.samples.iter_mut().zip(model.samples()) {
            sample.extend(values.into_iter().map(|(name, value)| (g.field(&name), value)));
        }
    }

    /// A displacement that is given.
    pub fn position(&mut self, input: Input) {
        // No two displacements may look alike.
        let shift = 0.137 * self.positions as f64;
        for (sample, part) in self.samples.iter_mut().zip([0.25f64, -0.41, 0.66]) {
            sample.insert(input.into(), (part + shift * part.signum()) * self.reach);
        }
        self.positions += 1;
    }

    /// An angle that is given, with its sine and cosine.
    pub fn angle(&mut self, [angle, sin, cos]: [Input; 3]) {
        // No two angles may look alike.
        let shift = 0.471 * self.angles.len() as f64;
        for (sample, value) in self.samples.iter_mut().zip([0.83f64, -1.37, 2.21]) {
            let value = value + shift * value.signum();
            sample.extend([(angle, value), (sin, value.sin()), (cos, value.cos())].map(|(input, x)| (input.into(), x)));
        }
        self.angles.push(angle.into());
    }

    /// The given angles.
    pub fn angles(&self) -> &[Symbol] {
        &self.angles
    }

    /// The samples.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// The value of an expression that is the same for every target and every given joint.
    pub fn value(&self, g: &Graph, e: Expr) -> Option<f64> {
        if !self.decides(g, &[e]) {
            return None;
        }
        let mut values = self.samples.iter().filter_map(|sample| g.evaluate(&[e], sample).first().copied());
        let first = values.next()?;
        let same = values.all(|value| (value - first).abs() <= 1e-13 * first.abs().max(self.reach.min(1.0)));
        same.then_some(first)
    }

    /// Returns true if the expressions depend only on symbols that have samples: not on joints that are solved at run
    /// time.
    pub fn decides(&self, g: &Graph, expressions: &[Expr]) -> bool {
        let Some(sample) = self.samples.first() else { return false };
        g.reachable(expressions).into_iter().all(|e| match g.node(e) {
            Node::Symbol(symbol) => symbol.value().is_some() || sample.contains_key(&symbol),
            _ => true,
        })
    }

    /// Returns true if each expression vanishes for every target; lengths are compared to reach.
    pub fn vanish(&self, g: &Graph, expressions: &[Expr], unit: Unit) -> bool {
        if !self.decides(g, expressions) {
            return false;
        }
        let scale = if unit == Unit::Length { self.reach } else { 1.0 };
        let vanishes = |value: &f64| self.decisions.vanishes(value / scale);
        self.samples.iter().all(|sample| g.evaluate(expressions, sample).iter().all(vanishes))
    }
}
