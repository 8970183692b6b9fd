//! Branches that are missed with a free joint at home, and where that joint has to be for them.

use super::place::{NODES, PLACES, Roots, Samples, node, stroke, turn};
use super::stage::State;
use super::{Facts, Tolerances};
use crate::math::wrap;
use crate::{Branch, JointMask};

/// A slide is sampled at home and this many reaches either way.
const STROKE: f64 = 2.0 / 3.0;

/// What a further run of the cascade is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pass {
    /// The level at one of three or five places of the first or second free joint; nothing is listed.
    Sample { second: bool, place: usize },
    /// The place of one open branch; again, with a stage after the one that misses.
    Open { index: usize, again: bool },
    /// The level of that stage at one of five nodes; nothing is listed.
    Node { index: usize, node: usize },
}

/// A branch that is still to be met.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Open<T> {
    branch: Branch,
    /// The first joint that is free or nearly so, and another one.
    joints: [JointMask; 2],
    /// The levels of the stage that misses.
    samples: Samples<T>,
    /// Those of the stage after that, and the interval in which the first one has roots.
    roots: Roots<T>,
    span: [T; 2],
    /// How far the free joints are from home at the branch's place, in turns or strokes.
    steps: [T; 2],
    /// Whether that place is known, and whether the stage has roots there.
    known: bool,
    feasible: bool,
    /// Whether a solution has been found there.
    met: bool,
    /// Where a joint that is nearly free has been, and how far it may move from there without moving the tool; infinite
    /// for a joint that is free.
    value: T,
    slack: T,
}

impl<T: Tolerances> Open<T> {
    const NONE: Self = Self {
        branch: Branch::NONE,
        joints: [JointMask::NONE; 2],
        samples: Samples::NONE,
        roots: Roots::NONE,
        span: [T::ZERO; 2],
        steps: [T::ZERO; 2],
        known: false,
        feasible: false,
        met: false,
        value: T::ZERO,
        slack: T::INFINITY,
    };

    /// Goes to a place of the interval: its middle and a share of half its width.
    fn go(&mut self, share: T) {
        let [middle, half] = self.span;
        let [first, _] = &mut self.steps;
        *first = (middle + half * share) / T::TAU;
    }

    /// Whether the stage that misses has roots in an interval.
    fn spans(&self) -> bool {
        let [_, half] = self.span;
        half > T::COINCIDENT
    }

    /// Whether two joints may move.
    fn two(&self) -> bool {
        let [_, second] = self.joints;
        !second.is_empty()
    }
}

/// The branches on which a joint is free or nearly so, and which are missed with that joint at home. Such a branch has
/// roots for an interval of the joint, or at one place alone: a stretched elbow that every other place of the joint
/// would have to stretch more. Three runs of the cascade tell the level of the stage that misses, and with that the
/// place. Behind a slide the level is of degree 2, and five runs tell it. Five more tell the level of a second stage,
/// where the first one alone does not lead to a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels<T, const M: usize> {
    /// Open branches, the first `len`.
    open: [Open<T>; M],
    len: usize,
    /// The joints that are free or nearly so on them.
    pub(super) free: JointMask,
    /// Of these the first ones, and others: those that either step moves.
    moving: [JointMask; 2],
    /// How far the free joints are from home in this pass, in turns or strokes.
    steps: [T; 2],
    /// Whether every level that misses is of degree 1 in its joint: no slide follows the joint.
    simple: bool,
}

impl<T: Tolerances, const M: usize> Levels<T, M> {
    pub(super) const NONE: Self = Self {
        open: [Open::NONE; M],
        len: 0,
        free: JointMask::NONE,
        moving: [JointMask::NONE; 2],
        steps: [T::ZERO; 2],
        simple: true,
    };

    fn open(&self) -> &[Open<T>] {
        self.open.get(..self.len).unwrap_or(&[])
    }

    fn open_mut(&mut self) -> &mut [Open<T>] {
        self.open.get_mut(..self.len).unwrap_or(&mut [])
    }

