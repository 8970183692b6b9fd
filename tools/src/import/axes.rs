//! The chain at its zero: every axis as a line in the base link's frame, and where the tool is.

use std::f64::consts::PI;

use super::path::Path;
use super::rigid::{Transform, V, about, exact_degrees, of_origin, scale};
use super::urdf::{Joint, Kind};

/// A moving joint. Its motion is a turn about, or a slide along, a line of the base link's frame:
/// `T(q) = M1(q1) M2(q2) .. T(0)`.
#[derive(Debug, Clone)]
pub struct Axis {
    pub name: String,
    pub turns: bool,
    /// A point of the line.
    pub point: V,
    /// A unit vector: the joint's positive direction.
    pub direction: V,
}

/// All axes, and the tool link's frame at zero.
#[derive(Debug, Clone)]
pub struct Axes {
    pub axes: Vec<Axis>,
    pub tool: Transform,
}

/// An angle that was made exact.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// The joint or row that it belongs to.
    pub of: String,
    /// The angle before, rad.
    pub from: f64,
    /// The angle now, degrees.
    pub to: f64,
}

impl Change {
    /// The change of the angle, rad.
    pub fn size(&self) -> f64 {
        (self.from - self.to * PI / 180.0).abs()
    }
}

/// A change below this, rad, is the rounding of an angle's digits and is not told.
const TOLD: f64 = 1e-12;

/// The angle, made exact where that changes it by at most `within`.
pub fn exact(angle: f64, within: f64, of: impl FnOnce() -> String, changes: &mut Vec<Change>) -> f64 {
    let Some(to) = exact_degrees(angle, within) else { return angle };
    let change = Change { of: of(), from: angle, to: to + 0.0 };
    let value = to * PI / 180.0;
    if change.size() > TOLD {
        changes.push(change);
    }
    value
}

/// The path with the angles of its origins made exact within `within` rad.
pub fn exact_origin(joint: &Joint, within: f64, changes: &mut Vec<Change>) -> Joint {
    let mut joint = joint.clone();
    for (angle, what) in joint.rpy.iter_mut().zip(["roll", "pitch", "yaw"]) {
        let name = &joint.name;
        *angle = exact(*angle, within, || format!("{what} of joint `{name}`"), changes);
    }
    joint
}

/// The axes of the path. A joint in `held` stands still at its value.
pub fn axes(path: &Path, held: &dyn Fn(&Joint) -> Option<f64>) -> Axes {
    let mut frame = Transform::IDENTITY;
    let mut axes = Vec::new();
    for passed in &path.joints {
        let joint = passed.joint;
        let origin = of_origin(joint.xyz, joint.rpy);
        if !passed.backward {
            frame = frame.then(&origin);
        }
        let moves = matches!(joint.kind, Kind::Turning | Kind::Sliding);
        match held(joint).filter(|_| moves) {
            Some(value) => {
                let motion = motion(joint, value);
                frame = frame.then(&if passed.backward { motion.inverse() } else { motion });
            }
            None if moves => axes.push(Axis {
                name: joint.name.clone(),
                turns: joint.kind == Kind::Turning,
                point: frame.p,
                direction: scale(frame.turn(joint.axis), if passed.backward { -1.0 } else { 1.0 }),
            }),
            None => {}
        }
        if passed.backward {
            frame = frame.then(&origin.inverse());
        }
    }
    Axes { axes, tool: frame }
}

/// The motion of a joint's child at a value of the joint.
pub fn motion(joint: &Joint, value: f64) -> Transform {
    match joint.kind {
        Kind::Turning => about(joint.axis, value),
        Kind::Sliding => Transform::shift(scale(joint.axis, value)),
        _ => Transform::IDENTITY,
    }
}

/// The tool link's frame by the rule of the format, joint after joint: the way that shares nothing with the table.
pub fn pose(path: &Path, value: &dyn Fn(&Joint) -> f64) -> Transform {
    let mut pose = Transform::IDENTITY;
    for passed in &path.joints {
        let step = of_origin(passed.joint.xyz, passed.joint.rpy).then(&motion(passed.joint, value(passed.joint)));
        pose = pose.then(&if passed.backward { step.inverse() } else { step });
    }
    pose
}
