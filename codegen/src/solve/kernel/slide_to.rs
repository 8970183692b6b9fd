//! A linear equation for a prismatic joint.

use super::argument::Argument;
use super::equation::Equation;
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `denominator x = numerator`
#[derive(Debug, Clone, PartialEq)]
pub struct SlideTo {
    /// Left factor.
    pub denominator: Expr,
    /// Right side.
    pub numerator: Expr,
}

impl Equation for SlideTo {
    fn function(&self) -> &'static str {
        "slide_to"
    }

    fn arguments(&self) -> Vec<Argument> {
        let [denominator, numerator] = [self.denominator, self.numerator].map(Argument::Number);
        vec![Argument::Default(0), Argument::Measure, denominator, numerator]
    }

    fn roots(&self) -> usize {
        1
    }

    fn description(&self) -> &'static str {
        "slides by a given amount (1 root)"
    }

    fn pivot(&self, _: &mut Graph, _: &Variables) -> Pivot {
        Pivot { value: self.denominator, power: 0 }
    }
}
