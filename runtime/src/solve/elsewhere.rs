//! Following the branches again with a free joint elsewhere.

use super::{Goal, Search, Tolerances, Trail};
use crate::math::wrap;
use crate::{Branch, Flags, JointMask};

/// Places on the turn of a free joint, its home among them.
const PLACES: u32 = 16;
/// By how much a gap may change, in reaches or rad, while the free joint turns by a rad. Rotating an arm moves it by its
/// reach at most; the rest is for joints that follow with a ratio.
const STEEPEST: f64 = 4.0;

/// Where the free joints are in a pass of the cascade, in the order of the passes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Pass<T> {
    /// At home.
    Home,
    /// At one of the other places.
    Place(u32),
    /// At home once more, where what is left is refined as it is.
    HomeAgain,
    /// Around the place that is best for the first open branch: the step in turns, with its sign, and whether the
    /// opposite step has failed from there.
    Nearer { step: T, both: bool },
    /// At the best place of that branch, whose solution is refined as it is.
    Last,
    /// At home, for a target out of reach: branches that are missed are followed to their end.
    Nearest,
}

/// A branch that is still to be met.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Open<T> {
    branch: Branch,
    /// The least gap so far, over reach or in rad, and the turn of the free joint at which it was.
    gap: T,
    turn: T,
    /// Where it has been met at home, but families of solutions cross: the joints that are loose there.
    crossing: Option<JointMask>,
}

/// The branches on which a joint is free, and which are missed with that joint at home: a later stage has no root
/// there, or the solution does not close. The latter happens where the joint is free only because an earlier one is at
/// the edge of its range to rounding, such as a roll behind a folded elbow.
///
/// Such a branch is met on an interval of the free joint, or at one place alone, where the gap touches zero: a stretched
/// elbow that every other place of the joint would have to stretch more. The whole cascade is run again with the joint
/// at further places; then, for every branch that none of them meets, nearer and nearer to the place of the least gap.
///
/// A branch may also be met at home just where another stage is singular: there families of solutions cross, and the one
/// at home does not tell which joints move together on the other. A second member is looked for elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Elsewhere<T, const M: usize> {
    pass: Pass<T>,
    /// How far the first of the free joints is from home, in turns.
    turn: T,
    /// The solutions of earlier passes.
    pub(super) settled: usize,
    /// The solutions of the pass at home.
    at_home: usize,
    /// Branches that are still to be met, the first `len`.
    open: [Open<T>; M],
    len: usize,
    /// The joints that are free on them.
    free: JointMask,
}

impl<T: Tolerances, const M: usize> Elsewhere<T, M> {
    /// Nothing to do yet.
    pub(super) const START: Self = Self {
        pass: Pass::Home,
        turn: T::ZERO,
        settled: 0,
        at_home: 0,
        open: [Open { branch: Branch::NONE, gap: T::INFINITY, turn: T::ZERO, crossing: None }; M],
        len: 0,
        free: JointMask::NONE,
    };

    /// For the nearest approach to a target out of reach.
    pub(super) const NEAREST: Self = Self { pass: Pass::Nearest, ..Self::START };

    /// Whether a branch is to be met with a free joint elsewhere.
    #[inline]
    pub(super) fn wanted(&self) -> bool {
        self.len != 0
    }

    /// Whether this is not the first pass.
    pub(super) fn again(&self) -> bool {
        self.pass != Pass::Home
    }

    /// Whether what is left is to be refined as it is.
    pub(super) fn last(&self) -> bool {
        matches!(self.pass, Pass::HomeAgain | Pass::Last)
    }

    /// Remembers a branch that was missed at home, or is on a crossing there, and the joints that are free on it.
    fn remember(&mut self, branch: Branch, free: JointMask, crossing: Option<JointMask>) {
        if let Some(known) = self.open_mut(branch) {
            known.crossing = known.crossing.and(crossing);
        } else if let Some(slot) = self.open.get_mut(self.len) {
            *slot = Open { branch, crossing, gap: T::INFINITY, turn: T::ZERO };
            self.len += 1;
        }
        self.free |= free;
    }

    /// In this pass a branch has this gap.
    fn compare(&mut self, branch: Branch, gap: T) {
        let turn = self.turn;
        if let Some(open) = self.open_mut(branch).filter(|open| gap < open.gap) {
            (open.gap, open.turn) = (gap, turn);
        }
    }

    /// How far from home a joint is in this pass, in turns. Several joints go round in different order.
    fn turns(&self, joint: usize) -> T {
        if !self.free.contains(joint) {
            return T::ZERO;
        }
        let before = self.free.iter().filter(|other| *other < joint).count();
        self.turn * T::from_f64(2.0 * before as f64 + 1.0)
    }

    fn open_mut(&mut self, branch: Branch) -> Option<&mut Open<T>> {
        self.open.iter_mut().take(self.len).find(|open| open.branch == branch)
    }

