//! The follower that keeps the path.

use super::advance::{Advance, Progress};
use super::aspect::Aspect;
use super::bounds::Bounds;
use super::settings::{FollowError, FollowSettings};
use super::signs::Signs;
use super::step::Tracking;
use crate::arm::InverseKinematics;
use crate::branch::Branch;
use crate::math::Scalar;
use crate::solution::{Solution, Status};

/// Most closed forms of a tick.
const TRIALS: usize = 12;
/// Time in which the path gets from rest to full speed at the earliest, s.
const START: f64 = 0.05;
/// Time without an advance after which a path counts as blocked, s.
const PATIENCE: f64 = 0.05;
/// Share of the rates from which a trial is good enough.
const ENOUGH: f64 = 0.9;

/// Follows a path exactly; where the velocities of the joints do not allow its time, the clock of the path slows down.
///
/// Every tick is an exact solution of the path, within the range of the joints and their velocities. Accelerations are not
/// bounded: the follower does not look ahead, and where a swing begins they reach many times the limit of the motors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathFollower<T, const N: usize> {
    settings: FollowSettings<T, N>,
    bounds: Bounds<T, N>,
    q: [T; N],
    at: T,
    /// Advance of the last tick, s.
    rate: T,
    /// Time without an advance, s.
    waited: T,
    here: Aspect,
}

/// The advance of a tick that was tried last, with what it came to.
struct Trial<T, const N: usize> {
    advance: T,
    solution: Solution<T, N>,
    /// The largest share of its velocity that a joint takes.
    share: T,
}

impl<T: Scalar, const N: usize> PathFollower<T, N> {
    /// An arm at rest at `q`, at time 0 of a path.
    ///
    /// # Errors
    /// Settings or a start with which no tick is possible.
    pub fn new<A: InverseKinematics<T, N>>(
        arm: &A,
        settings: FollowSettings<T, N>,
        q: &[T; N],
    ) -> Result<Self, FollowError> {
        settings.check(arm, q)?;
        let here = Aspect::at(arm, q, &mut A::Solutions::default());
        let (bounds, at) = (Bounds::new(arm, &settings), T::ZERO);
        Ok(Self { settings, bounds, q: *q, at, rate: settings.period, waited: T::ZERO, here })
    }

