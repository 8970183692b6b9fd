//! The neighborhood of a doubtful root, branch by branch.
//!
//! Where branches meet, the polynomial has a root of order two to four and knows it to the square root or the fourth
//! root of its rounding. The branches themselves are known to rounding. So each is looked at on both sides of the root
//! at distances that grow by four: for a change of its sign, and for its end, where v^2 or w^2 vanishes.

use core::ops::ControlFlow;

use super::axis::lowest;
use super::branch::{BRANCHES, Branch};
use super::search::Stream;
use crate::math::Scalar;

/// The distances: `3e-7 4^k` rad.
const NEAREST: f64 = 3e-7;
const PLACES: usize = 10;
/// A root beyond the first places may belong to another root of the polynomial.
const NEAR_PLACES: usize = 8;
/// A branch that misses by no more at its end may close there.
const AT_END: f64 = 1e-3;
/// Where v^2 or w^2 is lowest or highest and this near to 0, branches may be narrow.
const NARROW: f64 = 1e-2;

/// A place of a branch.
type Place<T> = (T, Branch<T>);

impl Stream<'_, '_, f64> {
    /// The roots of all branches near a doubtful root. Gives the branches that have one.
    ///
    /// All that happens to the branches in a narrow space happens about the root, or where v^2 or w^2 is lowest or highest
    /// near 0: branches end on both sides of such a place, at distances that may be far less than the error of the root.
    pub fn about(&mut self, root: f64) -> ControlFlow<(), [bool; BRANCHES]> {
        let mut is_found = self.beside(root)?;
        for (number, square) in [(0, 0), (0, 1), (1, 1)] {
            let posed = self.posed;
            let value = |t: f64| posed.branch_at(number, t).squares.get(square).copied().unwrap_or(0.0);
            let center = lowest(value, root);
            if value(center).abs() <= NARROW {
                let found = self.beside(center)?;
                is_found.iter_mut().zip(found).for_each(|(all, found)| *all |= found);
            }
        }
        ControlFlow::Continue(is_found)
    }

    /// The roots of all branches about an angle. Gives the branches that have one near it.
    pub fn beside(&mut self, angle: f64) -> ControlFlow<(), [bool; BRANCHES]> {
        let mut is_found = [false; BRANCHES];
        for side in [1.0, -1.0] {
            let mut step = side * NEAREST;
            let mut last = (angle, self.posed.branches(angle));
            for place in 0..PLACES {
                let next = (angle + step, self.posed.branches(angle + step));
                let branches = last.1.into_iter().zip(next.1).zip(&mut is_found);
                for (number, ((from, to), is_found)) in branches.enumerate() {
                    let offered = self.between(number, (last.0, from), (next.0, to), AT_END)?;
                    *is_found |= offered && place < NEAR_PLACES;
                }
                last = next;
                step *= 4.0;
            }
        }
        ControlFlow::Continue(is_found)
    }
}

impl<T: Scalar> Stream<'_, '_, T> {
    /// The root of one branch between two places, if its sign changes there, and its ends, if it misses by at most
    /// `at_end` there. Gives true if there is one.
    pub fn between(&mut self, number: usize, from: Place<T>, to: Place<T>, at_end: T) -> ControlFlow<(), bool> {
        let (mut end, mut is_found) = (None, false);
        for square in [0, 1] {
            let of = |branch: &Branch<T>| branch.squares.get(square).copied().unwrap_or(T::ZERO);
            let (at_from, at_to) = (of(&from.1), of(&to.1));
            if at_from * at_to > T::ZERO {
                continue;
            }
            let t = crossing(|t| of(&self.posed.branch_at(number, t)), (from.0, at_from), (to.0, at_to));
            let branch = self.posed.branch_at(number, t);
            // The other root may be imaginary here, or 0 to rounding.
            if branch.least_square() >= T::from_f64(-1e-9) {
                if branch.miss.abs() <= at_end {
                    self.offer(t, number, true)?;
                    is_found = true;
                }
                end = Some((t, branch));
            }
        }
        let (from, to) = match (from.1.is_real(), to.1.is_real(), end) {
            (true, true, _) => (from, to),
            (true, false, Some(end)) => (from, end),
            (false, true, Some(end)) => (end, to),
            _ => return ControlFlow::Continue(is_found),
        };
        if from.1.miss * to.1.miss <= T::ZERO {
            let t = crossing(|t| self.posed.miss(number, t), (from.0, from.1.miss), (to.0, to.1.miss));
            self.offer(t, number, true)?;
            is_found = true;
        }
        ControlFlow::Continue(is_found)
    }
}

/// Where a continuous function changes its sign: regula falsi with halved values (Illinois), at most 20 steps.
pub(super) fn crossing<T: Scalar>(value: impl Fn(T) -> T, (mut a, mut at_a): (T, T), (mut b, mut at_b): (T, T)) -> T {
    let small = T::from_f64(16.0) * T::EPSILON;
    let least = small * at_a.abs().max(at_b.abs());
    for _ in 0..20 {
        let t = (a * at_b - b * at_a) / (at_b - at_a);
        if !t.is_finite() {
            break;
        }
        let at_t = value(t);
        if at_t * at_b <= T::ZERO {
            (a, at_a) = (b, at_b);
        } else {
            at_a *= T::HALF;
        }
        (b, at_b) = (t, at_t);
        if at_t.abs() <= least || (a - b).abs() <= small {
            break;
        }
    }
    b
}
