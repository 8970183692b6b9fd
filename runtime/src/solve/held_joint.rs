//! The search of an arm whose inverse holds a joint: candidates become solutions.
//!
//! A kernel of [`denhart_core`] gives candidates: joint vectors near solutions. Each is evaluated, refined by damped
//! least squares where it misses by more than rounding, compared with those that are listed, and listed. A candidate
//! that several roots share is in doubt: its solution may be one that is listed, or lie where branches meet.

use core::ops::ControlFlow;

use denhart_core::held_joint::{Candidate, Outcome};

use super::arm_constants::ArmConstants;
use super::kernel::tolerances::Tolerances;
use super::least_squares::{DescentParams, Iterate, wrap_angles};
use super::search::Search;
use super::smallest_pivot::smallest_pivot;
use super::verify::{RESERVED, apart, coincide};
use crate::effort::{MOST_EVALUATIONS, MOST_HELD_JOINT_EVALUATIONS};
use crate::{Branch, Elbow, Flags, JointMask, Residual, Shoulder, Solution};

/// The search of an arm with `N` joints and at most `M` solutions whose inverse holds a joint.
pub type HeldJointSearch<'a, T, const N: usize, const M: usize> = Search<'a, T, N, M, 0>;

/// Two solutions in doubt that are no further apart than this, in rad and reaches, may be one. A fourfold root is known to
/// the fourth root of rounding.
const NEIGHBORS: f64 = 0.01;

