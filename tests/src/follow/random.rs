//! Random paths and targets for a follower.

use denhart::follow::{Crossing, FollowSettings, Rates, Step, Tracking};
use denhart::{InverseKinematics, Pose, Scalar};

use super::arms::Data;
use super::path::{SPLINE, spline};
use super::table::PERIOD;
use super::watch::{Run, Watch, keep};
use crate::random::Random;

/// Results of many random paths.
#[derive(Debug, Clone, Default, PartialEq)]
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
    /// Largest difference of a joint's way from its velocity times the period, in `epsilon (1 + |q|)`.
    pub apart: f64,
    /// Largest deviations where a continuous solution exists.
    pub deviation: [f64; 2],
    /// Runs that do not come to rest: an arm still moves 10 s after the end of its path, by more than 1e-3 rad a tick.
    pub restless: usize,
    /// Longest time from the end of the path to rest at its last target, s.
    pub longest: f64,
    /// Largest step of a joint in the last half second of a run that ends away.
    pub creep: f64,
    /// Longest time of the path follower over the path's own.
    pub slowest: f64,
    /// Numbers of the paths that are lost, wrong or restless.
    pub failed: Vec<usize>,
}

impl Many {
    /// Returns true if no path failed.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.lost == 0 && self.wrong == 0 && self.restless == 0
    }
}

/// Time after the end of a path for which its last target is held at most, s. An arm at its limits waits for
/// [a second or two](WAITS) before it leaves a branch. Then two turns of a joint of the UR5, which its range allows, take 4 s
/// at full rate, and a way may take twice the least time before every joint goes on its own.
const BACK: f64 = 10.0;
/// An arm that is still for longer than it waits before it leaves a branch, and the one from which it has strayed, stays, s.
const WAITS: f64 = 2.1;
/// Step of an arm that is still.
const STILL: f64 = 1e-9;
/// Step of an arm that is at rest.
const REST: f64 = 1e-3;

/// The ticks of a time.
fn ticks_of(time: f64) -> usize {
    (time / PERIOD) as usize
}

/// A pose with numbers of another kind.
fn converted<S: Scalar, T: Scalar>(pose: &Pose<S>) -> Pose<T> {
    let number = |x: S| T::from_f64(x.to_f64());
    Pose { rotation: pose.rotation.map(|row| row.map(number)), translation: pose.translation.map(number) }
}

/// Joint values in the box of an arm.
pub fn posture<const N: usize>(data: &Data<N>, random: &mut Random) -> [f64; N] {
    data.drawn.map(|[low, high]| random.uniform(low, high).to_radians())
}

/// Splines around random postures.
#[derive(Debug, Clone, Copy)]
pub struct Splines {
    /// Accelerations are bounded too.
    pub accelerations: bool,
    /// How many.
    pub count: usize,
    /// All numbers follow from it.
    pub seed: u64,
    /// The number of the only one to follow.
    pub only: Option<usize>,
}

impl Splines {
    /// Follows them. `target`: from a pose, and from the joint values at its start. `see`: the time of each tick, its target
    /// and the answer.
    pub fn follow<A, T: Scalar, const N: usize>(
        &self,
        arm: &A,
        data: &Data<N>,
        target: impl Fn(&Pose<T>, &[T; N]) -> A::Target,
        mut see: impl FnMut(f64, &A::Target, &Step<T, N>),
    ) -> Many
    where
        A: InverseKinematics<T, N>,
    {
        let mut random = Random::new(self.seed);
        let mut many = Many::default();
        for number in 0..self.count {
            let q = posture(data, &mut random).map(T::from_f64);
            let path = spline(converted(&arm.forward(&q)), data.reach * 0.1, &mut random);
            let phase = random.uniform(0.0, 1.0) * PERIOD;
            if self.only.is_none_or(|only| only == number) {
                let path = |t: f64| target(&converted(&path(t)), &q);
                self.one(arm, data, (number, &q, phase), path, &mut many, &mut see);
            }
        }
        many
    }

