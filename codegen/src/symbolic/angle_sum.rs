//! Sines and cosines: only ever of a signed sum of joint angles plus a constant angle held exactly.

use super::{Expr, Graph};
use crate::model::Angle;

/// A sine and a cosine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pair {
    /// The sine.
    pub sin: Expr,
    /// The cosine.
    pub cos: Expr,
}

impl Pair {
    /// The pair of the opposite angle.
    pub fn opposite(self, g: &mut Graph) -> Pair {
        Pair { sin: g.neg(self.sin), cos: self.cos }
    }

    /// The pair of the sum of two angles.
    pub fn plus(self, g: &mut Graph, other: Pair) -> Pair {
        let [cos, sin, _] = g.rotate_z(self, [other.cos, other.sin, Expr::ZERO]);
        Pair { sin, cos }
    }
}

/// `sign_1 q_1 + ... + constant`: joints by index, in chain order.
#[derive(Debug, Clone, PartialEq)]
pub struct AngleSum {
    /// `(joint, negative)`, joints counted from 0.
    pub terms: Vec<(usize, bool)>,
    /// The constant part.
    pub constant: Angle,
}

impl AngleSum {
    /// The empty sum.
    pub fn zero() -> Self {
        AngleSum { terms: Vec::new(), constant: Angle::ZERO }
    }

    /// Adds `sign (q_joint + offset)`.
    pub fn push(&mut self, joint: Option<usize>, offset: Angle, negative: bool) {
        self.terms.extend(joint.map(|j| (j, negative)));
        self.constant = self.constant.add(if negative { offset.neg() } else { offset });
    }

    /// The sum with its leading joint positive, and whether that changed the sign.
    fn oriented(&self) -> (AngleSum, bool) {
        match self.terms.first() {
            Some((_, true)) => {
                let terms = self.terms.iter().map(|(j, negative)| (*j, !negative)).collect();
                (AngleSum { terms, constant: self.constant.neg() }, true)
            }
            _ => (self.clone(), false),
        }
    }

    /// The suffix of its names, such as `23` for `q2 + q3`, `2m3` for `q2 - q3`; an inexact constant adds `o`.
    fn suffix(&self) -> String {
        let mut out = String::new();
        for (i, (joint, negative)) in self.terms.iter().enumerate() {
            if i > 0 && (*negative || self.terms.iter().any(|(j, _)| *j >= 9)) {
                out.push(if *negative { 'm' } else { '_' });
            }
            out.push_str(&(joint + 1).to_string());
        }
        out
    }
}

/// A sum whose sine and cosine a function needs: bound once at its top.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundAngle {
    /// The sum, its leading joint positive, its constant less than a quarter turn if exact.
    pub sum: AngleSum,
    /// The symbols of its sine and cosine.
    pub pair: Pair,
}

/// The sums in use, in order of first use.
#[derive(Debug, Clone, Default)]
pub struct Angles {
    /// The sums so far.
    pub bound: Vec<BoundAngle>,
}

impl Angles {
    /// Sine and cosine of a sum. Signs and quarter turns are folded, so `sin(q - 90 deg)` is `-c`.
    pub fn pair(&mut self, g: &mut Graph, sum: &AngleSum) -> Pair {
        if sum.terms.is_empty() {
            return g.turn(sum.constant);
        }
        let (mut sum, flipped) = sum.oriented();
        let turns = sum.constant.quarter_turns();
        if turns.is_some() {
            sum.constant = Angle::ZERO;
        }
        let base = self.symbols(g, sum);
        let (s, c) = (base.sin, base.cos);
        let turned = match turns {
            Some(1) => Pair { sin: c, cos: g.neg(s) },
            Some(2) => Pair { sin: g.neg(s), cos: g.neg(c) },
            Some(3) => Pair { sin: g.neg(c), cos: s },
            _ => base,
        };
        if flipped { turned.opposite(g) } else { turned }
    }

    fn symbols(&mut self, g: &mut Graph, sum: AngleSum) -> Pair {
        if let Some(known) = self.bound.iter().find(|b| b.sum == sum) {
            return known.pair;
        }
        let same_joints = self.bound.iter().filter(|b| b.sum.terms == sum.terms).count();
        let suffix = sum.suffix() + &"o".repeat(same_joints);
        let pair = Pair { sin: g.symbol(format!("s{suffix}")), cos: g.symbol(format!("c{suffix}")) };
        self.bound.push(BoundAngle { sum, pair });
        pair
    }
}
