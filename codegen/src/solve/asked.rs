//! What a plan answers.

use super::problem::Locked;
use crate::model::numeric::Transform;
use crate::model::{Angle, Axis, Task};

/// What a plan answers.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanTask {
    /// The task.
    pub task: Task,
    /// The joint whose value is given.
    pub locked: Option<Locked>,
    /// The tool's axis that points, for `position_axis`.
    pub axis: Axis,
    /// The joints of the angle by their signs, and the angle at zero, for `position_angle`.
    pub angle: Option<(Vec<f64>, Angle)>,
    /// Whether the target has more equations than the arm joints.
    pub overdetermined: bool,
    /// Why an axis before this one is not the one that points, where the file names none.
    pub passed_over: Option<String>,
    /// The arm angle is given.
    pub swivel: Option<SwivelFacts>,
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
        if self.swivel.is_some() {
            name += ", arm angle given";
        }
        if let Some(locked) = &self.locked {
            name += &format!(", q{} given", locked.joint + 1);
        }
        name
    }
}
