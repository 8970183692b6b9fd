//! Random paths and targets for a follower.

use denhart::follow::{Crossing, FollowSettings, Rates, Tracking};
use denhart::{InverseKinematics, Pose};

use super::arms::Data;
use super::path::{Path, SPLINE, spline};
use super::table::PERIOD;
use super::watch::{Run, Watch, keep};
use crate::random::Random;

/// Results of many random paths.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Many {
    /// Paths, and those that have a continuous solution from the start: those that the path follower keeps to the end.
    pub paths: [usize; 2],
    /// Of those: ended without an exact tick.
    pub lost: usize,
    /// Ended away, of those without a continuous solution.
    pub away: usize,
    /// Runs in which a limit or a word was missing.
    pub wrong: usize,
    /// Largest velocity and acceleration in parts of their limits.
    pub rates: [f64; 2],
    /// Largest deviations where a continuous solution exists.
    pub deviation: [f64; 2],
    /// Runs that end out of reach or at limits and still move, by more than 1e-3 rad a tick.
    pub restless: usize,
    /// Longest time of the path follower over the path's own.
    pub slowest: f64,
}

impl Many {
    fn note(&mut self, run: &Run) {
        self.wrong += usize::from(!run.holds(1e-6));
        for (most, rate) in self.rates.iter_mut().zip(run.rates) {
            *most = most.max(rate);
        }
        let ended = matches!(run.end, Some(Tracking::Limits | Tracking::Reach));
        self.restless += usize::from(ended && run.last_step > 1e-3);
    }
}

/// Joint values in the box of an arm.
pub fn posture<const N: usize>(data: &Data<N>, random: &mut Random) -> [f64; N] {
    data.drawn.map(|[low, high]| random.uniform(low, high).to_radians())
}

/// Splines around random postures. `target`: from a pose, and from the joint values at its start.
pub fn splines<A, const N: usize>(
    arm: &A,
    data: &Data<N>,
    accelerations: bool,
    count: usize,
    seed: u64,
    target: impl Fn(&Pose<f64>, &[f64; N]) -> A::Target,
) -> Many
where
    A: InverseKinematics<f64, N>,
{
    let mut random = Random::new(seed);
    let mut many = Many::default();
    for _ in 0..count {
        let q = posture(data, &mut random);
        let path = spline(arm.forward(&q), data.reach * 0.1, &mut random);
        let phase = random.uniform(0.0, 1.0) * PERIOD;
        one(arm, data, accelerations, &q, &path, phase, &target, &mut many);
    }
    many
}

#[allow(clippy::too_many_arguments, reason = "the parts of one case")]
fn one<A, const N: usize>(
    arm: &A,
    data: &Data<N>,
    accelerations: bool,
    q: &[f64; N],
    path: &Path<Pose<f64>>,
    phase: f64,
    target: &impl Fn(&Pose<f64>, &[f64; N]) -> A::Target,
    many: &mut Many,
) where
    A: InverseKinematics<f64, N>,
{
    let slow = Rates::velocity(data.rates().velocity);
    let kept = keep(arm, slow, FollowSettings::new(PERIOD, slow), PERIOD, |t| target(&path(t), q), SPLINE, q);
    let continuous = kept.share >= 1.0;
    many.paths[0] += 1;
    many.paths[1] += usize::from(continuous);
    many.wrong += usize::from(kept.rates[0] > 1.0 + 1e-9 || kept.deviation > 1e-8);
    if continuous {
        many.slowest = many.slowest.max(kept.time / SPLINE);
    }
    let rates = if accelerations { data.rates() } else { slow };
    let mut watch = Watch::new(arm, PERIOD, rates, FollowSettings::new(PERIOD, rates), q);
    // A slow arm that keeps the path takes several times as long.
    let time = if continuous { kept.time.max(SPLINE) } else { SPLINE };
    for tick in 1..=(time / PERIOD) as usize + 1500 {
        watch.tick(&target(&path(tick as f64 * PERIOD + phase), q));
    }
    let run = watch.run;
    many.note(&run);
    let exact = run.end == Some(Tracking::Exact);
    if continuous {
        many.lost += usize::from(!exact);
        for (most, deviation) in many.deviation.iter_mut().zip(run.deviation) {
            *most = most.max(deviation);
        }
    } else {
        many.away += usize::from(!exact);
    }
}

/// Results of targets that jump.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Jumps {
    /// Ends: exact, under way, at limits, out of reach.
    pub ends: [usize; 4],
    /// The whole run.
    pub run: Run,
    /// Targets after which the arm still moves, by more than 1e-3 rad a tick.
    pub restless: usize,
    /// Ticks with bad targets, stops among them.
    pub bad: usize,
}

/// Targets that jump: near ones, far ones, some out of reach, each held for 3 s; between them bad ones and stops.
/// `target`: of joint values, and longer by a factor; `bad`: a target that is none.
pub fn jumps<A, const N: usize>(
    arm: &A,
    data: &Data<N>,
    crossing: Crossing,
    count: usize,
    seed: u64,
    target: impl Fn(&[f64; N], f64) -> A::Target,
    bad: impl Fn() -> A::Target,
) -> Jumps
where
    A: InverseKinematics<f64, N>,
{
    let mut random = Random::new(seed);
    let mut result = Jumps::default();
    let rates = data.rates();
    let start = data.drawn.map(|[low, high]| (0.5 * (low + high)).to_radians() + 0.1);
    let settings = FollowSettings::new(PERIOD, rates).crossing(crossing);
    let mut watch = Watch::new(arm, PERIOD, rates, settings, &start);
    for jump in 0..count {
        let size = [0.3, 0.02, 2.0][jump % 3];
        let mut q = *watch.follower.q();
        for (q, [low, high]) in q.iter_mut().zip(data.drawn) {
            *q = (*q + size * random.uniform(-0.5, 0.5)).clamp(low.to_radians(), high.to_radians());
        }
        let target = target(&q, if jump % 10 == 9 { 1.5 } else { 1.0 });
        // While the arm is under way.
        let interrupted = if jump % 4 == 1 { 60 + random.below(60) } else { usize::MAX };
        for tick in 0..3000 {
            if (interrupted..interrupted.saturating_add(20)).contains(&tick) {
                result.bad += 1;
                if jump % 8 == 1 {
                    watch.tick(&bad())
                } else {
                    watch.stop()
                };
            } else {
                watch.tick(&target);
            }
        }
        let end = match watch.run.end {
            Some(Tracking::Exact) => 0,
            Some(Tracking::Limits) => 2,
            Some(Tracking::Reach) => 3,
            _ => 1,
        };
        result.ends[end] += 1;
        result.restless += usize::from(end >= 2 && watch.run.last_step > 1e-3);
    }
    result.run = watch.run;
    result
}
