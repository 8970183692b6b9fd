//! A point alone, for three joints.

use crate::model::Angle;
use crate::model::geometry::{Triple, TripleKind};
use crate::solve::loop_chain::{LoopChain, LoopJoint};
use crate::solve::plan::Plan;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::solve::{rank, structure};
use crate::symbolic::{Graph, Rigid};

/// Three virtual joints about the point, whose axes intersect there, and of which none is wanted.
///
/// # Errors
/// If the joints do not move the point in space.
pub fn plan(mut chain: LoopChain) -> Result<Plan, Unsupported> {
    rank::check(&chain, rank::ToolMotion::Point)?;
    let task = PlanTask::new(Goal::Position, chain.given.clone());
    let link = |g: &mut Graph, degrees: f64| {
        let pair = g.turn(Angle::degrees(degrees));
        Rigid { r: g.rotation_x(pair), ..Rigid::identity() }
    };
    let (there, back) = (link(&mut chain.g, 90.0), link(&mut chain.g, -90.0));
    chain.append(LoopJoint::virtual_turn(1), Rigid::identity());
    chain.append(LoopJoint::virtual_turn(2), there);
    chain.append(LoopJoint::virtual_turn(3), back);
    structure::around(chain, Triple { first: 3, kind: TripleKind::Intersecting }, &task)
}
