//! An open branch: one that a free or weak joint keeps from closing, and where iteration on it starts.

use super::kernel::tolerances::Tolerances;
use crate::math::{angle, sin_cos, wrap};
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

/// A branch without a solution so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Open<T, const N: usize> {
    pub(super) branch: Branch,
    pub(super) flags: Flags,
    pub(super) free: JointMask,
    /// The joints that are free or weak before the stage that is missed. If it `tells`, there is one, and it turns: the
    /// level of that stage tells its place.
    pub(super) joint: JointMask,
    pub(super) tells: bool,
    /// The way to the stage that is missed with the joints at their defaults, see [`Doubts`](super::doubts::Doubts).
    pub(super) way: u32,
    /// The level of that stage with the joint at its default, a step further and a step back. NaN if unknown.
    pub(super) levels: [T; 3],
    /// The stage has roots for levels up to this, of either sign: 1, or 0 for an equation without a joint of its own.
    pub(super) range: T,
    /// The level of that stage at the place that the levels tell.
    pub(super) level: T,
    /// The number of places that the levels have told.
    pub(super) told: u8,
    /// True if the branch has no solution.
    pub(super) closed: bool,
    /// The starts of least miss, the least first.
    pub(super) starts: [Start<T, N>; STARTS],
}

impl<T: Tolerances, const N: usize> Open<T, N> {
    pub(super) const NONE: Self = Self {
        branch: Branch::NONE,
        flags: Flags::NONE,
        free: JointMask::NONE,
        joint: JointMask::NONE,
        tells: false,
        way: 0,
        levels: [T::NAN; 3],
        range: T::ONE,
        level: T::NAN,
        told: 0,
        closed: false,
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

    /// Where the joint is narrowed down to. Where a stage reaches at one value of the joint alone, the miss is the square of
    /// the distance from there: its root is linear. To `probe`, a value beside the first start by the root of its miss;
    /// then where the root vanishes by both. Not a number without two starts off the defaults.
    #[inline(never)]
    pub(super) fn narrowed(&self, probe: bool) -> T {
        let value = |start: &Start<T, N>| self.joint.iter().next().and_then(|joint| start.q.get(joint)).copied();
        let [first, second] = &self.starts;
        let [Some(x), Some(y)] = [first, second].map(value) else { return T::NAN };
        let (a, b) = (first.miss.sqrt(), second.miss.sqrt());
        let by = if probe { a } else { wrap(y - x) * a / (a - b) };
        if second.miss < T::MAX { x + by } else { T::NAN }
    }

    /// The next place of the joint that the levels tell, see [`place`](Self::place). An equation without a joint of its
    /// own has a second root, the first one mirrored, also where the branch is `listed` by the first.
    pub(super) fn next_place(&mut self, step: T, listed: bool) -> Option<[T; 2]> {
        let mirror = self.told == 1 && self.range == T::ZERO;
        if !mirror && (listed || self.told > 0) {
            return None;
        }
        self.told += 1;
        let [x, level, phi] = self.place(step)?;
        let apart = wrap((x - phi) * T::TWO).abs() > T::WEAK;
        (!mirror || apart).then_some([if mirror { wrap(phi + phi - x) } else { x }, level])
    }

    /// The place of the joint, rad from its default, the level there, and phi below. `step`: how far the joint was moved.
    ///
    /// The level is `a + b cos(x - phi)`: the joint moves a point or a direction on a circle. The stage has roots where
    /// the level is in its range, between -1 and 1. Of the interval next to the default the place is the point that is nearest to the
    /// default, a quarter of the interval inside. Without an interval it is where the level exceeds its range by least.
    #[inline(never)]
    pub(super) fn place(&self, step: T) -> Option<[T; 3]> {
        let ([at, ahead, back], (sin, cos)) = (self.levels, sin_cos(step));
        let c = ((ahead + back) * T::HALF - at) / (cos - T::ONE);
        let s = (ahead - back) * T::HALF / sin;
        let (a, b) = (at - c, (c * c + s * s).sqrt());
        if !(b > T::ROUNDING * (T::ONE + a.abs())) {
            return None;
        }
        let phi = angle(s / b, c / b);
        // The angles from phi at which the range ends; beyond the turning points of the level there is no end.
        let [near, far] = [(self.range - a) / b, (-self.range - a) / b];
        let end = |cos: T| angle(((T::ONE - cos) * (T::ONE + cos)).max(T::ZERO).sqrt(), cos);
        let (no_near, no_far) = (near >= T::ONE, far <= -T::ONE);
        let from_phi = if near <= -T::ONE {
            T::PI
        } else if far >= T::ONE {
            T::ZERO
        } else {
            let least = if no_near { -end(far) } else { end(near) };
            let most = if no_far { T::TAU - end(near) } else { end(far) };
            let inside = (most - least) * T::HALF * T::HALF;
            if no_near && no_far { wrap(phi).abs() } else { wrap(phi).abs().max(least + inside).min(most - inside) }
        };
        let x = if wrap(phi) > T::ZERO { phi - from_phi } else { phi + from_phi };
        let (_, cos) = sin_cos(from_phi);
        Some([wrap(x), a + b * cos, phi])
    }

    /// Returns true if the level at the place is what it was told to be, and the stage has no root there by more than
    /// steps could close.
    pub(super) fn is_beyond(&self, told: T) -> bool {
        (self.level - told).abs() <= T::COINCIDENT * (T::ONE + told.abs()) && told.abs() - self.range > T::DOUBTFUL
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used)]