    /// Remembers a branch that is missed at home, at the joint vector `q`. `slack`: by how much a joint that is nearly
    /// free may move.
    #[inline(never)]
    pub(super) fn remember<const N: usize>(&mut self, state: &State<T>, branch: Branch, q: &[T; N], slack: T) {
        let level = state.level;
        self.simple &= level.low < T::ZERO && level.high < T::MAX && level.pole == T::ONE;
        if self.open().iter().any(|other| same(other.branch, branch, true)) {
            return;
        }
        let first = state.first.iter().next();
        let single = |joint: Option<usize>| joint.map_or(JointMask::NONE, JointMask::single);
        let joints = [single(first), single(state.loose().iter().find(|joint| Some(*joint) != first))];
        if let Some(slot) = self.open.get_mut(self.len) {
            let value = first.and_then(|joint| q.get(joint)).copied().unwrap_or(T::ZERO);
            (slot.branch, slot.joints, slot.value, slot.slack) = (branch, joints, value, slack);
            self.len += 1;
            self.free |= state.loose();
            for (moving, joint) in self.moving.iter_mut().zip(joints) {
                *moving |= joint;
            }
        }
    }

    /// Whether the solution at the end of a branch is to be verified in this pass, with the name of the open branch that
    /// it stands for. `listed` tells whether a branch has a solution.
    #[inline(never)]
    pub(super) fn takes(
        &mut self,
        pass: Pass,
        state: &State<T>,
        branch: Branch,
        listed: impl Fn(Branch) -> bool,
    ) -> Option<Branch> {
        match pass {
            Pass::Sample { place, .. } => {
                for exact in [true, false] {
                    for open in self.open_mut().iter_mut().filter(|open| same(open.branch, branch, exact)) {
                        open.samples.keep(place, &state.level, exact);
                    }
                }
                None
            }
            Pass::Node { index, node } => {
                let open = self.open_mut().get_mut(index);
                if let Some(open) = open.filter(|open| open.joints.contains(&state.first)) {
                    open.roots.keep(node, &state.then);
                }
                None
            }
            Pass::Open { index, again } => {
                let open = self.open().get(index)?;
                if !(again && open.joints.contains(&state.first) || same(open.branch, branch, false)) {
                    return None;
                }
                let name = open.branch.wrist().map_or(branch, |wrist| branch.with_wrist(wrist));
                (!listed(name)).then_some(name)
            }
        }
    }

    /// Where a joint stays in a pass, given its home.
    #[inline(never)]
    pub(super) fn away<const N: usize>(&self, facts: &Facts<T, N>, pass: Pass, joint: usize, home: T) -> T {
        let moved = self.moving.iter().zip(self.steps).find(|(moving, _)| moving.contains(joint));
        let step = moved.map_or(T::ZERO, |(_, step)| step);
        let slides = facts.prismatic.contains(joint);
        let step = match pass {
            Pass::Sample { place, .. } if !step.is_finite() && slides => stroke(place),
            Pass::Sample { second, place } if !step.is_finite() => turn::<T>(self.places(second), place) / T::TAU,
            _ => step,
        };
        if slides { home + facts.reach * T::from_f64(STROKE) * step } else { wrap(home + T::TAU * step) }
    }

    /// The number of places at which a joint is sampled: three for levels of degree 1, and for the second joint, so that
    /// all passes together keep to their bound.
    fn places(&self, second: bool) -> usize {
        if second || self.simple { 3 } else { PLACES }
    }

