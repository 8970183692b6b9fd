//! The joints whose values could be given, of an arm with more joints than its task needs.

use super::attempt::attempt;
use super::lists::combinations;
use crate::model::chain::Chain;
use crate::model::geometry::Geometry;
use crate::model::{Model, Redundant, RedundantValue, Task};
use crate::solve::description::describe;
use crate::solve::held_joint::{self, Holding};
use crate::solve::loop_chain::LoopChain;
use crate::solve::plan::Plan;
use crate::solve::{swivel, unsupported};

/// Values that could be given, and the inverse that is left.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// The values.
    pub given: Redundant,
    /// Their names, as a file writes them at `redundant`.
    pub names: String,
    /// How the other joints are solved.
    pub way: Way,
    /// The way in words.
    pub words: String,
}

/// How the joints that are left are solved; the cheapest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Way {
    /// In closed form, with so many operations in its equations. With an equation of degree 4 that counts more.
    ClosedForm {
        /// True with an equation of degree 4.
        has_quartic: bool,
        /// The operations.
        operations: usize,
    },
    /// Two joints slide: one is held at the roots of an equation of degree 4.
    Slides,
    /// Two axes meet and two are parallel: one joint is held at the roots of an equation of degree 8.
    Meet,
    /// One joint is held at the roots of an equation of degree 8, which an elimination gives.
    General,
}

impl Way {
    /// The name of the kind.
    pub fn name(self) -> &'static str {
        match self {
            Way::ClosedForm { .. } => "closed form",
            Way::Slides => "slides",
            Way::Meet => "meet",
            Way::General => "general",
        }
    }
}

/// All choices with which the arm has an inverse for its task, the cheapest first; none for an arm whose task needs all of
/// its joints. Whether a joint can be held is not tried for each: the choice of one takes a tenth of a second.
pub fn choices(model: &Model, chain: &Chain, geometry: &Geometry) -> Vec<Choice> {
    let task = model.inverse.task.unwrap_or(Task::Pose);
    let spare = unsupported::spare(model, Some(task));
    let asks_for_pose = task == Task::Pose && model.parameters.is_empty();
    let mut found = Vec::new();
    if spare == 0 {
        return found;
    }
    for list in combinations(model.joints.len(), spare) {
        let given = Redundant::of(&list);
        let joints = LoopChain::new(model, chain, geometry.reach, &given);
        let way = match attempt(task, model, geometry, &joints) {
            Ok(plan) => Some(closed(&plan)),
            Err(_) => held_joint::holding(model, chain, geometry, &given).map(held),
        };
        found.extend(way.map(|way| Choice::new(model, &given, way)));
    }
    let lists = if asks_for_pose { combinations(model.joints.len(), spare - 1) } else { Vec::new() };
    for list in lists {
        let mut given = Redundant { is_list: spare > 1, ..Redundant::of(&list) };
        given.values.push(RedundantValue::ArmAngle);
        let joints = LoopChain::new(model, chain, geometry.reach, &given);
        let plan = swivel::plan(joints, model, chain);
        found.extend(plan.ok().map(|plan| Choice::new(model, &given, closed(&plan))));
    }
    found.sort_by_key(|choice| choice.way);
    found
}

impl Choice {
    fn new(model: &Model, given: &Redundant, (way, words): (Way, String)) -> Self {
        Choice { names: given.written(&model.joints), given: given.clone(), way, words }
    }
}

/// The way of a plan in stages.
fn closed(plan: &Plan) -> (Way, String) {
    let operations = crate::symbolic::cost(&plan.graph, &plan.inputs()).arithmetic();
    let has_quartic = plan.stages().any(|stage| stage.kernel.form().roots > 2);
    let axes = describe(plan).into_iter().next().unwrap_or_default();
    let degree = if has_quartic { ", with an equation of degree 4" } else { "" };
    let words = format!("closed form, {axes}{degree}: {operations} operations");
    (Way::ClosedForm { has_quartic, operations }, words)
}

/// The way of a plan that holds a joint.
fn held(holding: Holding) -> (Way, String) {
    let (way, structure) = match holding {
        Holding::Slides => (Way::Slides, "two joints slide: one equation of degree 4"),
        Holding::Meet => (Way::Meet, "two axes meet and two are parallel: one equation of degree 8"),
        Holding::General => (Way::General, "one equation of degree 8, if a joint can be held"),
    };
    (way, format!("{structure}, 5 to 15 times as long as a closed form"))
}
