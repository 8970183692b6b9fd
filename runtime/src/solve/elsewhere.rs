//! Following the branches again with a free joint elsewhere.

use super::{Goal, Search, Tolerances, Trail};
use crate::math::wrap;
use crate::{Branch, Flags, JointMask};

/// Places on the turn of a free joint, its home among them.
const PLACES: u32 = 16;

/// The branches on which a joint is free, and which are missed with that joint at home: a later stage has no root
/// there, or the solution does not close. The latter happens where the joint is free only because an earlier one is at
/// the edge of its range to rounding, such as a roll behind a folded elbow.
///
/// Where such a branch can be met at all, it can be met on an interval of the free joint. The whole cascade is run
/// again with the joint at further places, until every such branch has been met, or they are used up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Elsewhere<const M: usize> {
    /// 0: at home; then the places; after them at home once more, where what is left is refined as it is.
    pass: u32,
    /// The solutions of earlier passes.
    pub(super) settled: usize,
    /// Branches that are still to be met, the first `len`.
    open: [Branch; M],
    len: usize,
    /// The joints that are free on them.
    free: JointMask,
}

impl<const M: usize> Elsewhere<M> {
    /// Nothing to do yet.
    pub(super) const START: Self = Self { pass: 0, settled: 0, open: [Branch::NONE; M], len: 0, free: JointMask::NONE };

    /// Whether a branch is to be met with a free joint elsewhere.
    #[inline]
    pub(super) fn wanted(&self) -> bool {
        self.len != 0
    }

    /// Whether this is not the first pass.
    pub(super) fn again(&self) -> bool {
        self.pass != 0
    }

    /// Whether every place has been tried.
    pub(super) fn last(&self) -> bool {
        self.pass == PLACES
    }

    /// Remembers a branch that was missed at home, and the joints that are free on it.
    fn remember(&mut self, branch: Branch, free: JointMask) {
        if !self.open().contains(&branch)
            && let Some(slot) = self.open.get_mut(self.len)
        {
            *slot = branch;
            self.len += 1;
        }
        self.free |= free;
    }

    /// How far from home a joint is in this pass, in turns.
    fn turns<T: Tolerances>(&self, joint: usize) -> T {
        if !self.free.contains(joint) {
            return T::ZERO;
        }
        // Bits in reverse: half a turn, quarters, eighths. Several joints go round in different order.
        let reversed = (self.pass % PLACES).reverse_bits() >> (u32::BITS - PLACES.ilog2());
        let before = self.free.iter().filter(|other| *other < joint).count() as u32;
        let place = (reversed * (2 * before + 1)) % PLACES;
        T::from_f64(f64::from(place) / f64::from(PLACES))
    }

    fn open(&self) -> &[Branch] {
        self.open.get(..self.len).unwrap_or(&[])
    }
}

impl<T: Tolerances, G: Goal<T, N>, const N: usize, const M: usize> Search<'_, T, G, N, M> {
    /// Where a joint stays in this pass if it is free.
    #[cold]
    #[inline(never)]
    pub(super) fn away(&self, joint: usize, home: T) -> T {
        let turns: T = self.doubts.as_ref().map_or(T::ZERO, |doubts| doubts.elsewhere.turns(joint));
        if turns == T::ZERO {
            home
        } else if self.facts.prismatic.contains(joint) {
            home + self.facts.reach * wrap(T::TWO * T::PI * turns) / T::PI
        } else {
            wrap(home + T::TWO * T::PI * turns)
        }
    }

    /// Whether the solution at the end of a doubtful branch is to be listed in this pass. If not because a stage was
    /// missed, the branch is remembered.
    #[cold]
    #[inline(never)]
    pub(super) fn takes(&mut self, trail: &Trail<T>, branch: Branch) -> bool {
        let elsewhere = &mut self.doubts().elsewhere;
        let Elsewhere { pass, free, .. } = *elsewhere;
        let open = elsewhere.open().contains(&branch);
        if pass == 0 {
            if !trail.missed {
                return true;
            }
            elsewhere.remember(branch, trail.free);
            return false;
        }
        if elsewhere.last() {
            return open;
        }
        let known = || {
            let mut listed = self.solutions.iter();
            listed.any(|s| s.branch == branch && s.free == trail.free)
        };
        !trail.missed && trail.free.iter().any(|joint| free.contains(joint)) && (open || !known())
    }

    /// Follows a branch again whose solution does not close with its free joint at home.
    pub(super) fn seek(&mut self, branch: Branch, free: JointMask) {
        let elsewhere = &mut self.doubts().elsewhere;
        if !elsewhere.again() {
            elsewhere.remember(branch, free);
        }
    }

    /// Strikes out the branches that have been met, and goes on to the next place. False if there is nothing left to do.
    #[cold]
    #[inline(never)]
    pub(super) fn move_on(&mut self) -> bool {
        let elsewhere = self.doubts().elsewhere;
        let mut left = [Branch::NONE; M];
        let mut len = 0;
        for branch in elsewhere.open() {
            let met = self.solutions.iter().any(|s| s.branch == *branch && s.flags.contains(Flags::EXACT));
            if !met && let Some(slot) = left.get_mut(len) {
                *slot = *branch;
                len += 1;
            }
        }
        let (settled, pass) = (self.solutions.len(), elsewhere.pass + 1);
        self.doubts().elsewhere = Elsewhere { pass, settled, open: left, len, ..elsewhere };
        for (joint, home) in self.facts.homes(self.near).into_iter().enumerate() {
            let away = self.away(joint, home);
            if let Some(slot) = self.homes.get_mut(joint) {
                *slot = away;
            }
        }
        len != 0 && !elsewhere.last()
    }
}
