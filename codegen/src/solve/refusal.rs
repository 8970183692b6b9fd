//! Why an arm has no inverse, in words a user can act on.

use crate::model::geometry::Geometry;
use crate::model::{LengthUnit, Model, Task};

/// The reason, one sentence without a period at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The sentence.
    pub reason: String,
}

impl Refusal {
    /// The same with what would work instead.
    pub(super) fn or_else(self, alternatives: Vec<String>) -> Self {
        match alternatives.as_slice() {
            [] => self,
            [one] => Refusal::new(format!("{}; {one} works", self.reason)),
            [rest @ .., last] => Refusal::new(format!("{}; {} or {last} work", self.reason, rest.join(", "))),
        }
    }

    pub(super) fn new(reason: impl Into<String>) -> Self {
        Refusal { reason: reason.into() }
    }
}

/// How many joints a task needs; without one, a pose.
fn needs(task: Option<Task>) -> usize {
    match task {
        Some(Task::Pose) | None => 6,
        Some(Task::PositionAxis) => 5,
        Some(Task::PositionAngle) => 4,
        Some(Task::Position | Task::PlanarPose) => 3,
        Some(Task::PlanarPosition) => 2,
    }
}

/// Whether the arm has one joint more than its task needs, and the file does not name it.
pub(super) fn is_one_more(model: &Model, task: Option<Task>) -> bool {
    model.joints.len() == needs(task) + 1 && model.inverse.redundant.is_none()
}

/// One joint more than the task needs, and none whose value could be given.
pub(super) fn none_to_spare(model: &Model, task: Option<Task>) -> Refusal {
    let (joints, name) = (model.joints.len(), task.unwrap_or(Task::Pose).name());
    Refusal::new(format!(
        "{joints} moving joints are one more than the task `{name}` needs, and whichever value is given, the other axes \
         have no three in a row that meet or are parallel"
    ))
}

/// A task that is not covered for this number of joints.
pub(super) fn not_covered(model: &Model, task: Option<Task>) -> Refusal {
    let joints = model.joints.len();
    let plural = if joints == 1 { "" } else { "s" };
    let name = task.unwrap_or(Task::Pose).name();
    Refusal::new(match task {
        _ if is_one_more(model, task) => {
            format!(
                "{joints} moving joints are one more than the task `{name}` needs: name the one whose value is given"
            )
        }
        Some(task) => format!("the task `{}` is not covered for {joints} moving joint{plural}", task.name()),
        None => format!("no task fits {joints} moving joint{plural}"),
    })
}

/// No triple: which three axes come closest.
pub(super) fn no_triple(model: &Model, geometry: &Geometry) -> Refusal {
    let closest = geometry.misses.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    let mut reason = "no three consecutive axes meet or are parallel".to_string();
    if let Some((first, miss)) = closest {
        let (length, unit) = readable(*miss, model.length_unit);
        reason += &format!("; closest: axes {}, {}, {} miss by {length} {unit}", first + 1, first + 2, first + 3);
    }
    if !model.parameters.is_empty() {
        let names: Vec<&str> = model.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        reason += &format!("; run-time parameters ({}) may have any value", names.join(", "));
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
