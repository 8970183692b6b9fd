//! The range of the numbers in a file: what the arithmetic of generated code can use, in double precision.

/// Numbers that are 0 or of a size from `least` to `most`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Noun for the numbers, and the unit of `least` and `most`.
    what: &'static str,
    unit: &'static str,
    least: f64,
    most: f64,
}

/// Kernels compute fourth powers of lengths: an arm's reach has these bounds too.
pub const LENGTH: Range = Range { what: "length", unit: "", least: 1e-60, most: 1e60 };
/// Where a joint or a motor stands, whose length counts for no reach.
pub const POSITION: Range = Range { what: "length", unit: "", least: 1e-30, most: 1e30 };
/// An angle of a million rad is known to 1e-10 rad.
pub const ANGLE: Range = Range { what: "angle", unit: " rad", least: 1e-30, most: 1e6 };
/// Factors and pulses: their squares and products stay in single precision.
pub const FACTOR: Range = Range { what: "factor", unit: "", least: 1e-12, most: 1e12 };
/// Weights: the same.
pub const WEIGHT: Range = Range { what: "weight", ..FACTOR };

impl Range {
    /// Description of the expected numbers, if the value is beyond the range.
    pub fn missed(&self, value: f64) -> Option<String> {
        let Range { what, unit, least, most } = self;
        let size = value.abs();
        let article = if what.starts_with('a') { "an" } else { "a" };
        if size == 0.0 || (size >= *least && size <= *most) {
            None
        } else if size < *least {
            Some(format!("{article} {what} of 0, or not below {least:e}{unit}"))
        } else {
            Some(format!("{article} {what} not beyond {most:e}{unit}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_and_the_ends_are_within() {
        for value in [0.0, -0.0, 1e-60, -1e60, 1.0] {
            assert_eq!(LENGTH.missed(value), None, "{value}");
        }
        assert_eq!(LENGTH.missed(-1e308).as_deref(), Some("a length not beyond 1e60"));
        assert_eq!(ANGLE.missed(1e-320).as_deref(), Some("an angle of 0, or not below 1e-30 rad"));
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(FACTOR.missed(value).as_deref(), Some("a factor not beyond 1e12"), "{value}");
        }
    }
}
