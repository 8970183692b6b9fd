//! The structure that a plan is built around: three consecutive joints, tried in every place and order.

use super::commuted::commuted;
use super::loop_chain::LoopChain;
use super::loop_closure::LoopClosure;
use super::plan::Plan;
use super::task::PlanTask;
use super::unsupported::Unsupported;
use super::{intersecting_axes, parallel_axes, rank, three_prismatic, triple};
use crate::model::geometry::{Triple, TripleKind};

/// The cheapest plan among the triples of a closed chain of six joints, wherever its prismatic joints are moved.
pub fn cheapest(chain: &LoopChain, task: &PlanTask) -> Result<Option<Plan>, Unsupported> {
    rank::check(chain, rank::ToolMotion::Pose)?;
    let mut best: Option<Plan> = None;
    let mut failure = None;
    for chain in commuted(chain) {
        for triple in chain.triples() {
            match around(chain.clone(), triple, task) {
                Ok(plan) if best.as_ref().is_none_or(|b| plan.effort() < b.effort()) => best = Some(plan),
                Ok(_) => {}
                Err(unsupported) => failure = failure.or(Some(unsupported)),
            }
        }
    }
    if best.is_none()
        && let Some(plan) = three_prismatic::plan(chain, task)
    {
        return plan.map(Some);
    }
    match (best, failure) {
        (Some(plan), _) => Ok(Some(plan)),
        (None, Some(unsupported)) => Err(unsupported),
        (None, None) => Ok(None),
    }
}

/// The plan around one triple.
pub fn around(chain: LoopChain, triple: Triple, task: &PlanTask) -> Result<Plan, Unsupported> {
    let mut c = LoopClosure::new(chain, triple);
    match triple.kind {
        TripleKind::Intersecting => {
            c.move_to_intersection();
            intersecting_axes::outer(&mut c)?;
        }
        TripleKind::Parallel => parallel_axes::outer(&mut c)?,
        TripleKind::Turning => {}
    }
    match triple.kind {
        // Three virtual joints are not wanted.
        TripleKind::Intersecting if c.is_virtual(triple) => {}
        TripleKind::Intersecting | TripleKind::Turning => triple::intersecting(&mut c),
        TripleKind::Parallel => triple::parallel(&mut c)?,
    }
    Ok(c.finish(triple, task.clone()))
}
