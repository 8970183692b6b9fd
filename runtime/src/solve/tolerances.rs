//! The thresholds of the cascade, per scalar type.

use crate::math::Scalar;

/// Thresholds relative to the size of the quantities compared (reach for lengths, 1 for directions).
pub trait Tolerances: Scalar {
    /// Amplitude below which an equation does not determine its joint: half of [`Self::EXACT`] at most, so that a joint
    /// left at its reference still closes.
    const VANISHING: Self;
    /// Amplitude below which a solution is checked in full, by forward kinematics.
    const DOUBTFUL: Self;
    /// Amplitude below which a joint may be all wrong if the joints before it come from a double root.
    const WEAK: Self;
    /// 64 units of rounding.
    const ROUNDING: Self;
    /// A residual up to this (relative to reach, and in rad) is exact.
    const EXACT: Self;
    /// Joint vectors closer than this in every joint (rad, relative to reach) are one solution: two roots merge when
    /// the sine of their half difference falls below the root of [`Self::ROUNDING`].
    const COINCIDENT: Self;
    /// A candidate with a relative residual above this is a guess rather than a solution of small error.
    const CLOSE: Self;
    /// A sine far below rounding whose fourth power is a number.
    const LEAST_SINE: Self;
    /// -1.
    const MINUS_ONE: Self;
    /// An angle beyond this, rad, is no reference: half a unit of its last place in every joint is about [`Self::EXACT`].
    const MOST_WOUND: Self;
    /// An arm of this reach or more has squares of areas that overflow.
    const LARGEST_REACH: Self;
    /// An arm of this reach or less has squares of areas that underflow where they count.
    const SMALLEST_REACH: Self;
}

impl Tolerances for f64 {
    const VANISHING: f64 = 4e-13;
    const DOUBTFUL: f64 = 2e-3;
    const WEAK: f64 = 1e-5;
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    const EXACT: f64 = 8e-13;
    const COINCIDENT: f64 = 2.4e-7;
    const CLOSE: f64 = 1e-4;
    const LEAST_SINE: f64 = 5e-32;
    const MINUS_ONE: f64 = -1.0;
    const MOST_WOUND: f64 = 2048.0;
    const LARGEST_REACH: f64 = 1e60;
    const SMALLEST_REACH: f64 = 1e-60;
}

impl Tolerances for f32 {
    const VANISHING: f32 = 1e-6;
    const DOUBTFUL: f32 = 2e-2;
    const WEAK: f32 = 1e-2;
    const ROUNDING: f32 = 64.0 * f32::EPSILON;
    const EXACT: f32 = 2e-5;
    const COINCIDENT: f32 = 5.5e-3;
    const CLOSE: f32 = 1e-2;
    const LEAST_SINE: f32 = 1e-9;
    const MINUS_ONE: f32 = -1.0;
    const MOST_WOUND: f32 = 64.0;
    const LARGEST_REACH: f32 = 1e8;
    const SMALLEST_REACH: f32 = 1e-4;
}
