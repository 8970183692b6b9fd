//! The axes that decide the inverse of an arm.

use denhart_codegen::{AxesRelation, DecidingAxes};
use denhart_dynamic::DynamicArm;

use crate::canvas::Canvas;
use crate::picture::{Paint, Role};
use crate::skeleton::{Joint, Skeleton};
use crate::vector::{Vector, add, cross, distance, dot, moved, sub};

/// A line ends this far beyond its joint and the point where the axes meet, in sizes of the arm.
const BEYOND: f64 = 0.3;

/// Lines whose directions have a smaller determinant than this are as good as parallel: their point is not known.
const CONDITION: f64 = 1e-6;

/// A line that is seen shorter than this is a ring, px.
const SHORTEST: f64 = 6.0;

/// Axes whose relation the inverse rests on, in one posture.
#[derive(Debug, Clone, PartialEq)]
pub struct DecidingLines {
    /// The joints of the arm whose axes they are, from 0. Empty where all the axes are virtual ones.
    pub joints: Vec<usize>,
    /// The ends of a line along each axis, through its joint and, where the axes meet, through that point.
    pub lines: Vec<[Vector; 2]>,
    /// The point where the axes meet; `None` for axes that do not, and where fewer than two are those of the arm.
    pub point: Option<Vector>,
    /// Relation in the words of `denhart check`: `axes 4, 5, 6 meet in a point`.
    pub words: String,
}

impl DecidingLines {
    /// The lines in the posture of a skeleton; empty where no relation of axes decides the inverse, or there is none.
    #[must_use]
    pub fn of(arm: &DynamicArm, skeleton: &Skeleton) -> Vec<Self> {
        let size = skeleton.size();
        arm.program().deciding_axes.iter().map(|axes| Self::through(axes, &skeleton.joints, size)).collect()
    }

    fn through(axes: &DecidingAxes, joints: &[Joint], size: f64) -> Self {
        let joints: Vec<&Joint> = axes.joints.iter().filter_map(|joint| joints.get(*joint)).collect();
        let point = (axes.relation == AxesRelation::Meet).then(|| common_point(&joints)).flatten();
        let line = |joint: &&Joint| {
            let to = point.map_or(0.0, |point| dot(sub(point, joint.point), joint.axis));
            let [back, front] = [to.min(0.0) - BEYOND * size, to.max(0.0) + BEYOND * size];
            [moved(joint.point, joint.axis, back), moved(joint.point, joint.axis, front)]
        };
        let lines = joints.iter().map(line).collect();
        DecidingLines { joints: axes.joints.clone(), lines, point, words: axes.words.clone() }
    }
}

/// The axes that decide the inverse in a sentence, in the words of `denhart check`; where no axis of the arm does, this.
#[must_use]
pub fn deciding_words(arm: &DynamicArm) -> String {
    let axes = &arm.program().deciding_axes;
    let words: Vec<&str> = axes.iter().map(|axes| axes.words.as_str()).collect();
    let words = words.join(", ");
    match arm.task() {
        Err(_) => "no inverse that axes decide".to_owned(),
        Ok(_) if axes.is_empty() => "no axes that meet or are parallel decide this inverse".to_owned(),
        Ok(_) if axes.iter().all(|axes| axes.joints.is_empty()) => {
            format!("no axis of the arm decides this inverse: {words}, all of them virtual")
        }
        Ok(_) => words,
    }
}

/// The point `p` nearest to lines through `c` along unit vectors `u`, which is the point they share if they meet:
/// `sum (1 - u u^T) (p - c) = 0`, three linear equations. `None` for fewer than two lines and for those that are parallel.
fn common_point(joints: &[&Joint]) -> Option<Vector> {
    // Distances from a joint nearby round less than those from the base.
    let origin = joints.first()?.point;
    let mut matrix = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    for joint in joints {
        let [x, y, z] = joint.axis;
        let across = [[1.0 - x * x, -x * y, -x * z], [-x * y, 1.0 - y * y, -y * z], [-x * z, -y * z, 1.0 - z * z]];
        let from = sub(joint.point, origin);
        right = add(right, across.map(|row| dot(row, from)));
        for (sum, row) in matrix.iter_mut().zip(across) {
            *sum = add(*sum, row);
        }
    }
    // The matrix is symmetric: its rows are its columns, and those of the inverse are their vector products.
    let [a, b, c] = matrix;
    let determinant = dot(a, cross(b, c));
    if determinant.abs() < CONDITION {
        return None;
    }
    let point = [cross(b, c), cross(c, a), cross(a, b)].map(|row| dot(row, right) / determinant);
    Some(add(origin, point)).filter(|point| point.iter().all(|x| x.is_finite()))
}

