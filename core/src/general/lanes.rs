//! Numbers of one or two samples at once: two are a vector register of any 64-bit processor.

use core::ops::{Add, Mul, Sub};

/// A number for each sample.
pub(super) trait Lanes: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    const ZERO: Self;
    const ONE: Self;
    /// One over each number.
    fn inverse(self) -> Self;
    /// The magnitude of the product of the numbers: a pivot serves all samples.
    fn magnitude(self) -> f64;
    /// One number for all samples.
    fn all(x: f64) -> Self;
}

impl Lanes for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline(always)]
    fn inverse(self) -> Self {
        1.0 / self
    }
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
    }
    #[inline(always)]
    fn all(x: f64) -> Self {
        x
    }
}

/// Two samples.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(super) struct Two(pub(super) [f64; 2]);

impl Lanes for Two {
    const ZERO: Self = Self([0.0; 2]);
    const ONE: Self = Self([1.0; 2]);

    #[inline(always)]
    fn inverse(self) -> Self {
        let Self([a, b]) = self;
        Self([1.0 / a, 1.0 / b])
    }
    #[inline(always)]
    fn magnitude(self) -> f64 {
        let Self([a, b]) = self;
        (a * b).abs()
    }
    #[inline(always)]
    fn all(x: f64) -> Self {
        Self([x, x])
    }
}

impl Add for Two {
    type Output = Self;
    #[inline(always)]
    fn add(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a + c, b + d])
    }
}

impl Sub for Two {
    type Output = Self;
    #[inline(always)]
    fn sub(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a - c, b - d])
    }
}

impl Mul for Two {
    type Output = Self;
    #[inline(always)]
    fn mul(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a * c, b * d])
    }
}
