//! Numbers with their first and second derivative by time: exact derivatives of a law, without differences.

use std::ops::{Add, Div, Mul, Neg};

/// A value at a time with its first and second derivative there (truncated Taylor arithmetic, Griewank and Walther 2008).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Value.
    pub value: f64,
    /// First derivative.
    pub first: f64,
    /// Second derivative.
    pub second: f64,
}

impl Jet {
    /// A constant.
    pub const fn constant(value: f64) -> Self {
        Self { value, first: 0.0, second: 0.0 }
    }

    /// The time itself.
    pub const fn time(t: f64) -> Self {
        Self { value: t, first: 1.0, second: 0.0 }
    }

    /// True if value and both derivatives are finite.
    pub fn is_finite(&self) -> bool {
        self.value.is_finite() && self.first.is_finite() && self.second.is_finite()
    }

    fn is_constant(&self) -> bool {
        self.first == 0.0 && self.second == 0.0
    }

    /// A function of it by its value and derivatives there. A constant stays one, even where the function has no
    /// derivative.
    fn chain(self, value: f64, first: f64, second: f64) -> Self {
        if self.is_constant() {
            return Self::constant(value);
        }
        // Where the function is linear, its second derivative counts nothing, however fast the time runs.
        let curved = if second == 0.0 { 0.0 } else { second * self.first * self.first };
        Self { value, first: first * self.first, second: curved + first * self.second }
    }

    /// The power `self ^ exponent`, of a negative base by a constant integer only.
    pub fn power(self, exponent: Self) -> Self {
        if !exponent.is_constant() {
            return Function::Exp.of(exponent * Function::Ln.of(self));
        }
        let (x, n) = (self.value, exponent.value);
        // A factor that vanishes leaves no derivative, also where the power behind it is infinite.
        let term = |factor: f64, n: f64| if factor == 0.0 { 0.0 } else { factor * x.powf(n) };
        self.chain(x.powf(n), term(n, n - 1.0), term(n * (n - 1.0), n - 2.0))
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, first: self.first + other.first, second: self.second + other.second }
    }
}

impl Neg for Jet {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, first: -self.first, second: -self.second }
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + 2.0 * self.first * other.first + self.value * other.second,
        }
    }
}

impl Div for Jet {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        // From `self = quotient * other`; the value is then correctly rounded.
        let value = self.value / other.value;
        let first = (self.first - value * other.first) / other.value;
        let second = (self.second - 2.0 * first * other.first - value * other.second) / other.value;
        Self { value, first, second }
    }
}

/// A function of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
}

impl Function {
    /// Every function with its name in a law.
    pub const NAMED: [(&'static str, Self); 13] = [
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("asin", Self::Asin),
        ("acos", Self::Acos),
        ("atan", Self::Atan),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sqrt", Self::Sqrt),
        ("abs", Self::Abs),
    ];

    /// The function of a jet. Not a number or infinite where the function or a derivative is not defined.
    pub fn of(self, jet: Jet) -> Jet {
        let x = jet.value;
        let (value, first, second) = match self {
            Self::Sin => (x.sin(), x.cos(), -x.sin()),
            Self::Cos => (x.cos(), -x.sin(), -x.cos()),
            Self::Tan => {
                let (tan, slope) = (x.tan(), 1.0 + x.tan() * x.tan());
                (tan, slope, 2.0 * tan * slope)
            }
            Self::Asin | Self::Acos => {
                // (1 - x)(1 + x) keeps the digits that 1 - x^2 loses near 1.
                let square = (1.0 - x) * (1.0 + x);
                let (first, second) = (1.0 / square.sqrt(), x / (square * square.sqrt()));
                if self == Self::Asin { (x.asin(), first, second) } else { (x.acos(), -first, -second) }
            }
            Self::Atan => {
                let slope = 1.0 / (1.0 + x * x);
                (x.atan(), slope, -2.0 * x * slope * slope)
            }
            Self::Sinh => (x.sinh(), x.cosh(), x.sinh()),
            Self::Cosh => (x.cosh(), x.sinh(), x.cosh()),
            Self::Tanh => {
                let (tanh, slope) = (x.tanh(), 1.0 / (x.cosh() * x.cosh()));
                (tanh, slope, -2.0 * tanh * slope)
            }
            Self::Exp => (x.exp(), x.exp(), x.exp()),
            Self::Ln => (x.ln(), 1.0 / x, -1.0 / (x * x)),
            Self::Sqrt => {
                let root = x.sqrt();
                (root, 0.5 / root, -0.25 / (root * x))
            }
            // At zero it has no derivative.
            Self::Abs if x == 0.0 => (0.0, f64::NAN, f64::NAN),
            Self::Abs => (x.abs(), x.signum(), 0.0),
        };
        jet.chain(value, first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of the value: off by `h^2` of fourth derivatives below 100 and by roundings over `h^2`.
    fn check(name: &str, t: f64, f: impl Fn(Jet) -> Jet) {
        let h = 1e-4;
        let at = |t: f64| f(Jet::time(t)).value;
        let jet = f(Jet::time(t));
        let first = (at(t + h) - at(t - h)) / (2.0 * h);
        let second = (at(t + h) - 2.0 * at(t) + at(t - h)) / (h * h);
        let scale = 1.0 + jet.value.abs() + jet.first.abs() + jet.second.abs();
        assert!((jet.first - first).abs() < 1e-6 * scale, "{name} at {t}: {jet:?}, {first}");
        assert!((jet.second - second).abs() < 1e-6 * scale, "{name} at {t}: {jet:?}, {second}");
    }

    #[test]
    fn derivatives_of_the_functions() {
        for (name, function) in Function::NAMED {
            for t in [0.15, 0.4, 0.7] {
                check(name, t, |t| function.of(t * t + Jet::constant(0.1)));
            }
        }
        for t in [-0.7, 0.3, 1.9] {
            check("quotient", t, |t| (t * t + t) / (t + Jet::constant(3.0)));
            check("cube", t, |t| t.power(Jet::constant(3.0)));
            check("inverse square", t, |t| (-t).power(Jet::constant(-2.0)));
            check("power of powers", t, |t| (t * t + Jet::constant(1.0)).power(t));
        }
    }

    #[test]
    fn powers_of_zero() {
        let power = |n: f64| Jet::time(0.0).power(Jet::constant(n));
        assert_eq!(power(0.0), Jet::constant(1.0));
        assert_eq!(power(1.0), Jet::time(0.0));
        assert_eq!(power(2.0), Jet { value: 0.0, first: 0.0, second: 2.0 });
        assert_eq!(power(3.0), Jet { value: 0.0, first: 0.0, second: 0.0 });
        assert!(!power(0.5).is_finite() && !power(1.5).is_finite() && !power(-1.0).is_finite());
    }

    #[test]
    fn constants_stay_constant_where_a_derivative_does_not_exist() {
        assert_eq!(Function::Sqrt.of(Jet::constant(0.0)), Jet::constant(0.0));
        assert_eq!(Function::Abs.of(Jet::constant(0.0)), Jet::constant(0.0));
        assert!(!Function::Sqrt.of(Jet::time(0.0)).is_finite());
        assert!(!Function::Abs.of(Jet::time(0.0)).is_finite());
        assert!(!Function::Ln.of(Jet::constant(0.0)).is_finite());
    }
}
