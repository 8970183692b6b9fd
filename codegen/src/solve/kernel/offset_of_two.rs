//! A point and a direction that a joint turns keep given offsets from a plane.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// `a cos + b sin = d` of lengths and of directions, as `[a, b, d]`: two equations for one joint. The runtime takes the
/// better conditioned one. Each is subproblem 4 of IK-Geo.
#[derive(Debug, Clone, PartialEq)]
pub struct OffsetOfTwo {
    /// Of lengths.
    pub length: [Expr; 3],
    /// Of directions.
    pub direction: [Expr; 3],
}

impl Equation for OffsetOfTwo {
    fn form(&self) -> Form {
        let [length, direction] = [self.length, self.direction].map(|row| Argument::numbers(&row));
        Form::new(
            "offset_of_two",
            "a point and a direction keep offsets, a cos + b sin = d (2 roots)",
            vec![Argument::Default(0), Argument::Measure, length, direction],
        )
    }

    /// There are more equations than joints, so no margins.
    fn pivot(&self, _: &mut Graph, _: &Variables) -> Pivot {
        Pivot::ONE
    }
}
