//! How far the roots of one stage are in doubt.

use super::tolerances::Tolerances;
use crate::JointMask;

/// Doubt of one stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) struct Doubt<T> {
    pub(in crate::solve) gap: T,
    pub(in crate::solve) angular: bool,
    pub(in crate::solve) boundary: bool,
    /// Conditioning of the stage; 1 where it is not in doubt.
    pub(in crate::solve) amplitude: T,
    /// True if the roots close the equation of the stage to rounding, however small the amplitude. The vectors of the
    /// later stages then have the lengths that they should have. Two roots of one joint close only where they are
    /// farther apart than [`Tolerances::COINCIDENT`]: closer ones may be one solution.
    pub(in crate::solve) closes: bool,
    pub(in crate::solve) weak: JointMask,
    pub(in crate::solve) free: JointMask,
}

impl<T: Tolerances> Doubt<T> {
    /// Nothing.
    pub(in crate::solve) const NOTHING: Self = Self {
        gap: T::ZERO,
        angular: false,
        boundary: false,
        amplitude: T::ONE,
        closes: false,
        weak: JointMask::NONE,
        free: JointMask::NONE,
    };
}
