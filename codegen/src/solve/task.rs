//! Tasks as closed chains of six joints.

use super::plan::{Plan, PlanTask};
use super::problem::{Problem, Slot};
use super::{Refusal, cheapest, refusal, solve};
use crate::model::chain::Chain;
use crate::model::geometry::{Geometry, Triple, TripleKind};
use crate::model::{Angle, Axis, Model, Task};
use crate::symbolic::{Graph, Rigid, transpose};

/// The plan for what the file asks, or for the most specific task the arm can do.
pub fn plan(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<Plan, Refusal> {
    let request = &model.inverse;
    let free = model.joints.len() - usize::from(request.redundant.is_some());
    let task = request.task.or(match free {
        6 => Some(Task::Pose),
        5 => Some(Task::PositionAxis),
        3 => Some(Task::Position),
        _ => None,
    });
    let problem = Problem::new(model, chain, geometry.reach, request.redundant);
    match (task, free) {
        (Some(Task::Pose), 6) => pose(model, geometry, problem),
        (Some(Task::Position), 3) => position(problem),
        (Some(Task::PositionAxis), 5) => position_axis(request.axis, problem),
        _ => Err(refusal::not_covered(model, task)),
    }
}

fn plan_task(task: Task, problem: &Problem) -> PlanTask {
    PlanTask { task, locked: problem.locked.clone(), axis: Axis::Z }
}

fn pose(model: &Model, geometry: &Geometry, problem: Problem) -> Result<Plan, Refusal> {
    let task = plan_task(Task::Pose, &problem);
    cheapest(&problem, &task)?.ok_or_else(|| refusal::no_triple(model, geometry))
}

/// A point alone: three virtual joints about it, of which none is wanted.
fn position(mut problem: Problem) -> Result<Plan, Refusal> {
    let task = plan_task(Task::Position, &problem);
    let link = |g: &mut Graph, degrees: f64| {
        let pair = g.constant_pair(Angle::degrees(degrees), "VIRTUAL");
        Rigid { r: transpose(&Graph::identity().map(|axis| g.rotate_x(pair, axis))), ..Rigid::identity() }
    };
    let (there, back) = (link(&mut problem.g, 90.0), link(&mut problem.g, -90.0));
    problem.append(Slot::virtual_turn(1), Rigid::identity(), Rigid::identity());
    problem.append(Slot::virtual_turn(2), there, Rigid::identity());
    problem.append(Slot::virtual_turn(3), back, Rigid::identity());
    solve(problem, Triple { first: 3, kind: TripleKind::Meeting }, &task)
}

/// A point and the direction of a tool axis: one virtual joint about that axis.
fn position_axis(axis: Option<Axis>, problem: Problem) -> Result<Plan, Refusal> {
    let wanted = axis.map_or(vec![Axis::Z, Axis::X, Axis::Y], |axis| vec![axis]);
    let mut failure = None;
    for axis in wanted {
        let mut problem = problem.clone();
        let task = PlanTask { axis, ..plan_task(Task::PositionAxis, &problem) };
        let before = onto_z(&mut problem.g, axis);
        problem.append(Slot::virtual_turn(1), before, Rigid::identity());
        match cheapest(&problem, &task) {
            Ok(Some(plan)) => return Ok(plan),
            Ok(None) => {
                let refusal = Refusal::new("no three consecutive axes (the tool's among them) meet or are parallel");
                failure = failure.or(Some(refusal));
            }
            Err(refusal) => failure = failure.or(Some(refusal)),
        }
    }
    Err(failure.unwrap_or_else(|| Refusal::new("no axis of the tool can be pointed")))
}

/// The frame whose z axis is the tool's axis.
fn onto_z(g: &mut Graph, axis: Axis) -> Rigid {
    let turn = |g: &mut Graph, degrees: f64| g.constant_pair(Angle::degrees(degrees), "VIRTUAL");
    let columns = match axis {
        Axis::Z => Graph::identity(),
        Axis::X => {
            let pair = turn(g, 90.0);
            Graph::identity().map(|v| g.rotate_y(pair, v))
        }
        Axis::Y => {
            let pair = turn(g, -90.0);
            Graph::identity().map(|v| g.rotate_x(pair, v))
        }
    };
    Rigid { r: transpose(&columns), ..Rigid::identity() }
}
