//! The nest of loops over the roots of a plan's stages, ready to run.

use std::ops::Range;

use denhart_codegen::lower::{BranchState, Each, Inverse, NestLevel, Part, Root, RootRange, Statement};

use crate::kernel::Known;
use crate::tape::{Compiler, Places, Tape};

/// The nest: the statements of the program, each after the operations that it needs.
#[derive(Debug, Clone)]
pub struct Nest {
    pub tape: Tape,
    pub places: Places,
    pub levels: Vec<Body>,
    /// State of each stage before the first statement, from constant ranges.
    pub known: Vec<Known>,
    pub program: Inverse,
}

/// The body of a loop.
#[derive(Debug, Clone)]
pub struct Body {
    pub each: Option<Each>,
    pub steps: Vec<(Range<usize>, Statement)>,
}

impl Nest {
    /// That of a program.
    pub fn new(program: &Inverse) -> Self {
        let statements = || program.levels.iter().flat_map(|level| &level.body);
        let mut compiler = Compiler::new(&program.graph, &statements().flat_map(Statement::reads).collect::<Vec<_>>());
        for (slot, _) in &program.inputs {
            compiler.leaf(*slot);
        }
        let mut known = vec![Known::NOTHING; program.stages];
        let mut levels = Vec::new();
        for NestLevel { each, body } in &program.levels {
            if let Some(each) = each {
                leaves(&mut compiler, &each.roots);
            }
            let mut steps = Vec::new();
            for statement in body {
                let start = compiler.len();
                compiler.work_out(&statement.reads());
                define(&mut compiler, statement);
                if let Statement::Solve(call) = statement
                    && let Some(known) = known.get_mut(call.stage)
                {
                    match call.range {
                        RootRange::Elbow { max, min, .. } => (known.elbow.max, known.elbow.min) = (max, min),
                        RootRange::Cone { max, min } => (known.cone.max, known.cone.min) = (max, min),
                        RootRange::None | RootRange::Prepared => {}
                    }
                }
                steps.push((start..compiler.len(), statement.clone()));
            }
            levels.push(Body { each: each.clone(), steps });
        }
        let (tape, places) = compiler.finish();
        Nest { tape, places, levels, known, program: program.clone() }
    }

    /// The place of a state among all states.
    pub fn state(&self, state: BranchState) -> usize {
        match state {
            BranchState::Start => 0,
            BranchState::Swung => 1,
            BranchState::Stage(stage) => 2 + stage,
            BranchState::Agreed(index) => 2 + self.program.stages + index,
        }
    }

    /// How many states there are.
    pub fn states(&self) -> usize {
        2 + self.program.stages + self.program.agreements
    }
}

/// Gives registers to what a statement defines.
fn define(compiler: &mut Compiler, statement: &Statement) {
    match statement {
        Statement::Only { roots, .. } => leaves(compiler, roots),
        Statement::Angle { symbol, .. } | Statement::Value { symbol, .. } => {
            compiler.leaf(*symbol);
        }
        Statement::Swivel { symbols, .. } => {
            for symbol in symbols.iter().flatten() {
                compiler.leaf(*symbol);
            }
        }
        _ => {}
    }
}

fn leaves(compiler: &mut Compiler, roots: &[Root]) {
    for (_, symbol) in roots.iter().flat_map(|Root(parts)| parts) {
        compiler.leaf(*symbol);
    }
}

/// One part of a turn: its value, sine or cosine.
pub fn part(turn: &denhart::solve::Turn<f64>, part: Part) -> f64 {
    match part {
        Part::Value => turn.value,
        Part::Sin => turn.sin,
        Part::Cos => turn.cos,
    }
}
