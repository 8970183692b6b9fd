//! The step of a tick in which no solution is reached.
//!
//! The joint with the longest way leads, and the others follow it so that the tool misses its target least. Joints whose ways
//! take nearly as long lead with it, and arrive with it: of two joints that turn against each other, as past a straight
//! wrist, one that does not lead would be drawn back to the branch that it comes from, and the other after it.

use super::bounds::{Bounds, Interval, units};
use super::brake::{braked, clamp};
use super::choice::Candidate;
use super::follower::Follower;
use super::least_squares::{Factor, Normal};
use super::settings::FollowSettings;
use super::step::Tracking;
use crate::arm::{Arm, InverseKinematics};
use crate::deviation::Deviation;
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
/// A joint whose way takes more than this part of the longest time leads.
const LEADS: f64 = 0.9;
/// Weighted error beyond which every joint goes to its own goal.
const FAR: f64 = 0.3;
/// Default of the length that weighs as 1 rad, in ways along the links: a tenth of what data sheets call the reach of an arm.
const LENGTH: f64 = 0.09;
/// A goal that moves by more than so many times the largest step is not followed.
const FLIGHT: f64 = 2.0;
/// A way that takes longer than so many times the least, and this time in s, ends with every joint on its own.
const PATIENCE: [f64; 2] = [2.0, 0.3];
/// A way beyond this asks for another turn of a joint, rad, if the goal has not been on that turn before.
pub(super) const TURN: f64 = 3.3;

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
    ///
    /// A goal that was on its way in the `last` tick stays so, however far: a joint that goes away from it for a while, as
    /// others lead, would otherwise be turned back at half a turn, and then led away again, for ever.
    pub(super) fn at<A: Arm<T, N>>(arm: &A, candidate: &Candidate<T, N>, q: &[T; N], last: Option<&[T; N]>) -> Self {
        let mut goal = candidate.q;
        let jumps = |joint: usize, goal: T| {
            last.and_then(|last| last.get(joint)).is_none_or(|last| (goal - *last).abs() > T::PI)
        };
        let turns = |(joint, (goal, (q, kind))): (usize, (&T, (&T, JointKind)))| {
            kind == JointKind::Revolute && (*goal - *q).abs() > T::from_f64(TURN) && jumps(joint, *goal)
        };
        let wound = goal.iter().zip(q.iter().zip(arm.joint_kinds())).enumerate().any(turns);
        if candidate.is_within_limits && !wound {
            return Self { goal: Some(goal), tracking: Tracking::Rates, held: JointMask::NONE, ticks: candidate.ticks };
        }
        let mut held = JointMask::NONE;
        let limits = arm.limits().into_iter().zip(arm.joint_kinds());
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
        let (length, angle) = (T::ONE / reach, settings.length.map_or(T::from_f64(LENGTH), |length| length / reach));
        Self { rows: [length, length, length, angle, angle, angle], units: units(arm, reach) }
    }

    /// The units of the motors: rad, or the reach.
    pub(super) const fn units(&self) -> &[T; N] {
        &self.units
    }

    /// The largest entry of a twist, relative to reach and in rad.
    pub(super) fn largest(&self, [x, y, z, turns @ ..]: [T; 6]) -> T {
        let [length, ..] = self.rows;
        let strokes = [x, y, z].iter().fold(T::ZERO, |most, entry| most.max(entry.abs()));
        turns.iter().fold(strokes * length, |most, entry| most.max(entry.abs()))
    }

    fn twist(&self, mut twist: [T; 6]) -> [T; 6] {
        for (entry, weight) in twist.iter_mut().zip(self.rows) {
            *entry *= weight;
        }
        twist
    }

    fn weigh(&self, rows: &mut [[T; N]; 6]) {
        for (row, weight) in rows.iter_mut().zip(self.rows) {
            for (entry, unit) in row.iter_mut().zip(self.units) {
                *entry *= weight * unit;
            }
        }
    }
}

