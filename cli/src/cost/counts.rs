//! Counts of an arm's programs, from which the estimates are made.

use std::collections::{BTreeMap, HashMap};

use denhart_codegen::Program;
use denhart_codegen::lower::{Function, Goal, Inverse, Kernel, Level, Node, Root, Slot, Statement};

/// Counts of one function, by name. Each function of a kind has the same names.
pub type Counts = Vec<(&'static str, usize)>;

/// Stands for one program of all functions but `inverse_branch`.
pub const TOGETHER: &str = "together";

/// The counts of each function of an arm.
pub struct Sheet {
    /// By function.
    pub functions: Vec<(&'static str, Counts)>,
    /// Calls of kernels for an ordinary target, all branches, by kernel.
    pub kernels: BTreeMap<&'static str, usize>,
    /// The largest number of solutions, 0 without an inverse.
    pub branches: usize,
}

/// The counts of an arm.
pub fn counts(program: &Program) -> Sheet {
    let joints = program.model.joints.len();
    let mut functions = vec![
        ("forward", straight(&program.functions.forward, joints)),
        ("forward_and_jacobian", straight(&program.functions.both, joints)),
    ];
    let Ok(inverse) = &program.inverse else { return Sheet { functions, kernels: BTreeMap::new(), branches: 0 } };
    let all = Walk::of(inverse, |kernel| kernel.form().roots);
    let one = Walk::of(inverse, |_| 1);
    functions.push(("inverse", all.counts(inverse)));
    functions.push(("inverse_near", all.counts(inverse)));
    functions.push(("inverse_branch", one.counts(inverse)));
    functions.push((TOGETHER, all.counts(inverse)));
    Sheet { functions, kernels: all.kernels, branches: inverse.capacity }
}

fn straight(function: &Function, joints: usize) -> Counts {
    let graph = &function.straight.graph;
    let nodes = graph.reachable(&function.straight.roots);
    let arithmetic =
        nodes.into_iter().filter(|slot| works(graph.node(*slot)) && graph.constant(*slot).is_none()).count();
    vec![("one", 1), ("joints", joints), ("sin_cos", function.turned.len()), ("arithmetic", arithmetic)]
}

fn works(node: Node) -> bool {
    matches!(node, Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Sqrt(_))
}

/// How often the parts of an inverse are run.
#[derive(Default)]
struct Walk {
    /// Calls of kernels.
    kernels: BTreeMap<&'static str, usize>,
    /// Calls of kernels by their cost: one root, two, a wrist, a quartic.
    classes: [usize; 4],
    /// Additions, multiplications and roots outside the kernels.
    arithmetic: usize,
    /// Additions, multiplications and roots outside the kernels, each statement of the code counted once.
    written: usize,
    /// Angles that are measured.
    angles: usize,
    /// Solutions.
    pushed: usize,
}

impl Walk {
    /// With so many roots of each kernel.
    fn of(inverse: &Inverse, roots: fn(&Kernel) -> usize) -> Self {
        let mut walk = Self::default();
        let kernels: HashMap<usize, &Kernel> = inverse
            .levels
            .iter()
            .flat_map(|level| &level.body)
            .filter_map(|statement| match statement {
                Statement::Solve(call) => Some((call.stage, &call.kernel)),
                _ => None,
            })
            .collect();
        // How often each level is run, and at which level each leaf is known.
        let mut times = Vec::new();
        let mut known: HashMap<Slot, usize> = HashMap::new();
        let mut read = Vec::new();
        for (index, level) in inverse.levels.iter().enumerate() {
            let outside = times.last().copied().unwrap_or(1);
            let each = level.each.as_ref();
            let inside = each.and_then(|each| kernels.get(&each.stage)).map_or(1, |kernel| roots(kernel));
            let now: usize = outside * inside;
            times.push(now);
            known.extend(given(level).into_iter().map(|slot| (slot, index)));
            for statement in &level.body {
                read.extend(statement.reads());
                match statement {
                    Statement::Solve(call) => {
                        let (name, class) = kind(&call.kernel);
                        *walk.kernels.entry(name).or_default() += now;
                        if let Some(class) = walk.classes.get_mut(class) {
                            *class += now;
                        }
                    }
                    Statement::Angle { .. } | Statement::Swivel { .. } => walk.angles += now,
                    Statement::Push { .. } => walk.pushed += now,
                    _ => {}
                }
            }
        }
        let mut level_of: HashMap<Slot, usize> = HashMap::new();
        for slot in inverse.graph.reachable(&read) {
            // Operands come before what is made of them.
            let of = |operand: &Slot| level_of.get(operand).copied().unwrap_or(0);
            let level = match inverse.graph.node(slot) {
                Node::Symbol(_) => known.get(&slot).copied().unwrap_or(0),
                _ => inverse.graph.operands(slot).iter().map(of).max().unwrap_or(0),
            };
            level_of.insert(slot, level);
            if works(inverse.graph.node(slot)) && inverse.graph.constant(slot).is_none() {
                walk.arithmetic += times.get(level).copied().unwrap_or(1);
                walk.written += 1;
            }
        }
        walk
    }

    fn counts(&self, inverse: &Inverse) -> Counts {
        let [one_root, two_roots, wrists, quartics] = self.classes;
        let is = usize::from;
        vec![
            ("one", 1),
            ("one_root", one_root),
            ("two_roots", two_roots),
            ("wrists", wrists),
            ("quartics", quartics),
            ("arithmetic", self.arithmetic),
            ("angles", self.angles),
            ("values", self.pushed * inverse.joints),
            ("list", inverse.capacity * (inverse.joints + 4)),
            ("written", self.written),
            ("stages", inverse.stages),
            ("joints", inverse.joints),
            ("pose", is(inverse.goal == Goal::Pose)),
            ("coupled", is(!inverse.decoupled)),
            ("has_quartic", is(quartics > 0)),
            ("agreements", inverse.agreements),
        ]
    }
}

/// The leaves that a level gives values.
fn given(level: &Level) -> Vec<Slot> {
    let of = |roots: &[Root]| roots.iter().flat_map(|Root(parts)| parts.iter().map(|(_, slot)| *slot)).collect();
    let mut slots: Vec<Slot> = level.each.as_ref().map_or_else(Vec::new, |each| of(&each.roots));
    for statement in &level.body {
        match statement {
            Statement::Only { roots, .. } => slots.extend::<Vec<Slot>>(of(roots)),
            Statement::Angle { symbol, .. } | Statement::Value { symbol, .. } => slots.push(*symbol),
            Statement::Swivel { symbols, .. } => slots.extend(symbols.iter().flatten()),
            _ => {}
        }
    }
    slots
}

/// The name of a kernel, and its class.
fn kind(kernel: &Kernel) -> (&'static str, usize) {
    match kernel {
        Kernel::Align(_) => ("align", 0),
        Kernel::SlideTo(_) => ("slide_to", 0),
        Kernel::Offset(_) => ("offset", 1),
        Kernel::OffsetOfTwo(_) => ("offset_of_two", 1),
        Kernel::Distance(_) => ("distance", 1),
        Kernel::Cone(_) => ("cone", 1),
        Kernel::Flip(_) => ("flip", 1),
        Kernel::Slide(_) => ("slide", 1),
        Kernel::SlideTurning(_) => ("slide_turning", 1),
        Kernel::Aim(_) => ("aim", 1),
        Kernel::Quadratic(_) => ("quadratic", 1),
        Kernel::Wrist(_) => ("wrist", 2),
        Kernel::Pair(_) => ("pair", 3),
        Kernel::PairSliding(_) => ("pair_sliding", 3),
    }
}
