//! Velocity and acceleration of the tool, and the derivative of the Jacobian.

use super::{Acceleration, Twist};
use crate::jacobian::Jacobian;
use crate::math::Scalar;
use crate::vector::{add, cross, scale, sub};

/// A joint's column of the Jacobian, with its rate and the rate's derivative.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Joint<T> {
    /// Velocity of the tool point per unit rate.
    pub v: [T; 3],
    /// Angular velocity per unit rate.
    pub w: [T; 3],
    /// Rate.
    pub qd: T,
    /// Derivative of the rate.
    pub qdd: T,
}

/// `J qd`
#[inline]
pub(crate) fn velocity<T: Scalar>(joints: impl Iterator<Item = Joint<T>>) -> Twist<T> {
    joints.fold(Twist::zero(), |sum, Joint { v, w, qd, .. }| sum.plus(scale(qd, v), scale(qd, w)))
}

/// `J qdd + dJ/dt qd`
///
/// In `dJ/dt qd` every product `w_j x v_i` with `j < i` occurs twice, from either column, and that with `j = i` once:
/// `sum_i qd_i (W_{i-1} + W_i) x v_i` with `W_i` the angular velocity of link i.
#[inline]
pub(crate) fn acceleration<T: Scalar>(joints: impl Iterator<Item = Joint<T>>) -> Acceleration<T> {
    let mut total = Acceleration::zero();
    let mut before = [T::ZERO; 3];
    for Joint { v, w, qd, qdd } in joints {
        let turn = scale(qd, w);
        let after = add(before, turn);
        let centripetal = cross(add(before, after), scale(qd, v));
        total.linear = add(total.linear, add(scale(qdd, v), centripetal));
        total.angular = add(total.angular, add(scale(qdd, w), cross(before, turn)));
        before = after;
    }
    total
}

/// Columns `(dv_i/dt, dw_i/dt)` in order: `W_{i-1} x v_i + w_i x V_{>=i}` and `W_{i-1} x w_i`, with `V_{>=i}` the
/// velocity of the tool point by joint i and those behind it.
#[inline]
pub(crate) fn derivative<T: Scalar>(
    joints: impl Iterator<Item = Joint<T>> + Clone,
) -> impl Iterator<Item = ([T; 3], [T; 3])> {
    let Twist { linear, .. } = velocity(joints.clone());
    joints.scan(([T::ZERO; 3], linear), |(before, behind), Joint { v, w, qd, .. }| {
        let column = (add(cross(*before, v), cross(w, *behind)), cross(*before, w));
        *before = add(*before, scale(qd, w));
        *behind = sub(*behind, scale(qd, v));
        Some(column)
    })
}

impl<T: Scalar> Twist<T> {
    #[inline]
    pub(super) fn plus(self, linear: [T; 3], angular: [T; 3]) -> Self {
        Self { linear: add(self.linear, linear), angular: add(self.angular, angular) }
    }
}

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// The columns with their rates.
    #[inline]
    pub(super) fn joints(&self, qd: &[T; N], qdd: &[T; N]) -> impl Iterator<Item = Joint<T>> + Clone {
        let [vx, vy, vz, wx, wy, wz] = &self.rows;
        let linear = vx.iter().zip(vy).zip(vz).map(|((x, y), z)| [*x, *y, *z]);
        let angular = wx.iter().zip(wy).zip(wz).map(|((x, y), z)| [*x, *y, *z]);
        let rates = qd.iter().zip(qdd);
        linear.zip(angular).zip(rates).map(|((v, w), (qd, qdd))| Joint { v, w, qd: *qd, qdd: *qdd })
    }

    /// Velocity of the tool, `J qd`, in the base frame, for joint rates `qd` `[N]` (rad/s or length unit / s).
    ///
    /// ```
    /// use denhart::{Jacobian, Twist};
    ///
    /// // One revolute joint about z, the tool 0.5 ahead of it along x.
    /// let jacobian = Jacobian { rows: [[0.0], [0.5], [0.0], [0.0], [0.0], [1.0]] };
    /// let twist = jacobian.velocity(&[2.0]);
    /// assert_eq!(twist, Twist { linear: [0.0, 1.0, 0.0], angular: [0.0, 0.0, 2.0] });
    /// // On its circle the tool is drawn to the axis by v^2 / r.
    /// assert_eq!(jacobian.acceleration(&[2.0], &[0.0]).linear, [-2.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn velocity(&self, qd: &[T; N]) -> Twist<T> {
        Twist::from(self.mul(qd))
    }

    /// Acceleration of the tool, `J qdd + dJ/dt qd`, in the base frame, for joint rates `qd` `[N]` and their
    /// derivatives `qdd` `[N]`.
    ///
    /// The linear part is the second derivative of the position of the tool point, see [`Acceleration`]. It takes a
    /// pass over the columns; the derivative of the Jacobian is not formed.
    #[inline]
    #[must_use]
    pub fn acceleration(&self, qd: &[T; N], qdd: &[T; N]) -> Acceleration<T> {
        acceleration(self.joints(qd, qdd))
    }

    /// Derivative of the Jacobian by time, `[6, N]`, for joint rates `qd` `[N]`.
    ///
    /// `self` has to be a geometric Jacobian in a frame at rest, at the tool point, of a serial arm. The derivative
    /// follows from its columns alone (Haviland and Corke 2020). See the source of this module for the derivation,
    /// prismatic joints included.
    #[inline]
    #[must_use]
    pub fn derivative(&self, qd: &[T; N]) -> Self {
        let mut rows = [[T::ZERO; N]; 6];
        let [vx, vy, vz, wx, wy, wz] = &mut rows;
        let linear = vx.iter_mut().zip(vy).zip(vz);
        let angular = wx.iter_mut().zip(wy).zip(wz);
        for ((((vx, vy), vz), ((wx, wy), wz)), (v, w)) in linear.zip(angular).zip(derivative(self.joints(qd, qd))) {
            [*vx, *vy, *vz] = v;
            [*wx, *wy, *wz] = w;
        }
        Self { rows }
    }

    /// Returns the Jacobian with its columns given in another frame, by the rotation of that frame, `R^T v` and
    /// `R^T w`.
    ///
    /// The point whose velocity the Jacobian gives stays. With the rotation of the tool the result is the Jacobian of
    /// the tool frame. Its product with the joint rates is the velocity of the tool point and the angular velocity in
    /// the axes of the tool.
    #[inline]
    #[must_use]
    pub fn in_frame(&self, rotation: &[[T; 3]; 3]) -> Self {
        let [x, y, z, a, b, c] = &self.rows;
        let [linear, angular] = [[x, y, z], [a, b, c]].map(|rows| transposed_times(rotation, rows));
        let ([x, y, z], [a, b, c]) = (linear, angular);
        Self { rows: [x, y, z, a, b, c] }
    }
}

/// `R^T` times three rows.
#[inline]
fn transposed_times<T: Scalar, const N: usize>([r0, r1, r2]: &[[T; 3]; 3], rows: [&[T; N]; 3]) -> [[T; N]; 3] {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = [r0, r1, r2];
    let [x, y, z] = rows;
    [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]].map(|[a, b, c]| {
        let mut row = [T::ZERO; N];
        for (entry, ((x, y), z)) in row.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *entry = *a * *x + *b * *y + *c * *z;
        }
        row
    })
}
