//! The inverse plan: which equations give which joints, in which order.
//!
//! Method: a chain of six joints closes cyclically with the target inside. Three consecutive axes that meet in a point
//! or are parallel leave two equations in two of the other joints; then the third by turning one vector onto another,
//! then the triple. Structure is decided here, on exact constants; what is left is a sequence of scalar equations, each
//! with its own kernel.

mod closure;
mod meeting;
mod parallel;
mod plan;
mod probe;
mod refusal;
mod rows;
mod sides;
mod triple;
mod words;

pub use plan::{Branching, ElbowRange, Kernel, Plan, PlanStep, Range, Stage, Unit};
pub use refusal::Refusal;
pub use words::describe;

use crate::model::chain::Chain;
use crate::model::geometry::{Geometry, Triple, TripleKind};
use crate::model::{JointKind, Model, Task};

/// The plan for an arm, or why there is none.
///
/// # Errors
/// The condition that fails, in words.
pub fn plan(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<Plan, Refusal> {
    refusal::applicable(model)?;
    if geometry.triples.is_empty() {
        return Err(refusal::no_triple(model, geometry));
    }
    let mut best: Option<Plan> = None;
    let mut failure = None;
    for triple in &geometry.triples {
        match solve(model, chain, geometry, *triple) {
            Ok(plan) if best.as_ref().is_none_or(|b| plan.effort() < b.effort()) => best = Some(plan),
            Ok(_) => {}
            Err(refusal) => failure = failure.or(Some(refusal)),
        }
    }
    best.ok_or_else(|| failure.unwrap_or_else(|| refusal::no_triple(model, geometry)))
}

fn solve(model: &Model, chain: &Chain, geometry: &Geometry, triple: Triple) -> Result<Plan, Refusal> {
    let mut closure = closure::Closure::new(model, chain, geometry, triple);
    match triple.kind {
        TripleKind::Meeting => meeting::outer(&mut closure)?,
        TripleKind::Parallel => parallel::outer(&mut closure)?,
    }
    match triple.kind {
        TripleKind::Meeting => triple::meeting(&mut closure),
        TripleKind::Parallel => triple::parallel(&mut closure),
    }
    Ok(closure.finish(triple))
}

/// The task of the file, or the one six joints can do.
fn task(model: &Model) -> Option<Task> {
    match model.inverse.task {
        Some(task) => Some(task),
        None if model.joints.len() == 6 => Some(Task::Pose),
        None => None,
    }
}

fn is_revolute(model: &Model, joint: usize) -> bool {
    model.joints.get(joint).is_some_and(|j| j.kind == JointKind::Revolute)
}
