//! Targets at the edge of what an arm reaches, and beyond it.

use std::ops::Range;

use denhart::Status;
use nalgebra::{Matrix3, Point3, Vector3};

use crate::poses::Space;
use crate::random::Random;
use crate::recover::{self, Form};
use crate::report::Report;
use crate::singular::{self, Svd};
use crate::subject::Subject;
use crate::task::{EQUATIONS, Kind};

/// How far an inexact solution may be from its target and still be listed: the default tolerance of an arm file, in
/// reaches and rad.
const TOLERANCE: f64 = 1e-6;

/// A point of the tool frame that the target places, and the joints that carry it there; the joints after them turn
/// about it.
#[derive(Debug, Clone)]
pub struct Carried {
    point: Point3<f64>,
    joints: Range<usize>,
    /// True if the first equation measures the distance of the point, so that its gap is the push.
    measured: bool,
}

impl Carried {
    /// The point of the task. For a task of a position alone, the point is the tool point. For a pose with as many
    /// equations as joints, the point is the wrist center. The last three axes must meet there, and none of their
    /// joints may be given. Otherwise there is no point, and none for an arm with a prismatic joint.
    pub fn of<const N: usize>(subject: &Subject<N>) -> Option<Self> {
        if subject.has_prismatic() {
            return None;
        }
        let measured = subject.task.given.is_empty();
        match subject.task.kind {
            Kind::Position | Kind::PlanarPosition => Some(Self { point: Point3::origin(), joints: 0..N, measured }),
            Kind::Pose if subject.task.equations() == N && subject.task.given.iter().all(|given| given + 3 < N) => {
                wrist_center(subject).map(|point| Self { point, joints: 0..N - 3, measured })
            }
            _ => None,
        }
    }

    /// The point for an arm whose equations nobody has looked at. The gap of such an arm may be larger than the push,
    /// by a factor up to the conditioning of the arm.
    #[must_use]
    pub fn of_any_arm(self) -> Self {
        Self { measured: false, ..self }
    }
}

/// The point where the last three axes meet, in the tool frame, if they do. Every joint is revolute.
fn wrist_center<const N: usize>(subject: &Subject<N>) -> Option<Point3<f64>> {
    let q = Space::of(subject).random(&mut Random::named(&subject.name));
    let jacobian = subject.chain.jacobian(&q).expect("the chain has as many joints as the arm");
    let tool = subject.pose(&q);
    let axes: [(Vector3<f64>, Vector3<f64>); 3] = std::array::from_fn(|k| {
        let velocity: Vector3<f64> = jacobian.fixed_view::<3, 1>(0, k + N - 3).into();
        let axis: Vector3<f64> = jacobian.fixed_view::<3, 1>(3, k + N - 3).into();
        // velocity = axis x (tool - point on the axis)
        (axis, tool.translation.vector - velocity.cross(&axis))
    });
    let across = |axis: &Vector3<f64>| Matrix3::identity() - axis * axis.transpose();
    let sum: Matrix3<f64> = axes.iter().map(|(axis, _)| across(axis)).sum();
    let right: Vector3<f64> = axes.iter().map(|(axis, point)| across(axis) * point).sum();
    let center = sum.try_inverse()? * right;
    let meets = axes.iter().all(|(axis, point)| (across(axis) * (center - point)).norm() < 1e-9 * subject.reach);
    meets.then(|| tool.inverse_transform_point(&center.into()))
}

/// Joints that carry the point as far along `direction` as the point goes, while the given joint keeps its value. No
/// target whose point lies farther in that direction is in reach.
///
/// One joint at a time is turned to the top of its sinusoid, from several starts; the best start is kept.
fn outermost<const N: usize>(
    subject: &Subject<N>,
    carried: &Carried,
    direction: &Vector3<f64>,
    random: &mut Random,
) -> [f64; N] {
    let height = |q: &[f64; N]| subject.pose(q).transform_point(&carried.point).coords.dot(direction);
    let climb = |q: &mut [f64; N]| {
        for joint in carried.joints.clone().filter(|joint| !subject.task.given.contains(*joint)) {
            let mut at = |angle: f64| {
                q[joint] = angle;
                height(q)
            };
            let [zero, quarter, half] = [0.0, std::f64::consts::FRAC_PI_2, std::f64::consts::PI].map(&mut at);
            let middle = 0.5 * (zero + half);
            q[joint] = (quarter - middle).atan2(zero - middle);
        }
    };
    let space = Space::of(subject);
    let joints = subject.task.given;
    let given = (!joints.is_empty()).then(|| space.random(random));
    let starts = (0..24).map(|_| {
        let mut q = space.random(random);
        if let Some(given) = given {
            joints.iter().for_each(|joint| q[joint] = given[joint]);
        }
        for _ in 0..30 {
            climb(&mut q);
        }
        q
    });
    let mut best = starts.max_by(|a, b| height(a).total_cmp(&height(b))).expect("there are starts");
    for _ in 0..2000 {
        climb(&mut best);
    }
    let others = space.random(random);
    std::array::from_fn(|joint| if carried.joints.contains(&joint) { best[joint] } else { others[joint] })
}

