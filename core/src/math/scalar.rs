//! The scalar types of the kinematics.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{double, single, sqrt};

mod sealed {
    /// Functions and constants for this crate alone; the trait also keeps other types from being a scalar.
    pub trait Kernel: Sized {
        /// Pi less its nearest float.
        const PI_LO: Self;
        /// `|self|` less a multiple of pi/2 as a sum of two floats, and the multiple modulo 4.
        fn reduce(self) -> (Self, Self, u8);
        /// Nearest value to an integer, without `f64` between.
        fn from_i32(value: i32) -> Self;
        /// The integer without the fraction; beyond `i32` its nearest end, 0 for what is not a number.
        fn to_i32(self) -> i32;
        /// Nearest value to an integer, without `f64` between.
        fn from_i64(value: i64) -> Self;
        /// As [`Kernel::to_i32`].
        fn to_i64(self) -> i64;
    }
}

/// A floating-point number the kinematics is computed in: `f64` or `f32`, and no other.
///
/// The functions of [`math`](crate::math) as methods, so that generic code needs no other trait.
pub trait Scalar:
    sealed::Kernel
    + Copy
    + PartialOrd
    + PartialEq
    + Debug
    + Display
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + Send
    + Sync
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// 1/2.
    const HALF: Self;
    /// Pi, rounded to nearest.
    const PI: Self;
    /// Pi/2, rounded to nearest.
    const FRAC_PI_2: Self;
    /// 2 pi, rounded to nearest.
    const TAU: Self;
    /// Distance from 1 to the next float.
    const EPSILON: Self;
    /// Greatest finite value.
    const MAX: Self;
    /// Its square root.
    const SQRT_MAX: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Not a number.
    const NAN: Self;

    /// Nearest value to `value`.
    fn from_f64(value: f64) -> Self;
    /// Value as `f64`, without rounding.
    fn to_f64(self) -> f64;
    /// Magnitude.
    fn abs(self) -> Self;
    /// Returns true for a finite number: neither infinite nor not a number.
    fn is_finite(self) -> bool;
    /// The magnitude of `self` with the sign of `sign`, that of a zero included.
    fn copysign(self, sign: Self) -> Self;
    /// `self` if `condition` holds, else 0.
    fn when(self, condition: bool) -> Self;
    /// The greater of two; `other` if either is not a number: one comparison, where `f32::max` takes two.
    fn max(self, other: Self) -> Self;
    /// The lesser of two; `other` if either is not a number.
    fn min(self, other: Self) -> Self;
    /// Nearest integer, halves to the even one.
    fn round_ties_even(self) -> Self;
    /// [`math::sqrt`](crate::math::sqrt).
    fn sqrt(self) -> Self;
    /// [`math::hypot`](crate::math::hypot).
    fn hypot(self, other: Self) -> Self;
    /// [`math::sin_cos`](crate::math::sin_cos).
    fn sin_cos(self) -> (Self, Self);
    /// [`math::sin_cos_array`](crate::math::sin_cos_array).
    fn sin_cos_array<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);
    /// [`math::atan2`](crate::math::atan2) of the ordinate `self` and the abscissa `x`.
    fn atan2(self, x: Self) -> Self;
    /// [`math::angle`](crate::math::angle) of the sine `self` and the cosine `cos`.
    fn angle(self, cos: Self) -> Self;
    /// [`math::angle_array`](crate::math::angle_array).
    fn angle_array<const N: usize>(sines: [Self; N], cosines: [Self; N]) -> [Self; N];
}

macro_rules! scalar {
    ($float:ident, $kernels:ident, $pi_lo:expr, $sqrt_max:expr) => {
        impl sealed::Kernel for $float {
            const PI_LO: Self = $pi_lo;

            #[inline]
            fn reduce(self) -> (Self, Self, u8) {
                let angle = $kernels::sin_cos::reduce(self);
                (angle.hi, angle.lo(), (angle.quarters & 3) as u8)
            }
            #[inline]
            fn from_i32(value: i32) -> Self {
                value as $float
            }
            #[inline]
            fn to_i32(self) -> i32 {
                self as i32
            }
            #[inline]
            fn from_i64(value: i64) -> Self {
                value as $float
            }
            #[inline]
            fn to_i64(self) -> i64 {
                self as i64
            }
        }

        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const HALF: Self = 0.5;
            const PI: Self = core::$float::consts::PI;
            const FRAC_PI_2: Self = core::$float::consts::FRAC_PI_2;
            const TAU: Self = core::$float::consts::TAU;
            const EPSILON: Self = $float::EPSILON;
            const MAX: Self = $float::MAX;
            const SQRT_MAX: Self = $sqrt_max;
            const INFINITY: Self = $float::INFINITY;
            const NAN: Self = $float::NAN;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
            #[inline]
            fn copysign(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }
            #[inline]
            fn when(self, condition: bool) -> Self {
                if condition { self } else { 0.0 }
            }
            #[inline]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline]
            fn round_ties_even(self) -> Self {
                // From 2^(bits - 1) on every float is an integer; adding that much rounds to one.
                const WHOLE: $float = 1.0 / $float::EPSILON;
                let magnitude = $float::abs(self);
                if magnitude < WHOLE { $float::copysign((magnitude + WHOLE) - WHOLE, self) } else { self }
            }
            #[inline]
            fn sqrt(self) -> Self {
                sqrt::$kernels(self)
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                sqrt::$kernels(self * self + other * other)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $kernels::sin_cos::sin_cos(self)
            }
            #[inline]
            fn sin_cos_array<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                $kernels::sin_cos::sin_cos_array(angles)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                $kernels::atan2::atan2(self, x)
            }
            #[inline]
            fn angle(self, cos: Self) -> Self {
                $kernels::angle::angle(self, cos)
            }
            #[inline(always)]
            fn angle_array<const N: usize>(sines: [Self; N], cosines: [Self; N]) -> [Self; N] {
                $kernels::angle::angle_array(sines, cosines)
            }
        }
    };
}

scalar!(f64, double, 1.2246467991473532e-16, 1.3407807929942596e154);
scalar!(f32, single, -8.742278e-08, 1.8446743e19);
