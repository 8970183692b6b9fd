//! `--keep path`: the planner.

use denhart::{Branch, InverseKinematics};
use denhart_dynamic::DynamicView;
use denhart_dynamic::plan::{JointPath, JointSample, PlanError, PlanSettings, Trajectory};

use super::answer::{Answer, Obstacle, Row};
use super::{Asked, PARTS};
use crate::Failure;
use crate::target::listed;

/// Intervals of the path that the plan begins with: so many between two poses, and over the whole path.
const BETWEEN_POSES: usize = 4;
const FEWEST: usize = 256;

/// The fastest motion along the path.
pub fn answer<const N: usize>(asked: &Asked, view: &DynamicView<N>) -> Result<Answer, Failure> {
    let path = |at: f64| asked.path.at(at);
    let settings = settings(asked)?;
    let mut progress = asked.progress();
    let end = asked.path.end();
    let plan = JointPath::new(view, &path, end, &settings, &mut |at| progress.look((PARTS * at / end) as u64));
    let plan = match plan {
        Ok(plan) => plan,
        Err(PlanError::NoPath { at, branch, obstacle }) => {
            let obstacle = Obstacle { at, branch: name(branch), reason: obstacle.to_string() };
            return Ok(Answer { keep: "path", rows: Vec::new(), obstacle: Some(obstacle) });
        }
        Err(error) => return Err(refused(asked, error)),
    };
    let trajectory = plan.timed();
    let duration = trajectory.duration();
    let times = asked.times(duration)?;
    let whole = (0..times.count()).map(|index| times.at(index));
    // The end is no whole period, mostly.
    let end = Some(duration).filter(|end| *end > times.at(times.count() - 1));
    let mut samples = plan.samples();
    let rows = whole.chain(end).map(|t| row_at(view, &trajectory, &path, &mut samples, t));
    Ok(Answer { keep: "path", rows: rows.collect(), obstacle: None })
}

/// The settings of the plan.
pub fn settings<const N: usize>(asked: &Asked) -> Result<PlanSettings<N>, Failure> {
    let rates = asked.rates.of::<N>();
    let settings = PlanSettings::new(rates.velocity, rates.acceleration, asked.tolerance);
    Ok(PlanSettings {
        start: asked.start()?,
        is_timed: asked.is_timed,
        intervals: (BETWEEN_POSES * asked.path.stretches()).max(FEWEST),
        ..settings
    })
}

fn row_at<const N: usize>(
    view: &DynamicView<N>,
    trajectory: &Trajectory<N>,
    path: &impl Fn(f64) -> denhart_dynamic::WholeTarget,
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
    let off = view.residual(&point.q, &path(point.at));
    let (q, velocity) = (point.q.to_vec(), point.velocity.to_vec());
    Row { t, q, velocity, at: point.at, branch: name(branch), tracking: "kept", off }
}

/// The name of a branch; empty where it has none.
pub fn name(branch: Branch) -> String {
    if branch == Branch::NONE { String::new() } else { branch.to_string() }
}

/// The failure of a plan for its settings.
pub fn refused(asked: &Asked, error: PlanError) -> Failure {
    Failure::Usage(match error {
        PlanError::StartAway { nearest, .. } => {
            let kinds = asked.arm.joint_kinds().iter().zip(&nearest);
            let values: Vec<f64> = kinds.map(|(kind, value)| asked.units.of_joint(*kind, *value)).collect();
            format!(
                "--start: these joint values are not at the first pose\n\
                 help: the nearest solution there is --start \"{}\"; leave --start out for the best of all",
                listed(&values)
            )
        }
        PlanError::Target { at } => format!("--path: the pose at {at} is not finite, or no rotation"),
        error => error.to_string(),
    })
}
