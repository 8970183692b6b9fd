//! Numbers of the command line, in the units that the user has chosen.

use std::path::Path;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use denhart::JointKind;
use denhart_dynamic::{DynamicArm, DynamicError};
use denhart_tools::Error;
pub use denhart_tools::Units;

use crate::Failure;

/// Reads the unit of angles: `deg` or `rad`.
pub fn units() -> impl TypedValueParser<Value = Units> {
    PossibleValuesParser::new([Units::Deg, Units::Rad].map(Units::symbol))
        .map(|symbol| if symbol == Units::Rad.symbol() { Units::Rad } else { Units::Deg })
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
}
