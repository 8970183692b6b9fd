//! A vector that a joint turns takes a given component along another axis.

use super::argument::{Argument, Phase, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// The range of a component: see the runtime's `Cone`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConeRange {
    /// Component of the vector along the turning axis.
    pub along: Expr,
    /// Component across it.
    pub across: Expr,
    /// Cosine of the other axis to the turning axis.
    pub cos: Expr,
    /// Sine of it, not negative.
    pub sin: Expr,
}

impl ConeRange {
    /// The expressions it reads.
    pub fn inputs(&self) -> [Expr; 4] {
        [self.along, self.across, self.cos, self.sin]
    }
}

/// `d = along cos + across sin cos(t)`: subproblem 4 of IK-Geo, with the other axis as the normal of the plane. The angle
/// `t` counts from where the vector is nearest to that axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    /// The component.
    pub d: Expr,
    /// The component across.
    pub rho: Expr,
    /// The range.
    pub range: ConeRange,
    /// Where the angle is counted from, if only known at run time.
    pub about: Option<Phase>,
}

impl Equation for Cone {
    fn form(&self) -> Form {
        let range = Argument::Range(self.range.inputs().to_vec());
        let [d, rho] = [self.d, self.rho].map(Argument::Number);
        Form {
            about: self.about,
            quantities: vec![("d", Quantity::Value(self.d))],
            ..Form::new(
                "cone",
                "a component along another axis (2 roots)",
                vec![Argument::Default(0), Argument::Measure, d, rho, range],
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        variables.about(g, self.about, variables.power())
    }
}
