//! Motion laws: one expression in the time `t` for each joint.
//!
//! ```text
//! laws    = law { "," law }
//! law     = term { ("+" | "-") term }
//! term    = factor { ["*" | "/"] factor }            without a sign: a product, as in 3t or 2 pi sin(t)
//! factor  = ("+" | "-") factor | atom ["^" factor]    ^ binds tighter than a sign before it, and to the right
//! atom    = number | "t" | "pi" | "e" | function "(" law ")" | "(" law ")"
//! ```
//!
//! `1/2t` is refused: some read it as `(1/2) t`, some as `1/(2t)`.

use std::fmt;

use super::jet::{Function, Jet};
use super::token::{LawError, Token, tokens};

/// Deepest nesting of parentheses, signs and powers: what stands on the stack is bounded.
const DEEPEST: usize = 100;

/// The motion of one joint as a function of the time.
#[derive(Debug, Clone, PartialEq)]
pub struct Law {
    expression: Expression,
    /// Where it starts in the text of all laws, a byte offset.
    pub at: usize,
    /// The text.
    pub text: String,
}

impl Law {
    /// Value, rate and derivative of the rate at the time `t`.
    pub fn at(&self, t: f64) -> Jet {
        self.expression.at(Jet::time(t))
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Sums and products hold all of their parts, so that a long law is no deep one.
#[derive(Debug, Clone, PartialEq)]
enum Expression {
    Number(f64),
    Time,
    Negative(Box<Expression>),
    Sum(Vec<Expression>),
    /// The factors, each with whether it divides.
    Product(Vec<(Expression, bool)>),
    Power(Box<Expression>, Box<Expression>),
    Call(Function, Box<Expression>),
}

impl Expression {
    fn at(&self, t: Jet) -> Jet {
        match self {
            Self::Number(value) => Jet::constant(*value),
            Self::Time => t,
            Self::Negative(inner) => -inner.at(t),
            Self::Sum(terms) => terms.iter().fold(Jet::constant(0.0), |sum, term| sum + term.at(t)),
            Self::Product(factors) => factors.iter().fold(Jet::constant(1.0), |product, (factor, divides)| {
                if *divides { product / factor.at(t) } else { product * factor.at(t) }
            }),
            Self::Power(base, exponent) => base.at(t).power(exponent.at(t)),
            Self::Call(function, argument) => function.of(argument.at(t)),
        }
    }
}

/// The laws in a text, separated by commas.
///
/// # Errors
/// The first place that is no law, with what was expected there.
pub fn parse(text: &str) -> Result<Vec<Law>, LawError> {
    let tokens = tokens(text)?;
    let mut parser = Parser { tokens: &tokens, next: 0, end: text.len(), depth: 0 };
    let mut laws = Vec::new();
    loop {
        let at = parser.place();
        let expression = parser.sum()?;
        let law = text.get(at..parser.place()).unwrap_or_default().trim_end().to_owned();
        laws.push(Law { expression, at, text: law });
        match parser.peek() {
            None => return Ok(laws),
            Some(Token::Sign(',')) => parser.next += 1,
            Some(_) => return Err(parser.unexpected("an operator, `,` or the end")),
        }
    }
}

struct Parser<'a> {
    tokens: &'a [(usize, Token)],
    next: usize,
    end: usize,
    depth: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next).map(|(_, token)| token)
    }

    /// Where the next token stands.
    fn place(&self) -> usize {
        self.tokens.get(self.next).map_or(self.end, |(at, _)| *at)
    }

    fn error(&self, message: impl Into<String>) -> LawError {
        LawError { at: self.place(), message: message.into() }
    }

    fn unexpected(&self, expected: &str) -> LawError {
        match self.peek() {
            Some(token) => self.error(format!("expected {expected}, found `{token}`")),
            None => self.error(format!("expected {expected}, found the end")),
        }
    }

    /// Takes the sign if it is next.
    fn take(&mut self, sign: char) -> bool {
        let is_next = self.peek() == Some(&Token::Sign(sign));
        self.next += usize::from(is_next);
        is_next
    }

    fn sum(&mut self) -> Result<Expression, LawError> {
        let first = self.product()?;
        let mut terms = vec![first];
        loop {
            if self.take('+') {
                terms.push(self.product()?);
            } else if self.take('-') {
                terms.push(Expression::Negative(Box::new(self.product()?)));
            } else {
                return Ok(single(terms).unwrap_or_else(Expression::Sum));
            }
        }
    }

    fn product(&mut self) -> Result<Expression, LawError> {
        let mut factors = vec![(self.factor()?, false)];
        loop {
            let divides = factors.last().is_some_and(|(_, divides)| *divides);
            match self.peek() {
                Some(Token::Sign(sign @ ('*' | '/'))) => {
                    let divides = *sign == '/';
                    self.next += 1;
                    factors.push((self.factor()?, divides));
                }
                Some(Token::Number(_) | Token::Name(_) | Token::Sign('(')) if divides => {
                    let message = "a product without a sign after `/` can be read two ways: put parentheses or a `*`";
                    return Err(self.error(message));
                }
                Some(Token::Number(_)) => {
                    return Err(self.unexpected("an operator, `,` or the end"));
                }
                Some(Token::Name(_) | Token::Sign('(')) => factors.push((self.factor()?, false)),
                _ if factors.len() > 1 => return Ok(Expression::Product(factors)),
                _ => {
                    let factor = factors.pop().map(|(factor, _)| factor);
                    return factor.ok_or_else(|| self.unexpected("a law"));
                }
            }
        }
    }

    fn factor(&mut self) -> Result<Expression, LawError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error(format!("nested deeper than {DEEPEST} levels")));
        }
        let factor = if self.take('-') {
            Expression::Negative(Box::new(self.factor()?))
        } else if self.take('+') {
            self.factor()?
        } else {
            let base = self.atom()?;
            if self.take('^') { Expression::Power(Box::new(base), Box::new(self.factor()?)) } else { base }
        };
        self.depth -= 1;
        Ok(factor)
    }

    fn atom(&mut self) -> Result<Expression, LawError> {
        const EXPECTED: &str = "a number, `t`, `pi`, a function or `(`";
        let Some(token) = self.peek().cloned() else { return Err(self.unexpected(EXPECTED)) };
        match token {
            Token::Number(value) => {
                self.next += 1;
                Ok(Expression::Number(value))
            }
            Token::Name(name) => self.name(&name),
            Token::Sign('(') => self.in_parentheses(),
            Token::Sign(_) => Err(self.unexpected(EXPECTED)),
        }
    }

    fn name(&mut self, name: &str) -> Result<Expression, LawError> {
        let constant = match name {
            "t" => Some(Expression::Time),
            "pi" | "π" => Some(Expression::Number(std::f64::consts::PI)),
            "e" => Some(Expression::Number(std::f64::consts::E)),
            _ => None,
        };
        if let Some(constant) = constant {
            self.next += 1;
            return Ok(constant);
        }
        let Some((_, function)) = Function::NAMED.iter().find(|(known, _)| *known == name) else {
            let known: Vec<&str> = Function::NAMED.iter().map(|(known, _)| *known).collect();
            let known = known.join(", ");
            return Err(self.error(format!("`{name}` is unknown; there are t, pi, e and the functions {known}")));
        };
        self.next += 1;
        if self.peek() != Some(&Token::Sign('(')) {
            return Err(self.unexpected(&format!("`(` after `{name}`")));
        }
        Ok(Expression::Call(*function, Box::new(self.in_parentheses()?)))
    }

    fn in_parentheses(&mut self) -> Result<Expression, LawError> {
        let open = self.place();
        self.next += 1;
        let inner = self.sum()?;
        if self.take(')') {
            return Ok(inner);
        }
        match self.peek() {
            None | Some(Token::Sign(',')) => Err(LawError { at: open, message: "this `(` is not closed".to_owned() }),
            Some(_) => Err(self.unexpected("an operator or `)`")),
        }
    }
}

