//! A pose or a point in the base frame's xy plane.

use crate::model::Angle;
use crate::model::geometry::{Triple, TripleKind};
use crate::solve::loop_chain::LoopChain;
use crate::solve::loop_closure::LoopClosure;
use crate::solve::plan::Plan;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::solve::{planar, rank};
use crate::symbolic::{Expr, Graph, Input, Pair, transpose};

/// The loop of three joints in the plane; for a point alone the third one is virtual.
///
/// # Errors
/// If the joints do not move in the plane, or are singular everywhere.
pub fn plan(goal: Goal, mut chain: LoopChain) -> Result<Plan, Unsupported> {
    let is_pose = goal == Goal::PlanarPose;
    rank::check(&chain, if is_pose { rank::ToolMotion::Pose } else { rank::ToolMotion::Point })?;
    let twist = if is_pose { chain.tool_twist() } else { Some(Angle::ZERO) };
    let (true, Some(twist)) = (chain.is_planar(), twist) else {
        return Err(Unsupported::new(format!(
            "the task `{}` needs axes parallel to the base z axis (sliding joints across it){}",
            goal.task().name(),
            if is_pose { " and a tool whose x axis lies in the plane" } else { "" }
        )));
    };
    chain.target.p = [chain.g.symbol(Input::Position(0)), chain.g.symbol(Input::Position(1)), Expr::ZERO];
    if is_pose {
        chain.generic.angle([Input::Phi, Input::SinPhi, Input::CosPhi]);
        let phi = Pair { sin: chain.g.symbol(Input::SinPhi), cos: chain.g.symbol(Input::CosPhi) };
        let twist = chain.g.turn(twist);
        let columns = Graph::identity().map(|axis| {
            let axis = chain.g.rotate_x(twist, axis);
            chain.g.rotate_z(phi, axis)
        });
        chain.target.r = transpose(&columns);
    } else {
        // The tool point alone: its frame turns on a virtual joint about z of the base.
        chain.target.r = Graph::identity();
        chain.append_upright();
    }
    let triple = Triple { first: 0, kind: TripleKind::Parallel };
    let task = PlanTask::new(goal, chain.given);
    let mut c = LoopClosure::new(chain, triple);
    let links = [c.link(0), c.link(1), c.link(2)];
    planar::solve(&mut c, [0, 1, 2], links)?;
    Ok(c.finish(triple, task))
}
