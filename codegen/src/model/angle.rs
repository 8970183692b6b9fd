//! Angles that are exact where people mean exact.
//!
//! A multiple of 15 degrees is held as a whole number of twelfths of pi. Its sine and cosine are known in closed form:
//! 0, 1/2, 1/sqrt 2, sqrt 3/2, 1, and (sqrt 6 -+ sqrt 2)/4. So parallel axes are exactly parallel.

use crate::spec::{WrittenAngle, pi_times};
use std::f64::consts::FRAC_1_SQRT_2;
use std::hash::{Hash, Hasher};

/// A constant angle.
#[derive(Debug, Clone, Copy)]
pub struct Angle(Form);

#[derive(Debug, Clone, Copy)]
enum Form {
    /// Multiples of pi/12.
    Twelfths(i64),
    /// Degrees that are no multiple of 15.
    Degrees(f64),
    /// Radians that are no correctly rounded multiple of pi/12.
    Radians(f64),
}

/// Sine of 0, 15, .. 90 degrees, each correctly rounded.
const SINES: [f64; 7] =
    [0.0, 0.258_819_045_102_520_74, 0.5, FRAC_1_SQRT_2, 0.866_025_403_784_438_6, 0.965_925_826_289_068_3, 1.0];

impl Angle {
    /// No rotation.
    pub const ZERO: Self = Self(Form::Twelfths(0));

    /// An angle in degrees, exact when it is a multiple of 15.
    pub fn degrees(value: f64) -> Self {
        let twelfths = value / 15.0;
        let whole = value % 15.0 == 0.0 && twelfths.abs() < 1e15;
        Self(if whole { Form::Twelfths(twelfths as i64) } else { Form::Degrees(value) })
    }

    /// An angle in radians, exact when it is a multiple of pi/12 to the last bit.
    pub fn radians(value: f64) -> Self {
        let twelfths = (value / (std::f64::consts::PI / 12.0)).round();
        // Beyond a few turns neighboring multiples and neighboring doubles have nothing to do with each other.
        let exact = twelfths.abs() < 1e3 && pi_times(twelfths, 12.0) == value;
        Self(if exact { Form::Twelfths(twelfths as i64) } else { Form::Radians(value) })
    }

    /// The angle of a plane vector, exact where it is a multiple of a quarter turn.
    pub fn of_vector(y: f64, x: f64) -> Self {
        let angle = y.atan2(x);
        let quarters = (angle / std::f64::consts::FRAC_PI_2).round();
        if (angle - quarters * std::f64::consts::FRAC_PI_2).abs() <= 1e-14 {
            Angle::degrees(90.0 * quarters)
        } else {
            Angle::radians(angle)
        }
    }

    /// `numerator * pi / denominator`, exact when that is a multiple of pi/12. The denominator is not zero.
    pub fn pi_fraction(numerator: i64, denominator: i64) -> Self {
        let twelfths = i128::from(numerator) * 12;
        let divides = denominator != 0 && twelfths % i128::from(denominator) == 0;
        match i64::try_from(twelfths.checked_div(i128::from(denominator)).unwrap_or_default()) {
            Ok(twelfths) if divides => Self(Form::Twelfths(twelfths)),
            _ => Self::radians(pi_times(numerator as f64, denominator as f64)),
        }
    }

    /// The value in radians, correctly rounded for exact angles.
    pub fn rad(&self) -> f64 {
        match self.0 {
            Form::Twelfths(twelfths) => pi_times(twelfths as f64, 12.0),
            Form::Degrees(value) => pi_times(value, 180.0),
            Form::Radians(value) => value,
        }
    }

