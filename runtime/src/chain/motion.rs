//! Velocity and acceleration of the tool of a chain.

use nalgebra::{Matrix6xX, Vector6};

use super::{Chain, ChainError};
use crate::motion::{self, Acceleration, Joint, Twist};

impl Chain {
    /// Velocity of the tool in the base frame, `J qd`.
    ///
    /// `q`, `qd`: one value and one rate per joint, rad or length unit, and those / s.
    ///
    /// # Errors
    /// If the length of `q` or `qd` is not the number of joints.
    pub fn velocity(&self, q: &[f64], qd: &[f64]) -> Result<Twist<f64>, ChainError> {
        self.count(qd)?;
        Ok(motion::velocity(joints(&self.jacobian(q)?, qd, qd)))
    }

    /// Acceleration of the tool in the base frame, `J qdd + dJ/dt qd`. Its parts are the second derivative of the
    /// position of the tool's origin and the derivative of the tool's angular velocity, see [`Acceleration`].
    ///
    /// # Errors
    /// If the length of `q`, `qd` or `qdd` is not the number of joints.
    pub fn acceleration(&self, q: &[f64], qd: &[f64], qdd: &[f64]) -> Result<Acceleration<f64>, ChainError> {
        self.count(qd)?;
        self.count(qdd)?;
        Ok(motion::acceleration(joints(&self.jacobian(q)?, qd, qdd)))
    }

    /// Derivative of the Jacobian by time, `[6, dof]`, for joint rates `qd`; see
    /// [`Jacobian::derivative`](crate::Jacobian::derivative).
    ///
    /// # Errors
    /// If the length of `q` or `qd` is not the number of joints.
    pub fn jacobian_dot(&self, q: &[f64], qd: &[f64]) -> Result<Matrix6xX<f64>, ChainError> {
        self.count(qd)?;
        let jacobian = self.jacobian(q)?;
        let mut derivative = Matrix6xX::zeros(jacobian.ncols());
        for (mut to, ([a, b, c], [d, e, f])) in
            derivative.column_iter_mut().zip(motion::derivative(joints(&jacobian, qd, qd)))
        {
            to.copy_from(&Vector6::new(a, b, c, d, e, f));
        }
        Ok(derivative)
    }

    fn count(&self, values: &[f64]) -> Result<(), ChainError> {
        let (expected, found) = (self.dof(), values.len());
        if expected == found { Ok(()) } else { Err(ChainError::JointCount { expected, found }) }
    }
}

fn joints<'a>(
    jacobian: &'a Matrix6xX<f64>,
    qd: &'a [f64],
    qdd: &'a [f64],
) -> impl Iterator<Item = Joint<f64>> + Clone + 'a {
    jacobian.column_iter().zip(qd.iter().zip(qdd)).map(|(column, (qd, qdd))| {
        let [linear, angular] = [column.fixed_rows::<3>(0), column.fixed_rows::<3>(3)];
        Joint { v: linear.into_owned().into(), w: angular.into_owned().into(), qd: *qd, qdd: *qdd }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Convention, DhRow};

    /// A slide on a turning arm: the closed form of polar coordinates.
    #[test]
    fn polar_coordinates() -> Result<(), ChainError> {
        let quarter = core::f64::consts::FRAC_PI_2;
        let arm = Chain::new(
            Convention::Modified,
            &[DhRow::revolute(0.0, 0.0, 0.0, quarter), DhRow::prismatic(0.0, quarter, 0.0, 0.0)],
        );
        // The slide points along the turned x axis: at q1 = 0 along x.
        let ([r, w], [rd, wd], rdd) = ([0.8, 0.5], [0.3, -0.7], 0.9);
        let (q, qd, qdd) = ([0.0, r], [w, rd], [wd, rdd]);
        let near = |a: [f64; 6], b: [f64; 6]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(near(arm.velocity(&q, &qd)?.to_array(), [rd, r * w, 0.0, 0.0, 0.0, w]));
        let acceleration = arm.acceleration(&q, &qd, &qdd)?.to_array();
        assert!(near(acceleration, [rdd - r * w * w, r * wd + 2.0 * rd * w, 0.0, 0.0, 0.0, wd]), "{acceleration:?}");
        let bias = arm.jacobian_dot(&q, &qd)? * nalgebra::Vector2::from(qd);
        assert!(near(bias.into(), [-r * w * w, 2.0 * rd * w, 0.0, 0.0, 0.0, 0.0]));
        Ok(())
    }

    #[test]
    fn counts_are_checked() {
        let arm = Chain::new(Convention::Standard, &[DhRow::revolute(1.0, 0.0, 0.0, 0.0)]);
        let mismatch = |found| ChainError::JointCount { expected: 1, found };
        assert_eq!(arm.velocity(&[0.0], &[]), Err(mismatch(0)));
        assert_eq!(arm.velocity(&[], &[0.0]), Err(mismatch(0)));
        assert_eq!(arm.acceleration(&[0.0], &[0.0], &[0.0, 0.0]), Err(mismatch(2)));
        assert_eq!(arm.jacobian_dot(&[0.0], &[0.0; 3]).err(), Some(mismatch(3)));
    }
}
