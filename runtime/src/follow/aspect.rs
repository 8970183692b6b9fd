//! The part of the joint space that an arm is in.

use super::signs::{Factors, Signs};
use crate::arm::InverseKinematics;
use crate::branch::Branch;
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

/// Where each factor exceeds this value a solution stands for one branch, and has its name: 1e-3 in `f64` and 0.02 in `f32`.
/// Two solutions that are one up to rounding are apart by a square root of it, behind another singularity by a cube root.
fn beside<T: Scalar>() -> T {
    if T::EPSILON < T::from_f64(1e-10) { T::from_f64(1e-3) } else { T::from_f64(0.02) }
}

impl Aspect {
    /// Aspect of joint values. `found` is overwritten.
    ///
    /// Every inverse of a follower is `inverse_branch_near_into`: in the memory of a microcontroller the code of the branches
    /// stands once.
    pub(super) fn at<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        q: &[T; N],
        found: &mut A::Solutions,
    ) -> Self {
        let target = arm.target_at(q);
        arm.inverse_branch_near_into(&target, Branch::NONE, q, true, found);
        let solutions = found.as_ref();
        let nearest = solutions.iter().find(|solution| solution.is_exact()).or(solutions.first());
        let signs = Signs::at(arm, q, Some(&target));
        nearest.map_or(Self { signs, branch: Branch::NONE, is_open: true }, |nearest| {
            Self::of(arm, signs, &nearest.q, nearest.branch)
        })
    }

    /// Aspect of a solution `q` of a branch, where the factors have these signs. The name has no numbers of roots: these mean
    /// something at one target only.
    pub(super) fn of<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        signs: Signs,
        q: &[T; N],
        branch: Branch,
    ) -> Self {
        let (branch, factors) = (branch.with_root(0), Factors::at(arm, q));
        if factors.least(None) > beside() {
            Self { signs, branch, is_open: false }
        } else if factors.least(arm.wrist_factor()) > beside() {
            Self { signs, branch: branch.with_any_wrist(), is_open: true }
        } else {
            Self { signs, branch: Branch::NONE, is_open: true }
        }
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

    /// Goes on to a solution where the factors have these signs. The solution names what was open.
    pub(super) fn arrive<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        &mut self,
        arm: &A,
        signs: Signs,
        solution: &Solution<T, N>,
    ) -> Option<Branch> {
        let left = self.go(arm, signs, |signs| Self::of(arm, signs, &solution.q, solution.branch));
        if self.is_open {
            self.complete(&Self::of(arm, signs, &solution.q, solution.branch));
        }
        left
    }

    /// Returns true if the name lacks a component that joint values with these factors have.
    pub(super) fn may_be_completed<T: Scalar>(&self, factors: &Factors<T>) -> bool {
        self.is_open && factors.least(None) > beside()
    }

    /// Takes what the name lacks from another one of the same part.
    pub(super) fn complete(&mut self, other: &Self) {
        self.branch = self.branch.or(other.branch);
        self.is_open &= other.is_open;
    }
}