/// A candidate whose virtual joint turns the tool by more than this, rad, is no solution of an arm without that joint. A
/// fourfold root, known to the fourth root of rounding, turns by far less.
const TURNED: f64 = 0.1;

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'_, T, N, M, S> {
    /// Where each joint stays if the target leaves it free: its reference value; without one 0, or the limit nearest to 0.
    #[inline]
    pub fn defaults(&self) -> [T; N] {
        self.defaults
    }

    /// Lists the solutions that `solve` gives candidates for, numbers them, and ends the call as
    /// [`run`](Search::run) does.
    ///
    /// `solve` passes each candidate on and stops where that breaks; `place` puts the values of the six joints in the
    /// places of the arm's joints, and the given ones beside them. A call takes at most
    /// [`MOST_HELD_JOINT_EVALUATIONS`].
    #[inline]
    pub fn run_held_joint(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        place: impl Fn([T; 6]) -> [T; N],
        solve: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
    ) {
        self.run_with_turn(constants, near, |joints| (place(joints), T::ZERO), solve);
    }

    /// Like [`run_held_joint`](Self::run_held_joint) for a pose of five joints, whose chain has a virtual joint that turns the
    /// tool.
    ///
    /// `place` gives that turn too, rad: 0 at a solution of the arm. A candidate that turns by more than a tenth of a radian
    /// is no solution: it is evaluated, for the residual of [`Status::Unreachable`](crate::Status::Unreachable), but not
    /// refined.
    #[inline]
    pub fn run_with_turn(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        place: impl Fn([T; 6]) -> ([T; N], T),
        solve: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
    ) {
        self.gather(place, solve);
        // A candidate between the two solutions of a fold may have stayed approximate.
        if self.solutions.iter().any(|solution| !solution.is_exact()) {
            self.unfold();
        }
        self.number_roots();
        self.finish(constants, near);
    }

    /// Like [`run_held_joint`](Self::run_held_joint) for a measured arm, whose links are `off` their table, relative to reach and
    /// in rad. The other solution of a fold is listed, and that to which the reference leads.
    #[inline]
    pub fn run_unfolded(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        off: T,
        place: impl Fn([T; 6]) -> [T; N],
        solve: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
    ) {
        self.slack = off;
        self.gather(|joints| (place(joints), T::ZERO), solve);
        if self.is_near_singular() {
            self.unfold();
        }
        self.number_roots();
        self.finish_measured(constants, near, |_, _| {});
    }

    /// Like [`run_unfolded`](Self::run_unfolded) where the table has names for its branches: `name` gives that of a joint
    /// vector. Solutions that share a name have numbers, but for the first. The call may begin with
    /// [`start_from_table`](Search::start_from_table): then `solve` is called where a solution or a missed branch of the table
    /// is nearly singular.
    #[inline]
    pub fn run_named(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        place: impl Fn([T; 6]) -> [T; N],
        name: impl Fn(&[T; N]) -> Branch,
        solve: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
    ) {
        if self.slack == T::ZERO || self.is_near_singular() {
            self.gather(|joints| (place(joints), T::ZERO), solve);
            self.unfold();
        }
        self.finish_measured(constants, near, |q, branch| *branch = name(q));
    }

    /// Lists the solutions that `solve` gives candidates for.
    #[inline]
    fn gather(
        &mut self,
        place: impl Fn([T; 6]) -> ([T; N], T),
        solve: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
    ) {
        crate::effort::holding_a_joint();
        // With what the table's stages have left, if the call began with them.
        self.evaluations_left += MOST_HELD_JOINT_EVALUATIONS - MOST_EVALUATIONS;
        let outcome = solve(&mut |candidate| {
            let (q, turn) = place(candidate.joints);
            self.consider(candidate, q, turn.abs() <= T::from_f64(TURNED))
        });
        if !outcome.is_complete {
            self.solutions.mark_incomplete();
        }
        // Where several joints are free at once, or rounding hides a root, no root leads to the solution at a reference.
        self.solutions.mark_awkward();
    }

    /// Makes a candidate a solution, if it closes. Breaks without evaluations left.
    #[inline(never)]
    fn consider(&mut self, candidate: &Candidate<T>, mut q: [T; N], is_near: bool) -> ControlFlow<()> {
        if !q.iter().all(|value| value.is_finite()) {
            return ControlFlow::Continue(());
        }
        if self.evaluations_left <= RESERVED {
            self.solutions.mark_incomplete();
            return ControlFlow::Break(());
        }
        let (constants, given) = (self.constants, self.goal.given());
        wrap_angles(&mut q, given, constants.prismatic);
        // A second cut gives most solutions once more.
        if candidate.free == 0 && self.solutions.exact().any(|other| coincide(constants, &other.q, &q)) {
            return ControlFlow::Continue(());
        }
        let (q, residual) = self.settled(&q, is_near);
        let mut solution = Solution::exact(q, name(candidate.signs));
        solution.residual = residual;
        let is_exact = constants.relative(&solution.residual) <= T::EXACT;
        if !is_exact && self.evaluations_left <= RESERVED {
            // Cut short: what it would have become is not known.
            self.solutions.mark_incomplete();
            return ControlFlow::Break(());
        }
        if !is_exact {
            self.note_gap(residual.position.max(residual.orientation));
            self.is_nearly_missed = true;
            if !constants.tolerates(&solution.residual) {
                return ControlFlow::Continue(());
            }
            solution.flags = Flags::APPROXIMATE;
        }
        solution.free = self.in_places_of_the_arm(candidate.free);
        if !solution.free.is_empty() {
            solution.flags |= Flags::FREE;
        }
        let is_doubtful = candidate.is_doubtful || !is_exact;
        let twin = match is_doubtful {
            true => self.neighbor(&solution),
            false => self.solutions.iter().position(|other| coincide(constants, &other.q, &solution.q)),
        };
        if is_doubtful && twin.is_none() && solution.free.is_empty() && self.is_singular(&solution.q) {
            solution.flags |= Flags::BOUNDARY;
        }
        let is_new = is_exact && !twin.and_then(|place| self.solutions.get(place)).is_some_and(Solution::is_exact);
        self.keep(solution, twin);
        // A root that two solutions share leads to one of them. Those of a measured arm are unfolded at the end.
        if candidate.is_doubtful && is_new && solution.free.is_empty() && self.slack == T::ZERO {
            self.unfold_one(&solution);
        }
        ControlFlow::Continue(())
    }

    /// A joint vector, refined if it `is_near` a solution, and its residual. Takes an evaluation at least, which has to be left
    /// beside those that are reserved. Out of line: an iterate is on the stack for as long as it takes.
    #[inline(never)]
    pub(super) fn settled(&mut self, q: &[T; N], is_near: bool) -> ([T; N], Residual<T>) {
        let (problem, evaluations_left) = (self.problem(), self.evaluations_left.saturating_sub(RESERVED + 1));
        let mut iterate = Iterate::at(*q);
        problem.evaluate(&mut iterate);
        let mut taken = 1;
        if is_near && !(self.constants.relative(&iterate.residual) <= T::ROUNDING) {
            // A root that several solutions share is known to few digits: the way from there may be slow.
            let params = DescentParams { evaluations_left, ends_slow: false };
            taken += problem.refine(&mut iterate, params).evaluations;
        }
        self.evaluations_left = self.evaluations_left.saturating_sub(taken);
        (iterate.q, iterate.residual)
    }

    /// The listed solution that a doubtful one cannot be told from: halfway between them the target is missed by no more
    /// than at the two.
    #[inline(never)]
    fn neighbor(&mut self, solution: &Solution<T, N>) -> Option<usize> {
        let constants = self.constants;
        let mut place = 0;
        while let Some(other) = self.solutions.get(place) {
            let (mut far, mut between) = (T::ZERO, solution.q);
            for (joint, (value, other)) in between.iter_mut().zip(&other.q).enumerate() {
                let slides = constants.prismatic.contains(joint);
                let to = if slides { *other - *value } else { crate::math::wrap(*other - *value) };
                far = far.max(apart(to, slides, constants.reach));
                *value += to * T::HALF;
            }
            if far <= T::COINCIDENT {
                return Some(place);
            }
            if far <= T::from_f64(NEIGHBORS) && self.evaluations_left > RESERVED {
                self.evaluations_left -= 1;
                let mut iterate = Iterate::at(between);
                self.problem().evaluate(&mut iterate);
                let residuals = constants.relative(&solution.residual).max(constants.relative(&other.residual));
                let bound = residuals * T::TWO + T::EPSILON * T::from_f64(4.0);
                if constants.relative(&iterate.residual) <= bound {
                    return Some(place);
                }
            }
            place += 1;
        }
        None
    }

    /// Returns true if the target leaves a combination of the joints undetermined at `q`. Out of line: the Jacobian is on the
    /// stack for as long as it takes.
    #[inline(never)]
    fn is_singular(&mut self, q: &[T; N]) -> bool {
        if self.evaluations_left <= RESERVED {
            return false;
        }
        self.evaluations_left -= 1;
        let (pose, mut jacobian) = self.arm.evaluate(q);
        self.goal.restrict(&pose, &mut jacobian);
        smallest_pivot(self.constants, self.goal.given(), &jacobian) <= T::WEAK
    }

    /// Lists a solution, or of two that are one the better.
    fn keep(&mut self, solution: Solution<T, N>, twin: Option<usize>) {
        let constants = self.constants;
        let better = |other: &Solution<T, N>| {
            let (own, listed) = (constants.relative(&solution.residual), constants.relative(&other.residual));
            // Of exact ones that leaves the joint where it is wanted.
            let is_family = other.is_exact() && !other.free.is_empty();
            let becomes_one = solution.is_exact() && other.free.is_empty() && !solution.free.is_empty();
            own < listed && !is_family || becomes_one
        };
        if let Some(other) = twin.and_then(|place| self.solutions.as_mut_slice().get_mut(place)) {
            if better(other) {
                let boundary = other.flags.contains(Flags::BOUNDARY);
                *other = solution;
                other.flags |= if boundary { Flags::BOUNDARY } else { Flags::default() };
                // The better one may be a third one, too.
                let mut is_first = true;
                self.solutions.retain(|other| {
                    let is_same = coincide(constants, &other.q, &solution.q);
                    let keep = !is_same || is_first;
                    is_first &= !is_same;
                    keep
                });
            }
            return;
        }
        if !self.solutions.push(solution) {
            self.solutions.mark_incomplete();
            let worse = self.solutions.as_mut_slice().iter_mut().find(|other| !other.is_exact());
            if let Some(worse) = worse.filter(|_| solution.is_exact()) {
                *worse = solution;
            }
        }
    }

    /// A mask of the six joints as one of the arm's joints, among which those that are given have a place.
    fn in_places_of_the_arm(&self, six: u8) -> JointMask {
        let given = self.goal.given();
        let solved = (0..N).filter(|joint| !given.contains(*joint));
        let free = solved.enumerate().filter(|(place, _)| six >> *place & 1 == 1);
        let own = free.fold(JointMask::NONE, |mask, (_, joint)| mask | JointMask::single(joint));
        // A virtual joint is the last of the six.
        if six >> 5 & 1 == 1 { own | self.constants.stands_for } else { own }
    }

    /// Numbers the solutions with the same signs in the order of the held joint's roots.
    fn number_roots(&mut self) {
        let mut place = 0;
        while let Some(solution) = self.solutions.get(place) {
            let name = solution.branch;
            let before = self.solutions.iter().take(place).filter(|other| other.branch.with_root(0) == name).count();
            if let Some(solution) = self.solutions.as_mut_slice().get_mut(place) {
                solution.branch = name.with_root_index(before);
            }
            place += 1;
        }
    }
}

/// The signs of a branch as its shoulder and elbow.
fn name(signs: Option<(bool, bool)>) -> Branch {
    let side = |is_positive: bool| usize::from(!is_positive);
    match signs {
        Some((v, w)) => Branch::NONE.with_shoulder(Shoulder::of_root(side(v))).with_elbow(Elbow::of_root(side(w))),
        None => Branch::NONE,
    }
}
