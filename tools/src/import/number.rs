//! Numbers of the arm file: as short as they may be.

use std::f64::consts::PI;

use super::rigid::exact_degrees;
use super::table::Table;

/// The shortest decimal within `tolerance` of the value.
pub fn shortest(value: f64, tolerance: f64) -> String {
    if value.abs() <= tolerance {
        return "0".to_owned();
    }
    let rounded = (0..17)
        .map(|digits| format!("{value:.digits$}"))
        .find(|text| text.parse().is_ok_and(|near: f64| (near - value).abs() <= tolerance && near != 0.0));
    rounded.unwrap_or_else(|| format!("{value:e}"))
}

/// An angle within `tolerance` rad of the value: in degrees, the file's unit, or in rad where these have fewer digits.
pub fn angle(value: f64, tolerance: f64) -> String {
    if let Some(degrees) = exact_degrees(value, tolerance) {
        return format!("{}", degrees + 0.0);
    }
    let degrees = shortest(value * 180.0 / PI, tolerance * 180.0 / PI);
    let rad = shortest(value, tolerance);
    if rad.len() < degrees.len() { format!("{rad} rad") } else { degrees }
}

/// Micrometers: the decimals of a length that was typed by hand.
const DECIMALS: i32 = 6;

/// The table with its lengths rounded to a micrometer where that changes them by at most `within`; the sizes of the
/// changes. What is below [`TOLD`] of the arm's size is the rounding of arithmetic, and no change.
pub fn short_lengths(table: &Table, within: f64) -> (Table, Vec<f64>) {
    let mut table = table.clone();
    let mut changes = Vec::new();
    let size = table.size;
    let mut round = |value: &mut f64| {
        let unit = 10_f64.powi(DECIMALS);
        let to = (*value * unit).round() / unit;
        let change = (to - *value).abs();
        if change <= within {
            changes.extend((change > TOLD * size).then_some(change));
            *value = to;
        }
    };
    for row in &mut table.rows {
        round(&mut row.a);
        round(&mut row.d);
    }
    table.base.p.iter_mut().chain(&mut table.tool.p).for_each(round);
    (table, changes)
}

/// A change below this, relative to the arm's size, is not told.
const TOLD: f64 = 1e-12;

#[cfg(test)]
mod tests {
    #![allow(clippy::approx_constant, reason = "rounded angles are what is tested")]
    use super::{angle, shortest};

    #[test]
    fn rounding_is_left_out_and_digits_are_not() {
        assert_eq!(shortest(0.425_000_000_000_000_04, 1e-13), "0.425");
        assert_eq!(shortest(-0.39225, 1e-13), "-0.39225");
        assert_eq!(shortest(3e-15, 1e-13), "0");
        assert_eq!(shortest(120.0, 1e-13), "120");
        assert_eq!(shortest(1.0 / 3.0, 1e-13), "0.3333333333333");
        assert_eq!(shortest(3.67e-6, 1e-13), "0.00000367");
    }

    #[test]
    fn angles_are_degrees_unless_rad_are_shorter() {
        assert_eq!(angle(std::f64::consts::FRAC_PI_2, 1e-13), "90");
        assert_eq!(angle(1.5708, 1e-13), "1.5708 rad");
        assert_eq!(angle(2.967_059_728_390_36, 1e-13), "170");
        assert_eq!(angle(0.5_f64.to_radians(), 1e-13), "0.5");
        assert_eq!(angle(-1.570_796_326_79, 1e-13), "-1.57079632679 rad");
    }
}
