//! A target in words and units.

use denhart_dynamic::{DynamicArm, DynamicTarget};

use super::axis_column;
use super::spelled::listed;
use crate::Failure;
use crate::numbers::{Units, short};

/// The target as it was understood: `point 300, 50, 200 mm; axis z towards 0, 0, -1`.
pub fn words(target: &DynamicTarget, arm: &DynamicArm, units: Units) -> Result<String, Failure> {
    let (length, unit) = (arm.length_unit(), units.symbol());
    let angle = |rad: f64| short(units.of(rad));
    let point = |point: &[f64]| format!("point {} {length}", listed(point));
    Ok(match target {
        DynamicTarget::Pose(pose) => {
            let [roll, pitch, yaw] = pose.rpy().angles.map(angle);
            format!("{}; roll {roll}, pitch {pitch}, yaw {yaw} {unit}", point(&pose.translation))
        }
        DynamicTarget::Position(asked) => point(asked),
        DynamicTarget::PositionAxis(asked) => {
            let name = ["x", "y", "z"].get(axis_column(arm)).copied().unwrap_or_default();
            format!("{}; axis {name} towards {}", point(&asked.point), listed(&asked.axis))
        }
        DynamicTarget::PositionAngle(asked) => format!("{}; angle {} {unit}", point(&asked.point), angle(asked.angle)),
        DynamicTarget::PlanarPose(asked) => {
            format!("{}; phi {} {unit}", point(&[asked.x, asked.y]), angle(asked.phi))
        }
        DynamicTarget::PlanarPosition(asked) => point(asked),
    })
}
