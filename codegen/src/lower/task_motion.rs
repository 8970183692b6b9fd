//! The part of the tool's motion that the task counts, for the manipulability.

use crate::model::{Axis, Model, Task};
use crate::solve::Goal;

/// The part of the tool's motion that the arm's task counts.
#[derive(Debug, Clone, PartialEq)]
pub enum TaskMotion {
    /// All six rows of the Jacobian.
    All,
    /// Some of the rows `vx vy vz wx wy wz`, and their names.
    Rows([bool; 6], &'static str),
    /// The point, and the turns across the tool's axis with this column.
    Axis(usize),
    /// The point, and the sum of the joints by these signs.
    Angle(Vec<f64>),
}

/// The part counted by the task of the arm's inverse, else by the task that its file names.
pub fn task_motion(model: &Model, goal: Option<&Goal>) -> TaskMotion {
    match (goal, goal.map(Goal::task).or(model.inverse.task)) {
        (_, Some(Task::Position)) => {
            TaskMotion::Rows([true, true, true, false, false, false], "`vx vy vz` of the Jacobian")
        }
        (_, Some(Task::PlanarPosition)) => {
            TaskMotion::Rows([true, true, false, false, false, false], "`vx vy` of the Jacobian")
        }
        (_, Some(Task::PlanarPose)) => {
            TaskMotion::Rows([true, true, false, false, false, true], "`vx vy wz` of the Jacobian")
        }
        (Some(Goal::PositionAxis { column }), _) => TaskMotion::Axis(*column),
        (_, Some(Task::PositionAxis)) => TaskMotion::Axis(model.inverse.axis.unwrap_or(Axis::Z).column()),
        (Some(Goal::PositionAngle { signs, .. }), _) => TaskMotion::Angle(signs.clone()),
        // Without an inverse the signs are not known.
        (_, Some(Task::PositionAngle | Task::Pose) | None) => TaskMotion::All,
    }
}
