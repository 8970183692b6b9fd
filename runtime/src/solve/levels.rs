//! Branches that are missed with a free joint at its default, and where that joint has to be for them.

use super::arm_constants::ArmConstants;
use super::doubts::Doubts;
use super::kernel::level::Behind;
use super::kernel::tolerances::Tolerances;
use super::open::{LEVELS, Open, same};
use super::place::{Elsewhere, PLACES, stroke, turn};
use super::second_level::{NODES, node};
use super::two_joints;
use crate::effort::MOST_CASCADES;
use crate::math::wrap;
use crate::{Branch, JointMask};

/// Open branches whose joints are placed together at most: the defaults, three places, six runs and these make all
/// cascades.
const MOST_TOGETHER: usize = MOST_CASCADES - 1 - two_joints::PLACES - two_joints::RUNS;
/// A slide is sampled at its default and this many reaches either way.
const STROKE: f64 = 2.0 / 3.0;

/// The purpose of a further run of the cascade.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pass {
    /// The level at one of three or five places of the first or second free joint; nothing is listed.
    Sample { second: bool, place: usize },
    /// A place of one open branch.
    Open { index: usize, round: Round },
    /// The level of a second stage at one of five nodes; nothing is listed.
    Node { index: usize, node: usize },
}

/// Which place of an open branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Round {
    /// The one that the level tells.
    Level,
    /// One of the sampled places, at which no stage was missed.
    Sampled,
    /// The one that the level of a second stage tells.
    Second,
    /// One of the other places at which the level has roots.
    Other(usize),
}

/// The branches on which a joint is free or nearly so, and which are missed with that joint at its default. Such a
/// branch has roots for an interval of the joint, or at one place alone. Such a place has a stretched elbow that every
/// other place of the joint would have to stretch more. Three runs of the cascade tell the level of the first stage
/// that depends on the joint, and with that the place. Behind a slide the level is of degree 2, and five runs tell it.
/// Six more tell the level over two free joints that turn. Five more tell the level of a second stage, where the first
/// one alone does not lead to a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels<T, const M: usize> {
    /// Open branches, the first `len`.
    open: [Open<T>; M],
    len: usize,
    /// The joints that are free or nearly so on them.
    pub(super) free: JointMask,
    /// Of these the first ones, and others: those that either step moves.
    moving: [JointMask; 2],
    /// How far the free joints are from their defaults in this pass, in turns or strokes.
    steps: [T; 2],
    /// True if every level that depends on its joint is of degree 1 in it: no prismatic joint follows.
    simple: bool,
    /// True if any stage behind a free joint has a level.
    any: bool,
    /// True if a level depends on the first joint.
    depends: bool,
    /// True if both joints are placed together: both are revolute, and levels of degree 1 depend on both.
    together: bool,
}

impl<T: Tolerances, const M: usize> Levels<T, M> {
    pub(super) const NONE: Self = Self {
        open: [Open::NONE; M],
        len: 0,
        free: JointMask::NONE,
        moving: [JointMask::NONE; 2],
        steps: [T::ZERO; 2],
        simple: true,
        any: false,
        depends: false,
        together: false,
    };

    fn open(&self) -> &[Open<T>] {
        self.open.get(..self.len).unwrap_or(&[])
    }

    fn open_mut(&mut self) -> &mut [Open<T>] {
        self.open.get_mut(..self.len).unwrap_or(&mut [])
    }

    /// Remembers a branch that is missed at its default, at the joint vector `q`. `slack`: by how much a joint that is
    /// nearly free may move.
    #[inline(never)]
    pub(super) fn remember<const N: usize>(
        &mut self,
        doubts: &Doubts<T>,
        levels: &[Behind<T>; LEVELS],
        branch: Branch,
        q: &[T; N],
        slack: T,
    ) {
        if self.open().iter().any(|other| same(other.branch, branch, true)) {
            return;
        }
        let first = doubts.first.iter().next();
        let single = |joint: Option<usize>| joint.map_or(JointMask::NONE, JointMask::single);
        let joints = [single(first), single(doubts.free_or_weak().iter().find(|joint| Some(*joint) != first))];
        if let Some(slot) = self.open.get_mut(self.len) {
            let value = first.and_then(|joint| q.get(joint)).copied().unwrap_or(T::ZERO);
            (slot.branch, slot.joints, slot.value, slot.slack) = (branch, joints, value, slack);
            slot.keep_before(levels, true);
            self.any |= levels.iter().any(|behind| behind.level.is_known());
            self.len += 1;
            self.free |= doubts.free_or_weak();
            for (moving, joint) in self.moving.iter_mut().zip(joints) {
                *moving |= joint;
            }
        }
    }

