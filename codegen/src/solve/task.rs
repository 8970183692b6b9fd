//! Tasks of plans, with all that belongs to them.

use crate::model::numeric::Transform;
use crate::model::{Angle, Joint, JointKind, Redundant, RedundantValue, Task};
use crate::symbolic::{AngleSum, Input, Part};

/// Task of a plan, with all that belongs to it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanTask {
    /// The task, with its numbers.
    pub goal: Goal,
    /// Values given beside the target.
    pub given: GivenValues,
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

/// Values given beside the target, in the order of the call.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct GivenValues {
    /// The values.
    pub values: Vec<Given>,
    /// True where the call takes an array of them, also of one.
    pub is_list: bool,
}

impl GivenValues {
    /// The values that a file names, of joints that turn or slide.
    pub fn of(redundant: &Redundant, joints: &[Joint]) -> Self {
        let value = |value: &RedundantValue| match value {
            RedundantValue::ArmAngle => Given::ArmAngle,
            RedundantValue::Joint(joint) => {
                let slides = joints.get(*joint).is_some_and(|checked| checked.kind == JointKind::Prismatic);
                Given::Joint { joint: *joint, revolute: !slides }
            }
        };
        GivenValues { values: redundant.values.iter().map(value).collect(), is_list: redundant.is_list }
    }

    /// Returns true if nothing is given.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The joints whose values are given, from 0, each with true if it turns.
    pub fn joints(&self) -> impl Iterator<Item = (usize, bool)> {
        self.values.iter().filter_map(|given| match given {
            Given::Joint { joint, revolute } => Some((*joint, *revolute)),
            Given::ArmAngle => None,
        })
    }

    /// Returns true if the value of this joint is given.
    pub fn holds(&self, joint: usize) -> bool {
        self.joints().any(|(given, _)| given == joint)
    }
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
    /// The first of the seven joints, from 0.
    pub first: usize,
    /// The shoulder, with the first joint's axis as z: in the frame of the link before that joint, else in the base frame.
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
    pub fn new(goal: Goal, given: GivenValues) -> Self {
        PlanTask { goal, given, overdetermined: false, passed_over: None, swivel: None }
    }

    /// The task as the file writes it, with what belongs to it.
    pub fn name(&self) -> String {
        let mut name = self.goal.task().name().to_string();
        if let Goal::PositionAxis { column } = self.goal {
            let axis = ["x", "y", "z"].get(column).copied().unwrap_or_default();
            name += &format!(", axis {axis}");
        }
        for given in &self.given.values {
            name += &match given {
                Given::ArmAngle => ", arm angle".to_owned(),
                Given::Joint { joint, .. } => format!(", q{}", joint + 1),
            };
        }
        if !self.given.is_empty() {
            name += " given";
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
        for (joint, revolute) in self.given.joints() {
            let parts: &[Part] = if revolute { &[Part::Value, Part::Sin, Part::Cos] } else { &[Part::Value] };
            all.extend(parts.iter().map(|part| Input::given(joint, *part)));
        }
        all
    }
}
