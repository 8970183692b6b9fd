//! The times are kept: the follower.

use denhart::follow::{FollowSettings, Follower, Step, Tracking};
use denhart::{Arm, InverseKinematics, Residual, Solution, Windings};
use denhart_dynamic::plan::PlanError;
use denhart_dynamic::{DynamicView, ViewSolutions, WholeTarget};

use super::asked::{Asked, Refused};
use super::keep_path::plan;
use super::motion::{Motion, Obstacle, Row, name};

/// A start is this near to a solution of the first pose, rad.
const NEAR: f64 = 1e-3;

/// The motion that keeps the times, tick by tick.
pub fn motion<const N: usize>(
    asked: &Asked<'_>,
    view: &DynamicView<'_, N>,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<Motion, Refused> {
    if !asked.is_timed() {
        return Err(Refused::Untimed);
    }
    let end = asked.end();
    // The last tick is a whole period too: its target is the end of the path.
    let ticks = (end / asked.period * (1.0 - 1e-12)).ceil();
    let times = asked.times(ticks * asked.period)?;
    let start = match start(asked, view, watch)? {
        Ok(start) => start,
        Err(obstacle) => return Ok(obstacle.into()),
    };
    let mut settings = FollowSettings::new(asked.period, asked.rates());
    if asked.motor_rates {
        settings = settings.linked(|q| view.to_motor(q), |motor| view.from_motor(motor));
    }
    let mut follower = Follower::new(view, settings, &start)?;
    let mut found = ViewSolutions::default();
    let mut rows = Vec::new();
    let first = asked.at(0.0);
    let branch = view.inverse_near(&first, &start).as_ref().first().map_or_else(String::new, |one| name(one.branch));
    let off = view.residual(&start, &first);
    let (q, velocity) = (start.to_vec(), vec![0.0; N]);
    rows.push(Row { t: 0.0, q, velocity, at: 0.0, branch, tracking: "exact", off });
    let mut last = None;
    for t in (1..times.count()).map(|tick| times.at(tick)) {
        let at = t.min(end);
        let target = asked.at(at);
        let step = follower.step(view, &target, &mut found);
        rows.push(row(view, &step, &target, t, at));
        if !watch(at) {
            return Err(Refused::Ended);
        }
        last = Some(step);
    }
    let obstacle = last.filter(|step| !step.tracking.is_exact()).map(|step| Obstacle {
        at: end,
        branch: name(step.branch),
        reason: reason(asked, &step),
    });
    Ok(Motion { rows, obstacle })
}

fn row<const N: usize>(view: &DynamicView<'_, N>, step: &Step<f64, N>, target: &WholeTarget, t: f64, at: f64) -> Row {
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
fn reason<const N: usize>(asked: &Asked<'_>, step: &Step<f64, N>) -> String {
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
fn start<const N: usize>(
    asked: &Asked<'_>,
    view: &DynamicView<'_, N>,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<Result<[f64; N], Obstacle>, Refused> {
    let first = asked.at(0.0);
    if let Some(start) = asked.start::<N>()? {
        let mut near = view.inverse(&first);
        view.inverse_given_near_into(&first, &start, &mut near);
        let exact = |solution: &&Solution<f64, N>| solution.is_exact();
        return match near.as_ref().iter().find(exact) {
            Some(one) if away(&start, &one.q) <= NEAR => Ok(Ok(start)),
            Some(one) => {
                let (distance, nearest) = (away(&start, &one.q), one.q.to_vec());
                Err(Refused::Plan(PlanError::StartAway { distance, nearest }))
            }
            None => Ok(Err(nowhere())),
        };
    }
    // The motion has not begun.
    if let Ok(plan) = plan(asked, view, &mut |_| watch(0.0))? {
        return Ok(plan.samples().first().map(|sample| sample.q).ok_or_else(nowhere));
    }
    let (limits, kinds) = (view.limits(), view.joint_kinds());
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
