//! Solutions with a stage in doubt: verified by forward kinematics, refined by a few damped steps, and merged where they
//! coincide.

use super::arm_constants::ArmConstants;
use super::doubts::Doubts;
use super::flip::Verified;
use super::kernel::branch_state::BranchState;
use super::kernel::tolerances::Tolerances;
use super::least_squares::{DescentParams, Iterate, MOST_STEPS, wrap_angles};
use super::measured::SLACK;
use super::search::{Search, VIRTUAL};
use crate::math::wrap;
use crate::{Branch, Flags, Solution};

/// The result of a candidate's verification.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Found {
    /// No solution.
    Nothing,
    /// A solution of the candidate's branch.
    Branch,
    /// A solution that steps reached from a distant start. It may belong to another branch.
    Guess,
}

/// At the defaults a branch with a free or weak joint is refined if it misses by no more, relative to reach or rad.
const FAR: f64 = 0.03;

/// Evaluations kept for the reference of `inverse_near`: the first one, and its steps.
pub(super) const RESERVED: usize = MOST_STEPS + 1;

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'_, T, N, M, S> {
    /// The end of a branch at an awkward pose.
    #[cold]
    #[inline(never)]
    pub(super) fn candidate(&mut self, state: BranchState, q: [T; N], branch: Branch) {
        let mut solution = Solution::exact(q, branch);
        let known = self.known_doubts(state);
        if !state.verify() && known.is_none_or(Doubts::are_settled) {
            if self.near.is_some() && known.is_some() {
                // The reference may be another member of a narrow family.
                self.solutions.mark_awkward();
            }
            if self.solutions.is_awkward() {
                self.list(solution, Found::Branch);
            } else {
                self.solutions.push(solution);
            }
            return;
        }
        let doubts = self.doubts(state);
        solution.flags |= doubts.flags;
        (solution.free, solution.residual) = (doubts.free, doubts.gap);
        if !self.admits(&doubts, branch) {
            return;
        }
        let (constants, movable, again) = (self.constants, !doubts.free_or_weak().is_empty(), self.is_again());
        let miss = constants.relative(&doubts.gap);
        // A missed branch is only a start. In a further run refinement would end where it has ended before, unless the closed
        // form comes much nearer.
        let near_enough = if again {
            constants.tolerates(&doubts.gap) && (S == 0 || miss < self.refine_below(branch))
        } else {
            S == 0 || !movable || doubts.clamped || miss <= T::from_f64(FAR)
        };
        let refines = near_enough && !doubts.is_missed();
        if movable && !refines && miss > T::EXACT {
            self.is_nearly_missed |= !doubts.is_missed();
            // An end that was refined in another run counts with its residual there.
            if doubts.is_missed() || !again {
                self.note_gap(doubts.gap.position.max(doubts.gap.orientation));
            }
            if S > 0 {
                self.open(&doubts, branch, false, &q);
            }
            return;
        }
        let found = self.verify(movable, refines, &mut solution);
        let closes_nowhere = doubts.clamped && !doubts.is_missed() && !again;
        if S > 0 && movable && !(solution.is_exact() || closes_nowhere) {
            // Refinement may have led away from the defaults. In a further run the closed form is the start of a step.
            self.open(&doubts, branch, refines, if again { &q } else { &solution.q });
        }
        // A solution of a further run that does not close is no better than those listed.
        if !(again && !solution.is_exact() && self.solutions.exact().next().is_some()) {
            self.list(solution, found);
        }
    }

    /// Verifies a solution, and refines it if told so. A solution that stays beyond the tolerance is none; its residual
    /// counts as the gap of its branch.
    pub(super) fn verify(&mut self, movable: bool, refines: bool, solution: &mut Solution<T, N>) -> Found {
        let Some(&Verified { start_residual, q, residual, .. }) = self.refined(&solution.q, refines) else {
            self.solutions.mark_incomplete();
            return Found::Nothing;
        };
        (solution.q, solution.residual) = (q, residual);
        let constants = self.constants;
        let (exact, close) = (constants.relative(&residual) <= T::EXACT, constants.tolerates(&start_residual));
        if exact || movable {
            self.solutions.mark_awkward();
        }
        if !exact {
            solution.flags.remove(Flags::EXACT);
            solution.flags |= Flags::APPROXIMATE;
            self.note_gap(residual.position.max(residual.orientation));
            self.is_nearly_missed = true;
            // A guess that comes near by its steps alone, or that is not refined, is no branch of this target.
            return if close && refines { Found::Branch } else { Found::Nothing };
        }
        // A measured arm misses the equations of its table.
        if movable || close || constants.relative(&start_residual) <= self.slack * T::from_f64(SLACK) {
            return Found::Branch;
        }
        // Of a nearly real pair of roots.
        solution.flags |= Flags::BOUNDARY;
        Found::Guess
    }

    /// Evaluates a candidate and refines it, unless it is the wrist flip of the last one; `None` without evaluations left.
    fn refined(&mut self, start: &[T; N], refines: bool) -> Option<&Verified<T, N>> {
        if let (Some(wrist), Some(last)) = (self.constants.wrist, &mut self.verified) {
            last.flip_to(start, wrist);
        } else {
            // One evaluation more than this candidate needs is for the reference.
            let evaluations_left = self.evaluations_left.checked_sub(RESERVED + 1)?;
            let problem = self.problem();
            let mut iterate = Iterate::at(*start);
            problem.evaluate(&mut iterate);
            let start_residual = iterate.residual;
            self.evaluations_left -= 1;
            if refines {
                let info = problem.refine(&mut iterate, DescentParams { evaluations_left, ends_slow: true });
                self.evaluations_left -= info.evaluations;
                if info.is_cut_short && self.constants.relative(&iterate.residual) > T::EXACT {
                    self.solutions.mark_incomplete();
                }
            }
            let (mut q, mut residual) = (iterate.q, iterate.residual);
            if self.constants.tolerates(&start_residual) && !self.constants.tolerates(&residual) {
                // The steps have traded one of the two residuals for the other.
                (q, residual) = (*start, start_residual);
            }
            self.verified = Some(Verified { start: *start, start_residual, q, residual });
        }
        self.verified.as_ref()
    }

    /// Lists a solution, or the better one of two that coincide. An exact root of its own replaces a guess from another one.
    pub(super) fn list(&mut self, mut solution: Solution<T, N>, found: Found) {
        let constants = self.constants;
        let is_listed = || self.solutions.exact().any(|other| coincide(constants, &other.q, &solution.q));
        if found == Found::Nothing || found == Found::Guess && is_listed() {
            return;
        }
        if solution.free.contains(VIRTUAL) {
            solution.free = solution.free.without(VIRTUAL) | constants.stands_for;
        }
        let again = self.is_again();
        if S > 0 && again && solution.is_exact() {
            // Solutions of the branch with a free joint that close only within the tolerance.
            let near_miss = Flags::APPROXIMATE | Flags::FREE;
            self.solutions.retain(|other| other.branch != solution.branch || !other.flags.contains(near_miss));
        }
        let mut others = self.solutions.as_mut_slice().iter_mut();
        let Some(twin) = others.find(|other| coincide(constants, &other.q, &solution.q)) else {
            self.solutions.push(solution);
            return;
        };
        // A root of its own is no guess from another one.
        let names =
            solution.is_exact() && twin.flags.contains(Flags::BOUNDARY) && !solution.flags.contains(Flags::BOUNDARY);
        if names || constants.relative(&solution.residual) < constants.relative(&twin.residual) {
            *twin = solution;
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
        let problem = self.problem();
        let mut iterate = Iterate::at(start);
        problem.evaluate(&mut iterate);
        // Only from a reference that already is close: farther away there is no "same place" to keep.
        if !(constants.relative(&iterate.residual) <= most) {
            return;
        }
        if !self.solutions.keeps_place() {
            // Worth looking for if the first step closes the target, less than half of the way to a solution that is listed.
            let ways = self.solutions.exact().map(|other| square_apart(constants, &other.q, &iterate.q));
            let nearest = ways.fold(T::INFINITY, T::min);
            if problem.first_step(&iterate) * T::from_f64(4.0) > nearest {
                return;
            }
        }
        let evaluations_left = self.evaluations_left.saturating_sub(1);
        problem.refine(&mut iterate, DescentParams { evaluations_left, ends_slow: false });
        let (q, residual) = (iterate.q, iterate.residual);
        if !(constants.relative(&residual) <= T::EXACT) {
            return;
        }
        let nearest = self.nearest(&q).map_or(Solution::EMPTY, |nearest| *nearest);
        let mut held = Solution { q, residual, ..nearest };
        held.flags.remove(Flags::APPROXIMATE);
        held.flags |= Flags::EXACT;
        // The same place, but nearer to the reference: beside a limit a small step would be a whole turn.
        if (coincide(constants, &nearest.q, &q) || !self.solutions.push(held))
            && let Some(nearest) = self.nearest(&q)
        {
            *nearest = held;
        }
        self.solutions.retain(|other| other.q == q || !coincide(constants, &other.q, &q));
    }

    /// The listed solution nearest to a joint vector.
    fn nearest(&mut self, q: &[T; N]) -> Option<&mut Solution<T, N>> {
        let constants = self.constants;
        let square = |other: &Solution<T, N>| square_apart(constants, &other.q, q);
        let solutions = self.solutions.as_mut_slice().iter_mut();
        solutions.min_by(|a, b| square(a).partial_cmp(&square(b)).unwrap_or(core::cmp::Ordering::Equal))
    }
}

