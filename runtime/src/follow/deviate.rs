//! The step of a tick in which no solution is reached.
//!
//! The joint with the longest way leads, and the others follow it so that the tool misses its target least.

use super::bounds::{Bounds, Interval, units};
use super::brake::{braked, clamp};
use super::choice::Candidate;
use super::follower::Follower;
use super::least_squares::Normal;
use super::settings::FollowSettings;
use super::step::Tracking;
use crate::arm::{Arm, InverseKinematics};
use crate::dh::JointKind;
use crate::flags::JointMask;
use crate::math::Scalar;
use crate::numeric::model::way_along_the_links;

/// Part of the sum of squares that damps the step.
const DAMPING: f64 = 1e-4;
/// Growth of the damping with the error, where no solution is known: a descent that does not swing through.
const DESCENT: f64 = 0.5;
/// Share of a descent's step that is taken.
const SLOW: f64 = 0.5;
/// Weighted error beyond which every joint goes to its own goal.
const FAR: f64 = 0.3;
/// A goal that moves by more than so many times the largest step is not followed.
const FLIGHT: f64 = 2.0;
/// A way that takes longer than so many times the least, and this time in s, ends with every joint on its own.
const PATIENCE: [f64; 2] = [2.0, 0.3];
/// A way beyond this asks for another turn of a joint, rad.
const TURN: f64 = 3.3;

/// Where an arm wants to go in a tick.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aim<T, const N: usize> {
    /// The joint values; none without a solution.
    pub(super) goal: Option<[T; N]>,
    pub(super) tracking: Tracking,
    pub(super) held: JointMask,
    /// Time of the way at full rates, in ticks.
    pub(super) ticks: T,
}

impl<T: Scalar, const N: usize> Aim<T, N> {
    /// No solution is known.
    pub(super) fn out_of_reach() -> Self {
        Self { goal: None, tracking: Tracking::Reach, held: JointMask::NONE, ticks: T::INFINITY }
    }

    /// A solution; where limits keep the arm from it, without the whole turns that they ask for, and within the range.
    pub(super) fn at<A: Arm<T, N>>(candidate: &Candidate<T, N>, q: &[T; N]) -> Self {
        let mut goal = candidate.q;
        let turns = |(goal, (q, kind)): (&T, (&T, JointKind))| {
            kind == JointKind::Revolute && (*goal - *q).abs() > T::from_f64(TURN)
        };
        let wound = goal.iter().zip(q.iter().zip(A::JOINT_KINDS)).any(turns);
        if candidate.within_limits && !wound {
            return Self { goal: Some(goal), tracking: Tracking::Rates, held: JointMask::NONE, ticks: candidate.ticks };
        }
        let mut held = JointMask::NONE;
        let limits = A::LIMITS.into_iter().zip(A::JOINT_KINDS);
        for (joint, ((goal, q), ([low, high], kind))) in goal.iter_mut().zip(q).zip(limits).enumerate() {
            if kind == JointKind::Revolute {
                *goal -= ((*goal - *q) / T::TAU).round_ties_even() * T::TAU;
            }
            let inside = clamp(*goal, low, high);
            if inside != *goal {
                held.insert(JointMask::single(joint));
                *goal = inside;
            }
        }
        Self { goal: Some(goal), tracking: Tracking::Limits, held, ticks: T::INFINITY }
    }
}

/// Weights of a deviation: lengths over the reach, angles over reach and the length that weighs as 1 rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weights<T, const N: usize> {
    rows: [T; 6],
    /// The motors' units for least squares.
    units: [T; N],
}

impl<T: Scalar, const N: usize> Weights<T, N> {
    pub(super) fn new<A: Arm<T, N>>(arm: &A, settings: &FollowSettings<T, N>, q: &[T; N]) -> Self {
        let reach = way_along_the_links(arm, q);
        let (length, angle) = (T::ONE / reach, settings.length.map_or(T::from_f64(0.1), |length| length / reach));
        Self { rows: [length, length, length, angle, angle, angle], units: units::<A, T, N>(reach) }
    }

    fn twist(&self, mut twist: [T; 6]) -> [T; 6] {
        for (entry, weight) in twist.iter_mut().zip(self.rows) {
            *entry *= weight;
        }
        twist
    }

    fn rows(&self, mut rows: [[T; N]; 6]) -> [[T; N]; 6] {
        for (row, weight) in rows.iter_mut().zip(self.rows) {
            for (entry, unit) in row.iter_mut().zip(self.units) {
                *entry *= weight * unit;
            }
        }
        rows
    }
}

/// The motion of the goal, and what each joint does about it by itself.
struct Own<T, const N: usize> {
    /// The step of each joint to its own goal: the motion of the goal, and the way that is left, with the brake.
    step: [T; N],
    /// The joint with the longest time.
    leader: Option<usize>,
    /// That time, in ticks.
    ticks: T,
    /// The goal moves faster than the joints can.
    fast: bool,
}

