//! Numbers of the command line, in the units that the user has chosen.

use std::path::Path;

use clap::ValueEnum;
use denhart::JointKind;
use denhart_dynamic::{DynamicArm, DynamicError};
use denhart_tools::Error;

use crate::Failure;

/// Unit of angles; lengths are in the unit of the arm file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Units {
    Deg,
    Rad,
}

impl Units {
    /// Its symbol.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Deg => "deg",
            Self::Rad => "rad",
        }
    }

    /// The unit in rad.
    pub fn in_rad(self) -> f64 {
        match self {
            Self::Deg => std::f64::consts::PI / 180.0,
            Self::Rad => 1.0,
        }
    }

    /// An angle in rad as a number of this unit. Degrees have 15 digits, without the rounding of the conversion.
    pub fn of(self, rad: f64) -> f64 {
        match self {
            Self::Deg => rounded(rad.to_degrees()),
            Self::Rad => rad,
        }
    }

    /// A number of this unit in rad.
    pub fn rad(self, value: f64) -> f64 {
        match self {
            Self::Deg => value.to_radians(),
            Self::Rad => value,
        }
    }

    /// A joint value, rad or length, as a number of this unit or length.
    pub fn of_joint(self, kind: JointKind, value: f64) -> f64 {
        if kind == JointKind::Revolute { self.of(value) } else { value }
    }

    /// A number of this unit, or a length, as a joint value.
    pub fn joint(self, kind: JointKind, value: f64) -> f64 {
        if kind == JointKind::Revolute { self.rad(value) } else { value }
    }
}

/// The value to 15 significant digits. A change of units is off by two units in the last place at most, which is less
/// than half of the 15th digit.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value) + 0.0
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Option(message) => Self::Usage(message),
            other => Self::Other(other.to_string()),
        }
    }
}

impl From<DynamicError> for Failure {
    fn from(error: DynamicError) -> Self {
        match error {
            DynamicError::Joints { .. } | DynamicError::Target { .. } => Self::Usage(error.to_string()),
            DynamicError::Given { .. } | DynamicError::NoArmAngle => Self::Usage(error.to_string()),
            DynamicError::Mistakes(errors) => Self::Other(crate::each(&errors)),
            _ => Self::Other(error.to_string()),
        }
    }
}

impl Failure {
    /// Puts the place of its text before a failure.
    pub fn at(self, place: &str) -> Self {
        match self {
            Self::Usage(text) => Self::Usage(format!("{place}: {text}")),
            Self::Other(text) => Self::Other(format!("{place}: {text}")),
            other => other,
        }
    }
}

/// The arm of a file; `-` is the standard input.
///
/// # Errors
/// Mistakes in the file, or no way to read it.
pub fn arm(file: &Path) -> Result<DynamicArm, Failure> {
    let (text, name) = crate::arm::text(file).map_err(Failure::Other)?;
    Ok(DynamicArm::named(&text, &name)?)
}

/// `1 value`, `2 values`.
pub fn count(n: usize, of: &str) -> String {
    if n == 1 { format!("1 {of}") } else { format!("{n} {of}s") }
}

/// At most nine digits, no trailing zeros, no negative zero.
pub fn short(value: f64) -> String {
    if value != 0.0 && !(1e-6..1e9).contains(&value.abs()) {
        return if value.abs() < 1e-12 { "0".to_owned() } else { format!("{value:.3e}") };
    }
    let digits = 9 - (value.abs().log10().floor().max(0.0) as usize).min(9);
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The shortest text that reads back as the same number; no negative zero.
pub fn printed(value: f64) -> String {
    let value = value + 0.0;
    let magnitude = value.abs();
    if magnitude == 0.0 || (1e-5..1e16).contains(&magnitude) { format!("{value}") } else { format!("{value:e}") }
}

/// The joints outside their limits, as `q2 = 200 is above 90 deg`.
pub fn outside(arm: &DynamicArm, q: &[f64], units: Units) -> Vec<String> {
    let joints = arm.joint_names().zip(arm.joint_kinds()).zip(arm.limits().iter().zip(q));
    // As the inverse judges: a joint at its limit is within it, up to rounding.
    let slack = |value: f64| 16.0 * f64::EPSILON * (1.0 + value.abs());
    joints
        .filter_map(|((name, kind), ([low, high], value))| {
            let shown = |value: f64| short(units.of_joint(*kind, value));
            let (beyond, end) = match *value {
                value if value > high + slack(value) => ("above", *high),
                value if value < low - slack(value) => ("below", *low),
                _ => return None,
            };
            let length = arm.length_unit().to_string();
            let unit = if *kind == JointKind::Revolute { units.symbol() } else { &length };
            Some(format!("{name} = {} is {beyond} {} {unit}", shown(*value), shown(end)))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-1e-17, "0"),
            (90.0, "90"),
            (0.1 + 0.2, "0.3"),
            (-817.25, "-817.25"),
            (123456.7891234, "123456.7891"),
            (2.5e-9, "2.500e-9"),
            (3e12, "3.000e12"),
        ] {
            assert_eq!(short(value), text);
        }
    }

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
        assert_eq!([f64::INFINITY, 0.0, 7.2e-15, -1e300].map(rounded), [f64::INFINITY, 0.0, 7.2e-15, -1e300]);
    }
}