    /// The step along a path of the duration `end`, s. `path` gives the target at a time from 0 to `end`. `found` is
    /// overwritten.
    ///
    /// The advance is the largest one, of those tried, whose solution the velocities reach in one tick: by bisection,
    /// with at most 12 calls of `inverse_near`.
    pub fn step<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        path: impl Fn(T) -> A::Target,
        end: T,
        found: &mut A::Solutions,
    ) -> Advance<T, N> {
        let rest = end - self.at;
        if rest <= T::ZERO {
            return self.stands(Progress::Done);
        }
        let (best, reason) = self.search(arm, &path, rest, found);
        let Some(trial) = best else {
            self.rate = T::ZERO;
            return self.waits(reason);
        };
        let velocity = self.bounds.to_joints(self.bounds.capped(self.way(&trial.solution.q)));
        self.q = trial.solution.q;
        let before = self.at;
        self.at = if trial.advance >= rest { end } else { before + trial.advance };
        self.rate = trial.advance;
        let period = self.settings.period;
        let signs = Signs::at(arm, &self.q, Some(&path(self.at)));
        let crossed = self.here.arrive(arm, signs, &trial.solution);
        let is_slow = trial.advance < T::from_f64(1e-4) * period && trial.share < T::from_f64(0.3);
        // An advance below the rounding of the time is none, whatever the joints do meanwhile.
        let creeps = is_slow || self.at <= before;
        let state = match () {
            () if self.at >= end => Progress::Done,
            () if creeps => self.waits(reason).state,
            () if trial.advance < period => Progress::Slowed,
            () => Progress::Full,
        };
        if !creeps {
            self.waited = T::ZERO;
        }
        let has_factors = || arm.factors(&self.q, &mut []) > 0;
        let crossed = crossed.filter(|left| *left != Branch::NONE || self.here.branch != Branch::NONE || has_factors());
        Advance {
            velocity: velocity.map(|step| step / period),
            rate: trial.advance / period,
            crossed,
            ..self.stands(state)
        }
    }

    /// Time on the path, s.
    #[must_use]
    pub const fn at(&self) -> T {
        self.at
    }

    /// The joint values now, rad or length unit.
    #[must_use]
    pub const fn q(&self) -> &[T; N] {
        &self.q
    }

    /// The best trial, and the reason why none was better.
    fn search<A: InverseKinematics<T, N>>(
        &self,
        arm: &A,
        path: &impl Fn(T) -> A::Target,
        rest: T,
        found: &mut A::Solutions,
    ) -> (Option<Trial<T, N>>, Tracking) {
        let period = self.settings.period;
        let rise = period * period / T::from_f64(START);
        let mut advance = (self.rate + rise).min(period).min(rest);
        let (mut best, mut reason) = (None, Tracking::Rates);
        let (mut low, mut high) = (T::ZERO, T::INFINITY);
        let middle = |low: T, high: T| T::HALF * (low + high);
        for _ in 0..TRIALS {
            self.solve(arm, &path(self.at + advance), found);
            let nearest = self.nearest(found.as_ref());
            match nearest {
                Some((solution, share)) if share <= T::ONE + T::from_f64(16.0) * T::EPSILON => {
                    low = advance;
                    best = Some(Trial { advance, solution, share });
                    if !high.is_finite() || share > T::from_f64(ENOUGH) {
                        break;
                    }
                    advance = middle(low, high.min(advance / share));
                }
                Some((_, share)) => {
                    (high, reason) = (advance, self.obstacle(share, found.as_ref()));
                    advance = match low > T::ZERO {
                        true => middle(low, high),
                        false => advance * (T::from_f64(0.97) / share).max(T::from_f64(0.05)).min(T::from_f64(0.7)),
                    };
                }
                None => {
                    (high, reason) = (advance, refusal::<A, T, N>(found));
                    advance = middle(low, high);
                }
            }
        }
        (best, reason)
    }

    fn solve<A: InverseKinematics<T, N>>(&self, arm: &A, target: &A::Target, found: &mut A::Solutions) {
        if A::TAKES_VALUES && self.settings.held {
            arm.inverse_near_into(target, &self.q, found);
        } else {
            arm.inverse_branch_near_into(target, Branch::NONE, &self.q, true, found);
        }
    }

    /// The usable solution that takes least of the velocities, and the largest share that it takes.
    fn nearest(&self, solutions: &[Solution<T, N>]) -> Option<(Solution<T, N>, T)> {
        let mut nearest: Option<(Solution<T, N>, T)> = None;
        for solution in solutions.iter().filter(|solution| solution.is_exact() && solution.is_within_limits()) {
            let share = self.bounds.ticks(&self.way(&solution.q));
            if nearest.is_none_or(|(_, least)| share < least) {
                nearest = Some((*solution, share));
            }
        }
        nearest
    }

    /// Why a solution that takes such a share of the velocities does not do: a nearer one is out of limits, or it is too far.
    fn obstacle(&self, share: T, solutions: &[Solution<T, N>]) -> Tracking {
        let beyond = solutions.iter().filter(|solution| solution.is_exact() && !solution.is_within_limits());
        let nearer = beyond.map(|solution| self.bounds.ticks(&self.way(&solution.q))).any(|other| other < share);
        if nearer { Tracking::Limits } else { Tracking::Rates }
    }

    fn way(&self, to: &[T; N]) -> [T; N] {
        self.bounds.way(&self.q, to)
    }

    /// A tick without an advance.
    fn waits(&mut self, reason: Tracking) -> Advance<T, N> {
        self.waited += self.settings.period;
        let blocked = self.waited >= T::from_f64(PATIENCE);
        self.stands(if blocked { Progress::Blocked(reason) } else { Progress::Slowed })
    }

    fn stands(&self, state: Progress) -> Advance<T, N> {
        let (q, velocity, at, branch) = (self.q, [T::ZERO; N], self.at, self.here.branch);
        Advance { q, velocity, at, rate: T::ZERO, state, branch, crossed: None }
    }
}

/// The reason why none of the solutions can be used.
fn refusal<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(found: &A::Solutions) -> Tracking {
    match A::status(found) {
        Status::BadTarget => Tracking::Target,
        Status::Unreachable { .. } => Tracking::Reach,
        Status::Reachable => Tracking::Limits,
    }
}
