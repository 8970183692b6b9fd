//! The pieces of a law: numbers, names and signs.

use std::fmt;

/// A mistake in a text of laws.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LawError {
    /// Where, a byte offset into the text.
    pub at: usize,
    /// The token that was found, and those that were expected.
    pub message: String,
}

/// A piece of a law.
#[derive(Debug, Clone, PartialEq)]
pub enum Token {
    /// A finite number, not negative.
    Number(f64),
    /// The time, a constant or a function.
    Name(String),
    /// An operator, a parenthesis or a comma; `**` is `^`.
    Sign(char),
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write!(f, "{value}"),
            Self::Name(name) => f.write_str(name),
            Self::Sign(sign) => write!(f, "{sign}"),
        }
    }
}

/// The tokens with their places, byte offsets.
///
/// # Errors
/// A character that has no meaning in a law, or digits that are no number.
pub fn tokens(text: &str) -> Result<Vec<(usize, Token)>, LawError> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let at = text.len() - rest.len();
        let length = if first.is_whitespace() {
            first.len_utf8()
        } else if first.is_ascii_digit() || first == '.' {
            let length = number_length(rest);
            let written = rest.get(..length).unwrap_or_default();
            let value = written.parse::<f64>().ok().filter(|value| value.is_finite());
            let message = || format!("`{written}` is not a number");
            tokens.push((at, Token::Number(value.ok_or_else(|| LawError { at, message: message() })?)));
            length
        } else if first.is_alphabetic() {
            let length = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            tokens.push((at, Token::Name(rest.get(..length).unwrap_or_default().to_owned())));
            length
        } else if rest.starts_with("**") {
            tokens.push((at, Token::Sign('^')));
            2
        } else if "+-*/^(),".contains(first) {
            tokens.push((at, Token::Sign(first)));
            1
        } else {
            let message = format!("`{first}` has no meaning in a law");
            return Err(LawError { at, message });
        };
        rest = rest.get(length..).unwrap_or_default();
    }
    Ok(tokens)
}

/// Length of the number that the text begins with: digits, a point, and an exponent only if digits follow the `e`.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = text.get(from..).unwrap_or_default();
        from + rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len())
    };
    let mut length = digits(0);
    if text.get(length..).is_some_and(|rest| rest.starts_with('.')) {
        length = digits(length + 1);
    }
    let exponent = text.get(length..).and_then(|rest| rest.strip_prefix(['e', 'E']));
    if let Some(exponent) = exponent {
        let sign = usize::from(exponent.starts_with(['+', '-']));
        let end = digits(length + 1 + sign);
        if end > length + 1 + sign {
            length = end;
        }
    }
    length
}
