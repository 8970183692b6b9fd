//! Following the branches of the cascade and collecting the solutions.

use super::doubts::Doubts;
use super::elsewhere::Elsewhere;
use super::refine::Evaluate;
use super::stage::Met;
use super::{Goal, Home, Measure, Stage, Tolerances, Trail};
use crate::limits::within;
use crate::math::wrap;
use crate::vector::norm;
use crate::{Branch, CombinedLimit, Flags, JointMask, Residual, Solution, Solutions, Status};

/// A target that every branch misses by more than this part of the reach is far away: the gap is told as it is.
const FAR: f64 = 0.1;

/// What the search needs to know about an arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facts<T: 'static, const N: usize> {
    /// Lower and upper limit of every joint, infinite where there is none.
    pub limits: &'static [[T; 2]; N],
    /// How much each joint counts in the distance from a reference, the squared norm `sum w (q - q_ref)^2`.
    pub weights: &'static [T; N],
    /// Whether any joint has limits.
    pub limited: bool,
    /// The sliding joints.
    pub prismatic: JointMask,
    /// Reach of the arm, in its length unit.
    pub reach: T,
    /// Residuals up to this are listed as approximate solutions.
    pub tolerance: Residual<T>,
}

impl<T: Tolerances, const N: usize> Facts<T, N> {
    /// The same arm with lengths that are known at run time: its reach, and up to which position residual a solution is
    /// listed. An arm without any length has the reach 1.
    ///
    /// `None` if the reach is not finite, or so large or so small that fourth powers of the arm's lengths, which the
    /// kernels compute, leave the range of the scalar: beyond 1e60 and 1e-60 (f32: 1e8 and 1e-4) of the length unit.
    #[inline]
    pub fn with_reach(mut self, reach: T, position: T) -> Option<Self> {
        if reach == T::ZERO {
            self.tolerance.position = position.max(T::from_f64(1e-6));
            self.reach = T::ONE;
            return Some(self);
        }
        self.reach = reach;
        self.tolerance.position = position;
        (reach < T::LARGEST_REACH && reach > T::SMALLEST_REACH).then_some(self)
    }

    /// Whether a joint vector can be a reference: finite, and its angles not so far wound that their rounding is more
    /// than an exact solution may miss by.
    #[inline]
    fn can_refer(&self, near: &[T; N]) -> bool {
        let mut joints = near.iter().enumerate();
        joints.all(|(joint, q)| q.is_finite() && (self.prismatic.contains(joint) || q.abs() <= T::MOST_WOUND))
    }

    /// Where each joint stays if it is free: its reference value; without one 0, or the limit nearest to 0.
    #[inline]
    pub(super) fn homes(&self, near: Option<&[T; N]>) -> [T; N] {
        match near {
            Some(near) if self.prismatic.is_empty() => *near,
            Some(near) => {
                // A slide farther off than the arm reaches beyond its limits is no place to stay.
                let mut homes = *near;
                for joint in self.prismatic.iter() {
                    if let (Some(home), Some([low, high])) = (homes.get_mut(joint), self.limits.get(joint)) {
                        let (low, high) = (low.max(-self.reach * T::TWO), high.min(self.reach * T::TWO));
                        *home = home.max(low - self.reach).min(high + self.reach);
                    }
                }
                homes
            }
            None => self.limits.map(|[low, high]| {
                if low > T::ZERO {
                    low
                } else if high < T::ZERO {
                    high
                } else {
                    T::ZERO
                }
            }),
        }
    }
}

/// One run of the inverse kinematics.
#[derive(Debug)]
pub struct Search<'a, T: 'static, G, const N: usize, const M: usize> {
    pub(super) facts: &'a Facts<T, N>,
    pub(super) goal: &'a G,
    pub(super) near: Option<&'a [T; N]>,
    pub(super) solutions: &'a mut Solutions<T, N, M>,
    /// Where each joint stays if it is free.
    pub(super) homes: [T; N],
    /// The target's deviation from a rotation.
    pub(super) deviation: T,
    /// What has been found at an awkward pose.
    pub(super) doubts: Option<Doubts<T, M>>,
    /// Limits of sums of joint values.
    combined: &'a [CombinedLimit<T, N>],
}

