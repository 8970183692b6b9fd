//! Following the branches of the cascade and collecting the solutions.

use super::arm_constants::{ArmConstants, Evaluate};
use super::doubts::Doubts;
use super::flip::Verified;
use super::goal::Goal;
use super::kernel::branch_state::BranchState;
use super::kernel::doubt::Doubt;
use super::kernel::roots::{Measure, Roots};
use super::kernel::tolerances::Tolerances;
use super::kernel::turn::DefaultValue;
use super::least_squares::Problem;
use super::retry::Retry;
use crate::effort::{MOST_CASCADES, MOST_EVALUATIONS};
use crate::limits::within;
use crate::vector::norm;
use crate::{Branch, Flags, JointMask, Solution, Solutions, Status};

/// The place of a virtual joint in a mask, beyond the joints of any arm with an inverse.
pub(super) const VIRTUAL: usize = 15;

/// The most doubts on one branch, one for each call of [`follow`](Search::follow) and [`directed`](Search::directed): at most
/// seven stages, and the state of an arm angle.
pub const MOST_DOUBTS: usize = 8;

/// One call of the inverse kinematics of an arm with `N` joints and at most `M` solutions.
///
/// `S`: the most branches that a free joint at its default may keep from closing. With `S = 0`, for an arm on which no later
/// stage sees where a free joint is, the code for such branches is not linked.
pub struct Search<'a, T: 'static, const N: usize, const M: usize, const S: usize> {
    pub(super) constants: &'a ArmConstants<'a, T, N>,
    pub(super) arm: &'a dyn Evaluate<T, N>,
    pub(super) goal: &'a dyn Goal<T, N>,
    pub(super) solutions: &'a mut Solutions<T, N, M>,
    /// Where each joint stays if it is free, and where a virtual one does: in further runs not at its default.
    pub(super) defaults: [T; N],
    pub(super) virtual_default: T,
    /// Least stage residual at which a branch ended, or least residual of a branch that went on.
    pub(super) least: Option<T>,
    /// The joints that further runs hold elsewhere. In such a run they are free where their amplitude is below `WEAK`.
    pub(super) elsewhere: JointMask,
    /// How many evaluations of the arm are left.
    pub(super) evaluations_left: usize,
    /// The candidate that was verified, if no stage has been solved since.
    pub(super) verified: Option<Verified<T, N>>,
    /// The doubts of the branch that is followed, one entry for each stage in doubt. Branches are followed depth first,
    /// so an entry stays until the branches behind it have ended.
    pub(super) doubts: Option<[Option<Doubts<T>>; MOST_DOUBTS]>,
    /// Every branch is verified. The arm misses its structure by more than rounding, or the target is so far away that
    /// its rounding alone can exceed what closes. A long slide may reach such a target.
    pub(super) doubt: bool,
    /// Distance of the links of a measured arm from the table whose equations are solved, relative to reach and in rad.
    pub(super) slack: T,
    /// The reference, if there is one.
    pub(super) near: Option<&'a [T; N]>,
    /// A branch of a measured arm's table is missed by little, or leads to no solution.
    pub(super) is_nearly_missed: bool,
    /// Memory of further runs, if the pose needs any.
    pub(super) retry: Option<Retry<T, N, M, S>>,
}

impl<'a, T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'a, T, N, M, S> {
    /// A search that fills `solutions`.
    #[inline(always)]
    pub fn new(
        constants: &'a ArmConstants<'a, T, N>,
        arm: &'a dyn Evaluate<T, N>,
        goal: &'a dyn Goal<T, N>,
        near: Option<&'a [T; N]>,
        solutions: &'a mut Solutions<T, N, M>,
    ) -> Self {
        Self {
            constants,
            arm,
            goal,
            solutions,
            defaults: constants.defaults(near),
            virtual_default: T::ZERO,
            least: None,
            elsewhere: JointMask::NONE,
            evaluations_left: MOST_EVALUATIONS,
            verified: None,
            doubts: None,
            doubt: false,
            slack: T::ZERO,
            near,
            is_nearly_missed: false,
            retry: None,
        }
    }

    /// Verifies every branch. An arm whose axes miss the structure of its equations by more than rounding needs this:
    /// the roots of the equations then miss by more than rounding, too.
    #[inline(always)]
    #[must_use]
    pub fn in_doubt(mut self) -> Self {
        self.doubt = true;
        self
    }

