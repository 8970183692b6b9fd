//! Things to draw, in space.

use denhart::{JointKind, Pose};
use denhart_dynamic::{DynamicArm, DynamicSolution};

use crate::DrawError;
use crate::deciding::{DecidingLines, deciding_words};
use crate::number::{rough, short};
use crate::section::Section;
use crate::skeleton::Skeleton;
use crate::vector::{Vector, length, scaled, sub, unit};

/// A target farther from the base than so many times the arm stands nearer ..
const FAR: f64 = 6.0;
/// .. at so many times.
const NEARER: f64 = 3.0;

/// An arm in one posture, with its name in the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The geometry.
    pub skeleton: Skeleton,
    /// Number of the solution, from 1; `None` for the arm itself, which has the signs of its joints.
    pub solution: Option<usize>,
    /// True if a joint is outside its limits.
    pub out_of_limits: bool,
    /// Name of the solution's branch; empty where it has none.
    pub branch: String,
}

/// The way that a target is missed by.
#[derive(Debug, Clone, PartialEq)]
pub struct Miss {
    /// The tool point of the closest approach.
    pub from: Vector,
    /// The point of the target.
    pub to: Vector,
    /// The difference in words.
    pub text: String,
}

/// An arm and what stands around it: a plain list of things in space, base frame, length unit of the arm.
///
/// The picture is made from it, and other ones may be: it knows nothing of views and colors.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Name of the arm.
    pub name: String,
    /// Symbol of the length unit.
    pub length_unit: String,
    /// Second line: the posture in words.
    pub posture: String,
    /// Postures of the arm; the first one has the frames, dimensions and axes.
    pub figures: Vec<Figure>,
    /// Frames of the table are drawn.
    pub frames: bool,
    /// Lengths of the table are drawn.
    pub dimensions: bool,
    /// The axes that decide the inverse, with a sentence on them; `None` if they are not drawn.
    pub axes: Option<(Vec<DecidingLines>, String)>,
    /// Pose of the target. One that lies too far away stands nearer, in its direction from the base.
    pub target: Option<Pose<f64>>,
    /// The point of a target that stands nearer.
    pub far_target: Option<Vector>,
    /// The way from the tool point to the target, where it is missed.
    pub miss: Option<Miss>,
    /// The section that the tool reaches.
    pub section: Option<Section>,
    /// Lines below the picture.
    pub notes: Vec<String>,
}

impl Scene {
    /// An arm without a posture.
    fn empty(arm: &DynamicArm) -> Self {
        Scene {
            name: arm.model().name.clone(),
            length_unit: arm.length_unit().to_string(),
            posture: String::new(),
            figures: Vec::new(),
            frames: false,
            dimensions: false,
            axes: None,
            target: None,
            far_target: None,
            miss: None,
            section: None,
            notes: Vec::new(),
        }
    }

    /// An arm at joint values, rad or length unit. Joints outside their limits are told in a note.
    ///
    /// # Errors
    /// Another number of joint values, one that is not finite, points that are not.
    pub fn of(arm: &DynamicArm, q: &[f64]) -> Result<Self, DrawError> {
        let mut scene = Scene::empty(arm);
        let out: Vec<String> = outside(arm, q);
        scene.posture = posture(arm, q);
        scene.figures.push(Figure {
            skeleton: Skeleton::of(arm, q)?,
            solution: None,
            out_of_limits: !out.is_empty(),
            branch: String::new(),
        });
        if !out.is_empty() {
            scene.notes.push(format!("outside limits: {}", out.join(", ")));
        }
        Ok(scene)
    }

    /// Every solution of a target, without the arm itself.
    ///
    /// # Errors
    /// A solution that has no finite points.
    pub fn of_solutions(arm: &DynamicArm, target: Pose<f64>, solutions: &[DynamicSolution]) -> Result<Self, DrawError> {
        let scene = Scene::empty(arm);
        scene.with_solutions(arm, solutions).map(|scene| scene.with_target(target))
    }

    /// Adds solutions beside what is there.
    ///
    /// # Errors
    /// As of [`of_solutions`](Self::of_solutions).
    pub fn with_solutions(mut self, arm: &DynamicArm, solutions: &[DynamicSolution]) -> Result<Self, DrawError> {
        for (number, solution) in (1..).zip(solutions.iter()) {
            let branch = solution.branch.to_string();
            self.figures.push(Figure {
                skeleton: Skeleton::of(arm, &solution.q)?,
                solution: Some(number),
                out_of_limits: !solution.is_within_limits(),
                branch: if branch == "-" { String::new() } else { branch },
            });
        }
        Ok(self)
    }

