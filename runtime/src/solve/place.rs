//! Where a free joint has to be for a later stage to have roots.

use super::kernel::circle::Circle;
use super::kernel::level::{Behind, Level};
use super::kernel::tolerances::Tolerances;
use super::range::Range;
use crate::math::{sin_cos, wrap};

/// Places at which the level of a stage is sampled, for a joint that turns.
pub(super) const PLACES: usize = 5;
/// How far inside the range of feasible places the joint goes, as a part of that range: at its ends two roots meet.
pub(super) const INSIDE: f64 = 0.25;
/// Places of a joint beside the nearest one at which an equation holds: of degree 2 it has four roots in all.
pub(super) const OTHERS: usize = 3;

/// A place of a free joint, as a step from its default value (in turns or in strokes), and whether the stage has roots
/// there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FreePlace<T> {
    pub(super) step: T,
    pub(super) feasible: bool,
    pub(super) elsewhere: Elsewhere<T>,
}

/// Where else a stage has roots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Elsewhere<T> {
    /// Around the place of a joint that turns: the middle of the interval, rad from its default, and half its width; of
    /// width 0 without any. Then the same of the widest other interval.
    pub(super) intervals: [[T; 2]; 2],
    /// Without an interval: at other places alone, as steps; NaN behind the last one.
    pub(super) places: [T; OTHERS],
}

impl<T: Tolerances> Elsewhere<T> {
    /// Nowhere.
    pub(super) const NOWHERE: Self = Self { intervals: [[T::ZERO; 2]; 2], places: [T::NAN; OTHERS] };

    /// One of the other places.
    pub(super) fn step(&self, index: usize) -> Option<T> {
        self.places.get(index).copied().filter(|step| step.is_finite())
    }
}

/// A level times the square of its pole, and that square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample<T>([T; 2]);

impl<T: Tolerances> Sample<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self([T::NAN; 2]);

    /// An equation that holds says nothing.
    pub(super) fn of(level: &Level<T>) -> Self {
        if level.is_met() {
            return Self::NONE;
        }
        let square = level.pole * level.pole;
        Self([level.value * square, square])
    }

    /// Returns true if two levels of one stage are known and differ. The stage then depends on the joint that has moved
    /// between.
    pub(super) fn differs(&self, other: &Self) -> bool {
        let (Self([one, pole]), Self([two, other])) = (*self, *other);
        (one / pole - two / other).abs() > T::COINCIDENT
    }

    /// A level of degree 1.
    pub(super) fn of_degree_1(level: T) -> Self {
        Self([level, T::ONE])
    }

    /// The level, where that is of degree 1.
    pub(super) fn value(&self) -> T {
        let Self([value, _]) = self;
        *value
    }

    fn is_known(&self) -> bool {
        self.value().is_finite()
    }

    /// Keeps a level, `over` what has been kept if it is set. An equation that does not hold, on another root of the
    /// same name, does not count beside it. Returns whether the level has been kept.
    pub(super) fn keep(&mut self, level: &Level<T>, over: bool) -> bool {
        let keeps = over && level.low < level.high || !self.is_known();
        if keeps {
            *self = Self::of(level);
        }
        keeps
    }
}

/// The levels of a stage at places of a free joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Samples<T> {
    values: [Sample<T>; PLACES],
    /// The range of the level in which there are roots.
    pub(super) low: T,
    pub(super) high: T,
    slides: bool,
}