    /// Returns true if there is something to search. Otherwise the solutions get their status. The status is
    /// [`Status::BadTarget`] if the target or the reference is not finite, or the reference is wound too far. The
    /// status is [`Status::Unreachable`] if squares overflow: the target is too far away, or the given value of a
    /// prismatic joint too large.
    #[inline(always)]
    #[must_use]
    pub fn begins(&mut self, near: Option<&[T; N]>) -> bool {
        let [x, y, z] = self.goal.point();
        let mut size = x.abs() + y.abs() + z.abs();
        if !self.goal.given().is_empty() {
            size += self.given_strokes();
        }
        self.doubt |= size > self.constants.reach * T::from_f64(10.0);
        let finite = self.goal.is_finite() && near.is_none_or(|q| self.constants.can_refer(q));
        let begins = finite && size <= T::SQRT_MAX * T::from_f64(1e-3);
        if !begins {
            let status = if finite { Status::Unreachable { residual: size.min(T::MAX) } } else { Status::BadTarget };
            self.solutions.set_status(status);
        }
        begins
    }

    /// The given values of slides, as a sum of lengths.
    #[inline(never)]
    fn given_strokes(&self) -> T {
        let strokes = self.goal.given().iter().filter(|joint| self.constants.prismatic.contains(*joint));
        let placed = self.goal.placed(self.defaults);
        strokes.filter_map(|joint| placed.get(joint)).fold(T::ZERO, |sum, stroke| sum + stroke.abs())
    }

    /// Where a joint stays if it is free: its reference value; without one 0, or the limit nearest to 0. In a further run
    /// another place.
    #[inline]
    pub fn default(&self, joint: usize) -> DefaultValue<T> {
        self.default_at(joint, self.defaults.get(joint).copied().unwrap_or(T::ZERO))
    }

    /// The default value of a virtual joint: 0, or in a further run another one.
    #[inline]
    pub fn virtual_default(&self) -> DefaultValue<T> {
        self.default_at(VIRTUAL, self.virtual_default)
    }

    #[inline]
    fn default_at(&self, joint: usize, value: T) -> DefaultValue<T> {
        DefaultValue { value, joint: JointMask::single(joint), nearly_free: self.elsewhere }
    }

    /// The doubts of a branch that has any.
    #[inline]
    pub(super) fn known_doubts(&self, state: BranchState) -> Option<&Doubts<T>> {
        let last = state.depth().checked_sub(1)?;
        self.doubts.as_ref()?.get(last)?.as_ref()
    }

    /// The doubts of a branch.
    #[inline(never)]
    pub(super) fn doubts(&self, state: BranchState) -> Doubts<T> {
        self.known_doubts(state).copied().unwrap_or(Doubts::START)
    }

    /// The state of a branch with further doubts.
    fn with_doubts(&mut self, state: BranchState, doubts: Doubts<T>, ended: bool) -> BranchState {
        if let Some(slot) = self.doubts.get_or_insert([None; MOST_DOUBTS]).get_mut(state.depth()) {
            *slot = Some(doubts);
        }
        state.deeper(ended)
    }

    /// The state of a branch after a stage. A stage that misses by more than the tolerance ends the branch, and its gap is
    /// remembered. If a joint before it is free or weak, the branch goes on.
    #[inline(always)]
    pub fn follow<const K: usize, const R: usize>(
        &mut self,
        state: &BranchState,
        stage: &Roots<T, K, R>,
    ) -> BranchState {
        if stage.doubt.is_some() | state.doubt() { self.doubtful(*state, stage.doubt) } else { *state }
    }

    #[cold]
    #[inline(never)]
    fn doubtful(&mut self, state: BranchState, doubt: Option<Doubt<T>>) -> BranchState {
        self.verified = None;
        let Some(doubt) = doubt else { return state };
        let mut next = self.doubts(state);
        let (amplitude, free, free_or_weak) = (next.amplitude, next.free, next.free_or_weak());
        next.note(&doubt);
        let mut ended = false;
        let Doubt { gap, angular, .. } = doubt;
        let measure = if angular { Measure::DIRECTION } else { Measure::length(self.constants.reach) };
        let tolerance = if angular { self.constants.tolerance.orientation } else { self.constants.tolerance.position };
        // A small amplitude of an earlier stage magnifies its uncertainty here; that of a joint which is free counts as 1.
        let rounding = measure.rounding() / amplitude;
        next.clamped |= gap > rounding && free_or_weak.is_empty();
        // With a joint earlier on the branch that is free, or nearly, the gap may close by moving that joint.
        if gap > tolerance.max(rounding) && (self.slack == T::ZERO || self.is_beyond_slack(gap, angular)) {
            if !free.is_empty() {
                next.miss(&doubt, free_or_weak);
            }
            if free_or_weak.is_empty() {
                ended = true;
                self.note_gap(gap);
            }
        }
        self.with_doubts(state, next, ended)
    }

