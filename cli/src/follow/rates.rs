//! The greatest rates of the joints: of the arm file, or of the command line.

use denhart_dynamic::DynamicArm;
use denhart_tools::follow::Rates;

use crate::Failure;
use crate::number_arguments::joint_vector;
use crate::numbers::Units;

/// Rates of the options, else of the arm file.
///
/// # Errors
/// A rate that is not above 0.
pub fn read(
    arm: &DynamicArm,
    velocity: Option<&str>,
    acceleration: Option<&str>,
    units: Units,
) -> Result<Rates, Failure> {
    let option = |option: &str, text: Option<&str>| match text {
        Some(text) => above_zero(option, arm, joint_vector(option, text, arm, units)?).map(Some),
        None => Ok(None),
    };
    let of_file = Rates::of_file(arm);
    let velocity = option("--max-velocity", velocity)?.unwrap_or(of_file.velocity);
    let acceleration = option("--max-acceleration", acceleration)?.unwrap_or(of_file.acceleration);
    Ok(Rates { velocity, acceleration })
}

/// Names the joints whose acceleration has no limit, if that of others has.
pub fn without_acceleration(arm: &DynamicArm, rates: &Rates) -> Option<String> {
    let endless = |(_, acceleration): &(_, &f64)| acceleration.is_infinite();
    let names: Vec<&str> = arm.joint_names().zip(&rates.acceleration).filter(endless).map(|(name, _)| name).collect();
    let some_have = names.len() < rates.acceleration.len();
    (some_have && !names.is_empty())
        .then(|| format!("no max_acceleration of {}: only its velocity is limited", names.join(", ")))
}

fn above_zero(option: &str, arm: &DynamicArm, values: Vec<f64>) -> Result<Vec<f64>, Failure> {
    match arm.joint_names().zip(&values).find(|(_, value)| **value <= 0.0) {
        None => Ok(values),
        Some((name, value)) => Err(Failure::Usage(format!(
            "{option}: {value} of {name} is no rate\nhelp: write one above 0 for each joint"
        ))),
    }
}
