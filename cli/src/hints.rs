//! Numbers that look like another unit than the one they are read in.

use std::f64::consts::{PI, TAU};

use denhart::{JointKind, LengthUnit};
use denhart_codegen::spec::looks_like_radians;
use denhart_dynamic::DynamicArm;

use crate::numbers::{Units, short};

/// Plain radians beyond two turns look like degrees, up to two turns of those.
const LIKE_DEGREES: std::ops::RangeInclusive<f64> = 4.0 * PI..=720.0;
/// How near, in proportion, a number with three decimals or more is to a multiple of pi/12 that looks like radians.
const NEAR: f64 = 1e-4;
/// A typed point this many times beyond the reach may be in a smaller unit.
const FAR: f64 = 3.0;
/// A point out of reach this many times nearer to the base than the arm is long may be in a larger unit.
const NEARBY: f64 = 10.0;

/// A hint where angles, in the unit that is read, look like the other one. `option` is where they were typed.
///
/// Angles of degrees look like radians if one is a multiple of 15 degrees in rad, and none is more than a turn of those.
pub fn of_angles(option: &str, angles: &[f64], units: Units) -> Option<String> {
    let place = if option.is_empty() { String::new() } else { format!("{option}: ") };
    match units {
        Units::Deg => {
            let small = angles.iter().all(|value| value.abs() <= 1.001 * TAU);
            let (value, degrees) = angles.iter().find_map(|value| Some((value, in_degrees(*value)?)))?;
            small.then(|| {
                format!("{place}{value} looks like radians and is read as degrees; write {degrees}, or add --units rad")
            })
        }
        Units::Rad => {
            let value = angles.iter().find(|value| LIKE_DEGREES.contains(&value.abs()))?;
            let radians = value.to_radians();
            Some(format!(
                "{place}{value} looks like degrees and is read as radians; write {radians}, or leave --units rad out"
            ))
        }
    }
}

/// The degrees that a number would be if it is in rad, where it looks so.
fn in_degrees(value: f64) -> Option<i64> {
    if let Some(eighths) = looks_like_radians(value) {
        return Some(45 * eighths);
    }
    let twelfths = (value / (PI / 12.0)).round();
    let exact = twelfths * (PI / 12.0);
    let rounded = (value * 100.0).round() / 100.0 == value;
    let near = twelfths != 0.0 && twelfths.abs() <= 24.0 && (value - exact).abs() <= NEAR * exact.abs();
    (near && !rounded).then(|| 15 * twelfths as i64)
}

/// A hint as of [`of_angles`] for joint values in rad and lengths: those of turning joints count.
pub fn of_joints(option: &str, arm: &DynamicArm, q: &[f64], units: Units) -> Option<String> {
    let turning = arm.joint_kinds().iter().zip(q).filter(|(kind, _)| **kind == JointKind::Revolute);
    let angles: Vec<f64> = turning.map(|(_, value)| units.of(*value)).collect();
    of_angles(option, &angles, units)
}

/// A hint for a point out of reach that would be within reach in another unit of length. `reach` is the length of all
/// links together.
pub fn of_point(point: &[f64], own: LengthUnit, reach: f64) -> Option<String> {
    let distance = point.iter().fold(0.0, |length: f64, value| length.hypot(*value));
    if !(distance > FAR * reach || (distance > 0.0 && distance < reach / NEARBY)) {
        return None;
    }
    let all = [LengthUnit::Millimeter, LengthUnit::Meter, LengthUnit::Centimeter, LengthUnit::Inch];
    let unit = all.into_iter().find(|unit| {
        let factor = unit.in_meters() / own.in_meters();
        let far = factor < 1.0 && distance > FAR * reach;
        let near = factor >= NEARBY && distance < reach / NEARBY;
        (far || near) && (0.05..=1.05).contains(&(distance * factor / reach))
    })?;
    let list = |factor: f64| point.iter().map(|value| short(value * factor)).collect::<Vec<_>>().join(", ");
    let converted = list(unit.in_meters() / own.in_meters());
    Some(format!(
        "the point is read in {own}, the unit of the file, and the arm is {} {own} long; if it is in {unit}, write {converted}",
        short((reach * 1000.0).round() / 1000.0)
    ))
}

#[cfg(test)]
mod tests {
    // Angles with the digits that people type.
    #![allow(clippy::approx_constant)]

    use super::*;

    #[test]
    fn radians_typed_as_degrees_are_noticed_and_small_degrees_are_not() {
        for (angles, degrees) in [
            (&[1.5708, 0.0, 0.0][..], "write 90,"),
            (&[0.0, -3.14159, 0.2], "write -180,"),
            (&[0.0, 0.5236], "write 30,"),
            (&[1.57], "write 90,"),
            (&[2.6179938779914944], "write 150,"),
        ] {
            let hint = of_angles("--pose", angles, Units::Deg);
            assert!(hint.as_ref().is_some_and(|hint| hint.contains(degrees)), "{angles:?}: {hint:?}");
        }
        for angles in [
            &[0.0, 0.0, 0.0][..],
            &[1.0, 0.5, -2.0],
            &[0.26, 0.52, 1.05],
            &[2.88, 5.76],
            &[1.5708, 90.0, 0.0],
            &[1.6, 3.1, 6.3, 0.1],
            &[180.0, 0.0, 15.0],
            &[1e308, -1e300, f64::MAX],
        ] {
            assert_eq!(of_angles("--pose", angles, Units::Deg), None, "{angles:?}");
        }
    }

    #[test]
    fn degrees_typed_as_radians_are_noticed() {
        let hint = of_angles("--q", &[0.0, -90.0], Units::Rad);
        assert!(hint.is_some_and(|hint| hint.contains("-90 looks like degrees") && hint.contains("-1.570796")));
        for angles in [&[3.2, -6.4][..], &[12.5], &[1e6]] {
            assert_eq!(of_angles("--q", angles, Units::Rad), None, "{angles:?}");
        }
    }

    #[test]
    fn a_point_in_another_unit_of_length_is_noticed() {
        use LengthUnit::{Centimeter, Meter, Millimeter};
        for (point, own, reach, found) in [
            ([300.0, 50.0, 200.0], Meter, 0.9, "if it is in mm, write 0.3, 0.05, 0.2"),
            ([0.3, 0.05, 0.2], Millimeter, 900.0, "if it is in m, write 300, 50, 200"),
            ([30.0, 5.0, 20.0], Meter, 0.9, "if it is in cm, write 0.3, 0.05, 0.2"),
            ([300.0, 50.0, 200.0], Centimeter, 20.0, "nothing"),
            ([300.0, 50.0, 200.0], Centimeter, 36.0, "if it is in mm, write 30, 5, 20"),
            ([180.0, 50.0, 100.0], Centimeter, 36.5, "if it is in mm, write 18, 5, 10"),
            ([2.0, 0.0, 0.0], Meter, 0.9, "nothing"),
            ([0.0, 0.0, 0.0], Meter, 0.9, "nothing"),
            ([1e9, 0.0, 0.0], Meter, 0.9, "nothing"),
            ([0.05, 0.0, 0.0], Meter, 0.9, "nothing"),
        ] {
            let hint = of_point(&point, own, reach).unwrap_or_else(|| "nothing".to_owned());
            assert!(hint.ends_with(found), "{point:?} {own}: {hint}");
        }
    }
}
