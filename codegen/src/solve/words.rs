//! The plan in words.

use super::plan::{Kernel, Plan, PlanStep, Value};
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
        TripleKind::Turning => "turn the tool, the others slide",
    };
    let mut lines = vec![format!("axes {}, {}, {} {kind}", label(0), label(1), label(2))];
    let steps = plan.steps.iter().filter_map(|step| match step {
        PlanStep::Stage(stage) => {
            let joints: Vec<String> = stage.joints.iter().map(|j| format!("q{}", plan.label(*j))).collect();
            Some(format!("{}: {}", joints.join(", "), kernel(&stage.kernel)))
        }
        PlanStep::Agreement { meaning, .. } => Some(meaning.trim_end_matches('.').to_lowercase()),
        PlanStep::Swivel { .. } => Some("the upper arm's rotation from the wrist center and the arm angle".into()),
        PlanStep::Angle { name, .. } => left_of_sum(plan, name),
    });
    // An angle that is known beforehand is no step.
    let staged = |joint: usize| {
        plan.steps.iter().any(|step| matches!(step, PlanStep::Stage(stage) if stage.joints.contains(&joint)))
    };
    let own = |joint: usize| plan.slots.get(joint).is_some_and(|slot| slot.joint.is_some());
    let rest = (0..plan.slots.len()).filter(|joint| own(*joint) && !staged(*joint));
    for line in steps.chain(rest.filter_map(|joint| left_of_others(plan, joint))) {
        // Two angles that are measured may be parts of one sum.
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines
}

/// The joint that is what others leave of a sum, which an angle is a part of.
fn left_of_sum(plan: &Plan, sum: &str) -> Option<String> {
    let part = |value: &Value| value.terms.iter().any(|(term, _)| term == sum);
    left_of_others(plan, plan.values.iter().position(part)?)
}

/// A joint that is what others leave of a sum.
fn left_of_others(plan: &Plan, joint: usize) -> Option<String> {
    let terms = &plan.values.get(joint)?.terms;
    let known = |slot: usize| {
        let label = plan.label(slot);
        terms.iter().any(|(term, _)| term.strip_prefix(['q', 't']) == Some(&label))
    };
    let joints: Vec<String> = (0..plan.slots.len())
        .filter(|slot| *slot == joint || known(*slot))
        .map(|slot| format!("q{}", plan.label(slot)))
        .collect();
    let label = plan.label(joint);
    Some(match joints.len() {
        1 => format!("q{label}: the direction of the tool in the plane"),
        _ => format!("q{label}: what is left of the sum {}", joints.join(", ")),
    })
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