    /// Returns true if the angle is exactly zero; a whole turn is not.
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Form::Twelfths(0))
    }

    /// The angle in twelfths of pi if it is exact, not reduced to one turn.
    pub fn exact_twelfths(&self) -> Option<i64> {
        if let Form::Twelfths(twelfths) = self.0 { Some(twelfths) } else { None }
    }

    /// 0, 1, 2 or 3 quarter turns if the angle is a multiple of 90 degrees, whole turns left out.
    pub fn quarter_turns(&self) -> Option<i64> {
        self.exact_twelfths().filter(|twelfths| twelfths % 6 == 0).map(|twelfths| (twelfths / 6).rem_euclid(4))
    }

    /// The sine; exactly 0, +-0.5 and +-1 where it is, correctly rounded for all exact angles.
    pub fn sin(&self) -> f64 {
        match self.0 {
            Form::Twelfths(twelfths) => sine(twelfths),
            Form::Degrees(value) => sin_cos_degrees(value).0,
            Form::Radians(value) => value.sin(),
        }
    }

    /// The cosine; exactly 0, +-0.5 and +-1 where it is, correctly rounded for all exact angles.
    pub fn cos(&self) -> f64 {
        match self.0 {
            // The sine of a quarter turn more; reduced first, so that nothing overflows.
            Form::Twelfths(twelfths) => sine(twelfths % 24 + 6),
            Form::Degrees(value) => sin_cos_degrees(value).1,
            Form::Radians(value) => value.cos(),
        }
    }

    /// The sum, exact if both are; degrees stay degrees, anything else becomes radians.
    #[allow(clippy::should_implement_trait, reason = "`+` would read as a sum of numbers")]
    pub fn add(self, other: Self) -> Self {
        match (self.0, other.0) {
            (Form::Twelfths(0), _) => other,
            (_, Form::Twelfths(0)) => self,
            (Form::Twelfths(a), Form::Twelfths(b)) => Self(Form::Twelfths(a.saturating_add(b))),
            (Form::Degrees(a), Form::Degrees(b)) => Self::degrees(a + b),
            (Form::Twelfths(a), Form::Degrees(b)) | (Form::Degrees(b), Form::Twelfths(a)) => {
                Self::degrees(a as f64 * 15.0 + b)
            }
            _ => Self::radians(self.rad() + other.rad()),
        }
    }

    /// The angle the other way round.
    #[allow(clippy::should_implement_trait, reason = "goes with `add`")]
    pub fn neg(self) -> Self {
        Self(match self.0 {
            Form::Twelfths(twelfths) => Form::Twelfths(twelfths.saturating_neg()),
            Form::Degrees(value) => Form::Degrees(-value),
            Form::Radians(value) => Form::Radians(-value),
        })
    }

    /// The angle for documentation: `90 deg`, `-37.74 deg`, `1.5 rad`.
    pub fn text(&self) -> String {
        match self.0 {
            Form::Twelfths(twelfths) => format!("{} deg", i128::from(twelfths) * 15),
            Form::Degrees(value) => format!("{value} deg"),
            Form::Radians(value) => format!("{value} rad"),
        }
    }

    /// Key by which two angles are equal: the form and the bits of the value.
    fn key(&self) -> (u8, u64) {
        match self.0 {
            Form::Twelfths(twelfths) => (0, twelfths as u64),
            Form::Degrees(value) => (1, value.to_bits()),
            Form::Radians(value) => (2, value.to_bits()),
        }
    }
}

impl From<WrittenAngle> for Angle {
    fn from(written: WrittenAngle) -> Self {
        match written {
            WrittenAngle::Degrees(value) => Self::degrees(value),
            WrittenAngle::Radians(value) => Self::radians(value),
            WrittenAngle::PiFraction(numerator, denominator) => Self::pi_fraction(numerator, denominator),
        }
    }
}

