//! The nest of an inverse, made ready for lanes.
//!
//! A statement names its registers here, constant ranges have registers as computed ones do, and the first root of a
//! stage goes to the registers that the statements after it read.

use std::ops::Range;

use denhart::JointKind;
use denhart::batch::LaneMeasure;
use denhart_codegen::lower::kernel::{Align, Flip, Offset, OffsetOfTwo, Slide, SlideTo, Wrist};
use denhart_codegen::lower::{
    self, ArmConstants, BranchState, Counted, Input, Inverse, Kernel, Part, Root, Slot, Statement, Unit,
};

use crate::nest::Nest;
use crate::tape::{Operation, Register};

/// Registers of the values, sines and cosines of up to three joints of a root; [`NONE`] for a part that nobody reads.
pub type RootRegisters = [[Register; 3]; 3];

/// No register.
pub const NONE: Register = Register::MAX;

/// The most roots of a stage that lanes follow.
pub const LANE_ROOTS: usize = 2;

/// The nest for lanes.
#[derive(Debug)]
pub struct Plan {
    pub operations: Vec<Operation>,
    /// Values of the registers before the first operation.
    pub start: Vec<f64>,
    pub levels: Vec<LaneLevel>,
    pub inputs: Vec<(Register, Input)>,
    /// How many states there are; the first one is that of the start.
    pub states: usize,
    pub stages: usize,
    pub reach: f64,
    /// The joints whose limits a solution may be outside of.
    pub limited: Vec<(usize, [f64; 2])>,
    /// Limits of sums of joint values.
    pub combined: Vec<SumLimit>,
}

/// Joints with their factors, and the range of their sum.
pub type SumLimit = (Vec<(usize, f64)>, [f64; 2]);

/// The body of a loop over the roots of a stage.
#[derive(Debug)]
pub struct LaneLevel {
    pub each: Option<Each>,
    pub steps: Vec<Step>,
}

/// The loop.
#[derive(Debug)]
pub struct Each {
    pub stage: usize,
    pub state: usize,
    /// Copies that make each root the one to go on with.
    pub roots: [Vec<(Register, Register)>; LANE_ROOTS],
}

/// A statement, after the operations that it needs.
#[derive(Debug)]
pub struct Step {
    pub operations: Range<usize>,
    pub action: Action,
}

/// Effect of a statement.
// A plan has a few of them, and lanes read them in order: no reason for a box.
#[allow(clippy::large_enum_variant)]
#[derive(Debug)]
pub enum Action {
    Nothing,
    Solve { stage: usize, equation: Equation, counted: Count, to: [RootRegisters; LANE_ROOTS], gap: Register },
    Phase { y: Register, x: Register, to: [Register; 3] },
    Elbow { inputs: [Register; 3], line: Option<Register>, to: [Register; 3] },
    Cone { inputs: [Register; 4], to: [Register; 4] },
    Follow { stage: usize, before: usize, after: usize, gap: Register },
    Angle { y: Register, x: Register, to: Register },
    Agree { before: usize, after: usize, rounding: f64, misses: Vec<Register> },
    Value { terms: Vec<(Register, bool)>, constant: Option<f64>, to: Register },
    Push { state: usize, q: Vec<Register> },
}

/// An equation that has a lane form.
#[derive(Debug)]
pub enum Equation {
    Offset { measure: LaneMeasure, abd: [Register; 3] },
    OffsetOfTwo { lengths: LaneMeasure, directions: LaneMeasure, length: [Register; 3], direction: [Register; 3] },
    Distance { measure: LaneMeasure, rho: Register, elbow: [Register; 3] },
    Cone { measure: LaneMeasure, d: Register, rho: Register, cone: [Register; 4] },
    Align { measure: LaneMeasure, from: [Register; 2], to: [Register; 2] },
    Flip { m: [Register; 3] },
    Wrist { m: [[Register; 3]; 3] },
    Slide { measure: LaneMeasure, inputs: [Register; 3] },
    SlideTo { inputs: [Register; 2] },
}

/// Where an angle is counted from.
#[derive(Debug, Clone, Copy)]
pub enum Count {
    FromZero,
    TurnedBack(Register),
    FromPhase([Register; 3]),
}

/// Registers of a stage beside those of its expressions.
#[derive(Debug, Clone, Copy)]
struct Prepared {
    elbow: [Register; 3],
    cone: [Register; 4],
    phase: [Register; 3],
    gap: Register,
    roots: [RootRegisters; LANE_ROOTS],
}

impl Plan {
    /// The plan of a program; `None` if it has a statement without a lane form, or if every branch is verified.
    pub fn of(program: &Inverse, kinds: &[JointKind]) -> Option<Self> {
        if program.held_joint.is_some() || program.in_doubt || program.off_table.is_some() {
            return None;
        }
        Builder::new(Nest::new(program)).plan(kinds)
    }
}

