//! The axes that decide an inverse: those whose relation its plan rests on.

use super::plan::Plan;
use crate::model::geometry::TripleKind;

/// Axes whose relation a plan rests on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DecidingAxes {
    /// The joints of the arm whose axes they are, from 0, in the order of the closed chain. Virtual axes are none of the arm's.
    pub joints: Vec<usize>,
    /// Their relation.
    pub relation: AxesRelation,
    /// Axes and relation as the report has them: `axes 4, 5, 6 meet in a point`. A virtual axis is `v1`, or that of the tool.
    pub words: String,
}

/// Relation of axes, in every posture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxesRelation {
    /// They meet in a point.
    Meet,
    /// They are parallel.
    Parallel,
    /// They move in a plane: some slide across the direction of the others, which are parallel.
    InPlane,
    /// They turn the tool, wherever they are; the other joints slide.
    Turn,
}

impl DecidingAxes {
    /// The triple of a plan in stages.
    pub fn of_triple(plan: &Plan) -> Self {
        let slots = plan.triple.first..plan.triple.first + 3;
        let slides = slots.clone().any(|slot| plan.loop_joints.get(slot).is_some_and(|slot| !slot.revolute));
        let [a, b, c] = [0, 1, 2].map(|k| plan.label(plan.triple.first + k));
        let relation = match plan.triple.kind {
            TripleKind::Intersecting => AxesRelation::Meet,
            TripleKind::Parallel if slides => AxesRelation::InPlane,
            TripleKind::Parallel => AxesRelation::Parallel,
            TripleKind::Turning => AxesRelation::Turn,
        };
        let words = format!("axes {a}, {b}, {c} {}", plan.triple.kind.words(slides));
        DecidingAxes { joints: slots.filter_map(|slot| plan.joint(slot)).collect(), relation, words }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::AxesRelation::{self, Meet, Parallel};

    /// The axes of an arm file; the report has their words in one line, or none of the kind.
    fn axes(text: &str) -> Vec<(Vec<usize>, AxesRelation)> {
        let found = crate::program(text, "arm.yaml").unwrap().deciding_axes;
        let report = crate::check(text, "arm.yaml").unwrap().to_string();
        let words: Vec<&str> = found.iter().map(|axes| axes.words.as_str()).collect();
        let line = report.lines().map(str::trim).find(|line| line.starts_with(&words.join(", ")));
        assert!(words.is_empty() || line.is_some(), "{words:?} in {report}");
        found.into_iter().map(|axes| (axes.joints, axes.relation)).collect()
    }

    #[test]
    fn a_wrist_and_three_parallel_axes_decide() {
        assert_eq!(axes(include_str!("../../../specs/ur5.yaml")), [(vec![1, 2, 3], Parallel)]);
        assert_eq!(axes(include_str!("../../../specs/abb_irb2400.yaml")), [(vec![3, 4, 5], Meet)]);
        assert_eq!(axes(include_str!("../../../specs/franka_panda.yaml")), [(vec![0, 1, 2], Meet)]);
        // The slide between them is none of the three.
        assert_eq!(axes(include_str!("../../../specs/cobra600_rrpr.yaml")), [(vec![0, 1, 3], Parallel)]);
    }

    #[test]
    fn virtual_axes_are_none_of_the_arm() {
        assert_eq!(axes(include_str!("../../../specs/anthro3r.yaml")), [(vec![], Meet)]);
        assert_eq!(axes(include_str!("../../../specs/planar2r.yaml")), [(vec![0, 1], Parallel)]);
    }

    #[test]
    fn two_axes_that_meet_and_two_that_are_parallel_decide_where_a_joint_is_held() {
        let pairs = [(vec![3, 4], Meet), (vec![1, 2], Parallel)];
        assert_eq!(axes(include_str!("../../../specs/kinova_gen3_lite.yaml")), pairs);
    }

    #[test]
    fn no_axes_decide_without_an_inverse() {
        assert_eq!(axes(include_str!("../../../specs/singular_6r.yaml")), []);
    }
}
