//! The inverse: the plan as nested loops over the roots of its stages.

use super::stage::call;
use super::{ArmConstants, Block, BranchState, Each, Inverse, Names, NestLevel, Root, Slot, Statement, margins};
use crate::model::Model;
use crate::solve::{self, HeldJointPlan, InversePlan, Plan, PlanStep, Stage, Unit};
use crate::symbolic::{Graph, Input, Mat3, Node, Part, Symbol, Unknown};
use std::collections::{HashMap, HashSet};

struct Nest<'a> {
    plan: &'a Plan,
    graph: Graph,
    block: Block<'a>,
    levels: Vec<NestLevel>,
    /// The level at which a leaf is known.
    known: HashMap<Slot, usize>,
    used: HashSet<Slot>,
    state: BranchState,
    agreements: usize,
}

/// The program of an inverse.
pub fn inverse(model: &Model, plan: &InversePlan) -> Inverse {
    match plan {
        InversePlan::Stages(plan) => stages(model, plan),
        InversePlan::HeldJoint(plan) => held_joint(model, plan),
    }
}

/// The program of a plan that holds a joint: no statements.
pub fn held_joint(model: &Model, plan: &HeldJointPlan) -> Inverse {
    let outline = plan.outline();
    Inverse {
        graph: Graph::default(),
        names: Names::default(),
        constants: ArmConstants { stands_for: plan.stands_for(), ..ArmConstants::of(model, outline.reach) },
        goal: outline.task.goal.clone(),
        given: outline.task.given.clone(),
        swivel: None,
        inputs: Vec::new(),
        levels: Vec::new(),
        stages: 0,
        agreements: 0,
        joints: outline.joints,
        capacity: outline.capacity,
        decoupled: false,
        in_doubt: false,
        off_table: None,
        table_margins: plan.names.as_deref().and_then(margins),
        held_joint: Some(plan.clone()),
        of_table: plan.stages_of_table().map(|table| Box::new(stages(model, &table))),
    }
}

/// The program of a plan.
pub fn stages(model: &Model, plan: &Plan) -> Inverse {
    let read = plan.inputs();
    // Leaves that only a joint value is made from are not in the plan's graph.
    let mut graph = plan.graph.clone();
    let wanted = plan.values.iter().zip(&plan.loop_joints).filter(|(_, slot)| slot.label.arm().is_some());
    let mut used: HashSet<Slot> =
        wanted.flat_map(|(value, _)| &value.terms).map(|(term, _)| graph.symbol(term.clone())).collect();
    used.extend(plan.graph.reachable(&read).into_iter().filter(|e| matches!(plan.graph.node(*e), Node::Symbol(_))));
    let mut nest = Nest {
        plan,
        block: Block::new(&plan.graph, &read, reserved(model, plan)),
        levels: vec![NestLevel::default()],
        known: HashMap::new(),
        used,
        state: BranchState::Start,
        agreements: 0,
        graph,
    };
    let mut stages = 0;
    for step in &plan.steps {
        match step {
            PlanStep::Stage(stage) => {
                nest.stage(stages, stage);
                stages += 1;
            }
            PlanStep::Angle { symbol, meaning, y, x } => nest.angle(symbol, meaning, *y, *x),
            PlanStep::Agreement { meaning, unit, misses } => nest.agreement(meaning, *unit, misses),
            PlanStep::Swivel { joints, rotation, meaning, wrist, moved, axis, elbow } => {
                let joints = joints.map(|slot| plan.joint(slot).unwrap_or_default());
                nest.swivel(joints, rotation, meaning, [*wrist, *moved, *axis, *elbow]);
            }
        }
    }
    nest.values();
    nest.push();
    let Nest { mut graph, block, levels, used, agreements, .. } = nest;
    // The value of a given joint goes into every solution.
    let always = |input: &Input| matches!(input, Input::Given(_));
    let inputs = plan
        .task
        .inputs()
        .into_iter()
        .map(|input| (graph.symbol(input), input))
        .filter(|(slot, input)| used.contains(slot) || always(input))
        .collect();
    Inverse {
        graph,
        names: block.bound,
        constants: ArmConstants {
            stands_for: plan.has_virtual_joint().then(|| plan.last_solved()),
            wrist: plan.flip(),
            ..ArmConstants::of(model, plan.reach)
        },
        goal: plan.task.goal.clone(),
        given: plan.task.given.clone(),
        swivel: plan.task.swivel.clone(),
        inputs,
        levels,
        stages,
        agreements,
        joints: plan.joints(),
        capacity: plan.max_solutions(),
        decoupled: plan.is_decoupled(),
        in_doubt: plan.missed.is_some() || plan.lacks_a_turn(),
        off_table: plan.off_table,
        table_margins: plan.off_table.and_then(|_| margins(&solve::naming_table(plan)?)),
        held_joint: None,
        of_table: None,
    }
}

/// Names that the code around the expressions uses, before the label of a joint.
const PREFIXES: [&str; 7] = ["q", "index", "roots", "state", "elbow", "cone", "phase"];

/// Names that it uses as they are.
const NAMES: [&str; 14] = [
    "agreed",
    "nest",
    "locked",
    "nearest",
    "search",
    "solutions",
    "start",
    "target",
    "near",
    "arm",
    "goal",
    "frame",
    "swing",
    "wanted",
];

/// The size of an arm with run-time parameters.
const SIZES: [&str; 3] = ["reach", "constants", "length"];

