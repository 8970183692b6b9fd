//! Numbers with one square root: `even + odd r`, of which r^2 is known and r may be imaginary.
//!
//! A branch of a solver takes the positive or the negative root. What both branches have in common is computed once in
//! this form, and a product over both branches needs no root: `(e + o r)(e - o r) = e^2 - o^2 r^2`.

use crate::Scalar;

/// `even + odd r`
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<T> {
    pub even: T,
    pub odd: T,
}

impl<T: Scalar> Pair<T> {
    #[inline(always)]
    pub fn new(even: T, odd: T) -> Self {
        Self { even, odd }
    }

    /// The product, of r^2. Out of line where size counts, see `math::ONE_COPY`.
    #[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
    #[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline(always))]
    pub fn times(self, other: Self, square: T) -> Self {
        let odd = self.even * other.odd + self.odd * other.even;
        Self { even: self.even * other.even + self.odd * other.odd * square, odd }
    }

    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Self { even: self.even + other.even, odd: self.odd + other.odd }
    }

    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        Self { even: self.even - other.even, odd: self.odd - other.odd }
    }

    #[inline(always)]
    pub fn plus_real(self, value: T) -> Self {
        Self { even: self.even + value, odd: self.odd }
    }

    #[inline(always)]
    pub fn scaled(self, factor: T) -> Self {
        Self { even: self.even * factor, odd: self.odd * factor }
    }

    /// The value for a root that is real.
    #[inline(always)]
    pub fn at(self, root: T) -> T {
        self.even + self.odd * root
    }

    /// The product of the values for r and -r, of r^2.
    #[inline(always)]
    pub fn norm(self, square: T) -> T {
        self.even * self.even - self.odd * self.odd * square
    }
}
