//! Whole turns: joint vectors that differ by multiples of 2 pi put the tool in the same place.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

use crate::dh::JointKind;
use crate::limits::rounding;
use crate::math::{Scalar, wrap};

/// The angle that differs from `value` by whole turns, next to `reference`: of those inside the limits the nearest one.
/// If there is none, or if the reference itself is outside, the angle is the one within half a turn of the reference.
/// So a reference that is a solution comes back as it is. Angles in rad, finite; limits may be infinite.
#[inline]
pub(crate) fn next_to<T: Scalar>(value: T, reference: T, limits: [T; 2]) -> T {
    let near = reference + wrap(value - reference);
    if inside(near, limits) || far_beyond(reference, limits) { near } else { at_limit(value, near, limits) }
}

/// The joint value next to a reference over lanes, the step to it as the search measures steps, and the lanes in doubt.
///
/// `reach`: of a prismatic joint, which has no turns; its step is relative to reach.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn step_lanes<L: Lanes>(
    set: L::Set,
    value: L,
    reference: L,
    limits: [f64; 2],
    reach: Option<f64>,
) -> (L, L, L::Mask) {
    match reach {
        Some(reach) => (value, (value - reference) / value.of(reach), L::mask(set, false)),
        None => {
            let (value, unsure) = next_to_lanes(value, reference, limits);
            (value, value - reference, unsure)
        }
    }
}

/// `next_to` of values in (-pi, pi] over lanes, and where the angle is beyond a limit by no more than a solution near a
/// singularity may be off, or the reference is wound: in doubt.
#[cfg(feature = "batch")]
#[inline(always)]
fn next_to_lanes<L: Lanes>(value: L, reference: L, limits: [f64; 2]) -> (L, L::Mask) {
    let (turned, wound) = crate::math::lanes::wrap(value - reference);
    let near = reference + turned;
    let [low, high] = limits.map(|limit| value.of(limit));
    let margin = 0.05 * crate::math::sqrt(f64::EPSILON);
    let [below, above] = [value.of(limits[0] - margin), value.of(limits[1] + margin)];
    let inside = |angle: L| L::both(low.at_most(angle), angle.at_most(high));
    let far = L::either(reference.less(below), above.less(reference));
    let stays = L::either(inside(near), far);
    let (is_below, is_above) = (near.less(below), above.less(near));
    let beyond = L::both(L::either(is_below, is_above), L::not(stays));
    if L::bits(beyond) == 0 {
        return (near, L::either(wound, L::not(stays)));
    }
    let ((down, odd_down), (up, odd_up)) = (inward_lanes(value, limits[1], 1.0), inward_lanes(value, limits[0], -1.0));
    let inward = down.where_or(is_above, up);
    let odd = L::either(L::both(is_above, odd_down), L::both(is_below, odd_up));
    let moves = L::both(beyond, inside(inward));
    let unsure = L::both(L::not(stays), L::either(L::not(beyond), odd));
    (inward.where_or(moves, near), L::either(wound, unsure))
}

/// The turn of `inward` that is nearest to a limit, the upper one or, with the sign -1, the lower one.
///
/// The whole number of turns takes two values, of which the greater is that of -pi (or pi); where rounding gives a third
/// one the lane is in doubt.
#[cfg(feature = "batch")]
#[inline(always)]
fn inward_lanes<L: Lanes>(value: L, limit: f64, sign: f64) -> (L, L::Mask) {
    use core::f64::consts::{PI, TAU};
    let turns = (value.of(limit) - value) * value.of(sign) / value.of(TAU);
    let most = whole_below((sign * limit + PI) / TAU);
    let less = turns.less(value.of(most));
    let by = value.of(sign * ((most - 1.0) * TAU)).where_or(less, value.of(sign * (most * TAU)));
    let odd = L::either(turns.less(value.of(most - 1.0)), L::not(turns.less(value.of(most + 1.0))));
    (value + by, odd)
}