struct Builder {
    nest: Nest,
    start: Vec<f64>,
    prepared: Vec<Prepared>,
}

impl Builder {
    fn new(nest: Nest) -> Self {
        let (_, start) = nest.tape.parts();
        let mut this = Builder { start: start.to_vec(), prepared: Vec::new(), nest };
        for known in this.nest.known.clone() {
            let elbow = [known.elbow.max, known.elbow.min, known.elbow.side].map(|value| this.fresh(value));
            let ([a, b], [c, d]) = (known.cone.max, known.cone.min);
            let cone = [a, b, c, d].map(|value| this.fresh(value));
            let phase = [0.0, 0.0, 1.0].map(|value| this.fresh(value));
            let gap = this.fresh(0.0);
            this.prepared.push(Prepared { elbow, cone, phase, gap, roots: [[[NONE; 3]; 3]; LANE_ROOTS] });
        }
        this
    }

    fn fresh(&mut self, value: f64) -> Register {
        self.start.push(value);
        self.start.len() - 1
    }

    fn at(&self, slot: Slot) -> Register {
        self.nest.places.of(slot)
    }

    fn all<const K: usize>(&self, slots: &[Slot; K]) -> [Register; K] {
        slots.map(|slot| self.at(slot))
    }

    fn state(&self, state: BranchState) -> usize {
        self.nest.state(state)
    }

    fn measure(&self, unit: Unit) -> LaneMeasure {
        let ArmConstants { reach, length, angle, .. } = self.nest.program.constants;
        match unit {
            Unit::Length => LaneMeasure::new(reach, length),
            Unit::Direction => LaneMeasure::new(1.0, angle),
        }
    }

    fn plan(mut self, kinds: &[JointKind]) -> Option<Plan> {
        let loops = self.loops()?;
        let bodies = self.nest.levels.clone();
        let mut levels = Vec::new();
        for (body, each) in bodies.iter().zip(loops) {
            let mut steps = Vec::new();
            for (operations, statement) in &body.steps {
                steps.push(Step { operations: operations.clone(), action: self.action(statement)? });
            }
            levels.push(LaneLevel { each, steps });
        }
        let constants = &self.nest.program.constants;
        // An angle of (-pi, pi] is within limits that are a whole turn.
        let turn = |joint: usize, [low, high]: [f64; 2]| {
            let revolute = kinds.get(joint) == Some(&JointKind::Revolute);
            revolute && low <= -core::f64::consts::PI && high >= core::f64::consts::PI
        };
        let limited = (0..)
            .zip(constants.limits.iter().copied())
            .filter(|(joint, limits)| limits.iter().any(|limit| limit.is_finite()) && !turn(*joint, *limits));
        let factors =
            |factors: &[f64]| (0..).zip(factors.iter().copied()).filter(|(_, factor)| *factor != 0.0).collect();
        Some(Plan {
            operations: self.nest.tape.parts().0.to_vec(),
            levels,
            inputs: self.nest.program.inputs.iter().map(|(slot, input)| (self.at(*slot), *input)).collect(),
            states: self.nest.states(),
            stages: self.nest.program.stages,
            reach: constants.reach,
            limited: limited.collect(),
            combined: constants.combined.iter().map(|(sum, range)| (factors(sum), *range)).collect(),
            start: self.start,
        })
    }

    /// The loop of each level, and the registers of the roots of every stage.
    fn loops(&mut self) -> Option<Vec<Option<Each>>> {
        let levels = self.nest.levels.clone();
        let mut solved = vec![0; self.nest.program.stages];
        let mut loops = Vec::new();
        for (depth, body) in levels.iter().enumerate() {
            let each = match &body.each {
                None => None,
                Some(each) => {
                    // Solved in the body before, the stage is solved anew before each time the loop begins.
                    let first_in_place = solved.get(each.stage).is_some_and(|at| at + 1 == depth);
                    Some(self.each(each, first_in_place)?)
                }
            };
            loops.push(each);
            for (_, statement) in &body.steps {
                match statement {
                    Statement::Solve(call) => *solved.get_mut(call.stage)? = depth,
                    Statement::Only { stage, roots } => {
                        let in_place = self.registers(roots)?;
                        self.prepared.get_mut(*stage)?.roots = [in_place, [[NONE; 3]; 3]];
                    }
                    _ => {}
                }
            }
        }
        Some(loops)
    }

    fn each(&mut self, each: &lower::Each, first_in_place: bool) -> Option<Each> {
        let read = self.registers(&each.roots)?;
        let mut roots = [Vec::new(), Vec::new()];
        let mut registers = [read; LANE_ROOTS];
        for (number, (copies, registers)) in roots.iter_mut().zip(&mut registers).enumerate() {
            if number == 0 && first_in_place {
                continue;
            }
            for register in registers.iter_mut().flatten().filter(|register| **register != NONE) {
                let to = *register;
                *register = self.fresh(0.0);
                copies.push((*register, to));
            }
        }
        self.prepared.get_mut(each.stage)?.roots = registers;
        Some(Each { stage: each.stage, state: self.state(each.state), roots })
    }

