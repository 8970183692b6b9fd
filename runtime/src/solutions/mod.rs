//! All branches of one inverse, in an array of fixed capacity.

use core::fmt;
use core::ops::Deref;
use core::{array, iter, slice};

use crate::branch::Branch;
use crate::flags::Flags;
use crate::math::Scalar;
use crate::solution::{Residual, Solution, Status};
use crate::target::Target;

mod sort;

/// A branch needed more than the closed form: the pose is singular or on a boundary for it.
const AWKWARD: u8 = 1;
/// A bound was reached before every place was looked at.
const INCOMPLETE: u8 = 2;
/// The member of a family of solutions to which the reference leads is wanted only if it is much nearer than those listed.
const ANY_PLACE: u8 = 4;

/// The solutions of one call, at most `M`, of an arm with `N` joints, and the status of the call.
///
/// Derefs to a slice of [`Solution`]. `inverse` lists the branches in the order that its documentation states,
/// `inverse_near` the nearest first. Limits never remove a solution: [`within_limits`](Self::within_limits) filters.
#[derive(Clone, Copy)]
pub struct Solutions<T, const N: usize, const M: usize> {
    /// The first `len` are solutions.
    items: [Solution<T, N>; M],
    len: usize,
    status: Status<T>,
    /// Bits: [`AWKWARD`], [`INCOMPLETE`], [`ANY_PLACE`].
    notes: u8,
    deviation: T,
}

impl<T: Scalar, const N: usize, const M: usize> Solutions<T, N, M> {
    /// One constant, all bits zero, so that making a list is a single fill of memory. (Struct update from it would
    /// compile to a slower copy of read-only data.)
    const EMPTY: Self =
        Self { items: [Solution::EMPTY; M], len: 0, status: Status::Reachable, notes: 0, deviation: T::ZERO };

    /// An empty list.
    #[inline]
    #[must_use]
    pub const fn new(status: Status<T>) -> Self {
        let mut empty = Self::EMPTY;
        empty.status = status;
        empty
    }

    /// Empties the list: what [`new`](Self::new) makes, without filling the places of the solutions.
    #[inline]
    pub const fn reset(&mut self, status: Status<T>) {
        (self.len, self.status, self.notes, self.deviation) = (0, status, 0, T::ZERO);
    }

    /// Like [`reset`](Self::reset), for generated code whose list is next to a reference. `keeps_place`, until the next reset: see
    /// [`inverse_branch_near_into`](crate::InverseKinematics::inverse_branch_near_into).
    #[inline]
    pub const fn reset_near(&mut self, status: Status<T>, keeps_place: bool) {
        self.reset(status);
        if !keeps_place {
            self.notes = ANY_PLACE;
        }
    }

    /// The residual of every solution, in order, from the arm's own `forward`.
    ///
    /// [`Solution::residual`] holds the gaps of the closed form; this is the full check, one forward kinematics for
    /// each solution.
    pub fn verify<A, G: Target<A, T, N>>(&self, arm: &A, target: &G) -> impl Iterator<Item = Residual<T>> {
        self.iter().map(|solution| target.missed_by(arm, &solution.q))
    }
}

impl<T, const N: usize, const M: usize> Solutions<T, N, M> {
    /// Appends a solution. Returns whether there was room.
    #[inline]
    pub fn push(&mut self, solution: Solution<T, N>) -> bool {
        match self.items.get_mut(self.len) {
            Some(place) => {
                *place = solution;
                self.len += 1;
                true
            }
            None => false,
        }
    }

    /// The solutions.
    #[inline]
    #[must_use]
    pub fn as_slice(&self) -> &[Solution<T, N>] {
        self.items.get(..self.len).unwrap_or(&[])
    }

    /// The solutions, to change in place.
    #[inline]
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [Solution<T, N>] {
        self.items.get_mut(..self.len).unwrap_or(&mut [])
    }

    /// Outcome of the call.
    #[inline]
    #[must_use]
    pub const fn status(&self) -> Status<T>
    where
        T: Copy,
    {
        self.status
    }

    /// Returns true if a branch needed more than the closed form.
    #[inline]
    pub(crate) const fn is_awkward(&self) -> bool {
        self.notes & AWKWARD != 0
    }

