//! Tasks as closed chains of six joints.

use super::asked::PlanTask;
use super::plan::Plan;
use super::problem::{Problem, Slot};
use super::{Refusal, cheapest, few, rank, refusal, solve, swivel};
use crate::model::chain::Chain;
use crate::model::geometry::{self, Geometry, Triple, TripleKind};
use crate::model::{Angle, Axis, Convention, Model, Task};
use crate::symbolic::{Graph, Rigid, transpose};

/// The plan for what the file asks, or for the most specific task the arm can do.
pub fn plan(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<Plan, Refusal> {
    let request = &model.inverse;
    let problem = Problem::new(model, chain, geometry.reach, request.redundant);
    if request.arm_angle {
        let task = plan_task(Task::Pose, &problem);
        return match request.task {
            _ if !model.parameters.is_empty() => Err(Refusal::new(
                "an arm angle needs lengths known when the code is generated, not run-time parameters",
            )),
            None | Some(Task::Pose) => swivel::plan(problem, chain, task),
            Some(_) => Err(Refusal::new("an arm angle belongs to the task `pose`")),
        };
    }
    let failed = match request.task {
        Some(task) => match attempt(task, model, geometry, &problem) {
            Ok(plan) => return Ok(plan),
            Err(refusal) => refusal,
        },
        None => {
            let mut failure = None;
            for task in most_specific_first(&problem) {
                match attempt(task, model, geometry, &problem) {
                    Ok(plan) => return Ok(plan),
                    // A whole pose is more than most arms of five joints can do: what they lack is told of the next task.
                    Err(_) if task == Task::Pose && problem.slots.len() == 5 => {}
                    Err(refusal) => failure = failure.or(Some(refusal)),
                }
            }
            failure.unwrap_or_else(|| refusal::not_covered(model, None))
        }
    };
    // Another task would hide what is wrong with the table.
    if let Some(hint) = other_convention(model) {
        return Err(Refusal { hint: Some(hint), ..failed });
    }
    let alternatives = alternatives(model, chain, geometry);
    if alternatives.is_empty() && refusal::is_one_more(model, request.task) {
        return Err(refusal::none_to_spare(model, request.task));
    }
    Err(failed.or_else(alternatives))
}

/// What to look at in a table that has what is asked for if its rows are read by the other convention.
fn other_convention(model: &Model) -> Option<String> {
    let convention = match model.convention {
        Convention::Standard => Convention::Modified,
        Convention::Modified => Convention::Standard,
    };
    let other = Model { convention, ..model.clone() };
    let chain = Chain::of(&other);
    let geometry = geometry::geometry(&other, &chain);
    let problem = Problem::new(&other, &chain, geometry.reach, model.inverse.redundant);
    let tasks = model.inverse.task.map_or_else(|| most_specific_first(&problem), |task| vec![task]);
    let solved = tasks.into_iter().find(|task| attempt(*task, &other, &geometry, &problem).is_ok())?;
    let name = match convention {
        Convention::Standard => "standard",
        Convention::Modified => "modified",
    };
    Some(format!(
        "read as `convention: {name}` the table has an inverse (task {}): look which frames its rows belong to",
        solved.name()
    ))
}

/// The tasks that an arm of so many joints may have.
fn most_specific_first(problem: &Problem) -> Vec<Task> {
    match problem.slots.len() {
        6 => vec![Task::Pose],
        5 => vec![Task::Pose, Task::PositionAxis],
        4 => vec![Task::PositionAngle, Task::Pose],
        3 if problem.is_planar() => vec![Task::PlanarPose],
        3 => vec![Task::Position],
        2 => vec![Task::PlanarPosition],
        _ => Vec::new(),
    }
}

fn attempt(task: Task, model: &Model, geometry: &Geometry, problem: &Problem) -> Result<Plan, Refusal> {
    let asked = plan_task(task, problem);
    let problem = problem.clone();
    match (task, problem.slots.len()) {
        (Task::Pose, 6) => pose(model, geometry, problem),
        (Task::Pose, 4 | 5) if few::yaws_and_pitches(&problem) => {
            rank::check(&problem, rank::Asked::Pose)?;
            few::yawing_pose(problem, asked)
        }
        (Task::Pose, 4) => few::upright_pose(stroke_last(problem)?, asked),
        (Task::Position, 3) => position(problem),
        (Task::PositionAxis, 5) => position_axis(model.inverse.axis, problem),
        (Task::PositionAngle, 4) if problem.locked.is_some() => Err(Refusal::new(
            "the task `position_angle` takes no joint's value: the angle of the plane is the sum of all of them",
        )),
        (Task::PositionAngle, 4) if few::yaws_a_plane(&problem) => {
            rank::check(&problem, rank::Asked::Pose)?;
            few::position_angle(problem, asked)
        }
        (Task::PositionAngle, 4) => Err(Refusal::new(
            "the task `position_angle` needs a joint that yaws, and three that move in a plane which it turns",
        )),
        (Task::PlanarPose, 3) => {
            rank::check(&problem, rank::Asked::Pose)?;
            few::in_plane(problem, asked)
        }
        (Task::PlanarPosition, 2) => {
            rank::check(&problem, rank::Asked::Point)?;
            few::in_plane(problem, asked)
        }
        _ => Err(refusal::not_covered(model, Some(task))),
    }
}

/// The tasks, or the joints to give, with which this arm has an inverse.
fn alternatives(model: &Model, chain: &Chain, geometry: &Geometry) -> Vec<String> {
    let works = |task: Task, given: Option<usize>| {
        let problem = Problem::new(model, chain, geometry.reach, given);
        attempt(task, model, geometry, &problem).is_ok()
    };
    let request = &model.inverse;
    let tasks =
        [Task::Pose, Task::PositionAxis, Task::PositionAngle, Task::Position, Task::PlanarPose, Task::PlanarPosition];
    let mut found: Vec<String> = tasks
        .into_iter()
        .filter(|task| Some(*task) != request.task && works(*task, request.redundant))
        .map(|task| format!("`task: {}`", task.name()))
        .collect();
    let given: Vec<String> = (0..model.joints.len())
        .filter(|joint| Some(*joint) != request.redundant)
        .filter(|joint| {
            tasks.into_iter().any(|task| request.task.is_none_or(|asked| asked == task) && works(task, Some(*joint)))
        })
        .filter_map(|joint| model.joints.get(joint))
        .map(|joint| format!("`redundant: {}`", joint.name))
        .collect();
    found.extend(given);
    let swings =
        !request.arm_angle && model.parameters.is_empty() && request.task.is_none_or(|task| task == Task::Pose) && {
            let problem = Problem::new(model, chain, geometry.reach, None);
            let task = plan_task(Task::Pose, &problem);
            swivel::plan(problem, chain, task).is_ok()
        };
    found.extend(swings.then(|| "`redundant: arm_angle`".to_string()));
    found
}

/// An arm whose tool moves in space and turns about one direction, with the stroke along it moved behind the others.
fn stroke_last(mut problem: Problem) -> Result<Problem, Refusal> {
    let refused = || {
        Refusal::new(
            "four joints have `pose` if all turn about and slide along or across one direction, or yaw and pitch thrice",
        )
    };
    let stroke = problem.stroke_along_turns().ok_or_else(refused)?;
    rank::check(&problem, rank::Asked::Pose)?;
    for i in stroke..3 {
        problem = problem.slide_later(i).ok_or_else(refused)?;
    }
    Ok(problem)
}

fn plan_task(task: Task, problem: &Problem) -> PlanTask {
    let locked = problem.locked.clone();
    PlanTask { task, locked, axis: Axis::Z, angle: None, overdetermined: false, passed_over: None, swivel: None }
}

fn pose(model: &Model, geometry: &Geometry, problem: Problem) -> Result<Plan, Refusal> {
    let task = plan_task(Task::Pose, &problem);
    cheapest(&problem, &task)?.ok_or_else(|| refusal::no_triple(model, geometry))
}

/// A point alone: three virtual joints about it, of which none is wanted.
fn position(mut problem: Problem) -> Result<Plan, Refusal> {
    rank::check(&problem, rank::Asked::Point)?;
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
    let mut failure: Option<Refusal> = None;
    for axis in wanted {
        let mut problem = problem.clone();
        let passed_over = failure.as_ref().map(|refusal| format!("axis z cannot be asked for: {}", refusal.reason));
        let task = PlanTask { axis, passed_over, ..plan_task(Task::PositionAxis, &problem) };
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
