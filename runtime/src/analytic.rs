//! The analytic Jacobian: rates of coordinates of the orientation instead of angular velocities.

use crate::jacobian::Jacobian;
use crate::math::{self, Scalar};
use crate::orientation::EulerOrder;

/// Rates of position and of `M` coordinates of the orientation per unit joint rate, in the base frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnalyticJacobian<T, const M: usize, const N: usize> {
    /// Rates of the tool point, `[3, N]`, length unit: the linear rows of the geometric Jacobian.
    pub position: [[T; N]; 3],
    /// Rates of the coordinates of the orientation in their order, `[M, N]`: rad, or no unit for a quaternion.
    pub orientation: [[T; N]; M],
    /// How far the coordinates are from their own singularity, 0 to 1: the absolute determinant of the map from their
    /// rates to the angular velocity. For three different axes (roll, pitch, yaw) the margin is `|cos|` of the middle
    /// angle. Where the first axis returns (ZYZ), the margin is `|sin|` of that angle. The margin is 1 for a
    /// quaternion, which has no singularity. The rates grow as the inverse of the margin.
    pub margin: T,
    /// True if the margin is zero to rounding (up to 16 units of it).
    ///
    /// One direction of the angular velocity then has no rates: the direction at right angles to the two remaining
    /// axes. The rates are those of the other components, of least norm (the Moore-Penrose inverse).
    pub singular: bool,
}

