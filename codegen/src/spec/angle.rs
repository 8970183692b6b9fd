//! Angles as people write them: `90`, `pi/2`, `-2*pi/3`, `3pi/4`, `90 deg`, `1.5 rad`.

use std::f64::consts::PI;

/// The unit of plain numbers that are angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleUnit {
    /// `deg`
    Degree,
    /// `rad`
    Radian,
}

/// An angle exactly as it was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WrittenAngle {
    /// A number of degrees.
    Degrees(f64),
    /// A number of radians.
    Radians(f64),
    /// `numerator * pi / denominator`, the denominator positive.
    PiFraction(i64, i64),
}

impl WrittenAngle {
    /// No rotation.
    pub const ZERO: Self = Self::Degrees(0.0);

    /// A plain number in the file's unit.
    pub fn number(value: f64, unit: AngleUnit) -> Self {
        match unit {
            AngleUnit::Degree => Self::Degrees(value),
            AngleUnit::Radian => Self::Radians(value),
        }
    }

    /// The value in radians.
    pub fn rad(self) -> f64 {
        match self {
            Self::Degrees(value) => value.to_radians(),
            Self::Radians(value) => value,
            Self::PiFraction(numerator, denominator) => pi_times(numerator as f64, denominator as f64),
        }
    }

    /// Its text in a file whose plain numbers have this unit.
    pub fn text(self, unit: AngleUnit) -> String {
        match (self, unit) {
            (Self::Degrees(value), AngleUnit::Degree) | (Self::Radians(value), AngleUnit::Radian) => value.to_string(),
            (Self::Degrees(0.0), AngleUnit::Radian) => "0".to_owned(),
            (Self::Degrees(value), AngleUnit::Radian) => format!("{value} deg"),
            (Self::Radians(value), AngleUnit::Degree) => format!("{value} rad"),
            (Self::PiFraction(numerator, 1), _) => format!("{numerator}*pi"),
            (Self::PiFraction(numerator, denominator), _) => format!("{numerator}*pi/{denominator}"),
        }
    }

    /// Reads text with a unit or with `pi`. `None` for anything else, a number without a unit too.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim().to_lowercase();
        for (suffix, unit) in SUFFIXES {
            let Some(value) = text.strip_suffix(suffix).map(str::trim_end) else { continue };
            return match (decimal(value), unit) {
                (Some(value), unit) => Some(Self::number(value, *unit)),
                (None, AngleUnit::Radian) => pi_product(value),
                (None, AngleUnit::Degree) => None,
            };
        }
        pi_product(&text)
    }
}

/// The longer spelling first: `rad` is no end of `radians`.
const SUFFIXES: &[(&str, AngleUnit)] = &[
    ("degrees", AngleUnit::Degree),
    ("degree", AngleUnit::Degree),
    ("deg", AngleUnit::Degree),
    ("°", AngleUnit::Degree),
    ("radians", AngleUnit::Radian),
    ("radian", AngleUnit::Radian),
    ("rad", AngleUnit::Radian),
];

/// A decimal number and nothing else: `f64::from_str` would also take `inf`.
pub(super) fn decimal(text: &str) -> Option<f64> {
    let digits = text.chars().any(|c| c.is_ascii_digit());
    let plain = text.chars().all(|c| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e'));
    text.parse().ok().filter(|value: &f64| digits && plain && value.is_finite())
}

/// `[sign] factor (('*' | '/') factor)*` with `pi` exactly once and not below a fraction bar; `3pi` is `3*pi`.
fn pi_product(text: &str) -> Option<WrittenAngle> {
    let text = text.replace('π', "pi").replace(char::is_whitespace, "");
    let (negative, unsigned) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(&text)),
    };
    // The sign of multiplication before `pi` may be left out; from here on it is there.
    let product = unsigned.replace("*pi", "pi").replace("pi", "*pi");
    let (mut numerator, mut denominator, mut pi) = (1.0, 1.0, 0);
    for factors in product.strip_prefix('*').unwrap_or(&product).split('*') {
        let (factor, divisors) = factors.split_once('/').map_or((factors, None), |(first, rest)| (first, Some(rest)));
        if factor == "pi" {
            pi += 1;
        } else {
            numerator *= decimal(factor)?;
        }
        for divisor in divisors.into_iter().flat_map(|divisors| divisors.split('/')) {
            denominator *= decimal(divisor)?;
        }
    }
    if pi != 1 || denominator == 0.0 {
        return None;
    }
    let sign = if negative != (denominator < 0.0) { -1.0 } else { 1.0 };
    let (numerator, denominator) = (sign * numerator, denominator.abs());
    let whole = |value: f64| (value.fract() == 0.0 && value.abs() < 1e15).then_some(value as i64);
    match (whole(numerator), whole(denominator)) {
        (Some(numerator), Some(denominator)) => Some(WrittenAngle::PiFraction(numerator, denominator)),
        _ => Some(WrittenAngle::Degrees(180.0 * numerator / denominator))
            .filter(|_| (numerator / denominator).is_finite()),
    }
}

