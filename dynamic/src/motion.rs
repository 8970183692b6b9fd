//! Velocities, accelerations and manipulability, from poses and Jacobian.

use denhart::{Acceleration, Jacobian, Pose, Twist};
use denhart_codegen::lower::{TaskMotion, task_motion};
use denhart_codegen::model::MOST_JOINTS;

use crate::{DynamicArm, DynamicError, DynamicJacobian, Joints};

/// Runs code with the number of joints as a constant.
macro_rules! of_joints {
    ($joints:expr, $N:ident => $code:expr) => {
        of_joints!(@each $joints, $N, $code; 1 2 3 4 5 6 7 8 9)
    };
    (@each $joints:expr, $N:ident, $code:expr; $($count:literal)*) => {
        match $joints {
            $($count => {
                const $N: usize = $count;
                $code
            })*
            _ => {
                const $N: usize = MOST_JOINTS;
                $code
            }
        }
    };
}

fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    let mut array = [0.0; N];
    for (place, value) in array.iter_mut().zip(values) {
        *place = *value;
    }
    array
}

fn links<const N: usize>(poses: &[Pose<f64>]) -> [Pose<f64>; N] {
    let mut links = [Pose::identity(); N];
    for (place, pose) in links.iter_mut().zip(poses) {
        *place = *pose;
    }
    links
}

fn typed<const N: usize>(rows: &DynamicJacobian) -> Jacobian<f64, N> {
    Jacobian { rows: rows.each_ref().map(|row| array(row)) }
}

fn untyped<const N: usize>(jacobian: Jacobian<f64, N>) -> DynamicJacobian {
    jacobian.rows.map(Joints::new)
}

impl DynamicArm {
    /// Velocity of the tool point (length unit/s) and angular velocity (rad/s) in the base frame, for rates `qd`: `J qd`.
    ///
    /// # Errors
    /// If the length of `q`, or of `qd`, is not the number of joints. So for all functions of joint rates.
    pub fn velocity(&self, q: &[f64], qd: &[f64]) -> Result<Twist<f64>, DynamicError> {
        self.counted(qd)?;
        let rows = self.jacobian(q)?;
        Ok(of_joints!(self.joints(), N => typed::<N>(&rows).velocity(&array(qd))))
    }

    /// Second derivative of the tool point (length unit/s^2), derivative of the angular velocity (rad/s^2): `J qdd + dJ/dt qd`.
    ///
    /// # Errors
    /// As of [`velocity`](Self::velocity).
    pub fn acceleration(&self, q: &[f64], qd: &[f64], qdd: &[f64]) -> Result<Acceleration<f64>, DynamicError> {
        self.counted(qd)?;
        self.counted(qdd)?;
        let rows = self.jacobian(q)?;
        Ok(of_joints!(self.joints(), N => typed::<N>(&rows).acceleration(&array(qd), &array(qdd))))
    }

    /// Derivative by time of [`jacobian`](Self::jacobian), for rates `qd`.
    ///
    /// # Errors
    /// As of [`velocity`](Self::velocity).
    pub fn jacobian_dot(&self, q: &[f64], qd: &[f64]) -> Result<DynamicJacobian, DynamicError> {
        self.counted(qd)?;
        let rows = self.jacobian(q)?;
        Ok(of_joints!(self.joints(), N => untyped(typed::<N>(&rows).derivative(&array(qd)))))
    }

    /// Geometric Jacobian of the tool point in the axes of the tool.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn jacobian_tool(&self, q: &[f64]) -> Result<DynamicJacobian, DynamicError> {
        let (tool, rows) = self.forward_and_jacobian(q)?;
        Ok(of_joints!(self.joints(), N => untyped(typed::<N>(&rows).in_frame(&tool.rotation))))
    }

    /// Velocities of the frames of [`link_poses`](Self::link_poses) in the base frame, each at its own origin.
    ///
    /// # Errors
    /// As of [`velocity`](Self::velocity).
    pub fn link_velocities(&self, q: &[f64], qd: &[f64]) -> Result<Vec<Twist<f64>>, DynamicError> {
        self.counted(qd)?;
        let ((tool, rows), poses) = (self.forward_and_jacobian(q)?, self.link_poses(q)?);
        Ok(of_joints!(self.joints(), N => {
            typed::<N>(&rows).link_velocities(&tool, &links(&poses), &array(qd)).to_vec()
        }))
    }

    /// Accelerations of the same frames.
    ///
    /// # Errors
    /// As of [`velocity`](Self::velocity).
    pub fn link_accelerations(
        &self,
        q: &[f64],
        qd: &[f64],
        qdd: &[f64],
    ) -> Result<Vec<Acceleration<f64>>, DynamicError> {
        self.counted(qd)?;
        self.counted(qdd)?;
        let ((tool, rows), poses) = (self.forward_and_jacobian(q)?, self.link_poses(q)?);
        Ok(of_joints!(self.joints(), N => {
            typed::<N>(&rows).link_accelerations(&tool, &links(&poses), &array(qd), &array(qdd)).to_vec()
        }))
    }

    /// Yoshikawa's manipulability over the motion that the task counts: `sqrt(det(J J^T))` or `sqrt(det(J^T J))`, see
    /// [`Jacobian::manipulability_of`]. It is 0 where the arm is singular; its unit is one length unit for each linear row.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn manipulability(&self, q: &[f64]) -> Result<f64, DynamicError> {
        let goal = self.program.inverse.as_ref().ok().map(|inverse| &inverse.goal);
        let counted = task_motion(self.model(), goal);
        if let TaskMotion::Axis(column) = counted {
            let (pose, rows) = self.forward_and_jacobian(q)?;
            let axis = pose.rotation.map(|row| row.get(column).copied().unwrap_or(f64::NAN));
            return Ok(of_joints!(self.joints(), N => typed::<N>(&rows).manipulability_pointing(axis)));
        }
        let rows = self.jacobian(q)?;
        Ok(of_joints!(self.joints(), N => {
            let jacobian = typed::<N>(&rows);
            match &counted {
                TaskMotion::Rows(counts, _) => jacobian.manipulability_of(*counts),
                TaskMotion::Angle(signs) => jacobian.manipulability_turning(array(signs)),
                TaskMotion::All | TaskMotion::Axis(_) => jacobian.manipulability(),
            }
        }))
    }

    /// Yoshikawa's manipulability over some of the rows vx vy vz wx wy wz, see [`Jacobian::manipulability_of`].
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn manipulability_of(&self, q: &[f64], counts: [bool; 6]) -> Result<f64, DynamicError> {
        let rows = self.jacobian(q)?;
        Ok(of_joints!(self.joints(), N => typed::<N>(&rows).manipulability_of(counts)))
    }
}
