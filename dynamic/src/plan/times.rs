//! Times along a curve: the fastest motion within velocities and accelerations.

use super::PlanSettings;
use super::curve::{Curve, Stretch};

/// Halvings of an interval of squared speeds: all bits of the mantissa.
const HALVINGS: usize = 60;

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
    /// The largest squared speed in the middle.
    middle: f64,
}

impl Bounds {
    fn of<const N: usize>(stretch: &Stretch<'_, N>, settings: &PlanSettings<N>) -> Self {
        let length = stretch.length();
        let mut accelerations = Vec::with_capacity(3 * N);
        for part in [0.0, 0.5, 1.0] {
            // The squared speed there is x + 2 part length u.
            let (first, second) = (stretch.q_ds(part), stretch.q_ds2(part));
            for ((first, second), most) in first.iter().zip(&second).zip(&settings.acceleration) {
                if most.is_finite() {
                    accelerations.push(Bound { a: first + 2.0 * part * length * second, b: *second, most: *most });
                }
            }
        }
        Bounds { length, accelerations, middle: fastest(stretch, 0.5, settings) }
    }

    /// The least and the largest `u` at the squared speed `x`; none where the first is larger.
    fn range(&self, x: f64) -> (f64, f64) {
        // The squared speed stays at least 0.
        let (mut low, mut high) = (-x / (2.0 * self.length), (self.middle - x) / self.length);
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
            low <= high && x + 2.0 * self.length * low <= next
        };
        if holds(most) {
            return most;
        }
        let (mut low, mut high) = (0.0, most);
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

/// The largest squared speed that the velocities allow at a place, and the path's own time.
fn fastest<const N: usize>(stretch: &Stretch<'_, N>, part: f64, settings: &PlanSettings<N>) -> f64 {
    let first = stretch.q_ds(part);
    let joints = first.iter().zip(&settings.velocity).map(|(first, velocity)| first.abs() / velocity);
    let own = if settings.is_timed { stretch.at_ds(part).abs() } else { 0.0 };
    let slowness = joints.fold(own, f64::max);
    1.0 / (slowness * slowness).max(f64::MIN_POSITIVE)
}

impl<const N: usize> Trajectory<N> {
    pub(super) fn new(curve: &Curve<N>, settings: &PlanSettings<N>, limits: [[f64; 2]; N]) -> Self {
        let bounds: Vec<Bounds> = curve.stretches().map(|stretch| Bounds::of(&stretch, settings)).collect();
        // What the velocities allow at each knot; rest at both ends if there is an acceleration to come to it.
        let at_starts = curve.stretches().map(|stretch| fastest(&stretch, 0.0, settings));
        let at_end = curve.stretches().last().map(|stretch| fastest(&stretch, 1.0, settings));
        let mut speeds: Vec<f64> = at_starts.chain(at_end).collect();
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
