//! Reads a field that is an angle, and notices when it is written in the wrong unit or only nearly exact.

use super::angle::{AngleUnit, WrittenAngle, pi_times};
use super::range;
use super::reader::{Field, NOTHING, Reader};
use super::suggestions;
use super::yaml::Node;
use std::f64::consts::{FRAC_PI_4, PI};

/// Role of an angle: tells how sure it is that an odd value is a mistake.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleRole {
    /// The angle between two axes. Nobody builds an arm with 1.57 degrees here.
    Twist,
    /// A joint offset or an angle of a frame.
    Offset,
    /// The end of a joint's range: any value may be meant, and exactness gains nothing.
    Limit,
    /// The position of a joint or a motor: any value may be meant here, too.
    Position,
    /// A small angle of any size.
    Tolerance,
    /// A small angle that is added to the one of a row.
    Delta,
    /// An angle in a second, or in a second squared.
    Rate,
}

/// Advice for a range that is no range.
pub const NO_LIMIT: &str = "write null for an end without a limit";

impl AngleRole {
    /// Advice for an angle that is too large or too small.
    fn advice(self) -> &'static str {
        match self {
            Self::Twist | Self::Offset => "write the angle within a turn, such as 90 deg, 1.5 rad or pi/2; 0 for none",
            Self::Limit => NO_LIMIT,
            Self::Position => "write the angle at which the joint stands, such as 90 deg; 0 for none",
            Self::Tolerance => "write a small angle, such as `angle: 1e-6 rad`",
            Self::Delta => {
                "write what is added to the angle of the row, such as 0.02 deg; whole angles belong in the row"
            }
            Self::Rate => "write the greatest rate in a second, such as 180 deg; leave it out where there is no bound",
        }
    }
}

/// Plain radians beyond two turns are degrees.
const MOST_RADIANS: f64 = 4.0 * PI;
/// How far from a multiple of pi/4 a number may be to look like one: 3.14 and 1.57 should.
const LOOKS_LIKE_RADIANS: f64 = 2e-3;
/// How far, rad, from a multiple of pi/12 an angle may be to look like one that was rounded.
const LOOKS_ROUNDED: f64 = 1e-4;
/// So many digits of an angle in rad are no chance: 1.57, 0.785.
const LEAST_DIGITS: usize = 3;

