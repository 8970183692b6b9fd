//! `check` for a processor: what the generator knows of the code of an arm before it is flashed, and what the
//! code of the most similar arm takes that was measured.

use std::collections::{BTreeMap, HashMap};

use denhart::effort::{MOST_CASCADES, MOST_EVALUATIONS, MOST_HELD_JOINT_EVALUATIONS, MOST_PLACES};
use denhart_codegen::Program;
use denhart_codegen::lower::{Inverse, Statement};
use serde_json::{Map, Value, json};

use super::Processor;
use crate::presets::preset;

/// Measurements, a line for each arm and function: `ur5 forward 2700 260 448`.
const CORTEX_M4F: &str = include_str!("cortex-m4f.txt");

/// Measured quantities of a function, in the order of their columns, and their names for people.
const QUANTITIES: [[&str; 2]; 3] =
    [["flash", "bytes of flash"], ["stack", "bytes of stack"], ["instructions", "instructions"]];

/// Stands for one program of several functions.
const TOGETHER: &str = "together";

/// Kernels, branches and bound of an arm's inverse, and a measured arm to compare the arm with.
#[derive(Debug)]
pub struct Cost {
    table: &'static str,
    kind: Kind,
    /// The largest number of solutions, 0 without an inverse.
    branches: usize,
    /// The measured arm, and true if the plans are of the same kind.
    measured: Option<(&'static str, bool)>,
}

/// Kind of a plan: its task, how often each kernel is called for an ordinary target, and whether the search for places
/// of free joints is linked. Without an inverse there are none of them.
#[derive(Debug, PartialEq)]
struct Kind {
    task: &'static str,
    kernels: BTreeMap<&'static str, usize>,
    decoupled: bool,
    holds_a_joint: bool,
}

impl Kind {
    fn of(program: &Program) -> Self {
        let inverse = program.inverse.as_ref().ok();
        let task = inverse.map_or("", |inverse| inverse.goal.task().name());
        let decoupled = inverse.is_some_and(|inverse| inverse.decoupled);
        let holds_a_joint = inverse.is_some_and(|inverse| inverse.held_joint.is_some());
        Self { task, kernels: inverse.map(kernels).unwrap_or_default(), decoupled, holds_a_joint }
    }
}

impl Cost {
    /// Of an arm. The measured arm is the one of the same kind whose pose and Jacobian take the most similar number of
    /// operations. If none is of that kind, all arms are compared.
    pub fn new(program: &Program, processor: Processor) -> Self {
        let table = match processor {
            Processor::CortexM4f => CORTEX_M4F,
        };
        let kind = Kind::of(program);
        let nearest = rows(table).filter(|[_, function, ..]| *function == "forward").filter_map(|[arm, ..]| {
            let other = denhart_codegen::program(preset(arm).ok()?.arm_file, arm).ok()?;
            let differs = Kind::of(&other) != kind;
            Some(((differs, operations(&other).abs_diff(operations(program))), arm))
        });
        let measured = nearest.min().map(|((differs, _), arm)| (arm, !differs));
        let branches = program.inverse.as_ref().map_or(0, |inverse| inverse.capacity);
        Self { table, kind, branches, measured }
    }

    /// The functions that the measured arm stands for. Pose and Jacobian depend on the kind of no plan.
    fn functions(&self) -> impl Iterator<Item = (&'static str, [&'static str; 3])> {
        let (arm, alike) = self.measured.unwrap_or_default();
        let inverse = alike && self.branches > 0;
        let rows = rows(self.table).filter(move |[row, function, ..]| {
            *row == arm && (inverse || matches!(*function, "forward" | "forward_and_jacobian"))
        });
        rows.map(|[_, function, values @ ..]| (function, values))
    }

