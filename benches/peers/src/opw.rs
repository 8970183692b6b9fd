//! The IRB 2400 of rs-opw-kinematics.

use denhart::Pose;
use rs_opw_kinematics::glam::{DMat3, DQuat, DVec3};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

/// The arm with the parameters that the library ships.
pub fn irb2400() -> OPWKinematics {
    OPWKinematics::new(Parameters::irb2400_10())
}

/// A pose in the library's own form.
pub fn target(pose: &Pose<f64>) -> rs_opw_kinematics::pose::Pose {
    let rotation = DMat3::from_cols_array_2d(&pose.rotation).transpose();
    rs_opw_kinematics::pose::Pose::from_parts(DVec3::from_array(pose.translation), DQuat::from_mat3(&rotation))
}