    /// The place of every open branch from the levels at the sampled places of a free joint.
    #[inline(never)]
    fn locate<const N: usize>(&mut self, facts: &Facts<T, N>, homes: &[T; N], second: bool) {
        let (steps, count) = (self.steps, self.places(second));
        for open in self.open_mut().iter_mut().filter(|open| !open.feasible) {
            let [one, other] = open.joints;
            let Some(joint) = (if second { other } else { one }).iter().next() else { continue };
            let home = homes.get(joint).copied().unwrap_or(T::ZERO);
            let now = if open.slack < T::INFINITY && !second { open.value } else { home };
            let place = if facts.prismatic.contains(joint) {
                open.samples.sliding((now - home) / (facts.reach * T::from_f64(STROKE)))
            } else {
                open.samples.turning(count, wrap(now - home), open.slack)
            };
            if second || place.is_none() {
                open.samples = Samples::NONE;
            }
            let Some(place) = place else { continue };
            let [first, _] = steps;
            open.steps = if second { [first, place.step] } else { [place.step, T::ZERO] };
            (open.known, open.span) = (true, place.span);
            open.feasible = place.feasible;
        }
    }

    /// The end of a pass; `met`: it has found a solution.
    #[inline(never)]
    pub(super) fn end<const N: usize>(&mut self, facts: &Facts<T, N>, homes: &[T; N], pass: Pass, met: bool) {
        match pass {
            Pass::Open { index, .. } => {
                if let Some(open) = self.open_mut().get_mut(index) {
                    open.met |= met;
                }
            }
            Pass::Sample { second, place } if place + 1 == self.places(second) => self.locate(facts, homes, second),
            Pass::Node { index, node } if node + 1 == NODES => {
                if let Some(open) = self.open_mut().get_mut(index)
                    && let Some(cosine) = open.roots.place(&open.samples, open.span)
                {
                    open.go(cosine);
                }
            }
            _ => {}
        }
    }

    /// The pass after one; the first after the pass at home.
    #[inline(never)]
    pub(super) fn after(&self, pass: Option<Pass>) -> Option<Pass> {
        let place = |from: usize| {
            let mut rest = self.open().iter().enumerate().skip(from);
            rest.find(|(_, open)| open.known).map(|(index, _)| Pass::Open { index, again: false })
        };
        let again = |from: usize| {
            let mut rest = self.open().iter().enumerate().skip(from);
            rest.find(|(_, open)| !open.met && open.spans()).map(|(index, _)| Pass::Node { index, node: 0 })
        };
        match pass {
            None => (self.len > 0).then_some(Pass::Sample { second: false, place: 0 }),
            Some(Pass::Sample { second, place }) if place + 1 < self.places(second) => {
                Some(Pass::Sample { second, place: place + 1 })
            }
            Some(Pass::Sample { second: false, .. }) if self.open().iter().any(|open| !open.feasible && open.two()) => {
                Some(Pass::Sample { second: true, place: 0 })
            }
            Some(Pass::Sample { .. }) => place(0),
            Some(Pass::Open { index, again: false }) => place(index + 1).or_else(|| again(0)),
            Some(Pass::Node { index, node }) if node + 1 < NODES => Some(Pass::Node { index, node: node + 1 }),
            Some(Pass::Node { index, .. }) => Some(Pass::Open { index, again: true }),
            Some(Pass::Open { index, again: true }) => again(index + 1),
        }
    }

    /// Moves the free joints to their places in a pass.
    #[inline(never)]
    pub(super) fn begin(&mut self, pass: Pass) {
        self.steps = match pass {
            Pass::Sample { second, .. } => {
                // The second joint, with the first one where the first open branch has it.
                let open = self.open().iter().find(|open| !open.feasible && open.two());
                let [first, _] = open.map_or([T::ZERO; 2], |open| open.steps);
                if second { [first, T::NAN] } else { [T::NAN, T::ZERO] }
            }
            Pass::Node { index, node: k } => {
                if let Some(open) = self.open_mut().get_mut(index) {
                    open.go(node(k));
                }
                self.open().get(index).map_or([T::ZERO; 2], |open| open.steps)
            }
            Pass::Open { index, .. } => self.open().get(index).map_or([T::ZERO; 2], |open| open.steps),
        };
    }
}

/// Whether two names are those of one branch, whichever way the elbow bends, and without `wrist` whichever way the
/// wrist does.
fn same(a: Branch, b: Branch, wrist: bool) -> bool {
    a.shoulder() == b.shoulder() && a.root() == b.root() && (!wrist || a.wrist() == b.wrist())
}
