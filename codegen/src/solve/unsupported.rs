//! Why an arm has no inverse, in words a user can act on.

use crate::model::geometry::Geometry;
use crate::model::numeric::{cross, length};
use crate::model::{JointKind, Model, Task, in_words};

/// The reason, one sentence without a period at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsupported {
    /// The sentence.
    pub reason: String,
    /// Advice on an entry of the file that is probably meant otherwise.
    pub hint: Option<String>,
    /// The reason without the requests that have an inverse.
    pub alone: String,
    /// Requests that have an inverse, as the file writes them: `inverse: {task: position}`.
    pub instead: Vec<String>,
    /// Requests that have an inverse in closed form.
    pub closed: Vec<String>,
}

/// A request for which the arm has an inverse.
pub(super) struct Alternative {
    /// The change to the request of the file; empty if that is not a part of the reason.
    words: String,
    /// The task, where the words do not tell it and the file asks for another.
    of: Option<Task>,
    /// The request as the file writes it.
    written: String,
    /// False if the inverse holds a joint.
    is_closed: bool,
}

impl Alternative {
    pub(super) fn new(words: String, task: Option<Task>, redundant: Option<&str>) -> Self {
        let task = task.map(|task| format!("task: {}", task.name()));
        let redundant = redundant.map(|name| format!("redundant: {name}"));
        let keys: Vec<String> = task.into_iter().chain(redundant).collect();
        Alternative { words, of: None, written: format!("inverse: {{{}}}", keys.join(", ")), is_closed: true }
    }

    /// With an inverse that holds a joint, unless it is closed.
    pub(super) fn closed_if(self, is_closed: bool) -> Self {
        Alternative { is_closed, ..self }
    }

    /// For another task than the file asks for.
    pub(super) fn of(self, task: Option<Task>) -> Self {
        Alternative { of: task, ..self }
    }
}

impl Unsupported {
    /// Adds the requests that have an inverse, those of one task together.
    pub(super) fn or_else(self, alternatives: Vec<Alternative>) -> Self {
        let mut reason = self.reason.clone();
        let worded: Vec<&Alternative> = alternatives.iter().filter(|found| !found.words.is_empty()).collect();
        for group in worded.chunk_by(|a, b| a.of == b.of) {
            let words: Vec<&str> = group.iter().map(|found| found.words.as_str()).collect();
            reason += &match words.as_slice() {
                [] => continue,
                [one] => format!("; {one} works"),
                [rest @ .., last] => format!("; {} or {last} work", rest.join(", ")),
            };
            if let Some(task) = group.first().and_then(|found| found.of) {
                reason += &format!(" for the task `{}`", task.name());
            }
        }
        let closed = alternatives.iter().filter(|found| found.is_closed).map(|found| found.written.clone()).collect();
        let instead = alternatives.into_iter().map(|found| found.written).collect();
        Unsupported { reason, instead, closed, ..self }
    }