/// The only element, or all of them back.
fn single(mut terms: Vec<Expression>) -> Result<Expression, Vec<Expression>> {
    match terms.pop() {
        Some(only) if terms.is_empty() => Ok(only),
        Some(last) => {
            terms.push(last);
            Err(terms)
        }
        None => Err(terms),
    }
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use super::*;

    fn value(text: &str, t: f64) -> f64 {
        let laws = parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        assert_eq!(laws.len(), 1, "{text}");
        laws[0].at(t).value
    }

    #[test]
    fn values_and_precedence() {
        let t = 1.7_f64;
        let cases = [
            ("3t", 3.0 * t),
            ("-90+3t", -90.0 + 3.0 * t),
            (" 90 + 3 t ", 90.0 + 3.0 * t),
            ("2(t+1)", 2.0 * (t + 1.0)),
            ("t(t+1)", t * (t + 1.0)),
            ("(t+1)(t-1)", t * t - 1.0),
            ("2 pi sin(2 pi t)", std::f64::consts::TAU * (std::f64::consts::TAU * t).sin()),
            ("-t^2", -t * t),
            ("(-t)^2", t * t),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("2t**2", 2.0 * t * t),
            ("3t^2 - 2t^3", 3.0 * t * t - 2.0 * t * t * t),
            ("10 - 4 - 3", 3.0),
            ("12 / 2 / 3", 2.0),
            ("1/2*t", 0.5 * t),
            ("t/2", 0.5 * t),
            ("1/(2t)", 0.5 / t),
            ("--t", t),
            ("1e2 + 1.5e-1 + .5", 100.65),
            ("2e", 2.0 * std::f64::consts::E),
            ("e^(-t)", (-t).exp()),
            ("3exp(-t)", 3.0 * (-t).exp()),
            ("sqrt(abs(-t)) π", t.sqrt() * std::f64::consts::PI),
        ];
        for (text, expected) in cases {
            let found = value(text, t);
            assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{text}: {found} for {expected}");
        }
    }

    #[test]
    fn laws_are_separated_by_commas() {
        let laws = parse("3t, -90 + 3t ,sin(t)").unwrap_or_default();
        let texts: Vec<(usize, &str)> = laws.iter().map(|law| (law.at, law.text.as_str())).collect();
        assert_eq!(texts, [(0, "3t"), (4, "-90 + 3t"), (14, "sin(t)")]);
        assert_eq!(laws[1].at(10.0), Jet { value: -60.0, first: 3.0, second: 0.0 });
    }

    #[test]
    fn mistakes_have_a_place() {
        let cases = [
            ("", 0, "found the end"),
            ("3t,", 3, "found the end"),
            ("3t,,t", 3, "found `,`"),
            ("3t + ", 5, "found the end"),
            ("3t )", 3, "found `)`"),
            ("2(t+1", 1, "not closed"),
            ("(t, t)", 0, "not closed"),
            ("sin t", 4, "`(` after `sin`"),
            ("3x", 1, "`x` is unknown"),
            ("t 3", 2, "found `3`"),
            ("1/2t", 3, "two ways"),
            ("1/t(t+1)", 3, "two ways"),
            ("3 $ t", 2, "no meaning"),
            ("1.2.3", 3, "found `0.3`"),
            (".", 0, "not a number"),
            ("1e999", 0, "not a number"),
            ("t ^ * 2", 4, "found `*`"),
        ];
        for (text, at, message) in cases {
            match parse(text) {
                Err(error) => {
                    assert_eq!(error.at, at, "{text}: {error:?}");
                    assert!(error.message.contains(message), "{text}: {error:?}");
                }
                Ok(laws) => panic!("{text}: {laws:?}"),
            }
        }
    }

    #[test]
    fn depth_is_bounded_and_length_is_not() {
        for deep in ["(".repeat(100_000), "-".repeat(100_000), "2^".repeat(100_000), "sin(".repeat(100_000)] {
            assert!(matches!(parse(&deep), Err(error) if error.message.contains("nested")));
        }
        let long = vec!["t"; 100_000];
        assert_eq!(value(&long.join("+"), 1.0), 100_000.0);
        assert_eq!(value(&long.join("*"), 1.0), 1.0);
    }
}
