//! Following the branches of the cascade and collecting the solutions.

use super::facts::Evaluate;
use super::passes::Passes;
use super::stage::Met;
use super::{Facts, Goal, Home, Measure, Stage, Tolerances, Trail};
use crate::effort::MOST_EVALUATIONS;
use crate::limits::within;
use crate::math::wrap;
use crate::vector::norm;
use crate::{Branch, Flags, JointMask, Residual, Solution, Solutions, Status};

/// The place of a virtual joint in a mask, beyond the joints of any arm with an inverse.
pub(super) const VIRTUAL: usize = 15;

/// One run of the inverse kinematics.
pub struct Search<'a, T: 'static, const N: usize, const M: usize> {
    pub(super) facts: &'a Facts<T, N>,
    pub(super) arm: &'a dyn Evaluate<T, N>,
    pub(super) goal: &'a dyn Goal<T, N>,
    pub(super) solutions: &'a mut Solutions<T, N, M>,
    /// Where each joint stays if it is free.
    pub(super) homes: [T; N],
    /// The least gap of a stage at which a branch ended, or what a branch that went on misses by.
    pub(super) least: Option<T>,
    /// How many evaluations of the arm are left.
    pub(super) left: usize,
    /// What is remembered at a pose that needs further passes.
    pub(super) passes: Option<Passes<T, N, M>>,
}

impl<'a, T: Tolerances, const N: usize, const M: usize> Search<'a, T, N, M> {
    /// Starts a search that fills `solutions`.
    ///
    /// `None`, with the status [`Status::BadTarget`], if the target or the reference is not finite.
    #[inline(always)]
    pub fn new(
        facts: &'a Facts<T, N>,
        arm: &'a dyn Evaluate<T, N>,
        goal: &'a dyn Goal<T, N>,
        near: Option<&[T; N]>,
        solutions: &'a mut Solutions<T, N, M>,
    ) -> Option<Self> {
        let finite = goal.is_finite() && near.is_none_or(|q| facts.can_refer(q));
        if !finite {
            solutions.set_status(Status::BadTarget);
            return None;
        }
        // So far away the squares of the coordinates overflow: no arm reaches there.
        let farthest = goal.point().iter().fold(T::ZERO, |most, x| most.max(x.abs()));
        if farthest > T::MAX.sqrt() * T::from_f64(1e-3) {
            solutions.set_status(Status::Unreachable { residual: farthest });
            return None;
        }
        Some(Self {
            facts,
            arm,
            goal,
            solutions,
            homes: facts.homes(near),
            least: None,
            left: MOST_EVALUATIONS,
            passes: None,
        })
    }

    /// The start of every branch.
    #[inline]
    pub fn start(&self) -> Trail<T> {
        crate::effort::cascade();
        // Far away (a long slide may reach there) the rounding of the target alone can exceed what closes.
        let limit = self.facts.reach * T::from_f64(10.0);
        let far = self.goal.point().iter().any(|x| x.abs() > limit);
        Trail { doubt: far || self.passes.is_some(), ..Trail::START }
    }

    /// Where a joint stays if it is free: its reference value; without one 0, or the limit nearest to 0.
    #[inline]
    pub fn home(&self, joint: usize) -> Home<T> {
        self.home_at(joint, self.homes.get(joint).copied().unwrap_or(T::ZERO))
    }

    /// The same for a virtual joint: 0.
    #[inline]
    pub fn virtual_home(&self) -> Home<T> {
        let value = self.passes.as_ref().map_or(T::ZERO, |passes| passes.away(self.facts, VIRTUAL, T::ZERO));
        self.home_at(VIRTUAL, value)
    }

    #[inline]
    fn home_at(&self, joint: usize, value: T) -> Home<T> {
        let free_below = self.passes.as_ref().map_or(T::VANISHING, |passes| passes.free_below(joint));
        Home { value, joint: JointMask::single(joint), free_below }
    }

    /// The trail of a branch after a stage. A stage that misses by more than the tolerance ends the branch; its gap is
    /// remembered.
    #[inline]
    pub fn follow<const K: usize, const R: usize>(&mut self, trail: &Trail<T>, stage: &Stage<T, K, R>) -> Trail<T> {
        if stage.doubt | trail.doubt { self.doubtful(trail, stage.met()) } else { *trail }
    }

