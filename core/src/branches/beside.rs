//! The neighborhood of a doubtful root, branch by branch.
//!
//! Where branches meet, the polynomial has a root of order two to four and knows it to the square root or the fourth
//! root of its rounding. The branches themselves are known to rounding. So each is looked at on both sides of the root
//! at distances that grow by four: for a change of its sign, and for its end, where v^2 or w^2 vanishes.

use core::ops::ControlFlow;

use super::{Branch, Branches, CENTERS, COUNT, Stream};
use crate::math::{Scalar, sin_cos};

/// The distances: `3e-7 4^k` rad.
const NEAREST: f64 = 3e-7;
const PLACES: usize = 10;
/// The neighborhoods of angles that are nearer than this are the same, rad.
const SAME_CENTER: f64 = 1e-9;
/// A root beyond the first places may belong to another root of the polynomial.
const NEAR_PLACES: usize = 8;
/// A branch that misses by no more at its end may close there.
const AT_END: f64 = 1e-6;
/// A branch that is real at one angle alone, known to half of the digits, may close there if it misses by no more.
const AT_POINT: f64 = 1e-4;
/// The parts of a branch near its end.
const PARTS: usize = 6;
/// A branch that misses by no more where it turns has a double root there.
const AT_TURN: f64 = 1e-8;
/// A square that is no greater is 0 to rounding.
const POINT: f64 = 1e-9;
/// Where v^2 or w^2 is lowest or highest and this near to 0, branches may be narrow.
const NARROW: f64 = 1e-2;

/// A place of a branch.
type Place<T> = (T, Branch<T>);

impl<B: Branches<f64>> Stream<'_, '_, f64, B> {
    /// The roots of all branches near a doubtful root. Gives the branches that have one.
    ///
    /// All that happens to the branches in a narrow space happens about the root, or where v^2 or w^2 is lowest or highest
    /// near 0: branches end on both sides of such a place, at distances that may be far less than the error of the root.
    /// `place`: an angle near the root where the closed form is singular.
    pub fn about(&mut self, root: f64, place: Option<f64>) -> ControlFlow<(), [bool; COUNT]> {
        let mut is_found = self.beside(root)?;
        if let Some(place) = place {
            self.beside(place)?;
        }
        for (number, square) in B::NARROW.iter().copied() {
            let branches = self.branches;
            let value = |t: f64| branches.branch(number, t).squares.get(square).copied().unwrap_or(0.0);
            let center = lowest(&value, root);
            if value(center).abs() <= NARROW {
                let found = self.beside(center)?;
                is_found.iter_mut().zip(found).for_each(|(all, found)| *all |= found);
                self.point(center)?;
            }
        }
        ControlFlow::Continue(is_found)
    }

    /// Branches that are real at one angle alone, where v^2 or w^2 is 0 and negative on both sides.
    fn point(&mut self, t: f64) -> ControlFlow<()> {
        for (number, branch) in self.branches.all(sin_cos(t)).iter().enumerate() {
            let is_point = branch.is_nearly_real() && branch.squares.iter().any(|square| *square <= POINT);
            if is_point && branch.miss.abs() <= AT_POINT {
                self.offer_once(t, number, true, POINT)?;
            }
        }
        ControlFlow::Continue(())
    }

    /// The roots of all branches about an angle. Gives the branches that have one near it.
    fn beside(&mut self, angle: f64) -> ControlFlow<(), [bool; COUNT]> {
        if let Some((_, found)) = self.centers.iter().find(|(center, _)| (angle - *center).abs() <= SAME_CENTER) {
            return ControlFlow::Continue(*found);
        }
        let mut is_found = [false; COUNT];
        let middle = (angle, self.branches.all(sin_cos(angle)));
        for side in [1.0, -1.0] {
            let mut step = side * NEAREST;
            let (mut last, mut here) = (None, middle);
            for place in 0..PLACES {
                let next = (angle + step, self.branches.all(sin_cos(angle + step)));
                for (number, is_found) in is_found.iter_mut().enumerate() {
                    let at = |(t, branches): (f64, [Branch<f64>; COUNT])| branches.get(number).map(|b| (t, *b));
                    let (Some(from), Some(to)) = (at(here), at(next)) else { continue };
                    let mut offered = self.between(number, from, to, AT_END)?;
                    if let Some(before) = last.and_then(at) {
                        offered |= self.turning(number, [before, from, to])?.is_found();
                    }
                    *is_found |= offered && place < NEAR_PLACES;
                }
                (last, here) = (Some(here), next);
                step *= 4.0;
            }
        }
        if let Some(slot) = self.centers.get_mut(self.center_count % CENTERS) {
            *slot = (angle, is_found);
        }
        self.center_count += 1;
        ControlFlow::Continue(is_found)
    }
}

