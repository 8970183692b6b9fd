//! Damped least-squares steps towards a target.

use super::arm_constants::{ArmConstants, Evaluate};
use super::damped_step::{MOST_COLUMNS, Step, damped_step, dot_out_of_line};
use super::goal::Goal;
use super::kernel::tolerances::Tolerances;
use crate::math::wrap;
use crate::{JointMask, Residual};

/// The most evaluations for one solution.
pub(super) const MOST_STEPS: usize = 16;
/// So many steps in a row that stall are the last ones; one, once the solution is exact.
const MOST_STALLS: usize = 2;
/// A step stalls that leaves more than this part of the squared error. Where several singularities meet, a step that
/// takes little may come before one that takes nearly all.
const PROGRESS: f64 = 0.8;
/// A descent is slow whose first eight evaluations leave more than this part of the squared error. The next eight seldom
/// close the target.
const SLOW: f64 = 2.5e-3;
/// Residuals up to so many roundings say nothing about where the solution is. Where the arm is nearly singular, a step
/// that would remove such residuals leads far away.
const NOISE: f64 = 20.0;

/// A step closes a target if by its linear model it leaves at most this part of the squared error.
const CLOSES: f64 = 0.01;

/// So many parts of a step are compared for the best one.
const PARTS: i32 = 8;

/// The least-squares problem of a call: the joints that are not given are to bring the tool to the target.
pub(super) struct Problem<'a, T: 'static, const N: usize> {
    pub(super) constants: &'a ArmConstants<'a, T, N>,
    pub(super) goal: &'a dyn Goal<T, N>,
    pub(super) arm: &'a dyn Evaluate<T, N>,
}

/// A joint vector with what it misses the target by. Lengths are relative to reach throughout.
#[derive(Debug, Clone, Copy)]
pub(super) struct Iterate<T, const N: usize> {
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
    /// The columns of the Jacobian; with more than seven joints those that are not given, then zeros. Not read where `size` is 0.
    columns: [[T; 6]; N],
    error: [T; 6],
    /// Its squared length; 0 if the error is rounding, and so tells nothing about where the solution is. No step starts there.
    size: T,
}

/// Parameters of a descent.
pub(super) struct DescentParams {
    /// So many evaluations are left. A descent takes at most [`MOST_STEPS`].
    pub(super) evaluations_left: usize,
    /// A slow descent ([`SLOW`]) ends halfway.
    pub(super) ends_slow: bool,
}

/// Information about a descent that has ended.
pub(super) struct DescentInfo {
    /// The evaluations that it took.
    pub(super) evaluations: usize,
    /// The evaluations ran out.
    pub(super) is_cut_short: bool,
}

impl<T: Tolerances, const N: usize> Iterate<T, N> {
    /// A joint vector before its evaluation.
    #[inline]
    pub(super) const fn at(q: [T; N]) -> Self {
        Self { q, residual: Residual::ZERO, columns: [[T::ZERO; 6]; N], error: [T::ZERO; 6], size: T::ZERO }
    }
}

