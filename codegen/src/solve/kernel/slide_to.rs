//! A linear equation for a prismatic joint.

use super::argument::Argument;
use super::equation::{Equation, Form};
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
    fn form(&self) -> Form {
        let [denominator, numerator] = [self.denominator, self.numerator].map(Argument::Number);
        Form {
            roots: 1,
            ..Form::new(
                "slide_to",
                "slides by a given amount (1 root)",
                vec![Argument::Default(0), Argument::Measure, denominator, numerator],
            )
        }
    }

    fn pivot(&self, _: &mut Graph, _: &Variables) -> Pivot {
        Pivot { value: self.denominator, power: 0 }
    }
}