/// The angle for a value beyond a limit. Beyond by rounding, the angle is the limit. Beyond by as little as a solution
/// near a singularity may be off, the angle stays. A whole turn away is no answer to that. Else the angle is the turn
/// inside.
#[cold]
#[inline(never)]
fn at_limit<T: Scalar>(value: T, near: T, limits: [T; 2]) -> T {
    let [low, high] = limits;
    let held = near.max(low).min(high);
    let beyond = (near - held).abs();
    if beyond <= rounding(held.abs()) {
        held
    } else if !far_beyond(near, limits) {
        near
    } else {
        inward(value, near, limits)
    }
}

/// Returns true if an angle is beyond a limit by more than the error of a solution near a singularity, 7e-10 in f64.
#[inline]
fn far_beyond<T: Scalar>(angle: T, [low, high]: [T; 2]) -> bool {
    let margin = T::from_f64(0.05) * T::EPSILON.sqrt();
    angle < low - margin || angle > high + margin
}

#[inline]
fn inside<T: Scalar>(angle: T, [low, high]: [T; 2]) -> bool {
    angle >= low && angle <= high
}

/// The turn inside that is nearest to the limit beyond which `near` is; `near` if there is none.
fn inward<T: Scalar>(value: T, near: T, limits: [T; 2]) -> T {
    let [low, high] = limits;
    // Counted from (-pi, pi], so that the turns taken off a far reference bring no rounding.
    let value = wrap(value);
    let wound = if near > high {
        value + whole_below((high - value) / T::TAU) * T::TAU
    } else {
        value - whole_below((value - low) / T::TAU) * T::TAU
    };
    if inside(wound, limits) { wound } else { near }
}

/// The greatest whole number that is not above `x`.
fn whole_below<T: Scalar>(x: T) -> T {
    let whole = x.round_ties_even();
    if whole > x { whole - T::ONE } else { whole }
}

/// Every joint vector within limits that differs from a given one by whole turns of revolute joints.
///
/// The first is the nearest to the given one: itself if it is within limits. The last joint changes fastest, and each
/// joint takes its nearest turn first. A joint without a limit on either side stays as it is, and so does a prismatic
/// joint. A revolute joint with a limit on one side takes its nearest value inside. The iterator is
/// empty if a joint has no value inside.
///
/// Returned by [`Solution::windings`](crate::Solution::windings), or from the joint vector. No allocation; a number of
/// turns beyond 2^31 is cut off there.
///
/// ```
/// use denhart::{JointKind, Windings};
///
/// let limits = [[-7.0, 7.0], [-1.0, 1.0]];
/// let all: Vec<_> = Windings::new(&[0.5, 0.25], &limits, &[JointKind::Revolute; 2]).map(|[q1, _]| q1).collect();
/// assert_eq!(all, [0.5, 0.5 + std::f64::consts::TAU, 0.5 - std::f64::consts::TAU]);
/// ```
#[derive(Debug, Clone)]
pub struct Windings<T, const N: usize> {
    q: [T; N],
    turns: [Turns; N],
    /// Which of its turns each joint takes next.
    at: [u32; N],
    done: bool,
}

/// The whole numbers from `low` to `high`.
#[derive(Debug, Clone, Copy)]
struct Turns {
    low: i64,
    high: i64,
}

impl Turns {
    const NONE: Self = Self { low: 1, high: 0 };
    const STAY: Self = Self { low: 0, high: 0 };

    fn of<T: Scalar>(q: T, [low, high]: [T; 2], kind: JointKind) -> Self {
        // As `inverse` has it, beyond a limit by rounding only is within it.
        let rounding = rounding(q.abs());
        let (low, high) = (low - rounding, high + rounding);
        let inside = q >= low && q <= high;
        if kind != JointKind::Revolute {
            return if inside { Self::STAY } else { Self::NONE };
        }
        if !(low.is_finite() && high.is_finite()) {
            let nearest = if inside { q } else { inward(q, q, [low, high]) };
            let turns = whole((nearest - q) / T::TAU);
            return if nearest >= low && nearest <= high { Self { low: turns, high: turns } } else { Self::NONE };
        }
        let at = |turns: i64| q + T::from_i64(turns) * T::TAU;
        // Rounding may take either end one turn too far.
        let (mut least, mut most) = (whole((low - q) / T::TAU) - 1, whole((high - q) / T::TAU) + 1);
        for _ in 0..2 {
            least += i64::from(at(least) < low);
            most -= i64::from(at(most) > high);
        }
        Self { low: least, high: most }
    }

