//! The closest approach of an arm to a target that it does not reach, and the part of the target that it misses there.

use std::f64::consts::{PI, TAU};

use denhart::numeric::{NumericInverse, Task};
use denhart::solve::Pointing;
use denhart::{JointKind, PointAngle, Pose, Residual, math};
use denhart_codegen::lower::Goal;
use denhart_dynamic::{DynamicArm, DynamicTarget};

use crate::chain;

/// So many starts besides the first one.
const RESTARTS: usize = 20;
/// So many steps from each.
const STEPS: usize = 300;
/// The length, over the reach, that counts as much as 1 rad where only the direction is missed: the point comes first.
const POINT_FIRST: f64 = 1e-3;

/// Turns of an angle up to half a turn, and how often the last one is halved.
const TURNS: u32 = 360;
const BISECTIONS: u32 = 40;

/// The closest approach to a target out of reach.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Closest {
    /// The part of the target that is missed.
    pub missed: Missed,
    /// Joint values, within their limits if a turn brings them there.
    pub q: Vec<f64>,
}

/// The part of a target that is missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Missed {
    /// No joint vector found brings the tool point to its place; it comes as close as this, length unit.
    Distance(f64),
    /// The tool point can be there, but not in this direction. With the point where it is to be, this is left.
    Direction(Residual<f64>),
}

/// The closest approach by iteration from `start`, without limits. `None` where no iteration can tell, as for a target that is
/// reached.
///
/// `pose` is a whole pose that meets the target, such as [`pose_of`] gives. `start` has a value for each joint, rad or length.
///
/// ```
/// use denhart_dynamic::{DynamicArm, DynamicTarget};
/// use denhart_tools::closest::{Missed, closest, pose_of};
///
/// # fn main() -> Result<(), denhart_dynamic::DynamicError> {
/// let rows = "[{a: 0.3, alpha: 0, d: 0, theta: 0}, {a: 0.2, alpha: 0, d: 0, theta: 0}]";
/// let arm = DynamicArm::from_yaml(&format!("convention: standard\njoints: {rows}\n"))?;
/// let target = DynamicTarget::PlanarPosition([0.0, 0.8]);
/// let found = closest(&arm, &target, &pose_of(&arm, &target), &[0.1, 0.2]);
/// let missed = found.map(|found| found.missed);
/// assert!(matches!(missed, Some(Missed::Distance(left)) if (left - 0.3).abs() < 1e-6), "{missed:?}");
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn closest(arm: &DynamicArm, target: &DynamicTarget, pose: &Pose<f64>, start: &[f64]) -> Option<Closest> {
    let (missed, q) = approach(arm, target, pose, start)?;
    let joints = arm.joint_kinds().iter().zip(arm.limits()).zip(q);
    let q = joints.map(|((kind, limits), q)| if *kind == JointKind::Revolute { turned(q, *limits) } else { q });
    Some(Closest { missed, q: q.collect() })
}

/// A whole pose that meets a target. Where the target leaves parts of the pose open, these are as of the base; of a
/// [`PointAngle`] the pose has the point alone, which is all that [`closest`] reads.
#[must_use]
pub fn pose_of(arm: &DynamicArm, target: &DynamicTarget) -> Pose<f64> {
    let at = |point, yaw| Pose::from_xyz_rpy(point, [0.0, 0.0, yaw]);
    match target {
        DynamicTarget::Pose(pose) => *pose,
        DynamicTarget::Position(point) => at(*point, 0.0),
        DynamicTarget::PositionAngle(asked) => at(asked.point, 0.0),
        DynamicTarget::PlanarPose(asked) => at([asked.x, asked.y, 0.0], asked.phi),
        DynamicTarget::PlanarPosition([x, y]) => at([*x, *y, 0.0], 0.0),
        DynamicTarget::PositionAxis(asked) => {
            let column = match arm.program().inverse.as_ref().map(|inverse| &inverse.goal) {
                Ok(Goal::PositionAxis { column }) => *column,
                _ => 2,
            };
            // The frame has its z axis along the direction. A cyclic change of its columns brings that one to its place.
            let frame = Pointing::new(asked, column).frame();
            let rotation = frame.rotation.map(|[u, v, w]| match column {
                0 => [w, u, v],
                1 => [v, w, u],
                _ => [u, v, w],
            });
            Pose { rotation, translation: asked.point }
        }
    }
}

