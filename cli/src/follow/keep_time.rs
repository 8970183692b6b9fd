//! `--keep time`: the follower.

use denhart::follow::{FollowError, FollowSettings, Follower, Step, Tracking};
use denhart::{InverseKinematics, Residual, Solution, Windings};
use denhart_dynamic::plan::{JointPath, PlanError};
use denhart_dynamic::{DynamicView, ViewSolutions};

use super::answer::{Answer, Obstacle, Row};
use super::keep_path::{name, refused, settings};
use super::{Asked, PARTS};
use crate::Failure;

/// A start is this near to a solution of the first pose, rad.
const NEAR: f64 = 1e-3;

/// The motion that keeps the times, tick by tick.
pub fn answer<const N: usize>(asked: &Asked, view: &DynamicView<N>) -> Result<Answer, Failure> {
    let path = |at: f64| asked.path.at(at);
    let end = asked.path.end();
    // The last tick is a whole period too: its target is the end of the path.
    let ticks = (end / asked.period * (1.0 - 1e-12)).ceil();
    let times = asked.times(ticks * asked.period)?;
    let start = match start(asked, view)? {
        Ok(start) => start,
        Err(obstacle) => return Ok(Answer { keep: "time", rows: Vec::new(), obstacle: Some(obstacle) }),
    };
    let follower = Follower::new(view, FollowSettings::new(asked.period, asked.rates.of()), &start);
    let mut follower = follower.map_err(|error| told(&error))?;
    let mut found = ViewSolutions::default();
    let mut rows = Vec::new();
    let branch =
        view.inverse_near(&path(0.0), &start).as_ref().first().map_or_else(String::new, |one| name(one.branch));
    let off = view.residual(&start, &path(0.0));
    let (q, velocity) = (start.to_vec(), vec![0.0; N]);
    rows.push(Row { t: 0.0, q, velocity, at: 0.0, branch, tracking: "exact", off });
    let mut progress = asked.progress();
    let mut last = None;
    for t in (1..times.count()).map(|tick| times.at(tick)) {
        let at = t.min(end);
        let step = follower.step(view, &path(at), &mut found);
        rows.push(row(view, &step, &path(at), t, at));
        progress.look((PARTS * at / end) as u64);
        last = Some(step);
    }
    drop(progress);
    let obstacle = last.filter(|step| !step.tracking.is_exact()).map(|step| Obstacle {
        at: end,
        branch: name(step.branch),
        reason: reason(asked, &step),
    });
    Ok(Answer { keep: "time", rows, obstacle })
}

fn row<const N: usize>(
    view: &DynamicView<N>,
    step: &Step<f64, N>,
    target: &denhart_dynamic::WholeTarget,
    t: f64,
    at: f64,
) -> Row {
    let tracking = match step.tracking {
        Tracking::Exact => "exact",
        Tracking::Rates => "rates",
        Tracking::Limits => "limits",
        Tracking::Reach => "reach",
        Tracking::Target => "target",
    };
    let off = if step.tracking.is_exact() { Residual::ZERO } else { view.residual(&step.q, target) };
    let (q, velocity) = (step.q.to_vec(), step.velocity.to_vec());
    Row { t, q, velocity, at, branch: name(step.branch), tracking, off }
}

/// Why the arm is away from its target.
fn reason<const N: usize>(asked: &Asked, step: &Step<f64, N>) -> String {
    let held: Vec<usize> = step.held.iter().collect();
    let names = asked.arm.joint_names().enumerate().filter(|(joint, _)| held.contains(joint));
    let names = names.map(|(_, name)| name).collect::<Vec<_>>().join(", ");
    match step.tracking {
        Tracking::Exact => "nothing".to_owned(),
        Tracking::Rates if names.is_empty() => "the rates of the joints do not allow it in this time".to_owned(),
        Tracking::Rates => format!("the rates of {names} do not allow it in this time"),
        Tracking::Limits => format!("at the limits of {names}"),
        Tracking::Reach => "the path leaves the reach of the branch".to_owned(),
        Tracking::Target => "the pose is none".to_owned(),
    }
}

/// The joint values at the first pose: those given, else those of the best plan, else any within the limits.
fn start<const N: usize>(asked: &Asked, view: &DynamicView<N>) -> Result<Result<[f64; N], Obstacle>, Failure> {
    let path = |at: f64| asked.path.at(at);
    let limits = denhart::Arm::limits(view);
    let kinds = denhart::Arm::joint_kinds(view);
    let first = path(0.0);
    if let Some(start) = asked.start::<N>()? {
        let mut near = view.inverse(&first);
        view.inverse_given_near_into(&first, &start, &mut near);
        let exact = |solution: &&Solution<f64, N>| solution.is_exact();
        return match near.as_ref().iter().find(exact) {
            Some(one) if away(&start, &one.q) <= NEAR => Ok(Ok(start)),
            Some(one) => {
                let (distance, nearest) = (away(&start, &one.q), one.q.to_vec());
                Err(refused(asked, PlanError::StartAway { distance, nearest }))
            }
            None => Ok(Err(nowhere())),
        };
    }
    match JointPath::new(view, &path, asked.path.end(), &settings(asked)?, &mut |_| {}) {
        Ok(plan) => return Ok(plan.samples().first().map(|sample| sample.q).ok_or_else(nowhere)),
        Err(PlanError::NoPath { .. }) => {}
        Err(error) => return Err(refused(asked, error)),
    }
    let all = view.inverse(&first);
    let inside = all.as_ref().iter().filter(|one| one.is_exact()).find_map(|one| {
        let mut turns = Windings::new(&one.q, &limits, &kinds);
        turns.find(|q| view.combined_limits().iter().all(|limit| limit.holds(q)))
    });
    Ok(inside.ok_or_else(nowhere))
}

/// The largest difference of a joint.
fn away<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The first pose has no solution within the limits.
fn nowhere() -> Obstacle {
    Obstacle {
        at: 0.0,
        branch: String::new(),
        reason: "no joint values within the limits reach the first pose".to_owned(),
    }
}

fn told(error: &FollowError) -> Failure {
    Failure::Usage(error.to_string())
}
