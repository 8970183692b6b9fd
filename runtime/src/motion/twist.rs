//! Velocity and acceleration of a frame.

use core::fmt;

use crate::math::Scalar;

/// Velocity of a frame that moves in a reference frame, in the coordinates of that reference frame.
///
/// `linear` is the velocity of the origin of the moving frame. So this is the twist of the textbooks at that point, not
/// at the origin of the reference frame. Rates per second give the units named; they scale with any other unit of time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Twist<T> {
    /// Velocity of the moving origin, length unit / s.
    pub linear: [T; 3],
    /// Angular velocity, rad/s: `dR/dt = [w]x R`.
    pub angular: [T; 3],
}

/// Acceleration of a frame that moves in a reference frame, in the coordinates of that reference frame.
///
/// Both parts are plain derivatives of those of [`Twist`]: `linear` is the second derivative of the position of the
/// moving origin, what an accelerometer there would read without gravity. The spatial acceleration of Featherstone 2008
/// is another one: its linear part is less by `w x v`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Acceleration<T> {
    /// Second derivative of the position of the moving origin, length unit / s^2.
    pub linear: [T; 3],
    /// Derivative of the angular velocity, rad/s^2.
    pub angular: [T; 3],
}

macro_rules! six_numbers {
    ($Type:ident) => {
        impl<T: Scalar> $Type<T> {
            /// No motion.
            #[inline]
            #[must_use]
            pub const fn zero() -> Self {
                Self { linear: [T::ZERO; 3], angular: [T::ZERO; 3] }
            }

            /// The linear part above the angular one, `[6]`: the order of the rows of a [`Jacobian`](crate::Jacobian).
            #[inline]
            #[must_use]
            pub const fn to_array(&self) -> [T; 6] {
                let ([x, y, z], [a, b, c]) = (self.linear, self.angular);
                [x, y, z, a, b, c]
            }

            /// Returns true if every number is finite.
            #[inline]
            #[must_use]
            pub fn is_finite(&self) -> bool {
                self.linear.iter().chain(&self.angular).all(|value| value.is_finite())
            }
        }

        impl<T> From<[T; 6]> for $Type<T> {
            #[inline]
            fn from([x, y, z, a, b, c]: [T; 6]) -> Self {
                Self { linear: [x, y, z], angular: [a, b, c] }
            }
        }

        /// `linear [ .. ] angular [ .. ]`. A precision in the format applies to every number; the default is 6 decimals.
        impl<T: fmt::Display> fmt::Display for $Type<T> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let precision = f.precision().unwrap_or(6);
                let ([x, y, z], [a, b, c]) = (&self.linear, &self.angular);
                write!(f, "linear [{x:.precision$}, {y:.precision$}, {z:.precision$}] ")?;
                write!(f, "angular [{a:.precision$}, {b:.precision$}, {c:.precision$}]")
            }
        }
    };
}

six_numbers!(Twist);
six_numbers!(Acceleration);

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    #[test]
    fn the_order_is_that_of_the_jacobian() {
        let twist = Twist::from([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(twist, Twist { linear: [1.0, 2.0, 3.0], angular: [4.0, 5.0, 6.0] });
        assert_eq!(twist.to_array(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(format!("{twist:.1}"), "linear [1.0, 2.0, 3.0] angular [4.0, 5.0, 6.0]");
    }

    #[test]
    fn finite_means_all_of_it() {
        assert!(Acceleration::<f32>::zero().is_finite());
        assert!(!Acceleration { linear: [0.0; 3], angular: [0.0, f64::NAN, 0.0] }.is_finite());
        assert!(!Twist { linear: [0.0, 0.0, f32::INFINITY], angular: [0.0; 3] }.is_finite());
    }
}
