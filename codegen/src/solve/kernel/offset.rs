//! A point that a joint turns keeps a given distance from a plane.

use super::argument::{Argument, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables, derivative};
use crate::symbolic::{Expr, Graph};

/// `a cos + b sin = d`: subproblem 4 of IK-Geo.
#[derive(Debug, Clone, PartialEq)]
pub struct Offset {
    /// Of the cosine.
    pub a: Expr,
    /// Of the sine.
    pub b: Expr,
    /// Right side.
    pub d: Expr,
}

impl Equation for Offset {
    fn form(&self) -> Form {
        let [a, b, d] = [self.a, self.b, self.d].map(Argument::Number);
        let (cos, sin) = (Quantity::Coefficient(self.a), Quantity::Coefficient(self.b));
        Form {
            quantities: vec![("a", cos), ("b", sin), ("d", Quantity::Value(self.d))],
            ..Form::new(
                "offset",
                "a point keeps an offset, a cos + b sin = d (2 roots)",
                vec![Argument::Default(0), Argument::Measure, a, b, d],
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let t = variables.pair(g, 0);
        Pivot { value: derivative(g, [self.a, self.b, self.d], t), power: variables.power() }
    }
}
