//! A point that a prismatic joint moves comes to a given distance from another one.

use super::argument::{Argument, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `rho^2 = across^2 + (x - middle)^2`
#[derive(Debug, Clone, PartialEq)]
pub struct Slide {
    /// The distance.
    pub rho: Expr,
    /// Distance of the line.
    pub across: Expr,
    /// The displacement that is nearest.
    pub middle: Expr,
}

impl Equation for Slide {
    fn form(&self) -> Form {
        let [rho, across, middle] = [self.rho, self.across, self.middle].map(Argument::Number);
        Form {
            quantities: vec![("rho", Quantity::Value(self.rho))],
            ..Form::new("slide", "slides to a given distance (2 roots)", vec![Argument::Measure, rho, across, middle])
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let position = variables.position(g, 0);
        Pivot { value: g.sub(position, self.middle), power: 1 }
    }
}
