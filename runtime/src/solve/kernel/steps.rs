//! Values of redundant joints.

use super::tolerances::Tolerances;

/// The middles of `n` equal steps from `low` to `high`; an end that is infinite becomes minus or plus `whole`.
///
/// `n` is at most `i32::MAX`; a larger one counts as that.
pub fn steps<T: Tolerances>(low: T, high: T, whole: T, n: usize) -> impl Iterator<Item = T> {
    let low = if low.is_finite() { low } else { -whole };
    let high = if high.is_finite() { high } else { whole };
    let n = i32::try_from(n).unwrap_or(i32::MAX);
    let count = T::from_i32(n);
    (0..n).map(move |k| low + (high - low) * (T::from_i32(k) + T::HALF) / count)
}

/// A grid of values: of each range `([low, high], whole)` the [`steps`] in number `n`, the last one fastest.
///
/// The grid has at most `usize::MAX` points; a larger one ends there.
pub fn grid<T: Tolerances, const K: usize>(ranges: [([T; 2], T); K], n: [usize; K]) -> impl Iterator<Item = [T; K]> {
    let counts = n.map(|n| n.min(i32::MAX as usize));
    let points = counts.iter().fold(1, |product: usize, n| product.saturating_mul(*n));
    (0..points).map(move |mut point| {
        let mut values = [T::ZERO; K];
        for ((value, ([low, high], whole)), n) in values.iter_mut().zip(ranges).zip(counts).rev() {
            // Without a step there is no point.
            let k = point.checked_rem(n).unwrap_or(0);
            point = point.checked_div(n).unwrap_or(0);
            *value = steps(low, high, whole, n).nth(k).unwrap_or(T::ZERO);
        }
        values
    })
}

#[cfg(test)]
mod tests {
    use super::{grid, steps};
    use std::vec::Vec;

    #[test]
    fn the_middles_of_equal_steps() {
        assert_eq!(steps(-1.0, 1.0, 3.0, 4).collect::<Vec<_>>(), [-0.75, -0.25, 0.25, 0.75]);
        assert_eq!(steps(f64::NEG_INFINITY, f64::INFINITY, 3.0, 2).collect::<Vec<_>>(), [-1.5, 1.5]);
        assert_eq!(steps(-1.0, 1.0, 3.0, 0).count(), 0);
        assert_eq!(steps(-1.0_f32, 1.0, 3.0, 4).collect::<Vec<_>>(), [-0.75, -0.25, 0.25, 0.75]);
    }

    #[test]
    fn every_point_of_a_grid() {
        let unit = ([0.0, 1.0], 1.0);
        let points = grid([unit, ([f64::NEG_INFINITY, f64::INFINITY], 3.0)], [2, 3]).collect::<Vec<_>>();
        assert_eq!(points, [[0.25, -2.0], [0.25, 0.0], [0.25, 2.0], [0.75, -2.0], [0.75, 0.0], [0.75, 2.0]]);
        assert_eq!(grid([unit; 2], [5, 0]).count(), 0);
        assert_eq!(grid([unit; 1], [2]).collect::<Vec<_>>(), [[0.25], [0.75]]);
        // More points than can be counted: the first ones are there.
        assert_eq!(grid([unit; 3], [usize::MAX; 3]).take(2).count(), 2);
    }

    #[test]
    fn a_number_beyond_i32_is_its_largest() {
        assert_eq!(steps(0.0, 1.0, 1.0, i32::MAX as usize).size_hint(), (i32::MAX as usize, Some(i32::MAX as usize)));
        assert_eq!(steps(0.0, 1.0, 1.0, usize::MAX).size_hint(), (i32::MAX as usize, Some(i32::MAX as usize)));
        // Each is inside the interval, the first half a step from its low end.
        assert_eq!(steps(0.0, 1.0, 1.0, usize::MAX).next(), Some(0.5 / f64::from(i32::MAX)));
    }
}