impl<T: Scalar, const N: usize> Follower<T, N> {
    /// The step of the motors of a tick without a solution.
    pub(super) fn deviate<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        target: &A::Target,
        aim: &Aim<T, N>,
        interval: &Interval<T, N>,
    ) -> [T; N] {
        let own = aim.goal.map(|goal| self.own(&goal, aim.tracking, interval));
        let leader = own.as_ref().filter(|_| aim.tracking == Tracking::Rates);
        match leader {
            Some(own) if self.takes_too_long(own) => return own.step,
            Some(_) => {}
            None => (self.under_way, self.allowed) = (T::ZERO, T::ZERO),
        }
        let deviation = arm.deviation(&self.q, target);
        let twist = self.weights.twist(deviation.twist);
        let left = self.left.map_or(twist, |left| self.weights.twist(left));
        let size = left.iter().fold(T::ZERO, |sum, entry| sum + *entry * *entry).sqrt();
        if let Some(own) = &own
            && size > T::from_f64(FAR)
        {
            return own.step;
        }
        let leads = |joint: usize| leader.is_some_and(|own| own.leader == Some(joint));
        let rows = self.weights.rows(self.bounds.by_motors(&deviation.jacobian));
        // What moves by itself: the leader, joints whose value is given, and those that are locked.
        let mut step = [T::ZERO; N];
        let mut alone = [false; N];
        for (joint, (alone, step)) in alone.iter_mut().zip(&mut step).enumerate() {
            *alone = leads(joint) || deviation.given.contains(joint) || self.bounds.most.get(joint) == Some(&T::ZERO);
            if *alone && let Some(own) = own.as_ref().and_then(|own| own.step.get(joint)) {
                *step = *own;
            }
        }
        let mut moved = twist;
        for ((moved, row), left) in moved.iter_mut().zip(&rows).zip(&left) {
            let led = row.iter().zip(&step).zip(self.weights.units).fold(T::ZERO, |sum, ((a, x), u)| sum + *a * *x / u);
            *moved = *moved - *left - led;
        }
        let descends = if own.is_some() { T::ZERO } else { T::from_f64(DESCENT) * size };
        let normal = Normal::new(&rows, T::from_f64(DAMPING) + descends);
        let mut rooms = self.bounds.rooms(&self.q);
        for (((low, high), alone), unit) in
            rooms.low.iter_mut().zip(&mut rooms.high).zip(&alone).zip(self.weights.units)
        {
            (*low, *high) = if *alone { (T::ZERO, T::ZERO) } else { (*low / unit, *high / unit) };
        }
        let closing = normal.within(&rows, &left, &rooms.low, &rooms.high);
        for ((low, high), closing) in rooms.low.iter_mut().zip(&mut rooms.high).zip(&closing) {
            (*low, *high) = ((*low - *closing).min(T::ZERO), (*high - *closing).max(T::ZERO));
        }
        let forward = normal.within(&rows, &moved, &rooms.low, &rooms.high);
        let share = if leader.is_some() { T::ONE } else { T::from_f64(SLOW) };
        for i in 0..N {
            if !alone[i] {
                let unit = self.weights.units[i];
                step[i] = forward[i] * unit + braked(share * closing[i] * unit, self.bounds.change[i]);
            }
        }
        interval.cut(step)
    }

    /// What each joint does to go to the goal.
    fn own(&self, goal: &[T; N], tracking: Tracking, interval: &Interval<T, N>) -> Own<T, N> {
        let Bounds { most, change, .. } = &self.bounds;
        let way = self.way(goal);
        let last = self.goal.map(|last| self.way(&last));
        let mut motion = [T::ZERO; N];
        if let Some(last) = &last {
            for (motion, (way, last)) in motion.iter_mut().zip(way.iter().zip(last)) {
                *motion = *way - *last;
            }
        }
        let faster = |times: T| last.is_none() || motion.iter().zip(most).any(|(motion, most)| motion.abs() > times * *most);
        let flees = tracking == Tracking::Rates && faster(T::from_f64(FLIGHT));
        let mut own = Own { step: interval.rest(), leader: None, ticks: T::ZERO, fast: flees || faster(T::ONE) };
        for i in 0..N {
            if !flees {
                let along = clamp(motion[i], -most[i], most[i]);
                own.step[i] = clamp(along + braked(way[i] - along, change[i]), interval.low[i], interval.high[i]);
            }
            let ticks = if most[i] > T::ZERO { (way[i] - own.step[i]).abs() / most[i] } else { T::ZERO };
            if ticks > own.ticks {
                (own.ticks, own.leader) = (ticks, Some(i));
            }
        }
        own
    }

    /// Counts a tick on the way to a goal that does not flee. Returns true if the arm has been on it for too long.
    fn takes_too_long(&mut self, own: &Own<T, N>) -> bool {
        if own.fast {
            (self.under_way, self.allowed) = (T::ZERO, T::ZERO);
            return false;
        }
        self.under_way += T::ONE;
        if self.allowed == T::ZERO {
            let [times, seconds] = PATIENCE.map(T::from_f64);
            self.allowed = times * own.ticks + seconds * self.second();
        }
        self.under_way > self.allowed
    }
}
