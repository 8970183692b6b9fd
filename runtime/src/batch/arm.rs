//! Traits of generated code with the option `batch`.

use denhart_core::lanes::Lanes;

use super::Branches;
use crate::solve::ArmConstants;
use crate::{Arm, InverseKinematics, Jacobian, Pose, Solutions};

/// Poses of several joint vectors at once. With it [`forward`](super::forward()) takes slices.
///
/// Of each function the text is that of the scalar one. The lanes of the mask have an angle that is too large for the
/// sines over lanes: their results mean nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no functions over lanes",
    label = "generated without `batch`",
    note = "write `batch` in #[arm(..)], Builder::batch(true) or `denhart expand --batch`"
)]
pub trait BatchArm<const N: usize>: Arm<f64, N> {
    /// Pose of the tool in the base frame. `q`: joint values `[N]`, rad or length unit.
    fn forward_lanes<L: Lanes>(&self, set: L::Set, q: [L; N]) -> (Pose<L>, L::Mask);

    /// Pose and geometric Jacobian in the base frame, at the tool point.
    fn forward_and_jacobian_lanes<L: Lanes>(&self, set: L::Set, q: [L; N]) -> (Pose<L>, Jacobian<L, N>, L::Mask);
}

/// Inverses of several poses at once. With it [`inverse`](super::inverse()) takes slices.
///
/// An arm has it if its inverse takes a pose, and nothing beside it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inverse of several poses",
    label = "generated without `batch`, or its inverse takes another target than a pose alone",
    note = "write `batch` in #[arm(..)], Builder::batch(true) or `denhart expand --batch`",
    note = "other targets, and values given beside a pose, take single calls, or `DynamicArm::inverse_batch` of denhart-dynamic"
)]
pub trait BatchInverse<const N: usize, const S: usize>:
    InverseKinematics<f64, N, Target = Pose<f64>, Solutions = Solutions<f64, N, S>>
{
    /// The constants of the search.
    const ARM_CONSTANTS: ArmConstants<'static, f64, N>;

    /// Every branch of the ordinary targets, in the place of what `branches` had. Without a form over lanes each target
    /// takes a single call.
    #[inline(always)]
    fn inverse_lanes<L: Lanes>(&self, _set: L::Set, _target: &Pose<L>, branches: &mut Branches<L, N, S>) {
        branches.leave();
    }
}