impl Reader<'_> {
    /// An angle: a number in the file's unit, or text with its own. Without a unit (it was misspelt) numbers are not
    /// judged.
    pub fn angle(&mut self, field: &Field<'_>, unit: Option<AngleUnit>, role: AngleRole) -> Option<WrittenAngle> {
        let expected = "an angle: a number, or text such as 90 deg, 1.5 rad, pi/2, -2*pi/3";
        let angle = match (field.node, field.node.number()) {
            (_, Some(value)) => {
                let angle = WrittenAngle::number(value, unit.unwrap_or(AngleUnit::Degree));
                self.within(range::ANGLE, field, angle.rad(), role.advice())?;
                if unit.is_some_and(|unit| self.wrong_unit(field, value, unit, role)) {
                    return None;
                }
                angle
            }
            (Node::Number(_), None) => {
                self.unexpected(field, "a finite angle", None);
                return None;
            }
            (Node::Text(text), None) => match WrittenAngle::parse(text) {
                Some(angle) => {
                    self.within(range::ANGLE, field, angle.rad(), role.advice())?;
                    angle
                }
                None => {
                    self.unexpected(field, expected, suggestions::angle(text));
                    return None;
                }
            },
            (Node::Null, None) => {
                self.unexpected(field, expected, Some(NOTHING.to_owned()));
                return None;
            }
            _ => {
                self.unexpected(field, expected, None);
                return None;
            }
        };
        if unit.is_some() && matches!(role, AngleRole::Twist | AngleRole::Offset) {
            self.advise_exact(field, angle, unit.unwrap_or(AngleUnit::Degree));
        }
        Some(angle)
    }

    /// Returns true if a plain number is certainly in the other unit. A number that only may be leaves a warning.
    fn wrong_unit(&mut self, field: &Field<'_>, value: f64, unit: AngleUnit, role: AngleRole) -> bool {
        if matches!(role, AngleRole::Tolerance | AngleRole::Rate) {
            return false;
        }
        let eighths = looks_like_radians(value);
        let certain = match unit {
            AngleUnit::Radian if value.abs() > MOST_RADIANS => matches!(role, AngleRole::Twist | AngleRole::Offset),
            AngleUnit::Degree if eighths.is_some() => role == AngleRole::Twist,
            _ => return false,
        };
        if !certain && !self.may_warn() {
            return false;
        }
        let (key, written) = (&field.key, self.source.written(&field.place));
        let written = written.trim_matches(['"', '\'', ' ']);
        let (message, help) = match eighths {
            Some(_) if role == AngleRole::Delta => (
                format!("`{key}`: {written} deg is added to the row, and looks like a whole angle in radians"),
                role.advice().to_owned(),
            ),
            Some(eighths) if unit == AngleUnit::Degree => (
                format!("`{key}`: {written} looks like radians, expected degrees as the file's `units` say"),
                format!("write {}, or \"{written} rad\"; if it is degrees, \"{written} deg\"", 45 * eighths),
            ),
            _ => (
                format!("`{key}`: {written} rad is more than two turns, expected radians as the file's `units` say"),
                format!("if it is degrees, write `angle: deg` in `units`, or `{written} deg` here"),
            ),
        };
        if certain {
            self.mistakes.push(self.source.mistake(&field.place, message).help(help));
        } else {
            self.warnings.push(self.source.warning(&field.place, message).help(help));
        }
        certain
    }

    /// Warns of an angle that is a multiple of pi/12 but for its rounding.
    fn advise_exact(&mut self, field: &Field<'_>, angle: WrittenAngle, unit: AngleUnit) {
        let Some(twelfths) = looks_rounded(angle).filter(|_| self.may_warn()) else { return };
        let exact = match unit {
            AngleUnit::Degree => format!("{}", 15 * twelfths),
            AngleUnit::Radian => fraction_text(twelfths),
        };
        let written = self.source.written(&field.place);
        let message = format!("`{}`: {written} is nearly {exact} and is used as written", field.key);
        let help = format!("write {exact} if that is meant: exact angles make the generated code exact and shorter");
        self.warnings.push(self.source.warning(&field.place, message).help(help));
    }
}

/// The eighths of a turn that `value` read as radians would be, if it is one of the common ones.
pub fn looks_like_radians(value: f64) -> Option<i64> {
    let eighths = (value / FRAC_PI_4).round();
    let near = (value - eighths * FRAC_PI_4).abs() < LOOKS_LIKE_RADIANS;
    // Beyond a turn a number near a multiple is chance: 355 is 113 pi.
    (near && eighths != 0.0 && eighths.abs() <= 8.0).then_some(eighths as i64)
}

/// The twelfths of pi that the angle nearly is without being it.
fn looks_rounded(angle: WrittenAngle) -> Option<i64> {
    let (value, twelfth) = match angle {
        WrittenAngle::Degrees(value) => (value, 15.0),
        WrittenAngle::Radians(value) => (value, PI / 12.0),
        WrittenAngle::PiFraction(..) => return None,
    };
    let twelfths = (value / twelfth).round();
    let (exact, near) = match angle {
        WrittenAngle::Radians(_) => (pi_times(twelfths, 12.0), LOOKS_ROUNDED),
        _ => (15.0 * twelfths, LOOKS_ROUNDED.to_degrees()),
    };
    let off = (value - exact).abs();
    let (last, digits) = last_digit(value);
    // Of few digits only those of the angle itself, rounded or cut off: 1.57 and 1.571, but not 1.58.
    let rounded = off <= 0.5 * last;
    let cut = value.abs() < exact.abs() && off <= last;
    let is_short = matches!(angle, WrittenAngle::Radians(_)) && digits >= LEAST_DIGITS && (rounded || cut);
    (value != exact && (off <= near && off <= last || is_short)).then_some(twelfths as i64)
}

