//! Values of a redundant joint.

use super::Tolerances;

/// The middles of `n` equal steps from `low` to `high`; an end that is infinite becomes minus or plus `whole`.
pub fn steps<T: Tolerances>(low: T, high: T, whole: T, n: usize) -> impl Iterator<Item = T> {
    let low = if low.is_finite() { low } else { -whole };
    let high = if high.is_finite() { high } else { whole };
    let count = T::from_f64(n as f64);
    (0..n).map(move |k| low + (high - low) * (T::from_f64(k as f64) + T::HALF) / count)
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
    }
}