/// The motion of the goal, and what each joint does about it by itself.
struct Own<T, const N: usize> {
    /// The step of each joint to its own goal: the motion of the goal, and the way that is left, with the brake.
    step: [T; N],
    /// Of each joint that leads the step with which all of them arrive together.
    lead: [Option<T>; N],
    /// The longest time, in ticks.
    ticks: T,
    /// The goal moves faster than the joints can.
    fast: bool,
}

/// The least squares of a tick, weighted: which step leaves least of a deviation.
struct System<T, const N: usize> {
    rows: [[T; N]; 6],
    normal: Normal<T, N>,
    /// Twist that the last tick left, and the motion of the target since.
    left: [T; 6],
    moved: [T; 6],
    /// The way of each motor to the ends of its range.
    rooms: Interval<T, N>,
    units: [T; N],
}

impl<T: Scalar, const N: usize> System<T, N> {
    /// `left`, `twist`: what is left of the last tick's deviation, and the one from this tick's target, both weighted.
    fn new(follower: &Follower<T, N>, deviation: &Deviation<T, N>, left: [T; 6], twist: [T; 6], descends: T) -> Self {
        let mut rows = follower.bounds.by_motors(&deviation.jacobian);
        follower.weights.weigh(&mut rows);
        let normal = Normal::new(&rows, T::from_f64(DAMPING) + descends);
        let mut moved = twist;
        for (moved, left) in moved.iter_mut().zip(&left) {
            *moved -= *left;
        }
        let units = follower.weights.units;
        let mut rooms = follower.bounds.rooms(&follower.q);
        for ((low, high), unit) in rooms.low.iter_mut().zip(&mut rooms.high).zip(units) {
            (*low, *high) = (*low / unit, *high / unit);
        }
        Self { rows, normal, left, moved, rooms, units }
    }

    /// The ways of the motors that are not `alone` to the posture that misses the target of the last tick least.
    fn closing(&self, alone: &[Option<T>; N], factor: &mut Option<Factor<T, N>>) -> Closing<T, N> {
        let mut rooms = self.rooms;
        for ((low, high), alone) in rooms.low.iter_mut().zip(&mut rooms.high).zip(alone) {
            if alone.is_some() {
                (*low, *high) = (T::ZERO, T::ZERO);
            }
        }
        let mut ways = self.normal.within(&self.rows, &self.left, &rooms.low, &rooms.high, factor);
        for (((low, high), way), unit) in rooms.low.iter_mut().zip(&mut rooms.high).zip(&mut ways).zip(self.units) {
            (*low, *high) = ((*low - *way).min(T::ZERO), (*high - *way).max(T::ZERO));
            *way *= unit;
        }
        Closing { ways, rooms }
    }

    /// The step of all motors. Those that are `alone` take their own step, and the others go along with them and with the
    /// target. Of their ways they take `share`, and brake in time.
    fn step(
        &self,
        follower: &Follower<T, N>,
        alone: &[Option<T>; N],
        Closing { ways, rooms }: &Closing<T, N>,
        share: T,
        factor: &mut Option<Factor<T, N>>,
    ) -> [T; N] {
        let mut moved = self.moved;
        for (joint, alone) in alone.iter().enumerate() {
            let Some(step) = alone else { continue };
            let scaled = *step / self.units[joint];
            for (moved, row) in moved.iter_mut().zip(&self.rows) {
                *moved -= row[joint] * scaled;
            }
        }
        let forward = self.normal.within(&self.rows, &moved, &rooms.low, &rooms.high, factor);
        let mut step = [T::ZERO; N];
        for joint in 0..N {
            step[joint] = alone[joint].unwrap_or_else(|| {
                forward[joint] * self.units[joint] + braked(share * ways[joint], follower.bounds.change[joint])
            });
        }
        step
    }
}

