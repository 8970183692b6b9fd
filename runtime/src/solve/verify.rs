//! Solutions with a stage in doubt: verified by forward kinematics, refined by a few damped steps, and merged where they
//! coincide.

use super::arm_constants::ArmConstants;
use super::doubts::Doubts;
use super::flip::Verified;
use super::kernel::branch_state::BranchState;
use super::kernel::tolerances::Tolerances;
use super::least_squares::{Iterate, MOST_STEPS, refine, wrap_angles};
use super::search::{SLACK, Search, VIRTUAL};
use crate::math::wrap;
use crate::{Branch, Flags, Solution};

/// The result of a candidate's verification.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Found {
    /// No solution.
    Nothing,
    /// A solution of the candidate's branch.
    Branch,
    /// A solution of the candidate's branch that no other solution is close to.
    Distinct,
    /// A solution that the candidate was not close to. It belongs to another root, unless that root has no solution of
    /// its own.
    Guess,
}

/// Evaluations kept for the reference of `inverse_near`: the first one, and its steps.
pub(super) const RESERVED: usize = MOST_STEPS + 1;

impl<T: Tolerances, const N: usize, const M: usize, const D: usize, const S: usize> Search<'_, T, N, M, D, S> {
    /// The end of a branch at an awkward pose.
    #[cold]
    #[inline(never)]
    pub(super) fn candidate(&mut self, state: BranchState, q: [T; N], branch: Branch) {
        let mut solution = Solution::exact(q, branch);
        let mut found = Found::Branch;
        let doubts = self.known_doubts(state);
        if !state.verify() && doubts.is_none_or(Doubts::are_settled) {
            if self.near.is_some() && doubts.is_some() {
                // The reference may be another member of a narrow family.
                self.solutions.mark_awkward();
            }
            if !self.solutions.is_awkward() {
                found = Found::Distinct;
            }
        } else {
            let doubts = self.doubts(state);
            solution.flags |= doubts.flags;
            (solution.free, solution.residual) = (doubts.free, doubts.gap);
            if !self.is_candidate(&doubts, &solution) {
                return;
            }
            let movable = !doubts.free_or_weak().is_empty();
            found = self.verified(movable, &mut solution);
            if S > 0 && movable && !(solution.is_exact() || doubts.clamped) {
                // At the defaults the miss says little, and refinement may have led away from there. In a further run the
                // closed form is the start of a step.
                if self.is_again() {
                    let miss = self.constants.relative(&doubts.gap);
                    self.open(&doubts, branch, miss, &q);
                } else {
                    self.open(&doubts, branch, T::MAX, &solution.q);
                }
            }
        }
        // What a further run does not close is no better than what is there.
        let worse = self.is_again() && !solution.is_exact() && self.solutions.exact().next().is_some();
        if found == Found::Nothing || worse {
            return;
        }
        self.finished(&mut solution, found);
    }

    /// Lists the solution to which steps from a joint vector of an open branch lead.
    pub(super) fn iterated(&mut self, solution: &mut Solution<T, N>) {
        self.verified = None;
        let found = self.verified(true, solution);
        if found != Found::Nothing && solution.is_exact() {
            self.finished(solution, found);
        }
    }

    /// Names the joints of a solution, and lists it.
    fn finished(&mut self, solution: &mut Solution<T, N>, found: Found) {
        if solution.free.contains(VIRTUAL) {
            solution.free = solution.free.without(VIRTUAL) | self.constants.stands_for;
        }
        self.list(solution, found);
    }

    /// Verifies a solution; refines it if that closes it. What stays beyond the tolerance is no solution; its residual
    /// counts as the gap of its branch.
    fn verified(&mut self, movable: bool, solution: &mut Solution<T, N>) -> Found {
        let constants = self.constants;
        let Some(Verified { q, residual, close, is_within_slack, .. }) = self.refined(&solution.q) else {
            return Found::Nothing;
        };
        (solution.q, solution.residual) = (*q, *residual);
        let (close, is_within_slack) = (*close, *is_within_slack);
        let exact = constants.relative(&solution.residual) <= T::EXACT;
        if !exact {
            solution.flags.remove(Flags::EXACT);
            solution.flags |= Flags::APPROXIMATE;
        }
        if exact || movable {
            self.solutions.mark_awkward();
        }
        // A guess that comes near by its steps alone, without closing, is no branch of this target.
        let listed = exact || close;
        if !exact {
            self.misses_by(&solution.residual);
            self.is_nearly_missed = true;
        }
        match listed {
            false => Found::Nothing,
            true if exact && !movable && !close && !is_within_slack => {
                // Of a nearly real pair of roots.
                solution.flags |= Flags::BOUNDARY;
                Found::Guess
            }
            true => Found::Branch,
        }
    }

    /// Evaluates a candidate and refines it, unless it is the wrist flip of the last one; `None` without evaluations left.
    fn refined(&mut self, start: &[T; N]) -> Option<&Verified<T, N>> {
        if let (Some(wrist), Some(last)) = (self.constants.wrist, &mut self.verified) {
            last.flip_to(start, wrist);
        } else {
            // One evaluation more than this candidate needs is for the reference.
            let mut evaluations_left = self.evaluations_left.checked_sub(RESERVED + 1)?;
            let mut iterate = Iterate::at(*start);
            iterate.evaluate(self.constants, self.goal, self.arm);
            let close = self.constants.tolerates(&iterate.residual);
            let is_within_slack =
                !close && self.constants.relative(&iterate.residual) <= self.slack * T::from_f64(SLACK);
            refine(self.constants, self.goal, self.arm, &mut iterate, &mut evaluations_left);
            self.evaluations_left = evaluations_left + RESERVED;
            self.verified =
                Some(Verified { start: *start, q: iterate.q, residual: iterate.residual, close, is_within_slack });
        }
        self.verified.as_ref()
    }

    /// Lists a solution, or the better one of two that coincide. An exact root of its own replaces a guess from another one.
    fn list(&mut self, solution: &Solution<T, N>, found: Found) {
        let constants = self.constants;
        let again = self.is_again();
        if S > 0 && again && solution.is_exact() {
            self.drop_near_miss(solution.branch);
        }
        let mut others = self.solutions.as_mut_slice().iter_mut();
        let twin = others.find(|other| found != Found::Distinct && coincident(constants, &other.q, &solution.q));
        let Some(twin) = twin else {
            self.solutions.push(*solution);
            return;
        };
        if found == Found::Guess && twin.is_exact() {
            return;
        }
        // A root of its own is no guess from another one.
        let names =
            solution.is_exact() && twin.flags.contains(Flags::BOUNDARY) && !solution.flags.contains(Flags::BOUNDARY);
        if names || constants.relative(&solution.residual) < constants.relative(&twin.residual) {
            *twin = *solution;
        }
        // One branch that is found again is no two roots.
        if !(again && twin.branch == solution.branch) {
            twin.flags |= Flags::BOUNDARY;
        }
    }

    /// Unwinds the joints next to the reference, and sorts nearest first. The reference's own place on a singular family is
    /// kept.
    #[inline(never)]
    pub(super) fn next_to(&mut self, near: &[T; N]) {
        if self.solutions.is_awkward() {
            self.hold(near, T::DOUBTFUL);
        }
        self.unwind(near);
    }

    /// Unwinds the joints next to the reference (inside the limits where some turn is), and sorts nearest first.
    #[inline(always)]
    pub(super) fn unwind(&mut self, near: &[T; N]) {
        let constants = self.constants;
        self.solutions.sort_by_number(|solution| {
            let joints = solution.q.iter_mut().zip(near).zip(constants.limits.iter().zip(constants.weights));
            joints.enumerate().fold(T::ZERO, |sum, (joint, ((value, reference), (limits, weight)))| {
                let step = if constants.prismatic.contains(joint) {
                    (*value - *reference) / constants.reach
                } else {
                    *value = crate::windings::next_to(*value, *reference, *limits);
                    *value - *reference
                };
                sum + *weight * step * step
            })
        });
    }

    /// Near a singularity a whole family of joint vectors closes within rounding. The member next to the reference is
    /// what a controller wants. This member is found from the reference itself, if that misses the target by at most `most`,
    /// relative to reach and in rad, and listed if no solution lies there yet. Where the list keeps no place
    /// (`Solutions::keeps_place`), the first step has to promise a member much nearer than what is listed.
    #[cold]
    #[inline(never)]
    pub(super) fn hold(&mut self, near: &[T; N], most: T) {
        let constants = self.constants;
        let mut start = self.goal.placed(*near);
        wrap_angles(&mut start, self.goal.given(), constants.prismatic);
        let mut iterate = Iterate::at(start);
        iterate.evaluate(constants, self.goal, self.arm);
        // Only from a reference that already is close: farther away there is no "same place" to keep.
        if !(constants.relative(&iterate.residual) <= most) {
            return;
        }
        if !self.solutions.keeps_place() {
            // Worth looking for if the first step closes the target, less than half of the way to a solution that is listed.
            let ways = self.solutions.exact().map(|other| square_apart(&other.q, &iterate.q));
            let nearest = ways.fold(T::INFINITY, T::min);
            if iterate.first_step(self.goal.given()) * T::from_f64(4.0) > nearest {
                return;
            }
        }
        let mut rest = self.evaluations_left.saturating_sub(1);
        refine(constants, self.goal, self.arm, &mut iterate, &mut rest);
        let (q, residual) = (iterate.q, iterate.residual);
        if !(constants.relative(&residual) <= T::EXACT) {
            return;
        }
        let nearer = |a: &&mut Solution<T, N>, b: &&mut Solution<T, N>| {
            square_apart(&a.q, &q).partial_cmp(&square_apart(&b.q, &q)).unwrap_or(core::cmp::Ordering::Equal)
        };
        let same = self.solutions.as_mut_slice().iter_mut();
        if let Some(same) = same.filter(|other| coincident(constants, &other.q, &q)).min_by(nearer) {
            // The same place, but nearer to the reference: beside a limit a small step would be a whole turn.
            (same.q, same.residual) = (q, residual);
            same.flags.remove(Flags::APPROXIMATE);
            same.flags |= Flags::EXACT;
            let mut first = true;
            self.solutions.retain(|other| {
                let keep = other.q == q && first || !coincident(constants, &other.q, &q);
                first &= other.q != q;
                keep
            });
            return;
        }
        let nearest = self.solutions.as_mut_slice().iter_mut().min_by(nearer);
        let mut held = nearest.map_or(Solution::EMPTY, |nearest| *nearest);
        (held.q, held.residual) = (q, residual);
        held.flags.remove(Flags::APPROXIMATE);
        held.flags |= Flags::EXACT;
        let full = !self.solutions.push(held);
        if full && let Some(nearest) = self.solutions.as_mut_slice().iter_mut().min_by(nearer) {
            *nearest = held;
        }
    }
}

/// The squared distance of two joint vectors, each joint on the turn that is nearest.
#[inline(never)]
fn square_apart<T: Tolerances, const N: usize>(a: &[T; N], b: &[T; N]) -> T {
    a.iter().zip(b).fold(T::ZERO, |sum, (a, b)| sum + wrap(*a - *b) * wrap(*a - *b))
}

/// Returns true if two joint vectors are one solution.
#[inline(never)]
pub(super) fn coincident<T: Tolerances, const N: usize>(
    constants: &ArmConstants<T, N>,
    a: &[T; N],
    b: &[T; N],
) -> bool {
    a.iter()
        .zip(b)
        .zip(0..)
        .all(|((a, b), joint)| apart(*a - *b, constants.prismatic.contains(joint), constants.reach) <= T::COINCIDENT)
}

/// How far apart two values of a joint are: a distance in reaches, or the angle, whichever way round is shorter.
#[inline(never)]
pub(super) fn apart<T: Tolerances>(difference: T, slides: bool, reach: T) -> T {
    if slides { (difference / reach).abs() } else { wrap(difference).abs() }
}