    /// Returns true if the member of a family of solutions to which the reference leads is wanted, however far.
    #[inline]
    pub(crate) const fn keeps_place(&self) -> bool {
        self.notes & ANY_PLACE == 0
    }

    /// Notes that a branch needs more than the closed form.
    #[inline]
    pub(crate) const fn mark_awkward(&mut self) {
        self.notes |= AWKWARD;
    }

    /// Returns false if further solutions may exist: evaluations ran out before each branch was verified. Where the inverse
    /// holds a joint, also if another bound of the call was reached, the list was full, or the equation of the arm has too few
    /// digits at this target. With a triple of axes that meet or are parallel it is false at few singular targets.
    #[inline]
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.notes & INCOMPLETE == 0
    }

    /// Notes that further solutions may exist.
    #[inline]
    pub(crate) const fn mark_incomplete(&mut self) {
        self.notes |= INCOMPLETE;
    }

    /// Deviation of the target's matrix from a rotation, of the order of the Frobenius distance to the nearest
    /// rotation. The solutions reach that rotation, and their residuals refer to it. 0 for a deviation of rounding
    /// alone.
    #[inline]
    #[must_use]
    pub const fn deviation(&self) -> T
    where
        T: Copy,
    {
        self.deviation
    }

    /// Sets the target's deviation.
    #[inline]
    pub(crate) fn set_deviation(&mut self, deviation: T) {
        self.deviation = deviation;
    }

    /// Sets the outcome of the call.
    #[inline]
    pub fn set_status(&mut self, status: Status<T>) {
        self.status = status;
    }

    /// The solutions with every joint within the arm's limits.
    #[inline]
    pub fn within_limits(&self) -> impl Iterator<Item = &Solution<T, N>> + Clone {
        self.as_slice().iter().filter(|solution| solution.is_within_limits())
    }

    /// The solutions that reach the target up to rounding.
    #[inline]
    pub fn exact(&self) -> impl Iterator<Item = &Solution<T, N>> + Clone {
        self.as_slice().iter().filter(|solution| solution.flags.contains(Flags::EXACT))
    }

    /// The first solution: after `inverse_near`, the one nearest to the reference.
    #[inline]
    #[must_use]
    pub fn nearest(&self) -> Option<&Solution<T, N>> {
        self.as_slice().first()
    }

    /// The first solution on a branch, an exact one if there is any. Parts that the arm does not have count for nothing.
    /// Where branches meet, the one solution has the name of the branch.
    ///
    /// # Errors
    /// The status, if there is no solution.
    #[inline]
    pub fn one_on(&self, branch: Branch) -> Result<Solution<T, N>, Status<T>>
    where
        T: Copy,
    {
        let named = |solution: &&Solution<T, N>| branch.agrees_with(solution.branch);
        let exact = self.exact().find(named).or(self.exact().next());
        let solution = exact.or(self.iter().find(named)).or(self.nearest()).ok_or(self.status)?;
        Ok(Solution { branch: solution.branch.called(branch), ..*solution })
    }

    /// The first solution on a branch, an exact one if there is any: for arms on which a name may be missing, or shared by
    /// solutions with numbers of which the first has none. `gap`: the residual of [`Status::Unreachable`] where other branches
    /// reach the target.
    ///
    /// # Errors
    /// The status, if there is no solution; [`Status::Unreachable`], if none has the name.
    #[inline]
    pub fn named(&self, branch: Branch, gap: T) -> Result<Solution<T, N>, Status<T>>
    where
        T: Copy,
    {
        let named = |solution: &&Solution<T, N>| branch.asks_for(solution.branch);
        let missing = if self.is_empty() { self.status } else { Status::Unreachable { residual: gap } };
        let solution = self.exact().find(named).or(self.iter().find(named)).ok_or(missing)?;
        Ok(Solution { branch: solution.branch.called(branch), ..*solution })
    }

    /// The first exact solution, else the first approximate one.
    ///
    /// # Errors
    /// The status, if there is no solution.
    #[inline]
    pub fn first_or_status(&self) -> Result<Solution<T, N>, Status<T>>
    where
        T: Copy,
    {
        self.one_on(Branch::NONE)
    }

    /// Keeps the first `len` solutions.
    #[inline]
    pub fn truncate(&mut self, len: usize) {
        self.len = self.len.min(len);
    }

    /// Keeps the solutions for which `keep` holds, in order.
    #[inline]
    pub fn retain(&mut self, mut keep: impl FnMut(&Solution<T, N>) -> bool)
    where
        T: Copy,
    {
        let mut kept = 0;
        for index in 0..self.len {
            if self.items.get(index).is_some_and(&mut keep) {
                // An exchange of two places: a copy within the list is a routine of 1.6 kB.
                if let Some([place, .., item]) = self.items.get_mut(kept..=index) {
                    core::mem::swap(place, item);
                }
                kept += 1;
            }
        }
        self.len = kept;
    }
}