    /// Handles the end of a branch in this pass. A pass that samples keeps the levels. Any other pass returns the name
    /// of the open branch that the solution stands for, if the solution is to be verified. `listed` tells whether a
    /// branch has a solution.
    #[inline(never)]
    pub(super) fn candidate_name(
        &mut self,
        pass: Pass,
        doubts: &Doubts<T>,
        levels: &[Behind<T>; LEVELS],
        branch: Branch,
        listed: impl Fn(Branch) -> bool,
    ) -> Option<Branch> {
        match pass {
            Pass::Sample { second, place } => {
                let (mut simple, mut depends) = (true, false);
                self.any |= levels.iter().any(|behind| behind.level.is_known());
                for exact in [true, false] {
                    let together = second && self.together;
                    for open in self.open_mut().iter_mut().filter(|open| same(open.branch, branch, exact)) {
                        if together {
                            open.sample_both(place, levels, exact);
                        } else if second && place == 0 {
                            open.keep_before(levels, exact);
                        } else {
                            open.sample(place, levels, exact);
                            simple &= open.samples.are_simple();
                            depends |= open.moved.is_some();
                        }
                    }
                }
                if !second {
                    self.simple &= simple;
                    self.depends |= depends;
                }
                let steps = self.steps;
                let without = self.open_mut().iter_mut().filter(|open| !doubts.missed && open.sampled.is_none());
                for open in without.filter(|open| same(open.branch, branch, false)) {
                    (open.sampled, open.aside) = (Some((second, place)), steps);
                }
                None
            }
            Pass::Node { index, node } => {
                let open = self.open_mut().get_mut(index);
                if let Some(open) = open.filter(|open| open.moves(doubts.first))
                    && let Some(level) = open.second_level(levels)
                {
                    open.roots.keep(node, level);
                }
                None
            }
            Pass::Open { index, round } => {
                let open = self.open().get(index)?;
                let moves = round == Round::Second && open.moves(doubts.first);
                if !(moves || same(open.branch, branch, false)) {
                    return None;
                }
                let name = open.branch.wrist().map_or(branch, |wrist| branch.with_wrist(wrist));
                // The other way round the wrist it stands for the open branch only if that is not a branch of its own.
                let other = |other: &Open<T>| same(other.branch, branch, true);
                let stands = name == branch || !(listed(branch) || self.open().iter().any(other));
                let again = matches!(round, Round::Other(_));
                (stands && (again || !listed(name))).then_some(name)
            }
        }
    }

    /// Where a joint stays in a pass, given its default value.
    #[inline(never)]
    pub(super) fn held_at<const N: usize>(
        &self,
        constants: &ArmConstants<T, N>,
        pass: Pass,
        joint: usize,
        default: T,
    ) -> T {
        let moved = self.moving.iter().zip(self.steps).find(|(moving, _)| moving.contains(joint));
        let step = moved.map_or(T::ZERO, |(_, step)| step);
        let slides = constants.prismatic.contains(joint);
        let sample = match pass {
            Pass::Sample { second, place } => Some((second, place)),
            Pass::Open { index, round: Round::Sampled } => self.open().get(index).and_then(|open| open.sampled),
            _ => None,
        };
        let step = match sample.filter(|_| !step.is_finite()) {
            Some((_, place)) if slides => stroke(place),
            Some((second, place)) => turn::<T>(self.places(second), place) / T::TAU,
            None => step,
        };
        if slides { default + constants.reach * T::from_f64(STROKE) * step } else { wrap(default + T::TAU * step) }
    }

