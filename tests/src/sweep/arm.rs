//! The parts of an evaluated arm that its judge needs, as the generator read them from the file.

use denhart::{Chain, Convention, DhFrame, DhRow, JointKind};
use denhart_codegen::lower::{Given, Goal, Inverse};
use denhart_codegen::model::{self, Frame, Model, RowKind};
use denhart_dynamic::DynamicArm;

use crate::inverse::Evaluated;
use crate::subject::{Subject, length};
use crate::task::{self, Kind, Task};

/// The chain of a model, every parameter at the value of the file.
pub fn chain(model: &Model) -> (Chain, [DhFrame; 2]) {
    let convention = match model.convention {
        model::Convention::Standard => Convention::Standard,
        model::Convention::Modified => Convention::Modified,
    };
    let rows: Vec<DhRow> = model.rows.iter().map(row).collect();
    let frames = [frame(&model.base), frame(&model.tool)];
    (Chain::new(convention, &rows).with_base(frames[0]).with_tool(frames[1]), frames)
}

/// The chain of the table, without a calibration.
pub fn table(model: &Model) -> Chain {
    let rows = model.calibration.as_ref().map_or(&model.rows, |calibration| &calibration.table);
    chain(&Model { rows: rows.clone(), ..model.clone() }).0
}

fn row(row: &model::Row) -> DhRow {
    let kind = match row.kind {
        RowKind::Revolute => JointKind::Revolute,
        RowKind::Prismatic => JointKind::Prismatic,
        RowKind::Fixed => JointKind::Fixed,
    };
    let (a, d) = (row.a.default_value(), row.d.default_value());
    DhRow { kind, a, alpha: row.alpha.rad(), d, theta: row.theta.rad() }
}

fn frame(frame: &Frame) -> DhFrame {
    let xyz = frame.xyz.each_ref().map(model::Length::default_value);
    DhFrame { xyz, rpy: frame.rpy.each_ref().map(model::Angle::rad) }
}

/// The length that tolerances are relative to.
pub fn reach(arm: &DynamicArm) -> f64 {
    let (chain, [base, tool]) = chain(arm.model());
    length(chain.rows(), [&base, &tool], arm.limits())
}

/// Kind of the task of an arm's inverse; `None` without an inverse.
pub fn kind(arm: &DynamicArm) -> Option<Kind> {
    Some(match &inverse(arm)?.goal {
        Goal::Pose => Kind::Pose,
        Goal::Position => Kind::Position,
        Goal::PositionAxis { column } => Kind::PositionAxis(*column),
        Goal::PositionAngle { .. } => Kind::PositionAngle,
        Goal::PlanarPose => Kind::PlanarPose,
        Goal::PlanarPosition => Kind::PlanarPosition,
    })
}

/// The program of an inverse that can be evaluated.
fn inverse(arm: &DynamicArm) -> Option<&Inverse> {
    arm.program().inverse.as_ref().ok().filter(|_| arm.task().is_ok())
}

/// The task of an arm whose values beside the target are those of joints, if any.
pub fn task(arm: &DynamicArm) -> Option<Task> {
    let (kind, inverse) = (kind(arm)?, inverse(arm)?);
    let task = Task { holds_a_joint: inverse.held_joint.is_some(), ..Task::new(kind) };
    let joint = |given: &Given| match given {
        Given::Joint { joint, .. } => Some(*joint),
        Given::ArmAngle => None,
    };
    let joints: Option<Vec<usize>> = inverse.given.values.iter().map(joint).collect();
    Some(Task { given: task::Given::of(joints?, 0), ..task })
}

/// The arm under test, and its inverse to be asked for what is no joint vector's pose; `None` without an inverse.
pub fn subject<const N: usize>(text: &str, arm: &DynamicArm) -> Option<(Subject<N>, Evaluated)> {
    let task = task(arm)?;
    let inverse = || Evaluated::new(DynamicArm::from_yaml(text).ok()?, task.kind).ok();
    let limits = arm.limits().try_into().ok()?;
    let (chain, _) = chain(arm.model());
    let subject =
        Subject::of(&arm.model().name, chain, reach(arm), limits, task, arm.max_solutions().ok()?, inverse()?);
    Some((subject, inverse()?))
}
