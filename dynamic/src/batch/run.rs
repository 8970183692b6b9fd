//! The nest of an inverse over a block of targets.

use denhart::Pose;
use denhart::batch::{self, BLOCK, LaneRoots, Lanes, Row, math};
use denhart::solve::{Cone, Elbow, Turn};
use denhart_codegen::lower::Input;

use super::plan::{Action, Count, Equation, LANE_ROOTS, Plan, RootRegisters, Step};
use super::rows::{Rows, lanes_of};
use super::straight::signed;
use crate::tape::Register;

/// Bodies of loops that a nest goes through at most: more than the roots of all stages together allow.
const MOST_BODIES: usize = 4096;

/// Where solutions go.
pub trait Sink {
    /// Takes a joint vector for every lane of the mask. Returns the lanes that are in doubt after that.
    fn push<L: Lanes>(&mut self, set: L::Set, plan: &Plan, rows: &Rows, q: &[Register], alive: u32) -> u32;
}

/// The state of a block.
pub struct Run<'a> {
    plan: &'a Plan,
    pub rows: Rows,
    /// The numbers of a pose, each of all targets.
    pub columns: [Row; 12],
    states: Vec<u32>,
    /// Lanes of each stage that have ended, that are in doubt, and that have each root.
    stages: Vec<Stage>,
    /// Lanes in doubt.
    pub doubt: u32,
    /// The least gap of a branch that has ended; negative where none has.
    pub least: Row,
    /// The next root of each loop.
    next: Vec<usize>,
}

#[derive(Clone, Copy)]
struct Stage {
    ended: u32,
    doubt: u32,
    present: [u32; LANE_ROOTS],
}

impl<'a> Run<'a> {
    /// Memory for blocks.
    pub fn new(plan: &'a Plan) -> Self {
        let stage = Stage { ended: 0, doubt: 0, present: [0; LANE_ROOTS] };
        Run {
            plan,
            rows: Rows::new(&plan.start),
            columns: [Row::all(0.0); 12],
            states: vec![0; plan.states],
            stages: vec![stage; plan.stages],
            doubt: 0,
            least: Row::all(-1.0),
            next: vec![0; plan.levels.len()],
        }
    }

    /// Lanes whose target, a pose, is ordinary.
    #[inline(always)]
    pub fn ordinary<L: Lanes>(&self, set: L::Set, strokes: &Row) -> u32 {
        let mut ordinary = 0;
        for at in 0..BLOCK / L::WIDTH {
            let of = |row: &Row| L::load(set, row, at);
            let [a, b, c, d, e, f, g, h, i, x, y, z] = &self.columns;
            let rotation = [[of(a), of(b), of(c)], [of(d), of(e), of(f)], [of(g), of(h), of(i)]];
            let pose = Pose { rotation, translation: [of(x), of(y), of(z)] };
            let mask = batch::ordinary(&pose, of(strokes), self.plan.reach);
            ordinary |= L::bits(mask) << (at * L::WIDTH);
        }
        ordinary
    }

    /// Reach of the arm.
    pub fn reach(&self) -> f64 {
        self.plan.reach
    }

