//! Position and orientation of one frame in another.

use core::fmt;
use core::ops::Mul;

use crate::math::{self, Scalar};
use crate::solution::Residual;
use crate::vector::{dot, norm, sub};

/// A pose: rotation and translation, the homogeneous transform `[R p; 0 1]`.
///
/// It maps coordinates in the moving frame to coordinates in the reference frame: `x_ref = R x + p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose<T> {
    /// Rotation matrix, dimensionless, `rotation[row][column]`.
    pub rotation: [[T; 3]; 3],
    /// Origin of the moving frame in the reference frame, in the arm's length unit.
    pub translation: [T; 3],
}

impl<T: Scalar> Pose<T> {
    /// The pose of a frame in itself.
    #[inline]
    #[must_use]
    pub const fn identity() -> Self {
        let (i, o) = (T::ONE, T::ZERO);
        Self { rotation: [[i, o, o], [o, i, o], [o, o, i]], translation: [o, o, o] }
    }

    /// Pose from a position and fixed-axis angles in rad: `R = Rz(yaw) Ry(pitch) Rx(roll)`.
    ///
    /// `xyz` in the length unit; `rpy` = roll, pitch, yaw in rad. In degrees:
    /// [`from_xyz_rpy_degrees`](Self::from_xyz_rpy_degrees).
    #[inline]
    #[must_use]
    pub fn from_xyz_rpy(xyz: [T; 3], rpy: [T; 3]) -> Self {
        let [(sr, cr), (sp, cp), (sy, cy)] = rpy.map(math::sin_cos);
        Self {
            rotation: [
                [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                [-sp, cp * sr, cp * cr],
            ],
            translation: xyz,
        }
    }

    /// [`from_xyz_rpy`](Self::from_xyz_rpy) with roll, pitch, yaw in degrees.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// let down = Pose::from_xyz_rpy_degrees([0.3, 0.0, 0.2_f64], [180.0, 0.0, 90.0]);
    /// assert!((down.rotation[2][2] + 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_xyz_rpy_degrees(xyz: [T; 3], rpy: [T; 3]) -> Self {
        Self::from_xyz_rpy(xyz, rpy.map(math::radians))
    }

    /// The product `self * rhs`: the pose `rhs`, given in the frame `self`, seen from the reference frame of `self`.
    #[inline]
    #[must_use]
    pub fn compose(&self, rhs: &Self) -> Self {
        let [x, y, z] = columns(&rhs.rotation).map(|axis| self.rotate(&axis));
        Self { rotation: columns(&[x, y, z]), translation: self.transform_point(&rhs.translation) }
    }

