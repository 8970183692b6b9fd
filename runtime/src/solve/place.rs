//! Where a free joint has to be for a later stage to have roots.

use super::Tolerances;
use super::circle::{Circle, angles};
use super::stage::{Behind, Level};
use crate::math::{sin_cos, wrap};
use core::cmp::Ordering;

/// Places at which the level of a stage is sampled, for a joint that turns.
pub(super) const PLACES: usize = 5;
/// How far inside the range of feasible places the joint goes, as a part of that range: at its ends two roots meet.
const INSIDE: f64 = 0.25;

/// A place of a free joint, as a step from its home (in turns or in strokes), and whether the stage has roots there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place<T> {
    pub(super) step: T,
    pub(super) feasible: bool,
    /// The middle of the feasible interval, rad from home, and half its width; 0 where there is none.
    pub(super) span: [T; 2],
    /// The widest other one.
    pub(super) other: [T; 2],
}

/// A level times the square of its pole, and that square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample<T>([T; 2]);

impl<T: Tolerances> Sample<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self([T::NAN; 2]);

    /// An equation that is met says nothing.
    pub(super) fn of(level: &Level<T>) -> Self {
        if level.is_met() {
            return Self::NONE;
        }
        let square = level.pole * level.pole;
        Self([level.value * square, square])
    }

    /// Whether two levels of one stage are known and differ: the stage depends on the joint that has moved between.
    pub(super) fn differs(&self, other: &Self) -> bool {
        let (Self([one, pole]), Self([two, other])) = (*self, *other);
        (one / pole - two / other).abs() > T::COINCIDENT
    }

    fn is_known(&self) -> bool {
        let Self([value, _]) = self;
        value.is_finite()
    }

    /// Keeps a level, `over` what has been kept if it is set. An equation that is not met, on another root of the same
    /// name, does not count beside it. Returns whether the level has been kept.
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

    /// The same level at every place before this one.
    pub(super) fn fill(&mut self, place: usize, sample: Sample<T>) {
        self.values.iter_mut().take(place).for_each(|slot| *slot = sample);
    }

    /// Whether the level is of degree 1 in a joint that turns: no slide stands between, and none solves the stage.
    pub(super) fn are_simple(&self) -> bool {
        !(self.slides || self.low >= T::ZERO || self.high >= T::MAX)
    }

    /// Keeps the level at a place; `over` what has been kept there if it is set.
    pub(super) fn keep(&mut self, place: usize, Behind { level, slides }: &Behind<T>, over: bool) {
        if self.values.get_mut(place).is_some_and(|slot| slot.keep(level, over)) {
            (self.low, self.high, self.slides) = (level.low, level.high, *slides);
        }
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

    /// One `part` of the samples at the first `count` places as a trigonometric polynomial of the step, by its discrete
    /// Fourier transform. The polynomial is of degree 2 through 5 places, of degree 1 through 3.
    #[inline(never)]
    pub(super) fn series(&self, count: usize, part: usize) -> Circle<T> {
        let share = T::ONE / T::from_i32(count as i32);
        let mut circle = Circle { k0: T::ZERO, k1: [T::ZERO; 2], k2: [T::ZERO; 2] };
        for (place, Sample(values)) in self.values.iter().enumerate().take(count) {
            let value = values.get(part).copied().unwrap_or(T::NAN) * share;
            let ((s, c), twice) = (sin_cos(turn(count, place)), value + value);
            circle.k0 += value;
            circle.k1 = add(circle.k1, [twice * c, twice * s]);
            if count == PLACES {
                circle.k2 = add(circle.k2, [twice * (c * c - s * s), twice * (s * c + s * c)]);
            }
        }
        circle
    }

    /// The place of a joint that turns, from levels at `count` places: five, or three where the level is of degree 1.
    ///
    /// The level is `g(x) / p(x)^2` with trigonometric polynomials of degree 2 and 1. The coefficient of a slide
    /// between the joint and the stage is p; without a slide p is 1. So the range of the level ends at roots of
    /// `g - low p^2` and `high p^2 - g`, two quartics on the unit circle. The place lies in the feasible interval next
    /// to `now` (rad from home), inside it by a quarter, or by `slack` if that is less. Without an interval the place
    /// is the root at which the level misses its range by least. That root is the end of an interval that has shrunk to
    /// a point. `None` if the level does not depend on x.
    #[inline(never)]
    pub(super) fn turning(&self, count: usize, now: T, slack: T) -> Option<Place<T>> {
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
        let (x, feasible) = match range.interval(now, slack) {
            Some(x) => (x, true),
            None => range.touching(now)?,
        };
        let (up, down) = if feasible { (range.next(x, T::ONE), range.next(x, -T::ONE)) } else { (T::ZERO, T::ZERO) };
        let span = [x + (up - down) * T::HALF, ((up + down) * T::HALF).min(T::PI)];
        let other = if feasible { range.other(span) } else { [T::ZERO; 2] };
        Some(Place { step: wrap(x) / T::TAU, feasible, span, other })
    }

    /// The same for a joint that slides, from the levels at home and one unit either way: `level = a + b u + c u^2`.
    #[inline(never)]
    pub(super) fn sliding(&self, now: T) -> Option<Place<T>> {
        let Self { values: [Sample([l0, _]), Sample([l1, _]), Sample([l2, _]), ..], low, high, .. } = *self;
        let (span, other) = ([T::ZERO; 2], [T::ZERO; 2]);
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
            return Some(Place { step: vertex, feasible: least < most + T::COINCIDENT, span, other });
        }
        let at = a + now * (b + now * c);
        let inside = ((most - least) * T::from_f64(INSIDE)).min(T::from_f64(INSIDE));
        let level = at.min(most - inside).max(least + inside);
        if level == at {
            return Some(Place { step: now, feasible: true, span, other });
        }
        let step = if curved {
            let off = ((level - extreme) / c).max(T::ZERO).sqrt();
            if now < vertex { vertex - off } else { vertex + off }
        } else {
            (level - a) / b
        };
        Some(Place { step, feasible: true, span, other })
    }
}

