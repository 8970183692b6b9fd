//! A point that a joint turns comes to a given distance from another one.

use super::argument::{Argument, Phase, Quantity};
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// The range of a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElbowRange {
    /// Distance of the first point from the axis.
    pub a: Expr,
    /// Distance of the second.
    pub b: Expr,
    /// How far apart they are along the axis.
    pub height: Expr,
}

impl ElbowRange {
    /// The expressions it reads.
    pub fn inputs(&self) -> [Expr; 3] {
        [self.a, self.b, self.height]
    }
}

/// `rho^2 = a^2 + b^2 + height^2 + 2 a b cos(t)`: subproblem 3 of Paden and Kahan, and of IK-Geo. The angle `t` counts
/// from where the links are stretched.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    /// The distance.
    pub rho: Expr,
    /// Its range.
    pub range: ElbowRange,
    /// Where the angle is counted from, if only known at run time.
    pub about: Option<Phase>,
}

impl Equation for Distance {
    fn form(&self) -> Form {
        let [a, b, height] = self.range.inputs();
        let range = Argument::Range(vec![a, b, height]);
        Form {
            about: self.about,
            quantities: [("rho", self.rho), ("a", a), ("b", b), ("h", height)]
                .map(|(key, e)| (key, Quantity::Value(e)))
                .to_vec(),
            ..Form::new(
                "distance",
                "two points a given distance apart, law of cosines (2 roots)",
                vec![Argument::Default(0), Argument::Measure, Argument::Number(self.rho), range],
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        variables.about(g, self.about, 2)
    }
}
