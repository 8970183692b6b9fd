//! Targets of arms with joints whose values are given.

use super::goal::Goal;
use super::kernel::tolerances::Tolerances;
use crate::{Jacobian, JointMask, Pose, Residual};

/// A goal of which one joint's value is given: that joint does not move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Locked<'a, T, G> {
    goal: &'a G,
    joint: usize,
    value: T,
}

impl<'a, T: Tolerances, G> Locked<'a, T, G> {
    /// Joint `joint`, counted from 0, stays at `value`.
    #[inline]
    pub fn new(goal: &'a G, joint: usize, value: T) -> Self {
        Locked { goal, joint, value }
    }
}

impl<T: Tolerances, G: Goal<T, N>, const N: usize> Goal<T, N> for Locked<'_, T, G> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.goal.is_finite() && self.value.is_finite()
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        self.goal.point()
    }

    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.goal.residual(q, pose)
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.goal.misses(q, pose)
    }

    fn error(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        self.goal.error(q, pose)
    }

    fn twist(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        self.goal.twist(q, pose)
    }

    fn virtual_value(&self, pose: &Pose<T>) -> Option<T> {
        self.goal.virtual_value(pose)
    }

    fn restrict(&self, pose: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        self.goal.restrict(pose, jacobian);
        for entry in jacobian.rows.iter_mut().filter_map(|row| row.get_mut(self.joint)) {
            *entry = T::ZERO;
        }
    }

    #[inline]
    fn given(&self) -> JointMask {
        JointMask::single(self.joint)
    }

    fn placed(&self, mut q: [T; N]) -> [T; N] {
        if let Some(place) = q.get_mut(self.joint) {
            *place = self.value;
        }
        q
    }
}

/// A goal of which the values of several joints are given: those joints do not move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AllLocked<'a, T, G> {
    goal: &'a G,
    held: &'a [(usize, T)],
}

impl<'a, T: Tolerances, G> AllLocked<'a, T, G> {
    /// The joints of `held`, counted from 0, stay at their values.
    #[inline]
    pub fn new(goal: &'a G, held: &'a [(usize, T)]) -> Self {
        AllLocked { goal, held }
    }
}

impl<T: Tolerances, G: Goal<T, N>, const N: usize> Goal<T, N> for AllLocked<'_, T, G> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.goal.is_finite() && self.held.iter().all(|(_, value)| value.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        self.goal.point()
    }

    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.goal.residual(q, pose)
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.goal.misses(q, pose)
    }

    fn error(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        self.goal.error(q, pose)
    }

    fn twist(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        self.goal.twist(q, pose)
    }

    fn virtual_value(&self, pose: &Pose<T>) -> Option<T> {
        self.goal.virtual_value(pose)
    }

    fn restrict(&self, pose: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        self.goal.restrict(pose, jacobian);
        for row in &mut jacobian.rows {
            for (joint, _) in self.held {
                if let Some(entry) = row.get_mut(*joint) {
                    *entry = T::ZERO;
                }
            }
        }
    }

    #[inline]
    fn given(&self) -> JointMask {
        self.held.iter().fold(JointMask::NONE, |mask, (joint, _)| mask | JointMask::single(*joint))
    }

    fn placed(&self, mut q: [T; N]) -> [T; N] {
        for (joint, value) in self.held {
            if let Some(place) = q.get_mut(*joint) {
                *place = *value;
            }
        }
        q
    }
}

#[cfg(test)]
mod tests {
    use super::{AllLocked, Goal, Locked};
    use crate::{Jacobian, JointMask, Pose};

    #[test]
    fn a_list_of_one_is_one_joint() {
        let (point, pose) = ([1.0, 2.0, 3.0], Pose::identity());
        let held = [(1, 0.5)];
        let (one, list) = (Locked::new(&point, 1, 0.5), AllLocked::new(&point, &held));
        let moved = |goal: &dyn Goal<f64, 3>| {
            let mut jacobian = Jacobian { rows: [[1.0; 3]; 6] };
            goal.restrict(&pose, &mut jacobian);
            (jacobian, goal.placed([7.0; 3]), goal.given(), goal.is_finite())
        };
        assert_eq!(moved(&one), moved(&list));
    }

    #[test]
    fn the_arm_angle_holds_no_joint() {
        let held = [(0, 0.5), (3, -1.0), (2, 4.0)];
        let goal = AllLocked::new(&[0.0; 3], &held);
        assert_eq!(Goal::<f64, 3>::placed(&goal, [7.0; 3]), [0.5, 7.0, 4.0]);
        let mask = [0, 2, 3].map(JointMask::single).into_iter().fold(JointMask::NONE, |mask, joint| mask | joint);
        assert_eq!(Goal::<f64, 3>::given(&goal), mask);
        assert!(!Goal::<f64, 3>::is_finite(&AllLocked::new(&[0.0; 3], &[(0, 0.0), (3, f64::NAN)])));
    }
}