impl<T: Tolerances> Samples<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self { values: [Sample::NONE; PLACES], low: T::NAN, high: T::NAN, slides: false };

    /// Fills in one level at every place before `place`. The range of the level and its prismatic joints are those of
    /// `behind`.
    pub(super) fn fill(&mut self, place: usize, sample: Sample<T>, behind: &Behind<T>) {
        self.values.iter_mut().take(place).for_each(|slot| *slot = sample);
        self.take_range(behind);
    }

    fn take_range(&mut self, Behind { level, slides }: &Behind<T>) {
        (self.low, self.high, self.slides) = (level.low, level.high, *slides);
    }

    /// Returns true if the level is of degree 1 in a revolute joint: no prismatic joint stands between or solves the
    /// stage.
    pub(super) fn are_simple(&self) -> bool {
        !(self.slides || self.low >= T::ZERO || self.high >= T::MAX)
    }

    /// Keeps the level at a place; `over` what has been kept there if it is set.
    pub(super) fn keep(&mut self, place: usize, behind: &Behind<T>, over: bool) {
        if self.values.get_mut(place).is_some_and(|slot| slot.keep(&behind.level, over)) {
            self.take_range(behind);
        }
    }

    /// The samples at all places.
    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Sample<T>> {
        self.values.iter_mut()
    }

    /// Takes samples that are not known from another stage's, if those known to both are the same.
    pub(super) fn complete(&mut self, other: &Self) {
        let pairs = || self.values.iter().zip(&other.values);
        let common = pairs().filter(|(one, other)| one.is_known() && other.is_known());
        if common.clone().count() > 1 && common.clone().all(|(one, other)| !one.differs(other)) {
            for (one, other) in self.values.iter_mut().zip(&other.values).filter(|(one, _)| !one.is_known()) {
                *one = *other;
            }
        }
    }

    /// One `part` of the samples at the first `count` places as a trigonometric polynomial of the step.
    pub(super) fn series(&self, count: usize, part: usize) -> Circle<T> {
        let values = self.values.each_ref().map(|Sample(values)| values.get(part).copied().unwrap_or(T::NAN));
        series(values.get(..count).unwrap_or(&[]))
    }

    /// The place of a joint that turns, from levels at `count` places: five, or three where the level is of degree 1.
    ///
    /// The level is `g(x) / p(x)^2` with trigonometric polynomials of degree 2 and 1. The coefficient of a slide
    /// between the joint and the stage is p; without a slide p is 1. So the range of the level ends at roots of `g -
    /// low p^2` and `high p^2 - g`, two quartics on the unit circle. The place lies in the feasible interval next to
    /// `now` (rad from its default). The place is inside that interval by a quarter, or by `slack` if that is less.
    /// Without an interval the place is the root at which the level misses its range by least. That root is the end of
    /// an interval that has shrunk to a point. `None` if the level does not depend on x.
    #[inline(never)]
    pub(super) fn turning(&self, count: usize, now: T, slack: T) -> Option<FreePlace<T>> {
        let (g, square) = (self.series(count, 0), self.series(count, 1));
        let bound = |end: T, sign: T| Circle {
            k0: (g.k0 - end * square.k0) * sign,
            k1: add(g.k1, square.k1.map(|k| -end * k)).map(|k| k * sign),
            k2: add(g.k2, square.k2.map(|k| -end * k)).map(|k| k * sign),
        };
        let above = bound(self.low, T::ONE);
        let below = if self.low < self.high && self.high < T::MAX { bound(self.high, -T::ONE) } else { above };
        let moves = above.k1.iter().chain(&above.k2).any(|k| k.abs() > T::ROUNDING * (T::ONE + above.k0.abs()));
        if !moves || !(above.largest() + below.largest()).is_finite() {
            return None;
        }
        let range = Range::new([above, below], square, self.low == self.high);
        let (x, feasible, elsewhere) = match range.interval(now, slack) {
            Some(x) => (x, true, Elsewhere { intervals: range.intervals(x), ..Elsewhere::NOWHERE }),
            None => {
                let (x, feasible) = range.touching(now)?;
                (x, feasible, Elsewhere { places: range.others(x), ..Elsewhere::NOWHERE })
            }
        };
        Some(FreePlace { step: wrap(x) / T::TAU, feasible, elsewhere })
    }

    /// The place of a prismatic joint, from levels at the default and one unit either way: `level = a + b u + c u^2`.
    #[inline(never)]
    pub(super) fn sliding(&self, now: T) -> Option<FreePlace<T>> {
        let Self { values: [Sample([l0, _]), Sample([l1, _]), Sample([l2, _]), ..], low, high, .. } = *self;
        let place = |step, feasible| Some(FreePlace { step, feasible, elsewhere: Elsewhere::NOWHERE });
        let (a, b, c) = (l0, (l1 - l2) * T::HALF, (l1 + l2) * T::HALF - l0);
        if !(b.abs().max(c.abs()) > T::ROUNDING * (T::ONE + a.abs())) {
            return None;
        }
        let curved = c.abs() > T::COINCIDENT * b.abs();
        let vertex = -b / (c + c);
        let extreme = a - b * b / (c * (T::TWO + T::TWO));
        let (least, most) = match curved {
            true if c > T::ZERO => (low.max(extreme), high),
            true => (low, high.min(extreme)),
            false => (low, high),
        };
        if !(least <= most) {
            return place(vertex, least < most + T::COINCIDENT);
        }
        let at = a + now * (b + now * c);
        let inside = ((most - least) * T::from_f64(INSIDE)).min(T::from_f64(INSIDE));
        let level = at.min(most - inside).max(least + inside);
        if level == at {
            return place(now, true);
        }
        let step = if curved {
            let off = ((level - extreme) / c).max(T::ZERO).sqrt();
            if now < vertex { vertex - off } else { vertex + off }
        } else {
            (level - a) / b
        };
        let mirror = vertex + vertex - step;
        let twice = curved && low == high && (mirror - step).abs() > T::WEAK;
        let mut elsewhere = Elsewhere::NOWHERE;
        if twice && let Some(place) = elsewhere.places.first_mut() {
            *place = mirror;
        }
        Some(FreePlace { step, feasible: true, elsewhere })
    }

    /// The place of a joint that turns and that the level does not depend on: where the joint is.
    pub(super) fn anywhere(&self, now: T) -> Option<FreePlace<T>> {
        let Self { values: [level, ..], low, high, .. } = self;
        let feasible = *low <= level.value() && level.value() <= *high;
        level.is_known().then(|| FreePlace { step: wrap(now) / T::TAU, feasible, elsewhere: Elsewhere::NOWHERE })
    }
}