/// The ways to the posture that misses a target least, with what is left of the rooms there.
struct Closing<T, const N: usize> {
    ways: [T; N],
    rooms: Interval<T, N>,
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
        let deviation = self.deviation(arm, target);
        let twist = self.weights.twist(deviation.twist);
        let left = self.left.map_or(twist, |left| self.weights.twist(left));
        let size = left.iter().fold(T::ZERO, |sum, entry| sum + *entry * *entry).sqrt();
        if let Some(own) = &own
            && size > T::from_f64(FAR)
        {
            return own.step;
        }
        let descends = if own.is_some() { T::ZERO } else { T::from_f64(DESCENT) * size };
        let system = System::new(self, &deviation, left, twist, descends);
        // What moves by itself: joints that lead, joints whose value is given, and those that are locked.
        let mut alone = [None; N];
        for (joint, alone) in alone.iter_mut().enumerate() {
            let locked = self.bounds.most.get(joint) == Some(&T::ZERO);
            *alone = leader.and_then(|own| own.lead.get(joint).copied().flatten());
            if alone.is_none() && (locked || deviation.given.contains(joint)) {
                *alone = Some(own.as_ref().and_then(|own| own.step.get(joint)).copied().unwrap_or(T::ZERO));
            }
        }
        let mut factor = None;
        if leader.is_some() {
            let closing = system.closing(&alone, &mut factor);
            return interval.cut(system.step(self, &alone, &closing, T::ONE, &mut factor));
        }
        // Without a goal for each joint the one leads whose way by least squares takes longest, if it takes more than a tick.
        let share = T::from_f64(SLOW);
        let closing = system.closing(&alone, &mut factor);
        let (mut most, mut longest) = (T::ONE, None);
        for (joint, (way, velocity)) in closing.ways.iter().zip(&self.bounds.most).enumerate() {
            if *velocity > T::ZERO && way.abs() > most * *velocity {
                (most, longest) = (way.abs() / *velocity, Some(joint));
            }
        }
        let Some(joint) = longest else {
            return interval.cut(system.step(self, &alone, &closing, share, &mut factor));
        };
        let mut led = closing.ways;
        for (led, change) in led.iter_mut().zip(&self.bounds.change) {
            *led = braked(share * *led, *change);
        }
        if let Some((alone, led)) = alone.iter_mut().zip(interval.cut(led)).nth(joint) {
            *alone = Some(led);
        }
        let closing = system.closing(&alone, &mut factor);
        interval.cut(system.step(self, &alone, &closing, share, &mut factor))
    }

    /// The step of each joint towards the goal.
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
        let faster =
            |times: T| last.is_none() || motion.iter().zip(most).any(|(motion, most)| motion.abs() > times * *most);
        let flees = tracking == Tracking::Rates && faster(T::from_f64(FLIGHT));
        let mut own = Own { step: interval.rest(), lead: [None; N], ticks: T::ZERO, fast: flees || faster(T::ONE) };
        let mut times = [T::ZERO; N];
        for i in 0..N {
            if !flees {
                let along = clamp(motion[i], -most[i], most[i]);
                own.step[i] = clamp(along + braked(way[i] - along, change[i]), interval.low[i], interval.high[i]);
            }
            times[i] = if most[i] > T::ZERO { (way[i] - own.step[i]).abs() / most[i] } else { T::ZERO };
            own.ticks = own.ticks.max(times[i]);
        }
        for ((lead, step), time) in own.lead.iter_mut().zip(own.step).zip(times) {
            let share = time / own.ticks;
            *lead = (share > T::from_f64(LEADS)).then_some(share * step);
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
            // One by one: constants become constants of `T` however little is optimized.
            let (times, seconds) = (T::from_f64(PATIENCE[0]), T::from_f64(PATIENCE[1]));
            self.allowed = times * own.ticks + seconds * self.second();
        }
        self.under_way > self.allowed
    }
}