    /// Takes those branches off that a solution has met (those on a crossing: one of a further pass), and those that have
    /// had their last pass.
    fn strike(&mut self, met: impl Fn(&Open<T>) -> bool) {
        let (all, passed) = (self.open, usize::from(self.pass == Pass::Last));
        let placed = self.pass == Pass::Place(PLACES - 1);
        let left =
            all.iter().take(self.len).skip(passed).filter(|open| !(placed && open.crossing.is_some() || met(open)));
        self.len = self.open.iter_mut().zip(left).map(|(slot, open)| *slot = *open).count();
    }

    /// Goes on to the next place.
    fn go_on(&mut self, first_before: Branch) {
        let Some(&Open { branch, gap, turn, .. }) = self.open.first() else { return };
        let first_step = T::HALF / T::from_f64(f64::from(PLACES));
        let afresh = Pass::Nearer { step: first_step, both: false };
        self.pass = match self.pass {
            // The odd sixteenths: quarters and eighths are where families cross.
            Pass::Home if self.open.iter().take(self.len).all(|open| open.crossing.is_some()) => {
                Pass::Place(PLACES / 2)
            }
            Pass::Home => Pass::Place(1),
            Pass::Place(place) if place + 1 < PLACES => Pass::Place(place + 1),
            Pass::Place(_) => Pass::HomeAgain,
            Pass::Nearer { step, both } if branch == first_before => {
                if turn == self.turn {
                    Pass::Nearer { step, both: false }
                } else if both {
                    Pass::Nearer { step: step * T::HALF, both: false }
                } else {
                    Pass::Nearer { step: -step, both: true }
                }
            }
            _ => afresh,
        };
        if let Pass::Nearer { step, .. } = self.pass {
            let whole = T::TWO * T::PI;
            let farthest = step.abs() * whole;
            if farthest < T::COINCIDENT || !(gap <= T::from_f64(STEEPEST) * farthest) {
                self.pass = Pass::Last;
            }
        }
        self.turn = match self.pass {
            Pass::Home | Pass::HomeAgain | Pass::Nearest => T::ZERO,
            // Bits in reverse: half a turn, quarters, eighths.
            Pass::Place(place) => {
                let reversed = place.reverse_bits() >> (u32::BITS - PLACES.ilog2());
                T::from_f64(f64::from(reversed) / f64::from(PLACES))
            }
            Pass::Nearer { step, .. } => turn + step,
            Pass::Last => turn,
        };
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
        let reach = self.facts.reach;
        let lost = !self.solutions.iter().any(|solution| solution.flags.contains(Flags::EXACT));
        let elsewhere = &mut self.doubts().elsewhere;
        let pass = elsewhere.pass;
        let loose = trail.free | trail.weak;
        // Beside a free joint another one is free, or nearly so.
        let crossing = (!trail.missed && !trail.free.is_empty() && loose.len() > 1).then_some(loose);
        let at_home = pass == Pass::Home && (trail.missed || crossing.is_some());
        // A branch that is there elsewhere only counts as long as none has been met.
        if at_home || lost && trail.missed && matches!(pass, Pass::Place(_)) {
            elsewhere.remember(branch, trail.free, crossing);
        }
        elsewhere.compare(branch, (trail.gap.position / reach).max(trail.gap.orientation));
        let free = elsewhere.free;
        let known = elsewhere.open_mut(branch).map(|open| open.crossing);
        let open = known.is_some_and(|crossing| crossing.is_none_or(|at_home| at_home != loose));
        match pass {
            Pass::Home => return !trail.missed,
            Pass::Nearest => return trail.beyond,
            Pass::HomeAgain => return open,
            Pass::Last => return elsewhere.open.first().is_some_and(|first| first.branch == branch),
            Pass::Place(_) | Pass::Nearer { .. } => {}
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
            elsewhere.remember(branch, free, None);
        }
    }

    /// Strikes out the branches that have been met, and goes on to the next place. False if there is nothing left to do.
    #[cold]
    #[inline(never)]
    pub(super) fn move_on(&mut self) -> bool {
        let mut elsewhere = self.doubts().elsewhere;
        let first = elsewhere.open.first().map_or(Branch::NONE, |open| open.branch);
        if !elsewhere.again() {
            elsewhere.at_home = self.solutions.len();
        }
        let at_home = elsewhere.at_home;
        elsewhere.strike(|&Open { branch, crossing, .. }| {
            let mut found = self.solutions.iter().skip(crossing.map_or(0, |_| at_home));
            found.any(|s| s.branch == branch && s.flags.contains(Flags::EXACT))
        });
        elsewhere.go_on(first);
        elsewhere.settled = self.solutions.len();
        self.doubts().elsewhere = elsewhere;
        for (joint, home) in self.facts.homes(self.near).into_iter().enumerate() {
            let away = self.away(joint, home);
            if let Some(slot) = self.homes.get_mut(joint) {
                *slot = away;
            }
        }
        elsewhere.wanted()
    }
}
