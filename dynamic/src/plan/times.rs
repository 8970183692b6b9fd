//! Times along a curve: the fastest motion within velocities and accelerations.

use super::PlanSettings;
use super::curve::{Curve, Stretch};

/// The ends of an interval of squared speeds that is halved are this factor apart.
const SIZE: f64 = 65_536.0;
/// Halvings of such an interval: all bits of the mantissa.
const HALVINGS: usize = 60;
/// Such factors between the largest and the smallest number.
const SIZES: usize = 130;

/// A motion along a joint path.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory<const N: usize> {
    curve: Curve<N>,
    limits: [[f64; 2]; N],
    /// Of each knot the time, and the square of the speed along the curve.
    times: Vec<(f64, f64)>,
}

/// A place of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrajectoryPoint<const N: usize> {
    /// Joint values, rad or length unit.
    pub q: [f64; N],
    /// Their rates, 1/s.
    pub velocity: [f64; N],
    /// The path's parameter.
    pub at: f64,
}

/// `a u + b x` within `-most` and `most`: an acceleration, where `x` is the squared speed at the start of a stretch and `u`
/// half its derivative by the length.
#[derive(Debug, Clone, Copy)]
struct Bound {
    a: f64,
    b: f64,
    most: f64,
}

/// The bounds of a stretch.
struct Bounds {
    length: f64,
    accelerations: Vec<Bound>,
    /// The largest squared speed that the velocities allow, and the path's own time.
    fastest: f64,
}

