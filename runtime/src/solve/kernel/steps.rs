//! Values of a redundant joint.

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

#[cfg(test)]
mod tests {
    use super::steps;
    use std::vec::Vec;

    #[test]
    fn the_middles_of_equal_steps() {
        assert_eq!(steps(-1.0, 1.0, 3.0, 4).collect::<Vec<_>>(), [-0.75, -0.25, 0.25, 0.75]);
        assert_eq!(steps(f64::NEG_INFINITY, f64::INFINITY, 3.0, 2).collect::<Vec<_>>(), [-1.5, 1.5]);
        assert_eq!(steps(-1.0, 1.0, 3.0, 0).count(), 0);
        assert_eq!(steps(-1.0_f32, 1.0, 3.0, 4).collect::<Vec<_>>(), [-0.75, -0.25, 0.25, 0.75]);
    }

    #[test]
    fn a_number_beyond_i32_is_its_largest() {
        assert_eq!(steps(0.0, 1.0, 1.0, i32::MAX as usize).size_hint(), (i32::MAX as usize, Some(i32::MAX as usize)));
        assert_eq!(steps(0.0, 1.0, 1.0, usize::MAX).size_hint(), (i32::MAX as usize, Some(i32::MAX as usize)));
        // Each is inside the interval, the first half a step from its low end.
        assert_eq!(steps(0.0, 1.0, 1.0, usize::MAX).next(), Some(0.5 / f64::from(i32::MAX)));
    }
}