    /// The lines for people.
    pub fn text(&self) -> String {
        let mut lines = vec!["on a Cortex-M4F, in f32, opt-level 3, feature `fpu`:".to_owned()];
        let [places, evaluations] = self.bound();
        if self.kind.holds_a_joint {
            lines.push(format!("  inverse: at most {} solutions, a joint held", self.branches));
            lines.push(format!(
                "  bound of any call: {evaluations} evaluations of forward_and_jacobian; {places} places of a held joint \
                 for its polynomial"
            ));
        } else if self.branches > 0 {
            let plural = if self.branches == 1 { "" } else { "es" };
            lines.push(format!("  inverse: at most {} branch{plural}", self.branches));
            let kernels: Vec<String> =
                self.kind.kernels.iter().map(|(name, calls)| format!("{name} {calls}")).collect();
            lines.push(format!("  calls of kernels for an ordinary target: {}", kernels.join(", ")));
            lines.push(format!(
                "  bound of any call: {places} cascades, {evaluations} evaluations of forward_and_jacobian"
            ));
        }
        if let Some((arm, alike)) = self.measured {
            let why = match (self.branches, alike) {
                (0, _) => "the nearest arm by operations",
                (_, true) => "the nearest arm of the same kind of plan",
                (_, false) => "the nearest arm by operations; no arm of the same kind of plan is measured",
            };
            lines.push(format!("  measured for {arm}, {why}:"));
        }
        for (function, values) in self.functions() {
            let values = values.into_iter().zip(QUANTITIES).rev().filter(|(value, _)| *value != "-");
            let values: Vec<String> = values.map(|(value, [_, quantity])| format!("{value} {quantity}")).collect();
            let name = if function == TOGETHER { "one program without inverse_branch" } else { function };
            lines.push(format!("    {name}: {}", values.join(", ")));
        }
        lines.join("\n")
    }

    /// The bound of a call: runs of the cascade, or places of each held joint; evaluations of the arm.
    fn bound(&self) -> [usize; 2] {
        match self.kind.holds_a_joint {
            true => [MOST_PLACES, MOST_HELD_JOINT_EVALUATIONS],
            false => [MOST_CASCADES, MOST_EVALUATIONS],
        }
    }

    /// Branches, kernels, bound and measured arm as JSON.
    pub fn json(&self) -> Value {
        let functions = self.functions().map(|(function, values)| {
            let values = values.into_iter().zip(QUANTITIES);
            let values =
                values.filter_map(|(value, [name, _])| Some((name.to_owned(), json!(value.parse::<u64>().ok()?))));
            (function.to_owned(), Value::Object(values.collect()))
        });
        let functions: Map<String, Value> = functions.collect();
        let [places, evaluations] = self.bound();
        let runs = if self.kind.holds_a_joint { "places" } else { "cascades" };
        json!({
            "branches": self.branches,
            "kernels": self.kind.kernels,
            "bound": {runs: places, "evaluations": evaluations},
            "measured": self.measured.map(|(arm, _)| json!({"arm": arm, "functions": functions})),
        })
    }
}

/// The rows of a table: arm, function, and a column for each quantity.
fn rows(table: &str) -> impl Iterator<Item = [&str; 5]> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split(' ').collect::<Vec<_>>().try_into().ok())
}

/// Calls of each kernel for an ordinary target, all branches.
fn kernels(inverse: &Inverse) -> BTreeMap<&'static str, usize> {
    let (mut calls, mut roots, mut times) = (BTreeMap::new(), HashMap::new(), 1);
    for level in &inverse.levels {
        // A level is run for each root of a stage of the levels before.
        times *= level.each.as_ref().and_then(|each| roots.get(&each.stage)).copied().unwrap_or(1);
        for statement in &level.body {
            if let Statement::Solve(call) = statement {
                let form = call.kernel.form();
                roots.insert(call.stage, form.roots);
                *calls.entry(form.function).or_default() += times;
            }
        }
    }
    calls
}

/// Operations of pose and Jacobian together.
fn operations(program: &Program) -> usize {
    let function = &program.functions.both.straight;
    function.graph.reachable(&function.roots).len()
}
