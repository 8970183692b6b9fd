//! The plan as text.

use super::deciding_axes::DecidingAxes;
use super::plan::{Plan, PlanStep, Value};
use crate::symbolic::{Label, Part, Symbol, Unknown};

/// One line a step: which joint, by which kind of equation.
pub fn describe(plan: &Plan) -> Vec<String> {
    let mut lines = vec![DecidingAxes::of_triple(plan).words];
    lines.extend(plan.missed.map(|by| format!("the axes miss this structure by {by:.0e}: every solution is verified")));
    lines.extend(plan.lacks_a_turn().then(|| "five joints have not every pose: every solution is verified".to_owned()));
    let steps = plan.steps.iter().filter_map(|step| match step {
        PlanStep::Stage(stage) => Some(format!("{}: {}", listed(&plan.labels(stage)), stage.kernel.form().description)),
        PlanStep::Agreement { meaning, .. } => Some(meaning.trim_end_matches('.').to_lowercase()),
        PlanStep::Swivel { .. } => Some("the upper arm's rotation from the wrist center and the arm angle".into()),
        PlanStep::Angle { symbol, .. } => left_of_sum(plan, symbol),
    });
    // An angle that is known beforehand is no step.
    let staged = |joint: usize| {
        plan.steps.iter().any(|step| matches!(step, PlanStep::Stage(stage) if stage.joints.contains(&joint)))
    };
    let rest = (0..plan.loop_joints.len()).filter(|joint| plan.joint(*joint).is_some() && !staged(*joint));
    for line in steps.chain(rest.filter_map(|joint| left_of_others(plan, joint))) {
        // Two angles that are measured may be parts of one sum.
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines
}

/// Values of joints, separated by commas.
fn listed(labels: &[Label]) -> String {
    labels.iter().map(|label| format!("q{label}")).collect::<Vec<_>>().join(", ")
}

/// The joint that is what others leave of a sum, which an angle is a part of.
fn left_of_sum(plan: &Plan, sum: &Symbol) -> Option<String> {
    let part = |value: &Value| value.terms.iter().any(|(term, _)| term == sum);
    left_of_others(plan, plan.values.iter().position(part)?)
}

/// A joint that is what others leave of a sum.
fn left_of_others(plan: &Plan, joint: usize) -> Option<String> {
    let terms = &plan.values.get(joint)?.terms;
    let known = |label: Label| {
        let values = Unknown::both(label, Part::Value).map(Symbol::from);
        terms.iter().any(|(term, _)| values.contains(term))
    };
    let of = |slot: &usize| plan.label(*slot);
    let joints: Vec<Label> =
        (0..plan.loop_joints.len()).filter(|slot| *slot == joint || known(of(slot))).map(|slot| of(&slot)).collect();
    let label = plan.label(joint);
    Some(match joints.len() {
        1 => format!("q{label}: the direction of the tool in the plane"),
        _ => format!("q{label}: what is left of the sum {}", listed(&joints)),
    })
}