    /// The inverse transform `[R^T  -R^T p; 0 1]`.
    ///
    /// The transpose stands for the inverse of `R`, so it is exact to the degree to which `R` is orthonormal.
    #[inline]
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = columns(&self.rotation);
        Self { rotation, translation: rotation.map(|row| -dot(row, self.translation)) }
    }

    /// A point given in the moving frame, in the reference frame: `R x + p`. Both in the length unit.
    #[inline]
    #[must_use]
    pub fn transform_point(&self, point: &[T; 3]) -> [T; 3] {
        let [x, y, z] = self.rotate(point);
        let [px, py, pz] = self.translation;
        [x + px, y + py, z + pz]
    }

    /// How far `other` is from `self`: the distance of the origins, and the angle of the rotation between the frames.
    ///
    /// The angle lies in `[0, pi]`. It is the `atan2` of the axis vector and the trace of `R1^T R2`. The axis vector is
    /// formed from `R2 - R1`, so that an angle of 1e-16 rad comes out as such. An arc cosine loses everything below
    /// 1e-8. Where the matrices deviate from rotations by `delta`, an angle `theta` is off by at most the order of
    /// `delta * theta + delta^2`. The deviation itself is not part of the angle. Not finite when a pose is not.
    #[must_use]
    pub fn residual(&self, other: &Self) -> Residual<T> {
        let [ax, ay, az] = self.translation;
        let [bx, by, bz] = other.translation;
        let position = norm([bx - ax, by - ay, bz - az]);

        let [r0, r1, r2] = self.rotation;
        let [s0, s1, s2] = other.rotation;
        let [x1, y1, z1] = columns(&self.rotation);
        let [x2, y2, z2] = columns(&other.rotation);
        // R1^T R1 is symmetric, so R1^T (R2 - R1) has the skew part of R1^T R2, without its cancellation.
        let [dx, dy, dz] = columns(&[sub(s0, r0), sub(s1, r1), sub(s2, r2)]);
        let axis = [dot(z1, dy) - dot(y1, dz), dot(x1, dz) - dot(z1, dx), dot(y1, dx) - dot(x1, dy)];
        let trace = dot(x1, x2) + dot(y1, y2) + dot(z1, z2);
        // The axis vector has length 2 sin(theta), and the trace is 1 + 2 cos(theta).
        Residual { position, orientation: math::atan2(norm(axis), trace - T::ONE) }
    }

    /// Distance of the matrix from a rotation, of the order of the Frobenius distance to the nearest rotation. The
    /// parts are the lengths of the columns x and y less 1, their dot product, and the difference of z from their cross
    /// product.
    #[inline]
    pub(crate) fn deviation(&self) -> T {
        self.squared_deviation().sqrt()
    }

    /// Square of [`deviation`](Self::deviation).
    #[inline]
    pub(crate) fn squared_deviation(&self) -> T {
        let [[a, d, g], [b, e, h], [c, f, i]] = self.rotation;
        let unit_x = T::HALF * (a * a + b * b + c * c - T::ONE);
        let unit_y = T::HALF * (d * d + e * e + f * f - T::ONE);
        let right = a * d + b * e + c * f;
        let [u, v, w] = [b * f - c * e - g, c * d - a * f - h, a * e - b * d - i];
        let squares = unit_x * unit_x + unit_y * unit_y + right * right;
        squares + u * u + v * v + w * w
    }

    /// Returns true if every entry is finite.
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let Self { rotation: [x, y, z], translation } = self;
        // 0 for a finite number, else not a number; without a branch.
        let nought = |row: &[T; 3]| row.iter().fold(T::ZERO, |sum, value| sum + *value * T::ZERO);
        nought(x) + nought(y) + nought(z) + nought(translation) == T::ZERO
    }

    #[inline]
    fn rotate(&self, vector: &[T; 3]) -> [T; 3] {
        let [x, y, z] = &self.rotation;
        [dot(*x, *vector), dot(*y, *vector), dot(*z, *vector)]
    }
}

impl<T: Scalar> Default for Pose<T> {
    fn default() -> Self {
        Self::identity()
    }
}

impl<T: Scalar> Mul for Pose<T> {
    type Output = Self;

    #[inline]
    fn mul(self, rhs: Self) -> Self {
        self.compose(&rhs)
    }
}

/// Three lines `[ r r r | p ]`. A precision in the format applies to every entry; the default is 6 decimals.
impl<T: fmt::Display> fmt::Display for Pose<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision().unwrap_or(6);
        let (narrow, wide) = (precision + 4, precision + 7);
        for (index, ([x, y, z], p)) in self.rotation.iter().zip(&self.translation).enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            write!(f, "[{x:narrow$.precision$}{y:narrow$.precision$}{z:narrow$.precision$} |{p:wide$.precision$} ]")?;
        }
        Ok(())
    }
}

