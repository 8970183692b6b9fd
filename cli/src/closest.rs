//! Where an arm comes closest to a target that it does not reach, and what it misses there.

use denhart::numeric::{NumericInverse, Task};
use denhart::{PointAngle, Pose, Residual};
use denhart_dynamic::{DynamicArm, DynamicTarget};

use crate::arm;
use std::f64::consts::PI;

/// So many starts besides the first one.
const RESTARTS: usize = 20;
/// So many steps from each.
const STEPS: usize = 300;
/// The length, over the reach, that counts as much as 1 rad where only the direction is missed: the point comes first.
const POINT_FIRST: f64 = 1e-3;

/// Turns of an angle up to half a turn, and how often the last one is halved.
const TURNS: u32 = 360;
const BISECTIONS: u32 = 40;

/// What is missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Missed {
    /// No joint vector found brings the tool point to its place; it comes as close as this, length unit.
    Distance(f64),
    /// The tool point can be there, but not in this direction. With the point where it is to be, this is left.
    Direction(Residual<f64>),
}

/// What is missed, by iteration from `start`, without limits. `None` where no iteration can tell.
pub fn missed(arm: &DynamicArm, target: &DynamicTarget, pose: &Pose<f64>, start: &[f64]) -> Option<Missed> {
    let chain = arm::chain(arm.model());
    let planar = matches!(target, DynamicTarget::PlanarPose(_) | DynamicTarget::PlanarPosition(_));
    let point = Task::Components([true, true, !planar, false, false, false]);
    let numeric = |task| NumericInverse::new().task(task).max_iterations(STEPS).restarts(RESTARTS);
    let solve =
        |numeric: NumericInverse<f64>, start: &[f64]| numeric.solve_chain(&chain, &(*pose).into(), start, None).ok();
    let at_point = solve(numeric(point), start)?;
    if !at_point.converged() {
        return Some(Missed::Distance(at_point.residual.position));
    }
    let whole = match target {
        DynamicTarget::Pose(_) => Task::Pose,
        DynamicTarget::PlanarPose(_) => Task::Components([true, true, false, false, false, true]),
        DynamicTarget::PositionAxis(asked) => {
            // The axis of the tool that points: the one that the pose has there.
            let [x, y, z] = asked.axis;
            Task::PositionAxis(pose.inverse().rotation.map(|[a, b, c]| a * x + b * y + c * z))
        }
        DynamicTarget::PositionAngle(asked) => return nearest_angle(arm, asked).map(Missed::Direction),
        DynamicTarget::Position(_) | DynamicTarget::PlanarPosition(_) => return None,
    };
    let reach = arm.program().inverse.as_ref().ok()?.constants.reach;
    let whole = solve(numeric(whole).length(POINT_FIRST * reach), &at_point.q)?;
    (!whole.converged()).then_some(Missed::Direction(whole.residual))
}

/// By how much the angle is missed with the point in its place. The asked angle is turned either way, until the inverse
/// reaches the target: turns of half a degree, then bisection.
fn nearest_angle(arm: &DynamicArm, asked: &PointAngle<f64>) -> Option<Residual<f64>> {
    let reaches = |turn: f64| {
        [turn, -turn].into_iter().any(|turn| {
            let target = DynamicTarget::PositionAngle(PointAngle::new(asked.point, asked.angle + turn));
            arm.inverse(&target, None).is_ok_and(|found| found.status().is_reachable())
        })
    };
    let turn = |k: u32| f64::from(k) * (PI / f64::from(TURNS));
    let outside = (0..TURNS).find(|k| reaches(turn(k + 1)))?;
    let (mut beyond, mut within) = (turn(outside), turn(outside + 1));
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (beyond + within);
        if reaches(middle) { within = middle } else { beyond = middle }
    }
    Some(Residual { position: 0.0, orientation: within })
}
