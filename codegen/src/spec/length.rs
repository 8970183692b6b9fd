//! Lengths: a number, or a parameter with a sign or a numeric factor.

use super::range;
use std::collections::HashMap;

/// A length in the file's unit, as the file has it.
#[derive(Debug, Clone, PartialEq)]
pub enum Length {
    /// A number.
    Constant(f64),
    /// `factor * parameter`
    Multiple {
        /// Not zero.
        factor: f64,
        /// The parameter's name.
        parameter: String,
        /// The length with the parameter at its default.
        default: f64,
    },
}

impl Length {
    /// Nothing.
    pub const ZERO: Length = Length::Constant(0.0);

    /// Returns true if the length is zero whatever the parameters are.
    pub fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }

    /// The length with all parameters at their defaults.
    pub fn default_value(&self) -> f64 {
        match self {
            Length::Constant(value) => *value,
            Length::Multiple { default, .. } => *default,
        }
    }

    /// The length with parameters at the given values, at their defaults where none is given.
    pub fn at(&self, values: &HashMap<String, f64>) -> f64 {
        match self {
            Length::Constant(value) => *value,
            Length::Multiple { factor, parameter, default } => values.get(parameter).map_or(*default, |v| factor * v),
        }
    }

    /// The parameter it depends on.
    pub fn parameter(&self) -> Option<&str> {
        match self {
            Length::Constant(_) => None,
            Length::Multiple { parameter, .. } => Some(parameter),
        }
    }
}

/// A factor and a name, or why a text is neither.
pub(super) type Factored<'t> = Result<(f64, &'t str), &'static str>;

/// Reads `l2`, `-l2`, `2*l2`, `l2 / 2`, `-3 * l2 / 4`: one name, numbers that multiply or divide it, a sign.
pub(super) fn factored(text: &str) -> Factored<'_> {
    const FORM: &str = "one parameter with a sign or a numeric factor, such as `-l2`, `2*l2` or `l2/2`";
    let (mut factor, mut name) = (1.0, None);
    let mut rest = text.trim();
    if let Some(positive) = rest.strip_prefix('-') {
        (factor, rest) = (-1.0, positive.trim_start());
    } else if let Some(positive) = rest.strip_prefix('+') {
        rest = positive.trim_start();
    }
    let mut divides = false;
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        let word = word.trim();
        match word.parse::<f64>() {
            // `inf` and `nan` parse as numbers, and are no factors.
            Ok(number) if number.is_finite() && number != 0.0 => {
                factor = if divides { factor / number } else { factor * number };
            }
            Ok(_) => return Err("a factor that is finite and not zero"),
            Err(_) if !is_name(word) => return Err(FORM),
            Err(_) if name.is_some() => return Err("one parameter: products of two are no length"),
            Err(_) if divides => return Err("a parameter that is not divided by"),
            Err(_) => name = Some(word),
        }
        let Some(operator) = after.chars().next() else { break };
        divides = operator == '/';
        rest = after.get(1..).unwrap_or_default();
    }
    match name {
        Some(_) if range::FACTOR.missed(factor).is_some() || factor == 0.0 => Err("a factor between 1e-12 and 1e12"),
        Some(name) => Ok((factor, name)),
        None => Err(FORM),
    }
}

/// Returns true if a text has the form of a name: letters, digits and `_`, no digit first.
pub(super) fn is_name(text: &str) -> bool {
    text.chars().enumerate().all(|(at, c)| c == '_' || c.is_alphabetic() || (at > 0 && c.is_alphanumeric()))
        && !text.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_a_sign_or_a_factor_is_a_length() {
        for (text, factor) in [
            ("l2", 1.0),
            ("-l2", -1.0),
            ("+ l2", 1.0),
            ("2*l2", 2.0),
            ("l2 / 2", 0.5),
            ("-3 * l2 / 4", -0.75),
            ("l2*-1.5", -1.5),
            ("1e-3*l2", 1e-3),
        ] {
            assert_eq!(factored(text), Ok((factor, "l2")), "{text}");
        }
        assert_eq!(factored("Länge_1"), Ok((1.0, "Länge_1")));
    }

    #[test]
    fn sums_products_and_quotients_by_a_name_are_not() {
        for (text, why) in [
            ("l2+l3", "one parameter with a sign"),
            ("l2 - 1", "one parameter with a sign"),
            ("2 l2", "one parameter with a sign"),
            ("(l2)", "one parameter with a sign"),
            ("--l2", "one parameter with a sign"),
            ("0.5 m", "one parameter with a sign"),
            ("2*3", "one parameter with a sign"),
            ("", "one parameter with a sign"),
            ("l2*", "one parameter with a sign"),
            ("l2*l3", "products of two"),
            ("1/l2", "not divided by"),
            ("0*l2", "finite and not zero"),
            ("l2/0", "finite and not zero"),
            ("inf*l2", "finite and not zero"),
        ] {
            let found = factored(text);
            assert!(found.is_err_and(|found| found.contains(why)), "{text}: {found:?}");
        }
    }

    #[test]
    fn a_length_follows_its_parameter() {
        let half = Length::Multiple { factor: 0.5, parameter: "l2".into(), default: 2.0 };
        assert_eq!([half.at(&HashMap::new()), half.default_value()], [2.0, 2.0]);
        assert_eq!(half.at(&HashMap::from([("l2".into(), 3.0)])), 1.5);
        // A parameter that is zero by default is not a length of zero.
        let zero = Length::Multiple { factor: 1.0, parameter: "l2".into(), default: 0.0 };
        assert!(!zero.is_zero() && Length::Constant(-0.0).is_zero());
    }
}
