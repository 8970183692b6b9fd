//! Two axes at right angles point a direction.

use super::argument::{Argument, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `R_z(y) R_y(x) e_z = m` for the inner joint x and the outer joint y, in this order. Subproblem 2 of Paden and Kahan, the
/// axes at a right angle. With `x = 0` joint y is free.
#[derive(Debug, Clone, PartialEq)]
pub struct Flip {
    /// The direction.
    pub m: [Expr; 3],
}

impl Equation for Flip {
    fn form(&self) -> Form {
        Form {
            quantities: vec![("m", Quantity::List(self.m.to_vec()))],
            ..Form::new(
                "flip",
                "two axes at right angles point a direction (2 roots)",
                vec![Argument::Default(1), Argument::numbers(&self.m)],
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        Pivot { value: variables.pair(g, 0).sin, power: 0 }
    }
}