/// Where a joint that turns leaves a stage roots: where both polynomials are positive, or for an equation vanish.
struct Range<T> {
    bounds: [Circle<T>; 2],
    /// The square of the pole. Where it vanishes both bounds touch zero, which says nothing.
    square: Circle<T>,
    /// Where either vanishes, the first `len`.
    ends: [T; 8],
    len: usize,
    equation: bool,
}

impl<T: Tolerances> Range<T> {
    #[inline(never)]
    fn new(bounds: [Circle<T>; 2], square: Circle<T>, equation: bool) -> Self {
        let mut range = Self { bounds, square, ends: [T::ZERO; 8], len: 0, equation };
        for bound in &bounds {
            let (roots, found) = angles(bound);
            for (slot, root) in range.ends.iter_mut().skip(range.len).zip(roots.iter().take(found)) {
                *slot = root.value;
            }
            range.len += found;
        }
        range
    }

    fn ends(&self) -> impl Iterator<Item = T> {
        self.ends.iter().copied().take(self.len)
    }

    /// Whether the pole says something at x: the slide is not itself nearly free there.
    fn sound(&self, x: T) -> bool {
        self.square.at(x) > T::WEAK * T::WEAK * self.square.largest()
    }

    /// By how much the stage has roots at x.
    #[inline(never)]
    fn inside(&self, x: T) -> T {
        let [above, below] = self.bounds.map(|bound| bound.at(x));
        if self.equation { -above.abs() } else { above.min(below) }
    }

    /// The angle from x to the next end one way round; a whole turn without any.
    #[inline(never)]
    fn next(&self, x: T, way: T) -> T {
        let ahead = |end: T| {
            let ahead = wrap(way * (end - x));
            if ahead > T::ZERO { ahead } else { ahead + T::TAU }
        };
        self.ends().map(ahead).fold(T::TAU, |least, ahead| least.min(ahead))
    }

    /// The place next to `now` in an interval, inside it by a quarter or `slack`.
    #[inline(never)]
    fn interval(&self, now: T, slack: T) -> Option<T> {
        let quarter = T::from_f64(INSIDE);
        let here = (self.inside(now) > T::ZERO && self.sound(now)).then(|| {
            let (up, down) = (self.next(now, T::ONE), self.next(now, -T::ONE));
            let margin = ((up + down) * quarter).min(slack);
            now + (margin - down).max(T::ZERO) - (margin - up).max(T::ZERO)
        });
        let beside = self.ends().flat_map(|end| [(end, T::ONE), (end, -T::ONE)]).filter_map(|(end, way)| {
            let width = self.next(end, way);
            let middle = end + way * width * T::HALF;
            let within = self.inside(middle) > T::ZERO && self.sound(middle);
            within.then(|| end + way * (width * quarter).min(slack))
        });
        nearest(here.into_iter().chain(beside), now)
    }

    /// The widest interval beside one, as its middle and half its width; of width 0 without any.
    #[inline(never)]
    fn other(&self, [middle, half]: [T; 2]) -> [T; 2] {
        let mut widest = [T::ZERO; 2];
        for end in self.ends() {
            let width = self.next(end, T::ONE) * T::HALF;
            let center = end + width;
            let apart = wrap(center - middle).abs() > half;
            let [_, most] = widest;
            if apart && width > most && self.inside(center) > T::ZERO && self.sound(center) {
                widest = [center, width];
            }
        }
        widest
    }

    /// Without an interval, the end at which the stage misses by least, and whether by no more than the rounding of a
    /// double root; `false` for an equation without a joint of its own. Of several such ends the nearest one counts. Without any end the stage misses everywhere, and by
    /// least where the slope of a bound vanishes.
    #[inline(never)]
    fn touching(&self, now: T) -> Option<(T, bool)> {
        let [above, below] = self.bounds;
        let scale = T::COINCIDENT * above.largest().max(below.largest());
        let ends = || self.ends().filter(|x| self.sound(*x));
        if let Some(x) = nearest(ends().filter(|x| self.inside(*x) >= -scale), now) {
            return Some((x, !self.equation));
        }
        let by_miss = |a: &T, b: &T| self.inside(*b).partial_cmp(&self.inside(*a)).unwrap_or(Ordering::Equal);
        if let Some(x) = ends().min_by(by_miss) {
            return Some((x, false));
        }
        let slopes = self.bounds.map(|bound| angles(&bound.slope()));
        let flat = slopes.iter().flat_map(|(roots, found)| roots.iter().take(*found)).map(|root| root.value);
        flat.filter(|x| self.sound(*x)).min_by(by_miss).map(|x| (x, false))
    }
}

/// The one of several places that is nearest to `now`.
fn nearest<T: Tolerances>(places: impl Iterator<Item = T>, now: T) -> Option<T> {
    let far = |x: &T| wrap(*x - now).abs();
    places.min_by(|a, b| far(a).partial_cmp(&far(b)).unwrap_or(Ordering::Equal))
}

/// The step to a place where a joint that turns is sampled, rad. The first one is not home, and all are off the grids
/// on which arms are singular.
pub(super) fn turn<T: Tolerances>(count: usize, place: usize) -> T {
    T::TAU * (T::from_f64(0.03) + T::from_i32(place as i32) / T::from_i32(count as i32))
}

/// The same for one that slides, in strokes; it needs three places.
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