    /// The least-squares problem of this call.
    #[inline]
    pub(super) const fn problem(&self) -> Problem<'a, T, N> {
        Problem { constants: self.constants, goal: self.goal, arm: self.arm }
    }

    /// Notes that a branch misses by `gap`, a length or an angle, whichever is the larger number.
    #[cold]
    #[inline(never)]
    pub(super) fn note_gap(&mut self, gap: T) {
        let gap = if gap.is_finite() { gap } else { T::MAX };
        self.least = Some(self.least.map_or(gap, |least| least.min(gap)));
    }

    /// The state of a branch on which equations without a joint to meet them are missed by this much. Beyond rounding
    /// its end is verified: what is asked for may be beyond the arm.
    #[inline]
    pub fn agree<const K: usize>(&self, state: &BranchState, measure: Measure<T>, misses: [T; K]) -> BranchState {
        let agreed = misses.iter().fold(true, |agreed, miss| agreed & (miss.abs() <= measure.rounding()));
        state.doubted(!agreed)
    }

    /// The state of a branch on which the direction of a vector tells where joints turn: one without length leaves the
    /// first two free.
    #[inline]
    pub fn directed(
        &mut self,
        state: &BranchState,
        measure: Measure<T>,
        vector: [T; 3],
        [first, second]: [DefaultValue<T>; 2],
    ) -> BranchState {
        if norm(vector) > measure.vanishing() {
            return *state;
        }
        let mut doubts = self.doubts(*state);
        doubts.free |= first.joint | second.joint;
        doubts.flags |= Flags::FREE;
        self.with_doubts(*state, doubts, false)
    }

    /// Adds a solution. `q`: joint angles in (-pi, pi], rad; strokes in the length unit.
    #[inline]
    pub fn push(&mut self, state: &BranchState, q: [T; N], branch: Branch) {
        if state.doubt() | self.solutions.is_awkward() {
            self.candidate(*state, q, branch);
        } else {
            self.solutions.push(Solution::exact(q, branch));
        }
    }

    /// Runs the cascade: `nest` follows every branch once and pushes the solutions. At a singular target `nest` runs
    /// again, with a free joint at another place, at most [`MOST_CASCADES`] times in all. Then, with a reference,
    /// solutions are unwound next to it and sorted; limits are marked, and the status is set.
    ///
    /// `constants` are those of the search: the compiler sees their values here, and leaves out what they exclude.
    #[inline(always)]
    pub fn run(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        nest: impl FnMut(&mut Self, BranchState),
    ) {
        self.cascades(nest);
        self.finish(constants, near);
    }

    #[inline(always)]
    pub(super) fn cascades(&mut self, mut nest: impl FnMut(&mut Self, BranchState)) {
        // One place of the call: the nest is inlined into it.
        for _ in 0..MOST_CASCADES {
            crate::effort::cascade();
            let start = BranchState::start(self.doubt || self.retry.is_some());
            nest(self, start);
            if self.retry.is_none() || !self.next_run() {
                break;
            }
        }
    }

    /// Unwinds and sorts next to a reference, marks limits, and sets the status.
    #[inline(always)]
    pub(super) fn finish(&mut self, constants: &ArmConstants<'_, T, N>, near: Option<&[T; N]>) {
        if let Some(near) = near {
            self.next_to(near);
        }
        self.conclude(constants);
    }

    /// Marks solutions outside the limits, and sets the status.
    #[inline(always)]
    pub(super) fn conclude(&mut self, constants: &ArmConstants<'_, T, N>) {
        if constants.limited || !constants.combined.is_empty() {
            self.mark_limits(constants);
        }
        let exact = self.solutions.iter().any(|s| s.flags.contains(Flags::EXACT));
        let status = if exact { Status::Reachable } else { self.unreachable() };
        self.solutions.set_status(status);
    }

    #[inline]
    fn mark_limits(&mut self, constants: &ArmConstants<'_, T, N>) {
        for solution in self.solutions.as_mut_slice() {
            let mut joints = solution.q.iter().zip(constants.limits);
            let inside = joints.all(|(q, limits)| within(*q, *limits, q.abs()));
            if !(inside && constants.combined.iter().all(|limit| limit.holds(&solution.q))) {
                solution.flags |= Flags::OUT_OF_LIMITS;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn unreachable(&self) -> Status<T> {
        // A quartic without real roots has no gap: all that is known is that the target is not near.
        let known = self.least.filter(|gap| *gap > T::ZERO);
        Status::Unreachable { residual: known.unwrap_or(self.constants.reach) }
    }
}
