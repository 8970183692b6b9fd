//! Where an arm comes closest to a target that it does not reach, and what it misses there.

use denhart::numeric::{NumericInverse, Task};
use denhart::{Pose, Residual};
use denhart_dynamic::{DynamicArm, DynamicTarget};

use crate::arm;

/// So many starts besides the first one.
const RESTARTS: usize = 20;
/// So many steps from each.
const STEPS: usize = 300;
/// The length, over the reach, that counts as much as 1 rad where only the direction is missed: the point comes first.
const POINT_FIRST: f64 = 1e-3;

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
        DynamicTarget::Position(_) | DynamicTarget::PlanarPosition(_) | DynamicTarget::PositionAngle(_) => return None,
    };
    let reach = arm.program().inverse.as_ref().ok()?.facts.reach;
    let whole = solve(numeric(whole).length(POINT_FIRST * reach), &at_point.q)?;
    (!whole.converged()).then_some(Missed::Direction(whole.residual))
}
