//! The iteration.

use super::limits::{bring_in, is_held, unwind};
use super::model::{Model, characteristic_length};
use super::report::{NumericSolution, Stop};
use super::settings::{Method, NumericInverse};
use super::starts::Generator;
use super::step;
use crate::math::{self, Scalar};
use crate::pose::Pose;
use crate::solution::Residual;
use crate::solve::{Tolerances, as_rotation};

/// The longest step that says the posture is as near as it comes, rad or in lengths of the arm.
const SETTLED: f64 = 1e-3;

/// So many iterations before the last one the posture is let go, so that the tool still converges. From the error that
/// moving along the null space leaves, four quadratic steps would do.
const CLOSING: usize = 10;

/// Solves from `start`, then from random starts.
pub(crate) fn run<T: Tolerances, M: Model<T>>(
    settings: &NumericInverse<T>,
    model: &M,
    target: &Pose<T>,
    start: &M::Joints,
    posture: Option<&M::Joints>,
) -> NumericSolution<T, M::Joints> {
    let unknown = Residual { position: T::INFINITY, orientation: T::INFINITY };
    let refused = |stop| NumericSolution { q: start.clone(), stop, iterations: 0, restarts: 0, residual: unknown };
    let is_finite = |q: &M::Joints| q.as_ref().iter().all(|value| value.is_finite());
    let Some(target) = &as_rotation(target).filter(|_| settings.task.is_meant()) else {
        return refused(Stop::BadTarget);
    };
    if !is_finite(start) || posture.is_some_and(|q| !is_finite(q) || q.as_ref().len() != start.as_ref().len()) {
        return refused(Stop::BadStart);
    }
    let length = settings.length.unwrap_or_else(|| characteristic_length(model, start));
    let descent = Descent { settings, model, target, posture, length, tolerance: settings.tolerance_for(length) };
    let mut best = descent.from(start);
    let mut generator = Generator::new(settings.seed);
    for restart in 1..=settings.restarts {
        if best.solution.converged() {
            break;
        }
        let next = descent.from(&generator.start(model, start, length));
        let iterations = best.solution.iterations + next.solution.iterations;
        if next.solution.converged() || next.size < best.size {
            best = next;
        }
        (best.solution.iterations, best.solution.restarts) = (iterations, restart);
    }
    if best.solution.stop == Stop::Stalled {
        let steps = settings.max_iterations.saturating_sub(best.steps);
        descent.approach(&mut best, steps);
    }
    unwind(model, settings.within_limits, &mut best.solution.q, start);
    best.solution
}

/// Data of a solution that stays constant over its iterations.
struct Descent<'a, T, M: Model<T>>
where
    T: Scalar,
{
    settings: &'a NumericInverse<T>,
    model: &'a M,
    target: &'a Pose<T>,
    posture: Option<&'a M::Joints>,
    length: T,
    tolerance: Residual<T>,
}

/// The closest iterate of a descent, with its squared error.
struct Closest<T, Q> {
    solution: NumericSolution<T, Q>,
    size: T,
    /// Steps from this start.
    steps: usize,
}

/// Error of the tool against the target: as a twist, squared by position and orientation, and both in one number.
struct Miss<T> {
    error: [T; 6],
    position: T,
    orientation: T,
    size: T,
}

/// Progress of the error so far, which decides on the damping.
struct Progress<T> {
    /// Least squared error since damping was last restored.
    least: T,
    /// Factor to which damping has faded.
    relief: T,
}

impl<T: Scalar> Progress<T> {
    /// Keeps the damping while the error falls, else divides it by ten. After twelve divisions the damping is restored,
    /// and the next error becomes the least.
    #[inline(always)]
    fn note(&mut self, size: T) {
        if size < self.least * T::from_f64(0.99) {
            *self = Self { least: size, relief: T::ONE };
        } else {
            self.relief *= T::from_f64(0.1);
            if self.relief < T::from_f64(1e-12) {
                *self = Self { least: T::INFINITY, relief: T::ONE };
            }
        }
    }
}

