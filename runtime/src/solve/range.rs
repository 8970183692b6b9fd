//! Where a joint that turns leaves a stage roots.

use super::kernel::circle::{Circle, angles};
use super::kernel::tolerances::Tolerances;
use super::place::{INSIDE, OTHERS};
use crate::math::wrap;
use core::cmp::Ordering;

/// Where a joint that turns leaves a stage roots: where both polynomials are positive, or for an equation vanish.
pub(super) struct Range<T> {
    bounds: [Circle<T>; 2],
    /// The square of the pole. Where it vanishes both bounds touch zero, which says nothing.
    square: Circle<T>,
    /// Where either vanishes, the first `len`.
    ends: [T; 8],
    len: usize,
    equation: bool,
    /// Bound on the miss of the stage at a double root that rounding has moved.
    rounding: T,
}

impl<T: Tolerances> Range<T> {
    #[inline(never)]
    pub(super) fn new(bounds: [Circle<T>; 2], square: Circle<T>, equation: bool) -> Self {
        let [above, below] = &bounds;
        let rounding = T::COINCIDENT * above.largest().max(below.largest());
        let mut range = Self { bounds, square, ends: [T::ZERO; 8], len: 0, equation, rounding };
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

    /// Returns true if the pole at x is large enough to trust the bounds: the prismatic joint is not weak there.
    fn sound(&self, x: T) -> bool {
        self.square.at(x) > T::WEAK * T::WEAK * self.square.largest()
    }

    /// The lower of the two bounds at x, positive where the stage has roots. For an equation, minus the absolute value
    /// of its bound.
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
        self.ends().map(ahead).fold(T::TAU, |least, ahead| ahead.min(least))
    }

    /// The place next to `now` in an interval, inside it by a quarter or `slack`.
    #[inline(never)]
    pub(super) fn interval(&self, now: T, slack: T) -> Option<T> {
        let quarter = T::from_f64(INSIDE);
        let here = (self.inside(now) > T::ZERO && self.sound(now)).then(|| {
            let (up, down) = (self.next(now, T::ONE), self.next(now, -T::ONE));
            let margin = ((up + down) * quarter).min(slack);
            now + (margin - down).max(T::ZERO) - (margin - up).max(T::ZERO)
        });
        let next_to_ends = self.ends().flat_map(|end| [(end, T::ONE), (end, -T::ONE)]).filter_map(|(end, way)| {
            let width = self.next(end, way);
            let middle = end + way * width * T::HALF;
            let within = self.inside(middle) > T::ZERO && self.sound(middle);
            within.then(|| end + way * (width * quarter).min(slack))
        });
        nearest(here.into_iter().chain(next_to_ends), now)
    }

    /// The interval around x and the widest other one, see [`Beside`].
    pub(super) fn intervals(&self, x: T) -> [[T; 2]; 2] {
        let (up, down) = (self.next(x, T::ONE), self.next(x, -T::ONE));
        let span = [x + (up - down) * T::HALF, ((up + down) * T::HALF).min(T::PI)];
        [span, self.other(span)]
    }

    /// Without an interval, the ends other than x at which the stage misses by no more than the rounding of a double
    /// root, as steps.
    #[inline(never)]
    pub(super) fn others(&self, x: T) -> [T; OTHERS] {
        let (mut others, mut len) = ([T::NAN; OTHERS], 0);
        for end in self.ends().filter(|end| self.meets(*end)) {
            let known = others.iter().take(len).map(|step| *step * T::TAU).chain([x]);
            let apart = known.fold(true, |apart, other| apart & (wrap(end - other).abs() > T::WEAK));
            if let Some(slot) = others.get_mut(len).filter(|_| apart) {
                *slot = wrap(end) / T::TAU;
                len += 1;
            }
        }
        others
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

    /// Returns true if the stage misses at x by no more than at a double root that rounding has moved.
    #[inline(never)]
    fn meets(&self, x: T) -> bool {
        self.sound(x) && self.inside(x) >= -self.rounding
    }

    /// Without an interval, the end at which the stage misses by least, and whether by no more than the rounding of a
    /// double root; `false` for an equation without a joint of its own. Of several such ends the nearest one counts.
    /// Without any end the stage misses everywhere, and by least where the slope of a bound vanishes.
    #[inline(never)]
    pub(super) fn touching(&self, now: T) -> Option<(T, bool)> {
        if let Some(x) = nearest(self.ends().filter(|x| self.meets(*x)), now) {
            return Some((x, !self.equation));
        }
        let ends = || self.ends().filter(|x| self.sound(*x));
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
