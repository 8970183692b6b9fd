//! Equally spaced times.

/// Most samples: beyond it a file would have terabytes, and a step is more likely a mistake.
const MOST: f64 = 1e10;

/// Equally spaced times from a first to at most a last one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Times {
    from: f64,
    to: f64,
    step: f64,
    /// The last index.
    last: u64,
    /// True if the last time is `to`.
    whole: bool,
}

impl Times {
    /// Times `from`, `from + step`, ... up to `to`, which is met where the range is a whole number of steps to 1e-9 of
    /// them.
    ///
    /// # Errors
    /// A time that is not finite, a step that is not positive, a first time later than the last.
    pub fn new(from: f64, to: f64, step: f64) -> Result<Self, String> {
        for (name, value) in [("from", from), ("to", to), ("step", step)] {
            if !value.is_finite() {
                return Err(format!("--{name} {value} is not a finite time"));
            }
        }
        if step <= 0.0 {
            return Err(format!("--step {step} is not a positive time"));
        }
        if from > to {
            return Err(format!("--from {from} is later than --to {to}"));
        }
        let steps = (to - from) / step;
        if steps > MOST || (from < to && (from + step <= from || to - step >= to)) {
            return Err(format!("--step {step} is too small for the time from {from} to {to}"));
        }
        let whole = (steps - steps.round()).abs() <= 1e-9 * steps.max(1.0);
        let last = if whole { steps.round() } else { steps.floor() };
        // At most MOST, so it fits.
        Ok(Self { from, to, step, last: last as u64, whole })
    }

    /// Number of samples, at least 1.
    pub fn count(&self) -> u64 {
        self.last + 1
    }

    /// The time of a sample. Of a step that is a whole part of a second the part is exact: three steps of 0.1 are 0.3.
    pub fn at(&self, index: u64) -> f64 {
        if self.whole && index == self.last && index > 0 {
            return self.to;
        }
        let parts = (1.0 / self.step).round();
        let is_part = parts >= 1.0 && (self.step * parts - 1.0).abs() <= f64::EPSILON;
        self.from + if is_part { index as f64 / parts } else { self.step * index as f64 }
    }
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use super::*;

    fn all(from: f64, to: f64, step: f64) -> Vec<f64> {
        let times = Times::new(from, to, step).unwrap_or_else(|error| panic!("{error}"));
        (0..times.count()).map(|index| times.at(index)).collect()
    }

    #[test]
    fn both_ends_where_the_steps_are_whole() {
        assert_eq!(all(0.0, 0.4, 0.1), [0.0, 0.1, 0.2, 0.3, 0.4]);
        assert_eq!(all(-1.0, 1.0, 1.0), [-1.0, 0.0, 1.0]);
        assert_eq!(all(0.0, 1.0, 0.4), [0.0, 0.4, 0.8]);
        assert_eq!(all(2.0, 2.0, 0.5), [2.0]);
        assert_eq!(all(2.0, 2.1, 0.5), [2.0]);
        assert_eq!(all(0.0, 1.0, 1e-6).len(), 1_000_001);
        assert_eq!(all(0.0, 1.0, 1e-6).last(), Some(&1.0));
    }

    #[test]
    fn mistakes_name_the_option() {
        let cases = [
            ((0.0, 1.0, 0.0), "--step 0 is not a positive"),
            ((0.0, 1.0, -0.1), "--step -0.1 is not a positive"),
            ((2.0, 1.0, 0.1), "--from 2 is later than --to 1"),
            ((f64::NAN, 1.0, 0.1), "--from NaN"),
            ((0.0, f64::INFINITY, 0.1), "--to inf"),
            ((0.0, 1.0, f64::NAN), "--step NaN"),
            ((0.0, 1.0, 1e-300), "too small"),
            ((1e16, 1e16 + 4.0, 0.1), "too small"),
        ];
        for ((from, to, step), message) in cases {
            assert!(matches!(Times::new(from, to, step), Err(error) if error.contains(message)), "{message}");
        }
    }
}
