//! What the inverse is asked for, and what its equations read of that.

use crate::model::{Angle, Axis, Task};
use crate::solve::Plan;

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

/// What is given beside the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// The value of a joint, from 0.
    Joint {
        /// The joint.
        joint: usize,
        /// Whether it turns: then its sine and cosine are read.
        turns: bool,
    },
    /// The arm angle, whose sine and cosine the upper arm's rotation is made from.
    ArmAngle,
}

impl Given {
    /// That of a plan.
    pub fn of(plan: &Plan) -> Option<Given> {
        if plan.task.swivel.is_some() {
            return Some(Given::ArmAngle);
        }
        plan.task.locked.as_ref().map(|locked| Given::Joint { joint: locked.joint, turns: locked.turns })
    }
}

/// A number of the target, or of what is given beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// Entry of the rotation: row, column, from 0.
    Rotation(usize, usize),
    /// Component of the position.
    Position(usize),
    /// The angle in the arm's plane, rad.
    Angle,
    /// Its sine.
    SinAngle,
    /// Its cosine.
    CosAngle,
    /// The direction in the base's plane, rad.
    Phi,
    /// Its sine.
    SinPhi,
    /// Its cosine.
    CosPhi,
    /// The value of the given joint, from 0.
    Given(usize),
    /// Its sine.
    SinGiven(usize),
    /// Its cosine.
    CosGiven(usize),
}

impl Input {
    /// The name of its leaf in the plan's graph.
    pub fn name(self) -> String {
        match self {
            Input::Rotation(row, column) => format!("r{}{}", row + 1, column + 1),
            Input::Position(component) => ["px", "py", "pz"].get(component).copied().unwrap_or_default().to_string(),
            Input::Angle => "angle".into(),
            Input::SinAngle => "sin_angle".into(),
            Input::CosAngle => "cos_angle".into(),
            Input::Phi => "phi".into(),
            Input::SinPhi => "sin_phi".into(),
            Input::CosPhi => "cos_phi".into(),
            Input::Given(joint) => format!("q{}", joint + 1),
            Input::SinGiven(joint) => format!("s{}", joint + 1),
            Input::CosGiven(joint) => format!("c{}", joint + 1),
        }
    }

    /// The numbers that there are of a goal.
    pub fn all(goal: &Goal, given: Option<Given>) -> Vec<Input> {
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
}
