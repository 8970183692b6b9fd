//! The path is kept: the planner.

use std::cell::Cell;

use denhart::{Branch, InverseKinematics};
use denhart_dynamic::plan::{JointPath, JointSample, PlanError, Trajectory};
use denhart_dynamic::{DynamicTarget, DynamicView, WholeTarget};

use super::asked::{Asked, Refused};
use super::motion::{Motion, Obstacle, Row, name};

/// The fastest motion along the path.
pub fn motion<const N: usize>(
    asked: &Asked<'_>,
    view: &DynamicView<'_, N>,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<Motion, Refused> {
    let plan = match plan(asked, view, watch)? {
        Ok(plan) => plan,
        Err(obstacle) => return Ok(obstacle.into()),
    };
    let trajectory = plan.timed();
    let duration = trajectory.duration();
    let times = asked.times(duration)?;
    let whole = (0..times.count()).map(|index| times.at(index));
    // The end is no whole period, mostly.
    let end = Some(duration).filter(|end| *end > times.at(times.count() - 1));
    let mut samples = plan.samples();
    let rows = whole.chain(end).map(|t| row_at(asked, view, &trajectory, &mut samples, t));
    Ok(Motion { rows: rows.collect(), obstacle: None })
}

/// The plan, or the place where none goes on.
pub fn plan<const N: usize>(
    asked: &Asked<'_>,
    view: &DynamicView<'_, N>,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<Result<JointPath<N>, Obstacle>, Refused> {
    let goes_on = Cell::new(true);
    // A target that is none ends the planner.
    let path = |at: f64| match goes_on.get() {
        true => asked.at(at),
        false => WholeTarget::from(DynamicTarget::PlanarPosition([f64::NAN; 2])),
    };
    let mut progress = |at: f64| goes_on.set(goes_on.get() && watch(at));
    let plan = JointPath::new(view, &path, asked.end(), &asked.settings(view)?, &mut progress);
    if !goes_on.get() {
        return Err(Refused::Ended);
    }
    match plan {
        Ok(plan) => Ok(Ok(plan)),
        Err(PlanError::NoPath { at, branch, obstacle }) => {
            let named = |joint: usize| asked.arm.joint_names().nth(joint).unwrap_or_default().to_owned();
            Ok(Err(Obstacle { at, branch: name(branch), reason: obstacle.words(named) }))
        }
        Err(error) => Err(Refused::Plan(error)),
    }
}

fn row_at<const N: usize>(
    asked: &Asked<'_>,
    view: &DynamicView<'_, N>,
    trajectory: &Trajectory<N>,
    samples: &mut &[JointSample<N>],
    t: f64,
) -> Row {
    let point = trajectory.at(t);
    while let [_, next, ..] = samples
        && next.at <= point.at
    {
        *samples = samples.get(1..).unwrap_or(&[]);
    }
    let branch = samples.first().map_or(Branch::NONE, |sample| sample.branch);
    let off = view.residual(&point.q, &asked.at(point.at));
    let (q, velocity) = (point.q.to_vec(), point.velocity.to_vec());
    Row { t, q, velocity, at: point.at, branch: name(branch), tracking: "kept", off }
}