/// `pi * numerator / denominator`, correctly rounded for the small whole numbers that exact angles are made of.
///
/// Double-double arithmetic after Dekker (1971): products split by a fused multiply-add, `pi` to 106 bits.
pub fn pi_times(numerator: f64, denominator: f64) -> f64 {
    /// Pi less its nearest double.
    const PI_TAIL: f64 = 1.224_646_799_147_353_2e-16;
    let product = numerator * PI;
    let tail = numerator.mul_add(PI, -product) + numerator * PI_TAIL;
    let quotient = product / denominator;
    let remainder = (-quotient).mul_add(denominator, product) + tail;
    quotient + remainder / denominator
}

/// `010` as `10`, `-007` as `-7`; none of a text that is no number, or has no zero in front of another digit.
pub fn without_leading_zeros(text: &str) -> Option<String> {
    let text = text.trim();
    let (sign, digits) = text.split_at(usize::from(text.starts_with(['-', '+'])));
    let zeros = digits.bytes().zip(digits.bytes().skip(1)).take_while(|(c, next)| *c == b'0' && next.is_ascii_digit());
    let plain = digits.get(zeros.count()..)?;
    (plain.len() < digits.len() && text.parse::<f64>().is_ok()).then(|| format!("{sign}{plain}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, FRAC_PI_8, TAU};

    #[test]
    fn reads_fractions_of_pi() {
        for (text, numerator, denominator) in [
            ("pi", 1, 1),
            ("-pi", -1, 1),
            ("+pi/2", 1, 2),
            ("- pi / 3", -1, 3),
            ("2*pi/3", 2, 3),
            ("-2 * pi / 3", -2, 3),
            ("3pi/4", 3, 4),
            ("pi*3/4", 3, 4),
            ("1/2*pi", 1, 2),
            ("pi/2/3", 1, 6),
            ("pi/-2", -1, 2),
            ("π/2", 1, 2),
            ("Pi/2", 1, 2),
            ("pi/2 rad", 1, 2),
        ] {
            assert_eq!(WrittenAngle::parse(text), Some(WrittenAngle::PiFraction(numerator, denominator)), "{text}");
        }
        assert_eq!(WrittenAngle::parse("0.5*pi"), Some(WrittenAngle::Degrees(90.0)));
    }

    #[test]
    fn reads_units() {
        assert_eq!(WrittenAngle::parse("90 deg"), Some(WrittenAngle::Degrees(90.0)));
        assert_eq!(WrittenAngle::parse("-37.74°"), Some(WrittenAngle::Degrees(-37.74)));
        assert_eq!(WrittenAngle::parse("1.5 rad"), Some(WrittenAngle::Radians(1.5)));
        assert_eq!(WrittenAngle::parse("1e-3 radians"), Some(WrittenAngle::Radians(1e-3)));
    }

    #[test]
    fn refuses_the_rest() {
        for text in [
            "", "90", "pi/0", "2/pi", "pi*pi", "pi/2 deg", "deg", "inf rad", "nan deg", "2*/pi", "pipi", "q", "pi+1",
            "1..2 deg",
        ] {
            assert_eq!(WrittenAngle::parse(text), None, "{text}");
        }
    }

    #[test]
    fn fractions_of_pi_are_correctly_rounded() {
        for (k, expected) in
            [(24.0, TAU), (12.0, PI), (6.0, FRAC_PI_2), (4.0, FRAC_PI_3), (3.0, FRAC_PI_4), (2.0, FRAC_PI_6)]
        {
            assert_eq!(pi_times(k, 12.0).to_bits(), expected.to_bits(), "{k}");
            assert_eq!(pi_times(-k * 15.0, 180.0).to_bits(), (-expected).to_bits(), "{k}");
        }
        assert_eq!(pi_times(1.0, 8.0).to_bits(), FRAC_PI_8.to_bits());
        // pi/12, 5 pi/12 and 7 pi/12 to 20 digits.
        assert_eq!(pi_times(1.0, 12.0), 0.261_799_387_799_149_46);
        assert_eq!(pi_times(5.0, 12.0), 1.308_996_938_995_747_2);
        assert_eq!(pi_times(7.0, 12.0), 1.832_595_714_594_046_1);
        assert_eq!(pi_times(0.0, 12.0), 0.0);
    }
}
