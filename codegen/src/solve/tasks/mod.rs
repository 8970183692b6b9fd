//! The tasks: each becomes a closed chain in its own file. Here is which one an arm gets.

mod attempt;
mod choices;
mod lists;
mod lower_mobility_pose;
mod planar;
mod pose;
pub(super) mod pose_of_five;
mod position;
mod position_angle;
pub(super) mod position_axis;
mod yaw;

pub use choices::{Choice, Way, choices};

use attempt::attempt;

use super::held_joint::{self, HeldJointPlan};
use super::inverse_plan::InversePlan;
use super::loop_chain::LoopChain;
use super::margins::naming_table;
use super::plan::Plan;
use super::rank;
use super::swivel;
use super::task::Goal;
use super::unsupported::{self, Alternative, Unsupported};
use crate::model::chain::Chain;
use crate::model::geometry::{self, Geometry};
use crate::model::{Axis, Convention, InverseRequest, Model, Redundant, Task};

/// The plan for the task of the file, or for the most specific task the arm can do. A measured arm has the task of its table,
/// or none.
///
/// # Errors
/// Why there is no inverse. A table that is singular everywhere makes a measured arm nearly so.
pub fn plan(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<InversePlan, Unsupported> {
    let Some(table) = table(model) else { return plan_of(model, chain, geometry) };
    // Requests that would do for the table, or for the measured arm alone, are none.
    let goal = goal_of_the_table(&table).map_err(|unsupported| {
        let hint = "what a calibration adds is too little to move by: look at the table, measured or not".to_owned();
        let reason = format!("without `calibration` {}", unsupported.alone);
        Unsupported { hint: unsupported.hint.or(Some(hint)), ..Unsupported::new(reason) }
    })?;
    let axis = match goal {
        Goal::PositionAxis { column } => Axis::of_column(column),
        _ => model.inverse.axis,
    };
    let inverse = InverseRequest { task: Some(goal.task()), axis, ..model.inverse.clone() };
    let model = &Model { inverse, ..model.clone() };
    plan_of(model, chain, geometry).map_err(|unsupported| {
        let task = goal.task().name();
        let turns = model.calibration.as_ref().is_some_and(|calibration| calibration.turned > 0.0);
        // Tasks of fewer joints need axes that are parallel.
        let hint = (model.joints.len() < 6 && turns).then(|| {
            format!(
                "the table alone has the task `{task}`: without `alpha` in `calibration`, which turns its parallel axes, the arm \
                 has it too, off by their tilt"
            )
        });
        Unsupported { hint, ..Unsupported::new(unsupported.alone) }
    })
}

/// The task of a measured arm's table.
fn goal_of_the_table(table: &Model) -> Result<Goal, Unsupported> {
    let chain = Chain::of(table);
    let geometry = geometry::geometry(table, &chain);
    match in_stages(table, &chain, &geometry) {
        Ok(plan) => Ok(plan.task.goal),
        Err(unsupported) => held_joint::goal(table, &chain, &geometry).ok_or(unsupported),
    }
}

/// The plan for the task of the file, or for the most specific task the arm can do. Without stages, six joints, virtual ones
/// among them, are solved with one joint held.
fn plan_of(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<InversePlan, Unsupported> {
    if let Some(plan) = of_the_table(model, geometry) {
        return Ok(plan);
    }
    match in_stages(model, chain, geometry) {
        Ok(plan) => Ok(InversePlan::Stages(Box::new(plan))),
        Err(unsupported) => {
            let plan = held_joint::plan(model, chain, geometry, unsupported)?;
            let (names, off_table) = (names_of_the_table(model), off_table(model, geometry));
            Ok(InversePlan::HeldJoint(Box::new(HeldJointPlan { names, off_table, ..plan })))
        }
    }
}

/// Up to this distance from its table, relative to reach and in rad, the stages of the table alone give starts to the
/// solutions of a measured arm. The arm's own equation of degree 8 has too few digits there.
const NEAR_TABLE: f64 = 1e-9;

/// The plan of a measured arm near its table.
fn of_the_table(model: &Model, geometry: &Geometry) -> Option<InversePlan> {
    let off = off_table(model, geometry).filter(|off| *off <= held_joint::NEAR_HELD_TABLE)?;
    by_the_table(model, geometry).filter(|plan| matches!(plan, InversePlan::HeldJoint(_)) || off <= NEAR_TABLE)
}

/// Distance of a measured arm from its table, relative to reach and in rad.
fn off_table(model: &Model, geometry: &Geometry) -> Option<f64> {
    let calibration = model.calibration.as_ref()?;
    Some(calibration.turned.max(calibration.displaced / geometry.reach))
}

/// The table of a measured arm whose six joints are all solved.
fn table_of_six(model: &Model) -> Option<Model> {
    let has_all = model.joints.len() == 6 && model.inverse.redundant.is_empty();
    table(model).filter(|_| has_all)
}

/// The table of a measured arm.
fn table(model: &Model) -> Option<Model> {
    let calibration = model.calibration.as_ref()?;
    Some(Model { rows: calibration.table.clone(), calibration: None, ..model.clone() })
}

/// The plan of the table of a measured arm that is solved as it was measured, if the signs of its margins name branches.
fn names_of_the_table(model: &Model) -> Option<Box<Plan>> {
    let table = table_of_six(model)?;
    let chain = Chain::of(&table);
    let plan = in_stages(&table, &chain, &geometry::geometry(&table, &chain)).ok()?;
    naming_table(&plan).map(Box::new)
}

/// The plan of a measured arm by the equations of its table, with every solution verified on the arm that was measured.
pub fn by_the_table(model: &Model, geometry: &Geometry) -> Option<InversePlan> {
    let off = off_table(model, geometry)?;
    let table = table_of_six(model)?;
    let chain = Chain::of(&table);
    let geometry = geometry::geometry(&table, &chain);
    match in_stages(&table, &chain, &geometry) {
        Ok(mut plan) if plan.task.goal.task() == Task::Pose => {
            (plan.missed, plan.off_table) = (Some(off), Some(off));
            Some(InversePlan::Stages(Box::new(plan)))
        }
        Ok(_) => None,
        Err(unsupported) => {
            let plan = held_joint::plan_of_table(&table, &chain, &geometry, unsupported)?;
            Some(InversePlan::HeldJoint(Box::new(HeldJointPlan { off_table: Some(off), ..plan })))
        }
    }
}

/// Returns true if the plan takes a choice of the joints that are held, which takes a tenth of a second.
pub fn takes_a_choice(model: &Model, chain: &Chain, geometry: &Geometry) -> bool {
    of_the_table(model, geometry).is_none()
        && held_joint::takes_a_choice(model, chain, geometry)
        && in_stages(model, chain, geometry).is_err()
}

/// The plan in stages.
fn in_stages(model: &Model, chain: &Chain, geometry: &Geometry) -> Result<Plan, Unsupported> {
    let request = &model.inverse;
    let joints = LoopChain::new(model, chain, geometry.reach, &request.redundant);
    if request.redundant.has_arm_angle() {
        return match request.task {
            _ if !model.parameters.is_empty() => Err(Unsupported::new(
                "an arm angle needs lengths known when the code is generated, not run-time parameters",
            )),
            None | Some(Task::Pose) => swivel::plan(joints, model, chain),
            Some(_) => Err(Unsupported::new("an arm angle belongs to the task `pose`")),
        };
    }
    let failed = match request.task {
        Some(task) => match attempt(task, model, geometry, &joints) {
            Ok(plan) => return Ok(plan),
            Err(unsupported) => unsupported,
        },
        None => {
            let mut failure = None;
            for task in most_specific_first(&joints) {
                match attempt(task, model, geometry, &joints) {
                    Ok(plan) => return Ok(plan),
                    // A whole pose is more than most arms of five joints can do: what they lack is told of the next task.
                    Err(_) if task == Task::Pose && joints.loop_joints.len() == 5 => {}
                    // The file gives a joint's value, and this task takes none: what is wrong is told of the next task.
                    Err(_) if task == Task::PositionAngle && !joints.given.is_empty() => {}
                    Err(unsupported) => failure = failure.or(Some(unsupported)),
                }
            }
            failure.unwrap_or_else(|| unsupported::not_covered(model, None))
        }
    };
    let failed = spared(model, chain, geometry).unwrap_or(failed);
    // Another task would hide what is wrong with the table.
    if failed.hint.is_none()
        && let Some(hint) = other_convention(model, &joints)
    {
        return Err(Unsupported { hint: Some(hint), ..failed });
    }
    let mut alternatives = alternatives(model, chain, geometry);
    if alternatives.is_empty() && unsupported::spare(model, request.task) == 1 {
        alternatives = givable(model, chain, geometry);
    }
    alternatives.extend(lists::alternatives(model, chain, geometry));
    if alternatives.is_empty() && unsupported::is_one_more(model, request.task) {
        return Err(unsupported::none_to_spare(model, request.task));
    }
    Err(failed.or_else(alternatives))
}

/// The hint for a table that is meant for the other convention. Read by that convention, the table has an inverse for
/// the task. Or the table is singular everywhere, but not by that convention.
fn other_convention(model: &Model, own: &LoopChain) -> Option<String> {
    let convention = match model.convention {
        Convention::Standard => Convention::Modified,
        Convention::Modified => Convention::Standard,
    };
    let other = Model { convention, ..model.clone() };
    let chain = Chain::of(&other);
    let geometry = geometry::geometry(&other, &chain);
    let joints = LoopChain::new(&other, &chain, geometry.reach, &model.inverse.redundant);
    let tasks = model.inverse.task.map_or_else(|| most_specific_first(&joints), |task| vec![task]);
    let solved = tasks.into_iter().find(|task| attempt(*task, &other, &geometry, &joints).is_ok());
    let is_singular = |joints: &LoopChain| rank::check(joints, rank::ToolMotion::Pose).is_err();
    let what = match solved {
        Some(task) => format!("the table has an inverse (task {})", task.name()),
        None if is_singular(own) && !is_singular(&joints) => "the table is not singular everywhere".to_owned(),
        None => return None,
    };
    let name = match convention {
        Convention::Standard => "standard",
        Convention::Modified => "modified",
    };
    Some(format!("read as `convention: {name}` {what}: look which frames its rows belong to"))
}

/// The tasks that an arm of so many joints may have.
fn most_specific_first(joints: &LoopChain) -> Vec<Task> {
    match joints.loop_joints.len() {
        6 => vec![Task::Pose],
        5 => vec![Task::Pose, Task::PositionAxis],
        4 => vec![Task::PositionAngle, Task::Pose],
        3 if joints.is_planar() || joints.plane_normal().is_some() => vec![Task::PlanarPose],
        3 => vec![Task::Position],
        2 => vec![Task::PlanarPosition],
        _ => Vec::new(),
    }
}

/// The reason where the file gives a joint's value that its arm needs: without `redundant` there is an inverse.
fn spared(model: &Model, chain: &Chain, geometry: &Geometry) -> Option<Unsupported> {
    if model.inverse.redundant.is_empty() || model.inverse.task.is_some() {
        return None;
    }
    let joints = LoopChain::new(model, chain, geometry.reach, &Redundant::default());
    let task =
        most_specific_first(&joints).into_iter().find(|task| attempt(*task, model, geometry, &joints).is_ok())?;
    unsupported::not_to_spare(model, task).map(Unsupported::new)
}

/// The joints that leave a chain of six whose inverse holds a joint, where a value is to be given.
fn givable(model: &Model, chain: &Chain, geometry: &Geometry) -> Vec<Alternative> {
    let others = model.joints.iter().enumerate();
    let leaves = |joint: &usize| {
        let joints = LoopChain::new(model, chain, geometry.reach, &Redundant::of(&[*joint]));
        held_joint::is_covered(model, joints)
    };
    let found = others.filter(|(joint, _)| leaves(joint));
    let request = |name: &str| Alternative::new(format!("`redundant: {name}`"), model.inverse.task, Some(name));
    found.map(|(_, joint)| request(&joint.name).closed_if(false)).collect()
}

/// The tasks, or the joints to give, with which this arm has an inverse.
fn alternatives(model: &Model, chain: &Chain, geometry: &Geometry) -> Vec<Alternative> {
    let request = &model.inverse;
    let works = |task: Task, given: &Redundant| {
        let joints = LoopChain::new(model, chain, geometry.reach, given);
        attempt(task, model, geometry, &joints).is_ok()
    };
    let (none, own) = (Redundant::default(), &request.redundant);
    let tasks =
        [Task::Pose, Task::PositionAxis, Task::PositionAngle, Task::Position, Task::PlanarPose, Task::PlanarPosition];
    let name_of = |joint: usize| model.joints.get(joint).map(|joint| joint.name.as_str());
    let redundant = (!own.is_empty()).then(|| own.written(&model.joints));
    let mut found: Vec<Alternative> = tasks
        .into_iter()
        .filter(|task| Some(*task) != request.task && works(*task, own))
        .map(|task| Alternative::new(format!("`task: {}`", task.name()), Some(task), redundant.as_deref()))
        .collect();
    let working = |given: &Redundant, named: Option<Task>| {
        tasks.into_iter().find(|task| named.is_none_or(|named| named == *task) && works(*task, given))
    };
    let other = |task: Task| Some(task).filter(|task| *task != request.task.unwrap_or(Task::Pose));
    // A joint's value that need not be given at all: no other one is proposed.
    let spares = redundant.as_ref().and_then(|_| working(&none, request.task));
    let is_own = |joint: usize| *own == Redundant::of(&[joint]);
    let others = (0..model.joints.len()).filter(|joint| !is_own(*joint) && spares.is_none());
    let others: Vec<(usize, &str)> = others.filter_map(|joint| Some((joint, name_of(joint)?))).collect();
    found.extend(others.iter().filter_map(|(joint, name)| {
        let task = working(&Redundant::of(&[*joint]), request.task)?;
        Some(Alternative::new(format!("`redundant: {name}`"), Some(task), Some(name)).of(other(task)))
    }));
    // The reason names the task of an arm that needs all of its joints.
    let spared = |task| Alternative::new("leaving out `redundant`".to_owned(), Some(task), None);
    found.extend(spares.map(spared));
    let swings =
        !own.has_arm_angle() && model.parameters.is_empty() && request.task.is_none_or(|task| task == Task::Pose) && {
            let joints = LoopChain::new(model, chain, geometry.reach, &none);
            swivel::plan(joints, model, chain).is_ok()
        };
    found.extend(swings.then(|| Alternative::new("`redundant: arm_angle`".to_owned(), None, Some("arm_angle"))));
    if found.is_empty() && request.task.is_some() {
        // Another task, and a joint whose value is given: two changes, which the reason has no room for.
        found.extend(others.iter().filter_map(|(joint, name)| {
            let task = working(&Redundant::of(&[*joint]), None)?;
            Some(Alternative::new(String::new(), Some(task), Some(name)))
        }));
    }
    found
}
