//! A point that a joint turns keeps a given distance from a plane.

use super::argument::{Argument, Quantity};
use super::equation::Equation;
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
    fn function(&self) -> &'static str {
        "offset"
    }

    fn arguments(&self) -> Vec<Argument> {
        let [a, b, d] = [self.a, self.b, self.d].map(Argument::Number);
        vec![Argument::Default(0), Argument::Measure, a, b, d]
    }

    fn description(&self) -> &'static str {
        "a point keeps an offset, a cos + b sin = d (2 roots)"
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let t = variables.pair(g, 0);
        Pivot { value: derivative(g, [self.a, self.b, self.d], t), power: variables.power() }
    }

    fn quantities(&self) -> Vec<(&'static str, Quantity)> {
        let [a, b] = [self.a, self.b].map(Quantity::Coefficient);
        vec![("a", a), ("b", b), ("d", Quantity::Value(self.d))]
    }
}