    fn count(self) -> u32 {
        u32::try_from((self.high - self.low + 1).max(0)).unwrap_or(u32::MAX)
    }

    /// The `index`-th, nearest to 0 first.
    fn nth(self, index: u32) -> i64 {
        let index = i64::from(index);
        if self.low > 0 {
            return self.low + index;
        }
        if self.high < 0 {
            return self.high - index;
        }
        let both = self.high.min(-self.low);
        match index {
            _ if index <= 2 * both && index % 2 == 1 => index / 2 + 1,
            _ if index <= 2 * both => -(index / 2),
            _ if self.high > both => index - both,
            _ => both - index,
        }
    }
}

/// The nearest whole number, within 2^31.
fn whole<T: Scalar>(x: T) -> i64 {
    x.round_ties_even().to_i64().clamp(-(1 << 31), 1 << 31)
}

impl<T: Scalar, const N: usize> Windings<T, N> {
    /// All windings of `q` (`[N]`, rad or length unit) within `limits`, `[low, high]` for each joint.
    #[must_use]
    pub fn new(q: &[T; N], limits: &[[T; 2]; N], kinds: &[JointKind; N]) -> Self {
        let mut turns = [Turns::NONE; N];
        for (turns, ((q, limits), kind)) in turns.iter_mut().zip(q.iter().zip(limits).zip(kinds)) {
            *turns = if q.is_finite() { Turns::of(*q, *limits, *kind) } else { Turns::NONE };
        }
        Self { q: *q, turns, at: [0; N], done: turns.iter().any(|turns| turns.count() == 0) }
    }
}

impl<T: Scalar, const N: usize> Iterator for Windings<T, N> {
    type Item = [T; N];

    fn next(&mut self) -> Option<[T; N]> {
        if self.done {
            return None;
        }
        let mut q = self.q;
        for (q, (turns, at)) in q.iter_mut().zip(self.turns.iter().zip(&self.at)) {
            let turns = turns.nth(*at);
            if turns != 0 {
                *q += T::from_i64(turns) * T::TAU;
            }
        }
        self.done = true;
        for (turns, at) in self.turns.iter().zip(&mut self.at).rev() {
            *at += 1;
            if *at < turns.count() {
                self.done = false;
                break;
            }
            *at = 0;
        }
        Some(q)
    }
}

