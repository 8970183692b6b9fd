//! Where a free joint has to be for a second stage to have roots, on either root of a first one.

use super::kernel::level::Level;
use super::kernel::tolerances::Tolerances;
use super::place::Samples;
use crate::math::sin_cos;

/// The number of nodes in an interval.
pub(super) const NODES: usize = 5;
/// Places round a turn at which a function is looked at, and steps that narrow the best one down.
const ROUND: i32 = 32;
const NARROW: usize = 24;

/// The levels of the stage that follows on either root of a first one, at the nodes of the first one's interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SecondLevel<T> {
    /// On the first root and on the second.
    values: [[T; 2]; NODES],
    low: T,
    high: T,
}

impl<T: Tolerances> SecondLevel<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self { values: [[T::NAN; 2]; NODES], low: T::NAN, high: T::NAN };

    /// Keeps the level at a node: the first one that comes is on the first root, the next other one on the second.
    pub(super) fn keep(&mut self, node: usize, level: &Level<T>) {
        let Some([first, second]) = self.values.get_mut(node) else { return };
        if !first.is_finite() {
            (self.low, self.high) = (level.low, level.high);
            (*first, *second) = (level.value, level.value);
        } else if *second == *first {
            *second = level.value;
        }
    }

    /// The place, rad from its default, at which the level is farthest inside its range, on either root. The place is
    /// in the interval, or in another interval of the first stage. A narrow interval tells nothing about another one.
    ///
    /// The roots of the first stage are at `+-h`, with `cos h` its own level. The levels are `u +- s sin(h)` with
    /// trigonometric polynomials u and s of degree 2. The nodes determine these polynomials by Lagrange's form
    /// `sum_k f_k prod_{j != k} sin((x - x_j) / 2) / sin((x_k - x_j) / 2)`.
    #[inline(never)]
    pub(super) fn place(&self, first: &Samples<T>, [[middle, half], other]: [[T; 2]; 2]) -> Option<T> {
        let series = [first.series(3, 0), first.series(3, 1)];
        // Half angles from the middle, so that a narrow interval loses no digits.
        let halves: [(T, T); NODES] = core::array::from_fn(|k| sin_cos(half * node(k) * T::HALF));
        let (s0, c0) = sin_cos(middle);
        // The sine of h, up to a factor, from the sine and cosine of half the angle from the middle.
        let sine = |(s, c): (T, T)| {
            let (s, c) = (s * c + s * c, c * c - s * s);
            let [level, square] = series.each_ref().map(|circle| circle.toward((s0 * c + c0 * s, c0 * c - s0 * s)));
            let level = level / square;
            ((level - first.low) * (first.high - level)).max(T::ZERO).sqrt()
        };
        // For every node the product of Lagrange's form over the other ones.
        let others = |(sin, cos): (T, T)| {
            let factors = halves.map(|(s, c)| sin * c - cos * s);
            let (mut products, mut before, mut behind) = ([T::ONE; NODES], T::ONE, T::ONE);
            for (product, factor) in products.iter_mut().zip(factors) {
                *product = before;
                before *= factor;
            }
            for (product, factor) in products.iter_mut().rev().zip(factors.iter().rev()) {
                *product *= behind;
                behind *= *factor;
            }
            products
        };
        let mut sums = self.values;
        for (k, (([mean, share], at), values)) in sums.iter_mut().zip(halves).zip(&self.values).enumerate() {
            let [one, other] = *values;
            let weight = T::HALF / others(at).get(k).copied()?;
            *mean = (one + other) * weight;
            *share = (one - other) * weight / sine(at);
        }
        let inside = |[center, width]: [T; 2], turn: T| {
            let (s, c) = sin_cos(turn);
            let from_middle = (center - middle) + width * c;
            let at = sin_cos(from_middle * T::HALF);
            let (mut mean, mut share) = (T::ZERO, T::ZERO);
            for ([m, d], weight) in sums.iter().zip(others(at)) {
                mean += weight * *m;
                share += weight * *d;
            }
            let level = mean + share * sine(at).copysign(s);
            (level - self.low).min(self.high - level)
        };
        let best = |span: [T; 2]| {
            let [center, width] = span;
            highest(&|turn| inside(span, turn)).map(|(turn, inside)| (center + width * sin_cos(turn).1, inside))
        };
        let [_, width] = other;
        let here = best([middle, half]);
        let there = if width > T::ZERO && half * half > T::WEAK { best(other) } else { None };
        there.into_iter().fold(here, |best, (place, inside)| better(best, place, inside)).map(|(place, _)| place)
    }
}

/// The turn at which a periodic function is highest, rad, and its value there: the best one of [`ROUND`], narrowed
/// down. `None` if the function is nowhere finite.
#[inline(never)]
pub(super) fn highest<T: Tolerances>(inside: &dyn Fn(T) -> T) -> Option<(T, T)> {
    let mut step = T::TAU / T::from_i32(ROUND);
    let mut best = None;
    for turn in (0..ROUND).map(|k| step * T::from_i32(k)) {
        best = better(best, turn, inside(turn));
    }
    for _ in 0..NARROW {
        step *= T::HALF;
        let (middle, _) = best?;
        for turn in [middle - step, middle + step] {
            best = better(best, turn, inside(turn));
        }
    }
    best
}

/// The better one of two turns: where a stage has its roots by more. One that says nothing does not count.
fn better<T: Tolerances>(best: Option<(T, T)>, turn: T, inside: T) -> Option<(T, T)> {
    let better = inside.is_finite() && best.is_none_or(|(_, most)| inside > most);
    if better { Some((turn, inside)) } else { best }
}

/// A node as a share of half the interval from its middle: a root of Chebyshev's polynomial of degree 5.
pub(super) fn node<T: Tolerances>(k: usize) -> T {
    let (_, cos) = sin_cos(T::PI * T::from_f64(0.1) * T::from_i32(2 * k as i32 + 1));
    cos
}