/// The value of a branch that turns without reaching 0.
pub(super) enum Turn<T> {
    /// It does not turn between the places.
    None,
    /// It turns and has roots on both sides.
    Found,
    /// It turns at an angle and misses by so much there.
    Misses(T, T),
}

impl<T> Turn<T> {
    fn is_found(&self) -> bool {
        matches!(self, Self::Found)
    }
}

impl<T: Scalar, B: Branches<T>> Stream<'_, '_, T, B> {
    /// The root of one branch between two places, if its sign changes there, and its ends, if it misses by at most
    /// `at_end` there. Gives true if there is one.
    pub fn between(&mut self, number: usize, from: Place<T>, to: Place<T>, at_end: T) -> ControlFlow<(), bool> {
        let (mut ends, mut is_found) = ([None; 2], false);
        for (square, end) in ends.iter_mut().enumerate() {
            let of = |branch: &Branch<T>| branch.squares.get(square).copied().unwrap_or(T::ZERO);
            let (at_from, at_to) = (of(&from.1), of(&to.1));
            if at_from * at_to > T::ZERO {
                continue;
            }
            let t = crossing(&|t| of(&self.branches.branch(number, t)), (from.0, at_from), (to.0, at_to));
            let branch = self.branches.branch(number, t);
            // The other root may be imaginary here, or 0 to rounding.
            if branch.is_nearly_real() {
                // The twin, which has the other sign of the root that is 0, is the same here.
                let is_twin = number & (1 << square) != 0;
                if branch.miss.abs() <= at_end && !is_twin {
                    self.offer(t, number, true)?;
                    is_found = true;
                }
                *end = Some((t, branch));
            }
        }
        // Where both roots end, the branch ends with the one that is nearer to the place where it is real.
        let real = if from.1.is_real() { from.0 } else { to.0 };
        if let [Some(first), Some(second)] = ends
            && (second.0 - real).abs() < (first.0 - real).abs()
        {
            ends = [Some(second), Some(first)];
        }
        match (from.1.is_real(), to.1.is_real(), ends) {
            (true, true, _) => is_found |= self.change(number, from, to)?,
            (true, false, [Some(end), _] | [None, Some(end)]) => is_found |= self.near_end(number, end, from)?,
            (false, true, [Some(end), _] | [None, Some(end)]) => is_found |= self.near_end(number, end, to)?,
            // Real between its two ends.
            (false, false, [Some(first), Some(second)]) => {
                let at = |share: T| {
                    let t = first.0 + (second.0 - first.0) * share;
                    (t, self.branches.branch(number, t))
                };
                let [left, middle, right] = [T::from_f64(0.125), T::HALF, T::from_f64(0.875)].map(at);
                is_found |= self.near_end(number, first, middle)? | self.near_end(number, second, middle)?;
                is_found |= self.turning(number, [left, middle, right])?.is_found();
            }
            _ => {}
        }
        ControlFlow::Continue(is_found)
    }

    /// The roots of a branch that begins at `end` and is real up to `far`. It begins like a square root, so it is looked at
    /// near its end.
    fn near_end(&mut self, number: usize, end: Place<T>, far: Place<T>) -> ControlFlow<(), bool> {
        let mut is_found = false;
        let (mut last, mut here, mut share) = (None, far, T::ONE);
        for part in 0..PARTS {
            share *= T::from_f64(0.25);
            let t = end.0 + (far.0 - end.0) * share;
            let next = if part + 1 < PARTS { (t, self.branches.branch(number, t)) } else { end };
            is_found |= self.change(number, here, next)?;
            if let Some(last) = last {
                is_found |= self.turning(number, [last, here, next])?.is_found();
            }
            (last, here) = (Some(here), next);
        }
        ControlFlow::Continue(is_found)
    }