    pub(super) fn new(reason: impl Into<String>) -> Self {
        let reason = reason.into();
        Unsupported { alone: reason.clone(), reason, hint: None, instead: Vec::new(), closed: Vec::new() }
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

/// How many joints the arm has beyond those that its task needs.
pub(super) fn spare(model: &Model, task: Option<Task>) -> usize {
    // The angle of `position_angle` is the sum of all joints but one: none of them can be given.
    let takes_some = task != Some(Task::PositionAngle);
    if takes_some { model.joints.len().saturating_sub(needs(task)) } else { 0 }
}

/// Returns true if the arm has one joint more than its task needs, and the file does not name that joint.
pub(super) fn is_one_more(model: &Model, task: Option<Task>) -> bool {
    spare(model, task) == 1 && model.inverse.redundant.is_empty()
}

/// One joint more than the task needs, and none whose value could be given.
pub(super) fn none_to_spare(model: &Model, task: Option<Task>) -> Unsupported {
    let (joints, name) = (model.joints.len(), task.unwrap_or(Task::Pose).name());
    Unsupported::new(format!(
        "{joints} moving joints are one more than the task `{name}` needs, and whichever value is given, the other axes \
         have no three in a row that meet or are parallel"
    ))
}

/// Why the values of these joints cannot be given: the task needs more than are left.
pub(super) fn not_to_spare(model: &Model, task: Task) -> Option<String> {
    let redundant = &model.inverse.redundant;
    let left = model.joints.len().checked_sub(redundant.values.len()).filter(|_| !redundant.is_empty())?;
    // Some arms of four and five joints have a pose too: those with a joint more are told what theirs lacks.
    let is_fewer = left + 1 == needs(Some(task)) || (task != Task::Pose && left < needs(Some(task)));
    let name = task.name();
    let names = redundant.written(&model.joints);
    is_fewer.then(|| format!("`redundant: {names}` leaves {}, fewer than `{name}` needs", counted(left, "")))
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
    let redundant = &model.inverse.redundant;
    let (given, names) = (redundant.values.len(), redundant.written(&model.joints));
    let moving = match given {
        0 => counted(joints, "moving "),
        given => {
            let left = counted(joints.saturating_sub(given), "moving ");
            format!("the {left} that `redundant: {names}` leaves")
        }
    };
    let spare = spare(model, task);
    Unsupported::new(match task {
        _ if is_one_more(model, task) => {
            format!(
                "{joints} moving joints are one more than the task `{name}` needs: name under `inverse` the one whose \
                 value is given"
            )
        }
        _ if given == 0 && spare > 1 => {
            let more = in_words(spare);
            format!("{joints} moving joints are {more} more than `{name}` needs: give {more} values")
        }
        _ if given > 0 && spare > given => {
            let more = in_words(spare - given);
            format!("`redundant: {names}` leaves {}, {more} more than `{name}` needs", counted(joints - given, ""))
        }
        Some(_) => format!("the task `{name}` is not covered for {moving}"),
        None => format!("no task fits {moving}"),
    })
}

/// No triple: which three axes come closest. An axis whose value is given counts in none.
pub(super) fn no_triple(model: &Model, geometry: &Geometry) -> Unsupported {
    let held = &model.inverse.redundant;
    let is_held = |first: usize| (first..first + 3).any(|joint| held.holds(joint));
    let closest = geometry.misses.iter().filter(|(first, _)| !is_held(*first)).min_by(|a, b| a.1.total_cmp(&b.1));
    let mut reason = "no three consecutive axes meet or are parallel".to_string();
    let named = |first: usize| format!("axes {}, {}, {}", first + 1, first + 2, first + 3);
    if let Some(triple) = geometry.triples.iter().find(|triple| is_held(triple.first)) {
        let slides = model.joints.iter().skip(triple.first).take(3).any(|j| j.kind == JointKind::Prismatic);
        let (three, what) = (named(triple.first), triple.kind.words(slides));
        let names = held.written(&model.joints);
        reason += &format!(" where `redundant: {names}` holds one of {three}, which {what}");
    }
    let nearly = nearly_parallel(model, geometry, is_held);
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

/// Three revolute joints in a row whose axes are nearly parallel, none of them held: the first of them, and the largest
/// angle between two neighbors, rad.
fn nearly_parallel(model: &Model, geometry: &Geometry, is_held: impl Fn(usize) -> bool) -> Option<(usize, f64)> {
    let turns = |first: usize| model.joints.iter().skip(first).take(3).all(|joint| joint.kind == JointKind::Revolute);
    let triples = geometry.axes.windows(3).enumerate().filter(|(first, _)| turns(*first) && !is_held(*first));
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
    #![allow(clippy::unwrap_used)]

    use super::rounded;

    fn report(arm: &str) -> crate::Report {
        let text = format!("name: arm\nunits: {{length: mm, angle: deg}}\n{arm}");
        crate::check(&text, "arm.yaml").unwrap()
    }

    /// Axes 1, 2, 3 meet, and joint 3 is held.
    const SHOULDER: &str = "convention: modified
inverse: {redundant: q3}
joints:
  - {a: 0, alpha: 0, d: 267, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 293, theta: 0}
  - {a: 52.5, alpha: 90, d: 0, theta: 0}
  - {a: 77.5, alpha: 90, d: 342.5, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 76, alpha: -90, d: 97, theta: 0}
";

    #[test]
    fn a_held_axis_is_no_part_of_the_closest_three() {
        let others =
            "  in closed form: `inverse: {task: pose, redundant: q4}`, `inverse: {task: pose, redundant: q5}`, ";
        let of_the_three = "no three consecutive axes meet or are parallel where `redundant: q3` holds one of axes 1, 2, 3, \
                            which meet in a point; closest: axes 5, 6, 7 miss by 76 mm";
        let text = report(SHOULDER).to_string();
        assert!(text.contains(&format!("  {of_the_three}\n")) && text.contains(others), "{text}");
        // With an offset at the shoulder no three axes meet anywhere.
        let offset = SHOULDER.replacen("{a: 0, alpha: -90", "{a: 30, alpha: -90", 1);
        let none = "no three consecutive axes meet or are parallel; closest: axes 5, 6, 7 miss by 76 mm";
        let text = report(&offset).to_string();
        assert!(text.contains(&format!("  {none}\n")) && !text.contains("in closed form"), "{text}");
    }

    #[test]
    fn another_task_is_named_with_the_joint_to_give() {
        let rows = "convention: standard
joints:
  - {name: j1, a: 0, alpha: -90, d: 275, theta: 0}
  - {name: j2, a: 700, alpha: 180, d: 0, theta: -90}
  - {name: j3, a: 0, alpha: -90, d: 0, theta: 0}
  - {name: j4, a: 0, alpha: 90, d: -500, theta: 0}
  - {name: j5, a: 0, alpha: -90, d: 162, theta: 0}
  - {name: j6, a: 0, alpha: 180, d: 0, theta: 0}
";
        let other =
            "`redundant: j1`, `redundant: j2`, `redundant: j3` or `redundant: j4` work for the task `position_axis`";
        // In f32 the arm has no inverse.
        let rows = rows.replace("a: 700, alpha: 180", "a: 700, alpha: 170");
        let options = crate::Options { scalar: crate::ScalarKind::F32, ..crate::Options::new("Arm") };
        let text = format!("name: arm\nunits: {{length: mm, angle: deg}}\n{rows}");
        let found = crate::generate(&text, "arm.yaml", &options).unwrap().report.unsupported.unwrap();
        let digits = "f32 has too few digits for the equation of degree 8 that holds a joint: f64 has enough";
        assert!(found.ends_with(&format!("axes 4, 5, 6 miss by 162 mm; {digits}; {other}")), "{found}");
        // The task that the file asks for has no need of its name.
        let asked = report(&rows.replace("joints:", "inverse: {task: position_axis}\njoints:")).unsupported.unwrap();
        assert!(asked.ends_with("or `redundant: j4` work"), "{asked}");
    }

    #[test]
    fn three_digits() {
        let texts = [0.3, 57.04, 0.0758, 150.0, 1000.0, 0.02, 1.5e-7].map(rounded);
        assert_eq!(texts, ["0.3", "57", "0.0758", "150", "1000", "0.02", "1.5e-7"]);
    }
}
