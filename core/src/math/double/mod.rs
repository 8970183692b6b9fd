//! Kernels for `f64`. Plain multiplications and additions only: no fused operation, so the bits are the same
//! everywhere.

pub(super) mod angle;
pub(super) mod atan2;
mod far;
pub(super) mod sin_cos;

use super::ONE_COPY;

/// Bits of an `f64` without its sign.
const MAGNITUDE: u64 = i64::MAX as u64;
/// The sign bit of an `f64`.
pub(crate) const SIGN: u64 = !MAGNITUDE;