/// Pushes targets out of the outermost boundary by `1e-12 .. 1e-3` of reach. The arm must report by how much the best
/// branch is short of a solution. The stretched arm must be listed as long as its miss is within the tolerance.
///
/// The residual of Unreachable is the least gap of a stage. If the first stage measures the distance that is too long,
/// that residual is at most twice the push. With a joint given, the stage that misses may come after one that bends the
/// elbow. That stage then measures the push over the sine of the elbow joint, which is above 1e-3 at the joints drawn
/// here.
pub fn check_outermost<const N: usize>(
    subject: &Subject<N>,
    carried: &Carried,
    directions: usize,
    random: &mut Random,
    report: &mut Report,
) {
    const FAMILY: &str = "pushed out of the outermost boundary";
    for _ in 0..directions {
        let direction = direction(subject, random);
        let q = outermost(subject, carried, &direction, random);
        for digits in 3..=12 {
            report.count(&q);
            let push = 10.0_f64.powi(-digits);
            let mut target = subject.goal(&q);
            target.pose.translation.vector += push * subject.reach * direction;
            let answer = subject.inverse(&target);
            recover::examine(subject, report, FAMILY, &target, &answer, Form::Principal);
            let near = subject.inverse_near(&target, &q);
            recover::examine(subject, report, FAMILY, &target, &near, Form::Near(&q));

            let mut fail = |rule| {
                report.fail(FAMILY, rule, || {
                    format!("pushed by {push:.0e}\n      {}", recover::describe(subject, &target, &q, &answer))
                });
            };
            // Up to ten times the bound of EXACT either status is right.
            let says_the_distance = |residual: f64| (0.5..=2.0).contains(&(residual / (push * subject.reach)));
            let magnified = if carried.measured { 2.0 } else { 1e3 };
            let is_a_gap = |residual: f64| residual > 0.0 && residual <= magnified * push * subject.reach;
            match answer.status {
                Status::Unreachable { residual } if is_a_gap(residual) => {}
                _ if push < 10.0 * recover::CLOSES => {}
                Status::Unreachable { .. } => fail("the residual of Unreachable is more than the distance"),
                Status::Reachable | Status::BadTarget => fail("not Unreachable"),
            }
            let comes_close =
                |q: &[f64; N]| subject.miss(&target, q).iter().all(|miss| *miss <= magnified * push + recover::CLOSES);
            let says_so = |s: &denhart::Solution<f64, N>| match carried.measured {
                _ if push < 10.0 * recover::CLOSES => true,
                true => says_the_distance(s.residual.position),
                // What it says is what it misses by.
                false => {
                    let [position, _] = subject.miss(&target, &s.q);
                    (s.residual.position / subject.reach - position).abs() <= recover::CLOSES
                }
            };
            let listed = |s: &denhart::Solution<f64, N>| comes_close(&s.q) && says_so(s);
            if push < TOLERANCE / magnified && !answer.solutions.iter().any(listed) {
                fail("the nearest branch is not listed with its residual");
            }
        }
    }
}

/// Pushes targets across folds of the singular surface, outward by `1e-12 .. 1e-3`. At pushes below a hundredth of the
/// tolerance, the branch that ends there is still listed. That branch comes as close as the fold itself, up to the
/// conditioning of the arm, a factor of at most 100. For tasks with as many equations as joints.
pub fn check_folds<const N: usize>(subject: &Subject<N>, attempts: usize, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "pushed across a fold";
    for (q, _) in singular::surface(subject, random, attempts) {
        let Some(outward) = fold(subject, &q) else { continue };
        for digits in 3..=12 {
            report.count(&q);
            let push = 10.0_f64.powi(-digits);
            let target = subject.moved(&subject.goal(&q), &outward, push);
            let answer = subject.inverse(&target);
            recover::examine(subject, report, FAMILY, &target, &answer, Form::Principal);
            let close = |q: &[f64; N]| subject.miss(&target, q).iter().all(|miss| *miss <= 100.0 * push + 1e-12);
            if push < 1e-2 * TOLERANCE && !answer.solutions.iter().any(|solution| close(&solution.q)) {
                report.fail(FAMILY, "the branch that ends here is not listed", || {
                    format!("pushed by {push:.0e}\n      {}", recover::describe(subject, &target, &q, &answer))
                });
            }
        }
    }
}