impl<T: Scalar, const M: usize, const N: usize> AnalyticJacobian<T, M, N> {
    /// Velocity of the tool point `[3]` and rates of the orientation's coordinates `[M]`, for joint rates `qd` `[N]`.
    #[inline]
    #[must_use]
    pub fn mul(&self, qd: &[T; N]) -> ([T; 3], [T; M]) {
        let times = |row: &[T; N]| row.iter().zip(qd).fold(T::ZERO, |sum, (entry, rate)| sum + *entry * *rate);
        (self.position.each_ref().map(times), self.orientation.each_ref().map(times))
    }
}

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// Rates of roll, pitch and yaw, rows in this order, at the angles `[roll, pitch, yaw]`, rad, of
    /// `R = Rz(yaw) Ry(pitch) Rx(roll)`. Singular at a pitch of +-90 degrees. The roll has no effect; not finite where
    /// another angle or an entry is not.
    ///
    /// ```
    /// use denhart::Jacobian;
    ///
    /// // A joint about the base's z axis turns the yaw and nothing else.
    /// let jacobian = Jacobian { rows: [[0.0], [0.0], [0.0], [0.0], [0.0], [1.0]] };
    /// let analytic = jacobian.analytic_rpy([0.1, -0.2, 0.3_f64]);
    /// assert!(!analytic.singular && (analytic.margin - 0.2_f64.cos()).abs() < 1e-15);
    /// let (_, [roll, pitch, yaw]) = analytic.mul(&[2.0]);
    /// assert!(roll.abs() + pitch.abs() + (yaw - 2.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn analytic_rpy(&self, [roll, pitch, yaw]: [T; 3]) -> AnalyticJacobian<T, 3, N> {
        let analytic = self.analytic_euler(EulerOrder::Zyx, [yaw, pitch, roll]);
        let [yaw, pitch, roll] = analytic.orientation;
        AnalyticJacobian { orientation: [roll, pitch, yaw], ..analytic }
    }

    /// Rates of intrinsic Euler angles, rows in the order of the sequence, at the three `angles`, rad; `EulerOrder::Zyz`
    /// for ZYZ. The third angle has no effect. Singular where the first and the third axis coincide.
    ///
    /// The angular velocity is the sum of the rates along the three axes, of which the second is at right angles to
    /// both others. So the second rate is a projection, and the other two follow in the plane at right angles to the
    /// second axis. Source: Siciliano et al. 2009, "Robotics", section 3.6, for ZYZ.
    #[must_use]
    pub fn analytic_euler(&self, order: EulerOrder, angles: [T; 3]) -> AnalyticJacobian<T, 3, N> {
        // The axes renamed to x, y, z. Into a left-handed frame that turns every angle around, and every angular
        // velocity, so that rates stay.
        let sign = if order.is_odd() { -T::ONE } else { T::ONE };
        let [first, middle, _] = angles;
        let ((sa, ca), (sb, cb)) = (math::sin_cos(sign * first), math::sin_cos(sign * middle));
        // The third axis, seen after the first turn: `along` the first axis and `across` it.
        let (along, across) = if order.is_proper() { (cb, -sb) } else { (sb, cb) };
        let singular = across.abs() <= T::from_f64(16.0) * T::EPSILON;
        let [x, y, z, wx, wy, wz] = &self.rows;
        let [wx, wy, wz] = order.arrange([wx, wy, wz]);
        let mut orientation = [[T::ZERO; N]; 3];
        let [a, b, c] = &mut orientation;
        for (((a, b), c), ((x, y), z)) in a.iter_mut().zip(b).zip(c).zip(wx.iter().zip(wy).zip(wz)) {
            let (x, y, z) = (*x, *y, *z);
            *b = ca * y + sa * z;
            (*a, *c) = if singular {
                // Both axes along x: the smallest rates that turn as much.
                (T::HALF * x, along * T::HALF * x)
            } else {
                let rate = (ca * z - sa * y) / across;
                (x - along * rate, rate)
            };
        }
        AnalyticJacobian { position: [*x, *y, *z], orientation, margin: across.abs(), singular }
    }

    /// Rates of a quaternion, rows `w x y z`, at the unit quaternion `[w, x, y, z]`, scalar part first.
    ///
    /// Half the product of the angular velocity and the quaternion: `dw/dt = -(w . v) / 2`, `dv/dt = (s w + w x v) / 2`
    /// for the angular velocity `w`, scalar part `s` and vector part `v`. Never singular; the rates keep the
    /// length of the quaternion. The negative quaternion has the negative rates.
    #[must_use]
    pub fn analytic_quaternion(&self, [s, i, j, k]: [T; 4]) -> AnalyticJacobian<T, 4, N> {
        let [x, y, z, wx, wy, wz] = &self.rows;
        let mut orientation = [[T::ZERO; N]; 4];
        let [ds, di, dj, dk] = &mut orientation;
        let rates = ds.iter_mut().zip(di).zip(dj.iter_mut().zip(dk));
        for (((ds, di), (dj, dk)), ((x, y), z)) in rates.zip(wx.iter().zip(wy).zip(wz)) {
            let (x, y, z) = (*x * T::HALF, *y * T::HALF, *z * T::HALF);
            *ds = -(x * i + y * j + z * k);
            *di = s * x + (y * k - z * j);
            *dj = s * y + (z * i - x * k);
            *dk = s * z + (x * j - y * i);
        }
        AnalyticJacobian { position: [*x, *y, *z], orientation, margin: T::ONE, singular: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;

    /// Columns that are the axes: the rates of the angles for a turn about each axis.
    fn axes<T: Scalar>() -> Jacobian<T, 3> {
        let (o, i) = (T::ZERO, T::ONE);
        Jacobian { rows: [[o; 3], [o; 3], [o; 3], [i, o, o], [o, i, o], [o, o, i]] }
    }

    const ANGLES: [[f64; 3]; 4] = [[0.3, -0.4, 1.1], [2.9, 1.2, -2.2], [-0.8, 2.5, 0.2], [0.0, 0.6, 0.0]];

    /// Entries of the rotation, three rates each.
    fn entries(pose: &Pose<f64>) -> [f64; 9] {
        let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
        [a, b, c, d, e, f, g, h, i]
    }

    /// Turning by the rates changes the rotation as the angular velocity does, `dR/dt = [w]x R`. Central differences of
    /// step 1e-5: off by 1e-10 times third derivatives, which the margin here keeps below 20, and 1e-11 by rounding.
    fn check(rates: [[f64; 3]; 3], at: impl Fn(f64, [f64; 3]) -> Pose<f64>) {
        for (axis, rates) in [0, 1, 2].map(|axis| (axis, rates.map(|row| row[axis]))) {
            let h = 1e-5;
            let [before, after] = [-h, h].map(|h| entries(&at(h, rates)));
            let mut w = [0.0; 3];
            w[axis] = 1.0;
            let r = at(0.0, rates).rotation;
            let column = |j: usize| crate::vector::cross(w, [0, 1, 2].map(|i| r[i][j]));
            for (j, expected) in [0, 1, 2].map(|j| (j, column(j))) {
                for i in 0..3 {
                    let found = (after[3 * i + j] - before[3 * i + j]) / (2.0 * h);
                    assert!((found - expected[i]).abs() < 2e-9, "axis {axis}, entry {i} {j}: {found} {}", expected[i]);
                }
            }
        }
    }

    #[test]
    fn euler_rates_turn_as_the_angular_velocity() {
        for order in EulerOrder::ALL {
            for angles in ANGLES {
                let analytic = axes().analytic_euler(order, angles);
                assert!(!analytic.singular);
                let expected = if order.is_proper() { angles[1].sin() } else { angles[1].cos() };
                assert!((analytic.margin - expected.abs()).abs() < 1e-15, "{order:?}");
                check(analytic.orientation, |h, rates| {
                    let moved = [0, 1, 2].map(|k| angles[k] + h * rates[k]);
                    Pose::from_xyz_euler([0.0; 3], order, moved)
                });
            }
        }
    }

    #[test]
    fn rates_of_roll_pitch_and_yaw() {
        for rpy in ANGLES {
            check(axes().analytic_rpy(rpy).orientation, |h, rates| {
                Pose::from_xyz_rpy([0.0; 3], [0, 1, 2].map(|k| rpy[k] + h * rates[k]))
            });
        }
    }

    #[test]
    fn rates_of_a_quaternion() -> Result<(), &'static str> {
        for rpy in ANGLES {
            let q = Pose::from_xyz_rpy([0.0; 3], rpy).quaternion();
            let analytic = axes().analytic_quaternion(q);
            assert_eq!((analytic.margin, analytic.singular), (1.0, false));
            for axis in 0..3 {
                let rates = analytic.orientation.map(|row| row[axis]);
                // The length stays.
                let change: f64 = rates.iter().zip(q).map(|(a, b)| a * b).sum();
                assert!(change.abs() < 1e-16, "{change:e}");
                let h = 1e-5;
                let at = |h: f64| {
                    let moved = [0, 1, 2, 3].map(|k| q[k] + h * rates[k]);
                    Pose::from_xyz_quaternion([0.0; 3], moved).ok_or("no quaternion")
                };
                let (before, after) = (at(-h)?, at(h)?);
                let found = before.error_to(&after).map(|x| x / (2.0 * h));
                let mut expected = [0.0; 6];
                expected[3 + axis] = 1.0;
                assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
            }
        }
        Ok(())
    }

    /// The angular velocity that the rates at a singular orientation give, by the axes of the sequence.
    #[test]
    fn a_singular_orientation_is_reported_and_stays_finite() {
        let quarter = core::f64::consts::FRAC_PI_2;
        for order in EulerOrder::ALL {
            let middles = if order.is_proper() { [0.0, core::f64::consts::PI] } else { [quarter, -quarter] };
            for middle in middles {
                let analytic = axes::<f64>().analytic_euler(order, [0.7, middle, -0.2]);
                assert!(analytic.singular && analytic.margin < 2e-16, "{order:?} {analytic:?}");
                assert!(analytic.orientation.as_flattened().iter().all(|x| x.abs() <= 1.0));
                // Near it the rates are large, of their own size, and their turn is right.
                let near = axes::<f64>().analytic_euler(order, [0.7, middle + 1e-6, -0.2]);
                assert!(!near.singular && (near.margin / 1e-6 - 1.0).abs() < 1e-9, "{near:?}");
                let most = near.orientation.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                assert!((1e5..1.1e6).contains(&most), "{most:e}");
            }
        }
        // Roll and yaw share a turn about the common axis, the pitch is as ever.
        let analytic = axes().analytic_rpy([0.0, quarter, 0.0]);
        assert_eq!(analytic.orientation, [[0.0, 0.0, -0.5], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]]);
        let single = axes().analytic_rpy([0.0, core::f32::consts::FRAC_PI_2, 0.0]);
        assert!(single.singular && single.orientation.as_flattened().iter().all(|x| x.is_finite()));
    }

    #[test]
    fn not_finite_in_not_finite_out() {
        for angles in [[0.1, f64::INFINITY, 0.1], [0.1, 0.1, f64::NAN]] {
            let analytic = axes().analytic_rpy(angles);
            assert!(analytic.orientation.as_flattened().iter().any(|x| x.is_nan()), "{angles:?}");
        }
    }
}