    #[cold]
    #[inline(never)]
    fn doubtful(&mut self, trail: &Trail<T>, met: Met<T>) -> Trail<T> {
        let mut next = *trail;
        next.note(met);
        let Met { gap, angular, .. } = met;
        let measure = if angular { Measure::DIRECTION } else { Measure::length(self.facts.reach) };
        let tolerance = if angular { self.facts.tolerance.orientation } else { self.facts.tolerance.position };
        // What an earlier stage of small amplitude leaves uncertain shows up here magnified.
        let rounding = measure.rounding() / trail.amplitude;
        next.clamped |= gap > rounding && trail.loose().is_empty();
        // With a joint earlier on the branch that is free, or nearly, the gap may close by moving that joint.
        if gap > tolerance.max(rounding) {
            next.missed |= !trail.free.is_empty();
            if trail.loose().is_empty() {
                next.ended = true;
                self.misses(gap);
            }
        }
        next
    }

    /// A branch misses by this.
    pub(super) fn misses(&mut self, gap: T) {
        let gap = if gap.is_finite() { gap } else { T::MAX };
        self.least = Some(self.least.map_or(gap, |least| least.min(gap)));
    }

    /// The trail of a branch on which equations without a joint to meet them are missed by this much. Beyond rounding
    /// its end is verified: what is asked for may be beyond the arm.
    #[inline]
    pub fn agree<const K: usize>(&self, trail: &Trail<T>, measure: Measure<T>, misses: [T; K]) -> Trail<T> {
        let agreed = misses.iter().fold(true, |agreed, miss| agreed & (miss.abs() <= measure.rounding()));
        Trail { doubt: trail.doubt | !agreed, ..*trail }
    }

    /// The trail of a branch on which the direction of a vector tells where joints turn: one without length leaves the
    /// first two free.
    #[inline]
    pub fn directed(
        &mut self,
        trail: &Trail<T>,
        measure: Measure<T>,
        vector: [T; 3],
        [first, second]: [Home<T>; 2],
    ) -> Trail<T> {
        if norm(vector) > measure.vanishing() {
            return *trail;
        }
        let free = first.joint | second.joint;
        Trail { doubt: true, free: trail.free | free, first: first.joint, flags: trail.flags | Flags::FREE, ..*trail }
    }

    /// Adds a solution. `q`: joint angles in (-pi, pi], rad; strokes in the length unit.
    #[inline]
    pub fn push(&mut self, trail: &Trail<T>, q: [T; N], branch: Branch) {
        let solution = Solution { q, flags: trail.flags | Flags::EXACT, free: trail.free, branch, residual: trail.gap };
        if trail.doubt | self.solutions.is_awkward() {
            self.candidate(trail, solution);
        } else {
            self.solutions.push(solution);
        }
    }

    /// The end of a pass. Returns whether it was the last one: if not, a joint is free or nearly so on some branch, and
    /// the branches are to be followed once more with that joint elsewhere.
    #[inline]
    #[must_use]
    pub fn complete(&mut self) -> bool {
        self.passes.is_none() || !self.next_pass()
    }

    /// The end of the search: with a reference, solutions are unwound next to it and sorted; limits are marked, and
    /// the status is set.
    #[inline]
    pub fn finish(&mut self, near: Option<&[T; N]>) {
        match near {
            Some(near) => self.next_to(near),
            None if !self.goal.given().is_empty() => self.wrap_given(),
            None => {}
        }
        if self.facts.limited || !self.facts.combined.is_empty() {
            self.mark_limits();
        }
        let exact = self.solutions.iter().any(|s| s.flags.contains(Flags::EXACT));
        let status = if exact { Status::Reachable } else { self.unreachable() };
        self.solutions.set_status(status);
    }

    /// A given angle may have come with whole turns; in a solution it is in (-pi, pi] like every other.
    #[inline]
    fn wrap_given(&mut self) {
        for joint in self.goal.given().iter().filter(|joint| !self.facts.prismatic.contains(*joint)) {
            for value in self.solutions.as_mut_slice().iter_mut().filter_map(|solution| solution.q.get_mut(joint)) {
                *value = wrap(*value);
            }
        }
    }

    #[inline]
    fn mark_limits(&mut self) {
        for solution in self.solutions.as_mut_slice() {
            // Every joint, without a branch.
            let joints = solution.q.iter().zip(self.facts.limits);
            let inside = joints.fold(true, |inside, (q, limits)| inside & within(*q, *limits, q.abs()));
            if !(inside && self.facts.combined.iter().all(|limit| limit.holds(&solution.q))) {
                solution.flags |= Flags::OUT_OF_LIMITS;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn unreachable(&self) -> Status<T> {
        let larger = |residual: &Residual<T>| residual.position.max(residual.orientation);
        let listed = self.solutions.iter().map(|s| larger(&s.residual));
        let residual = listed.chain(self.least).fold(T::INFINITY, |least, gap| least.min(gap));
        // A quartic without real roots has no gap: all that is known is that the target is not near.
        let known = residual.is_finite() && residual > T::ZERO;
        Status::Unreachable { residual: if known { residual } else { self.facts.reach } }
    }
}
