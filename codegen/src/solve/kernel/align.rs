//! A joint turns one vector onto another.

use super::argument::{Argument, Quantity};
use super::equation::Equation;
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
    fn function(&self) -> &'static str {
        "align"
    }

    fn arguments(&self) -> Vec<Argument> {
        let [from, to] = [self.from, self.to].map(|vector| Argument::numbers(&vector));
        vec![Argument::Default(0), Argument::Measure, from, to]
    }

    fn roots(&self) -> usize {
        1
    }

    fn description(&self) -> &'static str {
        "one vector turned onto another (1 root)"
    }

    /// The equation gives the angle itself.
    fn pivot(&self, _: &mut Graph, _: &Variables) -> Pivot {
        Pivot::ONE
    }

    fn quantities(&self) -> Vec<(&'static str, Quantity)> {
        [("from", self.from), ("to", self.to)].map(|(key, list)| (key, Quantity::List(list.to_vec()))).to_vec()
    }
}