/// Moves targets by `1e-12 .. 1e-3` in ways that an arm with fewer joints than equations cannot follow. At moves below
/// a hundredth of the tolerance, the branch is still listed. That branch comes as close as the move, up to the
/// conditioning of the arm, a factor of at most 100.
pub fn check_leftover<const N: usize>(subject: &Subject<N>, count: usize, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "beside what the arm can do";
    let space = Space::of(subject);
    let regular = std::iter::repeat_with(|| (space.random(random), [random.direction(), random.direction()]))
        .take(1000 * count)
        .filter(|(q, _)| Svd::at(subject, q).least() > 0.05)
        .take(count);
    for (q, [shift, turn]) in regular.collect::<Vec<_>>() {
        let mut twist = [0.0; EQUATIONS];
        twist[..3].copy_from_slice(&shift);
        twist[3..6].copy_from_slice(&turn);
        for digits in 3..=12 {
            report.count(&q);
            let push = 10.0_f64.powi(-digits);
            let target = subject.moved(&subject.goal(&q), &twist, push);
            for (answer, form) in
                [(subject.inverse(&target), Form::Principal), (subject.inverse_near(&target, &q), Form::Near(&q))]
            {
                recover::examine(subject, report, FAMILY, &target, &answer, form);
                let close = |q: &[f64; N]| subject.miss(&target, q).iter().all(|miss| *miss <= 100.0 * push + 1e-12);
                if push < 1e-2 * TOLERANCE && !answer.solutions.iter().any(|solution| close(&solution.q)) {
                    report.fail(FAMILY, "the branch is not listed", || {
                        format!("moved by {push:.0e}\n      {}", recover::describe(subject, &target, &q, &answer))
                    });
                }
                if push > 1e2 * TOLERANCE && answer.status.is_reachable() {
                    report.fail(FAMILY, "not Unreachable", || recover::describe(subject, &target, &q, &answer));
                }
            }
        }
    }
}

/// The direction in which a target on the singular surface lies at the edge of its branch. The direction is a unit
/// vector over the equations (lengths in reaches). `None` where the arm moves on or stays as it goes along its null
/// vector, or where the second smallest singular value is below 0.03.
fn fold<const N: usize>(subject: &Subject<N>, q: &[f64; N]) -> Option<[f64; EQUATIONS]> {
    const STEP: f64 = 1e-3;
    let columns = subject.columns(q);
    let right = Svd::new(columns);
    if right.values[N - 2] < 0.03 {
        return None;
    }
    let rows: [[f64; N]; N] = std::array::from_fn(|row| std::array::from_fn(|joint| columns[joint][row]));
    let least = Svd::new(rows).vectors[N - 1];
    let normal: [f64; EQUATIONS] = std::array::from_fn(|row| least.get(row).copied().unwrap_or(0.0));
    let height = |step: f64| -> f64 {
        let there = std::array::from_fn(|joint| q[joint] + step * subject.unit(joint) * right.vectors[N - 1][joint]);
        let error = subject.error(&subject.goal(&there), q);
        normal.iter().zip(error).map(|(n, x)| n * x).sum()
    };
    let curvature = (height(STEP) + height(-STEP)) / (STEP * STEP);
    (curvature.abs() > 0.03).then(|| normal.map(|n| -n * curvature.signum()))
}

/// A random direction in which the tool point can be asked to go.
fn direction<const N: usize>(subject: &Subject<N>, random: &mut Random) -> Vector3<f64> {
    let [x, y, z] = random.direction();
    if subject.task.is_planar() { Vector3::new(x, y, 0.0).normalize() } else { Vector3::new(x, y, z) }
}

/// Targets far out of reach, up to where squares overflow: a status, never a number that is none, never EXACT. With
/// prismatic joints that have no stops some of them are in reach; then they close.
pub fn check_far<const N: usize>(subject: &Subject<N>, count: usize, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "far out of reach";
    for exponent in [0, 1, 2, 3, 6, 12, 100, 150, 160, 300] {
        for _ in 0..count {
            let q = Space::of(subject).random(random);
            report.count(&q);
            let mut target = subject.goal(&q);
            target.pose.translation.vector = direction(subject, random) * subject.reach * 10.0_f64.powi(exponent) * 2.5;
            for answer in [subject.inverse(&target), subject.inverse_near(&target, &q)] {
                let finite = answer.solutions.iter().all(|s| s.q.iter().all(|x| x.is_finite()));
                let honest = match answer.status {
                    Status::Unreachable { residual } => residual > 0.0,
                    Status::Reachable => subject.has_prismatic(),
                    // Where squares overflow nothing can be said about the target.
                    Status::BadTarget => exponent > 140,
                };
                // A slide that is far out carries its own rounding. Where squares overflow, so does the norm that judges.
                let closes = |q: &[f64; N]| {
                    subject.miss(&target, q).iter().all(|miss| *miss < recover::CLOSES * subject.extension(q))
                };
                let reach_nothing = answer.exact().all(|s| subject.has_prismatic() && (exponent > 140 || closes(&s.q)));
                if !(finite && honest && reach_nothing) {
                    report.fail(FAMILY, "wrong status or solution", || {
                        format!("10^{exponent}\n      {}", recover::describe(subject, &target, &q, &answer))
                    });
                }
            }
        }
    }
}
