//! Joint limits, up to rounding.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

use crate::math::Scalar;

/// How far beyond a limit a value of this size may be by rounding: a robot parked at its limit is within it.
#[inline]
pub(crate) fn rounding<T: Scalar>(size: T) -> T {
    T::from_f64(16.0) * T::EPSILON * (T::ONE + size)
}

/// Returns true if a value is within limits, up to the rounding of the numbers it was computed from, which have this
/// `size`. A value that is not a number is outside.
#[inline]
pub(crate) fn within<T: Scalar>(value: T, [low, high]: [T; 2], size: T) -> bool {
    if low <= value && value <= high {
        return true;
    }
    let (below, above) = (low - value, value - high);
    // A plain comparison: not a number stays one, and is not within.
    let beyond = if below > above { below } else { above };
    beyond <= rounding(size)
}

/// `within` over lanes: a value inside is beyond neither limit by more than nothing, so that one comparison with each
/// limit is enough.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn within_lanes<L: Lanes>(value: L, [low, high]: [f64; 2], size: L) -> L::Mask {
    let rounding = value.of(16.0 * f64::EPSILON) * (value.of(1.0) + size);
    L::both((value.of(low) - value).at_most(rounding), (value - value.of(high)).at_most(rounding))
}
