//! Roll, pitch, yaw and the other Euler angles.

use crate::math::{self, Scalar};
use crate::pose::Pose;

/// A sequence of three axes, each turned with the body (intrinsic): `Xyz` is `Rx(a) Ry(b) Rz(c)`.
///
/// Taken in reverse, the angles turn about the axes of the reference frame (extrinsic): `Zyx` with the angles yaw,
/// pitch, roll is roll, pitch, yaw about the fixed x, y, z. The orders with three different axes (Tait-Bryan) are
/// singular where the middle angle is +-90 degrees. The orders that return to the first axis (proper Euler) are
/// singular where it is 0 or 180.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EulerOrder {
    /// `Rx(a) Ry(b) Rz(c)`.
    Xyz,
    /// `Rx(a) Rz(b) Ry(c)`.
    Xzy,
    /// `Ry(a) Rx(b) Rz(c)`.
    Yxz,
    /// `Ry(a) Rz(b) Rx(c)`.
    Yzx,
    /// `Rz(a) Rx(b) Ry(c)`.
    Zxy,
    /// `Rz(a) Ry(b) Rx(c)`: yaw, pitch, roll.
    Zyx,
    /// `Rx(a) Ry(b) Rx(c)`.
    Xyx,
    /// `Rx(a) Rz(b) Rx(c)`.
    Xzx,
    /// `Ry(a) Rx(b) Ry(c)`.
    Yxy,
    /// `Ry(a) Rz(b) Ry(c)`.
    Yzy,
    /// `Rz(a) Rx(b) Rz(c)`.
    Zxz,
    /// `Rz(a) Ry(b) Rz(c)`.
    Zyz,
}

impl EulerOrder {
    /// Every order.
    pub const ALL: [Self; 12] = [
        Self::Xyz,
        Self::Xzy,
        Self::Yxz,
        Self::Yzx,
        Self::Zxy,
        Self::Zyx,
        Self::Xyx,
        Self::Xzx,
        Self::Yxy,
        Self::Yzy,
        Self::Zxz,
        Self::Zyz,
    ];

    /// Returns true if the third axis is the first again (proper Euler angles).
    #[must_use]
    pub const fn is_proper(self) -> bool {
        matches!(self, Self::Xyx | Self::Xzx | Self::Yxy | Self::Yzy | Self::Zxz | Self::Zyz)
    }

    /// Returns true if the first axis, the second and the remaining one form a left-handed frame.
    pub(crate) const fn is_odd(self) -> bool {
        matches!(self, Self::Xzy | Self::Xzx | Self::Yxz | Self::Yxy | Self::Zyx | Self::Zyz)
    }

    /// `x`, `y`, `z` in the order first axis, second axis, the one left over.
    pub(crate) const fn arrange<X: Copy>(self, [x, y, z]: [X; 3]) -> [X; 3] {
        match self {
            Self::Xyz | Self::Xyx => [x, y, z],
            Self::Xzy | Self::Xzx => [x, z, y],
            Self::Yxz | Self::Yxy => [y, x, z],
            Self::Yzx | Self::Yzy => [y, z, x],
            Self::Zxy | Self::Zxz => [z, x, y],
            Self::Zyx | Self::Zyz => [z, y, x],
        }
    }

    /// The inverse of [`arrange`](Self::arrange).
    const fn restore<X: Copy>(self, [a, b, c]: [X; 3]) -> [X; 3] {
        match self {
            Self::Xyz | Self::Xyx => [a, b, c],
            Self::Xzy | Self::Xzx => [a, c, b],
            Self::Yxz | Self::Yxy => [b, a, c],
            Self::Yzx | Self::Yzy => [c, a, b],
            Self::Zxy | Self::Zxz => [b, c, a],
            Self::Zyx | Self::Zyz => [c, b, a],
        }
    }
}

/// Euler angles of an orientation, and whether it is a singular one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Euler<T> {
    /// The three angles, rad, in the order that the function documents.
    pub angles: [T; 3],
    /// True if the first and the third axis coincide (gimbal lock): only the sum or the difference of their angles is
    /// determined. The third angle of the sequence is then 0, and the first one holds all of the turn.
    pub singular: bool,
}

