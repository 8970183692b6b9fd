//! The angle that a whole pose has in the plane of a `position_angle` arm.
//!
//! The tool turns with the yaw joint about `u`, and with the pitch joints about `n`. So its orientation is
//! `R = Rot(n, angle - offset) Rot(u, yaw) R0`, with `R0` that of all joints at 0. The pitch axis is fixed in the tool:
//! `n = R R0^T n0`. It is also given by the point `p`, whose offset along it is constant: `n . (p - o) = e`, with `o` on
//! the yaw axis. A pose where both agree has the arm's own angle.

use denhart::{JointKind, PointAngle, Pose, math};
use denhart_codegen::lower::Goal;
use denhart_dynamic::{DynamicArm, DynamicError, DynamicTarget};

use super::Target;
use crate::Failure;
use crate::numbers::{Units, short};

type Vector = [f64; 3];

/// The most that the direction of a pose may miss, rad: as much as the inverse allows the rotation of a pose.
const MOST_MISSED: f64 = 1e-3;
/// A pose that misses by more than this, rad, was printed with few digits, which is told.
const ROUNDING: f64 = 1e-6;
/// The distance of a point from the yaw axis, over the reach, below which its digits do not tell a direction.
const NO_DIRECTION: f64 = 1e-6;

/// The point and the angle of a whole pose.
///
/// # Errors
/// A pose in which the tool leaves the arm's plane, with the angle by which it does.
pub fn target(arm: &DynamicArm, pose: Pose<f64>, units: Units) -> Result<Target, Failure> {
    let plane = Plane::of(arm)?;
    let (angle, missed) = plane.angle(&pose);
    let off = || format!("{} {}", short(units.of(missed)), units.symbol());
    let [x, y, z] = pose.translation;
    let own = [x, y, z, units.of(angle)].map(short).join(" ");
    if missed > MOST_MISSED || missed.is_nan() {
        return Err(Failure::Usage(format!(
            "the arm has no such pose: its tool stands in the plane that joint {} turns, and the direction misses that \
             plane by {}\nhelp: write the point and an angle alone, \"x y z angle\"; the nearest one is --pose \"{own}\"",
            plane.yaw_name,
            off()
        )));
    }
    let hints = (missed > ROUNDING).then(|| format!("the pose misses the arm's plane by {}; its angle is used", off()));
    let target = DynamicTarget::PositionAngle(PointAngle::new(pose.translation, angle));
    Ok(Target { target, pose, q: None, given: Vec::new(), hints: hints.into_iter().collect() })
}

/// The plane with all joints at 0.
struct Plane {
    yaw_name: String,
    /// Orientation of the tool.
    rotation: Pose<f64>,
    /// Direction of the yaw axis, a point on it, and direction of the pitch axis.
    yaw: Vector,
    origin: Vector,
    pitch: Vector,
    /// Offset of the tool point from `origin` along the pitch axis.
    along: f64,
    /// The angle.
    offset: f64,
    /// A point nearer to the yaw axis than this has no direction from it.
    near: f64,
}

impl Plane {
    fn of(arm: &DynamicArm) -> Result<Self, Failure> {
        let wrong = || Failure::from(DynamicError::Target { expected: "position_angle", found: "pose" });
        let inverse = arm.program().inverse.as_ref().map_err(|_| wrong())?;
        let Goal::PositionAngle { signs, offset } = &inverse.goal else { return Err(wrong()) };
        let kinds = arm.joint_kinds().iter().enumerate();
        let turns: Vec<usize> =
            kinds.filter(|(_, kind)| **kind == JointKind::Revolute).map(|(joint, _)| joint).collect();
        let sign = |joint: &&usize| signs.get(**joint).copied().unwrap_or_default();
        let yaws = turns.iter().find(|joint| sign(joint) == 0.0).ok_or_else(wrong)?;
        let pitches = turns.iter().find(|joint| sign(joint) != 0.0).ok_or_else(wrong)?;
        let (tool, jacobian) = arm.forward_and_jacobian(&vec![0.0; arm.joints()])?;
        let [vx, vy, vz, wx, wy, wz] =
            jacobian.map(|row| [yaws, pitches].map(|joint| row.get(*joint).copied().unwrap_or(f64::NAN)));
        let column = |x: [f64; 2], y: [f64; 2], z: [f64; 2]| {
            let ([x, a], [y, b], [z, c]) = (x, y, z);
            ([x, y, z], [a, b, c])
        };
        let ((velocity, _), (yaw, pitch)) = (column(vx, vy, vz), column(wx, wy, wz));
        let pitch = scaled(sign(&pitches), pitch);
        // The velocity of a turn about the axis is u x (p - o). So u x velocity leads from the point to the axis.
        let origin = sum(tool.translation, cross(yaw, velocity));
        Ok(Self {
            yaw_name: arm.joint_names().nth(*yaws).unwrap_or_default().to_owned(),
            rotation: Pose { translation: [0.0; 3], ..tool },
            along: dot(pitch, sum(tool.translation, scaled(-1.0, origin))),
            yaw,
            origin,
            pitch,
            offset: offset.rad(),
            near: NO_DIRECTION * inverse.constants.reach,
        })
    }

