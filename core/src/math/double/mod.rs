//! Kernels for `f64`. Plain multiplications and additions only: no fused operation, so the bits are the same
//! everywhere.

pub(super) mod angle;
pub(super) mod atan2;
mod far;
pub(super) mod sin_cos;

/// On bare metal `f64` is computed by routines, and a call costs nothing beside it: one copy of the equations serves all.
const ONE_COPY: bool = cfg!(target_os = "none");
/// Bits of an `f64` without its sign.
const MAGNITUDE: u64 = i64::MAX as u64;
/// The sign bit of an `f64`.
pub(crate) const SIGN: u64 = !MAGNITUDE;
