//! A stage of the plan as a call of its kernel.

use super::{Call, Counted, DefaultValue, RootRange, Slot, Statement};
use crate::solve::kernel::{Cone, ConeRange, Distance, ElbowRange, Phase};
use crate::solve::{Kernel, Plan, Stage};
use crate::symbolic::{Expr, Graph};

/// The call of a stage, and the statements before it. They work out once what is the same for every root of the stages
/// before.
pub fn call(plan: &Plan, graph: &Graph, index: usize, stage: &Stage) -> (Vec<Statement>, Call) {
    let mut before = Vec::new();
    let (range, counted) = match &stage.kernel {
        Kernel::Distance(Distance { range, about, .. }) => {
            // Links along one line are stretched or folded: that needs no angle.
            let (line, about) = match about {
                Some(Phase { y, x }) if *y == Expr::ZERO => (Some(*x), None),
                about => (None, about.as_ref()),
            };
            let range = elbow(graph, index, range, line, &mut before);
            (range, about.map_or(Counted::FromZero, |about| phase(index, about, &mut before)))
        }
        Kernel::Cone(Cone { range, about, .. }) => {
            let range = cone(graph, index, range, &mut before);
            (range, about.as_ref().map_or(Counted::FromZero, |about| phase(index, about, &mut before)))
        }
        _ => (RootRange::None, Counted::FromZero),
    };
    let defaults = [default_value(plan, stage, 0), default_value(plan, stage, 1)];
    let labels = plan.labels(stage).iter().map(ToString::to_string).collect();
    let call = Call { stage: index, labels, kernel: stage.kernel.clone(), unit: stage.unit, defaults, range, counted };
    (before, call)
}

fn default_value(plan: &Plan, stage: &Stage, place: usize) -> DefaultValue {
    let slot = stage.joints.get(place).or(stage.joints.first()).copied().unwrap_or(0);
    DefaultValue { joint: plan.joint(slot), shift: plan.shift(slot) }
}

fn phase(stage: usize, phase: &Phase, before: &mut Vec<Statement>) -> Counted {
    if phase.y == Expr::ZERO {
        return Counted::TurnedBack(phase.x);
    }
    before.push(Statement::Phase { stage, phase: *phase });
    Counted::FromPhase
}

fn elbow(
    graph: &Graph,
    stage: usize,
    range: &ElbowRange,
    line: Option<Slot>,
    before: &mut Vec<Statement>,
) -> RootRange {
    if let [Some(a), Some(b), Some(height)] = range.inputs().map(|e| graph.constant(e)) {
        return RootRange::Elbow { links: [a, b], max: (a + b).hypot(height), min: (a - b).hypot(height) };
    }
    before.push(Statement::Elbow { stage, range: *range, line });
    RootRange::Prepared
}

fn cone(graph: &Graph, stage: usize, range: &ConeRange, before: &mut Vec<Statement>) -> RootRange {
    if let [Some(along), Some(across), Some(cos), Some(sin)] = range.inputs().map(|e| graph.constant(e)) {
        // Rounding of a product of exact angles must not look like an angle of 1e-17.
        let size = along.hypot(across);
        let clean = |x: f64| if x.abs() <= 1e-15 * size { 0.0 } else { x };
        return RootRange::Cone {
            max: [along * cos + across * sin, across * cos - along * sin].map(clean),
            min: [along * cos - across * sin, across * cos + along * sin].map(clean),
        };
    }
    before.push(Statement::Cone { stage, range: *range });
    RootRange::Prepared
}
