//! The inverse of many targets: blocks in lanes, targets in doubt by single calls.

use denhart::batch::{BLOCK, Found, Lanes, LeftOut, Row, Summary, Work};
use denhart::{Flags, Status, math};
use denhart_codegen::lower::{Given, Inverse};
use denhart_codegen::model::MOST_JOINTS;

use super::plan::Plan;
use super::rows::{first, lanes_of, of_lane};
use super::run::Run;
use super::sink::{All, Nearest};
use super::target::{Beside, target};
use crate::DynamicSolutions;
use crate::solver::{Asked, Solve};

/// After a block whose lanes were all in doubt so many blocks at most take single calls before lanes are tried again.
const MOST_LEFT_OUT: usize = 256;

/// The targets of a batch, and where their solutions go. `NEAR`: only the nearest one, within the limits.
pub struct Targets<'a, const NEAR: bool> {
    pub plan: Option<&'a Plan>,
    pub program: &'a Inverse,
    pub solver: &'a dyn Solve,
    pub targets: &'a [f64],
    pub width: usize,
    /// References, with so many joint values a target; none without `NEAR`.
    pub references: &'a [f64],
    /// Values beside the targets, as the solver takes them, with so many a target.
    pub given: &'a [f64],
    pub limits: &'a [[f64; 2]],
    /// Joint values.
    pub q: &'a mut [f64],
    /// How many a target.
    pub row: usize,
    pub found: &'a mut [Found],
}

/// Part of the slices.
struct Block<'b> {
    targets: &'b [f64],
    references: &'b [f64],
    given: &'b [f64],
    q: &'b mut [f64],
    found: &'b mut [Found],
}

impl<const NEAR: bool> Work for Targets<'_, NEAR> {
    type Output = Summary;

    #[inline(always)]
    fn run<L: Lanes>(mut self, set: L::Set) -> Summary {
        let mut single = Single::new(self.program, self.solver, self.width, self.references.is_empty());
        let (q, found) = (core::mem::take(&mut self.q), core::mem::take(&mut self.found));
        let mut summary = Summary::default();
        let Some(plan) = self.plan else {
            let all = Block { targets: self.targets, references: self.references, given: self.given, q, found };
            single.lanes(all, u32::MAX, &mut summary, self.row, true);
            return summary;
        };
        let joints = self.program.joints;
        let beside = self.program.given.values.len();
        let mut run = Run::new(plan);
        let mut nearest = Reference::new(self.program);
        let mut left_out = LeftOut::up_to(MOST_LEFT_OUT);
        let mut given = self.given.chunks((beside * BLOCK).max(1));
        let mut references = self.references.chunks((joints * BLOCK).max(1));
        let blocks = self.targets.chunks((self.width * BLOCK).max(1));
        for ((targets, q), found) in blocks.zip(q.chunks_mut((self.row * BLOCK).max(1))).zip(found.chunks_mut(BLOCK)) {
            let (given, references) = (given.next().unwrap_or(&[]), references.next().unwrap_or(&[]));
            let block = Block { targets, references, given, q: &mut *q, found: &mut *found };
            let all = first(block.found.len());
            if !left_out.takes_lanes() {
                single.lanes(block, all, &mut summary, self.row, false);
                continue;
            }
            let value = |lane: usize, kind: &Given| given_value(self.program, given, references, lane, kind);
            let mut ordinary =
                run.read::<L>(set, targets, self.width, &Beside { program: self.program, values: &value }) & all;
            if NEAR {
                ordinary &= nearest.read(references);
            }
            let mut doubt = all;
            if ordinary != 0 {
                for found in block.found.iter_mut() {
                    *found = Found::NOTHING;
                }
                if NEAR {
                    let mut sink = Nearest {
                        references: nearest.rows.get(..joints).unwrap_or(&nearest.rows),
                        weights: &nearest.weights,
                        limits: self.limits,
                        best: [Row::all(0.0); MOST_JOINTS],
                        distance: Row::all(0.0),
                        exists: 0,
                        listed: 0,
                    };
                    run.cascade::<L>(set, ordinary, &mut sink);
                    doubt = all & (!ordinary | run.doubt);
                    let Nearest { best, exists, listed, .. } = sink;
                    for lane in lanes_of(all & !doubt) {
                        let place = block.q.chunks_exact_mut(self.row.max(1)).nth(lane).zip(block.found.get_mut(lane));
                        let Some((q, found)) = place else { continue };
                        found.status = status(exists >> lane & 1 != 0, of_lane(&run.least, lane), plan.reach);
                        if listed >> lane & 1 != 0 {
                            found.count = 1;
                            if let Some(flags) = found.flags.first_mut() {
                                *flags = Flags::EXACT;
                            }
                            for (place, row) in q.iter_mut().zip(&best) {
                                *place = of_lane(row, lane);
                            }
                        }
                        summary.add(found);
                    }
                } else {
                    let mut sink = All { q: &mut *block.q, width: self.row, found: &mut *block.found };
                    run.cascade::<L>(set, ordinary, &mut sink);
                    doubt = all & (!ordinary | run.doubt);
                    for lane in lanes_of(all & !doubt) {
                        let Some(found) = block.found.get_mut(lane) else { continue };
                        found.status = status(found.count != 0, of_lane(&run.least, lane), plan.reach);
                        summary.reached += usize::from(found.count != 0);
                    }
                }
            }
            left_out.note(doubt == all);
            if doubt != 0 {
                single.lanes(block, doubt, &mut summary, self.row, false);
            }
        }
        summary
    }
}

