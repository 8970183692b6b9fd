//! Numbers of several poses at once, one in each lane of a vector register.
//!
//! A function over [`Lanes`] is compiled once for each [`InstructionSet`], and [`InstructionSet::run`] calls the one that
//! the processor has. The operations are those of IEEE 754, none is fused, so that every lane has the bits of the same
//! operations on an `f64`.
//!
//! Two implementations: vectors of the crate `fearless_simd`, on x86, and arrays of four whose loops the compiler turns
//! into the vector code of the target, everywhere. The trait is sealed: neither shows in what is built on it.
//!
//! All that runs over lanes is `#[inline(always)]`. A function that is not inlined into [`InstructionSet::run`] is
//! compiled without the instructions of the set, and every one of its operations becomes a call.

mod array;
mod set;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod turned;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod vector;

use core::ops::{Add, Div, Mul, Neg, Sub};

pub use array::Four;
pub use set::{InstructionSet, Work};

/// The poses of a block: as many as a mask of blocks has bits.
pub const BLOCK: usize = 32;

/// The lanes of the widest vector.
pub const MOST_LANES: usize = 8;

/// A number for each pose of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Row(pub [f64; BLOCK]);

impl Row {
    /// One number for every pose.
    #[must_use]
    pub const fn all(value: f64) -> Self {
        Self([value; BLOCK])
    }
}

mod sealed {
    /// Keeps other types from being lanes.
    pub trait Sealed {}
}

/// Numbers of several poses. What is said of one number holds for each of them.
pub trait Lanes:
    sealed::Sealed
    + Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A truth value for each lane.
    type Mask: Copy;
    /// Proof that the processor has the instructions.
    type Set: Copy;
    /// The number of lanes; it divides [`BLOCK`].
    const WIDTH: usize;
    /// True of vectors whose operations are instructions of the set. Loops over arrays are left to the compiler.
    const EXPLICIT: bool;

    /// One number in every lane.
    fn all(set: Self::Set, value: f64) -> Self;
    /// One number in every lane, by the set that `self` proves.
    fn of(self, value: f64) -> Self;
    /// The numbers from the `at`-th vector of a row; zeros beyond its end.
    fn load(set: Self::Set, row: &Row, at: usize) -> Self;
    /// Writes the `at`-th vector of a row; nothing beyond its end.
    fn store(self, row: &mut Row, at: usize);
    /// Writes the numbers to the front of a slice; nothing if it is too short.
    fn write(self, to: &mut [f64]);
    /// The columns of four numbers of each lane's row: the first numbers, the second ones, and so on. Rows beyond the
    /// lanes are not looked at.
    fn columns(set: Self::Set, rows: &[[f64; 4]; MOST_LANES]) -> [Self; 4];
    /// Four numbers of each lane as a row; zeros beyond the lanes.
    fn rows(columns: [Self; 4]) -> [[f64; 4]; MOST_LANES];
    /// Magnitude.
    fn abs(self) -> Self;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// The sign changed where that of `sign` is negative.
    fn turned_by(self, sign: Self) -> Self;
    /// The number without the lower 27 bits of its fraction.
    fn upper(self) -> Self;
    /// `self < other`; false for what is not a number.
    fn less(self, other: Self) -> Self::Mask;
    /// `self <= other`; false for what is not a number.
    fn at_most(self, other: Self) -> Self::Mask;
    /// `self` where the mask is true, else `other`.
    fn where_or(self, mask: Self::Mask, other: Self) -> Self;
    /// True in every lane, or in none.
    fn mask(set: Self::Set, value: bool) -> Self::Mask;
    /// True where both are.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// True where either is.
    fn either(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// True where the mask is not.
    fn not(mask: Self::Mask) -> Self::Mask;
    /// A bit for each lane, the first one lowest.
    fn bits(mask: Self::Mask) -> u32;
    /// Sine and cosine from those of the angle less its quarter turns, whose number stands in the low bits of
    /// `rounded`; `angle` gives the sign.
    fn quarters(rounded: Self, sine: Self, cosine: Self, angle: Self) -> (Self, Self);
}

#[cfg(test)]
mod tests;
