//! Two equations in a prismatic and a revolute joint.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables, derivative};
use crate::symbolic::{Expr, Graph};

/// `scale x = line . (cos, sin, 1)`, `x^2 + m x + n = q . (cos, sin, 1)`
#[derive(Debug, Clone, PartialEq)]
pub struct PairSliding {
    /// Of the cosine, of the sine, constant; over `scale`.
    pub line: [Expr; 3],
    /// Common denominator of the line, a constant.
    pub scale: Expr,
    /// `m` and `n`.
    pub square: [Expr; 2],
    /// Of the cosine, of the sine, constant.
    pub q: [Expr; 3],
    /// The vector's components across the axis of the joint between the two, as the prismatic joint moves it: factor and
    /// constant.
    pub sliding: [[Expr; 2]; 2],
    /// The vector's components across that axis, as the revolute joint moves it: rows.
    pub turning: [[Expr; 3]; 2],
}

impl Equation for PairSliding {
    fn form(&self) -> Form {
        let (line, scale) = (Argument::numbers(&self.line), Argument::Number(self.scale));
        let (square, q) = (Argument::numbers(&self.square), Argument::numbers(&self.q));
        let across = Argument::Tuple([Argument::rows(&self.sliding), Argument::rows(&self.turning)].map(Box::new));
        Form {
            roots: 4,
            ..Form::new(
                "pair_sliding",
                "two equations together, a quartic with a slide (up to 4 roots)",
                vec![Argument::Measure, line, scale, square, q, across],
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let position = variables.position(g, 0);
        let z = variables.pair(g, 1);
        let (line, square) = (derivative(g, self.line, z), derivative(g, self.q, z));
        let [m, _] = self.square;
        let twice = g.add(position, position);
        let own = g.add(twice, m);
        Pivot { value: g.cross2([line, self.scale], [square, own]), power: 2 }
    }
}
