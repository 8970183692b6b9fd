//! Interface of the iteration to an arm: a generated one or a chain.

use core::marker::PhantomData;

use crate::arm::Arm;
use crate::dh::JointKind;
use crate::jacobian::Jacobian;
use crate::math::{self, Scalar};
use crate::pose::Pose;

/// A joint vector: `[T; N]`, or a `Vec` of the length of the arm.
pub(crate) trait Joints<T>: Clone + AsRef<[T]> + AsMut<[T]> {}
impl<T, V: Clone + AsRef<[T]> + AsMut<[T]>> Joints<T> for V {}

/// An arm as the iteration sees it.
pub(crate) trait Model<T: Scalar> {
    /// Its joint vectors.
    type Joints: Joints<T>;

    /// Pose and Jacobian, as the arm returns them.
    type Evaluation;

    /// Pose of the tool and geometric Jacobian.
    fn evaluate(&self, q: &Self::Joints) -> Self::Evaluation;

    /// The pose, and the rows of the Jacobian.
    fn parts(evaluation: &mut Self::Evaluation) -> (&Pose<T>, &mut [Self::Joints; 6]);

    /// Lowest and highest value of a joint.
    fn limits(&self, joint: usize) -> [T; 2];

    /// Returns true for a prismatic joint.
    fn is_prismatic(&self, joint: usize) -> bool;

    /// Origins of the links in order, the tool last, each handed to `visit`.
    fn visit_origins(&self, q: &Self::Joints, visit: impl FnMut([T; 3]));
}

/// A length that measures the arm: the way from the first link's origin along the links to the tool; 1 if that is 0.
///
/// For an arm of revolute joints it does not depend on the joint values. It weighs lengths against angles.
pub(super) fn characteristic_length<T: Scalar, M: Model<T>>(model: &M, q: &M::Joints) -> T {
    let (mut last, mut length) = (None, T::ZERO);
    model.visit_origins(q, |[x, y, z]| {
        if let Some([px, py, pz]) = last.replace([x, y, z]) {
            let (dx, dy, dz): (T, T, T) = (x - px, y - py, z - pz);
            length += math::sqrt(dx * dx + dy * dy + dz * dz);
        }
    });
    if length > T::ZERO && length.is_finite() { length } else { T::ONE }
}

/// The way along the links of an arm.
pub(crate) fn way_along_the_links<A: Arm<T, N>, T: Scalar, const N: usize>(arm: &A, q: &[T; N]) -> T {
    characteristic_length(&Generated::new(arm), q)
}

/// A generated arm.
pub(super) struct Generated<'a, A, T, const N: usize> {
    arm: &'a A,
    scalar: PhantomData<T>,
}

impl<'a, A, T, const N: usize> Generated<'a, A, T, N> {
    pub(super) fn new(arm: &'a A) -> Self {
        Self { arm, scalar: PhantomData }
    }
}

impl<A: Arm<T, N>, T: Scalar, const N: usize> Model<T> for Generated<'_, A, T, N> {
    type Joints = [T; N];
    type Evaluation = (Pose<T>, Jacobian<T, N>);

    #[inline(always)]
    fn evaluate(&self, q: &[T; N]) -> Self::Evaluation {
        self.arm.forward_and_jacobian(q)
    }

    #[inline(always)]
    fn parts((pose, jacobian): &mut Self::Evaluation) -> (&Pose<T>, &mut [[T; N]; 6]) {
        (pose, &mut jacobian.rows)
    }

    #[inline(always)]
    fn limits(&self, joint: usize) -> [T; 2] {
        self.arm.limits().get(joint).copied().unwrap_or([-T::INFINITY, T::INFINITY])
    }

    #[inline(always)]
    fn is_prismatic(&self, joint: usize) -> bool {
        self.arm.joint_kinds().get(joint) == Some(&JointKind::Prismatic)
    }

    fn visit_origins(&self, q: &[T; N], mut visit: impl FnMut([T; 3])) {
        for link in self.arm.link_poses(q) {
            visit(link.translation);
        }
        visit(self.arm.forward(q).translation);
    }
}