    /// Registers that a root goes to; `None` for one of more than three joints.
    fn registers(&self, roots: &[Root]) -> Option<RootRegisters> {
        let mut registers = [[NONE; 3]; 3];
        if roots.len() > registers.len() {
            return None;
        }
        for (registers, Root(parts)) in registers.iter_mut().zip(roots) {
            let [value, sin, cos] = registers;
            for (part, slot) in parts {
                match part {
                    Part::Value => *value = self.at(*slot),
                    Part::Sin => *sin = self.at(*slot),
                    Part::Cos => *cos = self.at(*slot),
                }
            }
        }
        Some(registers)
    }

    fn action(&self, statement: &Statement) -> Option<Action> {
        Some(match statement {
            Statement::Let(_) | Statement::Only { .. } => Action::Nothing,
            Statement::Phase { stage, phase } => {
                Action::Phase { y: self.at(phase.y), x: self.at(phase.x), to: self.prepared.get(*stage)?.phase }
            }
            Statement::Elbow { stage, range, line } => Action::Elbow {
                inputs: self.all(&range.inputs()),
                line: line.map(|line| self.at(line)),
                to: self.prepared.get(*stage)?.elbow,
            },
            Statement::Cone { stage, range } => {
                Action::Cone { inputs: self.all(&range.inputs()), to: self.prepared.get(*stage)?.cone }
            }
            Statement::Solve(call) => {
                let Prepared { phase, gap, roots, .. } = *self.prepared.get(call.stage)?;
                let counted = match call.counted {
                    Counted::FromZero => Count::FromZero,
                    Counted::TurnedBack(slot) => Count::TurnedBack(self.at(slot)),
                    Counted::FromPhase => Count::FromPhase(phase),
                };
                Action::Solve { stage: call.stage, equation: self.equation(call)?, counted, to: roots, gap }
            }
            Statement::Follow { stage, before } => Action::Follow {
                stage: *stage,
                before: self.state(*before),
                after: self.state(BranchState::Stage(*stage)),
                gap: self.prepared.get(*stage)?.gap,
            },
            Statement::Angle { symbol, y, x, .. } => {
                Action::Angle { y: self.at(*y), x: self.at(*x), to: self.at(*symbol) }
            }
            Statement::Agree { index, before, unit, misses, .. } => Action::Agree {
                before: self.state(*before),
                after: self.state(BranchState::Agreed(*index)),
                rounding: LaneMeasure::new(self.measure(*unit).scale, 0.0).tolerance,
                misses: misses.iter().map(|slot| self.at(*slot)).collect(),
            },
            // The direction of a swing has no lane form.
            Statement::Swivel { .. } => return None,
            Statement::Value { symbol, terms, constant } => Action::Value {
                terms: terms.iter().map(|(slot, negative)| (self.at(*slot), *negative)).collect(),
                constant: (!constant.is_zero()).then(|| constant.rad()),
                to: self.at(*symbol),
            },
            Statement::Push { state, q } => {
                Action::Push { state: self.state(*state), q: q.iter().map(|slot| self.at(*slot)).collect() }
            }
        })
    }

    fn equation(&self, call: &lower::Call) -> Option<Equation> {
        let measure = self.measure(call.unit);
        let Prepared { elbow, cone, .. } = *self.prepared.get(call.stage)?;
        Some(match &call.kernel {
            Kernel::Offset(Offset { a, b, d }) => Equation::Offset { measure, abd: self.all(&[*a, *b, *d]) },
            Kernel::OffsetOfTwo(OffsetOfTwo { length, direction }) => Equation::OffsetOfTwo {
                lengths: measure,
                directions: self.measure(Unit::Direction),
                length: self.all(length),
                direction: self.all(direction),
            },
            Kernel::Distance(kernel) => Equation::Distance { measure, rho: self.at(kernel.rho), elbow },
            Kernel::Cone(kernel) => Equation::Cone { measure, d: self.at(kernel.d), rho: self.at(kernel.rho), cone },
            Kernel::Align(Align { from, to }) => Equation::Align { measure, from: self.all(from), to: self.all(to) },
            Kernel::Flip(Flip { m }) => Equation::Flip { m: self.all(m) },
            Kernel::Wrist(Wrist { m }) => Equation::Wrist { m: m.each_ref().map(|row| self.all(row)) },
            Kernel::Slide(Slide { rho, across, middle }) => {
                Equation::Slide { measure, inputs: self.all(&[*rho, *across, *middle]) }
            }
            Kernel::SlideTo(SlideTo { denominator, numerator }) => {
                Equation::SlideTo { inputs: self.all(&[*denominator, *numerator]) }
            }
            // Stages of more roots, of quartics, and the quadratic of a slide: few arms have them.
            _ => return None,
        })
    }
}
