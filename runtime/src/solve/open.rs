//! A branch that is missed with a free joint at its default.

use super::kernel::level::{Behind, Level};
use super::kernel::tolerances::Tolerances;
use super::place::{Elsewhere, FreePlace, PLACES, Sample, Samples};
use super::second_level::SecondLevel;
use super::two_joints::{self, Rows};
use crate::math::wrap;
use crate::{Branch, JointMask};

/// The stages that are looked at behind a free joint: the first ones may not depend on the joint.
pub(super) const LEVELS: usize = 5;

/// A branch without a solution so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Open<T> {
    pub(super) branch: Branch,
    /// The first joint that is free or nearly so, and another one.
    pub(super) joints: [JointMask; 2],
    /// Levels of the stages behind the free joint, before that joint moves.
    pub(super) before: [Sample<T>; LEVELS],
    /// Index of the first stage behind the free joint whose level depends on that joint.
    pub(super) moved: Option<usize>,
    /// True if a stage after `moved` has a level.
    pub(super) second: bool,
    /// Samples of the level of `moved`.
    pub(super) samples: Samples<T>,
    /// Samples of the level of `moved` with the second joint off its default.
    pub(super) rows: Rows<T>,
    /// Samples of the level of the stage after `moved`.
    pub(super) roots: SecondLevel<T>,
    /// Other places at which the stage `moved` has roots.
    pub(super) elsewhere: Elsewhere<T>,
    /// A sample at which no stage was missed (of the second joint, place), with the steps of that pass.
    pub(super) sampled: Option<(bool, usize)>,
    pub(super) aside: [T; 2],
    /// How far the free joints are from their defaults at the branch's place, in turns or strokes.
    pub(super) steps: [T; 2],
    /// True if the branch's place is known.
    pub(super) known: bool,
    /// True if the stage `moved` has roots at the branch's place.
    pub(super) feasible: bool,
    /// True if a solution has been found at the branch's place.
    pub(super) found: bool,
    /// Where a joint that is nearly free has been, and how far it may move from there without moving the tool. For a
    /// joint that is free, the `slack` is infinite.
    pub(super) value: T,
    pub(super) slack: T,
}

impl<T: Tolerances> Open<T> {
    pub(super) const NONE: Self = Self {
        branch: Branch::NONE,
        joints: [JointMask::NONE; 2],
        before: [Sample::NONE; LEVELS],
        moved: None,
        second: false,
        samples: Samples::NONE,
        rows: Rows::NONE,
        roots: SecondLevel::NONE,
        elsewhere: Elsewhere::NOWHERE,
        sampled: None,
        aside: [T::ZERO; 2],
        steps: [T::ZERO; 2],
        known: false,
        feasible: false,
        found: false,
        value: T::ZERO,
        slack: T::INFINITY,
    };

    /// Keeps the levels before the free joint moves, `over` what has been kept if it is set.
    pub(super) fn keep_before(&mut self, levels: &[Behind<T>; LEVELS], over: bool) {
        for (slot, level) in self.before.iter_mut().zip(levels) {
            slot.keep(&level.level, over);
        }
    }

    /// Forgets what is known of the levels.
    pub(super) fn forget(&mut self) {
        (self.before, self.moved, self.samples) = ([Sample::NONE; LEVELS], None, Samples::NONE);
    }

    /// Finds the first level that depends on a joint that has moved; at places before this one it was the same.
    fn find(&mut self, place: usize, levels: &[Behind<T>; LEVELS]) -> Option<Behind<T>> {
        if self.moved.is_none() {
            let differs = |(before, behind): (&Sample<T>, &Behind<T>)| before.differs(&Sample::of(&behind.level));
            self.moved = self.before.iter().zip(levels).position(differs);
            if let Some((before, behind)) = self.moved.and_then(|moved| self.before.iter().zip(levels).nth(moved)) {
                self.samples.fill(place, *before, behind);
            }
        }
        self.second |= self.second_level(levels).is_some();
        self.moved.and_then(|moved| levels.get(moved)).copied()
    }

    /// The level of the stage after the one that depends on the free joint.
    pub(super) fn second_level<'a>(&self, levels: &'a [Behind<T>; LEVELS]) -> Option<&'a Level<T>> {
        let behind = levels.get(self.moved? + 1..)?;
        behind.iter().map(|behind| &behind.level).find(|level| level.is_known())
    }

    /// Keeps a sample of the first level that depends on the free joint, `over` what has been kept there if it is set.
    pub(super) fn sample(&mut self, place: usize, levels: &[Behind<T>; LEVELS], over: bool) {
        if let Some(behind) = self.find(place, levels) {
            self.samples.keep(place, &behind, over);
        }
    }

    /// Keeps a sample of that level in a run with both joints off their defaults.
    pub(super) fn sample_both(&mut self, run: usize, levels: &[Behind<T>; LEVELS], over: bool) {
        if let Some(behind) = self.find(PLACES, levels) {
            self.rows.keep(run, &behind.level, over);
        }
    }

    /// The place of both joints from these samples, with the first one next to `now`, rad from its default. A branch
    /// without a second joint stays where the first one is.
    pub(super) fn locate_both(&mut self, now: T) {
        if !self.two() {
            return;
        }
        let Some(angle) = self.rows.place(&mut self.samples) else { return };
        let both = self.samples.turning(two_joints::PLACES, now, self.slack);
        if let Some(place) = both.or_else(|| self.samples.anywhere(now)) {
            self.steps = [place.step, wrap(angle) / T::TAU];
            self.take(place);
        }
    }

    /// Takes what a place tells.
    pub(super) fn take(&mut self, place: FreePlace<T>) {
        (self.known, self.feasible, self.elsewhere) = (true, place.feasible, place.elsewhere);
    }

    /// Goes to a place, rad from its default.
    pub(super) fn set_angle(&mut self, angle: T) {
        let [first, _] = &mut self.steps;
        *first = angle / T::TAU;
    }

    /// Takes samples that are not known from another branch, if those known to both agree: its level is the same. A
    /// stage that is missed may have but one root, whose branch has one of several names.
    pub(super) fn borrow(&mut self, other: &Self) {
        if self.moved == other.moved {
            self.samples.complete(&other.samples);
        }
    }

    /// The interval of the joint in which the first stage that depends on it has roots, and another one.
    pub(super) fn intervals(&self) -> Option<[[T; 2]; 2]> {
        let [[_, half], _] = self.elsewhere.intervals;
        (half > T::COINCIDENT).then_some(self.elsewhere.intervals)
    }

    /// Returns true if `first` is one of the joints of this branch. `first` is the first joint that is free or weak on
    /// another branch, or the empty mask if that branch has none.
    pub(super) fn moves(&self, first: JointMask) -> bool {
        !first.is_empty() && self.joints.contains(&first)
    }

    /// Returns true if two joints may move.
    pub(super) fn two(&self) -> bool {
        let [_, second] = self.joints;
        !second.is_empty()
    }
}

/// Returns true if two names differ in the elbow at most, or without `wrist` in elbow and wrist.
pub(super) fn same(a: Branch, b: Branch, wrist: bool) -> bool {
    a.shoulder() == b.shoulder() && a.root() == b.root() && (!wrist || a.wrist() == b.wrist())
}
