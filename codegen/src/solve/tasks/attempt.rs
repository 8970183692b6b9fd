//! The plan of one task.

use super::{lower_mobility_pose, planar, pose, pose_of_five, position, position_angle, position_axis, yaw};
use crate::model::geometry::Geometry;
use crate::model::{Model, Task};
use crate::solve::loop_chain::LoopChain;
use crate::solve::plan::Plan;
use crate::solve::task::Goal;
use crate::solve::unsupported::{self, Unsupported};

/// The plan in stages of a task, for joints of which those that are given are no part.
///
/// # Errors
/// A condition of the task that the arm does not meet.
pub fn attempt(task: Task, model: &Model, geometry: &Geometry, joints: &LoopChain) -> Result<Plan, Unsupported> {
    let joints = joints.clone();
    match (task, joints.loop_joints.len()) {
        (Task::Pose, 6) => pose::plan(model, geometry, joints),
        (Task::Pose, 4 | 5) if yaw::yaws_and_pitches(&joints) => lower_mobility_pose::yawing(joints),
        (Task::Pose, 4) => lower_mobility_pose::upright(joints),
        (Task::Pose, 5) if pose_of_five::is_asked(model, &joints) => pose_of_five::plan(joints),
        (Task::Position, 3) => position::plan(joints),
        (Task::PositionAxis, 5) => position_axis::plan(model.inverse.axis, joints),
        (Task::PositionAngle, 4) => position_angle::plan(joints),
        (Task::PlanarPose, 3) => planar::plan(Goal::PlanarPose, model, joints),
        (Task::PlanarPosition, 2) => planar::plan(Goal::PlanarPosition, model, joints),
        _ => Err(unsupported::not_covered(model, Some(task))),
    }
}