    /// The number of places at which a joint is sampled: three for levels of degree 1. All passes together keep to
    /// their bound. If a level depends on the first joint, the second joint has three places, or both joints are sampled
    /// together.
    fn places(&self, second: bool) -> usize {
        match second {
            true if self.together => two_joints::RUNS,
            true if self.depends => 3,
            false if self.simple => 3,
            _ => PLACES,
        }
    }

    /// Returns true if a place is the last one to be sampled. If no level depends on the joint, two places are enough.
    /// If no stage has a level, one run tells whether the branches have their roots there.
    fn sampled(&self, second: bool, place: usize) -> bool {
        let depends = self.open().iter().any(|open| open.moved.is_some());
        place + 1 == self.places(second) || !self.any || place > 0 && !depends
    }

    /// The place of every open branch from the levels at the sampled places of a free joint.
    #[inline(never)]
    fn locate<const N: usize>(&mut self, constants: &ArmConstants<T, N>, defaults: &[T; N], second: bool) {
        let ([first, _], count) = (self.steps, self.places(second));
        let both = second && self.together;
        for index in 0..self.len {
            if let Some((before, rest)) = self.open_mut().split_at_mut_checked(index)
                && let Some((open, after)) = rest.split_first_mut()
            {
                before.iter().chain(&*after).for_each(|other| open.borrow(other));
            }
        }
        for open in self.open_mut().iter_mut().filter(|open| !open.feasible) {
            let [one, other] = open.joints;
            let Some(joint) = (if second && !both { other } else { one }).iter().next() else { continue };
            let default = defaults.get(joint).copied().unwrap_or(T::ZERO);
            let now = if open.slack < T::INFINITY && (!second || both) { open.value } else { default };
            if both {
                open.locate_both(wrap(now - default));
                continue;
            }
            let place = if constants.prismatic.contains(joint) {
                open.samples.sliding((now - default) / (constants.reach * T::from_f64(STROKE)))
            } else {
                open.samples.turning(count, wrap(now - default), open.slack)
            };
            if second {
                open.forget();
            }
            let Some(place) = place else { continue };
            open.take(place);
            open.steps = [place.step, T::ZERO];
            if second {
                (open.steps, open.elsewhere) = ([first, place.step], Elsewhere::NOWHERE);
            }
        }
        if !second {
            self.decide_together(constants);
        }
    }

    /// Decides, after the first joint has been placed, whether both joints are placed together. If not, the branches
    /// without a place forget what they have sampled.
    fn decide_together<const N: usize>(&mut self, constants: &ArmConstants<T, N>) {
        let turns = |joints: &JointMask| joints.iter().all(|joint| !constants.prismatic.contains(joint));
        let misplaced = |open: &Open<T>| open.known && !open.feasible && open.two();
        self.together = self.simple && self.len <= MOST_TOGETHER && self.moving.iter().all(turns);
        self.together &= self.open().iter().any(misplaced);
        let alone = !self.together;
        self.open_mut().iter_mut().filter(|open| alone && !open.feasible).for_each(Open::forget);
    }

    /// The end of a pass; `found`: it has found a solution.
    #[inline(never)]
    pub(super) fn end_pass<const N: usize>(
        &mut self,
        constants: &ArmConstants<T, N>,
        defaults: &[T; N],
        pass: Pass,
        found: bool,
    ) {
        match pass {
            Pass::Open { index, .. } => {
                if let Some(open) = self.open_mut().get_mut(index) {
                    open.found |= found;
                }
            }
            Pass::Sample { second, place } if self.sampled(second, place) => self.locate(constants, defaults, second),
            Pass::Node { index, node } if node + 1 == NODES => {
                if let Some(open) = self.open_mut().get_mut(index)
                    && let Some(intervals) = open.intervals()
                    && let Some(angle) = open.roots.place(&open.samples, intervals)
                {
                    open.set_angle(angle);
                }
            }
            _ => {}
        }
    }

