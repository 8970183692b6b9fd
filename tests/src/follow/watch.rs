//! Rules that hold in each tick, and the result of a run.

use denhart::follow::{FollowSettings, Follower, PathFollower, Progress, Rates, Step, Tracking};
use denhart::{Branch, InverseKinematics, Scalar};

/// How a run went.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Run {
    /// Largest velocity and acceleration, in parts of their limits.
    pub rates: [f64; 2],
    /// Largest difference of a joint's way from its velocity times the period, in `epsilon (1 + |q|)`.
    pub apart: f64,
    /// Largest distance beyond the range of a joint.
    pub beyond: f64,
    /// Largest deviations: length, rad.
    pub deviation: [f64; 2],
    /// Ticks with a deviation above 1e-6.
    pub away: usize,
    /// Tracking of the last tick.
    pub end: Option<Tracking>,
    /// Largest step of a joint in the last tick.
    pub last_step: f64,
    /// Crossings that were reported.
    pub crossings: usize,
    /// Ticks in which something did not hold: a sign or a branch changed without a word, an exact tick was not.
    pub wrong: usize,
    /// The first of them.
    pub complaint: Option<&'static str>,
}

impl Run {
    fn expect(&mut self, holds: bool, complaint: &'static str) {
        if !holds {
            self.wrong += 1;
            self.complaint = self.complaint.or(Some(complaint));
        }
    }

    /// Returns true if every tick held the limits, and reported its crossings. `slack`: of the rates.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.beyond <= 1e-9 && self.wrong == 0
    }
}

/// A velocity is rounded when it is chosen and when it is cut to its limits, by so much of the rate each time; an
/// acceleration is the difference of two.
fn rounding<T: Scalar>() -> f64 {
    T::EPSILON.to_f64()
}

/// Deviations, in the length unit and rad, up to which a tick is exact.
fn exact<T: Scalar>() -> f64 {
    if T::EPSILON.to_f64() < 1e-10 { 1e-8 } else { 2e-3 }
}

/// Factors from which on the inverse tells one branch from the other.
fn beside<T: Scalar>() -> f64 {
    if T::EPSILON.to_f64() < 1e-10 { 1e-3 } else { 2e-2 }
}

/// Returns true if a branch has each component that another one names.
fn agree(named: Branch, branch: Branch) -> bool {
    named.shoulder().is_none_or(|name| branch.shoulder() == Some(name))
        && named.elbow().is_none_or(|name| branch.elbow() == Some(name))
        && named.wrist().is_none_or(|name| branch.wrist() == Some(name))
}

/// A follower, watched.
pub struct Watch<'a, A: InverseKinematics<T, N>, T, const N: usize> {
    arm: &'a A,
    rates: Rates<T, N>,
    period: T,
    /// The follower.
    pub follower: Follower<T, N>,
    found: A::Solutions,
    last: Option<Step<T, N>>,
    ticks: usize,
    factors: [f64; 8],
    /// The run so far.
    pub run: Run,
}

impl<'a, A: InverseKinematics<T, N>, T: Scalar, const N: usize> Watch<'a, A, T, N> {
    /// A follower at `q`.
    ///
    /// # Panics
    /// If it does not begin.
    pub fn new(arm: &'a A, period: T, rates: Rates<T, N>, settings: FollowSettings<T, N>, q: &[T; N]) -> Self {
        let follower = match Follower::new(arm, settings, q) {
            Ok(follower) => follower,
            Err(error) => panic!("{error}"),
        };
        let found = arm.inverse(&arm.target_at(q));
        let factors = factors(arm, q);
        Self { arm, rates, period, follower, found, last: None, ticks: 0, factors, run: Run::default() }
    }

    /// A tick towards a target.
    pub fn tick(&mut self, target: &A::Target) -> Step<T, N> {
        let before = *self.follower.q();
        let step = self.follower.step(self.arm, target, &mut self.found);
        let residual = self.arm.residual(&step.q, target);
        let [position, angle] = [residual.position, residual.orientation].map(Scalar::to_f64);
        if position.is_finite() && step.tracking != Tracking::Target {
            let [most, turned] = self.run.deviation;
            self.run.deviation = [most.max(position), turned.max(angle)];
            self.run.away += usize::from(position > 1e-6 || angle > 1e-6);
        }
        self.look(&before, &step, position.max(angle));
        step
    }

    /// A tick without a target.
    pub fn stop(&mut self) -> Step<T, N> {
        let before = *self.follower.q();
        let step = self.follower.stop(self.arm);
        self.look(&before, &step, 0.0);
        step
    }

