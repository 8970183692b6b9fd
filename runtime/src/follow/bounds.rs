//! The steps that the limits allow in a tick.
//!
//! Everything here is in the coordinates of the motors: those of the joints, but for joints whose motors are linked.

use super::brake::{brake_up_to, clamp};
use super::linear::product;
use super::settings::{FollowSettings, Linked};
use crate::arm::{Arm, InverseKinematics};
use crate::combined_limit::CombinedLimit;
use crate::dh::JointKind;
use crate::jacobian::Jacobian;
use crate::math::Scalar;

/// The intervals of the steps of one tick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval<T, const N: usize> {
    pub(super) low: [T; N],
    pub(super) high: [T; N],
}

impl<T: Scalar, const N: usize> Interval<T, N> {
    /// A step cut to the intervals.
    pub(super) fn cut(&self, mut step: [T; N]) -> [T; N] {
        for (step, (low, high)) in step.iter_mut().zip(self.low.iter().zip(&self.high)) {
            *step = clamp(*step, *low, *high);
        }
        step
    }

    /// Returns true if a motor's way to the joint value `q` is a step of its interval, up to rounding.
    #[inline]
    pub(super) fn allows(&self, motor: usize, q: T, way: T) -> bool {
        let rounding = rounding(q);
        let ends = self.low.get(motor).zip(self.high.get(motor));
        ends.is_some_and(|(low, high)| way >= *low - rounding && way <= *high + rounding)
    }

    /// The sum of the longest steps, in units of the joints.
    pub(super) fn longest(&self, units: &[T; N]) -> T {
        let ends = self.low.iter().zip(&self.high).zip(units);
        ends.fold(T::ZERO, |sum, ((low, high), unit)| sum + high.max(-*low) / *unit)
    }

    /// The step that is nearest to rest.
    pub(super) fn rest(&self) -> [T; N] {
        self.cut([T::ZERO; N])
    }
}

/// How far a joint value of this size may be off by rounding.
pub(super) fn rounding<T: Scalar>(q: T) -> T {
    T::from_f64(4.0) * T::EPSILON * (T::ONE + q.abs())
}

/// The limits of an arm for a tick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds<T, const N: usize> {
    /// Largest step of each motor.
    pub(super) most: [T; N],
    /// Largest change of that step from tick to tick.
    pub(super) change: [T; N],
    /// The range of each motor that is its joint; infinite for linked ones.
    range: [[T; 2]; N],
    linked: Option<Linked<T, N>>,
}

impl<T: Scalar, const N: usize> Bounds<T, N> {
    pub(super) fn new<A: InverseKinematics<T, N>>(arm: &A, settings: &FollowSettings<T, N>) -> Self {
        let period = settings.period;
        let mut most = settings.rates.velocity.map(|velocity| velocity * period);
        let change = settings.rates.acceleration.map(|acceleration| acceleration * period * period);
        let mut range = arm.limits();
        for (joint, (most, range)) in most.iter_mut().zip(&mut range).enumerate() {
            if settings.locked.contains(joint) {
                *most = T::ZERO;
            }
            if settings.linked.is_some_and(|linked| !linked.is_own(joint)) {
                *range = [-T::INFINITY, T::INFINITY];
            }
        }
        Self { most, change, range, linked: settings.linked }
    }

    /// Returns true if motors are linked.
    pub(super) const fn are_linked(&self) -> bool {
        self.linked.is_some()
    }

    /// A step of the joints as one of the motors.
    #[allow(clippy::wrong_self_convention)]
    pub(super) fn to_motors(&self, joints: [T; N]) -> [T; N] {
        self.linked.as_ref().map_or(joints, |linked| product(&linked.to_motor, &joints))
    }

    /// A step of the motors as one of the joints.
    #[allow(clippy::wrong_self_convention)]
    pub(super) fn to_joints(&self, motors: [T; N]) -> [T; N] {
        self.linked.as_ref().map_or(motors, |linked| product(&linked.from_motor, &motors))
    }

    /// The way of the motors from joint values to others.
    pub(super) fn way(&self, from: &[T; N], to: &[T; N]) -> [T; N] {
        let mut way = *to;
        for (way, from) in way.iter_mut().zip(from) {
            *way -= *from;
        }
        self.to_motors(way)
    }

    /// A step cut to the velocities.
    pub(super) fn capped(&self, mut step: [T; N]) -> [T; N] {
        for (step, most) in step.iter_mut().zip(&self.most) {
            *step = clamp(*step, -*most, *most);
        }
        step
    }

    /// A Jacobian by the joints as one by the motors.
    pub(super) fn by_motors(&self, jacobian: &Jacobian<T, N>) -> [[T; N]; 6] {
        let Some(linked) = &self.linked else { return jacobian.rows };
        jacobian.rows.map(|row| {
            let mut by_motors = [T::ZERO; N];
            for (entry, line) in row.iter().zip(&linked.from_motor) {
                for (sum, factor) in by_motors.iter_mut().zip(line) {
                    *sum += *entry * *factor;
                }
            }
            by_motors
        })
    }

    /// The way that is left of each motor to the ends of its range, `low <= 0 <= high`.
    pub(super) fn rooms(&self, q: &[T; N]) -> Interval<T, N> {
        let mut rooms = Interval { low: [-T::INFINITY; N], high: [T::INFINITY; N] };
        let ends = rooms.low.iter_mut().zip(&mut rooms.high);
        for ((low, high), (q, [least, most])) in ends.zip(q.iter().zip(self.range)) {
            (*low, *high) = ((least - *q).min(T::ZERO), (most - *q).max(T::ZERO));
        }
        rooms
    }