    /// Shows the target. One that is farther from the base than six times the arm stands at three times, with a note:
    /// beside its true place no arm would be seen.
    #[must_use]
    pub fn with_target(mut self, mut target: Pose<f64>) -> Self {
        let points = self.figures.iter().flat_map(|figure| figure.skeleton.points());
        let size = points.map(|point| length(*point)).fold(0.0, f64::max);
        let (away, direction) = polar(target.translation);
        if size > 0.0 && away > FAR * size {
            self.far_target = Some(target.translation);
            self.notes.push(format!("the target, {} {} from the base, is drawn nearer", rough(away), self.length_unit));
            target.translation = scaled(direction, NEARER * size);
        }
        self.target = Some(target);
        self
    }

    /// Shows the frames of the table.
    #[must_use]
    pub fn with_frames(mut self) -> Self {
        self.frames = true;
        self
    }

    /// Shows the lengths of the table.
    #[must_use]
    pub fn with_dimensions(mut self) -> Self {
        self.dimensions = true;
        self
    }

    /// Shows the axes that decide the inverse, in the posture of the first figure. Where no axis of the arm does, a note says so.
    #[must_use]
    pub fn with_axes(mut self, arm: &DynamicArm) -> Self {
        let lines = self.figures.first().map(|figure| DecidingLines::of(arm, &figure.skeleton));
        self.axes = lines.map(|lines| (lines, deciding_words(arm)));
        self
    }

    /// Shows by how much the target is missed, from the tool point of the first figure.
    #[must_use]
    pub fn with_miss(mut self) -> Self {
        if let (Some(figure), Some(target)) = (self.figures.first(), self.target) {
            let (from, to) = (figure.skeleton.tool.translation, target.translation);
            let (short, _) = polar(sub(self.far_target.unwrap_or(to), from));
            let text = format!("{} {} short", rough(short), self.length_unit);
            self.miss = Some(Miss { from, to, text });
        }
        self
    }

    /// Shows the section that the tool reaches.
    #[must_use]
    pub fn with_section(mut self, section: Section) -> Self {
        self.section = Some(section);
        self
    }

    /// Adds a line below the picture.
    #[must_use]
    pub fn with_note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }
}

/// Length and direction, of vectors too whose squares are not finite.
fn polar(vector: Vector) -> (f64, Vector) {
    let greatest = vector.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if greatest == 0.0 {
        return (0.0, vector);
    }
    let part = vector.map(|x| x / greatest);
    (greatest * length(part), unit(part).unwrap_or_default())
}

/// The posture in words: `all joints at 0`, or the joint values.
fn posture(arm: &DynamicArm, q: &[f64]) -> String {
    if q.iter().all(|value| *value == 0.0) {
        return "all joints at 0".to_owned();
    }
    let shown = |(kind, value): (&JointKind, &f64)| match kind {
        JointKind::Revolute => format!("{}\u{b0}", short(rounded(value.to_degrees()))),
        _ => format!("{} {}", short(*value), arm.length_unit()),
    };
    let values: Vec<String> = arm.joint_kinds().iter().zip(q).map(shown).collect();
    format!("q = {}", values.join(", "))
}

/// Names of joints outside their limits.
fn outside(arm: &DynamicArm, q: &[f64]) -> Vec<String> {
    let slack = |value: f64| 1e-12 * (1.0 + value.abs());
    let joints = arm.joint_names().zip(arm.limits()).zip(q);
    joints
        .filter(|((_, [low, high]), value)| **value < low - slack(*low) || **value > high + slack(*high))
        .map(|((name, _), _)| name.to_owned())
        .collect()
}
/// To four decimals; a number so large that it has none stays as it is.
fn rounded(value: f64) -> f64 {
    if value.abs() < 1e9 { (value * 1e4).round() / 1e4 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_far_target_stands_nearer_and_its_distance_is_told() {
        let arm = DynamicArm::from_yaml(include_str!("../../specs/ur5.yaml"));
        let scene = arm.ok().and_then(|arm| Scene::of(&arm, &[0.0; 6]).ok());
        assert!(scene.is_some());
        let Some(scene) = scene else { return };
        let at = |x| Pose { translation: [x, 0.0, 0.0], ..Pose::identity() };
        let near = scene.clone().with_target(at(3.0)).with_miss();
        assert_eq!(near.target.map(|target| target.translation), Some([3.0, 0.0, 0.0]));
        assert!(near.far_target.is_none() && near.notes.is_empty());
        for (x, words) in [(1e3, "1000 m"), (1e300, "1.00e300 m")] {
            let far = scene.clone().with_target(at(x)).with_miss();
            assert!(far.target.is_some_and(|target| (2.0..6.0).contains(&target.translation[0])), "{:?}", far.target);
            assert_eq!(far.notes, [format!("the target, {words} from the base, is drawn nearer")]);
            assert_eq!(far.miss.map(|miss| miss.text), Some(format!("{words} short")));
        }
    }
}
