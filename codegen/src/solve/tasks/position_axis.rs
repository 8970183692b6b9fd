//! A point and the direction of an axis of the tool, for five joints.

use crate::model::{Angle, Axis};
use crate::solve::loop_chain::{LoopChain, LoopJoint};
use crate::solve::plan::Plan;
use crate::solve::structure;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::symbolic::{Graph, Rigid, transpose};

/// One virtual joint about the tool's axis; without a named one z, or else x, or else y.
///
/// # Errors
/// If no three consecutive joints make a closed form with any of the axes.
pub fn plan(axis: Option<Axis>, chain: LoopChain) -> Result<Plan, Unsupported> {
    let wanted = axis.map_or(vec![Axis::Z, Axis::X, Axis::Y], |axis| vec![axis]);
    let mut failure: Option<Unsupported> = None;
    for axis in wanted {
        let mut chain = chain.clone();
        let goal = Goal::PositionAxis { column: axis.column() };
        let passed_over =
            failure.as_ref().map(|unsupported| format!("axis z cannot be asked for: {}", unsupported.reason));
        let task = PlanTask { passed_over, ..PlanTask::new(goal, chain.given.clone()) };
        turn(&mut chain, axis);
        match structure::cheapest(&chain, &task) {
            Ok(Some(plan)) => return Ok(plan),
            Ok(None) => {
                let unsupported =
                    Unsupported::new("no three consecutive axes (the tool's among them) meet or are parallel");
                failure = failure.or(Some(unsupported));
            }
            Err(unsupported) => failure = failure.or(Some(unsupported)),
        }
    }
    Err(failure.unwrap_or_else(|| Unsupported::new("no axis of the tool can be pointed")))
}

/// Adds the virtual joint about the tool's axis.
pub fn turn(chain: &mut LoopChain, axis: Axis) {
    let before = onto_z(&mut chain.g, axis);
    chain.append(LoopJoint::virtual_turn(1), before);
}

/// The frame whose z axis is the tool's axis.
fn onto_z(g: &mut Graph, axis: Axis) -> Rigid {
    let r = match axis {
        Axis::Z => Graph::identity(),
        Axis::X => {
            let pair = g.turn(Angle::degrees(90.0));
            transpose(&Graph::identity().map(|v| g.rotate_y(pair, v)))
        }
        Axis::Y => {
            let pair = g.turn(Angle::degrees(-90.0));
            g.rotation_x(pair)
        }
    };
    Rigid { r, ..Rigid::identity() }
}