fn reserved(model: &Model, plan: &Plan) -> Vec<String> {
    let labels =
        (1..=plan.joints()).map(|i| i.to_string()).chain(plan.loop_joints.iter().map(|slot| slot.label.to_string()));
    let of_joints = labels.flat_map(|label| PREFIXES.map(|prefix| format!("{prefix}{label}")));
    let sizes: &[&str] = if model.parameters.is_empty() { &[] } else { &SIZES };
    let lists: &[&str] = if plan.task.given.is_list { &["held"] } else { &[] };
    of_joints.chain(NAMES.iter().chain(sizes).chain(lists).map(|name| name.to_string())).collect()
}

impl Nest<'_> {
    fn deepest(&self) -> usize {
        self.levels.len().saturating_sub(1)
    }

    fn at(&mut self, level: usize, statement: Statement) {
        if let Some(level) = self.levels.get_mut(level) {
            level.body.push(statement);
        }
    }

    /// The level from which on an expression can be evaluated.
    fn level(&self, e: Slot) -> usize {
        let reachable = self.graph.reachable(&[e]);
        reachable.iter().filter_map(|x| self.known.get(x)).max().copied().unwrap_or(0)
    }

    /// Binds what the inputs share, each at its level. Returns the level of the inputs together.
    fn bind(&mut self, inputs: &[Slot]) -> usize {
        for e in self.block.bind(inputs) {
            let level = self.level(e);
            self.at(level, Statement::Let(e));
        }
        self.level_of(inputs)
    }

    fn level_of(&self, inputs: &[Slot]) -> usize {
        inputs.iter().map(|e| self.level(*e)).max().unwrap_or(0)
    }

    fn stage(&mut self, index: usize, stage: &Stage) {
        let level = self.bind(&stage.kernel.inputs());
        let (before, call) = call(self.plan, &self.graph, index, stage);
        for statement in before {
            let level = self.level_of(&statement.reads());
            self.at(level, statement);
        }
        self.at(level, Statement::Solve(call));
        let deepest = self.deepest();
        self.at(deepest, Statement::Follow { stage: index, before: self.state });
        self.state = BranchState::Stage(index);
        if stage.kernel.form().roots == 1 {
            let roots = self.roots(stage);
            self.at(deepest, Statement::Only { stage: index, roots });
        } else {
            self.levels.push(NestLevel::default());
            let roots = self.roots(stage);
            let joints = stage.joints.iter().map(|slot| self.plan.joint(*slot));
            let flips = self.plan.flip().is_some_and(|flip| joints.eq(flip.map(Some)));
            let each = Each { stage: index, state: self.state, roots, branching: stage.branching, flips };
            if let Some(level) = self.levels.last_mut() {
                level.each = Some(each);
            }
        }
    }

    /// Parts in use of a stage's roots.
    fn roots(&mut self, stage: &Stage) -> Vec<Root> {
        let level = self.deepest();
        let mut roots = Vec::new();
        for unknowns in &stage.unknowns {
            let mut root = Root::default();
            for unknown in unknowns {
                let symbol = self.graph.symbol(*unknown);
                if self.used.contains(&symbol) {
                    self.known.insert(symbol, level);
                    root.0.push((unknown.part, symbol));
                }
            }
            roots.push(root);
        }
        roots
    }

    fn angle(&mut self, symbol: &Symbol, meaning: &str, y: Slot, x: Slot) {
        let level = self.bind(&[y, x]);
        let symbol = self.graph.symbol(symbol.clone());
        self.at(level, Statement::Angle { symbol, y, x, meaning: meaning.to_string() });
        self.known.insert(symbol, level);
    }

    fn agreement(&mut self, meaning: &str, unit: Unit, misses: &[Slot]) {
        self.bind(misses);
        let (index, before, deepest) = (self.agreements, self.state, self.deepest());
        let (misses, meaning) = (misses.to_vec(), meaning.to_string());
        self.at(deepest, Statement::Agree { index, before, unit, misses, meaning });
        self.agreements += 1;
        self.state = BranchState::Agreed(index);
    }

    fn swivel(&mut self, joints: [usize; 2], rotation: &Mat3, meaning: &str, vectors: [[Slot; 3]; 4]) {
        let level = self.bind(&vectors.concat());
        let (before, meaning) = (self.state, meaning.to_string());
        self.at(level, Statement::Swivel { joints, symbols: *rotation, vectors, before, meaning });
        self.state = BranchState::Swung;
        for symbol in rotation.iter().flatten() {
            self.known.insert(*symbol, level);
        }
    }

    /// Joint values that are not a kernel's value as it is.
    fn values(&mut self) {
        for (slot, value) in self.plan.loop_joints.iter().zip(&self.plan.values) {
            let symbol = self.graph.symbol(Unknown::of(slot.label, Part::Value));
            let terms: Vec<(Slot, bool)> =
                value.terms.iter().map(|(term, negative)| (self.graph.symbol(term.clone()), *negative)).collect();
            if slot.label.arm().is_none() || terms.iter().any(|(term, _)| *term == symbol) {
                continue;
            }
            let level = terms.iter().filter_map(|(term, _)| self.known.get(term)).max().copied().unwrap_or(0);
            self.at(level, Statement::Value { symbol, terms, constant: value.constant });
        }
    }

    fn push(&mut self) {
        let q = (0..self.plan.joints()).map(|joint| self.graph.symbol(self.plan.value(joint))).collect();
        let (state, deepest) = (self.state, self.deepest());
        self.at(deepest, Statement::Push { state, q });
    }
}
