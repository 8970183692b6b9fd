//! Kernels for `f32`, without any `f64`: the small processors this is for have single precision only. Plain
//! multiplications and additions: no fused operation, so the bits are the same everywhere.

pub(super) mod angle;
pub(super) mod atan2;
mod far;
pub(super) mod sin_cos;

/// Bits of an `f32` without its sign.
const MAGNITUDE: u32 = i32::MAX as u32;
/// The sign bit of an `f32`.
const SIGN: u32 = !MAGNITUDE;
