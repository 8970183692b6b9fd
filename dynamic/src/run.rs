//! One run of the inverse: the nest of a program, with the runtime's search.

use denhart::math;
use denhart::solve::{self, BranchState, Cone, DefaultValue, Elbow, Select, Turn};
use denhart::{Branch, Elbow as ElbowSide, Shoulder, Wrist};
use denhart_codegen::lower::{self, Branching, Call, Each, Given, Input, Root, Slot, Statement, Unit};
use denhart_codegen::model::MOST_JOINTS;

use crate::branches::Branches;
use crate::kernel::{AnyRoots, Known, MOST_ROOTS, Values, measure, solve, with_roots};
use crate::nest::{Nest, part};
use crate::tape::Registers;

/// The state of a run.
pub struct Run<'a> {
    nest: &'a Nest,
    registers: Registers,
    known: Vec<Known>,
    states: Vec<BranchState>,
    /// Sine and cosine of the arm angle, where that is given.
    swing: (f64, f64),
    /// The branch to follow; none for all of them.
    wanted: Option<Branch>,
}

impl<'a> Run<'a> {
    /// Before the first statement, with the target's numbers in their registers.
    ///
    /// `given`: the values beside the target. `number`: the other numbers of the target.
    pub fn new(nest: &'a Nest, given: &[f64], number: &dyn Fn(Input) -> f64, wanted: Option<Branch>) -> Self {
        let program = &nest.program;
        let mut swing = (f64::NAN, f64::NAN);
        let mut parts = [(f64::NAN, swing); MOST_JOINTS];
        for (kind, value) in program.given.values.iter().zip(given) {
            match *kind {
                Given::ArmAngle => swing = math::sin_cos(*value),
                Given::Joint { joint, revolute } => {
                    if let Some(place) = parts.get_mut(joint) {
                        *place = (*value, if revolute { math::sin_cos(*value) } else { swing });
                    }
                }
            }
        }
        let part = |joint: usize| parts.get(joint).copied().unwrap_or_default();
        let mut registers = nest.tape.registers();
        for (slot, input) in &program.inputs {
            let value = match *input {
                Input::Given(joint) => part(joint).0,
                Input::SinGiven(joint) => part(joint).1.0,
                Input::CosGiven(joint) => part(joint).1.1,
                other => number(other),
            };
            registers.set(nest.places.of(*slot), value);
        }
        Run { nest, registers, known: nest.known.clone(), states: Vec::new(), swing, wanted }
    }

    /// Follows all branches from their start.
    pub fn cascade(&mut self, search: &mut dyn Branches, start: BranchState) {
        self.states.clear();
        self.states.resize(self.nest.states(), start);
        self.level(0, Branch::NONE, search);
    }

    fn level(&mut self, depth: usize, branch: Branch, search: &mut dyn Branches) {
        let nest = self.nest;
        let Some(body) = nest.levels.get(depth) else { return };
        for (operations, statement) in &body.steps {
            nest.tape.run(operations.clone(), &mut self.registers);
            self.statement(statement, branch, search);
        }
        let Some(each) = nest.levels.get(depth + 1).and_then(|next| next.each.as_ref()) else { return };
        let (Some(state), wanted) = (self.state(each.state), self.root_wanted(each.branching)) else { return };
        let wanted = if each.flips { state.flips(wanted) } else { wanted };
        for number in 0..MOST_ROOTS {
            let Some(index) = self.take_root(each, &state, wanted, number) else { return };
            self.level(depth + 1, named(branch, each, index), search);
        }
    }

    /// Sets the registers of a loop's root to those of the next root; its index, or none after the last.
    fn take_root(&mut self, each: &Each, state: &BranchState, wanted: Option<usize>, number: usize) -> Option<usize> {
        let Run { nest, registers, known, .. } = self;
        with_roots!(known.get(each.stage)?.roots.as_ref()?, stage => {
            let (index, root) = stage.each(state, wanted).nth(number)?;
            take(registers, nest, &each.roots, root);
            Some(index)
        })
    }

