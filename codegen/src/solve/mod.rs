//! The inverse plan: which equations give which joints, in which order.
//!
//! Method: a chain of six joints closes cyclically with the target inside. Three consecutive axes that meet in a point
//! or are parallel leave two equations in two of the other joints; then the third by turning one vector onto another,
//! then the triple. Structure is decided here, on exact constants; what is left is a sequence of scalar equations, each
//! with its own kernel. Smaller tasks become the same closure with virtual joints for what they leave open; a redundant
//! joint becomes part of its link.

mod asked;
mod closure;
mod few;
mod margins;
mod meeting;
mod meeting_point;
mod parallel;
mod plan;
mod planar;
mod probe;
mod problem;
mod rank;
mod refusal;
mod rows;
mod sides;
mod strokes;
mod swivel;
mod task;
mod triple;
mod two_slides;
mod words;

pub use asked::{PlanTask, SwivelFacts};
pub use margins::{Factor, margins};
pub use plan::{Branching, ElbowRange, Kernel, Phase, Plan, PlanStep, Range, Stage, Unit};
pub use refusal::Refusal;
pub use words::describe;

use crate::model::Model;
use crate::model::chain::Chain;
use crate::model::geometry::{Geometry, Triple, TripleKind};
use problem::Problem;

/// The plan for an arm, or why there is none.
///
/// # Errors
/// The condition that fails, in words.
pub fn plan(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<Plan, Refusal> {
    task::plan(model, chain, geometry)
}

/// The cheapest plan among the triples of a closed chain of six joints, wherever its sliding joints are moved.
fn cheapest(problem: &Problem, task: &PlanTask) -> Result<Option<Plan>, Refusal> {
    rank::check(problem, rank::Asked::Pose)?;
    let mut best: Option<Plan> = None;
    let mut failure = None;
    for problem in commuted(problem) {
        for triple in problem.triples() {
            match solve(problem.clone(), triple, task) {
                Ok(plan) if best.as_ref().is_none_or(|b| plan.effort() < b.effort()) => best = Some(plan),
                Ok(_) => {}
                Err(refusal) => failure = failure.or(Some(refusal)),
            }
        }
    }
    if best.is_none()
        && let Some(plan) = strokes::plan(problem, task)
    {
        return plan.map(Some);
    }
    match (best, failure) {
        (Some(plan), _) => Ok(Some(plan)),
        (None, Some(refusal)) => Err(refusal),
        (None, None) => Ok(None),
    }
}

/// The chain itself, and every chain that comes of moving sliding joints past turning ones with parallel axes.
fn commuted(problem: &Problem) -> Vec<Problem> {
    let mut found = vec![problem.clone()];
    let mut next = 0;
    while let Some(current) = found.get(next).cloned() {
        next += 1;
        let moved = (0..current.slots.len()).flat_map(|i| [current.slide_later(i), current.slide_earlier(i)]);
        for moved in moved.flatten().collect::<Vec<_>>() {
            if !found.iter().any(|known| known.slots == moved.slots) {
                found.push(moved);
            }
        }
    }
    found
}

fn solve(problem: Problem, triple: Triple, task: &PlanTask) -> Result<Plan, Refusal> {
    let mut closure = closure::Closure::new(problem, triple);
    match triple.kind {
        TripleKind::Meeting => meeting::outer(&mut closure)?,
        TripleKind::Parallel => parallel::outer(&mut closure)?,
        TripleKind::Turning => {}
    }
    match triple.kind {
        // Three virtual joints are not wanted.
        TripleKind::Meeting if closure.is_virtual(triple) => {}
        TripleKind::Meeting | TripleKind::Turning => triple::meeting(&mut closure),
        TripleKind::Parallel => triple::parallel(&mut closure)?,
    }
    Ok(closure.finish(triple, task.clone()))
}