impl<T: Tolerances, M: Model<T>> Descent<'_, T, M> {
    /// Iterates from one start.
    fn from(&self, start: &M::Joints) -> Closest<T, M::Joints> {
        let Self { settings, model, .. } = *self;
        let (near, aligned) = self.bounds();
        let mut q = start.clone();
        self.advance(&mut q, None);
        let mut change = q.clone();
        let mut closest = q.clone();
        let (mut least, mut left) = (T::INFINITY, [T::INFINITY; 2]);
        let mut progress = Progress { least: T::INFINITY, relief: T::ONE };
        let (mut reached, mut idle, mut iterations) = (false, 0, 0);
        let mut posture = self.posture;
        let stop = loop {
            let mut evaluation = model.evaluate(&q);
            let (rows, Miss { error, position, orientation, size }) = self.miss(&mut evaluation);
            let is_reached = position <= near && orientation <= aligned;
            if is_reached || (size < least && !reached) {
                idle = if size < least * T::from_f64(0.99) { 0 } else { idle + 1 };
                (least, left) = (size, [position, orientation]);
                closest.as_mut().copy_from_slice(q.as_ref());
                reached = is_reached;
                if is_reached && posture.is_none() {
                    break Stop::Converged;
                }
            } else {
                idle += 1;
            }
            if iterations >= settings.max_iterations {
                break Stop::IterationBound;
            }
            if !size.is_finite() {
                break Stop::NotFinite;
            }
            if idle > settings.patience && posture.is_none() {
                break Stop::Stalled;
            }
            if iterations + CLOSING >= settings.max_iterations {
                posture = None;
            }
            progress.note(size);
            let damping = match settings.method {
                Method::DampedLeastSquares => size * settings.damping * progress.relief,
                Method::NewtonRaphson => T::ZERO,
            };
            self.step(&q, rows, &error, damping + T::EPSILON, posture, &mut change);
            let longest = self.longest(&change);
            if longest <= T::from_f64(SETTLED) {
                posture = None;
                if is_reached {
                    break Stop::Converged;
                }
            }
            if longest > settings.max_step {
                let factor = settings.max_step / longest;
                change.as_mut().iter_mut().for_each(|change| *change *= factor);
            }
            self.advance(&mut q, Some(&change));
            iterations += 1;
        };
        let [position, orientation] = left.map(math::sqrt);
        let stop = if reached { Stop::Converged } else { stop };
        let residual = Residual { position, orientation };
        let solution = NumericSolution { q: closest, stop, iterations, restarts: 0, residual };
        Closest { solution, size: least, steps: iterations }
    }

    /// Goes on from the closest iterate by steps that descend, damped as much as that takes, for a target out of reach:
    /// Levenberg and Marquardt's method as Marquardt has it (1963, J. SIAM 11(2)).
    #[cold]
    fn approach(&self, closest: &mut Closest<T, M::Joints>, steps: usize) {
        let (near, aligned) = self.bounds();
        let mut evaluation = self.model.evaluate(&closest.solution.q);
        let mut change = closest.solution.q.clone();
        let mut damping = closest.size;
        for _ in 0..steps {
            let (rows, Miss { error, .. }) = self.miss(&mut evaluation);
            self.step(&closest.solution.q, rows, &error, damping + T::EPSILON, None, &mut change);
            let mut q = closest.solution.q.clone();
            self.advance(&mut q, Some(&change));
            closest.solution.iterations += 1;
            let mut next = self.model.evaluate(&q);
            let (_, Miss { position, orientation, size, .. }) = self.miss(&mut next);
            if size < closest.size {
                closest.size = size;
                closest.solution.q.as_mut().copy_from_slice(q.as_ref());
                let [position, orientation] = [position, orientation].map(math::sqrt);
                closest.solution.residual = Residual { position, orientation };
                evaluation = next;
                damping *= T::from_f64(0.2);
            } else {
                damping *= T::from_f64(5.0);
            }
            if position <= near && orientation <= aligned {
                closest.solution.stop = Stop::Converged;
                break;
            }
        }
    }

    /// The squares of the tolerances.
    #[inline(always)]
    fn bounds(&self) -> (T, T) {
        let Residual { position, orientation } = self.tolerance;
        (position * position, orientation * orientation)
    }

    /// Error of the tool and Jacobian, both reduced to the components that the task counts.
    #[inline(always)]
    fn miss<'e>(&self, evaluation: &'e mut M::Evaluation) -> (&'e mut [M::Joints; 6], Miss<T>) {
        let (pose, rows) = M::parts(evaluation);
        let mut error = pose.error_to(self.target);
        self.settings.task.reduce(pose, self.target, &mut error, rows);
        let [x, y, z, u, v, w] = error;
        let (position, orientation) = (x * x + y * y + z * z, u * u + v * v + w * w);
        (rows, Miss { error, position, orientation, size: position / (self.length * self.length) + orientation })
    }

    /// The step from `q`, before it is capped.
    #[inline(always)]
    fn step(
        &self,
        q: &M::Joints,
        rows: &[M::Joints; 6],
        error: &[T; 6],
        damping: T,
        posture: Option<&M::Joints>,
        change: &mut M::Joints,
    ) {
        let mut columns = None;
        for (joint, value) in q.as_ref().iter().enumerate() {
            let prismatic = self.model.is_prismatic(joint);
            let held = self.settings.within_limits
                && is_held(*value, self.model.limits(joint), || self.push(rows, error, joint));
            if prismatic || held {
                let columns = columns.get_or_insert_with(|| self.ones(q));
                if let Some(column) = columns.as_mut().get_mut(joint) {
                    *column = if held { T::ZERO } else { self.length };
                }
            }
        }
        let columns = columns.as_ref();
        let Some(posture) = posture else {
            step::damped(rows, error, damping, self.length, columns, change);
            return;
        };
        // dq = z + J# (e - J z): the pseudoinverse answers for what the wish z does to the tool.
        let mut wish = posture.clone();
        for (joint, (wish, value)) in wish.as_mut().iter_mut().zip(q.as_ref()).enumerate() {
            let held = columns.is_some_and(|columns| columns.as_ref().get(joint) == Some(&T::ZERO));
            *wish = if held { T::ZERO } else { (*wish - *value) * self.settings.posture_gain };
        }
        let mut rest = *error;
        for (rest, row) in rest.iter_mut().zip(rows) {
            *rest = row.as_ref().iter().zip(wish.as_ref()).fold(*rest, |sum, (entry, wish)| sum - *entry * *wish);
        }
        step::damped(rows, &rest, damping, self.length, columns, change);
        for (change, wish) in change.as_mut().iter_mut().zip(wish.as_ref()) {
            *change += *wish;
        }
    }

    /// Component of the steepest descent for one joint: its sign says which way the error pushes it.
    fn push(&self, rows: &[M::Joints; 6], error: &[T; 6], joint: usize) -> T {
        let weight = T::ONE / (self.length * self.length);
        let weights = [weight, weight, weight, T::ONE, T::ONE, T::ONE];
        let entries = rows.iter().map(|row| row.as_ref().get(joint).copied().unwrap_or(T::ZERO));
        entries.zip(error).zip(weights).fold(T::ZERO, |sum, ((entry, error), weight)| sum + entry * *error * weight)
    }

    fn ones(&self, q: &M::Joints) -> M::Joints {
        let mut ones = q.clone();
        ones.as_mut().fill(T::ONE);
        ones
    }

    /// The longest change of a joint, rad or in lengths of the arm. Not finite where one is not.
    #[inline(always)]
    fn longest(&self, change: &M::Joints) -> T {
        change.as_ref().iter().enumerate().fold(T::ZERO, |longest, (joint, change)| {
            let change = if self.model.is_prismatic(joint) { *change / self.length } else { *change }.abs();
            if change > longest { change } else { longest }
        })
    }

    /// Adds a step, and brings every joint within its limits.
    #[inline(always)]
    fn advance(&self, q: &mut M::Joints, change: Option<&M::Joints>) {
        if let Some(change) = change {
            for (value, change) in q.as_mut().iter_mut().zip(change.as_ref()) {
                *value += *change;
            }
        }
        if self.settings.within_limits {
            for (joint, value) in q.as_mut().iter_mut().enumerate() {
                *value = bring_in(*value, self.model.limits(joint), self.model.is_prismatic(joint));
            }
        }
    }
}