    /// The pass after one; the first after the pass at the defaults.
    #[inline(never)]
    pub(super) fn after(&self, pass: Option<Pass>) -> Option<Pass> {
        match pass {
            None => (self.len > 0).then_some(Pass::Sample { second: false, place: 0 }),
            Some(Pass::Sample { second, place }) if !self.sampled(second, place) => {
                Some(Pass::Sample { second, place: place + 1 })
            }
            Some(Pass::Sample { second: false, .. })
                if self.any && self.open().iter().any(|open| !open.feasible && open.two()) =>
            {
                Some(Pass::Sample { second: true, place: 0 })
            }
            Some(Pass::Sample { .. }) => self.place_of(0),
            Some(Pass::Open { index, round: Round::Level }) => self.place_of(index + 1),
            Some(Pass::Open { index, round: Round::Sampled }) => {
                self.node_of(index).or_else(|| self.further(index + 1))
            }
            Some(Pass::Node { index, node }) if node + 1 < NODES => Some(Pass::Node { index, node: node + 1 }),
            Some(Pass::Node { index, .. }) => Some(Pass::Open { index, round: Round::Second }),
            Some(Pass::Open { index, round: Round::Second }) => self.further(index + 1),
            Some(Pass::Open { index, round: Round::Other(k) }) => self.other(index, k + 1),
        }
    }

    /// The place of the next open branch.
    fn place_of(&self, from: usize) -> Option<Pass> {
        let mut rest = self.open().iter().enumerate().skip(from);
        let next = rest.find(|(_, open)| open.known).map(|(index, _)| Pass::Open { index, round: Round::Level });
        next.or_else(|| self.further(0))
    }

    /// The second stage of a branch that has no solution yet, if there is one.
    fn node_of(&self, index: usize) -> Option<Pass> {
        let spans = self.open().get(index).is_some_and(|open| !open.found && open.second && open.intervals().is_some());
        spans.then_some(Pass::Node { index, node: 0 })
    }

    /// The next pass for a branch without a solution. The other places come last, because their branches have a
    /// solution.
    #[inline(never)]
    fn further(&self, from: usize) -> Option<Pass> {
        let next = (from..self.len).find_map(|index| {
            let sampled = self.open().get(index).is_some_and(|open| !open.found && open.sampled.is_some());
            if sampled { Some(Pass::Open { index, round: Round::Sampled }) } else { self.node_of(index) }
        });
        next.or_else(|| self.other(0, 0))
    }

    /// The next one of the other places.
    #[inline(never)]
    fn other(&self, from: usize, k: usize) -> Option<Pass> {
        let mut rest = self.open().iter().enumerate().skip(from);
        rest.find_map(|(index, open)| {
            let k = if index == from { k } else { 0 };
            open.elsewhere.step(k).map(|_| Pass::Open { index, round: Round::Other(k) })
        })
    }

    /// Moves the free joints to their places in a pass.
    #[inline(never)]
    pub(super) fn start_pass(&mut self, pass: Pass) {
        self.steps = match pass {
            Pass::Sample { second: true, place } if self.together => {
                two_joints::places(place).map(|angle: T| angle / T::TAU)
            }
            Pass::Sample { second, .. } => {
                // The second joint, with the first one where the first open branch has it.
                let open = self.open().iter().find(|open| !open.feasible && open.two());
                let [first, _] = open.map_or([T::ZERO; 2], |open| open.steps);
                if second { [first, T::NAN] } else { [T::NAN, T::ZERO] }
            }
            Pass::Node { index, node: k } => {
                if let Some(open) = self.open_mut().get_mut(index)
                    && let Some([[middle, half], _]) = open.intervals()
                {
                    open.set_angle(middle + half * node(k));
                }
                self.open().get(index).map_or([T::ZERO; 2], |open| open.steps)
            }
            Pass::Open { index, round } => self.open().get(index).map_or([T::ZERO; 2], |open| match round {
                Round::Level | Round::Second => open.steps,
                Round::Sampled => open.aside,
                Round::Other(k) => {
                    let [_, second] = open.steps;
                    [open.elsewhere.step(k).unwrap_or(T::ZERO), second]
                }
            }),
        };
    }
}
