//! Numbers of the command line, in the units that the user has chosen.

use std::path::Path;

use clap::ValueEnum;
use denhart::{JointKind, Pose};
use denhart_dynamic::{DynamicArm, DynamicError};

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

    /// An angle in rad as a number of this unit.
    pub fn of(self, rad: f64) -> f64 {
        match self {
            Self::Deg => rad.to_degrees(),
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

impl From<DynamicError> for Failure {
    fn from(error: DynamicError) -> Self {
        match error {
            DynamicError::Joints { .. } | DynamicError::Target { .. } => Self::Usage(error.to_string()),
            DynamicError::Given(_) | DynamicError::NothingGiven => Self::Usage(error.to_string()),
            _ => Self::Other(error.to_string()),
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

/// Numbers separated by commas or spaces; `option` is where they come from, for messages.
///
/// # Errors
/// What is no number.
pub fn numbers(option: &str, text: &str) -> Result<Vec<f64>, Failure> {
    let words = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
    words
        .map(|word| match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(Failure::Usage(format!("{option}: `{word}` is not a number"))),
        })
        .collect()
}

/// A joint vector of an arm, in rad and lengths.
///
/// # Errors
/// What is no number; another number of values than joints.
pub fn joints(option: &str, text: &str, arm: &DynamicArm, units: Units) -> Result<Vec<f64>, Failure> {
    let values = numbers(option, text)?;
    let kinds = arm.joint_kinds();
    if values.len() != kinds.len() {
        let names: Vec<&str> = arm.joint_names().collect();
        let (found, names) = (values.len(), names.join(", "));
        return Err(Failure::Usage(format!("{option}: {found} values, one for each joint is needed: {names}")));
    }
    Ok(kinds.iter().zip(values).map(|(kind, value)| units.joint(*kind, value)).collect())
}

/// A pose from `x y z roll pitch yaw`.
pub fn pose([x, y, z, roll, pitch, yaw]: [f64; 6], units: Units) -> Pose<f64> {
    Pose::from_xyz_rpy([x, y, z], [roll, pitch, yaw].map(|angle| units.rad(angle)))
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
    fn numbers_are_separated_by_commas_and_spaces() {
        let read = |text: &str| numbers("--q", text).ok();
        assert_eq!(read("0, -90 ,90  1e-1"), Some(vec![0.0, -90.0, 90.0, 0.1]));
        assert_eq!(read("0, x"), None);
        assert_eq!(read("inf"), None);
    }
}
