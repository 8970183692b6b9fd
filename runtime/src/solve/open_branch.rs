//! An open branch: one that a free or weak joint keeps from closing, and where iteration on it starts.

use super::kernel::tolerances::Tolerances;
use crate::math::{angle, sin_cos, wrap};
use crate::{Branch, Flags, JointMask};

/// Iterations start from so many joint vectors of a branch at most.
const STARTS: usize = 2;

/// The levels of a stage at so many places of a joint tell all others, behind a slide at `MOST_SAMPLES`.
const SAMPLES: usize = 3;
pub(super) const MOST_SAMPLES: usize = 5;

/// The least level behind a slide is looked for at so many places, and beside it at distances halved so many times.
const SCANNED: i32 = 32;
const HALVED: usize = 24;

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
    /// The levels of that stage, times a square, and the square, with the joint at its default and one to four steps
    /// further, all by `first` more. NaN if unknown. So many of them tell all others.
    pub(super) levels: [[T; 2]; MOST_SAMPLES],
    pub(super) first: u8,
    /// A slide is solved between the joint and that stage.
    pub(super) is_behind_slide: bool,
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
        levels: [[T::NAN; 2]; MOST_SAMPLES],
        first: 0,
        is_behind_slide: false,
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

    /// The next place of the joint that the levels tell, rad from its default, and the level there, see
    /// [`turning_place`](Self::turning_place). An equation without a joint of its own has a second root, the first one mirrored,
    /// also where the branch is `listed` by the first. None before so many `multiples` of the step that the levels are known.
    pub(super) fn next_place(&mut self, step: T, multiples: u8, listed: bool) -> Option<[T; 2]> {
        let mirror = self.has_second_place();
        let samples = if self.is_behind_slide { MOST_SAMPLES } else { SAMPLES };
        let first = self.place == Place::Sampled && !listed;
        if usize::from(multiples) < usize::from(self.first) + samples || !(first || mirror) {
            return None;
        }
        self.place = if mirror { Place::ToldTwice } else { Place::Told };
        let [x, level, phi] =
            if self.is_behind_slide { self.place_behind_slide(step)? } else { self.turning_place(step)? };
        let apart = wrap((x - phi) * T::TWO).abs() > T::WEAK;
        (!mirror || apart).then_some([if mirror { wrap(phi + phi - x) } else { x }, level])
    }

    /// Returns true if a second place is still to be told.
    pub(super) fn has_second_place(&self) -> bool {
        self.place == Place::Told && self.is_jointless
    }

    /// The place of the joint, rad from its default, the level there, and phi below. `step`: how far the joint was moved.
    ///
    /// The level is `a + b cos(x - phi)`: the joint moves a point or a direction on a circle. The stage has roots where
    /// the level is in its range, between -1 and 1. Of the interval next to the default the place is the point that is nearest to the
    /// default, a quarter of the interval inside. Without an interval it is where the level exceeds its range by least.
    #[inline(never)]
    fn turning_place(&self, step: T) -> Option<[T; 3]> {
        let start = T::from_i32(self.first.into()) * step;
        let [[at, _], [one, _], [two, _], ..] = self.levels;
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
        let [near, far] = [(self.range() - a) / b, (-self.range() - a) / b];
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

    /// The place of the joint, rad from its default, the level there, and the place again, if a slide is solved between the
    /// joint and the stage.
    ///
    /// The stroke of the slide is one harmonic `a + b cos(x - phi)` over another one, its coefficient. The level times the
    /// squared coefficient has harmonics up to the second, and so has the square. Five places tell both everywhere (Lagrange
    /// interpolation with sines of half angles). The place is where the level is nearest to 0, the middle of its range.
    #[inline(never)]
    fn place_behind_slide(&self, step: T) -> Option<[T; 3]> {
        let half = |multiple: usize| T::from_i32(i32::from(self.first) + multiple as i32) * step * T::HALF;
        let others = |node: usize| (0..MOST_SAMPLES).filter(move |other| *other != node);
        let sine = |angle: T| sin_cos(angle).0;
        let most = self.levels.iter().fold(T::ZERO, |most, [_, square]| most.max(*square));
        let mut nodes = self.levels;
        for (node, values) in nodes.iter_mut().enumerate() {
            let product = others(node).fold(T::ONE, |product, other| product * sine(half(node) - half(other)));
            *values = values.map(|value| value / product);
        }
        let level = |x: T| {
            let sines: [T; MOST_SAMPLES] = core::array::from_fn(|node| sine(x * T::HALF - half(node)));
            let [level, square] = nodes.iter().enumerate().fold([T::ZERO; 2], |[level, square], (node, values)| {
                let sines = others(node).filter_map(|other| sines.get(other));
                let product = sines.fold(T::ONE, |product, sine| product * *sine);
                let [of_level, of_square] = *values;
                [level + of_level * product, square + of_square * product]
            });
            // Where the slide all but vanishes, rounding is left.
            if square > most * T::COINCIDENT { level / square } else { T::NAN }
        };
        let (mut x, mut least, mut width) = (T::ZERO, T::INFINITY, T::TAU / T::from_i32(SCANNED));
        for here in (0..SCANNED).map(|k| width * T::from_i32(k)) {
            let size = level(here).abs();
            if size < least {
                (x, least) = (here, size);
            }
        }
        for _ in 0..HALVED {
            for here in [x - width, x + width] {
                let size = level(here).abs();
                if size < least {
                    (x, least) = (here, size);
                }
            }
            width *= T::HALF;
        }
        let (x, level) = (wrap(x), level(x));
        level.is_finite().then_some([x, level, x])
    }

    /// The largest level for which the stage has roots.
    fn range(&self) -> T {
        if self.is_jointless { T::ZERO } else { T::ONE }
    }

    /// The level, times a square, and the square of a run that moves the free joints by so many steps.
    pub(super) fn sample(&mut self, multiple: u8) -> Option<&mut [T; 2]> {
        self.levels.get_mut(usize::from(multiple.checked_sub(self.first)?))
    }

    /// Returns true if the `level` at the place is what it was `told` to be, and the stage has no root there by more than
    /// steps could close.
    pub(super) fn is_beyond(&self, told: T, level: T) -> bool {
        (level - told).abs() <= T::COINCIDENT * (T::ONE + told.abs()) && told.abs() - self.range() > T::DOUBTFUL
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
        let levels = [0.0, 1.0, 2.0, 3.0, 4.0].map(|k| [level(k * STEP), 1.0]);
        let open = Open::<f64, 1> { levels, ..Open::NONE };
        let [x, told, _] = open.turning_place(STEP).expect("a level that moves");
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
        let open = Open::<f64, 1> { levels: [[1.5, 1.0]; 5], ..Open::NONE };
        assert_eq!(open.turning_place(STEP), None);
        assert_eq!(Open::<f64, 1>::NONE.turning_place(STEP), None);
    }

    /// A vector of lengths 0.1 and u, whose component along a slide vanishes: with another component it is stretched by
    /// its square, and the slide does nothing at a right angle.
    #[test]
    fn a_level_behind_a_slide_is_least_where_it_touches_its_range() {
        for turned in [0.0, 0.7, 2.0, -2.9] {
            for u in [0.0, 0.03, -0.07, 0.09] {
                let coefficient = |x: f64| (x - turned).cos();
                let level = |x: f64| 1.0 + (u - 0.1 * (x - turned).sin()).powi(2) / coefficient(x).powi(2);
                let levels = [0.0, 1.0, 2.0, 3.0, 4.0].map(|k| {
                    let square = coefficient(k * STEP).powi(2);
                    [level(k * STEP) * square, square]
                });
                let open = Open::<f64, 1> { levels, is_behind_slide: true, ..Open::NONE };
                let [x, told, _] = open.place_behind_slide(STEP).expect("a level");
                assert!((told - 1.0).abs() < 1e-12 && (level(x) - 1.0).abs() < 1e-12, "{turned} {u}: {x} {told}");
            }
        }
        assert_eq!(Open::<f64, 1>::NONE.place_behind_slide(STEP), None);
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
