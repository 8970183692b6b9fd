//! The task of the iteration that meets a target.

use denhart::Pose;
use denhart::numeric::Task;
use denhart_codegen::lower::Goal;
use denhart_dynamic::{DynamicArm, DynamicTarget};
use denhart_tools::closest::pose_of;

/// A pose that meets a target, and the components of it that count. `None` for `position_angle`, which is no task of the
/// iteration.
pub fn task(arm: &DynamicArm, target: &DynamicTarget) -> Option<(Pose<f64>, Task<f64>)> {
    let task = match target {
        DynamicTarget::Pose(_) => Task::Pose,
        DynamicTarget::Position(_) => Task::POSITION,
        DynamicTarget::PositionAxis(_) => match arm.program().inverse.as_ref().ok()?.goal {
            Goal::PositionAxis { column: 0 } => Task::PositionAxis([1.0, 0.0, 0.0]),
            Goal::PositionAxis { column: 1 } => Task::PositionAxis([0.0, 1.0, 0.0]),
            _ => Task::PositionAxis([0.0, 0.0, 1.0]),
        },
        DynamicTarget::PositionAngle(_) => return None,
        DynamicTarget::PlanarPose(_) => Task::Components([true, true, false, false, false, true]),
        DynamicTarget::PlanarPosition(_) => Task::Components([true, true, false, false, false, false]),
    };
    Some((pose_of(arm, target), task))
}