    fn look(&mut self, before: &[T; N], step: &Step<T, N>, residual: f64) {
        let run = &mut self.run;
        let last = self.last.map_or([T::ZERO; N], |last| last.velocity);
        run.last_step = 0.0;
        for joint in 0..N {
            let (v, a) = (self.rates.velocity[joint].to_f64(), self.rates.acceleration[joint].to_f64());
            let (now, then) = (step.velocity[joint].to_f64(), last[joint].to_f64());
            let (q, h) = (step.q[joint].to_f64(), self.period.to_f64());
            let ulp = T::EPSILON.to_f64() * (1.0 + q.abs());
            run.rates[0] = run.rates[0].max(now.abs() / v);
            run.rates[1] = run.rates[1].max((now - then).abs() / h / a);
            run.expect(now.abs() <= v * (1.0 + 2.0 * rounding::<T>()), "a velocity is beyond its limit");
            let change = (now - then).abs();
            run.expect(change <= a * h + 4.0 * rounding::<T>() * v, "an acceleration is beyond its limit");
            // The velocity is that of the step.
            let moved = q - before[joint].to_f64();
            let apart = (moved - now * h).abs() / ulp;
            run.apart = run.apart.max(apart);
            run.expect(apart <= 8.0, "the velocity is not that of the step");
            run.last_step = run.last_step.max(moved.abs());
            let [low, high] = A::LIMITS[joint].map(Scalar::to_f64);
            let beyond = (q - high).max(low - q);
            run.beyond = run.beyond.max(beyond - 16.0 * ulp);
            run.expect(q.is_finite() && now.is_finite(), "not finite");
        }
        let now = factors(self.arm, &step.q);
        let flipped = |(a, b): (&f64, &f64)| a * b < 0.0 && a.abs().min(b.abs()) > 64.0 * T::EPSILON.to_f64();
        let changed = now.iter().zip(&self.factors).any(flipped);
        run.expect(!changed || step.crossed.is_some(), "a factor changed its sign without a word");
        // A component that a singularity leaves open has no name there, and gets one beside it without a crossing: no name
        // changes or goes. The check below compares names with those of the inverse.
        let renamed = self.last.is_some_and(|last| !agree(last.branch, step.branch));
        run.expect(!renamed || step.crossed.is_some(), "the branch changed without a word");
        self.ticks += 1;
        // A joint value may be that of a singularity to the bit, where the inverse gives either name.
        let count = self.arm.factors(&step.q, &mut []);
        let regular = count > 0 && now.iter().take(count).all(|factor| factor.abs() > beside::<T>());
        if regular && self.ticks.is_multiple_of(16) {
            let there = self.arm.inverse_near(&self.arm.target_at(&step.q), &step.q);
            let at = |q: &[T; N]| q.iter().zip(&step.q).all(|(a, b)| (*a - *b).to_f64().abs() < 0.1 * beside::<T>());
            let named = there.as_ref().iter().find(|solution| solution.is_exact() && at(&solution.q));
            run.expect(
                named.is_none_or(|solution| agree(step.branch, solution.branch)),
                "the branch has the name of another one",
            );
        }
        run.crossings += usize::from(step.crossed.is_some());
        if step.tracking.is_exact() {
            run.expect(residual <= exact::<T>(), "an exact tick was not");
        }
        run.end = Some(step.tracking);
        for (known, now) in self.factors.iter_mut().zip(now) {
            if now.abs() > 64.0 * T::EPSILON.to_f64() {
                *known = now;
            }
        }
        self.last = Some(*step);
    }
}

fn factors<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(arm: &A, q: &[T; N]) -> [f64; 8] {
    let mut factors = [T::ZERO; 8];
    arm.factors(q, &mut factors);
    factors.map(Scalar::to_f64)
}

/// How a path was kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kept {
    /// Largest velocity and acceleration, in parts of their limits (accelerations of 8/s where none are given).
    pub rates: [f64; 2],
    /// Time that the path took, s.
    pub time: f64,
    /// State of the last tick.
    pub end: Progress,
    /// Part of the path that was gone.
    pub share: f64,
    /// Largest deviation.
    pub deviation: f64,
}

impl Kept {
    /// Returns true if rates were kept, and the path exactly, with numbers of `T`, up to its end or to where it is blocked.
    #[must_use]
    pub fn holds<T: Scalar>(&self) -> bool {
        let is_over = matches!(self.end, Progress::Done | Progress::Blocked(_));
        is_over && self.rates[0] <= 1.0 + 2.0 * rounding::<T>() && self.deviation <= exact::<T>()
    }
}

/// Keeps a path.
///
/// # Panics
/// If the follower does not begin.
pub fn keep<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
    arm: &A,
    rates: Rates<T, N>,
    settings: FollowSettings<T, N>,
    period: T,
    path: impl Fn(f64) -> A::Target,
    end: f64,
    q: &[T; N],
) -> Kept {
    let mut follower = match PathFollower::new(arm, settings, q) {
        Ok(follower) => follower,
        Err(error) => panic!("{error}"),
    };
    let mut found = arm.inverse(&path(0.0));
    let mut kept = Kept { rates: [0.0; 2], time: 0.0, end: Progress::Full, share: 0.0, deviation: 0.0 };
    let mut last = [T::ZERO; N];
    let target = |at: T| path(at.to_f64());
    let end = T::from_f64(end);
    for _ in 0..100_000 {
        let advance = follower.step(arm, target, end, &mut found);
        kept.time += period.to_f64();
        #[allow(clippy::needless_range_loop)]
        for joint in 0..N {
            let v = rates.velocity[joint].to_f64();
            kept.rates[0] = kept.rates[0].max(advance.velocity[joint].to_f64().abs() / v);
            kept.rates[1] =
                kept.rates[1].max((advance.velocity[joint] - last[joint]).to_f64().abs() / period.to_f64() / (8.0 * v));
        }
        last = advance.velocity;
        let residual = arm.residual(&advance.q, &target(advance.at));
        kept.deviation = kept.deviation.max(residual.position.to_f64()).max(residual.orientation.to_f64());
        kept.end = advance.state;
        kept.share = (advance.at / end).to_f64();
        if matches!(advance.state, Progress::Done | Progress::Blocked(_)) {
            break;
        }
    }
    kept
}
