//! The derivative of an equation by its joints' variables.

use super::argument::Phase;
use crate::symbolic::{Expr, Graph, Pair, Part, Unknown};

/// Unit of an equation's numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Lengths.
    Length,
    /// Components of unit vectors.
    Direction,
}

/// A derivative: `value / reach^power` has no unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pivot {
    /// The derivative.
    pub value: Expr,
    /// How many lengths it is a product of.
    pub power: u32,
}

impl Pivot {
    /// Of an angle by itself.
    pub const ONE: Pivot = Pivot { value: Expr::ONE, power: 0 };
}

/// The variables of a stage's kernel.
#[derive(Debug, Clone, Copy)]
pub struct Variables<'a> {
    /// By the joint's place in the stage: value, sine, cosine.
    pub unknowns: &'a [[Unknown; 3]],
    /// Unit of the equation's numbers.
    pub unit: Unit,
}

impl Variables<'_> {
    /// 1 for an equation between lengths.
    pub fn power(&self) -> u32 {
        u32::from(self.unit == Unit::Length)
    }

    /// Sine and cosine of a variable.
    pub fn pair(&self, g: &mut Graph, place: usize) -> Pair {
        let [sin, cos] = [Part::Sin, Part::Cos].map(|part| self.symbol(g, place, part));
        Pair { sin, cos }
    }

    /// The displacement of a prismatic joint.
    pub fn position(&self, g: &mut Graph, place: usize) -> Expr {
        self.symbol(g, place, Part::Value)
    }

    fn symbol(&self, g: &mut Graph, place: usize, part: Part) -> Expr {
        let unknown = self.unknowns.get(place).and_then(|parts| parts.iter().find(|unknown| unknown.part == part));
        unknown.map_or(Expr::ZERO, |unknown| g.symbol(*unknown))
    }

    /// The sine of the angle from the double root. Where that root is only known at run time, the sine is multiplied by
    /// the product of the two radii, `power` lengths.
    pub fn about(&self, g: &mut Graph, about: Option<Phase>, power: u32) -> Pivot {
        let t = self.pair(g, 0);
        match about {
            None => Pivot { value: t.sin, power: 0 },
            Some(Phase { y, x }) => {
                let value = g.cross2([x, y], [t.cos, t.sin]);
                Pivot { value, power }
            }
        }
    }
}

/// Of `a cos + b sin + c` the derivative `b cos - a sin`.
pub fn derivative(g: &mut Graph, [a, b, _]: [Expr; 3], t: Pair) -> Expr {
    g.cross2([b, a], [t.sin, t.cos])
}
