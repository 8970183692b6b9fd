//! The methods of a generated arm that follow from its pose and Jacobian.

/// Inherent methods of an arm, beside its own `forward_and_jacobian`, `jacobian` and `link_poses`; `unit`: its length
/// unit, for the docs.
#[doc(hidden)]
#[macro_export]
macro_rules! motion_methods {
    ($scalar:ty, $n:literal, $unit:literal) => {
        #[doc = ::core::concat!("Velocity of the tool point (", $unit, "/s) and angular velocity (rad/s) in the base frame, for rates `qd`: `J qd`.")]
        #[inline]
        #[must_use]
        pub fn velocity(&self, q: &[$scalar; $n], qd: &[$scalar; $n]) -> $crate::Twist<$scalar> {
            self.jacobian(q).velocity(qd)
        }
        #[doc = ::core::concat!("Second derivative of the tool point (", $unit, "/s^2), derivative of the angular velocity: `J qdd + dJ/dt qd`.")]
        #[inline]
        #[must_use]
        pub fn acceleration(
            &self,
            q: &[$scalar; $n],
            qd: &[$scalar; $n],
            qdd: &[$scalar; $n],
        ) -> $crate::Acceleration<$scalar> {
            self.jacobian(q).acceleration(qd, qdd)
        }
        /// Derivative by time of [`Self::jacobian`], for rates `qd`.
        #[must_use]
        pub fn jacobian_dot(&self, q: &[$scalar; $n], qd: &[$scalar; $n]) -> $crate::Jacobian<$scalar, $n> {
            self.jacobian(q).derivative(qd)
        }
        /// Geometric Jacobian of the tool point in the axes of the tool.
        #[must_use]
        pub fn jacobian_tool(&self, q: &[$scalar; $n]) -> $crate::Jacobian<$scalar, $n> {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.in_frame(&tool.rotation)
        }
        /// Velocities of the frames of [`Self::link_poses`] in the base frame, each at its own origin.
        #[must_use]
        pub fn link_velocities(&self, q: &[$scalar; $n], qd: &[$scalar; $n]) -> [$crate::Twist<$scalar>; $n] {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.link_velocities(&tool, &self.link_poses(q), qd)
        }
        /// Accelerations of the same frames.
        #[must_use]
        pub fn link_accelerations(
            &self,
            q: &[$scalar; $n],
            qd: &[$scalar; $n],
            qdd: &[$scalar; $n],
        ) -> [$crate::Acceleration<$scalar>; $n] {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.link_accelerations(&tool, &self.link_poses(q), qd, qdd)
        }
    };
}