/// The squared distance of two joint vectors, each joint on the turn that is nearest.
#[inline(never)]
fn square_apart<T: Tolerances, const N: usize>(constants: &ArmConstants<T, N>, a: &[T; N], b: &[T; N]) -> T {
    distances(constants, a, b).fold(T::ZERO, |sum, distance| sum + distance * distance)
}

/// Returns true if two joint vectors are one solution.
#[inline(never)]
pub(super) fn coincide<T: Tolerances, const N: usize>(constants: &ArmConstants<T, N>, a: &[T; N], b: &[T; N]) -> bool {
    distances(constants, a, b).all(|distance| distance <= T::COINCIDENT)
}

/// The distance of two joint vectors in each joint.
#[inline]
pub(super) fn distances<T: Tolerances, const N: usize>(
    constants: &ArmConstants<T, N>,
    a: &[T; N],
    b: &[T; N],
) -> impl Iterator<Item = T> {
    let joints = a.iter().zip(b).enumerate();
    joints.map(|(joint, (a, b))| apart(*a - *b, constants.prismatic.contains(joint), constants.reach))
}

/// How far apart two values of a joint are: a distance in reaches, or the angle, whichever way round is shorter.
#[inline(never)]
pub(super) fn apart<T: Tolerances>(difference: T, slides: bool, reach: T) -> T {
    if slides { (difference / reach).abs() } else { wrap(difference).abs() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::arm_constants::Evaluate;
    use crate::{Jacobian, JointMask, Pose, Residual, Solutions, Status};

    const CONSTANTS: ArmConstants<'_, f64, 1> = ArmConstants {
        limits: &[[-4.0, 4.0]],
        combined: &[],
        weights: &[1.0],
        limited: false,
        prismatic: JointMask::NONE,
        stands_for: JointMask::NONE,
        wrist: None,
        reach: 1.0,
        tolerance: Residual { position: 1e-6, orientation: 1e-6 },
    };

    /// An arm that brings its tool to `x + x^2 / 4`.
    struct Curve;

    impl Evaluate<f64, 1> for Curve {
        fn evaluate(&self, [x]: &[f64; 1]) -> (Pose<f64>, Jacobian<f64, 1>) {
            let mut jacobian = Jacobian { rows: [[0.0]; 6] };
            jacobian.rows[0] = [1.0 + x / 2.0];
            (Pose { rotation: [[0.0; 3]; 3], translation: [x + x * x / 4.0, 0.0, 0.0] }, jacobian)
        }
    }

    /// A candidate that evaluations run out for is lost, and the list says so. Those for the reference stay.
    #[test]
    fn evaluations_that_run_out_leave_the_list_incomplete() {
        for (evaluations, exact, complete) in
            [(0, false, false), (1, false, false), (3, false, false), (20, true, true)]
        {
            let mut solutions = Solutions::<f64, 1, 4>::new(Status::Reachable);
            let mut search = Search::<f64, 1, 4, 1>::new(&CONSTANTS, &Curve, &[0.0; 3], None, &mut solutions);
            search.evaluations_left = RESERVED + evaluations;
            let mut solution = Solution::exact([0.4], Branch::NONE);
            let found = search.verify(true, true, &mut solution);
            assert!(search.evaluations_left >= RESERVED, "{}", search.evaluations_left);
            assert_eq!((found == Found::Branch, search.solutions.is_complete()), (exact, complete), "{evaluations}");
        }
    }
}
