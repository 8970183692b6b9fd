//! Two equations in two prismatic joints, one of them eliminated.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `a x^2 + b x + c = 0`
#[derive(Debug, Clone, PartialEq)]
pub struct Quadratic {
    /// `a`, `b` and `c`.
    pub coefficients: [Expr; 3],
}

impl Equation for Quadratic {
    fn form(&self) -> Form {
        Form::new(
            "quadratic",
            "two equations in two slides, a quadratic (2 roots)",
            vec![Argument::Measure, Argument::numbers(&self.coefficients)],
        )
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let [a, b, _] = self.coefficients;
        let position = variables.position(g, 0);
        let ax = g.mul(a, position);
        let twice = g.add(ax, ax);
        Pivot { value: g.add(twice, b), power: 1 }
    }
}