/// An empty list, before any call.
impl<T: Scalar, const N: usize, const M: usize> Default for Solutions<T, N, M> {
    fn default() -> Self {
        Self::new(Status::BadTarget)
    }
}

impl<T, const N: usize, const M: usize> Deref for Solutions<T, N, M> {
    type Target = [Solution<T, N>];

    #[inline]
    fn deref(&self) -> &Self::Target {
        self.as_slice()
    }
}

impl<T, const N: usize, const M: usize> AsRef<[Solution<T, N>]> for Solutions<T, N, M> {
    #[inline]
    fn as_ref(&self) -> &[Solution<T, N>] {
        self.as_slice()
    }
}

impl<T, const N: usize, const M: usize> IntoIterator for Solutions<T, N, M> {
    type Item = Solution<T, N>;
    type IntoIter = iter::Take<array::IntoIter<Solution<T, N>, M>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter().take(self.len)
    }
}

impl<'a, T, const N: usize, const M: usize> IntoIterator for &'a Solutions<T, N, M> {
    type Item = &'a Solution<T, N>;
    type IntoIter = slice::Iter<'a, Solution<T, N>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.as_slice().iter()
    }
}

/// Equal solutions in the same order, and the same status.
impl<T: PartialEq, const N: usize, const M: usize> PartialEq for Solutions<T, N, M> {
    fn eq(&self, other: &Self) -> bool {
        self.status == other.status && self.as_slice() == other.as_slice()
    }
}

