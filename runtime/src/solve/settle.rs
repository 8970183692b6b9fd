//! The end of a search: doubtful solutions are checked in full, coinciding ones merged, and with a reference the
//! joints are unwound next to it.

use super::doubts::Doubts;
use super::refine::{Evaluate, NOISE, STIFF, approached, refine, relative};
use super::{Goal, Search, Tolerances};
use crate::math::wrap;
use crate::windings::next_to;
use crate::{Flags, JointMask, Residual, Solution};

/// Newton steps for a solution that is already close.
const STEPS: usize = 24;
/// Steps for one whose free joint has to move.
pub(super) const FREE_STEPS: usize = 40;
/// Steps for one that no place of its free joint has met: where the arm is also at the edge of its reach, several roots
/// meet, towards which every step gains the same small part.
const LAST_STEPS: usize = 300;

impl<T: Tolerances, G: Goal<T, N>, const N: usize, const M: usize> Search<'_, T, G, N, M> {
    /// Checks every doubtful solution with forward kinematics; refines it if that closes it. What stays beyond the
    /// tolerance is no solution; its residual counts as the gap of its branch.
    #[cold]
    #[inline(never)]
    pub(super) fn settle(&mut self, evaluate: &impl Evaluate<T, N>) {
        let found = *self.solutions;
        let Doubts { elsewhere, solutions, loose, .. } = *self.doubts();
        let before = elsewhere.settled;
        self.solutions.truncate(before);
        for (index, solution) in found.iter().enumerate().skip(before) {
            let doubtful = solutions.checked_shr(index as u32).unwrap_or(0) & 1 == 1;
            let loose = loose.get(index).copied().unwrap_or(JointMask::NONE);
            let (checked, near) =
                if doubtful { self.checked(solution, loose, evaluate) } else { (Some(*solution), true) };
            let closes = checked.is_some_and(|checked| checked.flags.contains(Flags::EXACT));
            if doubtful && !closes && !solution.free.is_empty() {
                self.seek(solution.branch, solution.free);
            }
            let Some(checked) = checked else { continue };
            let (facts, again) = (self.facts, elsewhere.again());
            let twin = self.solutions.as_mut_slice().iter_mut().find(|other| {
                coincident(&other.q, &checked.q, facts.reach, |joint| facts.prismatic.contains(joint))
                    // What did not close with the free joint at home.
                    || again && other.branch == checked.branch && other.flags.contains(Flags::APPROXIMATE | Flags::FREE)
            });
            let Some(twin) = twin else {
                self.solutions.push(checked);
                continue;
            };
            // Of two that coincide the one that closes better stays. They mark a boundary if both came from there, not
            // if one is a false candidate that was refined into the other.
            let met = if near { Flags::BOUNDARY } else { Flags::NONE } | twin.flags | checked.flags;
            if relative(facts, &checked.residual) < relative(facts, &twin.residual) {
                *twin = checked;
            }
            twin.flags |= if met.contains(Flags::BOUNDARY) { Flags::BOUNDARY } else { Flags::NONE };
        }
    }

    /// The solution after a full check, if it is one, and whether it was close before it was refined.
    fn checked(
        &mut self,
        solution: &Solution<T, N>,
        loose: JointMask,
        evaluate: &impl Evaluate<T, N>,
    ) -> (Option<Solution<T, N>>, bool) {
        let (facts, tolerance) = (self.facts, self.facts.tolerance);
        let found = self.goal.residual(&solution.q, &evaluate(&solution.q).0);
        let near = relative(facts, &found) <= T::CLOSE;
        let (q, mut residual) = if relative(facts, &found) <= T::EXACT {
            self.polished(&solution.q, found, evaluate)
        } else {
            self.improved(solution, found, loose, evaluate)
        };
        residual.orientation += self.deviation;
        let mut checked = Solution { q, residual, ..*solution };
        if relative(facts, &residual) <= T::EXACT {
            return (Some(checked), near);
        }
        checked.flags.remove(Flags::EXACT);
        checked.flags |= Flags::APPROXIMATE;
        // A guess that did not close is none of the branches of this target, but better than nothing.
        if (near || self.solutions.is_empty())
            && residual.position <= tolerance.position
            && residual.orientation <= tolerance.orientation + self.deviation
        {
            return (Some(checked), near);
        }
        let gap = residual.position.max(residual.orientation);
        let gap = if gap.is_finite() { gap } else { T::MAX };
        self.doubts().misses(gap);
        (None, near)
    }

    /// A solution that closes. Near a singularity what is left of its residual may still move the joints.
    fn polished(&self, q: &[T; N], found: Residual<T>, evaluate: &impl Evaluate<T, N>) -> ([T; N], Residual<T>) {
        let facts = self.facts;
        if !(relative(facts, &found) > T::from_f64(NOISE) * T::EPSILON) {
            return (*q, found);
        }
        let (next, refined) = refine(facts, self.goal, q, evaluate, FREE_STEPS);
        if relative(facts, &refined) < relative(facts, &found) { (next, refined) } else { (*q, found) }
    }

    /// A solution that does not close, made to close, or brought as near to the target as it goes.
    fn improved(
        &mut self,
        solution: &Solution<T, N>,
        found: Residual<T>,
        loose: JointMask,
        evaluate: &impl Evaluate<T, N>,
    ) -> ([T; N], Residual<T>) {
        let (facts, goal, elsewhere) = (self.facts, self.goal, self.doubts().elsewhere);
        let steps = match loose.is_empty() {
            true => STEPS,
            false if elsewhere.last() => LAST_STEPS,
            false => FREE_STEPS,
        };
        let (q, refined) = refine(facts, goal, &solution.q, evaluate, steps);
        if relative(facts, &refined) <= T::EXACT {
            return (q, refined);
        }
        let missed = solution.residual.position.max(solution.residual.orientation * facts.reach);
        let clamped = missed > T::ROUNDING * facts.reach;
        let mut best = (solution.q, found);
        if clamped {
            // The joints before the clamped one may yet come closer. The orientation is kept, not traded for position,
            // so that the residual is the distance missed.
            let (q, approached) = approached(facts, goal, &q, evaluate, FREE_STEPS);
            let share = approached.position / (facts.reach * T::from_f64(STIFF));
            let kept = approached.orientation <= found.orientation + T::EXACT + share;
            if kept && approached.position < found.position {
                best = (q, approached);
            }
        } else if relative(facts, &refined) < relative(facts, &found) {
            best = (q, refined);
        }
        let singular = !clamped && relative(facts, &found) <= T::CLOSE;
        // In a pass for a free joint elsewhere the further passes are the restarts.
        let alone = !elsewhere.again() || elsewhere.last();
        if alone && (singular || !loose.is_empty()) {
            let (q, restarted) = self.restarted(&solution.q, loose, evaluate);
            let listed = relative(facts, &best.1) <= relative(facts, &facts.tolerance);
            if relative(facts, &restarted) <= if listed { T::EXACT } else { relative(facts, &best.1) } {
                best = (q, restarted);
            }
        }
        best
    }

    /// Unwinds the joints next to the reference (inside the limits where some turn is), keeps the reference's own place
    /// on a singular family, and sorts nearest first.
    #[inline(never)]
    pub(super) fn approach(&mut self, near: &[T; N], evaluate: &impl Evaluate<T, N>) {
        if self.doubts.is_some_and(|doubts| doubts.solutions != 0) || self.solutions.is_empty() {
            self.hold(near, evaluate);
        }
        let facts = self.facts;
        for solution in self.solutions.as_mut_slice() {
            let joints = solution.q.iter_mut().zip(near).zip(facts.limits);
            for (joint, ((value, reference), limits)) in joints.enumerate() {
                if !facts.prismatic.contains(joint) {
                    *value = next_to(*value, *reference, *limits);
                }
            }
        }
        let distance = |q: &[T; N]| {
            q.iter().zip(near).zip(facts.weights).enumerate().fold(T::ZERO, |sum, (joint, ((a, b), weight))| {
                let step = if facts.prismatic.contains(joint) { (*a - *b) / facts.reach } else { *a - *b };
                sum + *weight * step * step
            })
        };
        self.solutions
            .sort_by(|a, b| distance(&a.q).partial_cmp(&distance(&b.q)).unwrap_or(core::cmp::Ordering::Equal));
    }

    /// Near a singularity a whole family of joint vectors closes within rounding. The member next to the reference is
    /// what a controller wants: it is found from the reference itself, and listed if no solution lies there yet.
    #[cold]
    #[inline(never)]
    fn hold(&mut self, near: &[T; N], evaluate: &impl Evaluate<T, N>) {
        let facts = self.facts;
        let mut start = self.goal.placed(*near);
        for (joint, value) in start.iter_mut().enumerate() {
            if !facts.prismatic.contains(joint) && !self.goal.given().contains(joint) {
                *value = wrap(*value);
            }
        }
        // Only from a reference that already is close: farther away there is no "same place" to keep.
        let close = relative(facts, &self.goal.residual(&start, &evaluate(&start).0)) <= T::DOUBTFUL;
        let (q, mut residual) = if close { refine(facts, self.goal, &start, evaluate, STEPS) } else { return };
        residual.orientation += self.deviation;
        let is_prismatic = |joint: usize| facts.prismatic.contains(joint);
        if !(relative(facts, &residual) <= T::EXACT) {
            return;
        }
        let apart = |other: &Solution<T, N>| {
            other.q.iter().zip(&q).fold(T::ZERO, |sum, (a, b)| sum + wrap(*a - *b) * wrap(*a - *b))
        };
        let nearer = |a: &&mut Solution<T, N>, b: &&mut Solution<T, N>| {
            apart(a).partial_cmp(&apart(b)).unwrap_or(core::cmp::Ordering::Equal)
        };
        let same = self.solutions.as_mut_slice().iter_mut();
        let same = same.filter(|other| coincident(&other.q, &q, facts.reach, is_prismatic)).min_by(nearer);
        if let Some(same) = same {
            // The same place, but nearer to the reference: beside a limit a small step would be a whole turn.
            (same.q, same.residual) = (q, residual);
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

fn coincident<T: Tolerances, const N: usize>(
    a: &[T; N],
    b: &[T; N],
    reach: T,
    is_prismatic: impl Fn(usize) -> bool,
) -> bool {
    a.iter().zip(b).enumerate().all(|(joint, (a, b))| {
        let apart = if is_prismatic(joint) { (*a - *b) / reach } else { wrap(*a - *b) };
        apart.abs() <= T::COINCIDENT
    })
}