/// Samples at as many places as a trigonometric polynomial of the step, by its discrete Fourier transform. The
/// polynomial is of degree 2 through 5 places, of degree 1 through 3.
#[inline(never)]
pub(super) fn series<T: Tolerances>(samples: &[T]) -> Circle<T> {
    let count = samples.len();
    let share = T::ONE / T::from_i32(count as i32);
    let mut circle = Circle { k0: T::ZERO, k1: [T::ZERO; 2], k2: [T::ZERO; 2] };
    for (place, sample) in samples.iter().enumerate() {
        let value = *sample * share;
        let ((s, c), twice) = (sin_cos(turn(count, place)), value + value);
        circle.k0 += value;
        circle.k1 = add(circle.k1, [twice * c, twice * s]);
        if count == PLACES {
            circle.k2 = add(circle.k2, [twice * (c * c - s * s), twice * (s * c + s * c)]);
        }
    }
    circle
}

/// The step to a place where a joint that turns is sampled, rad. The first one is not the default, and all are off the
/// grids on which arms are singular.
pub(super) fn turn<T: Tolerances>(count: usize, place: usize) -> T {
    T::TAU * (T::from_f64(0.03) + T::from_i32(place as i32) / T::from_i32(count as i32))
}

/// The step to a place where a prismatic joint is sampled, in strokes. Three places are needed.
pub(super) fn stroke<T: Tolerances>(place: usize) -> T {
    match place {
        1 => T::ONE,
        2 => -T::ONE,
        _ => T::ZERO,
    }
}

fn add<T: Tolerances>([a, b]: [T; 2], [c, d]: [T; 2]) -> [T; 2] {
    [a + c, b + d]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used)]

    use super::super::kernel::level::LevelOf;
    use super::*;

    /// An equation that holds where `cos x = 0.3`, on either side of the default value.
    #[test]
    fn an_equation_is_met_at_every_root() {
        let mut samples = Samples::<f64>::NONE;
        for at in 0..3 {
            let level = Level::from(LevelOf::Zero(turn::<f64>(3, at).cos() - 0.3));
            samples.keep(at, &Behind { level, slides: false }, true);
        }
        let root = 0.3_f64.acos();
        let place = samples.turning(3, 1.0, f64::INFINITY).expect("an equation in x");
        assert!((place.step * std::f64::consts::TAU - root).abs() < 1e-9, "{place:?}");
        let other = place.elsewhere.step(0).expect("another root");
        assert!((other * std::f64::consts::TAU + root).abs() < 1e-9 && place.elsewhere.step(1).is_none(), "{place:?}");
    }

    /// `u^2 - 0.25` in strokes.
    #[test]
    fn a_free_slide_meets_an_equation_at_both_roots() {
        let mut samples = Samples::<f64>::NONE;
        for at in 0..3 {
            let level = Level::from(LevelOf::Zero(stroke::<f64>(at).powi(2) - 0.25));
            samples.keep(at, &Behind { level, slides: false }, true);
        }
        let place = samples.sliding(0.4).expect("an equation in u");
        assert!((place.step - 0.5).abs() < 1e-12 && place.elsewhere.step(0) == Some(-place.step), "{place:?}");
    }
}
