//! Velocities and accelerations of the links.

use super::{Acceleration, Twist};
use crate::jacobian::Jacobian;
use crate::math::Scalar;
use crate::pose::Pose;
use crate::vector::{add, cross, scale, sub};

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// Velocities of the link frames `[N]` in the base frame, each at the frame's own origin, for joint rates `qd` `[N]`.
    ///
    /// `tool` is the pose that the Jacobian belongs to, `links` are the poses of the links at the same joint values.
    /// The columns of the joints up to link i, each times its rate, sum up to the velocity of its body at the tool
    /// point. That velocity, shifted to the link's origin by `w x (p_i - p)`, is the velocity of the frame.
    #[must_use]
    pub fn link_velocities(&self, tool: &Pose<T>, links: &[Pose<T>; N], qd: &[T; N]) -> [Twist<T>; N] {
        let mut twists = [Twist::zero(); N];
        // The body's velocity at the tool point.
        let mut body = Twist::zero();
        for ((twist, link), joint) in twists.iter_mut().zip(links).zip(self.joints(qd, qd)) {
            body = body.plus(scale(joint.qd, joint.v), scale(joint.qd, joint.w));
            let arm = sub(link.translation, tool.translation);
            *twist = Twist { linear: add(body.linear, cross(body.angular, arm)), angular: body.angular };
        }
        twists
    }

    /// Accelerations of the link frames `[N]` in the base frame, each at the frame's own origin. The joint rates are
    /// `qd` `[N]`, and `qdd` `[N]` are their derivatives; `tool` and `links` as in
    /// [`link_velocities`](Self::link_velocities).
    ///
    /// The derivative of the same sum: `a_i = dV_i/dt + dw_i/dt x (p_i - p) + w_i x (v_i - v)`. `V_i` is the velocity of
    /// body i at the tool point `p`, which itself moves with the tool. Each linear part is the second derivative of the
    /// position of the link's origin.
    #[must_use]
    pub fn link_accelerations(
        &self,
        tool: &Pose<T>,
        links: &[Pose<T>; N],
        qd: &[T; N],
        qdd: &[T; N],
    ) -> [Acceleration<T>; N] {
        let mut accelerations = [Acceleration::zero(); N];
        let velocity = self.velocity(qd).linear;
        // The body's velocity at the tool point.
        let mut body = Twist::zero();
        // Its derivative.
        let mut change = Twist::zero();
        let columns = self.joints(qd, qdd).zip(super::tool::derivative(self.joints(qd, qdd)));
        for ((acceleration, link), (joint, (dv, dw))) in accelerations.iter_mut().zip(links).zip(columns) {
            body = body.plus(scale(joint.qd, joint.v), scale(joint.qd, joint.w));
            change = change.plus(scale(joint.qdd, joint.v), scale(joint.qdd, joint.w));
            change = change.plus(scale(joint.qd, dv), scale(joint.qd, dw));
            let arm = sub(link.translation, tool.translation);
            let relative = sub(add(body.linear, cross(body.angular, arm)), velocity);
            let shift = add(cross(change.angular, arm), cross(body.angular, relative));
            *acceleration = Acceleration { linear: add(change.linear, shift), angular: change.angular };
        }
        accelerations
    }
}