impl<T: Scalar, const N: usize> core::iter::FusedIterator for Windings<T, N> {}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{PI, TAU};
    use std::vec::Vec;

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    #[test]
    fn next_to_the_reference() {
        // Within half a turn.
        assert_eq!(next_to(3.0, -3.0, FREE), -3.0 + wrap(6.0));
        assert_eq!(next_to(0.5, 4.0 * TAU, FREE), 4.0 * TAU + 0.5);
        // Half a turn of the reference is outside, the other way round is inside.
        assert_eq!(next_to(-2.7, 2.7, [-2.8, 2.8]), -2.7);
        assert_eq!(next_to(2.7, -2.7, [-2.8, 2.8]), 2.7);
        // The nearest turn inside.
        assert_eq!(next_to(0.9, 7.0, [-7.0, 7.0]), 0.9);
        assert_eq!(next_to(-0.9, -7.0, [-7.0, 7.0]), -0.9);
        assert_eq!(next_to(-1.0, 1.0, [0.0, f64::INFINITY]), TAU - 1.0);
        // Beyond the limit by rounding, and by what an inexact solution may be.
        assert_eq!(next_to(-PI, PI - 1e-16, [-PI, PI]), PI);
        assert_eq!(next_to(-1.0 + 4e-16, -1.0 + 4e-16, [-2.0, -1.0]), -1.0);
        assert_eq!(next_to(1.0 + 4e-16, 1.0, [-1.0, 1.0]), 1.0);
        assert!((next_to(5e-10 - PI, PI - 1e-9, [-PI, PI]) - PI - 5e-10).abs() < 1e-14);
        assert_eq!(next_to(1e-8 - PI, PI - 1e-9, [-PI, PI]), 1e-8 - PI);
        // A reference that is outside is followed.
        assert_eq!(next_to(0.5, 4.0 * TAU, [-7.0, 7.0]), 4.0 * TAU + 0.5);
        // None inside: next to the reference.
        assert_eq!(next_to(2.0, 0.0, [-1.0, 1.0]), 2.0);
        assert!((next_to(2.0, 10.0, [-1.0, 1.0]) - (2.0 + TAU)).abs() < 1e-15 * 16.0);
    }

    /// Against a search through many turns.
    #[test]
    fn next_to_is_the_nearest_inside() {
        for step in 0..2000 {
            let at = |k: f64, range: f64| ((f64::from(step) * k) % 1.0 - 0.5) * 2.0 * range;
            let (value, reference) = (at(0.618, PI), at(0.414, 30.0));
            let (low, high) = (-at(0.732, 12.0).abs(), at(0.236, 12.0).abs());
            let windings = (-9..=9).map(|k| value + f64::from(k) * TAU);
            let reference = if (low..=high).contains(&reference) { reference } else { 0.0 };
            let distance = |angle: f64| (angle - reference).abs();
            let best = |all: &mut dyn Iterator<Item = f64>| all.min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
            let wanted = best(&mut windings.clone().filter(|x| (low..=high).contains(x)))
                .or_else(|| best(&mut windings.clone()));
            let found = next_to(value, reference, [low, high]);
            // Two turns may be equally near.
            let same = wanted.is_some_and(|x| (distance(x) - distance(found)).abs() < 1e-13);
            let turns = (found - value) / TAU;
            assert!(same && (turns - turns.round()).abs() < 1e-13, "{value} {reference} {low} {high}: {found}");
        }
    }

    fn all(q: f64, limits: [f64; 2]) -> Vec<f64> {
        let turns = |[x]: [f64; 1]| ((x - q) / TAU).round();
        Windings::new(&[q], &[limits], &[JointKind::Revolute]).map(turns).collect()
    }

    #[test]
    fn one_joint() {
        assert_eq!(all(0.0, [-2.0 * TAU, 2.0 * TAU]), [0.0, 1.0, -1.0, 2.0, -2.0]);
        assert_eq!(all(0.5, [-1.0, 20.0]), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(all(0.5, [-20.0, 1.0]), [0.0, -1.0, -2.0, -3.0]);
        assert_eq!(all(0.5, [1.0, 14.0]), [1.0, 2.0]);
        assert_eq!(all(0.5, [-14.0, 0.0]), [-1.0, -2.0]);
        assert_eq!(all(0.5, [1.0, 2.0]), []);
        assert_eq!(all(PI, [-PI, PI]), [0.0, -1.0]);
        assert_eq!(all(2.0, FREE), [0.0]);
        assert_eq!(all(-2.0, [0.0, f64::INFINITY]), [1.0]);
        assert_eq!(all(f64::NAN, FREE), []);
        assert_eq!(all(f64::INFINITY, [-1.0, 1.0]), []);
    }

    #[test]
    fn joints_together() {
        let kinds = [JointKind::Revolute, JointKind::Prismatic, JointKind::Revolute];
        let limits = [[-7.0, 7.0], [0.0, 10.0], [-4.0, 4.0]];
        let found: Vec<_> = Windings::new(&[0.5, 7.0, 3.0], &limits, &kinds).collect();
        let wanted = [
            [0.5, 7.0, 3.0],
            [0.5, 7.0, 3.0 - TAU],
            [0.5 + TAU, 7.0, 3.0],
            [0.5 + TAU, 7.0, 3.0 - TAU],
            [0.5 - TAU, 7.0, 3.0],
            [0.5 - TAU, 7.0, 3.0 - TAU],
        ];
        assert_eq!(found, wanted);
        assert_eq!(Windings::new(&[0.5, 11.0, 3.0], &limits, &kinds).count(), 0);
    }

    #[test]
    fn huge_limits_are_total() {
        let limits = [[-1e300, 1e300]];
        let mut windings = Windings::new(&[0.5], &limits, &[JointKind::Revolute]);
        assert_eq!(windings.next(), Some([0.5]));
        assert!(windings.take(1000).all(|[q]| q.is_finite()));
    }
}