impl<'a, T: Tolerances, G: Goal<T, N>, const N: usize, const M: usize> Search<'a, T, G, N, M> {
    /// Starts a search that fills `solutions`.
    ///
    /// `None`, with the status [`Status::BadTarget`], if the target (or the reference) is not finite or its rotation is
    /// not one within 1e-6 (f32: 1e-3).
    #[inline(always)]
    pub fn new(
        facts: &'a Facts<T, N>,
        goal: &'a G,
        near: Option<&'a [T; N]>,
        solutions: &'a mut Solutions<T, N, M>,
    ) -> Option<Self> {
        let deviation = goal.deviation();
        let finite = goal.point().iter().all(|x| x.is_finite()) && near.is_none_or(|q| facts.can_refer(q));
        if !(deviation <= T::NOT_A_ROTATION) || !finite {
            solutions.set_status(Status::BadTarget);
            return None;
        }
        // So far away the squares of the coordinates overflow: no arm reaches there.
        let farthest = goal.point().iter().fold(T::ZERO, |most, x| most.max(x.abs()));
        if farthest > T::MAX.sqrt() * T::from_f64(1e-3) {
            solutions.set_status(Status::Unreachable { residual: farthest });
            return None;
        }
        Some(Self { facts, goal, near, solutions, homes: facts.homes(near), deviation, doubts: None, combined: &[] })
    }

    /// Solutions outside one of these limits are out of limits too. An arm without any does not call this.
    #[inline]
    pub fn limit_sums(&mut self, combined: &'a [CombinedLimit<T, N>]) {
        self.combined = combined;
    }

    /// The start of every branch.
    #[inline]
    pub fn start(&self) -> Trail<T> {
        // Far away (a long slide may reach there) the rounding of the target alone can exceed what closes.
        let limit = self.facts.reach * T::from_f64(10.0);
        let far = self.goal.point().iter().any(|x| x.abs() > limit);
        Trail { doubt: far || self.deviation > T::ROUNDING || self.elsewhere_wanted(), ..Trail::START }
    }

    /// Whether this is a further pass, with a free joint elsewhere.
    #[inline]
    fn elsewhere_wanted(&self) -> bool {
        self.doubts.as_ref().is_some_and(|doubts| doubts.elsewhere.wanted())
    }

    /// The doubts so far, to add to.
    #[cold]
    #[inline(never)]
    pub(super) fn doubts(&mut self) -> &mut Doubts<T, M> {
        self.doubts.get_or_insert(Doubts::NONE)
    }

    /// Where a joint stays if it is free: its reference value; without one 0, or the limit nearest to 0.
    #[inline]
    pub fn home(&self, joint: usize) -> Home<T> {
        let value = self.homes.get(joint).copied().unwrap_or(T::ZERO);
        Home { value, joint: JointMask::single(joint) }
    }

    /// The same for a virtual joint: 0. The joint named is one of the arm's that moves with it.
    #[inline]
    pub fn virtual_home(&self, joint: usize) -> Home<T> {
        let value = if self.elsewhere_wanted() { self.away(joint, T::ZERO) } else { T::ZERO };
        Home { value, joint: JointMask::single(joint) }
    }

    /// The trail of a branch after a stage. A stage that misses by more than the tolerance ends the branch; its gap is
    /// remembered.
    #[inline]
    pub fn follow<const K: usize, const R: usize>(&mut self, trail: &Trail<T>, stage: &Stage<T, K, R>) -> Trail<T> {
        if stage.doubt { self.doubtful_trail(trail, stage.met()) } else { *trail }
    }

