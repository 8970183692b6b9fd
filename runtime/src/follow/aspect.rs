//! The part of the joint space that an arm is in.

use super::signs::{Signs, factors_exceed};
use crate::arm::InverseKinematics;
use crate::branch::Branch;
use crate::flags::Flags;
use crate::math::Scalar;
use crate::solution::Solution;

/// A part of the joint space that singularities bound: the signs that the factors have there, and the name of its branch.
///
/// Beside a singularity one solution stands for two branches, by the name of either. A name that is taken there lacks the
/// component that the singularity leaves open.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aspect {
    pub(super) signs: Signs,
    pub(super) branch: Branch,
    /// The name lacks a component.
    is_open: bool,
}

/// Where each factor exceeds this value a solution stands for one branch: 1e-6 in `f64` and 0.02 in `f32`. Two solutions that
/// are one up to rounding are apart by its square root.
fn beside<T: Scalar>() -> T {
    T::from_f64(64.0) * T::EPSILON.sqrt()
}

impl Aspect {
    /// The one where the factors have these signs, by its name.
    pub(super) const fn new(signs: Signs, branch: Branch) -> Self {
        Self { signs, branch: branch.with_root(0), is_open: false }
    }

    /// The one of joint values. `found` is overwritten.
    ///
    /// Every inverse of a follower is `inverse_branch_near_into`: in the memory of a microcontroller the code of the branches
    /// stands once.
    pub(super) fn at<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        q: &[T; N],
        found: &mut A::Solutions,
    ) -> Self {
        let target = arm.target_at(q);
        arm.inverse_branch_near_into(&target, Branch::NONE, q, found);
        let solutions = found.as_ref();
        let nearest = solutions.iter().find(|solution| solution.is_exact()).or(solutions.first());
        Self::named(arm, Signs::at(arm, q, Some(&target)), nearest)
    }

    /// The one of a solution.
    pub(super) fn of<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        solution: &Solution<T, N>,
        target: &A::Target,
    ) -> Self {
        Self::named(arm, Signs::at(arm, &solution.q, Some(target)), Some(solution))
    }

    /// The name is that of a solution. Numbers of roots are left out: they mean something at one target only.
    fn named<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        signs: Signs,
        solution: Option<&Solution<T, N>>,
    ) -> Self {
        let Some(solution) = solution else { return Self { signs, branch: Branch::NONE, is_open: true } };
        let stands_for_two = solution.flags.contains(Flags::BOUNDARY) || solution.flags.contains(Flags::FREE);
        if !(stands_for_two || signs.are_open()) || arm.factors(&solution.q, &mut []) == 0 {
            return Self::new(signs, solution.branch);
        }
        let wrist_alone = factors_exceed(arm, &solution.q, beside(), arm.wrist_factor());
        let branch = if wrist_alone { solution.branch.with_any_wrist() } else { Branch::NONE };
        Self { is_open: true, ..Self::new(signs, branch) }
    }

    /// Goes to joint values where the factors have these signs. Gives the branch that was left, if one has changed; `name`
    /// is then asked for the new one. A factor without a sign keeps the sign it had.
    pub(super) fn go<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        &mut self,
        arm: &A,
        signs: Signs,
        name: impl FnOnce(Signs) -> Self,
    ) -> Option<Branch> {
        let left = *self;
        self.signs = signs.or(left.signs);
        if !self.signs.differ(left.signs) {
            return None;
        }
        let flips = arm.wrist_factor().is_some_and(|wrist| self.signs.differ_in(left.signs, wrist));
        match left.branch.with_other_wrist().filter(|_| flips) {
            Some(flipped) => self.branch = flipped,
            None => *self = Self { signs: self.signs, ..name(self.signs) },
        }
        Some(left.branch)
    }

    /// Goes on to a solution. It names what was open.
    pub(super) fn arrive<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        &mut self,
        arm: &A,
        solution: &Self,
    ) -> Option<Branch> {
        let left = self.go(arm, solution.signs, |_| *solution);
        self.complete(solution);
        left
    }

    /// Returns true if the name lacks a component that joint values have.
    pub(super) fn may_be_completed<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        &self,
        arm: &A,
        q: &[T; N],
    ) -> bool {
        self.is_open && factors_exceed(arm, q, beside::<T>(), None)
    }

    /// Takes what the name lacks from another one of the same part.
    pub(super) fn complete(&mut self, other: &Self) {
        self.branch = self.branch.or(other.branch);
        self.is_open &= other.is_open;
    }
}