impl<T: Tolerances, const N: usize> Problem<'_, T, N> {
    /// Evaluates the arm at the joint vector of an iterate.
    #[inline(never)]
    pub(super) fn evaluate(&self, iterate: &mut Iterate<T, N>) {
        let Self { constants, goal, arm } = *self;
        let mut evaluated = arm.evaluate(&iterate.q);
        let (pose, jacobian) = &mut evaluated;
        let k = T::ONE / constants.reach;
        let [x, y, z, u, v, w] = goal.error(&iterate.q, pose);
        iterate.error = [x * k, y * k, z * k, u, v, w];
        iterate.size = dot_out_of_line(&iterate.error, &iterate.error);
        iterate.residual = goal.misses(&iterate.q, pose);
        let floor = T::from_f64(NOISE) * T::EPSILON;
        if iterate.size <= floor * floor {
            iterate.size = T::ZERO;
            return;
        }
        goal.restrict(pose, jacobian);
        let [x, y, z, u, v, w] = &jacobian.rows;
        let rows = x.iter().zip(y).zip(z).zip(u.iter().zip(v).zip(w));
        for (column, (((x, y), z), ((u, v), w))) in iterate.columns.iter_mut().zip(rows) {
            *column = [*x * k, *y * k, *z * k, *u, *v, *w];
        }
        for joint in constants.prismatic.iter() {
            let column = iterate.columns.get_mut(joint).into_iter().flatten();
            column.for_each(|entry| *entry *= constants.reach);
        }
        if N > MOST_COLUMNS {
            let (own, held) = (core::mem::replace(&mut iterate.columns, [[T::ZERO; 6]; N]), goal.given());
            let moving = own.iter().enumerate().filter(|(joint, _)| !held.contains(*joint));
            iterate.columns.iter_mut().zip(moving).for_each(|(column, (_, own))| *column = *own);
        }
    }

    /// The squared length of the first step; infinite if the step does not close the target ([`CLOSES`]).
    pub(super) fn first_step(&self, from: &Iterate<T, N>) -> T {
        if from.size == T::ZERO {
            return T::ZERO;
        }
        let step = damped_step(&from.columns, &from.error, from.size);
        if step.remaining_error <= from.size * T::from_f64(CLOSES) { step.square } else { T::INFINITY }
    }

    /// The joint vector to which a step leads that is taken m times, angles on any turn. `None` if the step overflows.
    /// `damped`: as in [`refine`](Self::refine).
    pub(super) fn step(&self, from: &Iterate<T, N>, m: T, damped: bool) -> Option<[T; N]> {
        let step = damped_step(&from.columns, &from.error, if damped { from.size } else { T::ZERO });
        let mut q = from.q;
        self.move_by(&mut q, &from.q, &step, m);
        step.square.is_finite().then_some(q)
    }

    /// Moves a joint vector by a part of a step from another one.
    #[inline]
    fn move_by(&self, q: &mut [T; N], from: &[T; N], step: &Step<T, N>, part: T) {
        let held = if N <= MOST_COLUMNS { JointMask::NONE } else { self.goal.given() };
        let moving = q.iter_mut().zip(from).enumerate().filter(|(joint, _)| !held.contains(*joint));
        for ((joint, (value, from)), change) in moving.zip(&step.changes) {
            *value = *from + *change * part * self.constants.unit(joint);
        }
    }

    /// Damped least squares (Levenberg 1944, Marquardt 1963), damped in proportion to the squared error, so that
    /// convergence is quadratic. `best` becomes the iterate of least error, its angles in (-pi, pi].
    ///
    /// - Of two steps in a row one has to reduce the error (the watchdog of Chamberlain, Powell, Lemarechal, Pedersen 1982).
    /// - At a fold a step goes half of the way and leaves a quarter of the error. The next step is taken twice (Decker,
    ///   Keller, Kelley 1983). The step after it restores the equations without a fold.
    /// - If a part of a step that stalls is predicted to leave less than half of the squared error, that part is taken
    ///   ([`best_part`]).
    /// - The descent ends after two steps in a row that stall ([`PROGRESS`]), after one if the solution is exact, and where the
    ///   linear model predicts that the next step stalls.
    #[cold]
    #[inline(never)]
    pub(super) fn refine(&self, best: &mut Iterate<T, N>, params: DescentParams) -> DescentInfo {
        let (constants, held) = (self.constants, self.goal.given());
        let DescentParams { evaluations_left, ends_slow } = params;
        if !(best.size > T::ZERO) {
            return DescentInfo { evaluations: 0, is_cut_short: false };
        }
        // A free joint may stay at a reference that is wound by turns.
        wrap_angles(&mut best.q, held, constants.prismatic);
        let mut tried = *best;
        // True if the next step starts at the joint vector tried last.
        let mut onward = false;
        // The next step is taken so many times.
        let (mut times, mut taken, mut stalls) = (T::ONE, 0, 0);
        let most = MOST_STEPS.min(evaluations_left);
        let slow = best.size * T::from_f64(SLOW);
        // Every turn takes an evaluation, or is the last one.
        while taken < most {
            let from = if onward { &tried } else { &*best };
            let Iterate { q, error, size, .. } = *from;
            let exact = constants.relative(&best.residual) <= T::EXACT;
            let is_slow = ends_slow && taken >= MOST_STEPS / 2 && best.size > slow;
            if !(size > T::ZERO) || is_slow || stalls >= if exact { 1 } else { MOST_STALLS } {
                break;
            }
            let step = damped_step(&from.columns, &from.error, size);
            // A step changes singular values by about its length, and those below the error are damped away.
            let predicts_stall = step.remaining_error > size * T::from_f64(PROGRESS) && step.square <= size;
            if !step.square.is_finite() || !onward && predicts_stall {
                break;
            }
            let mut part = times;
            // Two turns at most: the whole step, and a part of it, which is not 1.
            loop {
                self.move_by(&mut tried.q, &q, &step, part);
                self.evaluate(&mut tried);
                taken += 1;
                let least;
                let model_closes = step.remaining_error < size * T::HALF;
                if part != T::ONE || !model_closes || tried.size < best.size * T::from_f64(PROGRESS) || taken >= most {
                    break;
                }
                (part, least) = best_part(&error, &tried.error);
                // A part that is not a number is none.
                if !(least < best.size * T::HALF) {
                    break;
                }
            }
            // At a fold the linear model leaves nothing, and the step a quarter of the error, within a factor of 2.
            let ratio = tried.size / size * T::from_f64(16.0);
            let quarter = ratio > T::HALF * T::HALF && ratio < T::TWO * T::TWO && tried.size < best.size;
            times =
                if quarter && part == T::ONE && step.remaining_error < tried.size * T::HALF { T::TWO } else { T::ONE };
            stalls = if tried.size < best.size * T::from_f64(PROGRESS) { 0 } else { stalls + 1 };
            // A step along a narrow curved valley leaves it, and the next one leads back: one may make it worse.
            onward = !(tried.size < best.size) && tried.size.is_finite();
            if tried.size < best.size {
                *best = tried;
            }
        }
        wrap_angles(&mut best.q, held, constants.prismatic);
        DescentInfo { evaluations: taken, is_cut_short: taken == evaluations_left && taken < MOST_STEPS }
    }
}

