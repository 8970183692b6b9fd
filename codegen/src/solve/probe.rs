//! Deciding on numbers whether an expression vanishes for every target.

use crate::model::Model;
use crate::model::geometry::TOLERANCE;
use crate::symbolic::{Expr, Graph, Node};
use std::collections::HashMap;

/// Values of symbols, by name.
pub type Sample = HashMap<String, f64>;

/// A few generic targets, as values of the target's symbols.
#[derive(Debug, Clone)]
pub struct Probe {
    samples: Vec<Sample>,
    angles: Vec<String>,
    reach: f64,
}

/// Names of the target's rotation entries and position components.
pub const ROTATION: [[&str; 3]; 3] = [["r11", "r12", "r13"], ["r21", "r22", "r23"], ["r31", "r32", "r33"]];
/// Names of the target's position components.
pub const POSITION: [&str; 3] = ["px", "py", "pz"];

impl Probe {
    /// Targets within the reach of an arm, with no special orientation.
    pub fn new(reach: f64) -> Probe {
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
                let rotation = ROTATION.iter().zip(r).flat_map(|(names, row)| names.iter().zip(row));
                let position = POSITION.iter().zip(p);
                rotation.chain(position).map(|(name, value)| (name.to_string(), value)).collect()
            })
            .to_vec();
        Probe { samples, angles: Vec::new(), reach }
    }

    /// Run-time parameters are symbols with generic values.
    pub fn parameters(&mut self, g: &Graph, model: &Model) {
        for (sample, values) in self.samples.iter_mut().zip(model.samples()) {
            sample.extend(values.into_iter().map(|(name, value)| (g.field(&name), value)));
        }
    }

    /// A sliding joint whose position is given.
    pub fn position(&mut self, name: &str) {
        for (sample, part) in self.samples.iter_mut().zip([0.25, -0.41, 0.66]) {
            sample.insert(name.to_string(), part * self.reach);
        }
    }

    /// An angle that is given, with its sine and cosine, all by name.
    pub fn angle(&mut self, [name, sin, cos]: [&str; 3]) {
        // No two angles may look alike.
        let shift = 0.471 * self.angles.len() as f64;
        for (sample, angle) in self.samples.iter_mut().zip([0.83f64, -1.37, 2.21]) {
            let angle = angle + shift * angle.signum();
            for (name, value) in [(name, angle), (sin, angle.sin()), (cos, angle.cos())] {
                sample.insert(name.to_string(), value);
            }
        }
        self.angles.push(name.to_string());
    }

    /// Names of the given angles.
    pub fn angles(&self) -> &[String] {
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

    /// Whether the expressions depend on nothing but what has samples: not on joints that are solved at run time.
    pub fn decides(&self, g: &Graph, expressions: &[Expr]) -> bool {
        let Some(sample) = self.samples.first() else { return false };
        g.reachable(expressions).into_iter().all(|e| match g.node(e) {
            Node::Symbol(symbol) => symbol.value.is_some() || sample.contains_key(&symbol.name),
            _ => true,
        })
    }

    /// Whether every one of the expressions vanishes for every target; `length` expressions are compared to reach.
    pub fn vanish(&self, g: &Graph, expressions: &[Expr], length: bool) -> bool {
        if !self.decides(g, expressions) {
            return false;
        }
        let small = if length { TOLERANCE * self.reach } else { TOLERANCE };
        self.samples.iter().all(|sample| g.evaluate(expressions, sample).iter().all(|value| value.abs() <= small))
    }
}
