//! Angles in the unit that people read.

use denhart::JointKind;

/// Unit of angles; lengths are in the unit of the arm file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    /// Degrees.
    #[default]
    Deg,
    /// Radians.
    Rad,
}

impl Units {
    /// Its symbol.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Deg => "deg",
            Self::Rad => "rad",
        }
    }

    /// The unit in rad.
    #[must_use]
    pub fn in_rad(self) -> f64 {
        match self {
            Self::Deg => std::f64::consts::PI / 180.0,
            Self::Rad => 1.0,
        }
    }

    /// An angle in rad as a number of this unit. Degrees have 15 digits, without the rounding of the conversion.
    #[must_use]
    pub fn of(self, rad: f64) -> f64 {
        match self {
            Self::Deg => Self::rounded(rad.to_degrees()),
            Self::Rad => rad,
        }
    }

    /// A number of this unit in rad.
    #[must_use]
    pub fn rad(self, value: f64) -> f64 {
        match self {
            Self::Deg => value.to_radians(),
            Self::Rad => value,
        }
    }

    /// A joint value, rad or length, as a number of this unit or length.
    #[must_use]
    pub fn of_joint(self, kind: JointKind, value: f64) -> f64 {
        if kind == JointKind::Revolute { self.of(value) } else { value }
    }

    /// A number of this unit, or a length, as a joint value.
    #[must_use]
    pub fn joint(self, kind: JointKind, value: f64) -> f64 {
        if kind == JointKind::Revolute { self.rad(value) } else { value }
    }

    /// The value to 15 significant digits. A change of units is off by two units in the last place at most, which is less
    /// than half of the 15th digit.
    #[must_use]
    pub fn rounded(value: f64) -> f64 {
        format!("{value:.14e}").parse().unwrap_or(value) + 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_come_back_as_they_were_typed() {
        for hundredths in -36_000..=36_000 {
            let degrees = f64::from(hundredths) / 100.0;
            assert_eq!(Units::Deg.of(Units::Deg.rad(degrees)), degrees);
            assert_eq!(Units::Rad.of(Units::Rad.rad(degrees)), degrees);
        }
        // More than 15 digits are left out, and no more.
        assert_eq!(Units::Deg.of(1.0), 57.2957795130823);
        assert_eq!(Units::Rad.of(1.0 / 3.0), 1.0 / 3.0);
        assert_eq!([f64::INFINITY, 0.0, 7.2e-15, -1e300].map(Units::rounded), [f64::INFINITY, 0.0, 7.2e-15, -1e300]);
    }
}