/// The angle less whole turns, within the limits if one turn more or less brings it there.
fn turned(angle: f64, [low, high]: [f64; 2]) -> f64 {
    let angle = math::wrap(angle);
    let within = |angle: &f64| (low..=high).contains(angle);
    [angle, angle + TAU, angle - TAU].into_iter().find(within).unwrap_or(angle)
}

fn approach(arm: &DynamicArm, target: &DynamicTarget, pose: &Pose<f64>, start: &[f64]) -> Option<(Missed, Vec<f64>)> {
    let chain = chain(arm.model());
    let planar = matches!(target, DynamicTarget::PlanarPose(_) | DynamicTarget::PlanarPosition(_));
    let point = Task::Components([true, true, !planar, false, false, false]);
    let numeric = |task| NumericInverse::new().task(task).max_iterations(STEPS).restarts(RESTARTS);
    let solve =
        |numeric: NumericInverse<f64>, start: &[f64]| numeric.solve_chain(&chain, &(*pose).into(), start, None).ok();
    let at_point = solve(numeric(point), start)?;
    if !at_point.converged() {
        // So far away that the distance overflows.
        let distance = at_point.residual.position;
        return distance.is_finite().then_some((Missed::Distance(distance), at_point.q));
    }
    let whole = match target {
        DynamicTarget::Pose(_) => Task::Pose,
        DynamicTarget::PlanarPose(_) => Task::Components([true, true, false, false, false, true]),
        DynamicTarget::PositionAxis(asked) => {
            // The axis of the tool that points: the one that the pose has there.
            let [x, y, z] = asked.axis;
            Task::PositionAxis(pose.inverse().rotation.map(|[a, b, c]| a * x + b * y + c * z))
        }
        DynamicTarget::PositionAngle(asked) => return nearest_angle(arm, asked, start),
        DynamicTarget::Position(_) | DynamicTarget::PlanarPosition(_) => return None,
    };
    let reach = arm.program().inverse.as_ref().ok()?.constants.reach;
    let whole = solve(numeric(whole).length(POINT_FIRST * reach), &at_point.q)?;
    (!whole.converged()).then_some((Missed::Direction(whole.residual), whole.q))
}

/// The least turn of the asked angle, either way, with which the inverse reaches the point, and joint values there: turns of
/// half a degree, then bisection.
fn nearest_angle(arm: &DynamicArm, asked: &PointAngle<f64>, start: &[f64]) -> Option<(Missed, Vec<f64>)> {
    let reached = |turn: f64| {
        [turn, -turn].into_iter().find_map(|turn| {
            let target = DynamicTarget::PositionAngle(PointAngle::new(asked.point, asked.angle + turn));
            let found = arm.inverse_near(&target, start).ok()?;
            let nearest = found.first().filter(|_| found.status().is_reachable())?;
            Some(nearest.q.to_vec())
        })
    };
    let turn = |k: u32| f64::from(k) * (PI / f64::from(TURNS));
    let (outside, mut q) = (0..TURNS).find_map(|k| Some((k, reached(turn(k + 1))?)))?;
    let (mut beyond, mut within) = (turn(outside), turn(outside + 1));
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (beyond + within);
        match reached(middle) {
            Some(there) => (within, q) = (middle, there),
            None => beyond = middle,
        }
    }
    Some((Missed::Direction(Residual { position: 0.0, orientation: within }), q))
}
