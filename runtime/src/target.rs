//! Targets of arms with fewer freedoms than a whole pose.

use crate::arm::{Arm, InverseKinematics};
use crate::math::{Scalar, radians, wrap};
use crate::pose::Pose;
use crate::solution::Residual;
use crate::solve::{Goal, Tolerances};

/// A target that an arm `A` with `N` joints can reach for.
///
/// A [`Pose`], a point `[T; 3]`, a point of the plane `[T; 2]` and a [`PlanarPose`] mean the same for every arm. The
/// other types belong to arms of one task. A pair of a target and the value of a redundant joint, or an array of such
/// values, counts as the target alone.
pub trait Target<A, T, const N: usize> {
    /// Residual of the arm's tool at `q`; only the components that the target gives count.
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T>;
}

impl<A: Arm<T, N>, T: Tolerances, const N: usize> Target<A, T, N> for Pose<T> {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        Goal::residual(self, q, &arm.forward(q))
    }
}

impl<G: Target<A, T, N>, A, T, const N: usize> Target<A, T, N> for (G, T) {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        self.0.missed_by(arm, q)
    }
}

impl<G: Target<A, T, N>, A, T, const N: usize, const K: usize> Target<A, T, N> for (G, [T; K]) {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        self.0.missed_by(arm, q)
    }
}

impl<A: Arm<T, N>, T: Tolerances, const N: usize> Target<A, T, N> for [T; 3] {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        Goal::residual(self, q, &arm.forward(q))
    }
}

impl<A: Arm<T, N>, T: Tolerances, const N: usize> Target<A, T, N> for [T; 2] {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        Goal::residual(self, q, &arm.forward(q))
    }
}

impl<A: Arm<T, N>, T: Tolerances, const N: usize> Target<A, T, N> for PlanarPose<T> {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        Goal::residual(self, q, &arm.forward(q))
    }
}

/// A target as an arm takes it: itself, or with the values of redundant joints, which the residual does not look at.
pub trait PartOf<W> {
    /// With those values, if the arm takes any.
    fn whole(&self) -> W;
}

impl<T: Scalar> PartOf<PointAxis<T>> for PointAxis<T> {
    fn whole(&self) -> PointAxis<T> {
        *self
    }
}

impl<T: Scalar> PartOf<(PointAxis<T>, T)> for PointAxis<T> {
    fn whole(&self) -> (PointAxis<T>, T) {
        (*self, T::ZERO)
    }
}

impl<T: Scalar, const K: usize> PartOf<(PointAxis<T>, [T; K])> for PointAxis<T> {
    fn whole(&self) -> (PointAxis<T>, [T; K]) {
        (*self, [T::ZERO; K])
    }
}

impl<A, T, const N: usize> Target<A, T, N> for PointAxis<T>
where
    A: InverseKinematics<T, N>,
    Self: PartOf<A::Target>,
{
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        arm.residual(q, &self.whole())
    }
}

impl<A: InverseKinematics<T, N, Target = Self>, T, const N: usize> Target<A, T, N> for PointAngle<T> {
    fn missed_by(&self, arm: &A, q: &[T; N]) -> Residual<T> {
        arm.residual(q, self)
    }
}

/// A point and the tool's rotation in the arm's own plane: the target of the task `position_angle`.
///
/// For an arm that yaws and then pitches about three parallel axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointAngle<T> {
    /// Where the tool point is to be, base frame, length unit, `[3]`.
    pub point: [T; 3],
    /// The tool's rotation in the plane, rad: the signed sum of the pitch joints with their DH offsets, counted after
    /// the yaw. The signs are those of the pitch axes relative to the first of them.
    pub angle: T,
}

impl<T> PointAngle<T> {
    /// A point and an angle in rad; in degrees: [`from_degrees`](Self::from_degrees).
    pub const fn new(point: [T; 3], angle: T) -> Self {
        PointAngle { point, angle }
    }
}

impl<T: Scalar> PointAngle<T> {
    /// A point and an angle in degrees: the gripper points down at -90.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use denhart::PointAngle;
    ///
    /// let down = PointAngle::from_degrees([0.2, 0.0, 0.05], -90.0);
    /// assert_eq!(down, PointAngle::new([0.2, 0.0, 0.05], -FRAC_PI_2));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_degrees(point: [T; 3], degrees: T) -> Self {
        PointAngle { point, angle: radians(degrees) }
    }

    /// Returns the target with its angle in (-pi, pi]: sums with the angle lose no digits to its turns.
    #[inline]
    #[must_use]
    pub fn wrapped(&self) -> Self {
        PointAngle { point: self.point, angle: wrap(self.angle) }
    }
}

/// A point and the direction of one of the tool's axes: the target of the task `position_axis`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointAxis<T> {
    /// Where the tool point is to be, base frame, length unit, `[3]`.
    pub point: [T; 3],
    /// Where the tool's axis is to point, base frame, `[3]`. Need not be of unit length: it is normalized. A vector
    /// shorter than 1e-12 is a bad target.
    pub axis: [T; 3],
}

impl<T> PointAxis<T> {
    /// A point and a direction.
    pub const fn new(point: [T; 3], axis: [T; 3]) -> Self {
        PointAxis { point, axis }
    }
}

/// A pose in the plane: the target of the task `planar_pose`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanarPose<T> {
    /// Position along the base frame's x, length unit.
    pub x: T,
    /// Position along the base frame's y, length unit.
    pub y: T,
    /// Direction of the tool's x axis, rad, counted from the base frame's x axis towards its y axis.
    pub phi: T,
}

impl<T> PlanarPose<T> {
    /// Position and direction, which is in rad; in degrees: [`from_degrees`](Self::from_degrees).
    pub const fn new(x: T, y: T, phi: T) -> Self {
        PlanarPose { x, y, phi }
    }
}

impl<T: Scalar> PlanarPose<T> {
    /// Position and direction, which is in degrees.
    #[inline]
    #[must_use]
    pub fn from_degrees(x: T, y: T, degrees: T) -> Self {
        PlanarPose { x, y, phi: radians(degrees) }
    }

    /// Returns the target with its direction in (-pi, pi]: sums with the angle lose no digits to its turns.
    #[inline]
    #[must_use]
    pub fn wrapped(&self) -> Self {
        PlanarPose { x: self.x, y: self.y, phi: wrap(self.phi) }
    }
}

impl<T: Scalar> From<[T; 3]> for PlanarPose<T> {
    /// From `[x, y, phi]`, phi in rad.
    fn from([x, y, phi]: [T; 3]) -> Self {
        PlanarPose { x, y, phi }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_stand_in_the_call() {
        use core::{f32, f64};
        let arc = PointAngle::from_degrees([1.0, 2.0, 3.0], 135.0);
        assert_eq!(arc, PointAngle::new([1.0, 2.0, 3.0], 3.0 * f64::consts::FRAC_PI_4));
        let plane = PlanarPose::from_degrees(1.0, -2.0, -180.0_f32);
        assert_eq!(plane, PlanarPose::new(1.0, -2.0, -f32::consts::PI));
        assert!(PointAngle::from_degrees([0.0; 3], f64::INFINITY).angle.is_infinite());
    }
}
