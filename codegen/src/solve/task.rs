//! Tasks of plans, with all that belongs to them.

use crate::model::numeric::Transform;
use crate::model::{Angle, Task};
use crate::symbolic::{AngleSum, Input, Part};

/// Task of a plan, with all that belongs to it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanTask {
    /// The task, with its numbers.
    pub goal: Goal,
    /// Value given beside the target.
    pub given: Option<Given>,
    /// True if the target has more equations than the arm has joints.
    pub overdetermined: bool,
    /// Why an axis before this one is not the one that points, where the file names none.
    pub passed_over: Option<String>,
    /// Constants for the arm angle of a joint vector, where the arm angle is given.
    pub swivel: Option<SwivelConstants>,
}

/// Task, joints, capacity and reach.
#[derive(Debug, Clone, Copy)]
pub struct Outline<'a> {
    /// The task, with what is given beside the target.
    pub task: &'a PlanTask,
    /// The number of the arm's joints.
    pub joints: usize,
    /// The largest number of solutions.
    pub capacity: usize,
    /// Reach of the arm, length unit.
    pub reach: f64,
}

/// A task with its numbers.
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

/// Value given beside the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// The value of a joint, from 0.
    Joint {
        /// The joint.
        joint: usize,
        /// True for a revolute joint, whose sine and cosine are read.
        revolute: bool,
    },
    /// The arm angle, whose sine and cosine the upper arm's rotation is made from.
    ArmAngle,
}

/// Constants for the arm angle of a joint vector.
#[derive(Debug, Clone, PartialEq)]
pub struct SwivelConstants {
    /// The shoulder, with the first joint's axis as z, in the base frame.
    pub shoulder: Transform,
    /// The wrist in the frame of the link after the elbow.
    pub wrist: [f64; 3],
    /// The elbow's axis there.
    pub axis: [f64; 3],
    /// A point of it.
    pub elbow: [f64; 3],
}

impl Goal {
    /// The task as the file names it.
    pub fn task(&self) -> Task {
        match self {
            Goal::Pose => Task::Pose,
            Goal::Position => Task::Position,
            Goal::PositionAxis { .. } => Task::PositionAxis,
            Goal::PositionAngle { .. } => Task::PositionAngle,
            Goal::PlanarPose => Task::PlanarPose,
            Goal::PlanarPosition => Task::PlanarPosition,
        }
    }

    /// The angle of `position_angle` as a sum of joints; `None` for the other tasks.
    pub fn angle_sum(&self) -> Option<AngleSum> {
        let Goal::PositionAngle { signs, offset } = self else { return None };
        let turns = signs.iter().enumerate().filter(|(_, sign)| **sign != 0.0);
        Some(AngleSum { terms: turns.map(|(joint, sign)| (joint, *sign < 0.0)).collect(), constant: *offset })
    }
}

impl PlanTask {
    /// A task without what only some plans have.
    pub fn new(goal: Goal, given: Option<Given>) -> Self {
        PlanTask { goal, given, overdetermined: false, passed_over: None, swivel: None }
    }

    /// The joint whose value is given, from 0.
    pub fn given_joint(&self) -> Option<usize> {
        match self.given {
            Some(Given::Joint { joint, .. }) => Some(joint),
            Some(Given::ArmAngle) | None => None,
        }
    }

    /// The task as the file writes it, with what belongs to it.
    pub fn name(&self) -> String {
        let mut name = self.goal.task().name().to_string();
        if let Goal::PositionAxis { column } = self.goal {
            let axis = ["x", "y", "z"].get(column).copied().unwrap_or_default();
            name += &format!(", axis {axis}");
        }
        match self.given {
            Some(Given::ArmAngle) => name += ", arm angle given",
            Some(Given::Joint { joint, .. }) => name += &format!(", q{} given", joint + 1),
            None => {}
        }
        name
    }

    /// The numbers that there are of the target and of what is given.
    pub fn inputs(&self) -> Vec<Input> {
        let rotation = || Input::ROTATION.into_iter().flatten();
        let position = |count: usize| Input::POSITION.into_iter().take(count);
        let mut all: Vec<Input> = match self.goal {
            Goal::Pose | Goal::PositionAxis { .. } => rotation().chain(position(3)).collect(),
            Goal::Position => position(3).collect(),
            Goal::PositionAngle { .. } => position(3).chain([Input::Angle, Input::SinAngle, Input::CosAngle]).collect(),
            Goal::PlanarPose => position(2).chain([Input::Phi, Input::SinPhi, Input::CosPhi]).collect(),
            Goal::PlanarPosition => position(2).collect(),
        };
        if let Some(Given::Joint { joint, revolute }) = self.given {
            let parts: &[Part] = if revolute { &[Part::Value, Part::Sin, Part::Cos] } else { &[Part::Value] };
            all.extend(parts.iter().map(|part| Input::given(joint, *part)));
        }
        all
    }
}