impl PartialEq for Angle {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Angle {}

impl Hash for Angle {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

/// Sine of a multiple of pi/12.
fn sine(twelfths: i64) -> f64 {
    let in_turn = twelfths.rem_euclid(24);
    let (half, negative) = if in_turn >= 12 { (in_turn - 12, true) } else { (in_turn, false) };
    let quarter = half.min(12 - half);
    let value = usize::try_from(quarter).ok().and_then(|index| SINES.get(index)).copied().unwrap_or(f64::NAN);
    // Plus zero for 180 degrees: a signed zero would only show up in the generated code.
    if negative && quarter != 0 { -value } else { value }
}

/// Sine and cosine of degrees, reduced to +-45 degrees before the factor pi/180 brings in any rounding.
fn sin_cos_degrees(value: f64) -> (f64, f64) {
    let in_turn = value % 360.0;
    let quarters = (in_turn / 90.0).round();
    let (sin, cos) = pi_times(in_turn - 90.0 * quarters, 180.0).sin_cos();
    match (quarters as i64).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::approx_constant, reason = "rounded angles are what is tested")]
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI};

    #[test]
    fn common_angles_are_exact_however_they_are_written() {
        let right = Angle::degrees(90.0);
        assert_eq!(right.exact_twelfths(), Some(6));
        assert_eq!(right, Angle::pi_fraction(1, 2));
        assert_eq!(right, Angle::radians(FRAC_PI_2));
        assert_ne!(right, Angle::radians(1.5708));
        assert_eq!(Angle::degrees(-0.0), Angle::ZERO);
        assert_eq!(Angle::radians(0.0), Angle::ZERO);
        assert_eq!(Angle::pi_fraction(-2, 3), Angle::degrees(-120.0));
        assert_eq!(Angle::pi_fraction(3, -4), Angle::degrees(-135.0));
        assert_eq!(Angle::radians(1e-9).exact_twelfths(), None);
        assert_eq!(Angle::degrees(7.5).exact_twelfths(), None);
    }

    #[test]
    fn radians_are_correctly_rounded() {
        for (degrees, rad) in
            [(180.0, PI), (90.0, FRAC_PI_2), (60.0, FRAC_PI_3), (45.0, FRAC_PI_4), (-30.0, -FRAC_PI_6)]
        {
            assert_eq!(Angle::degrees(degrees).rad().to_bits(), f64::to_bits(rad), "{degrees}");
        }
        assert_eq!(Angle::radians(1.5708).rad(), 1.5708);
        assert_eq!(Angle::pi_fraction(1, 5).rad(), 0.628_318_530_717_958_6);
        assert!((Angle::degrees(-37.74).rad() - (-37.74_f64).to_radians()).abs() < 2e-16);
    }

    #[test]
    fn sines_and_cosines_of_exact_angles_are_exact() {
        let (s, h) = (FRAC_1_SQRT_2, 0.5);
        for (degrees, sin, cos) in [
            (0.0, 0.0, 1.0),
            (45.0, s, s),
            (90.0, 1.0, 0.0),
            (150.0, h, -SINES[4]),
            (180.0, 0.0, -1.0),
            (-60.0, -SINES[4], h),
            (-90.0, -1.0, 0.0),
            (270.0, -1.0, 0.0),
            (75.0, SINES[5], SINES[1]),
            (-360.0, 0.0, 1.0),
            (-315.0, s, s),
        ] {
            let angle = Angle::degrees(degrees);
            assert_eq!((angle.sin(), angle.cos()), (sin, cos), "{degrees}");
            assert!(angle.sin() != 0.0 || angle.sin().is_sign_positive(), "{degrees}");
        }
        for twelfths in -30..30 {
            let angle = Angle(Form::Twelfths(twelfths));
            assert!((angle.sin() - angle.rad().sin()).abs() < 1e-15 && (angle.cos() - angle.rad().cos()).abs() < 1e-15);
        }
        // Their squares are 1/2 -+ sqrt(3)/4.
        assert!((SINES[1] * SINES[1] + SINES[5] * SINES[5] - 1.0).abs() < 2e-16);
    }

    #[test]
    fn degrees_are_reduced_before_they_are_rounded() {
        for degrees in [-37.74, 59.98, 179.99, 200.5, 300.25, -271.0, 1e-3] {
            let angle = Angle::degrees(degrees);
            let turned = Angle::degrees(degrees + 360.0);
            assert!((angle.sin() - degrees.to_radians().sin()).abs() < 1e-15, "{degrees}");
            assert!((angle.cos() - degrees.to_radians().cos()).abs() < 1e-15, "{degrees}");
            assert!((angle.sin() - turned.sin()).abs() < 1e-15, "{degrees}");
        }
        // A million turns more cost nothing: 360e6 + 0.5 is exact in a double.
        assert_eq!(Angle::degrees(360e6 + 0.5).sin(), Angle::degrees(0.5).sin());
    }

    #[test]
    fn sums_stay_exact() {
        let sum = |a: f64, b: f64| Angle::degrees(a).add(Angle::degrees(b));
        assert_eq!(sum(90.0, -90.0), Angle::ZERO);
        assert_eq!(sum(-79.349_949_087_697_35, 79.349_949_087_697_35), Angle::ZERO);
        assert_eq!(sum(89.5, 90.0), Angle::degrees(179.5));
        assert_eq!(Angle::radians(0.1).add(Angle::ZERO), Angle::radians(0.1));
        assert_eq!(Angle::radians(0.1).add(Angle::degrees(180.0)).rad(), 0.1 + PI);
        assert_eq!(Angle::degrees(90.0).neg(), Angle::degrees(-90.0));
        assert_eq!(Angle::degrees(1.0).neg().add(Angle::degrees(1.0)), Angle::ZERO);
    }

    #[test]
    fn quarter_turns_leave_whole_turns_out() {
        let turns = |degrees| Angle::degrees(degrees).quarter_turns();
        assert_eq!([turns(0.0), turns(90.0), turns(-90.0), turns(450.0)], [Some(0), Some(1), Some(3), Some(1)]);
        assert_eq!([turns(45.0), turns(89.0)], [None, None]);
        assert!(Angle::degrees(360.0).quarter_turns() == Some(0) && !Angle::degrees(360.0).is_zero());
    }

    #[test]
    fn texts_are_in_the_written_unit() {
        let texts = [Angle::pi_fraction(1, 2).text(), Angle::degrees(-37.74).text(), Angle::radians(1.5).text()];
        assert_eq!(texts, ["90 deg", "-37.74 deg", "1.5 rad"]);
    }
}