    /// The joint values after a step of the motors from `q`, within their ranges.
    pub(super) fn after(&self, q: &[T; N], step: [T; N]) -> [T; N] {
        let (rooms, mut after) = (self.rooms(q), *q);
        for ((q, step), (low, high)) in
            after.iter_mut().zip(self.to_joints(step)).zip(rooms.low.iter().zip(&rooms.high))
        {
            *q += clamp(step, *low, *high);
        }
        after
    }

    /// The intervals of the next step at `q`, after a `step`: by velocity, by acceleration, and so that the motor can
    /// brake before the end of its range. They are never empty from rest on.
    pub(super) fn interval(&self, q: &[T; N], step: &[T; N]) -> Interval<T, N> {
        let mut interval = self.rooms(q);
        let ends = interval.low.iter_mut().zip(&mut interval.high);
        for ((low, high), ((most, change), step)) in ends.zip(self.most.iter().zip(&self.change).zip(step)) {
            // Ends of a range that is left by rounding give way to the acceleration.
            let (slowest, fastest) = ((*step - *change).max(-*most), (*step + *change).min(*most));
            *low = (-brake_up_to(-*low, *change, -slowest)).min(fastest);
            *high = brake_up_to(*high, *change, fastest).max(slowest);
        }
        interval
    }

    /// The time of a way at full rates, in ticks; a motor that is locked does not count.
    pub(super) fn ticks(&self, way: &[T; N]) -> T {
        let ways = way.iter().zip(&self.most).filter(|(_, most)| **most > T::ZERO);
        ways.fold(T::ZERO, |time, (way, most)| time.max(way.abs() / *most))
    }

    /// Returns true if no sum of joints that has a limit of its own leaves it: after the step all motors can brake
    /// together, each sum by the same share in each tick, to rest within the limit.
    pub(super) fn sums_hold<A: InverseKinematics<T, N>>(&self, arm: &A, q: &[T; N], step: &[T; N]) -> bool {
        let combined = arm.combined_limits();
        if combined.is_empty() && self.linked.is_none() {
            return true;
        }
        let changes = step.iter().zip(&self.change).filter(|(_, change)| change.is_finite());
        let ticks = changes.fold(T::ZERO, |ticks, (step, change)| ticks.max(step.abs() / *change));
        let joints = self.to_joints(*step);
        let stop = T::ONE + ticks * T::HALF;
        let holds = |limit: &CombinedLimit<T, N>| {
            let (at, way) = (limit.sum(q), limit.sum(&joints) * stop);
            let [low, high] = limit.limits;
            let rounding = T::from_f64(16.0) * T::EPSILON * (T::ONE + at.abs());
            (way >= T::ZERO || at + way >= low - rounding) && (way <= T::ZERO || at + way <= high + rounding)
        };
        combined.iter().all(holds) && self.linked.is_none_or(|linked| linked.limits(arm).all(|limit| holds(&limit)))
    }

    /// A step on the line from rest, or braking, to `step` after which every sum of joints holds its limit.
    pub(super) fn within_sums<A: InverseKinematics<T, N>>(
        &self,
        arm: &A,
        q: &[T; N],
        before: &[T; N],
        interval: &Interval<T, N>,
        step: [T; N],
    ) -> [T; N] {
        if self.sums_hold(arm, q, &step) {
            return step;
        }
        // All motors brake by the same share, as fast as the one that takes longest.
        let mut left = T::ZERO;
        for (step, change) in before.iter().zip(&self.change) {
            if step.abs() > *change {
                left = left.max(T::ONE - *change / step.abs());
            }
        }
        let safe = interval.cut(before.map(|step| step * left));
        let between = |share: T| {
            let mut mixed = safe;
            for (mixed, step) in mixed.iter_mut().zip(&step) {
                *mixed += share * (*step - *mixed);
            }
            mixed
        };
        let (mut share, mut half) = (T::ZERO, T::HALF);
        for _ in 0..HALVINGS {
            if self.sums_hold(arm, q, &between(share + half)) {
                share += half;
            }
            half *= T::HALF;
        }
        between(share)
    }
}

/// How often the part of a step that the limits of sums allow is halved.
const HALVINGS: usize = 10;

impl<T: Scalar, const N: usize> Linked<T, N> {
    /// Returns true if a motor moves its joint alone, and nothing else moves that joint.
    fn is_own(&self, joint: usize) -> bool {
        let unit = |matrix: &[[T; N]; N]| {
            let entry = |row: usize, column: usize| matrix.get(row).and_then(|row| row.get(column)).copied();
            (0..N).all(|other| {
                let wanted = if other == joint { T::ONE } else { T::ZERO };
                entry(joint, other) == Some(wanted)
            })
        };
        unit(&self.to_motor) && unit(&self.from_motor)
    }

    /// The ranges of the joints that their own motors do not move alone.
    fn limits<A: InverseKinematics<T, N>>(self, arm: &A) -> impl Iterator<Item = CombinedLimit<T, N>> {
        arm.limits().into_iter().enumerate().filter(move |(joint, _)| !self.is_own(*joint)).map(|(joint, limits)| {
            let mut factors = [T::ZERO; N];
            if let Some(factor) = factors.get_mut(joint) {
                *factor = T::ONE;
            }
            CombinedLimit { factors, limits }
        })
    }
}

/// Scales of the motors for least squares: 1 for a turn, the reach for a slide.
pub(super) fn units<A: Arm<T, N>, T: Scalar, const N: usize>(arm: &A, reach: T) -> [T; N] {
    arm.joint_kinds().map(|kind| if kind == JointKind::Prismatic { reach } else { T::ONE })
}
