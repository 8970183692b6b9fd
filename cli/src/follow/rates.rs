//! The greatest rates of the joints: of the arm file, or of the command line.

use denhart::follow;
use denhart_dynamic::DynamicArm;

use crate::Failure;
use crate::number_arguments::joint_vector;
use crate::numbers::Units;

/// Greatest velocities and accelerations, rad or length unit per s and s^2; accelerations may be infinite.
pub struct Rates {
    pub velocity: Vec<f64>,
    pub acceleration: Vec<f64>,
}

impl Rates {
    /// The rates of an arm with so many joints.
    pub fn of<const N: usize>(&self) -> follow::Rates<f64, N> {
        let mut rates = follow::Rates::velocity([f64::INFINITY; N]);
        for (place, value) in rates.velocity.iter_mut().zip(&self.velocity) {
            *place = *value;
        }
        for (place, value) in rates.acceleration.iter_mut().zip(&self.acceleration) {
            *place = *value;
        }
        rates
    }

    /// Rates of the options, else of the arm file.
    ///
    /// # Errors
    /// A joint without velocity; a rate that is not above 0.
    pub fn read(
        arm: &DynamicArm,
        velocity: Option<&str>,
        acceleration: Option<&str>,
        units: Units,
    ) -> Result<Self, Failure> {
        let option = |option: &str, text: Option<&str>| match text {
            Some(text) => above_zero(option, arm, joint_vector(option, text, arm, units)?).map(Some),
            None => Ok(None),
        };
        let velocity = option("--max-velocity", velocity)?.unwrap_or_else(|| arm.max_velocity().collect());
        let acceleration =
            option("--max-acceleration", acceleration)?.unwrap_or_else(|| arm.max_acceleration().collect());
        let lacking = arm.joint_names().zip(&velocity).filter(|(_, velocity)| !velocity.is_finite());
        let lacking: Vec<&str> = lacking.map(|(name, _)| name).collect();
        if lacking.is_empty() {
            return Ok(Self { velocity, acceleration });
        }
        let names = lacking.join(", ");
        Err(Failure::Usage(format!(
            "the arm file has no velocity of {names}\n\
             help: write max_velocity in the rows of the file, or --max-velocity with a value per s for each joint"
        )))
    }
}

fn above_zero(option: &str, arm: &DynamicArm, values: Vec<f64>) -> Result<Vec<f64>, Failure> {
    match arm.joint_names().zip(&values).find(|(_, value)| **value <= 0.0) {
        None => Ok(values),
        Some((name, value)) => Err(Failure::Usage(format!(
            "{option}: {value} of {name} is no rate\nhelp: write one above 0 for each joint"
        ))),
    }
}