    /// The root of a branch between two places, if its sign changes there.
    fn change(&mut self, number: usize, from: Place<T>, to: Place<T>) -> ControlFlow<(), bool> {
        let is_found = from.1.miss * to.1.miss <= T::ZERO;
        if is_found {
            let t = crossing(&|t| self.branches.branch(number, t).miss, (from.0, from.1.miss), (to.0, to.1.miss));
            self.offer(t, number, true)?;
        }
        ControlFlow::Continue(is_found)
    }

    /// The roots of a branch that turns towards 0 and back between three places where it has one sign: eight parabolas
    /// through the places nearest to the turn.
    pub(super) fn turning(&mut self, number: usize, places: [Place<T>; 3]) -> ControlFlow<(), Turn<T>> {
        let [mut from, mut middle, mut to] = places;
        let is_turning = places.iter().all(|(_, branch)| branch.is_nearly_real())
            && from.1.miss * middle.1.miss > T::ZERO
            && to.1.miss * middle.1.miss > T::ZERO
            && middle.1.miss.abs() <= from.1.miss.abs()
            && middle.1.miss.abs() <= to.1.miss.abs();
        if !is_turning {
            return ControlFlow::Continue(Turn::None);
        }
        for _ in 0..8 {
            let (left, right) = (slope(from, middle), slope(middle, to));
            let bend = (right - left) / (to.0 - from.0);
            let t = T::HALF * (from.0 + middle.0 - left / bend);
            // Outside for a quotient that is not a number, too.
            let is_inside = (t - from.0) * (to.0 - t) > T::ZERO && t != middle.0;
            if !is_inside {
                break;
            }
            let place = (t, self.branches.branch(number, t));
            if place.1.miss * middle.1.miss <= T::ZERO {
                self.change(number, from, place)?;
                self.change(number, place, to)?;
                return ControlFlow::Continue(Turn::Found);
            }
            let is_before = (t - from.0) * (middle.0 - t) > T::ZERO;
            let is_lower = place.1.miss.abs() <= middle.1.miss.abs();
            match (is_lower, is_before) {
                (true, true) => (middle, to) = (place, middle),
                (true, false) => (from, middle) = (middle, place),
                (false, true) => from = place,
                (false, false) => to = place,
            }
        }
        if middle.1.miss.abs() <= T::from_f64(AT_TURN) {
            // A double root is known to half of the digits.
            self.offer_once(middle.0, number, true, T::EPSILON.sqrt())?;
            return ControlFlow::Continue(Turn::Found);
        }
        ControlFlow::Continue(Turn::Misses(middle.0, middle.1.miss))
    }
}

/// The slope of a branch between two places.
fn slope<T: Scalar>(from: Place<T>, to: Place<T>) -> T {
    (to.1.miss - from.1.miss) / (to.0 - from.0)
}

/// Where a continuous function changes its sign: regula falsi with halved values (Illinois), at most 20 steps.
#[inline(never)]
pub(crate) fn crossing<T: Scalar>(value: &dyn Fn(T) -> T, (mut a, mut at_a): (T, T), (mut b, mut at_b): (T, T)) -> T {
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

/// Where a function is lowest or highest, near an angle: parabolas through three angles each.
#[inline(never)]
fn lowest<T: Scalar>(value: &dyn Fn(T) -> T, mut t: T) -> T {
    let wide = T::EPSILON.sqrt().sqrt().sqrt();
    let (middle, narrow) = (wide * wide, wide * wide * wide);
    // Far from a double root a parabola is none yet, and each step leaves a part of the distance.
    for step in [wide, middle, middle, middle, middle, narrow, narrow] {
        let (before, here, after) = (value(t - step), value(t), value(t + step));
        let moved = T::HALF * step * (before - after) / (before + after - here - here);
        // False for a quotient that is not a number, too.
        if moved.abs() <= T::from_f64(0.1) {
            t += moved;
        }
    }
    t
}

/// The place near an angle where a function is nearest to 0: where it is lowest or highest itself, or where `other` is, whose
/// shape is a parabola where that of the function is none.
#[inline(never)]
pub(crate) fn nearest_to_zero<T: Scalar>(value: &dyn Fn(T) -> T, other: &dyn Fn(T) -> T, t: T) -> T {
    let (own, other) = (lowest(value, t), lowest(other, t));
    if value(own).abs() <= value(other).abs() { own } else { other }
}