    use super::*;

    const STEP: f64 = 2.4;

    /// The place for a level `a + b cos(x - phi)`, and that level there as it is and as it was told.
    fn place(a: f64, b: f64, phi: f64) -> (f64, f64) {
        let level = |x: f64| a + b * (x - phi).cos();
        let open = Open::<f64, 1> { levels: [0.0, STEP, -STEP].map(level), ..Open::NONE };
        let [x, told, _] = open.place(STEP).expect("a level that moves");
        assert!((level(x) - told).abs() < 1e-12, "{a} {b} {phi}: {x}");
        (x, told)
    }

    #[test]
    fn the_place_is_inside_the_interval_next_to_the_default() {
        for phi in [-3.0, -2.0, -0.4, 0.0, 0.4, 1.0, 2.5] {
            for (a, b) in [(1.5, 1.0), (-1.5, 1.0), (0.2, 4.0), (3.0, 2.5), (0.1, 0.2)] {
                let (x, told) = place(a, b, phi);
                assert!(told.abs() < 1.0, "{a} {b} {phi}: {x} {told}");
                // No place nearer to the default by more than a quarter of a turn is farther inside.
                let level = |x: f64| a + b * (x - phi).cos();
                let nearest =
                    (0..1000).map(|k| f64::from(k) * 0.003).find(|x| level(*x).abs().min(level(-x).abs()) < 1.0);
                assert!(nearest.is_some_and(|nearest| nearest <= x.abs() + 3e-3), "{a} {b} {phi}: {x}");
            }
        }
    }

    #[test]
    fn a_level_beyond_its_range_is_least_beyond_it_at_its_turning_point() {
        for phi in [-2.0, 0.0, 1.0] {
            let (x, told) = place(2.5, 1.0, phi);
            assert!((wrap(x - phi).abs() - core::f64::consts::PI).abs() < 1e-12 && (told - 1.5).abs() < 1e-12);
            let (x, told) = place(-2.5, 1.0, phi);
            assert!(wrap(x - phi).abs() < 1e-12 && (told + 1.5).abs() < 1e-12);
        }
    }

    #[test]
    fn a_level_that_does_not_move_tells_no_place() {
        let open = Open::<f64, 1> { levels: [1.5; 3], ..Open::NONE };
        assert_eq!(open.place(STEP), None);
        assert_eq!(Open::<f64, 1>::NONE.place(STEP), None);
    }

    #[test]
    fn the_root_of_a_square_is_found_beside_its_probe() {
        for x in [3.1, 2.8, -3.0] {
            let start = |x: f64| Start { miss: 0.7 * wrap(x - 3.0).powi(2), q: [x] };
            let mut open = Open::<f64, 1> { joint: JointMask::single(0), starts: [start(x), start(0.5)], ..Open::NONE };
            open.starts = [start(x), start(open.narrowed(true))];
            assert!(wrap(open.narrowed(false) - 3.0).abs() < 1e-12, "{x}: {}", open.narrowed(false));
        }
        assert!(Open::<f64, 1>::NONE.narrowed(true).is_nan());
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