/// The part t of a step at which the squared error is least, and that error. To second order the error along a step whose
/// linear model closes is `(1 - t) before + t^2 after`. Between two roots of a fold whole steps would go from one side of a
/// root to the other without end.
#[inline(never)]
fn best_part<T: Tolerances>(before: &[T; 6], after: &[T; 6]) -> (T, T) {
    let [first, mixed, last] = [(before, before), (before, after), (after, after)].map(|(a, b)| dot_out_of_line(a, b));
    // Beyond this part, which may be more than the whole step, the second term is the longer one.
    let longest = (first / last).sqrt().sqrt();
    (1..=PARTS).fold((T::ONE, last), |(part, least), k| {
        let t = longest * T::from_i32(k) / T::from_i32(PARTS);
        let (u, v) = (T::ONE - t, t * t);
        let error = u * (u * first + T::TWO * v * mixed) + v * v * last;
        if error < least { (t, error) } else { (part, least) }
    })
}

/// Brings the angles of a joint vector into (-pi, pi]. Those that are `held` stay as they are.
#[inline(never)]
pub(super) fn wrap_angles<T: Tolerances>(q: &mut [T], held: JointMask, prismatic: JointMask) {
    for (joint, value) in q.iter_mut().enumerate() {
        if !(held | prismatic).contains(joint) {
            *value = wrap(*value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::locked::AllLocked;
    use crate::{Jacobian, Pose};

    const CONSTANTS: ArmConstants<'_, f64, 2> = ArmConstants {
        limits: &[[-4.0, 4.0]; 2],
        combined: &[],
        weights: &[1.0; 2],
        limited: false,
        prismatic: JointMask::NONE,
        stands_for: JointMask::NONE,
        wrist: None,
        reach: 1.0,
        tolerance: Residual { position: 1e-6, orientation: 1e-6 },
    };

    /// An arm that brings its tool to the point `(f, g, 0)`, with the gradients of f and g.
    struct Map(fn(f64, f64) -> [Value; 2]);

    /// The value of a function, and its gradient.
    type Value = (f64, [f64; 2]);

    impl Evaluate<f64, 2> for Map {
        fn evaluate(&self, [x, y]: &[f64; 2]) -> (Pose<f64>, Jacobian<f64, 2>) {
            let [(f, df), (g, dg)] = self.0(*x, *y);
            let mut jacobian = Jacobian { rows: [[0.0; 2]; 6] };
            [jacobian.rows[0], jacobian.rows[1]] = [df, dg];
            (Pose { rotation: [[0.0; 3]; 3], translation: [f, g, 0.0] }, jacobian)
        }
    }

    /// The joint vector and the residual that refinement ends at with the origin as target, and its evaluations.
    fn refined(map: Map, q: [f64; 2], most: usize) -> ([f64; 2], f64, usize) {
        descended(map, q, true, most)
    }

    /// As [`refined`]; `ends_slow`: a slow descent ends halfway.
    fn descended(map: Map, q: [f64; 2], ends_slow: bool, most: usize) -> ([f64; 2], f64, usize) {
        let problem = Problem { constants: &CONSTANTS, goal: &[0.0; 3], arm: &map };
        let mut iterate = Iterate::at(q);
        problem.evaluate(&mut iterate);
        let info = problem.refine(&mut iterate, DescentParams { evaluations_left: most, ends_slow });
        (iterate.q, iterate.residual.position, info.evaluations)
    }

    #[test]
    fn steps_to_a_simple_root_converge_quadratically() {
        let map = Map(|x, y| [(x + 0.2 * y * y, [1.0, 0.4 * y]), (y - 0.2 * x * x, [-0.4 * x, 1.0])]);
        let (_, miss, taken) = refined(map, [0.2, -0.1], 99);
        assert!(miss < 1e-14 && taken <= 4, "{miss:e} {taken}");
    }

    #[test]
    fn the_second_step_to_a_fold_is_taken_twice() {
        let (q, miss, taken) = refined(Map(|x, y| [(x * x, [2.0 * x, 0.0]), (y, [0.0, 1.0])]), [0.1, 0.0], 99);
        assert!(q[0].abs() < 1e-6 && miss < 1e-12 && taken <= 4, "{q:?} {miss:e} {taken}");
    }

    /// From between the roots +-0.01 the whole step leads to 0.05.
    #[test]
    fn of_a_step_beyond_a_root_the_best_part_is_taken() {
        let map = Map(|x, y| [(x * x - 1e-4, [2.0 * x, 0.0]), (y, [0.0, 1.0])]);
        let (q, miss, taken) = refined(map, [1e-3, 0.0], 99);
        assert!((q[0] - 0.01).abs() < 1e-9 && miss < 1e-12 && taken <= 6, "{q:?} {miss:e} {taken}");
        let along = |size: f64| [size * 0.6, 0.0, size * -0.8, 0.0, 0.0, 0.0];
        // Roots of `(1 - t) + t^2 after`. Parts up to `|after|^(-1/2)` are eighths of that, so a root is off by a sixteenth.
        for (after, part) in [(-2.0_f64, 0.5), (0.25, 2.0), (-200.0, 0.068_254_858_490_424_52)] {
            let (found, least) = best_part(&along(1.0), &along(after));
            assert!((found - part).abs() <= after.abs().powf(-0.5) / 16.0 && least < 0.5, "{after}: {found} {least}");
        }
        for after in [f64::NAN, f64::INFINITY] {
            assert!(!(best_part(&along(1.0), &along(after)).1 < 1.0), "{after}");
        }
    }

    /// Along the bottom of the valley `y = 2 x^2` a step leaves the valley, and the next one leads back.
    #[test]
    fn one_step_may_increase_the_error() {
        let map = Map(|x, y| [(y - 2.0 * x * x, [-4.0 * x, 1.0]), (0.05 * (x - 0.1), [0.05, 0.0])]);
        let (q, miss, taken) = refined(map, [0.0, 0.0], 99);
        assert!((q[0] - 0.1).abs() < 1e-9 && miss < 1e-12 && taken <= 4, "{q:?} {miss:e} {taken}");
    }

    #[test]
    fn a_descent_to_an_error_above_zero_is_given_up() {
        let map = Map(|x, y| [(x * x + 0.1, [2.0 * x, 0.0]), (y, [0.0, 1.0])]);
        let (q, miss, taken) = refined(map, [0.3, 0.1], 99);
        assert!(q[0].abs() < 0.1 && (miss - 0.1).abs() < 0.01 && taken <= 8, "{q:?} {miss} {taken}");
        // The linear model predicts no progress at all.
        let (_, _, taken) = refined(Map(|_, y| [(0.5, [0.0, 0.0]), (y, [0.0, 1.0])]), [1.0, 0.0], 99);
        assert_eq!(taken, 0);
    }

    /// Newton's steps on `x^(3/5)` lead from x to `-2/3 x`, and leave 0.78 of the error.
    #[test]
    fn a_slow_descent_ends_halfway_if_told() {
        let map = || Map(|x, y| [(x.abs().powf(0.6) * x.signum(), [0.6 * x.abs().powf(-0.4), 0.0]), (y, [0.0, 1.0])]);
        for (ends_slow, most) in [(true, MOST_STEPS / 2), (false, MOST_STEPS)] {
            let (q, miss, taken) = descended(map(), [0.1, 0.0], ends_slow, 99);
            let left = (2.0_f64 / 3.0).powi(taken as i32);
            assert!(taken == most && q[0].abs() < 0.12 * left && miss > 0.0, "{q:?} {miss:e} {taken}");
        }
    }

    /// Of ten joints three slide along x, y and z. The other ones move nothing. The slide along y and two others are given.
    #[test]
    fn a_step_moves_the_joints_that_are_not_given() {
        struct Gantry;
        impl Evaluate<f64, 10> for Gantry {
            fn evaluate(&self, q: &[f64; 10]) -> (Pose<f64>, Jacobian<f64, 10>) {
                let mut jacobian = Jacobian { rows: [[0.0; 10]; 6] };
                (jacobian.rows[0][2], jacobian.rows[1][5], jacobian.rows[2][9]) = (1.0, 1.0, 1.0);
                (Pose { rotation: [[0.0; 3]; 3], translation: [q[2], q[5], q[9]] }, jacobian)
            }
        }
        let slides = JointMask::single(2) | JointMask::single(5) | JointMask::single(9);
        let constants = ArmConstants {
            limits: &[[-4.0, 4.0]; 10],
            combined: &[],
            weights: &[1.0; 10],
            limited: false,
            prismatic: slides,
            stands_for: JointMask::NONE,
            wrist: None,
            reach: 4.0,
            tolerance: Residual { position: 1e-6, orientation: 1e-6 },
        };
        let given = [(0, 0.1), (5, 0.25), (7, 0.3)];
        let goal = AllLocked::new(&[1.0, 0.5, -2.0], &given);
        let problem = Problem { constants: &constants, goal: &goal, arm: &Gantry };
        let start = core::array::from_fn(|joint| 0.05 * joint as f64);
        let mut iterate = Iterate::at(goal.placed(start));
        problem.evaluate(&mut iterate);
        let q = problem.step(&iterate, 1.0, false).unwrap_or_default();
        let mut wanted = goal.placed(start);
        (wanted[2], wanted[9]) = (1.0, -2.0);
        assert!(q.iter().zip(wanted).all(|(q, wanted)| (q - wanted).abs() < 1e-14), "{q:?} {wanted:?}");
    }

    #[test]
    fn evaluations_are_bounded() {
        // A fold of the fourth order: each step leads a quarter of the way.
        let map = || Map(|x, y| [(x.powi(4), [4.0 * x.powi(3), 0.0]), (y, [0.0, 1.0])]);
        for most in [0, 1, 3, 99] {
            let (q, _, taken) = refined(map(), [0.9, 0.2], most);
            assert!(taken <= most.min(MOST_STEPS) && (taken > 0) == (q != [0.9, 0.2]), "{most}: {taken} {q:?}");
        }
        let (q, _, taken) = refined(Map(|x, y| [(x, [f64::NAN, 0.0]), (y, [0.0, 1.0])]), [0.5, 0.2], 99);
        assert_eq!((q, taken), ([0.5, 0.2], 0));
    }
}
