//! `base:` and `tool:`, the constant frames before the first row and after the last.

use super::angle::WrittenAngle;
use super::angle_field::AngleRole;
use super::length::Length;
use super::parameter::Context;
use super::reader::{Field, Fields, Reader};

/// A constant frame as written: translation `xyz`, then `Rz(yaw) Ry(pitch) Rx(roll)` with `rpy` = roll, pitch, yaw.
#[derive(Debug, Clone)]
pub struct FrameSpec {
    /// Length unit of the file.
    pub xyz: [Length; 3],
    /// Roll, pitch, yaw.
    pub rpy: [WrittenAngle; 3],
}

impl Reader<'_> {
    /// The frame under `key`, the identity where there is none.
    pub fn frame(&mut self, root: &Fields<'_>, key: &'static str, context: Context<'_>) -> FrameSpec {
        let mut frame = FrameSpec { xyz: [Length::ZERO; 3], rpy: [WrittenAngle::ZERO; 3] };
        let Some(field) = root.get(key) else { return frame };
        let Some(fields) = self.mapping(&field, &format!("`{key}`"), &["xyz", "rpy"]) else { return frame };
        let xyz: Option<[Field<'_>; 3]> = fields.get("xyz").and_then(|field| {
            self.list(&field, "three lengths [x, y, z]", "write `xyz: [0, 0, 0]`, a length along each axis")
        });
        if let Some(xyz) = xyz {
            frame.xyz = xyz.map(|field| self.length(&field, context.parameters).unwrap_or(Length::ZERO));
        }
        let rpy: Option<[Field<'_>; 3]> = fields.get("rpy").and_then(|field| {
            self.list(
                &field,
                "three angles [roll, pitch, yaw]",
                "write `rpy: [0, 0, 0]`, the rotation Rz(yaw) Ry(pitch) Rx(roll)",
            )
        });
        if let Some(rpy) = rpy {
            let read = |field| self.angle(&field, context.angle, AngleRole::Offset);
            frame.rpy = rpy.map(read).map(|angle| angle.unwrap_or(WrittenAngle::ZERO));
        }
        frame
    }
}
