//! What all equations have.

use super::argument::{Argument, Phase, Quantity};
use super::pivot::{Pivot, Variables};
use crate::symbolic::Graph;

/// An equation, as the planner, the report, the margins and the code see it.
pub trait Equation {
    /// The runtime's function that solves it.
    fn function(&self) -> &'static str;

    /// What it takes, in order.
    fn arguments(&self) -> Vec<Argument>;

    /// Where its angle is counted from, if that is only known at run time.
    fn about(&self) -> Option<Phase> {
        None
    }

    /// The largest number of roots of regular targets.
    fn roots(&self) -> usize {
        2
    }

    /// The same with the roots that there are besides where a joint is free.
    fn most_roots(&self) -> usize {
        self.roots()
    }

    /// Its line in a report.
    fn description(&self) -> &'static str;

    /// Its derivative by its joints' variables: the determinant for two of them.
    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot;

    /// What the text of a stage may name in braces.
    fn quantities(&self) -> Vec<(&'static str, Quantity)> {
        Vec::new()
    }
}
