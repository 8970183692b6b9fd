//! Targets of an arm known at run time.

use denhart::{PlanarPose, PointAngle, PointAxis, Pose};

/// A target of one of the tasks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DynamicTarget {
    /// Task `pose`.
    Pose(Pose<f64>),
    /// Task `position`: where the tool point is to be, base frame, length unit.
    Position([f64; 3]),
    /// Task `position_axis`.
    PositionAxis(PointAxis<f64>),
    /// Task `position_angle`.
    PositionAngle(PointAngle<f64>),
    /// Task `planar_pose`.
    PlanarPose(PlanarPose<f64>),
    /// Task `planar_position`: where the tool point is to be in the base frame's xy plane, length unit.
    PlanarPosition([f64; 2]),
}

impl DynamicTarget {
    /// The task that it belongs to, as an arm file names it.
    #[must_use]
    pub const fn task(&self) -> &'static str {
        match self {
            DynamicTarget::Pose(_) => "pose",
            DynamicTarget::Position(_) => "position",
            DynamicTarget::PositionAxis(_) => "position_axis",
            DynamicTarget::PositionAngle(_) => "position_angle",
            DynamicTarget::PlanarPose(_) => "planar_pose",
            DynamicTarget::PlanarPosition(_) => "planar_position",
        }
    }
}