    /// The trail of a branch on which equations without a joint to meet them are missed by this much. Beyond rounding
    /// its end is checked in full: what is asked for may be beyond the arm.
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
        Trail { doubt: true, free: trail.free | free, flags: trail.flags | Flags::FREE, ..*trail }
    }

    #[cold]
    #[inline(never)]
    fn doubtful_trail(&mut self, trail: &Trail<T>, met: Met<T>) -> Trail<T> {
        let mut next = *trail;
        next.note(met);
        let Met { gap, angular, .. } = met;
        let measure = if angular { Measure::DIRECTION } else { Measure::length(self.facts.reach) };
        let tolerance = if angular { self.facts.tolerance.orientation } else { self.facts.tolerance.position };
        // What an earlier stage of small amplitude leaves uncertain shows up here magnified.
        let rounding = measure.rounding() / trail.amplitude;
        // With a joint earlier on the branch that is free, or nearly, the gap may close by moving that joint.
        if gap > tolerance.max(rounding) {
            next.missed = !trail.free.is_empty();
            next.beyond |= trail.free.is_empty() && trail.weak.is_empty();
        }
        if next.beyond && !trail.beyond {
            next.ended = self.doubts().ends(gap, gap / measure.scale);
        }
        next
    }

    /// Adds a solution. `q`: joint angles in (-pi, pi], rad; strokes in the length unit.
    #[inline]
    pub fn push(&mut self, trail: &Trail<T>, q: [T; N], branch: Branch) {
        if trail.doubt && !self.takes(trail, branch) {
            return;
        }
        let at = self.solutions.len();
        let orientation = trail.gap.orientation + self.deviation;
        let solution = Solution {
            q,
            flags: trail.flags | Flags::EXACT,
            free: trail.free,
            branch,
            residual: Residual { position: trail.gap.position, orientation },
        };
        if self.solutions.push(solution) && trail.doubt {
            self.doubt(at, trail);
        }
    }

    /// The solution at an index is to be checked in full.
    #[cold]
    #[inline(never)]
    fn doubt(&mut self, at: usize, trail: &Trail<T>) {
        let (doubts, bit) = (self.doubts(), 1u32.checked_shl(at as u32).unwrap_or(0));
        doubts.solutions |= bit;
        doubts.astray |= !(trail.free | trail.weak).is_empty();
        if let Some(loose) = doubts.loose.get_mut(at) {
            *loose = trail.free | trail.weak;
        }
    }

    /// Checks what is doubtful, sorts by distance if there is a reference, marks limits, and sets the status.
    /// `evaluate` gives the tool's pose and the Jacobian.
    ///
    /// Returns whether that is all. If not, a stage could not be met because of where a free joint stays: the branches
    /// are to be followed once more, with that joint elsewhere.
    #[inline]
    #[must_use]
    pub fn complete(&mut self, evaluate: impl Evaluate<T, N>) -> bool {
        if self.doubts.is_some() && !self.resolved(&evaluate) {
            return false;
        }
        match self.near {
            Some(near) => self.approach(near, &evaluate),
            None if !self.goal.given().is_empty() => self.wrap_given(),
            None => {}
        }
        if self.facts.limited || !self.combined.is_empty() {
            self.mark_limits();
        }
        let exact = self.solutions.iter().any(|s| s.flags.contains(Flags::EXACT));
        let status = if exact { Status::Reachable } else { self.unreachable() };
        self.solutions.set_status(status);
        true
    }

    /// Checks what is doubtful. Returns whether no branch is left to be followed again.
    #[cold]
    #[inline(never)]
    fn resolved(&mut self, evaluate: &impl Evaluate<T, N>) -> bool {
        if self.doubts().solutions != 0 {
            self.solutions.mark_awkward();
            self.settle(evaluate);
        }
        if self.elsewhere_wanted() && self.move_on() || self.seek_nearest() {
            return false;
        }
        if self.solutions.is_empty() && self.doubts().astray {
            self.rescue(evaluate);
        }
        true
    }

    /// If nothing is listed and the target is not far out of reach, the branches that come nearest are to be followed to
    /// their end: the gap is what one joint alone misses by, and with the joints before it the arm may come closer.
    fn seek_nearest(&mut self) -> bool {
        let (listed, homes, reach) = (!self.solutions.is_empty(), self.facts.homes(self.near), self.facts.reach);
        let doubts = self.doubts();
        let least = doubts.checked_gap.map_or(T::from_f64(FAR), |gap| gap / reach);
        if listed || doubts.nearest > T::ZERO || !(doubts.relative_gap < least) {
            return false;
        }
        doubts.nearest = T::TWO * doubts.relative_gap;
        doubts.stage_gap = None;
        doubts.elsewhere = Elsewhere::NEAREST;
        self.homes = homes;
        true
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
            if !(inside && self.combined.iter().all(|limit| limit.holds(&solution.q))) {
                solution.flags |= Flags::OUT_OF_LIMITS;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn unreachable(&self) -> Status<T> {
        let listed = self.solutions.iter().map(|s| s.residual.position.max(s.residual.orientation));
        let checked = listed
            .chain(self.doubts.and_then(|doubts| doubts.checked_gap))
            .fold(T::INFINITY, |least, gap| least.min(gap));
        // The gap of a stage is not all that its branch misses: it counts where no branch has been followed to its end.
        let residual = if checked.is_finite() {
            checked
        } else {
            self.doubts.and_then(|doubts| doubts.stage_gap).unwrap_or(T::INFINITY)
        };
        // A quartic without real roots has no gap: all that is known is that the target is not near.
        let residual = if residual.is_finite() { residual } else { self.facts.reach };
        // One farther away than the arm is long is missed by the difference at least.
        let beyond = if self.facts.prismatic.is_empty() { norm(self.goal.point()) - self.facts.reach } else { T::ZERO };
        Status::Unreachable { residual: residual.max(beyond) }
    }
}