    /// The registers of the inputs.
    #[inline]
    pub fn inputs(&self) -> &'a [(Register, Input)] {
        &self.plan.inputs
    }

    /// Follows every branch of the lanes of the mask.
    #[inline(always)]
    pub fn cascade<L: Lanes>(&mut self, set: L::Set, start: u32, sink: &mut impl Sink) {
        let plan = self.plan;
        self.least = Row::all(-1.0);
        self.doubt = 0;
        if let Some(state) = self.states.first_mut() {
            *state = start;
        }
        let (mut depth, mut alive) = (0, start);
        for _ in 0..MOST_BODIES {
            if alive & !self.doubt != 0
                && let Some(level) = plan.levels.get(depth)
            {
                for step in &level.steps {
                    alive = self.step::<L>(set, step, alive, sink);
                }
                depth += 1;
                if let Some(next) = self.next.get_mut(depth) {
                    *next = 0;
                }
            }
            // The next root of the innermost loop that has one.
            for _ in 0..MOST_BODIES {
                let (Some(level), Some(next)) = (plan.levels.get(depth), self.next.get_mut(depth)) else {
                    let Some(up) = depth.checked_sub(1) else { return };
                    depth = up;
                    continue;
                };
                let Some(each) = &level.each else { return };
                let Some(copies) = each.roots.get(*next) else {
                    let Some(up) = depth.checked_sub(1) else { return };
                    depth = up;
                    continue;
                };
                let stage = self.stages.get(each.stage);
                let present = stage.and_then(|stage| stage.present.get(*next)).copied().unwrap_or(0);
                *next += 1;
                alive = self.states.get(each.state).copied().unwrap_or(0) & present;
                if alive & !self.doubt == 0 {
                    continue;
                }
                for (from, to) in copies {
                    self.rows.copy(*from, *to);
                }
                break;
            }
        }
        // Never: the branches left are left to single calls.
        self.doubt = start;
    }

    /// Does a statement; returns the lanes that go on.
    #[inline(always)]
    fn step<L: Lanes>(&mut self, set: L::Set, step: &Step, alive: u32, sink: &mut impl Sink) -> u32 {
        if let Some(operations) = self.plan.operations.get(step.operations.clone()) {
            self.rows.run::<L>(set, operations);
        }
        match &step.action {
            Action::Nothing => {}
            Action::Solve { stage, equation, counted, to, gap } => {
                let solved = self.solve::<L>(set, equation, *counted, to, *gap);
                if let Some(place) = self.stages.get_mut(*stage) {
                    *place = solved;
                }
            }
            Action::Follow { stage, before, after, gap } => {
                // The state is that before the loop over roots: lanes without the root that is followed have it, too.
                let before = self.states.get(*before).copied().unwrap_or(0) & alive;
                let Some(Stage { ended, doubt, .. }) = self.stages.get(*stage).copied() else { return 0 };
                self.doubt |= doubt & before;
                for lane in lanes_of(ended & before & !self.doubt) {
                    self.misses(lane, *gap);
                }
                let goes_on = before & !ended & !doubt;
                if let Some(state) = self.states.get_mut(*after) {
                    *state = goes_on;
                }
                return goes_on;
            }
            Action::Phase { y, x, to: [value, sin, cos] } => {
                let mut doubt = 0;
                for at in 0..BLOCK / L::WIDTH {
                    let (y, x): (L, L) = (self.rows.load(set, *y, at), self.rows.load(set, *x, at));
                    let (turn, unsure) = Turn::direction_lanes(y, x);
                    self.rows.store(*value, at, turn.value);
                    self.rows.store(*sin, at, turn.sin);
                    self.rows.store(*cos, at, turn.cos);
                    doubt |= L::bits(unsure) << (at * L::WIDTH);
                }
                self.doubt |= doubt & alive;
            }
            Action::Elbow { inputs, line, to: [max, min, side] } => {
                for at in 0..BLOCK / L::WIDTH {
                    let [a, b, height]: [L; 3] = self.rows.all(set, inputs, at);
                    let mut elbow = Elbow::new_lanes(a, b, height);
                    if let Some(line) = line {
                        elbow = elbow.signed_lanes(self.rows.load(set, *line, at));
                    }
                    self.rows.store(*max, at, elbow.max);
                    self.rows.store(*min, at, elbow.min);
                    self.rows.store(*side, at, elbow.side);
                }
            }
            Action::Cone { inputs, to } => {
                for at in 0..BLOCK / L::WIDTH {
                    let [along, across, cos, sin]: [L; 4] = self.rows.all(set, inputs, at);
                    let Cone { max: [a, b], min: [c, d] } = Cone::new_lanes(along, across, cos, sin);
                    for (register, value) in to.iter().zip([a, b, c, d]) {
                        self.rows.store(*register, at, value);
                    }
                }
            }
            Action::Angle { y, x, to } => {
                let mut doubt = 0;
                for at in 0..BLOCK / L::WIDTH {
                    let (y, x): (L, L) = (self.rows.load(set, *y, at), self.rows.load(set, *x, at));
                    let (angle, unusual) = math::atan2(y, x);
                    self.rows.store(*to, at, angle);
                    doubt |= L::bits(unusual) << (at * L::WIDTH);
                }
                self.doubt |= doubt & alive;
            }
            Action::Agree { before, after, rounding, misses } => {
                let mut agreed = u32::MAX;
                for miss in misses {
                    for at in 0..BLOCK / L::WIDTH {
                        let miss: L = self.rows.load(set, *miss, at);
                        let misses = L::not(miss.abs().at_most(miss.of(*rounding)));
                        agreed &= !(L::bits(misses) << (at * L::WIDTH));
                    }
                }
                let before = self.states.get(*before).copied().unwrap_or(0) & alive;
                self.doubt |= before & !agreed;
                if let Some(state) = self.states.get_mut(*after) {
                    *state = before & agreed;
                }
                return before & agreed;
            }
            Action::Value { terms, constant, to } => {
                let mut doubt = 0;
                for at in 0..BLOCK / L::WIDTH {
                    let mut sum = None;
                    for (term, negative) in terms {
                        sum = Some(signed(sum, self.rows.load(set, *term, at), *negative));
                    }
                    let sum: L = sum.unwrap_or(L::all(set, 0.0));
                    let sum = constant.map_or(sum, |constant| sum + sum.of(constant));
                    let (wrapped, far) = math::wrap(sum);
                    self.rows.store(*to, at, wrapped);
                    doubt |= L::bits(far) << (at * L::WIDTH);
                }
                self.doubt |= doubt & alive;
            }
            Action::Push { state, q } => {
                let alive = self.states.get(*state).copied().unwrap_or(0) & !self.doubt & alive;
                if alive != 0 {
                    self.doubt |= sink.push::<L>(set, self.plan, &self.rows, q, alive) & alive;
                }
            }
        }
        alive
    }

    /// Solves a stage.
    #[inline(always)]
    fn solve<L: Lanes>(
        &mut self,
        set: L::Set,
        equation: &Equation,
        counted: Count,
        to: &[RootRegisters; LANE_ROOTS],
        gap: Register,
    ) -> Stage {
        let mut stage = Stage { ended: 0, doubt: 0, present: [0; LANE_ROOTS] };
        macro_rules! each_vector {
            ($at:ident => $roots:expr) => {
                for $at in 0..BLOCK / L::WIDTH {
                    let roots = $roots;
                    put(&mut self.rows, $at, &roots, to, gap, &mut stage);
                }
            };
        }
        match equation {
            Equation::Offset { measure, abd } => each_vector!(at => {
                let [a, b, d]: [L; 3] = self.rows.all(set, abd, at);
                batch::offset_lanes(set, *measure, a, b, d)
            }),
            Equation::OffsetOfTwo { lengths, directions, length, direction } => each_vector!(at => {
                let (length, direction): ([L; 3], _) =
                    (self.rows.all(set, length, at), self.rows.all(set, direction, at));
                batch::offset_of_two_lanes(set, *lengths, *directions, length, direction)
            }),
            Equation::Distance { measure, rho, elbow } => each_vector!(at => {
                let rho: L = self.rows.load(set, *rho, at);
                let [max, min, side] = self.rows.all(set, elbow, at);
                let roots = batch::distance_lanes(set, *measure, rho, Elbow { max, min, side });
                self.counted(set, roots, counted, at)
            }),
            Equation::Cone { measure, d, rho, cone } => each_vector!(at => {
                let (d, rho): (L, L) = (self.rows.load(set, *d, at), self.rows.load(set, *rho, at));
                let [a, b, c, e] = self.rows.all(set, cone, at);
                let roots = batch::cone_lanes(set, *measure, d, rho, Cone { max: [a, b], min: [c, e] });
                self.counted(set, roots, counted, at)
            }),
            Equation::Align { measure, from, to: onto } => each_vector!(at => {
                let (from, onto): ([L; 2], _) = (self.rows.all(set, from, at), self.rows.all(set, onto, at));
                batch::align_lanes(set, *measure, from, onto)
            }),
            Equation::Flip { m } => each_vector!(at => batch::flip_lanes::<L>(set, self.rows.all(set, m, at))),
            Equation::Wrist { m: [a, b, c] } => each_vector!(at => {
                let m = [self.rows.all(set, a, at), self.rows.all(set, b, at), self.rows.all(set, c, at)];
                batch::wrist_lanes::<L>(set, m)
            }),
            Equation::Slide { measure, inputs } => each_vector!(at => {
                let [rho, across, middle]: [L; 3] = self.rows.all(set, inputs, at);
                batch::slide_lanes(set, *measure, rho, across, middle)
            }),
            Equation::SlideTo { inputs } => each_vector!(at => {
                let [denominator, numerator]: [L; 2] = self.rows.all(set, inputs, at);
                batch::slide_to_lanes(set, denominator, numerator)
            }),
        }
        stage
    }

    /// The roots with the angle counted from where it is.
    #[inline(always)]
    fn counted<L: Lanes>(&self, set: L::Set, roots: LaneRoots<L, 1, 2>, from: Count, at: usize) -> LaneRoots<L, 1, 2> {
        match from {
            Count::FromZero => roots,
            Count::TurnedBack(register) => roots.turned_back(self.rows.load(set, register, at)),
            Count::FromPhase(phase) => {
                let [value, sin, cos] = self.rows.all(set, &phase, at);
                roots.about(Turn { value, sin, cos })
            }
        }
    }

    /// Notes that a branch of a lane has ended.
    #[inline]
    fn misses(&mut self, lane: usize, gap: Register) {
        let gap = self.rows.row(gap).and_then(|row| row.0.get(lane)).copied();
        if let (Some(gap), Some(least)) = (gap, self.least.0.get_mut(lane)) {
            let gap = if gap.is_finite() { gap } else { f64::MAX };
            *least = if *least < 0.0 { gap } else { least.min(gap) };
        }
    }
}

/// Writes the roots of a stage to their registers, and its masks.
#[inline(always)]
fn put<L: Lanes, const K: usize, const R: usize>(
    rows: &mut Rows,
    at: usize,
    roots: &LaneRoots<L, K, R>,
    to: &[RootRegisters; LANE_ROOTS],
    gap: Register,
    stage: &mut Stage,
) {
    for (root, to) in roots.roots.iter().zip(to) {
        for (turn, [value, sin, cos]) in root.iter().zip(to) {
            // A part that nobody reads has no register, and is not stored.
            rows.store(*value, at, turn.value);
            rows.store(*sin, at, turn.sin);
            rows.store(*cos, at, turn.cos);
        }
    }
    let shift = at * L::WIDTH;
    let ended = L::bits(roots.ended);
    if ended != 0 {
        rows.store(gap, at, roots.gap);
    }
    stage.ended |= ended << shift;
    stage.doubt |= L::bits(roots.doubt) << shift;
    for (present, mask) in stage.present.iter_mut().zip(roots.present) {
        *present |= L::bits(mask) << shift;
    }
}
