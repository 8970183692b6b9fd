//! An open branch: one that a free or weak joint keeps from closing, and where iteration on it starts.

use super::kernel::tolerances::Tolerances;
use crate::{Branch, Flags, JointMask};

/// Iterations start from so many joint vectors of a branch at most.
const STARTS: usize = 2;

/// A joint vector of the closed form, and by how much its stages miss.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start<T, const N: usize> {
    /// Relative to reach, or rad; infinite if there is no such start.
    pub(super) miss: T,
    pub(super) q: [T; N],
}

/// A branch that has no solution with the joints at their defaults.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Open<T, const N: usize> {
    pub(super) branch: Branch,
    pub(super) flags: Flags,
    pub(super) free: JointMask,
    /// The order of the root of its missed stage, see [`Doubts::missed_order`](super::doubts::Doubts::missed_order); 2 without
    /// such a stage or if the second root has been asked for, 0 in an entry that is not used.
    pub(super) order: u8,
    /// The joints that are free or weak before that stage.
    pub(super) missed_for: JointMask,
    /// The miss of the start from which the last step was taken; NaN before.
    pub(super) stepped_miss: T,
    /// The starts of least miss, the least first.
    pub(super) starts: [Start<T, N>; STARTS],
}

impl<T: Tolerances, const N: usize> Open<T, N> {
    pub(super) const NONE: Self = Self {
        branch: Branch::NONE,
        flags: Flags::NONE,
        free: JointMask::NONE,
        order: 0,
        missed_for: JointMask::NONE,
        stepped_miss: T::NAN,
        starts: [Start { miss: T::INFINITY, q: [T::ZERO; N] }; STARTS],
    };

    /// Keeps a start if it is one of those of least miss.
    pub(super) fn keep(&mut self, start: Start<T, N>) {
        let [first, second] = &mut self.starts;
        if start.miss < first.miss {
            (*second, *first) = (*first, start);
        } else if start.miss < second.miss {
            *second = start;
        }
    }

    /// Returns true if no step has been taken from the start of least miss.
    pub(super) fn is_unstepped(&self) -> bool {
        let [first, _] = &self.starts;
        self.stepped_miss != first.miss
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_starts_of_least_miss_are_kept() {
        let mut open = Open::<f64, 1>::NONE;
        for miss in [0.5, 0.2, 0.9, 0.3, 0.25] {
            open.keep(Start { miss, q: [miss] });
        }
        assert_eq!(open.starts, [Start { miss: 0.2, q: [0.2] }, Start { miss: 0.25, q: [0.25] }]);
    }
}
