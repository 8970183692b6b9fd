//! A revolute and a prismatic joint with a third one between them that is prismatic.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables, derivative};
use crate::symbolic::{Expr, Graph};

/// `rows . (cos, sin, 1) = direction x`: two components across the prismatic joint between the two.
#[derive(Debug, Clone, PartialEq)]
pub struct SlideTurning {
    /// The direction there of the prismatic joint.
    pub direction: [Expr; 2],
    /// Rows of the revolute joint: of the cosine, of the sine, constant.
    pub rows: [[Expr; 3]; 2],
}

impl Equation for SlideTurning {
    fn form(&self) -> Form {
        let (direction, rows) = (Argument::numbers(&self.direction), Argument::rows(&self.rows));
        Form::new(
            "slide_turning",
            "two components across a slide, an angle and another slide (2 roots)",
            vec![Argument::defaults(), Argument::Measure, direction, rows],
        )
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let t = variables.pair(g, 0);
        let rates = self.rows.map(|row| derivative(g, row, t));
        Pivot { value: g.cross2(self.direction, rates), power: 1 }
    }
}
