//! What a plan answers: the task with all that belongs to it.

use crate::model::numeric::Transform;
use crate::model::{Angle, Axis, Task};

/// What a plan answers.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanTask {
    /// The task.
    pub task: Task,
    /// What is given beside the target.
    pub given: Option<Given>,
    /// The tool's axis that points, for `position_axis`.
    pub axis: Axis,
    /// The joints of the angle by their signs, and the angle at zero, for `position_angle`.
    pub angle: Option<(Vec<f64>, Angle)>,
    /// Whether the target has more equations than the arm joints.
    pub overdetermined: bool,
    /// Why an axis before this one is not the one that points, where the file names none.
    pub passed_over: Option<String>,
    /// What the arm angle of a joint vector is read from, where that is given.
    pub swivel: Option<SwivelFacts>,
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

/// What the arm angle of a joint vector is read from.
#[derive(Debug, Clone, PartialEq)]
pub struct SwivelFacts {
    /// The shoulder, with the first joint's axis as z, in the base frame.
    pub shoulder: Transform,
    /// The wrist in the frame of the link after the elbow.
    pub wrist: [f64; 3],
    /// The elbow's axis there.
    pub axis: [f64; 3],
    /// A point of it.
    pub elbow: [f64; 3],
}

impl PlanTask {
    /// A task without what only some tasks have.
    pub fn new(task: Task, given: Option<Given>) -> Self {
        PlanTask { task, given, axis: Axis::Z, angle: None, overdetermined: false, passed_over: None, swivel: None }
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
        let mut name = self.task.name().to_string();
        if self.task == Task::PositionAxis {
            name += match self.axis {
                Axis::X => ", axis x",
                Axis::Y => ", axis y",
                Axis::Z => ", axis z",
            };
        }
        match self.given {
            Some(Given::ArmAngle) => name += ", arm angle given",
            Some(Given::Joint { joint, .. }) => name += &format!(", q{} given", joint + 1),
            None => {}
        }
        name
    }
}