    fn statement(&mut self, statement: &Statement, branch: Branch, search: &mut dyn Branches) {
        match statement {
            // The operations before it are all there is to do.
            Statement::Let(_) => {}
            Statement::Phase { stage, phase } => {
                let phase = Turn::direction(self.value(phase.y), self.value(phase.x));
                self.prepare(*stage, |known| known.phase = phase);
            }
            Statement::Elbow { stage, range, line } => {
                let [a, b, height] = range.inputs().map(|slot| self.value(slot));
                let elbow = Elbow::new(a, b, height);
                let elbow = line.map_or(elbow, |line| elbow.signed(self.value(line)));
                self.prepare(*stage, |known| known.elbow = elbow);
            }
            Statement::Cone { stage, range } => {
                let [along, across, cos, sin] = range.inputs().map(|slot| self.value(slot));
                let cone = Cone::new(along, across, cos, sin);
                self.prepare(*stage, |known| known.cone = cone);
            }
            Statement::Solve(call) => self.solve(call, search),
            Statement::Follow { stage, before } => {
                let Some(before) = self.state(*before) else { return };
                let roots = self.known.get(*stage).and_then(|known| known.roots.as_ref());
                // Without roots yet, the state stays.
                let after = roots.map_or(before, |roots| search.follow(*stage, &before, roots));
                self.set_state(lower::BranchState::Stage(*stage), after);
            }
            Statement::Only { stage, roots } => {
                let Run { nest, registers, known, .. } = self;
                if let Some(AnyRoots::OneOfOne(solved)) = known.get(*stage).and_then(|known| known.roots.as_ref()) {
                    take(registers, nest, roots, &solved.only());
                }
            }
            Statement::Angle { symbol, y, x, .. } => {
                let angle = math::atan2(self.value(*y), self.value(*x));
                self.set(*symbol, angle);
            }
            Statement::Agree { index, before, unit, misses, .. } => {
                let measure = measure(*unit, self.nest.program.constants.reach);
                let Some(mut state) = self.state(*before) else { return };
                for miss in misses {
                    state = search.agree(&state, measure, self.value(*miss));
                }
                self.set_state(lower::BranchState::Agreed(*index), state);
            }
            Statement::Swivel { joints, symbols, vectors, before, .. } => {
                let Some(before) = self.state(*before) else { return };
                let [wrist, moved, axis, elbow] = self.values().rows(vectors);
                let rotation = solve::swivel(wrist, moved, axis, elbow, self.swing);
                for (symbol, value) in symbols.iter().flatten().zip(rotation.iter().flatten()) {
                    self.set(*symbol, *value);
                }
                let length = measure(Unit::Length, self.nest.program.constants.reach);
                let defaults = joints.map(|joint| search.default(joint));
                let state = search.directed(&before, length, wrist, defaults);
                self.set_state(lower::BranchState::Swung, state);
            }
            Statement::Value { symbol, terms, constant } => {
                let add = |sum: Option<f64>, (term, negative): &(Slot, bool)| {
                    let value = self.value(*term);
                    Some(match (sum, negative) {
                        (None, false) => value,
                        (None, true) => -value,
                        (Some(sum), false) => sum + value,
                        (Some(sum), true) => sum - value,
                    })
                };
                let sum = terms.iter().fold(None, add).unwrap_or(0.0);
                let sum = if constant.is_zero() { sum } else { sum + constant.rad() };
                self.set(*symbol, solve::wrap(sum));
            }
            Statement::Push { state, q } => {
                let Some(state) = self.state(*state) else { return };
                let mut values = [f64::NAN; MOST_JOINTS];
                for (value, slot) in values.iter_mut().zip(q) {
                    *value = self.value(*slot);
                }
                search.push(&state, &values, branch);
            }
        }
    }

    fn solve(&mut self, call: &Call, search: &dyn Branches) {
        let defaults = call.defaults.map(|default| self.default(default, search));
        let reach = self.nest.program.constants.reach;
        let Run { nest, registers, known, .. } = self;
        let Some(known) = known.get_mut(call.stage) else { return };
        solve(call, defaults, known, reach, Values { places: &nest.places, registers });
    }

    fn default(&self, default: lower::DefaultValue, search: &dyn Branches) -> DefaultValue<f64> {
        let at = match default.joint {
            Some(joint) => search.default(joint),
            None => search.virtual_default(),
        };
        if default.shift.is_zero() { at } else { at.shifted(default.shift.rad()) }
    }

    fn values(&self) -> Values<'_> {
        Values { places: &self.nest.places, registers: &self.registers }
    }

    fn value(&self, slot: Slot) -> f64 {
        self.values().of(slot)
    }

    fn set(&mut self, slot: Slot, value: f64) {
        self.registers.set(self.nest.places.of(slot), value);
    }

    fn prepare(&mut self, stage: usize, set: impl FnOnce(&mut Known)) {
        if let Some(known) = self.known.get_mut(stage) {
            set(known);
        }
    }

    fn state(&self, state: lower::BranchState) -> Option<BranchState> {
        self.states.get(self.nest.state(state)).copied()
    }

    fn set_state(&mut self, state: lower::BranchState, value: BranchState) {
        if let Some(place) = self.states.get_mut(self.nest.state(state)) {
            *place = value;
        }
    }

    /// The root to follow; none for all of them.
    fn root_wanted(&self, branching: Branching) -> Option<usize> {
        let wanted = self.wanted?;
        match branching {
            Branching::None => None,
            Branching::Shoulder => Select::shoulder(wanted),
            Branching::Elbow => Select::elbow(wanted),
            Branching::Wrist => Select::wrist(wanted),
            Branching::Root => Select::root(wanted),
        }
    }
}

/// Sets the registers of a root.
fn take<const K: usize>(registers: &mut Registers, nest: &Nest, roots: &[Root], turns: &[Turn<f64>; K]) {
    for (Root(parts), turn) in roots.iter().zip(turns) {
        for (which, symbol) in parts {
            registers.set(nest.places.of(*symbol), part(turn, *which));
        }
    }
}

/// The branch with the name of a root.
fn named(branch: Branch, each: &Each, index: usize) -> Branch {
    match each.branching {
        Branching::None => branch,
        Branching::Shoulder => branch.with_shoulder(Shoulder::of_root(index)),
        Branching::Elbow => branch.with_elbow(ElbowSide::of_root(index)),
        Branching::Wrist => branch.with_wrist(Wrist::of_root(index)),
        Branching::Root => branch.with_root_index(index),
    }
}
