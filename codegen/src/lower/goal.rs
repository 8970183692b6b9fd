//! What the inverse is asked for, and what its equations read of that.

use crate::model::{Angle, Axis, Task};
use crate::solve::{Given, Plan};
use crate::symbolic::Input;

/// What is asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// A pose; one that is nearly a rotation stands for the nearest one.
    Pose,
    /// A point.
    Position,
    /// A point and the direction of an axis of the tool: 0 for x to 2 for z.
    PositionAxis {
        /// The axis.
        column: usize,
    },
    /// A point and the sum of the joints by their signs, plus the offset.
    PositionAngle {
        /// One for each joint, 0 for those that do not count.
        signs: Vec<f64>,
        /// The angle at zero.
        offset: Angle,
    },
    /// A pose in the base frame's xy plane.
    PlanarPose,
    /// A point there.
    PlanarPosition,
}

impl Goal {
    /// That of a plan.
    pub fn of(plan: &Plan) -> Goal {
        match plan.task.task {
            Task::Pose => Goal::Pose,
            Task::Position => Goal::Position,
            Task::PositionAxis => Goal::PositionAxis {
                column: match plan.task.axis {
                    Axis::X => 0,
                    Axis::Y => 1,
                    Axis::Z => 2,
                },
            },
            Task::PositionAngle => {
                let (signs, offset) = plan.task.angle.clone().unwrap_or((Vec::new(), Angle::ZERO));
                Goal::PositionAngle { signs, offset }
            }
            Task::PlanarPose => Goal::PlanarPose,
            Task::PlanarPosition => Goal::PlanarPosition,
        }
    }
}

/// The numbers that there are of a goal.
pub fn inputs(goal: &Goal, given: Option<Given>) -> Vec<Input> {
    let position = |count: usize| (0..count).map(Input::Position);
    let rotation = || (0..3).flat_map(|row| (0..3).map(move |column| Input::Rotation(row, column)));
    let mut all: Vec<Input> = match goal {
        Goal::Pose | Goal::PositionAxis { .. } => rotation().chain(position(3)).collect(),
        Goal::Position => position(3).collect(),
        Goal::PositionAngle { .. } => position(3).chain([Input::Angle, Input::SinAngle, Input::CosAngle]).collect(),
        Goal::PlanarPose => position(2).chain([Input::Phi, Input::SinPhi, Input::CosPhi]).collect(),
        Goal::PlanarPosition => position(2).collect(),
    };
    match given {
        Some(Given::Joint { joint, turns: true }) => {
            all.extend([Input::Given(joint), Input::SinGiven(joint), Input::CosGiven(joint)]);
        }
        Some(Given::Joint { joint, turns: false }) => all.push(Input::Given(joint)),
        Some(Given::ArmAngle) | None => {}
    }
    all
}
