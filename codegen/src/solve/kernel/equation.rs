//! Properties that all equations have.

use super::argument::{Argument, Phase, Quantity};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Expr, Graph};

/// Form of an equation, as the planner, the report and the code use it.
#[derive(Debug, Clone)]
pub struct Form {
    /// The runtime's function that solves it.
    pub function: &'static str,
    /// Arguments of the function, in order.
    pub arguments: Vec<Argument>,
    /// Where its angle is counted from, if that is only known at run time.
    pub about: Option<Phase>,
    /// The largest number of roots of regular targets.
    pub roots: usize,
    /// How many more there are where a joint is free.
    pub extra_roots: usize,
    /// Its line in a report.
    pub description: &'static str,
    /// Quantities that the text of a stage may name in braces.
    pub quantities: Vec<(&'static str, Quantity)>,
}

impl Form {
    /// Form of an equation with two roots.
    pub fn new(function: &'static str, description: &'static str, arguments: Vec<Argument>) -> Self {
        Form { function, arguments, about: None, roots: 2, extra_roots: 0, description, quantities: Vec::new() }
    }

    /// The expressions it reads.
    pub fn inputs(&self) -> Vec<Expr> {
        let about = self.about.iter().flat_map(|phase| [phase.y, phase.x]);
        self.arguments.iter().flat_map(Argument::inputs).chain(about).collect()
    }
}

/// An equation.
pub trait Equation {
    /// Form of the equation.
    fn form(&self) -> Form;

    /// Its derivative by its joints' variables: the determinant for two of them.
    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot;
}