/// The status of an ordinary target, as the search sets it.
#[inline]
fn status(reached: bool, least: f64, reach: f64) -> Status<f64> {
    if reached {
        return Status::Reachable;
    }
    Status::Unreachable { residual: if least > 0.0 { least } else { reach } }
}

/// A value beside a target: the one that is given, or that of the reference.
#[inline]
fn given_value(program: &Inverse, given: &[f64], references: &[f64], lane: usize, kind: &Given) -> f64 {
    let kinds = &program.given.values;
    let value = match (references, *kind) {
        ([_, ..], Given::Joint { joint, .. }) => references.get(lane * program.joints + joint),
        _ => {
            let place = kinds.iter().position(|other| other == kind);
            place.and_then(|place| given.get(lane * kinds.len() + place))
        }
    };
    let value = value.copied().unwrap_or(f64::NAN);
    match *kind {
        Given::Joint { revolute: true, .. } if references.is_empty() => math::wrap(value),
        _ => value,
    }
}

/// References of a block, by joint.
struct Reference {
    rows: [Row; MOST_JOINTS],
    weights: Vec<(f64, Option<f64>)>,
    /// The greatest magnitude of each joint's reference.
    most: Vec<f64>,
}

impl Reference {
    fn new(program: &Inverse) -> Self {
        let constants = &program.constants;
        let slides = |joint: usize| constants.prismatic.contains(&joint);
        Reference {
            rows: [Row::all(0.0); MOST_JOINTS],
            weights: (0..)
                .zip(&constants.weights)
                .map(|(joint, weight)| (*weight, slides(joint).then_some(constants.reach)))
                .collect(),
            most: (0..program.joints)
                .map(|joint| if slides(joint) { f64::MAX } else { <f64 as denhart::solve::Tolerances>::MOST_WOUND })
                .collect(),
        }
    }

    /// Takes the references of a block; returns the lanes whose joint vector can be one.
    #[inline(never)]
    fn read(&mut self, references: &[f64]) -> u32 {
        let mut fine = u32::MAX;
        for (lane, q) in references.chunks_exact(self.most.len().max(1)).enumerate() {
            for ((row, most), q) in self.rows.iter_mut().zip(&self.most).zip(q) {
                if let Some(place) = row.0.get_mut(lane) {
                    *place = *q;
                }
                // What is not a number is no reference.
                let can_refer = q.abs() <= *most;
                fine &= !(u32::from(!can_refer) << (lane % BLOCK));
            }
        }
        fine
    }
}

/// Targets by single calls.
struct Single<'a> {
    program: &'a Inverse,
    solver: &'a dyn Solve,
    width: usize,
    /// Every solution is listed, not the nearest one alone.
    all: bool,
    list: DynamicSolutions,
    given: Vec<f64>,
}

impl<'a> Single<'a> {
    fn new(program: &'a Inverse, solver: &'a dyn Solve, width: usize, all: bool) -> Self {
        let given = vec![f64::NAN; program.given.values.len()];
        Single { program, solver, width, all, list: DynamicSolutions::default(), given }
    }

    /// The targets of the lanes of a mask, or all of a slice that may be longer than a block.
    #[cold]
    #[inline(never)]
    fn lanes(&mut self, block: Block<'_>, mask: u32, summary: &mut Summary, row: usize, every: bool) {
        let Block { targets, references, given, q, found } = block;
        let joints = self.program.joints.max(1);
        let places = targets.chunks_exact(self.width.max(1)).zip(q.chunks_exact_mut(row.max(1))).zip(found);
        for (lane, ((numbers, q), found)) in places.enumerate() {
            if !every && (lane >= BLOCK || mask >> lane & 1 == 0) {
                continue;
            }
            for (place, kind) in self.given.iter_mut().zip(&self.program.given.values) {
                *place = given_value(self.program, given, references, lane, kind);
            }
            let Some(target) = target(&self.program.goal, numbers) else { continue };
            let near = references.get(lane * joints..(lane + 1) * joints).filter(|_| !self.all);
            let asked = Asked { near, ..Asked::all(&target, &self.given) };
            self.solver.solve(&asked, &mut self.list);
            *found = Found { status: self.list.status(), deviation: self.list.deviation(), ..Found::NOTHING };
            found.scalar = true;
            let most = if self.all { usize::MAX } else { 1 };
            let listed = self.list.iter().filter(|solution| self.all || solution.is_within_limits()).take(most);
            for ((solution, q), flags) in listed.zip(q.chunks_exact_mut(joints)).zip(&mut found.flags) {
                for (place, value) in q.iter_mut().zip(solution.q.iter()) {
                    *place = *value;
                }
                *flags = solution.flags;
                found.count += 1;
            }
            summary.add(found);
        }
    }
}
