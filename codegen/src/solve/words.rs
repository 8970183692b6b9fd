//! The plan in words.

use super::plan::{Kernel, Plan, PlanStep};
use crate::model::geometry::TripleKind;

/// One line a step: which joint, by which kind of equation.
pub fn describe(plan: &Plan) -> Vec<String> {
    let label = |k: usize| plan.label(plan.triple.first + k);
    let kind = match plan.triple.kind {
        TripleKind::Meeting => "meet in a point",
        TripleKind::Parallel if plan.slots.iter().skip(plan.triple.first).take(3).any(|slot| !slot.turns) => {
            "move in a plane"
        }
        TripleKind::Parallel => "are parallel",
    };
    let mut lines = vec![format!("axes {}, {}, {} {kind}", label(0), label(1), label(2))];
    for step in &plan.steps {
        lines.push(match step {
            PlanStep::Stage(stage) => {
                let joints: Vec<String> = stage.joints.iter().map(|j| format!("q{}", plan.label(*j))).collect();
                format!("{}: {}", joints.join(", "), kernel(&stage.kernel))
            }
            PlanStep::Agreement { meaning, .. } => meaning.trim_end_matches('.').to_lowercase(),
            PlanStep::Swivel { .. } => "the upper arm's rotation from the wrist center and the arm angle".into(),
            PlanStep::Angle { name, .. } => {
                let joints: Vec<String> = name.chars().skip(1).map(|c| format!("q{c}")).collect();
                let last = label(2);
                format!("q{last}: what is left of the sum {}", joints.join(", "))
            }
        });
    }
    lines
}

fn kernel(kernel: &Kernel) -> &'static str {
    match kernel {
        Kernel::Offset { .. } => "a point keeps an offset, a cos + b sin = d (2 roots)",
        Kernel::OffsetOfTwo { .. } => "a point and a direction keep offsets, a cos + b sin = d (2 roots)",
        Kernel::Distance { .. } => "two points a given distance apart, law of cosines (2 roots)",
        Kernel::Cone { .. } => "a component along another axis (2 roots)",
        Kernel::Align { .. } => "one vector turned onto another (1 root)",
        Kernel::Flip { .. } => "two axes at right angles point a direction (2 roots)",
        Kernel::Wrist { .. } => "three axes at right angles give a rotation (2 roots)",
        Kernel::Slide { .. } => "slides to a given distance (2 roots)",
        Kernel::SlideTo { .. } => "slides by a given amount (1 root)",
        Kernel::SlideTurning { .. } => "two components across a slide, an angle and another slide (2 roots)",
        Kernel::Aim { .. } => "one direction seen over a sliding joint, two cones (2 roots)",
        Kernel::Pair { .. } => "two equations together, a quartic (up to 4 roots)",
        Kernel::PairSliding { .. } => "two equations together, a quartic with a slide (up to 4 roots)",
        Kernel::Quadratic { .. } => "two equations in two slides, a quadratic (2 roots)",
    }
}