    fn one<A, T: Scalar, const N: usize>(
        &self,
        arm: &A,
        data: &Data<N>,
        (number, q, phase): (usize, &[T; N], f64),
        path: impl Fn(f64) -> A::Target,
        many: &mut Many,
        see: &mut impl FnMut(f64, &A::Target, &Step<T, N>),
    ) where
        A: InverseKinematics<T, N>,
    {
        let Rates { velocity, acceleration } = data.rates();
        let fast = Rates { velocity: velocity.map(T::from_f64), acceleration: acceleration.map(T::from_f64) };
        let (slow, period) = (Rates::velocity(fast.velocity), T::from_f64(PERIOD));
        let kept = keep(arm, slow, FollowSettings::new(period, slow), period, &path, SPLINE, q);
        let continuous = kept.share >= 1.0;
        many.paths[0] += 1;
        many.paths[1] += usize::from(continuous);
        if continuous {
            many.slowest = many.slowest.max(kept.time / SPLINE);
        }
        let rates = if self.accelerations { fast } else { slow };
        let mut watch = Watch::new(arm, period, rates, FollowSettings::new(period, rates), q);
        let still_step = STILL.max(8.0 * T::EPSILON.to_f64());
        let (mut still, mut ticks, mut moves) = (0, 0, 0.0_f64);
        while ticks < ticks_of(SPLINE) || (still <= ticks_of(WAITS) && ticks < ticks_of(SPLINE + BACK)) {
            ticks += 1;
            let at = ticks as f64 * PERIOD;
            let target = path(at + phase);
            let step = watch.tick(&target);
            see(at, &target, &step);
            let rests = watch.run.last_step < still_step;
            moves = if ticks % ticks_of(0.5) == 1 { 0.0 } else { moves }.max(watch.run.last_step);
            still = match step.tracking {
                Tracking::Exact if rests => usize::MAX,
                _ if rests && ticks > ticks_of(SPLINE) => still + 1,
                _ => 0,
            };
        }
        let run = watch.run;
        let exact = run.end == Some(Tracking::Exact);
        let (lost, restless) = (continuous && !exact, moves > REST && !exact);
        let wrong = !kept.holds::<T>() || !run.holds();
        if exact {
            many.longest = many.longest.max(ticks as f64 * PERIOD - SPLINE);
        } else {
            many.creep = many.creep.max(moves);
        }
        many.lost += usize::from(lost);
        many.away += usize::from(!continuous && !exact);
        many.wrong += usize::from(wrong);
        many.restless += usize::from(restless);
        if lost || restless || wrong {
            many.failed.push(number);
        }
        for (most, rate) in many.rates.iter_mut().zip(run.rates) {
            *most = most.max(rate);
        }
        many.apart = many.apart.max(run.apart);
        for (most, deviation) in many.deviation.iter_mut().zip(run.deviation).filter(|_| continuous) {
            *most = most.max(deviation);
        }
    }
}

/// Results of targets that jump.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Jumps {
    /// Ends: exact, under way, at limits, out of reach.
    pub ends: [usize; 4],
    /// The whole run.
    pub run: Run,
    /// Targets at whose limits, or out of whose reach, the arm still moves after 10 s more, by more than 1e-3 rad a tick.
    pub restless: usize,
    /// Ticks with bad targets, stops among them.
    pub bad: usize,
}

/// Targets that jump: near ones, far ones, some out of reach, each held for 3 s; between them bad ones and stops.
/// `target`: of joint values, and longer by a factor; `bad`: a target that is none.
pub fn jumps<A, T: Scalar, const N: usize>(
    arm: &A,
    data: &Data<N>,
    crossing: Crossing,
    count: usize,
    seed: u64,
    target: impl Fn(&[T; N], T) -> A::Target,
    bad: impl Fn() -> A::Target,
) -> Jumps
where
    A: InverseKinematics<T, N>,
{
    let mut random = Random::new(seed);
    let mut result = Jumps::default();
    let Rates { velocity, acceleration } = data.rates();
    let rates = Rates { velocity: velocity.map(T::from_f64), acceleration: acceleration.map(T::from_f64) };
    let start = data.drawn.map(|[low, high]| T::from_f64((0.5 * (low + high)).to_radians() + 0.1));
    let settings = FollowSettings::new(T::from_f64(PERIOD), rates).crossing(crossing);
    let mut watch = Watch::new(arm, T::from_f64(PERIOD), rates, settings, &start);
    for jump in 0..count {
        let size = [0.3, 0.02, 2.0][jump % 3];
        let mut q = *watch.follower.q();
        for (q, [low, high]) in q.iter_mut().zip(data.drawn) {
            let drawn = q.to_f64() + size * random.uniform(-0.5, 0.5);
            *q = T::from_f64(drawn.clamp(low.to_radians(), high.to_radians()));
        }
        let target = target(&q, if jump % 10 == 9 { T::from_f64(1.5) } else { T::ONE });
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
        // A way may take longer.
        let moves = |run: &Run| run.last_step > REST && matches!(run.end, Some(Tracking::Limits | Tracking::Reach));
        let mut more = 0;
        while moves(&watch.run) && more < ticks_of(BACK) {
            more += 1;
            watch.tick(&target);
        }
        let end = match watch.run.end {
            Some(Tracking::Exact) => 0,
            Some(Tracking::Limits) => 2,
            Some(Tracking::Reach) => 3,
            _ => 1,
        };
        result.ends[end] += 1;
        result.restless += usize::from(moves(&watch.run));
    }
    result.run = watch.run;
    result
}
