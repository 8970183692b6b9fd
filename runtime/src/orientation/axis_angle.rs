//! Rotation vectors, axis and angle, and the pose error as a twist.

use super::quaternion;
use crate::math::{self, Scalar};
use crate::pose::Pose;
use crate::vector::{dot, norm, sub};

/// A turn by an angle about an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisAngle<T> {
    /// Unit vector.
    pub axis: [T; 3],
    /// In `[0, pi]`, rad.
    pub angle: T,
}

impl<T: Scalar> Pose<T> {
    /// Pose from a position, in the length unit, and a turn by `angle` (rad) about `axis` (of any length); in degrees:
    /// [`from_xyz_axis_angle_degrees`](Self::from_xyz_axis_angle_degrees).
    ///
    /// Rodrigues's formula. `None` if the axis is zero or not finite, or the angle is not finite.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// let turn = Pose::from_xyz_axis_angle([0.0; 3], [0.0, 0.0, 2.0], 0.5);
    /// let yaw = Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, 0.5]);
    /// assert!(turn.is_some_and(|turn| turn.residual(&yaw).orientation < 1e-15_f64));
    /// ```
    #[must_use]
    pub fn from_xyz_axis_angle(xyz: [T; 3], axis: [T; 3], angle: T) -> Option<Self> {
        let largest = axis.iter().fold(T::ZERO, |most, part| most.max(part.abs()));
        if !(largest > T::ZERO && angle.is_finite() && axis.iter().all(|part| part.is_finite())) {
            return None;
        }
        let axis = axis.map(|part| part / largest);
        let length = norm(axis);
        let (sin, cos) = math::sin_cos(angle * T::HALF);
        let [x, y, z] = axis.map(|part| part / length * sin);
        Self::from_xyz_quaternion(xyz, [cos, x, y, z])
    }

    /// [`from_xyz_axis_angle`](Self::from_xyz_axis_angle) with the angle in degrees.
    #[must_use]
    pub fn from_xyz_axis_angle_degrees(xyz: [T; 3], axis: [T; 3], angle: T) -> Option<Self> {
        Self::from_xyz_axis_angle(xyz, axis, math::radians(angle))
    }

    /// Pose from a position, in the length unit, and a rotation vector: a turn about its direction by its length, rad.
    ///
    /// Not finite where the vector is not.
    #[must_use]
    pub fn from_xyz_rotation_vector(xyz: [T; 3], vector: [T; 3]) -> Self {
        let angle = norm(vector);
        // So small a turn differs from R = I + [v]x by less than rounding; its square may vanish.
        if angle < T::EPSILON {
            let ([x, y, z], i) = (vector, T::ONE);
            return Self { rotation: [[i, -z, y], [z, i, -x], [-y, x, i]], translation: xyz };
        }
        let not_finite = Self { rotation: [[T::NAN; 3]; 3], translation: xyz };
        Self::from_xyz_axis_angle(xyz, vector, angle).unwrap_or(not_finite)
    }

    /// The orientation as a rotation vector: its direction is the axis, its length the angle in `[0, pi]`, rad.
    ///
    /// The logarithm of the rotation, to rounding from no turn to half a turn. At half a turn the vector and its negative
    /// are the same rotation: the first component that is not zero is then positive. Just below it, the sign is
    /// determined, and two rotations next to each other may have vectors almost `2 pi` apart.
    #[must_use]
    pub fn rotation_vector(&self) -> [T; 3] {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.rotation;
        let twice_sine = [zy - yz, xz - zx, yx - xy];
        logarithm(&twice_sine, xx + yy + zz, || self.rotation)
    }

