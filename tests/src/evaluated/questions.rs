//! Questions to both an evaluated and a generated arm.

use denhart::{JointKind, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};

use crate::random::Random;

/// Joints are often at multiples of this, where arms are singular.
const STEP: f64 = std::f64::consts::FRAC_PI_4;

/// A joint vector: at random, or each joint on a grid or beside it.
pub(super) fn joints(arm: &DynamicArm, round: usize, random: &mut Random) -> Vec<f64> {
    let joint = |(kind, [low, high]): (&JointKind, &[f64; 2])| {
        let (low, high) = match kind {
            JointKind::Revolute => (low.max(-3.1), high.min(3.1)),
            _ => (low.max(-1.0), high.min(1.0)),
        };
        let value = random.uniform(low, high);
        match round % 4 {
            0 | 1 => value,
            2 => (value / STEP).round() * STEP,
            _ => (value / STEP).round() * STEP + random.uniform(-1.0, 1.0) * 10.0_f64.powi(-(round as i32 / 4)),
        }
    };
    arm.joint_kinds().iter().zip(arm.limits()).map(joint).collect()
}

/// Rates and their derivatives for a joint vector.
pub(super) fn rates(q: &[f64]) -> [Vec<f64>; 2] {
    [q.iter().map(|q| 1.5 - 0.5 * q).collect(), q.iter().map(|q| 2.0 * q - 0.25).collect()]
}

/// The target; the same a little off, far out, a little way out, turned off a rotation, and not a number.
pub(super) fn targets(target: &DynamicTarget, round: usize, random: &mut Random) -> Vec<DynamicTarget> {
    let near = moved(target, |x| x + 1e-9 * random.uniform(-1.0, 1.0));
    let mut all = vec![*target, near];
    match round % 6 {
        0 => all.push(moved(target, |x| 3.0 * x)),
        1 => all.push(moved(target, |x| 1.02 * x)),
        2 => all.push(moved(target, |x| (x * 1e4).round() / 1e4)),
        3 => all.push(moved(target, |_| f64::NAN)),
        4 => all.push(moved(target, |_| 0.0)),
        _ => all.push(moved(target, |x| 1e200 * x)),
    }
    if let DynamicTarget::Pose(pose) = target {
        let rotation = pose.rotation.map(|row| row.map(|entry| (entry * 1e5).round() / 1e5));
        all.push(DynamicTarget::Pose(Pose { rotation, ..*pose }));
    }
    all
}

/// The target with every coordinate of its point changed.
fn moved(target: &DynamicTarget, mut change: impl FnMut(f64) -> f64) -> DynamicTarget {
    let mut target = *target;
    match &mut target {
        DynamicTarget::Pose(pose) => pose.translation = pose.translation.map(change),
        DynamicTarget::Position(point) => *point = point.map(change),
        DynamicTarget::PositionAxis(asked) => asked.point = asked.point.map(change),
        DynamicTarget::PositionAngle(asked) => asked.point = asked.point.map(change),
        DynamicTarget::PlanarPose(asked) => (asked.x, asked.y) = (change(asked.x), change(asked.y)),
        DynamicTarget::PlanarPosition(point) => *point = point.map(change),
    }
    target
}