/// The axes that decide the inverse: a line along each, a ring about one that is seen from its end, a dot where they meet.
pub fn deciding(canvas: &mut Canvas, axes: &[DecidingLines], words: &str) {
    for one in axes {
        let mut place = one.point.map(|point| canvas.camera.place(point));
        for ends in &one.lines {
            let [from, to] = ends.map(|end| canvas.camera.place(end));
            if distance(from, to) < SHORTEST {
                canvas.picture.circle(from, SHORTEST, Paint::line(Role::Deciding, 1.6));
            } else {
                canvas.line(ends, Paint::line(Role::Deciding, 1.6), 1.5);
            }
            place = place.or(Some(to));
        }
        if let Some(point) = one.point {
            canvas.picture.circle(canvas.camera.place(point), 4.5, Paint::both(Role::Deciding, Role::Background, 1.2));
        }
        if let Some(at) = place.filter(|_| !canvas.small) {
            canvas.label(at, 7.0, one.words.clone(), Role::Deciding);
        }
    }
    if axes.iter().all(|one| one.lines.is_empty()) {
        canvas.notes.push(words.to_owned());
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]

    use super::*;
    use crate::vector::length;

    const Q: [f64; 6] = [0.3, -0.8, 0.9, 0.4, -0.7, 0.2];

    fn lines(text: &str, q: &[f64]) -> Vec<DecidingLines> {
        let arm = DynamicArm::from_yaml(text).unwrap();
        DecidingLines::of(&arm, &Skeleton::of(&arm, q).unwrap())
    }

    /// Distance of a point from the line through two others.
    fn off(point: Vector, [from, to]: [Vector; 2]) -> f64 {
        length(cross(sub(point, from), sub(to, from))) / distance(from, to)
    }

    #[test]
    fn the_axes_of_a_wrist_meet_where_its_lines_do() {
        let text = include_str!("../../specs/abb_irb2400.yaml");
        let arm = DynamicArm::from_yaml(text).unwrap();
        for q in [[0.0; 6], Q] {
            let [wrist] = &lines(text, &q)[..] else { panic!("one structure") };
            assert_eq!((wrist.joints.as_slice(), wrist.lines.len()), (&[3, 4, 5][..], 3));
            let point = wrist.point.unwrap();
            let size = Skeleton::of(&arm, &q).unwrap().size();
            for ends in &wrist.lines {
                assert!(off(point, *ends) < 1e-12 * size, "{ends:?}");
            }
            // The frame of link 5 stands in the wrist center: no joint of the wrist moves it.
            let moved = [q[0], q[1], q[2], 1.1, 0.6, -2.0];
            let [other] = &lines(text, &moved)[..] else { panic!("one structure") };
            assert!(distance(other.point.unwrap(), point) < 1e-12 * size);
        }
    }

    #[test]
    fn parallel_axes_have_no_point() {
        let [axes] = &lines(include_str!("../../specs/ur5.yaml"), &Q)[..] else { panic!("one structure") };
        assert_eq!((axes.joints.as_slice(), axes.point), (&[1, 2, 3][..], None));
        let directions: Vec<Vector> = axes.lines.iter().map(|[from, to]| sub(*to, *from)).collect();
        for other in &directions[1..] {
            assert!(length(cross(directions[0], *other)) < 1e-12 && dot(directions[0], *other) > 0.0);
        }
    }

    #[test]
    fn arms_without_axes_that_decide_say_so() {
        let words = |text: &str| deciding_words(&DynamicArm::from_yaml(text).unwrap());
        assert_eq!(words(include_str!("../../specs/ur5.yaml")), "axes 2, 3, 4 are parallel");
        let pairs = "axes 4 and 5 meet, axes 2 and 3 are parallel";
        assert_eq!(words(include_str!("../../specs/kinova_gen3_lite.yaml")), pairs);
        let virtual_ones = words(include_str!("../../specs/anthro3r.yaml"));
        assert!(virtual_ones.starts_with("no axis of the arm"), "{virtual_ones}");
        assert_eq!(words(include_str!("../../specs/singular_6r.yaml")), "no inverse that axes decide");
        let [pair] = &lines(include_str!("../../specs/anthro3r.yaml"), &[0.1, 0.2, 0.3])[..] else { panic!("one") };
        assert!(pair.lines.is_empty() && pair.point.is_none());
    }
}
