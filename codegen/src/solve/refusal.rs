//! Why an arm has no inverse, in words a user can act on.

use super::task;
use crate::model::geometry::Geometry;
use crate::model::{JointKind, LengthUnit, Model, Task};

/// The reason, one sentence without a period at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The sentence.
    pub reason: String,
}

impl Refusal {
    pub(super) fn new(reason: impl Into<String>) -> Self {
        Refusal { reason: reason.into() }
    }
}

/// Whether the task and the number of joints are covered at all.
pub(super) fn applicable(model: &Model) -> Result<(), Refusal> {
    let joints = model.joints.len();
    if model.inverse.redundant.is_some() {
        return Err(Refusal::new(format!(
            "a redundant joint is not covered yet (this arm has {joints} moving joints)"
        )));
    }
    match task(model) {
        Some(Task::Pose) if joints == 6 => Ok(()),
        Some(Task::Pose) | None => Err(Refusal::new(format!(
            "so far it covers arms with six moving joints and the task `pose`; this arm has {joints} moving joints"
        ))),
        Some(task) => Err(Refusal::new(format!(
            "the task `{}` is not covered yet; so far it is `pose`, for arms with six moving joints",
            name(task)
        ))),
    }
}

fn name(task: Task) -> &'static str {
    match task {
        Task::Pose => "pose",
        Task::PositionAngle => "position_angle",
        Task::PositionAxis => "position_axis",
        Task::Position => "position",
        Task::PlanarPose => "planar_pose",
        Task::PlanarPosition => "planar_position",
    }
}

/// No triple: which three axes come closest.
pub(super) fn no_triple(model: &Model, geometry: &Geometry) -> Refusal {
    let closest = geometry.misses.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    let mut reason = "no three consecutive axes meet or are parallel".to_string();
    if let Some((first, miss)) = closest {
        let (length, unit) = readable(*miss, model.length_unit);
        reason += &format!("; closest: axes {}, {}, {} miss by {length} {unit}", first + 1, first + 2, first + 3);
    }
    let sliding = model.joints.iter().filter(|j| j.kind == JointKind::Prismatic).count();
    if sliding > 0 {
        reason += "; the three must be revolute";
    }
    Refusal::new(reason)
}

/// A length in millimeters for metric files, in the file's unit otherwise.
fn readable(length: f64, unit: LengthUnit) -> (String, &'static str) {
    let (value, unit) = match unit {
        LengthUnit::Meter => (length * 1000.0, "mm"),
        LengthUnit::Centimeter => (length * 10.0, "mm"),
        LengthUnit::Millimeter => (length, "mm"),
        LengthUnit::Inch => (length, "in"),
    };
    let text = if value >= 0.05 { format!("{value:.1}") } else { format!("{value:.2e}") };
    (text, unit)
}
