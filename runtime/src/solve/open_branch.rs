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
    /// The length of that step: so many halves of the least one. 0 before.
    pub(super) halves: u8,
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
        halves: 0,
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

    /// Returns true if no step of the least length has been taken from the start of least miss.
    pub(super) fn is_unstepped(&self) -> bool {
        let [first, _] = &self.starts;
        self.stepped_miss != first.miss || self.halves > 2
    }

    /// The start of least miss, stepped from now, and how many times the step is taken.
    ///
    /// To a root of order m a step leads `1 / m` of the way. Taken `t` times it leaves `(1 - t / m)^m` of the miss. The least
    /// step is taken m times, by the order of the branch. If it leaves about `4^-m`, the root seems to be of twice this order.
    /// The next step is half as long again, which brings either root nearer. If it leaves less than half of `4^-m`, further
    /// steps are twice as long as the least one.
    pub(super) fn step(&mut self) -> (&[T; N], T) {
        let [first, _] = &self.starts;
        let left = first.miss / self.stepped_miss * T::from_i32(1 << (2 * self.order));
        self.halves = match self.halves {
            _ if self.stepped_miss == first.miss => 2,
            2 if left > T::HALF && left < T::TWO => 3,
            3 if left < T::HALF => 4,
            4 => 4,
            _ => 2,
        };
        self.stepped_miss = first.miss;
        (&first.q, T::from_i32((self.order * self.halves).into()) * T::HALF)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;

    /// Steps to a root of order `m`, from one length away: what is left of the way.
    fn stepped(m: i32, order: u8) -> Vec<f64> {
        let mut open = Open::<f64, 1> { order, ..Open::NONE };
        let mut left = 1.0_f64;
        let step = |_| {
            open.keep(Start { miss: left.abs().powi(m), q: [left] });
            let (from, times) = open.step();
            left = from[0] * (1.0 - times / f64::from(m));
            left
        };
        (0..4).map(step).collect()
    }

    #[test]
    fn steps_learn_that_a_root_is_of_twice_its_order() {
        let learned = [0.5, 0.125, 0.0];
        assert_eq!((&stepped(4, 2)[..3], &stepped(2, 1)[..3]), (&learned[..], &learned[..]));
        assert_eq!((stepped(2, 2)[0], stepped(1, 1)[0]), (0.0, 0.0));
    }

    #[test]
    fn a_start_is_stepped_from_once_by_the_least_step() {
        let mut open = Open::<f64, 1> { order: 2, ..Open::NONE };
        open.keep(Start { miss: 1.0, q: [1.0] });
        for (miss, times, again) in [(1.0, 2.0, false), (0.06, 3.0, true), (0.06, 2.0, false), (0.02, 2.0, false)] {
            open.keep(Start { miss, q: [miss] });
            assert!(open.is_unstepped());
            assert_eq!(open.step(), (&[miss], times));
            assert_eq!(open.is_unstepped(), again);
        }
    }

    #[test]
    fn two_starts_of_least_miss_are_kept() {
        let mut open = Open::<f64, 1>::NONE;
        for miss in [0.5, 0.2, 0.9, 0.3, 0.25] {
            open.keep(Start { miss, q: [miss] });
        }
        assert_eq!(open.starts, [Start { miss: 0.2, q: [0.2] }, Start { miss: 0.25, q: [0.25] }]);
    }
}
