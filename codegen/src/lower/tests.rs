//! Properties of every program of the arms in `specs/`.
#![allow(clippy::unwrap_used)]

use super::{BranchState, Functions, Inverse, Node, Root, Slot, Statement, Straight};
use crate::Program;
use crate::program;
use crate::symbolic::Graph;
use std::collections::HashSet;
use std::fs;
use std::path::Path;

fn programs() -> Vec<(String, Program)> {
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let files = fs::read_dir(specs).unwrap().map(|entry| entry.unwrap().path());
    let of = |path: &Path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let program = program(&fs::read_to_string(path).unwrap(), &name).unwrap();
        (name, program)
    };
    files.map(|path| of(&path)).collect()
}

/// The leaves of some expressions whose value is known at run time only.
fn leaves(graph: &Graph, slots: &[Slot]) -> Vec<Slot> {
    let is_leaf = |slot: &Slot| matches!(graph.node(*slot), Node::Symbol(_)) && graph.constant(*slot).is_none();
    graph.reachable(slots).into_iter().filter(is_leaf).collect()
}

#[test]
fn functions_read_joint_values_and_their_sines_alone() {
    for (name, program) in programs() {
        let Functions { forward, jacobian, both, links } = &program.functions;
        for function in [forward, jacobian, both, links] {
            let Straight { graph, roots, .. } = &function.straight;
            let sines = function.turned.iter().flat_map(|turned| [turned.pair.sin, turned.pair.cos]);
            let known: HashSet<Slot> = sines.chain(function.joints.iter().copied()).collect();
            assert!(leaves(graph, roots).iter().all(|leaf| known.contains(leaf)), "{name}");
        }
    }
}

/// Slots, states and stages that have a value so far.
#[derive(Default)]
struct Known {
    slots: HashSet<Slot>,
    trails: HashSet<BranchState>,
    solved: HashSet<usize>,
    prepared: HashSet<usize>,
}

impl Known {
    fn take(&mut self, roots: &[Root]) {
        self.slots.extend(roots.iter().flat_map(|Root(parts)| parts).map(|(_, slot)| *slot));
    }

    fn read(&self, inverse: &Inverse, slots: &[Slot], what: &str) {
        for leaf in leaves(&inverse.graph, slots) {
            assert!(self.slots.contains(&leaf), "{what}: {:?} has no value yet", inverse.graph.leaf_name(leaf));
        }
    }

    fn after(&mut self, inverse: &Inverse, statement: &Statement, name: &str) {
        let what = format!("{name}, {statement:?}");
        match statement {
            Statement::Let(slot) => self.read(inverse, &[*slot], &what),
            Statement::Phase { stage, phase } => {
                self.read(inverse, &[phase.y, phase.x], &what);
                self.prepared.insert(*stage);
            }
            Statement::Elbow { stage, range, .. } => {
                self.read(inverse, &[range.a, range.b, range.height], &what);
                self.prepared.insert(*stage);
            }
            Statement::Cone { stage, range } => {
                self.read(inverse, &[range.along, range.across, range.cos, range.sin], &what);
                self.prepared.insert(*stage);
            }
            Statement::Solve(call) => {
                self.read(inverse, &call.kernel.inputs(), &what);
                let waits = call.range == super::RootRange::Prepared || call.counted == super::Counted::FromPhase;
                assert!(!waits || self.prepared.contains(&call.stage), "{what}");
                self.solved.insert(call.stage);
            }
            Statement::Follow { stage, before } => {
                assert!(self.solved.contains(stage) && self.trails.contains(before), "{what}");
                self.trails.insert(BranchState::Stage(*stage));
            }
            Statement::Only { stage, roots } => {
                assert!(self.solved.contains(stage), "{what}");
                self.take(roots);
            }
            Statement::Angle { symbol, y, x, .. } => {
                self.read(inverse, &[*y, *x], &what);
                self.slots.insert(*symbol);
            }
            Statement::Agree { index, before, misses, .. } => {
                self.read(inverse, misses, &what);
                assert!(self.trails.contains(before), "{what}");
                self.trails.insert(BranchState::Agreed(*index));
            }
            Statement::Swivel { symbols, vectors, before, .. } => {
                self.read(inverse, &vectors.concat(), &what);
                assert!(self.trails.contains(before), "{what}");
                self.trails.insert(BranchState::Swung);
                self.slots.extend(symbols.iter().flatten());
            }
            Statement::Value { symbol, terms, .. } => {
                let terms: Vec<Slot> = terms.iter().map(|(term, _)| *term).collect();
                self.read(inverse, &terms, &what);
                self.slots.insert(*symbol);
            }
            Statement::Push { state, q } => {
                self.read(inverse, q, &what);
                assert!(self.trails.contains(state) && q.len() == inverse.joints, "{what}");
            }
        }
    }
}

#[test]
fn everything_has_a_value_before_it_is_read() {
    let mut inverses = 0;
    for (name, program) in programs() {
        let Ok(inverse) = &program.inverse else { continue };
        // An inverse that holds a joint has no statements.
        if inverse.held_joint.is_some() {
            assert!(inverse.levels.is_empty(), "{name}");
            continue;
        }
        inverses += 1;
        let mut known = Known::default();
        known.slots.extend(inverse.inputs.iter().map(|(slot, _)| *slot));
        known.trails.insert(BranchState::Start);
        for (depth, level) in inverse.levels.iter().enumerate() {
            assert_eq!(level.each.is_some(), depth > 0, "{name}: which levels are loops");
            if let Some(each) = &level.each {
                assert!(known.solved.contains(&each.stage) && known.trails.contains(&each.state), "{name}: {each:?}");
                known.take(&each.roots);
            }
            for statement in &level.body {
                known.after(inverse, statement, &name);
            }
        }
        let last = inverse.levels.last().unwrap().body.last();
        assert!(matches!(last, Some(Statement::Push { .. })), "{name}: {last:?}");
    }
    assert!(inverses > 40, "{inverses}");
}