    /// The angle of a pose, and how far its direction is from one that the arm has there, rad.
    fn angle(&self, pose: &Pose<f64>) -> (f64, f64) {
        let turned = Pose { translation: [0.0; 3], ..*pose }.orthonormalized().compose(&self.rotation.inverse());
        // The pitch axis by the orientation.
        let seen = turned.transform_point(&self.pitch);
        // Directions across the yaw axis are angles from the pitch axis at 0.
        let rise = dot(self.pitch, self.yaw);
        let flat = |v: Vector| sum(v, scaled(-dot(v, self.yaw), self.yaw));
        let east = flat(self.pitch);
        let width = dot(east, east).sqrt();
        let north = cross(self.yaw, east);
        let bearing = |v: Vector| (dot(v, north).atan2(dot(v, east)), dot(flat(v), flat(v)).sqrt());
        let from = sum(pose.translation, scaled(-1.0, self.origin));
        let ((point, radius), (own, _)) = (bearing(from), bearing(seen));
        // width radius cos(turn - point) = along - rise height
        let cosine = (self.along - rise * dot(from, self.yaw)) / (width * radius);
        // On the yaw axis every turn will do.
        let turns = match radius > self.near {
            true => [1.0, -1.0].map(|side| point + side * cosine.clamp(-1.0, 1.0).acos()),
            false => [own; 2],
        };
        let about = |axis: Vector, angle: f64| Pose::from_xyz_axis_angle([0.0; 3], axis, angle);
        let candidates = turns.map(|turn| {
            let yawed = about(self.yaw, turn).unwrap_or_else(Pose::identity);
            let pitch = yawed.transform_point(&self.pitch);
            let across = cross(pitch, seen);
            let missed = dot(across, across).sqrt().atan2(dot(pitch, seen));
            // The part of the remaining turn that is about the pitch axis.
            let [w, x, y, z] = turned.compose(&yawed.inverse()).quaternion();
            let angle = self.offset + 2.0 * dot([x, y, z], pitch).atan2(w);
            (math::wrap(angle), missed)
        });
        let [one, other] = candidates;
        if other.1 < one.1 { other } else { one }
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn sum([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [a + x, b + y, c + z]
}

fn scaled(k: f64, v: Vector) -> Vector {
    v.map(|x| k * x)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use std::path::Path;

    fn arms() -> Vec<DynamicArm> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let made_up =
            std::fs::read_dir(root.join("tests/arms/position_angle")).unwrap().map(|entry| entry.unwrap().path());
        let published = ["al5d", "jupiter"].map(|name| root.join(format!("specs/{name}.yaml")));
        made_up.chain(published).map(|path| DynamicArm::from_file(path).unwrap()).collect()
    }

    /// Joint values that fill their ranges.
    fn joints(arm: &DynamicArm, index: usize) -> Vec<f64> {
        let spread = |joint: usize| ((4 * index + joint) as f64 * 0.618_033_988_749_895).fract() * 2.0 - 1.0;
        let kinds = arm.joint_kinds().iter().enumerate();
        kinds.map(|(joint, kind)| spread(joint) * if *kind == JointKind::Revolute { 3.1 } else { 0.5 }).collect()
    }

    #[test]
    fn the_pose_of_joint_values_has_the_angle_of_their_target() {
        let arms = arms();
        assert!(arms.len() >= 11);
        for arm in &arms {
            for index in 0..200 {
                let q = joints(arm, index);
                let found = target(arm, arm.forward(&q).unwrap(), Units::Deg).unwrap();
                let (DynamicTarget::PositionAngle(found), DynamicTarget::PositionAngle(expected)) =
                    (found.target, arm.target_at(&q).unwrap())
                else {
                    unreachable!()
                };
                assert_eq!(found.point, expected.point);
                let off = math::wrap(found.angle - expected.angle);
                assert!(off.abs() < 1e-6, "{} {q:?}: {off:e}", arm.model().name);
            }
        }
    }

    /// A tool that is turned out of its plane by an angle misses by that angle.
    #[test]
    fn a_pose_out_of_the_plane_misses_by_its_turn() {
        for arm in &arms() {
            let plane = Plane::of(arm).unwrap();
            for index in 0..50 {
                let pose = arm.forward(&joints(arm, index)).unwrap();
                let (_, own) = plane.angle(&pose);
                assert!(own < 1e-6, "{}: {own:e}", arm.model().name);
                // Across the pitch axis, so that no pitch takes it back.
                let turned = Pose { translation: [0.0; 3], ..pose }.compose(&plane.rotation.inverse());
                let pitch = turned.transform_point(&plane.pitch);
                let across = cross(pitch, plane.yaw);
                let size = dot(across, across).sqrt();
                let tilt = Pose::from_xyz_axis_angle([0.0; 3], scaled(1.0 / size, across), 0.2).unwrap();
                let tilted = Pose { translation: pose.translation, ..tilt.compose(&pose) };
                let (_, missed) = plane.angle(&tilted);
                assert!((missed - 0.2).abs() < 1e-6, "{}: {missed}", arm.model().name);
            }
        }
    }
}
