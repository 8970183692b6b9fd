//! Traits of generated code with the option `batch`.

use denhart_core::lanes::Lanes;

use super::Branches;
use crate::solve::ArmConstants;
use crate::{Arm, InverseKinematics, Jacobian, Pose, Solutions};

/// Poses of several joint vectors at once. With it [`forward`](super::forward()) takes slices.
///
/// Of each function the text is that of the scalar one. The lanes of the mask have an angle that is too large for the
/// sines over lanes: their results mean nothing.
pub trait BatchArm<const N: usize>: Arm<f64, N> {
    /// Pose of the tool in the base frame. `q`: joint values `[N]`, rad or length unit.
    fn forward_lanes<L: Lanes>(&self, set: L::Set, q: [L; N]) -> (Pose<L>, L::Mask);

    /// Pose and geometric Jacobian in the base frame, at the tool point.
    fn forward_and_jacobian_lanes<L: Lanes>(&self, set: L::Set, q: [L; N]) -> (Pose<L>, Jacobian<L, N>, L::Mask);
}

/// Inverses of several poses at once. With it [`inverse`](super::inverse()) takes slices.
pub trait BatchInverse<const N: usize, const S: usize>:
    InverseKinematics<f64, N, Target = Pose<f64>, Solutions = Solutions<f64, N, S>>
{
    /// The constants of the search.
    const ARM_CONSTANTS: ArmConstants<'static, f64, N>;

    /// Every branch of the ordinary targets, in the place of what `branches` had.
    fn inverse_lanes<L: Lanes>(&self, set: L::Set, target: &Pose<L>, branches: &mut Branches<L, N, S>);
}