/// One in the last digit of the number as it is written: what rounding or cutting it off may have changed. A value that
/// is further off was measured. Then the number of digits from the first one that is not 0.
fn last_digit(value: f64) -> (f64, usize) {
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent = exponent.parse::<i32>().unwrap_or(0) - i32::try_from(decimals).unwrap_or(0);
    // Written in binary, the difference has rounding of its own.
    (10_f64.powi(exponent) * (1.0 + 1e-9) + 4.0 * f64::EPSILON * value.abs(), decimals + 1)
}

/// `k * pi / 12` in lowest terms.
fn fraction_text(twelfths: i64) -> String {
    let divisor = [12, 6, 4, 3, 2].into_iter().find(|divisor| twelfths % divisor == 0).unwrap_or(1);
    let (numerator, denominator) = (twelfths / divisor, 12 / divisor);
    let product = match numerator {
        0 => return "0".to_owned(),
        1 => "pi".to_owned(),
        -1 => "-pi".to_owned(),
        _ => format!("{numerator}*pi"),
    };
    if denominator == 1 { product } else { format!("{product}/{denominator}") }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::approx_constant, reason = "rounded angles are what is tested")]
    use super::*;

    #[test]
    fn fractions_are_in_lowest_terms() {
        let texts = [
            (0, "0"),
            (1, "pi/12"),
            (6, "pi/2"),
            (-8, "-2*pi/3"),
            (12, "pi"),
            (-24, "-2*pi"),
            (9, "3*pi/4"),
            (10, "5*pi/6"),
        ];
        for (twelfths, text) in texts {
            assert_eq!(fraction_text(twelfths), text);
        }
    }

    #[test]
    fn rounded_angles_are_noticed_and_exact_ones_are_not() {
        assert_eq!(looks_rounded(WrittenAngle::Radians(1.5708)), Some(6));
        assert_eq!(looks_rounded(WrittenAngle::Radians(-1.570796)), Some(-6));
        assert_eq!(looks_rounded(WrittenAngle::Radians(std::f64::consts::FRAC_PI_2)), None);
        assert_eq!(looks_rounded(WrittenAngle::Radians(-std::f64::consts::PI)), None);
        // Rounded or cut to the digits that are written.
        for (radians, twelfths) in [
            (1.57, 6),
            (1.571, 6),
            (-1.57, -6),
            (0.785, 3),
            (3.14, 12),
            (3.142, 12),
            (3.141, 12),
            (0.524, 2),
            (-2.09, -8),
        ] {
            assert_eq!(looks_rounded(WrittenAngle::Radians(radians)), Some(twelfths), "{radians}");
        }
        // Digits of their own, or too few.
        for radians in [1.58, 1.572, 1.569, 1.5, 1.6, 3.1, 0.5, 1.5733, -1.5682, 0.79, 0.001, 3.15] {
            assert_eq!(looks_rounded(WrittenAngle::Radians(radians)), None, "{radians}");
        }
        assert_eq!(looks_rounded(WrittenAngle::Degrees(89.9999)), Some(6));
        assert_eq!(looks_rounded(WrittenAngle::Degrees(1e-9)), Some(0));
        // Measured: further off than rounding.
        for degrees in [0.004, 90.0021, -89.9973] {
            assert_eq!(looks_rounded(WrittenAngle::Degrees(degrees)), None, "{degrees}");
        }
        for degrees in [0.0, 15.0, 90.0, -720.0, 59.98, 55.0, 1.0, 29.43, -37.74] {
            assert_eq!(looks_rounded(WrittenAngle::Degrees(degrees)), None, "{degrees}");
        }
    }

    #[test]
    fn radians_among_degrees_are_noticed() {
        for (value, eighths) in
            [(1.5708, 2), (-1.57, -2), (3.14, 4), (0.785, 1), (6.2832, 8), (-std::f64::consts::PI, -4)]
        {
            assert_eq!(looks_like_radians(value), Some(eighths), "{value}");
        }
        for value in [0.0, 1.0, 1.5, 2.0, 90.0, 355.0, 1e-4, 3.1, 11.0, 22.0] {
            assert_eq!(looks_like_radians(value), None, "{value}");
        }
    }
}
