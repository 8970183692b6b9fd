//! Motors that count pulses.

use denhart::{Actuator, JointMask, Pose, Residual};

use crate::{DynamicArm, DynamicError, Joints};

/// Configuration of an arm whose motors stand at whole pulses: [`Quantized`](denhart::Quantized) without the number of joints
/// in its type.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicQuantized {
    /// The counts next to the wanted joint values.
    pub pulses: Vec<i32>,
    /// The motors whose count is saturated or whose value is not a number, counted from 0.
    pub saturated: JointMask,
    /// The joint values at these counts, rad or length unit.
    pub q: Joints,
    /// The tool's pose there, in the base frame, position in the length unit.
    pub pose: Pose<f64>,
    /// How far that pose is from the wanted one: length unit and rad. Not a number where a wanted joint value is not.
    pub residual: Residual<f64>,
}

impl DynamicArm {
    /// Pulse scale and home position of each motor, pulses per rad or length unit.
    ///
    /// # Errors
    /// A file without `actuator`. So for all functions of pulses.
    pub fn actuators(&self) -> Result<Vec<Actuator<f64>>, DynamicError> {
        let actuators = self.model().actuators.as_ref().ok_or(DynamicError::NoActuators)?;
        let actuator =
            |of: &denhart_codegen::model::Actuator| Actuator { pulses_per_unit: of.pulses_per_unit, home: of.home };
        Ok(actuators.iter().map(actuator).collect())
    }

    /// Pulse counts of the motors at joint values, rounded to the nearest count from each home position, halves away from
    /// zero; and the motors (from 0) whose count is saturated or whose value is not a number.
    ///
    /// # Errors
    /// A file without `actuator`; a joint vector whose length is not the number of joints.
    pub fn to_pulses(&self, q: &[f64]) -> Result<(Vec<i32>, JointMask), DynamicError> {
        let (actuators, motors) = (self.actuators()?, self.to_motor(q)?);
        let mut saturated = JointMask::NONE;
        let counts = actuators.iter().zip(motors.iter()).enumerate().map(|(motor, (actuator, value))| {
            let (count, is_saturated) = actuator.pulses(*value);
            if is_saturated {
                saturated.insert(JointMask::single(motor));
            }
            count
        });
        Ok((counts.collect(), saturated))
    }

    /// Joint values at pulse counts of the motors.
    ///
    /// # Errors
    /// A file without `actuator`; another number of counts than that of joints.
    pub fn from_pulses(&self, pulses: &[i32]) -> Result<Joints, DynamicError> {
        let actuators = self.actuators()?;
        let (expected, found) = (self.joints(), pulses.len());
        if expected != found {
            return Err(DynamicError::Joints { expected, found });
        }
        let motors = actuators.iter().zip(pulses).map(|(actuator, count)| actuator.value(*count));
        self.from_motor(&Joints::new(motors))
    }

    /// The arm with `q` rounded to pulses: counts, joint values, the pose of the tool there, and how far that pose is from
    /// the one at `q`.
    ///
    /// # Errors
    /// As of [`to_pulses`](Self::to_pulses).
    pub fn quantized_error(&self, q: &[f64]) -> Result<DynamicQuantized, DynamicError> {
        let (pulses, saturated) = self.to_pulses(q)?;
        let reached = self.from_pulses(&pulses)?;
        let (wanted, pose) = (self.forward(q)?, self.forward(&reached)?);
        Ok(DynamicQuantized { pulses, saturated, q: reached, pose, residual: wanted.residual(&pose) })
    }
}