impl<T: fmt::Debug, const N: usize, const M: usize> fmt::Debug for Solutions<T, N, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Solutions").field("status", &self.status).field("solutions", &self.as_slice()).finish()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::arm::Arm;
    use crate::dh::JointKind;
    use crate::flags::JointMask;
    use crate::jacobian::Jacobian;
    use crate::pose::Pose;
    use std::format;
    use std::vec::Vec;

    type Three = Solutions<f64, 1, 3>;

    fn solution(q: f64, flags: Flags) -> Solution<f64, 1> {
        Solution { q: [q], flags, ..Solution::EMPTY }
    }

    fn list(values: &[f64]) -> Solutions<f64, 1, 8> {
        let mut list = Solutions::new(Status::Reachable);
        for q in values {
            assert!(list.push(solution(*q, Flags::EXACT)));
        }
        list
    }

    fn values<const M: usize>(list: &Solutions<f64, 1, M>) -> Vec<f64> {
        list.iter().map(|solution| solution.q[0]).collect()
    }

    #[test]
    fn a_new_list_is_empty() {
        let empty = Three::new(Status::BadTarget);
        assert!(empty.is_empty() && empty.nearest().is_none() && empty.into_iter().next().is_none());
        assert_eq!(empty.status(), Status::BadTarget);
        assert_eq!(Solution::<f32, 2>::EMPTY.free, JointMask::NONE);
    }

    #[test]
    fn a_list_that_is_reset_is_a_new_one() {
        let mut kept = list(&[1.0, 2.0]);
        kept.mark_awkward();
        kept.set_deviation(0.5);
        kept.reset(Status::BadTarget);
        assert!(kept.is_empty() && !kept.is_awkward());
        assert_eq!((kept.status(), kept.deviation()), (Status::BadTarget, 0.0));
    }

    #[test]
    fn a_full_list_refuses() {
        let mut list = Three::new(Status::Reachable);
        for q in [1.0, 2.0, 3.0] {
            assert!(list.push(solution(q, Flags::EXACT)));
        }
        assert!(!list.push(solution(4.0, Flags::EXACT)));
        assert_eq!(values(&list), [1.0, 2.0, 3.0]);
        assert_eq!(list.len(), 3);
        let mut none = Solutions::<f64, 1, 0>::new(Status::Reachable);
        assert!(!none.push(solution(4.0, Flags::EXACT)) && none.is_empty());
    }

    #[test]
    fn filters_do_not_remove() {
        let mut list = Three::new(Status::Reachable);
        list.push(solution(1.0, Flags::EXACT | Flags::OUT_OF_LIMITS));
        list.push(solution(2.0, Flags::APPROXIMATE));
        list.push(solution(3.0, Flags::EXACT));
        assert_eq!(list.within_limits().map(|s| s.q[0]).collect::<Vec<_>>(), [2.0, 3.0]);
        assert_eq!(list.exact().map(|s| s.q[0]).collect::<Vec<_>>(), [1.0, 3.0]);
        assert_eq!(list.nearest().unwrap().q, [1.0]);
        assert_eq!(list.len(), 3);
    }

    #[test]
    fn retain_keeps_the_order() {
        let mut some = list(&[1.0, -2.0, 3.0, -4.0, 5.0]);
        some.retain(|s| s.q[0] > 0.0);
        assert_eq!(values(&some), [1.0, 3.0, 5.0]);
        some.retain(|_| true);
        assert_eq!(values(&some), [1.0, 3.0, 5.0]);
        some.retain(|s| s.q[0] > 1.0);
        assert_eq!(values(&some), [3.0, 5.0]);
        some.retain(|_| false);
        assert!(some.is_empty());
        assert!(some.push(solution(9.0, Flags::EXACT)));
        assert_eq!(values(&some), [9.0]);
    }

    #[test]
    fn truncate_and_change_in_place() {
        let mut some = list(&[1.0, 2.0, 3.0]);
        some.truncate(5);
        assert_eq!(some.len(), 3);
        some.truncate(2);
        some.set_status(Status::Unreachable { residual: 0.5 });
        for s in some.as_mut_slice() {
            s.q[0] *= 10.0;
        }
        assert_eq!(some.into_iter().map(|s| s.q[0]).collect::<Vec<_>>(), [10.0, 20.0]);
        assert_eq!(some.status(), Status::Unreachable { residual: 0.5 });
    }

    /// A prismatic joint along x.
    struct Slide;

    impl Arm<f64, 1> for Slide {
        const LIMITS: [[f64; 2]; 1] = [[0.0, 1.0]];
        const JOINT_NAMES: [&'static str; 1] = ["q1"];
        const JOINT_KINDS: [JointKind; 1] = [JointKind::Prismatic];

        fn forward(&self, &[q1]: &[f64; 1]) -> Pose<f64> {
            Pose { translation: [q1, 0.0, 0.0], ..Pose::identity() }
        }

        fn link_poses(&self, q: &[f64; 1]) -> [Pose<f64>; 1] {
            [self.forward(q)]
        }

        fn jacobian(&self, _: &[f64; 1]) -> Jacobian<f64, 1> {
            Jacobian { rows: [[1.0], [0.0], [0.0], [0.0], [0.0], [0.0]] }
        }

        fn forward_and_jacobian(&self, q: &[f64; 1]) -> (Pose<f64>, Jacobian<f64, 1>) {
            (self.forward(q), self.jacobian(q))
        }
    }

    #[test]
    fn verify_recomputes_every_residual() {
        let target = Pose { translation: [0.5, 0.0, 2.0], ..Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, 0.25]) };
        let residuals = list(&[0.5, 2.0]).verify(&Slide, &target).collect::<Vec<_>>();
        assert_eq!(residuals.iter().map(|r| r.position).collect::<Vec<_>>(), [2.0, 2.5]);
        assert!(residuals.iter().all(|r| (r.orientation - 0.25).abs() < 1e-15), "{residuals:?}");
    }

    #[test]
    fn equality_and_debug_ignore_what_was_removed() {
        let mut some = list(&[1.0, 2.0]);
        some.truncate(1);
        assert_eq!(some, list(&[1.0]));
        assert_ne!(some, list(&[2.0]));
        some.set_status(Status::BadTarget);
        assert_ne!(some, list(&[1.0]));
        assert_eq!(format!("{some:?}").matches("Solution {").count(), 1);
    }
}
