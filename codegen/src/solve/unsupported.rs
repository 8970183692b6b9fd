//! Why an arm has no inverse, in words a user can act on.

use crate::model::geometry::Geometry;
use crate::model::numeric::{cross, length};
use crate::model::{JointKind, Model, Task};

/// The reason, one sentence without a period at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsupported {
    /// The sentence.
    pub reason: String,
    /// Advice on an entry of the file that is probably meant otherwise.
    pub hint: Option<String>,
    /// Requests that have an inverse, as the file writes them: `inverse: {task: position}`.
    pub instead: Vec<String>,
}

/// A request for which the arm has an inverse.
pub(super) struct Alternative {
    /// Difference from the request of the file; empty if that is not a part of the reason.
    words: String,
    /// The request as the file writes it.
    written: String,
}

impl Alternative {
    pub(super) fn new(words: String, task: Option<Task>, redundant: Option<&str>) -> Self {
        let task = task.map(|task| format!("task: {}", task.name()));
        let redundant = redundant.map(|name| format!("redundant: {name}"));
        let keys: Vec<String> = task.into_iter().chain(redundant).collect();
        Alternative { words, written: format!("inverse: {{{}}}", keys.join(", ")) }
    }
}

impl Unsupported {
    /// Adds the requests that would work instead.
    pub(super) fn or_else(self, alternatives: Vec<Alternative>) -> Self {
        let (words, instead): (Vec<String>, Vec<String>) =
            alternatives.into_iter().map(|Alternative { words, written }| (words, written)).unzip();
        let words: Vec<String> = words.into_iter().filter(|words| !words.is_empty()).collect();
        let reason = match words.as_slice() {
            [] => self.reason,
            [one] => format!("{}; {one} works", self.reason),
            [rest @ .., last] => format!("{}; {} or {last} work", self.reason, rest.join(", ")),
        };
        Unsupported { instead, ..Unsupported::new(reason) }
    }

    pub(super) fn new(reason: impl Into<String>) -> Self {
        Unsupported { reason: reason.into(), hint: None, instead: Vec::new() }
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

/// Returns true if the arm has one joint more than its task needs, and the file does not name that joint.
pub(super) fn is_one_more(model: &Model, task: Option<Task>) -> bool {
    // The angle of `position_angle` is the sum of all joints but one: none of them can be given.
    let takes_one = task != Some(Task::PositionAngle);
    takes_one && model.joints.len() == needs(task) + 1 && model.inverse.redundant.is_none()
}

/// One joint more than the task needs, and none whose value could be given.
pub(super) fn none_to_spare(model: &Model, task: Option<Task>) -> Unsupported {
    let (joints, name) = (model.joints.len(), task.unwrap_or(Task::Pose).name());
    Unsupported::new(format!(
        "{joints} moving joints are one more than the task `{name}` needs, and whichever value is given, the other axes \
         have no three in a row that meet or are parallel"
    ))
}

/// Why the value of no joint can be given: the task needs all of them.
pub(super) fn not_to_spare(model: &Model, task: Task) -> Option<String> {
    let given = model.joints.get(model.inverse.redundant?)?;
    let left = model.joints.len().checked_sub(1)?;
    // Some arms of four and five joints have a pose too: those with a joint more are told what theirs lacks.
    let is_fewer = left + 1 == needs(Some(task)) || (task != Task::Pose && left < needs(Some(task)));
    let name = task.name();
    is_fewer.then(|| format!("`redundant: {}` leaves {}, fewer than `{name}` needs", given.name, counted(left, "")))
}

/// `5 moving joints`, `1 moving joint`.
fn counted(joints: usize, which: &str) -> String {
    format!("{joints} {which}joint{}", if joints == 1 { "" } else { "s" })
}

/// A task that is not covered for this number of joints.
pub(super) fn not_covered(model: &Model, task: Option<Task>) -> Unsupported {
    if let Some(reason) = task.and_then(|task| not_to_spare(model, task)) {
        return Unsupported::new(reason);
    }
    let joints = model.joints.len();
    let name = task.unwrap_or(Task::Pose).name();
    let moving = match model.inverse.redundant.and_then(|given| model.joints.get(given)) {
        Some(given) => {
            let left = counted(joints.saturating_sub(1), "moving ");
            format!("the {left} that `redundant: {}` leaves", given.name)
        }
        None => counted(joints, "moving "),
    };
    Unsupported::new(match task {
        _ if is_one_more(model, task) => {
            format!(
                "{joints} moving joints are one more than the task `{name}` needs: name the one whose value is given"
            )
        }
        Some(_) => format!("the task `{name}` is not covered for {moving}"),
        None => format!("no task fits {moving}"),
    })
}

/// No triple: which three axes come closest.
pub(super) fn no_triple(model: &Model, geometry: &Geometry) -> Unsupported {
    let closest = geometry.misses.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    let mut reason = "no three consecutive axes meet or are parallel".to_string();
    let named = |first: usize| format!("axes {}, {}, {}", first + 1, first + 2, first + 3);
    let nearly = nearly_parallel(model, geometry);
    match (nearly, closest) {
        (Some((first, angle)), _) => {
            reason += &format!("; {} are parallel but for {} deg", named(first), rounded(angle.to_degrees()));
        }
        (None, Some((first, miss))) => {
            let unit = model.length_unit.symbol();
            reason += &format!("; closest: {} miss by {} {unit}", named(*first), rounded(*miss));
        }
        (None, None) => {}
    }
    if !model.parameters.is_empty() {
        let names: Vec<&str> = model.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        reason += &format!("; run-time parameters ({}) may have any value", names.join(", "));
    }
    Unsupported::new(reason)
}

/// Axes that are off by less than this, rad, were meant to be parallel.
const NEARLY: f64 = 0.02;

/// Three revolute joints in a row whose axes are nearly parallel: the first of them, and the largest angle between two
/// neighbors, rad.
fn nearly_parallel(model: &Model, geometry: &Geometry) -> Option<(usize, f64)> {
    let turns = |first: usize| model.joints.iter().skip(first).take(3).all(|joint| joint.kind == JointKind::Revolute);
    let triples = geometry.axes.windows(3).enumerate().filter(|(first, _)| turns(*first));
    let angles = triples.filter_map(|(first, axes)| {
        let [a, b, c] = axes else { return None };
        let sine = |u: [f64; 3], v: [f64; 3]| length(cross(u, v));
        let most = sine(a.direction, b.direction).max(sine(b.direction, c.direction));
        (most < NEARLY).then(|| (first, most.asin()))
    });
    angles.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Three significant digits, without zeros at the end of the decimals.
fn rounded(value: f64) -> String {
    let digits = 2 - value.abs().log10().floor().clamp(-12.0, 2.0) as i32;
    let text = format!("{value:.*}", usize::try_from(digits).unwrap_or(0));
    match value.abs() < 1e-4 {
        true => format!("{value:.1e}"),
        false if text.contains('.') => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn three_digits() {
        let texts = [0.3, 57.04, 0.0758, 150.0, 1000.0, 0.02, 1.5e-7].map(rounded);
        assert_eq!(texts, ["0.3", "57", "0.0758", "150", "1000", "0.02", "1.5e-7"]);
    }
}
