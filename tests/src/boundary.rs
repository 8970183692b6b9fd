//! Targets at the edge of what an arm reaches, and beyond it.

use denhart::{Pose, Status};
use nalgebra::{Isometry3, Matrix3, Point3, Translation3, UnitQuaternion, Vector3};

use crate::poses::Space;
use crate::random::Random;
use crate::recover::{self, Form};
use crate::report::Report;
use crate::singular::{self, Svd};
use crate::subject::Subject;

/// How far an inexact solution may be from its target and still be listed: the default tolerance of an arm file, in
/// reaches and rad.
const TOLERANCE: f64 = 1e-6;

/// The point where the last three axes meet, in the tool frame, if they do and every joint is revolute.
pub fn wrist_center(subject: &Subject<6>) -> Option<Point3<f64>> {
    if subject.has_prismatic() {
        return None;
    }
    let q = Space::of(subject).random(&mut Random::named(subject.name));
    let jacobian = subject.chain.jacobian(&q).expect("six joints");
    let tool = subject.pose(&q);
    let axes: [(Vector3<f64>, Vector3<f64>); 3] = std::array::from_fn(|k| {
        let velocity: Vector3<f64> = jacobian.fixed_view::<3, 1>(0, k + 3).into();
        let axis: Vector3<f64> = jacobian.fixed_view::<3, 1>(3, k + 3).into();
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

/// Joints 1 to 3 that carry the wrist center as far along `direction` as it goes: no pose with the wrist center farther
/// that way is in reach.
///
/// One joint at a time is turned to the top of its sinusoid, from several starts; the best start is kept.
pub fn outermost(subject: &Subject<6>, wrist: &Point3<f64>, direction: &Vector3<f64>, random: &mut Random) -> [f64; 6] {
    let height = |q: &[f64; 6]| subject.pose(q).transform_point(wrist).coords.dot(direction);
    let climb = |q: &mut [f64; 6]| {
        let mut largest_turn = 0.0_f64;
        for joint in 0..3 {
            let before = q[joint];
            let mut at = |angle: f64| {
                q[joint] = angle;
                height(q)
            };
            let [zero, quarter, half] = [0.0, std::f64::consts::FRAC_PI_2, std::f64::consts::PI].map(&mut at);
            let middle = 0.5 * (zero + half);
            q[joint] = (quarter - middle).atan2(zero - middle);
            largest_turn = largest_turn.max((q[joint] - before).abs());
        }
        largest_turn
    };
    let space = Space::of(subject);
    let starts = (0..24).map(|_| {
        let mut q = space.random(random);
        for _ in 0..30 {
            climb(&mut q);
        }
        q
    });
    let mut best = starts.max_by(|a, b| height(a).total_cmp(&height(b))).expect("there are starts");
    for _ in 0..2000 {
        climb(&mut best);
    }
    let wrist_joints = space.random(random);
    std::array::from_fn(|joint| if joint < 3 { best[joint] } else { wrist_joints[joint] })
}

/// Pushes targets out of the outermost boundary by `1e-12 .. 1e-3` of reach: the arm says how far it is short of them,
/// and lists the stretched arm as long as it comes within the tolerance.
pub fn check_outermost(subject: &Subject<6>, wrist: &Point3<f64>, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "pushed out of the outermost boundary";
    for _ in 0..12 {
        let direction = Vector3::from(random.direction());
        let q = outermost(subject, wrist, &direction, random);
        for digits in 3..=12 {
            report.count();
            let push = 10.0_f64.powi(-digits);
            let mut target = subject.pose(&q);
            target.translation.vector += push * subject.reach * direction;
            let answer = subject.inverse(&Pose::from(target));
            recover::examine(subject, report, FAMILY, &target, &answer, Form::Principal);
            let near = subject.inverse_near(&Pose::from(target), &q);
            recover::examine(subject, report, FAMILY, &target, &near, Form::Near(&q));

            let mut fail = |rule| {
                report.fail(FAMILY, rule, || {
                    format!("pushed by {push:.0e}\n      {}", recover::describe(subject, &target, &q, &answer))
                });
            };
            // Up to ten times the bound of EXACT either status is right.
            let says_the_distance = |residual: f64| (0.5..=2.0).contains(&(residual / (push * subject.reach)));
            match answer.status {
                Status::Unreachable { residual } if says_the_distance(residual) => {}
                _ if push < 10.0 * recover::CLOSES => {}
                Status::Unreachable { .. } => fail("the residual of Unreachable is not the distance"),
                Status::Reachable | Status::BadTarget => fail("not Unreachable"),
            }
            let comes_close =
                |q: &[f64; 6]| subject.miss(&target, q).iter().all(|miss| *miss <= 2.0 * push + recover::CLOSES);
            let says_so = |position: f64| push < 10.0 * recover::CLOSES || says_the_distance(position);
            let listed = |s: &denhart::Solution<f64, 6>| comes_close(&s.q) && says_so(s.residual.position);
            if push < 0.5 * TOLERANCE && !answer.solutions.iter().any(listed) {
                fail("the nearest branch is not listed with its residual");
            }
        }
    }
}

/// Pushes targets across folds of the singular surface, outward by `1e-12 .. 1e-3`: below the tolerance the branch that
/// ends there is still listed and comes as close as the fold itself, up to the conditioning of the arm.
pub fn check_folds(subject: &Subject<6>, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "pushed across a fold";
    for (q, _) in singular::surface(subject, random, 120) {
        let Some(outward) = fold(subject, &q) else { continue };
        for digits in 3..=12 {
            report.count();
            let push = 10.0_f64.powi(-digits);
            let target = moved(subject, &subject.pose(&q), &outward, push);
            let answer = subject.inverse(&Pose::from(target));
            recover::examine(subject, report, FAMILY, &target, &answer, Form::Principal);
            let close = |q: &[f64; 6]| subject.miss(&target, q).iter().all(|miss| *miss <= 100.0 * push + 1e-12);
            if push < 1e-2 * TOLERANCE && !answer.solutions.iter().any(|solution| close(&solution.q)) {
                report.fail(FAMILY, "the branch that ends here is not listed", || {
                    format!("pushed by {push:.0e}\n      {}", recover::describe(subject, &target, &q, &answer))
                });
            }
        }
    }
}

/// The direction in which a pose on the singular surface lies at the edge of its branch, as a unit twist (lengths in
/// reaches); `None` where the arm moves on or stays as it goes along its null vector.
fn fold(subject: &Subject<6>, q: &[f64; 6]) -> Option<[f64; 6]> {
    const STEP: f64 = 1e-3;
    let columns = singular::columns(subject, q);
    let right = Svd::new(columns);
    if right.values[4] < 0.03 {
        return None;
    }
    let rows: [[f64; 6]; 6] = std::array::from_fn(|row| std::array::from_fn(|joint| columns[joint][row]));
    let normal = Svd::new(rows).vectors[5];
    let here = subject.pose(q);
    let height = |step: f64| -> f64 {
        let q = std::array::from_fn(|joint| q[joint] + step * subject.unit(joint) * right.vectors[5][joint]);
        let there = subject.pose(&q);
        let shift = (there.translation.vector - here.translation.vector) / subject.reach;
        let turn = (there.rotation * here.rotation.inverse()).scaled_axis();
        normal.iter().zip(shift.iter().chain(turn.iter())).map(|(n, x)| n * x).sum()
    };
    let curvature = (height(STEP) + height(-STEP)) / (STEP * STEP);
    (curvature.abs() > 0.03).then(|| normal.map(|n| -n * curvature.signum()))
}

/// The pose moved by a twist in base coordinates (lengths in reaches) about the tool point.
fn moved(subject: &Subject<6>, pose: &Isometry3<f64>, twist: &[f64; 6], size: f64) -> Isometry3<f64> {
    let [x, y, z, rx, ry, rz] = twist.map(|t| t * size);
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(rx, ry, rz));
    let shift = Vector3::new(x, y, z) * subject.reach;
    Isometry3::from_parts(Translation3::from(pose.translation.vector + shift), turn * pose.rotation)
}

/// Targets far out of reach, up to where squares overflow: a status, never a number that is none, never EXACT. With
/// prismatic joints that have no stops some of them are in reach; then they close.
pub fn check_far(subject: &Subject<6>, random: &mut Random, report: &mut Report) {
    const FAMILY: &str = "far out of reach";
    for exponent in [0, 1, 2, 3, 6, 12, 100, 150, 160, 300] {
        for _ in 0..20 {
            report.count();
            let q = Space::of(subject).random(random);
            let mut target = subject.pose(&q);
            target.translation.vector =
                Vector3::from(random.direction()) * subject.reach * 10.0_f64.powi(exponent) * 2.5;
            for answer in [subject.inverse(&Pose::from(target)), subject.inverse_near(&Pose::from(target), &q)] {
                let finite = answer.solutions.iter().all(|s| s.q.iter().all(|x| x.is_finite()));
                let honest = match answer.status {
                    Status::Unreachable { residual } => residual > 0.0,
                    Status::Reachable => subject.has_prismatic(),
                    // Where squares overflow nothing can be said about the target.
                    Status::BadTarget => exponent > 140,
                };
                // A slide that is far out carries its own rounding. Where squares overflow, so does the norm that judges.
                let closes = |q: &[f64; 6]| {
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