    /// The orientation as an axis and an angle in `[0, pi]`, see [`rotation_vector`](Self::rotation_vector). Without a
    /// turn the axis is z.
    #[must_use]
    pub fn axis_angle(&self) -> AxisAngle<T> {
        let vector = self.rotation_vector();
        let largest = vector.iter().fold(T::ZERO, |most, part| most.max(part.abs()));
        if largest > T::ZERO {
            let scaled = vector.map(|part| part / largest);
            let length = norm(scaled);
            AxisAngle { axis: scaled.map(|part| part / length), angle: (length * largest).min(T::PI) }
        } else {
            // No turn, or not a number, which the sum passes on.
            let angle = vector.iter().fold(T::ZERO, |sum, part| sum + *part);
            AxisAngle { axis: [T::ZERO, T::ZERO, T::ONE], angle }
        }
    }

    /// The twist that leads from this pose to `target`: `[vx, vy, vz, wx, wy, wz]` in the base frame, the translation
    /// in the length unit and the rotation vector in rad.
    ///
    /// A body that moves by the twist for a unit of time goes from this pose to the target. The velocity `v` of its
    /// origin and its angular velocity `w` are constant, both in the base frame. `w` is the exact logarithm of
    /// `R_target R^T`, accurate from the smallest turn up to `pi`. At `pi` its sign is a convention, as with
    /// [`rotation_vector`](Self::rotation_vector). The twist has the rows of a [`Jacobian`](crate::Jacobian):
    /// `J dq = error` is Newton's step. Not finite where a pose is not.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// let here = Pose::<f64>::identity();
    /// let there = Pose::from_xyz_rpy([1.0, 2.0, 3.0], [0.0, 0.0, 3.0]);
    /// let [vx, vy, vz, wx, wy, wz] = here.error_to(&there);
    /// assert_eq!([vx, vy, vz, wx, wy], [1.0, 2.0, 3.0, 0.0, 0.0]);
    /// assert!((wz - 3.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn error_to(&self, target: &Self) -> [T; 6] {
        let ([px, py, pz], [qx, qy, qz]) = (self.translation, target.translation);
        let ([r0, r1, r2], [t0, t1, t2]) = (&self.rotation, &target.rotation);
        let trace = dot(*r0, *t0) + dot(*r1, *t1) + dot(*r2, *t2);
        // R R^T is symmetric, so (R_t - R) R^T has the skew part of R_t R^T, without its cancellation.
        let [d0, d1, d2] = [sub(*t0, *r0), sub(*t1, *r1), sub(*t2, *r2)];
        let twice_sine = [dot(d2, *r1) - dot(d1, *r2), dot(d0, *r2) - dot(d2, *r0), dot(d1, *r0) - dot(d0, *r1)];
        let product = || [t0, t1, t2].map(|t| [dot(*t, *r0), dot(*t, *r1), dot(*t, *r2)]);
        let [wx, wy, wz] = logarithm(&twice_sine, trace, product);
        [qx - px, qy - py, qz - pz, wx, wy, wz]
    }
}

/// The rotation vector of a rotation with the given skew part (twice the axis times the sine) and trace. The matrix
/// itself is asked for only near half a turn, where the sine says little about the axis.
#[inline]
fn logarithm<T: Scalar>(twice_sine: &[T; 3], trace: T, rotation: impl FnOnce() -> [[T; 3]; 3]) -> [T; 3] {
    let length = norm(*twice_sine);
    // At trace -1/2 the angle is 139 degrees and the sine 0.66.
    let factor = if trace > -T::HALF {
        if length > T::ZERO { math::atan2(length, trace - T::ONE) / length } else { T::HALF }
    } else {
        return beyond(&rotation());
    };
    twice_sine.map(|part| part * factor)
}

/// The rotation vector by way of the quaternion: accurate for large angles, and total.
#[cold]
fn beyond<T: Scalar>(rotation: &[[T; 3]; 3]) -> [T; 3] {
    let [w, x, y, z] = quaternion::of_rotation(rotation);
    let length = norm([x, y, z]);
    let factor = T::TWO * math::atan2(length, w) / length;
    [x, y, z].map(|part| part * factor)
}
