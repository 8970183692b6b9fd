//! An open branch: one that a free or weak joint keeps from closing, and where iteration on it starts.

use super::kernel::tolerances::Tolerances;
use crate::math::{angle, sin_cos, wrap};
use crate::{Branch, Flags, JointMask};

/// Iterations start from so many joint vectors of a branch at most.
const STARTS: usize = 2;

/// The levels of a stage at so many places of a joint tell all others.
pub(super) const SAMPLES: usize = 3;

/// A joint vector of the closed form, and by how much its stages miss.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start<T, const N: usize> {
    /// Relative to reach, or rad; infinite if there is no such start.
    pub(super) miss: T,
    pub(super) q: [T; N],
}

/// How the place of an open branch's joint is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// No level tells the place: several joints are free or weak, or one that slides.
    Untold,
    /// The levels of the runs so far do not tell the place yet.
    Sampled,
    /// The levels have told the place.
    Told,
    /// They have told the second place of an equation without a joint of its own, or that there is none.
    ToldTwice,
    /// The level at the place says that the branch has no solution.
    Nowhere,
}

/// A branch without a solution so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Open<T, const N: usize> {
    pub(super) branch: Branch,
    pub(super) flags: Flags,
    pub(super) free: JointMask,
    /// The joints that are free or weak before the stage that is missed. Where there is one, and it turns, the level of that
    /// stage tells its place.
    pub(super) joint: JointMask,
    pub(super) place: Place,
    /// The way to the stage that is missed with the joints at their defaults, see [`Doubts`](super::doubts::Doubts).
    pub(super) way: u32,
    /// The levels of that stage with the joint at its default, one and two steps further, all by `first` more. NaN if unknown.
    pub(super) levels: [T; SAMPLES],
    pub(super) first: u8,
    /// That stage is an equation without a joint of its own: it has roots where the level is 0. Another one has them where the level
    /// is between -1 and 1.
    pub(super) is_jointless: bool,
    /// A step from the first start has been taken.
    pub(super) stepped: bool,
    /// The starts of least miss, the least first.
    pub(super) starts: [Start<T, N>; STARTS],
}

impl<T: Tolerances, const N: usize> Open<T, N> {
    pub(super) const NONE: Self = Self {
        branch: Branch::NONE,
        flags: Flags::NONE,
        free: JointMask::NONE,
        joint: JointMask::NONE,
        place: Place::Untold,
        way: 0,
        levels: [T::NAN; SAMPLES],
        first: 0,
        is_jointless: false,
        stepped: false,
        starts: [Start { miss: T::INFINITY, q: [T::ZERO; N] }; STARTS],
    };

    /// Keeps a start if it is one of those of least miss.
    pub(super) fn keep(&mut self, start: Start<T, N>) {
        let [first, second] = &mut self.starts;
        if start.miss < first.miss {
            (*second, *first) = (*first, start);
            self.stepped = false;
        } else if start.miss < second.miss {
            *second = start;
        }
    }

    /// The next place of the joint that the levels tell, rad from its default, and the level there, see [`turning_place`]. An
    /// equation without a joint of its own has a second root, the first one mirrored, also where the branch is `listed` by the
    /// first. `None` before so many `multiples` of the step that the levels are known.
    pub(super) fn next_place(&mut self, step: T, multiples: u8, listed: bool) -> Option<[T; 2]> {
        let mirror = self.has_second_place();
        let first = self.place == Place::Sampled && !listed;
        if usize::from(multiples) < usize::from(self.first) + SAMPLES || !(first || mirror) {
            return None;
        }
        self.place = if mirror { Place::ToldTwice } else { Place::Told };
        let start = T::from_i32(self.first.into()) * step;
        let [x, level, phi] = turning_place(self.levels, start, step, self.range())?;
        let apart = wrap((x - phi) * T::TWO).abs() > T::WEAK;
        (!mirror || apart).then_some([if mirror { wrap(phi + phi - x) } else { x }, level])
    }

    /// Returns true if a second place is still to be told.
    pub(super) fn has_second_place(&self) -> bool {
        self.place == Place::Told && self.is_jointless
    }

    /// The largest level for which the stage has roots.
    fn range(&self) -> T {
        if self.is_jointless { T::ZERO } else { T::ONE }
    }

    /// The level of a run that moves the free joints by so many steps.
    pub(super) fn sample(&mut self, multiple: u8) -> Option<&mut T> {
        self.levels.get_mut(usize::from(multiple.checked_sub(self.first)?))
    }

    /// Returns true if the `level` at the place is what it was `told` to be, and the stage has no root there by more than
    /// steps could close.
    pub(super) fn is_beyond(&self, told: T, level: T) -> bool {
        (level - told).abs() <= T::COINCIDENT * (T::ONE + told.abs()) && told.abs() - self.range() > T::DOUBTFUL
    }
}

/// The place of the joint, rad from its default, the level there, and phi below. The samples are at `start` and one and two
/// times `step` further, rad from the default; `range`: the largest level for which the stage has roots.
///
/// The level is `a + b cos(x - phi)`: the joint moves a point or a direction on a circle. The stage has roots where
/// the level is in its range, between -1 and 1. Of the interval next to the default the place is the point that is nearest to the
/// default, a quarter of the interval inside. Without an interval it is where the level exceeds its range by least.
#[inline(never)]
fn turning_place<T: Tolerances>([at, one, two]: [T; SAMPLES], start: T, step: T, range: T) -> Option<[T; 3]> {
    let ((sin, cos), (half_sin, half_cos)) = (sin_cos(step), sin_cos(step * T::HALF));
    // `c cos x + s sin x` at the places less that at the first one, over `-2 sin(x / 2)`.
    let (p, q) = ((at - one) / (T::TWO * half_sin), (at - two) / (T::TWO * sin));
    let (c, s) = ((q * half_cos - p * cos) / half_sin, (q * half_sin - p * sin) / half_sin);
    let (a, b) = (at - c, (c * c + s * s).sqrt());
    if !(b > T::ROUNDING * (T::ONE + a.abs())) {
        return None;
    }
    let phi = wrap(angle(s / b, c / b) + start);
    // The angles from phi at which the range ends; beyond the turning points of the level there is no end.
    let [near, far] = [(range - a) / b, (-range - a) / b];
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

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used)]

    use super::*;

    const STEP: f64 = 2.4;

    /// The place for a level `a + b cos(x - phi)`, and that level there as it is and as it was told.
    fn place(a: f64, b: f64, phi: f64) -> (f64, f64) {
        let level = |x: f64| a + b * (x - phi).cos();
        let levels = [0.0, 1.0, 2.0].map(|k| level(k * STEP));
        let [x, told, _] = turning_place(levels, 0.0, STEP, 1.0).expect("a level that moves");
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
        assert_eq!(turning_place([1.5; 3], 0.0, STEP, 1.0), None);
        assert_eq!(turning_place([f64::NAN; 3], 0.0, STEP, 1.0), None);
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
