//! The names in the loops of an inverse.

use super::Target;
use super::tokens::{Writer, ident};
use crate::lower::{self, BranchState, Slot};
use crate::solve::Plan;
use crate::symbolic::Label;
use proc_macro2::Ident;

/// The settings that the statements are written with.
pub struct Nest<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// The scalar type, and paths.
    pub target: &'a Target,
    /// The plan as a program.
    pub program: &'a lower::Inverse,
    /// True if lengths are compared to a reach that is known at run time only.
    pub bound: bool,
    /// True if the expressions are those of lanes.
    pub lanes: bool,
    /// True if a call may ask for one branch.
    pub selects: bool,
}

impl Nest<'_> {
    /// Writes expressions.
    pub fn writer(&self) -> Writer<'_> {
        Writer { graph: &self.program.graph, bound: &self.program.names, krate: &self.target.krate, lanes: self.lanes }
    }

    /// The name of a leaf.
    pub fn leaf(&self, slot: Slot) -> Ident {
        ident(&self.program.graph.leaf_name(slot).unwrap_or_default())
    }

    /// The number of a stage in names: its joints.
    pub fn number(&self, stage: usize) -> String {
        let labels = self.plan.stages().nth(stage).map(|stage| self.plan.labels(stage));
        labels.unwrap_or_default().iter().map(Label::to_string).collect()
    }

    /// The name of the state of a branch after a step.
    pub fn state(&self, state: BranchState) -> Ident {
        match state {
            BranchState::Start => ident("start"),
            BranchState::Stage(stage) => ident(&format!("state{}", self.number(stage))),
            BranchState::Agreed(_) => ident("agreed"),
            BranchState::Swung => ident("swung"),
        }
    }
}