/// The transpose: the columns of a matrix given by rows.
#[inline]
fn columns<T: Copy>([[a, b, c], [d, e, f], [g, h, i]]: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    [[*a, *d, *g], [*b, *e, *h], [*c, *f, *i]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    const TURN: Pose<f64> =
        Pose { rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], translation: [1.0, 2.0, 3.0] };

    #[test]
    fn a_quarter_turn_moves_points_and_frames() {
        assert_eq!(TURN.transform_point(&[1.0, 0.0, 0.5]), [1.0, 3.0, 3.5]);
        let twice = TURN * TURN;
        assert_eq!(twice.rotation, [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(twice.translation, [-1.0, 3.0, 6.0]);
        assert_eq!(TURN.compose(&Pose::identity()), TURN);
        assert_eq!(Pose::identity().compose(&TURN), TURN);
    }

    #[test]
    fn inverse_undoes() {
        assert_eq!(TURN.inverse().translation, [-2.0, 1.0, -3.0]);
        assert_eq!(TURN.inverse() * TURN, Pose::identity());
        let pose = Pose::from_xyz_rpy([0.3, -0.2, 0.9], [0.4, -1.1, 2.5]);
        let gap = Pose::identity().residual(&(pose * pose.inverse()));
        assert!(gap.position < 4e-16 && gap.orientation < 4e-16, "{gap:?}");
    }

    #[test]
    fn rpy_turns_about_fixed_axes_in_the_order_roll_pitch_yaw() {
        let rpy = [0.3, -0.8, 1.9];
        let about = |axis: usize| {
            let mut angles = [0.0; 3];
            if let (Some(to), Some(from)) = (angles.get_mut(axis), rpy.get(axis)) {
                *to = *from;
            }
            Pose::from_xyz_rpy([0.0; 3], angles)
        };
        let gap = (about(2) * about(1) * about(0)).residual(&Pose::from_xyz_rpy([0.0; 3], rpy));
        assert!(gap.orientation < 4e-16, "{gap:?}");
        let (s, c) = (0.3_f64.sin(), 0.3_f64.cos());
        let roll = about(0).rotation;
        for (row, expected) in roll.iter().zip([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]) {
            for (value, expected) in row.iter().zip(expected) {
                assert!((value - expected).abs() < 4e-16, "{roll:?}");
            }
        }
    }

    #[test]
    fn angles_in_degrees_are_converted_once() {
        let (xyz, degrees) = ([0.1, -0.2, 0.3], [90.0, -45.0, 12.5]);
        let rad = [core::f64::consts::FRAC_PI_2, -core::f64::consts::FRAC_PI_4, 12.5_f64.to_radians()];
        assert_eq!(Pose::from_xyz_rpy_degrees(xyz, degrees), Pose::from_xyz_rpy(xyz, rad));
        let single = Pose::from_xyz_rpy_degrees([0.0_f32; 3], [0.0, 0.0, -90.0]);
        assert_eq!(single, Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, -core::f32::consts::FRAC_PI_2]));
        assert!(!Pose::from_xyz_rpy_degrees(xyz, [f64::NAN, 0.0, 0.0]).is_finite());
    }

    #[test]
    fn residual_angle_is_accurate_from_tiny_to_half_a_turn() {
        let start = Pose::from_xyz_rpy([0.1, 0.2, 0.3], [0.7, -0.4, 2.0]);
        for angle in [1e-300, 1e-100] {
            // Squares of such angles underflow: the result must still be small, not NaN.
            let gap = Pose::identity().residual(&Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, angle]));
            assert!(gap.orientation <= 2.0 * angle, "{gap:?}");
        }
        for angle in [1e-16, 1e-12, 1e-9, 1e-8, 1e-4, 1.0, 3.0, core::f64::consts::PI - 1e-9, core::f64::consts::PI] {
            let turn = Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, angle]);
            let plain = Pose::identity().residual(&turn).orientation;
            assert!((plain - angle).abs() <= 4e-16 * angle, "{angle}: {plain}");
            // Seen from a general frame the entries themselves are rounded: a few 1e-16 absolute.
            let turned = start.residual(&(start * turn)).orientation;
            assert!((turned - angle).abs() < 1e-15, "{angle}: {turned}");
        }
        assert_eq!(start.residual(&start), Residual::ZERO);
    }

    #[test]
    fn residual_ignores_a_slight_deviation_from_a_rotation() {
        let mut worn = TURN;
        for entry in worn.rotation.iter_mut().flatten() {
            *entry *= 1.0 + 1e-7;
        }
        worn.translation = [1.0, 5.0, 7.0];
        let gap = TURN.residual(&worn);
        assert_eq!(gap.position, 5.0);
        assert!(gap.orientation < 1e-15, "{gap:?}");
    }

    #[test]
    fn single_precision_too() {
        let turn = Pose::<f32>::from_xyz_rpy([0.0, 3.0, 4.0], [1e-7, 0.0, 0.0]);
        let gap = Pose::identity().residual(&turn);
        assert_eq!(gap.position, 5.0);
        assert!((gap.orientation - 1e-7).abs() < 1e-13);
    }

    #[test]
    fn not_finite_is_seen() {
        assert!(TURN.is_finite());
        let mut bad = TURN;
        bad.translation = [0.0, f64::NAN, 0.0];
        assert!(!bad.is_finite());
        assert!(TURN.residual(&bad).position.is_nan());
        bad = TURN;
        bad.rotation = [[f64::INFINITY; 3]; 3];
        assert!(!bad.is_finite());
    }

    #[test]
    fn display_is_a_matrix() {
        assert_eq!(
            format!("{TURN:.2}"),
            "[  0.00 -1.00  0.00 |     1.00 ]\n[  1.00  0.00  0.00 |     2.00 ]\n[  0.00  0.00  1.00 |     3.00 ]"
        );
    }
}