impl<T: Scalar> Pose<T> {
    /// Pose from a position, in the length unit, and three intrinsic Euler angles, rad; in degrees:
    /// [`from_xyz_euler_degrees`](Self::from_xyz_euler_degrees).
    ///
    /// ```
    /// use denhart::{EulerOrder, Pose};
    ///
    /// let zyx = Pose::from_xyz_euler([0.0; 3], EulerOrder::Zyx, [0.3, -0.2, 0.1]);
    /// let rpy = Pose::from_xyz_rpy([0.0; 3], [0.1, -0.2, 0.3]);
    /// assert!(zyx.residual(&rpy).orientation < 1e-15_f64);
    /// ```
    #[must_use]
    pub fn from_xyz_euler(xyz: [T; 3], order: EulerOrder, angles: [T; 3]) -> Self {
        // The axes renamed to x, y, z. Renaming into a left-handed frame turns every angle around.
        let sign = if order.is_odd() { -T::ONE } else { T::ONE };
        let [(sa, ca), (sb, cb), (sc, cc)] = angles.map(|angle| math::sin_cos(sign * angle));
        let renamed = if order.is_proper() {
            [
                [cb, sb * sc, sb * cc],
                [sa * sb, ca * cc - sa * cb * sc, -ca * sc - sa * cb * cc],
                [-ca * sb, sa * cc + ca * cb * sc, ca * cb * cc - sa * sc],
            ]
        } else {
            [
                [cb * cc, -cb * sc, sb],
                [ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb],
                [sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb],
            ]
        };
        Self { rotation: order.restore(renamed.map(|row| order.restore(row))), translation: xyz }
    }

    /// [`from_xyz_euler`](Self::from_xyz_euler) with the angles in degrees.
    #[must_use]
    pub fn from_xyz_euler_degrees(xyz: [T; 3], order: EulerOrder, angles: [T; 3]) -> Self {
        Self::from_xyz_euler(xyz, order, angles.map(math::radians))
    }

    /// Intrinsic Euler angles of the orientation, rad.
    ///
    /// The first and the third angle lie in `[-pi, pi]`; the middle one in `[-pi/2, pi/2]` (three different axes) or
    /// `[0, pi]` (proper Euler angles). At a singular orientation, that is within 16 units of rounding of one, the
    /// third angle is 0 and the result says so. Beside one, the first and the third angle by themselves are as
    /// uncertain as rounding over the distance makes them. Together they fit: [`from_xyz_euler`](Self::from_xyz_euler)
    /// gives the rotation back to rounding (16 units of it where singular). The reason is that each angle is taken from
    /// the matrix with the turn of the one before it undone. Not a number where the rotation is not finite.
    ///
    /// ```
    /// use denhart::{Euler, EulerOrder, Pose};
    ///
    /// let pose = Pose::from_xyz_euler([0.0; 3], EulerOrder::Zyz, [0.3, 0.0, 0.5_f64]);
    /// let Euler { angles: [first, middle, third], singular } = pose.euler(EulerOrder::Zyz);
    /// assert!(singular && (first - 0.8).abs() < 1e-15 && middle == 0.0 && third == 0.0);
    /// ```
    #[must_use]
    pub fn euler(&self, order: EulerOrder) -> Euler<T> {
        let sign = if order.is_odd() { -T::ONE } else { T::ONE };
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = order.arrange(self.rotation.map(|row| order.arrange(row)));
        // Sine and cosine of the third angle, times the cosine (sine) of the middle one, which is not negative.
        let (sin, cos) = if order.is_proper() { (xy, sign * xz) } else { (-sign * xy, xx) };
        let singular = math::hypot(sin, cos) <= T::from_f64(16.0) * T::EPSILON;
        let third = if singular { T::ZERO } else { math::atan2(sin, cos) };
        let (s, c) = math::sin_cos(sign * third);
        // The third turn undone. What is left is Rx(a) Ry(b): its second column is (0, cos a, sin a), its first row
        // (cos b, 0, sin b).
        let (second_y, second_z, cos_b, sin_b) = if order.is_proper() {
            (c * yy - s * yz, c * zy - s * zz, xx, s * xy + c * xz)
        } else {
            (s * yx + c * yy, s * zx + c * zy, c * xx - s * xy, xz)
        };
        let first = math::atan2(sign * second_z, second_y);
        // Adding zero leaves no negative zero. Proper Euler angles have a sine that is not negative, save by rounding.
        let sin_b = sign * sin_b + T::ZERO;
        let sin_b = if order.is_proper() && sin_b < T::ZERO { T::ZERO } else { sin_b };
        let middle = math::atan2(sin_b, cos_b);
        Euler { angles: [first, middle, third], singular }
    }

    /// Roll, pitch, yaw of the orientation, rad: `R = Rz(yaw) Ry(pitch) Rx(roll)`, as
    /// [`from_xyz_rpy`](Self::from_xyz_rpy) takes them.
    ///
    /// The angles of [`EulerOrder::Zyx`] in reverse: roll and yaw in `[-pi, pi]`, pitch in `[-pi/2, pi/2]`. With the x
    /// axis straight up or down (gimbal lock) roll is 0, yaw holds all of the turn, and the result says so.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// let [roll, pitch, yaw] = Pose::from_xyz_rpy([0.0; 3], [0.1, -0.2, 0.3_f64]).rpy().angles;
    /// assert!((roll - 0.1).abs() + (pitch + 0.2).abs() + (yaw - 0.3).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn rpy(&self) -> Euler<T> {
        let Euler { angles: [yaw, pitch, roll], singular } = self.euler(EulerOrder::Zyx);
        Euler { angles: [roll, pitch, yaw], singular }
    }
}
