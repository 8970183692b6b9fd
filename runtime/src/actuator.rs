//! Motors that count pulses: steppers and encoders.
//!
//! An [`Actuator`] counts `pulses = round(pulses_per_unit (value - home))`, halves away from zero. Counts are `i32`,
//! as in most controllers. A count beyond that range saturates at its end and is flagged.

use crate::flags::JointMask;
use crate::math::Scalar;
use crate::pose::Pose;
use crate::solution::Residual;

/// Pulse scale and zero position of a motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actuator<T> {
    /// Pulses per rad, or per length unit of a sliding joint; negative where the count falls as the value rises. Not 0.
    pub pulses_per_unit: T,
    /// The motor value, rad or length unit, at which the count is 0.
    pub home: T,
}

impl<T: Scalar> Actuator<T> {
    /// The count at a motor value (rad or length unit), and a flag: true for a count that is not the value's.
    ///
    /// The count is the nearest whole number of pulses from `home`, halves away from zero. Beyond `i32` it saturates
    /// at `i32::MIN` or `i32::MAX`, and a value that is not a number counts 0; the flag is set in both cases. In single
    /// precision counts beyond 2^22 are off by up to one in 2^23.
    #[inline]
    #[must_use]
    pub fn pulses(&self, value: T) -> (i32, bool) {
        let exact = (value - self.home) * self.pulses_per_unit;
        let count = half_away_from_zero(exact);
        // 2^31, which either type has exactly; a whole number below it is an `i32`.
        let end = -T::from_i32(i32::MIN);
        (count.to_i32(), !(count >= -end && count < end))
    }

    /// The motor value, rad or length unit, at a count: `home + pulses / pulses_per_unit`.
    #[inline]
    #[must_use]
    pub fn value(&self, pulses: i32) -> T {
        self.home + T::from_i32(pulses) / self.pulses_per_unit
    }
}

/// Nearest integer, halves away from zero.
#[inline]
fn half_away_from_zero<T: Scalar>(x: T) -> T {
    let magnitude = x.abs();
    let even = magnitude.round_ties_even();
    // Exact: both are within 1/2 of each other.
    let rounded = if magnitude - even == T::HALF { even + T::ONE } else { even };
    rounded.copysign(x)
}

/// The counts of all motors, and the motors whose count is saturated or whose value is not a number.
///
/// `motors`: motor values, rad or length unit, `[N]`. See [`Actuator::pulses`].
#[inline]
#[must_use]
pub fn to_pulses<T: Scalar, const N: usize>(actuators: &[Actuator<T>; N], motors: &[T; N]) -> ([i32; N], JointMask) {
    let mut counts = [0; N];
    let mut saturated = JointMask::NONE;
    for (joint, (count, (actuator, value))) in counts.iter_mut().zip(actuators.iter().zip(motors)).enumerate() {
        let (pulses, beyond) = actuator.pulses(*value);
        *count = pulses;
        if beyond {
            saturated.insert(JointMask::single(joint));
        }
    }
    (counts, saturated)
}

/// The motor values, rad or length unit, `[N]`, at the counts. See [`Actuator::value`].
#[inline]
#[must_use]
pub fn from_pulses<T: Scalar, const N: usize>(actuators: &[Actuator<T>; N], pulses: &[i32; N]) -> [T; N] {
    let mut motors = [T::ZERO; N];
    for (value, (actuator, count)) in motors.iter_mut().zip(actuators.iter().zip(pulses)) {
        *value = actuator.value(*count);
    }
    motors
}

/// Configuration of an arm whose motors stand at whole pulses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantized<T, const N: usize> {
    /// The counts next to the wanted joint values.
    pub pulses: [i32; N],
    /// The motors whose count is saturated or whose value is not a number, counted from 0.
    pub saturated: JointMask,
    /// The joint values at these counts, rad or length unit.
    pub q: [T; N],
    /// The tool's pose there, in the base frame, position in the length unit.
    pub pose: Pose<T>,
    /// How far that pose is from the wanted one: length unit and rad. Not a number where a wanted joint value is not.
    pub residual: Residual<T>,
}

impl<T: Scalar, const N: usize> Quantized<T, N> {
    /// From the counts, the joint values there, and the poses wanted and reached.
    #[inline]
    #[must_use]
    pub fn new((pulses, saturated): ([i32; N], JointMask), q: [T; N], wanted: &Pose<T>, reached: Pose<T>) -> Self {
        Self { pulses, saturated, q, pose: reached, residual: wanted.residual(&reached) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE_A_UNIT: Actuator<f64> = Actuator { pulses_per_unit: 1.0, home: 0.0 };

    #[test]
    fn halves_go_away_from_zero() {
        let counts = [
            (0.0, 0),
            (0.5, 1),
            (-0.5, -1),
            (1.5, 2),
            (2.5, 3),
            (-2.5, -3),
            (0.49999999999999994, 0),
            (-0.49999999999999994, 0),
            (2.4999999999999996, 2),
            (1e9 + 0.5, 1_000_000_001),
        ];
        for (value, count) in counts {
            assert_eq!(ONE_A_UNIT.pulses(value), (count, false), "{value}");
        }
        let single = Actuator { pulses_per_unit: -2.0_f32, home: 1.0 };
        assert_eq!(single.pulses(1.25), (-1, false));
        assert_eq!(single.pulses(0.75), (1, false));
        assert_eq!(single.value(-1), 1.5);
    }

    #[test]
    fn beyond_the_range_counts_are_marked() {
        let counts = [
            (2147483647.0, i32::MAX, false),
            (2147483647.4, i32::MAX, false),
            (2147483647.5, i32::MAX, true),
            (-2147483648.4, i32::MIN, false),
            (-2147483648.5, i32::MIN, true),
            (1e300, i32::MAX, true),
            (f64::INFINITY, i32::MAX, true),
            (f64::NEG_INFINITY, i32::MIN, true),
            (f64::NAN, 0, true),
        ];
        for (value, count, beyond) in counts {
            assert_eq!(ONE_A_UNIT.pulses(value), (count, beyond), "{value}");
        }
        let single = Actuator { pulses_per_unit: 1.0_f32, home: 0.0 };
        assert_eq!(single.pulses(2147483520.0), (2147483520, false));
        assert_eq!(single.pulses(2147483648.0), (i32::MAX, true));
        assert_eq!(single.pulses(-2147483648.0), (i32::MIN, false));
        assert_eq!(single.pulses(f32::NAN), (0, true));
    }

    #[test]
    fn all_motors_together() {
        let actuators = [ONE_A_UNIT, Actuator { pulses_per_unit: -10.0, home: 0.5 }];
        assert_eq!(to_pulses(&actuators, &[-7.2, 0.0]), ([-7, 5], JointMask::NONE));
        assert_eq!(
            to_pulses(&actuators, &[f64::NAN, -1e300]),
            ([0, i32::MAX], JointMask::single(0) | JointMask::single(1))
        );
        assert_eq!(from_pulses(&actuators, &[-7, 5]), [-7.0, 0.0]);
    }

    /// A count comes back from its value, up to the ends of the range.
    #[test]
    fn counts_come_back() {
        let actuator = Actuator { pulses_per_unit: 42962.0 / core::f64::consts::TAU, home: 1.5 };
        for count in [0, 1, -1, 42962, -10_144, 1_000_003, i32::MAX, i32::MIN] {
            assert_eq!(actuator.pulses(actuator.value(count)), (count, false));
        }
    }
}
