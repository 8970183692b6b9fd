//! A joint turns one vector onto another.

use super::argument::{Argument, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `R_z(t) from = to`, up to their lengths: subproblem 1 of Paden and Kahan, and of IK-Geo.
#[derive(Debug, Clone, PartialEq)]
pub struct Align {
    /// The vector turned.
    pub from: [Expr; 2],
    /// The direction it takes.
    pub to: [Expr; 2],
}

impl Equation for Align {
    fn form(&self) -> Form {
        let [from, to] = [self.from, self.to].map(|vector| Argument::numbers(&vector));
        Form {
            roots: 1,
            quantities: [("from", self.from), ("to", self.to)]
                .map(|(key, list)| (key, Quantity::List(list.to_vec())))
                .to_vec(),
            ..Form::new(
                "align",
                "one vector turned onto another (1 root)",
                vec![Argument::Default(0), Argument::Measure, from, to],
            )
        }
    }

    /// The equation gives the angle itself.
    fn pivot(&self, _: &mut Graph, _: &Variables) -> Pivot {
        Pivot::ONE
    }
}