impl Bounds {
    fn of<const N: usize>(stretch: &Stretch<'_, N>, settings: &PlanSettings<N>) -> Self {
        let length = stretch.length();
        let mut accelerations = Vec::with_capacity(5 * N);
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| {
            // The squared speed there is x + 2 part length u.
            let (first, second) = (settings.of_motors(stretch.q_ds(part)), settings.of_motors(stretch.q_ds2(part)));
            let mut factors = [[0.0; 2]; N];
            for (factors, (first, second)) in factors.iter_mut().zip(first.into_iter().zip(second)) {
                *factors = [first + 2.0 * part * length * second, second];
            }
            factors
        });
        for (((start, middle), end), most) in start.iter().zip(&middle).zip(&end).zip(&settings.acceleration) {
            if most.is_finite() {
                let ([a0, b0], [a1, b1], [a2, b2]) = (*start, *middle, *end);
                let (a, b) = (control_points(a0, a1, a2), control_points(b0, b1, b2));
                accelerations.extend(a.into_iter().zip(b).map(|(a, b)| Bound { a, b, most: *most }));
            }
        }
        Bounds { length, accelerations, fastest: fastest(stretch, settings) }
    }

    /// The least and the largest `u` at the squared speed `x`; none where the first is larger. A squared speed below 0 at
    /// the end is for the caller to leave out: by a division here 0 itself would be lost to rounding.
    fn range(&self, x: f64) -> (f64, f64) {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for Bound { a, b, most } in &self.accelerations {
            if a.abs() * 1e12 <= b.abs() * self.length {
                // The speed alone decides.
                if (b * x).abs() > *most {
                    return (1.0, -1.0);
                }
                continue;
            }
            let (one, other) = ((-most - b * x) / a, (most - b * x) / a);
            low = low.max(one.min(other));
            high = high.min(one.max(other));
        }
        (low, high)
    }

    /// The largest squared speed up to `most` from which one up to `next` is reached.
    fn reachable(&self, most: f64, next: f64) -> f64 {
        // Speed 0 is always one of them, and all of them are an interval: the bounds are linear.
        let holds = |x: f64| {
            let (low, high) = self.range(x);
            let [slow, fast] = [low, high].map(|u| x + 2.0 * self.length * u);
            low <= high && slow <= next && fast >= 0.0
        };
        if holds(most) {
            return most;
        }
        // The size first: a velocity that is there for no limit allows squared speeds that are far too large.
        let (mut low, mut high) = (most / SIZE, most);
        for _ in 0..SIZES {
            if holds(low) {
                break;
            }
            (low, high) = (low / SIZE, low);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if holds(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}

/// The control points of degree 4 of a parabola with these values at its start, middle and end: it is between the least and
/// the largest of them everywhere. (Its values alone do not bound it: between them it is up to a quarter beyond.)
fn control_points(start: f64, middle: f64, end: f64) -> [f64; 5] {
    let inner = 2.0 * middle - 0.5 * (start + end);
    [start, 0.5 * (start + inner), (start + 4.0 * inner + end) / 6.0, 0.5 * (inner + end), end]
}

/// The largest squared speed that the velocities allow anywhere on a stretch, and the path's own time.
fn fastest<const N: usize>(stretch: &Stretch<'_, N>, settings: &PlanSettings<N>) -> f64 {
    const PARTS: [f64; 3] = [0.0, 0.5, 1.0];
    let most = |[start, middle, end]: [f64; 3]| {
        control_points(start, middle, end).into_iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    };
    let [start, middle, end] = PARTS.map(|part| settings.of_motors(stretch.q_ds(part)));
    let joints = start.into_iter().zip(middle).zip(end).zip(&settings.velocity);
    let joints = joints.map(|(((start, middle), end), velocity)| most([start, middle, end]) / velocity);
    let own = if settings.is_timed { most(PARTS.map(|part| stretch.at_ds(part))) } else { 0.0 };
    let slowness = joints.fold(own, f64::max);
    1.0 / (slowness * slowness).max(f64::MIN_POSITIVE)
}

impl<const N: usize> Trajectory<N> {
    pub(super) fn new(curve: &Curve<N>, settings: &PlanSettings<N>, limits: [[f64; 2]; N]) -> Self {
        let bounds: Vec<Bounds> = curve.stretches().map(|stretch| Bounds::of(&stretch, settings)).collect();
        // What the velocities allow at each knot; rest at both ends if there is an acceleration to come to it.
        let before = [f64::INFINITY].into_iter().chain(bounds.iter().map(|bounds| bounds.fastest));
        let after = bounds.iter().map(|bounds| bounds.fastest).chain([f64::INFINITY]);
        let mut speeds: Vec<f64> = before.zip(after).map(|(before, after)| before.min(after)).collect();
        if settings.acceleration.iter().any(|most| most.is_finite()) {
            for end in [speeds.first_mut()].into_iter().flatten() {
                *end = 0.0;
            }
            for end in [speeds.last_mut()].into_iter().flatten() {
                *end = 0.0;
            }
        }
        // Backward: from where the next knot's speed is reached.
        let mut next = speeds.last().copied().unwrap_or(0.0);
        for (speed, bounds) in speeds.iter_mut().rev().skip(1).zip(bounds.iter().rev()) {
            *speed = bounds.reachable(*speed, next);
            next = *speed;
        }
        // Forward: the fastest of them.
        let (mut time, mut x) = (0.0, speeds.first().copied().unwrap_or(0.0));
        let mut times = vec![(time, x)];
        for (bounds, most) in bounds.iter().zip(speeds.iter().skip(1)) {
            let (low, high) = bounds.range(x);
            let fast = x + 2.0 * bounds.length * high.max(low);
            let next = fast.min(*most).max(0.0);
            time += 2.0 * bounds.length / (x.sqrt() + next.sqrt());
            x = next;
            times.push((time, x));
        }
        Trajectory { curve: curve.clone(), limits, times }
    }

    /// The time of the whole motion, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.times.last().map_or(0.0, |(time, _)| *time)
    }

    /// The place at a time, s; before the start and after the end those ones.
    #[must_use]
    pub fn at(&self, time: f64) -> TrajectoryPoint<N> {
        let time = time.max(0.0).min(self.duration());
        let knots = self.times.len();
        let index = self.times.partition_point(|(start, _)| *start <= time).min(knots.saturating_sub(1)).max(1);
        let ends = (self.curve.knots.get(index - 1), self.curve.knots.get(index));
        let (Some(from), Some(to)) = ends else {
            let [q, velocity] = [self.curve.knots.first().map_or([f64::NAN; N], |knot| knot.q), [0.0; N]];
            return TrajectoryPoint { q, velocity, at: 0.0 };
        };
        let stretch = Stretch { from, to };
        let at = |index: usize| self.times.get(index).copied().unwrap_or((0.0, 0.0));
        let ((start, x), (_, next)) = (at(index - 1), at(index));
        let (since, u) = (time - start, (next - x) / (2.0 * stretch.length()));
        let part = ((x.sqrt() * since + 0.5 * u * since * since) / stretch.length()).clamp(0.0, 1.0);
        let speed = (x.sqrt() + u * since).max(0.0);
        let mut q = stretch.q(part);
        for (q, [low, high]) in q.iter_mut().zip(&self.limits) {
            *q = q.max(*low).min(*high);
        }
        TrajectoryPoint { q, velocity: stretch.q_ds(part).map(|slope| slope * speed), at: stretch.at(part) }
    }
}
