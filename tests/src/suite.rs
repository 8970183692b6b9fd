//! Tests that every arm with an inverse has to pass, group by group.

use denhart::{InverseKinematics, JointKind, Target};

use crate::boundary::{self, Carried};
use crate::poses::{SURFACE, Space, singular_surface};
use crate::random::Random;
use crate::recover;
use crate::reference;
use crate::report::Report;
use crate::subject::{Answer, Specified, Subject};
use crate::task::{Asked, Kind};

/// How large grids may be.
#[derive(Debug, Clone, Copy)]
pub struct Grids {
    /// A grid with more joint vectors than this is sampled.
    pub complete: usize,
    /// By so many.
    pub samples: usize,
}

/// Directions in which targets are pushed out of the outermost boundary.
const DIRECTIONS: usize = 12;
/// Attempts to find a fold, and joint vectors of arms with fewer joints than equations.
const FOLDS: usize = 120;
/// Targets at each distance far out.
const FAR: usize = 20;

/// 2,000 random joint vectors, with references beside them and whole turns away.
pub fn random_poses<const N: usize>(subject: &Subject<N>) {
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let space = Space::of(subject);
    for _ in 0..2000 {
        let q = space.random(&mut random);
        recover::check(subject, &mut report, "random", &q);
        recover::check_references(subject, &mut report, "random", &q, &mut random);
    }
    report.assert_empty();
}

/// Grids of 90, 45, 15 and 30 degrees. With `DENHART_FULL_GRID=1` that of 30 degrees is complete.
pub fn grids<const N: usize>(subject: &Subject<N>, grids: Grids) {
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let space = Space::of(subject);
    let full = std::env::var_os("DENHART_FULL_GRID").is_some_and(|value| value == "1");
    for (steps, family) in
        [(4, "90 degree grid"), (8, "45 degree grid"), (24, "15 degree grid"), (12, "30 degree grid")]
    {
        if space.grid(steps).len() <= grids.complete || (steps == 12 && full) {
            for q in space.grid(steps) {
                recover::check(subject, &mut report, family, &q);
            }
        } else {
            for q in space.grid_samples(steps, grids.samples, &mut random) {
                recover::check(subject, &mut report, family, &q);
            }
        }
    }
    report.assert_at_most(subject.task.known_losses);
}

/// Joints at and beside the values where arms tend to be singular, and where this one is.
pub fn awkward_poses<const N: usize>(subject: &Subject<N>) {
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let space = Space::of(subject);
    let special = [
        space.first_joint_square(&mut random),
        space.one_special(&mut random),
        space.two_special(&mut random),
        space.all_special(&mut random),
    ];
    let surface = singular_surface(subject, SURFACE, &mut random);
    // Slides are singular nowhere, nor is one joint that turns a tool whose orientation counts.
    let turning = subject.kinds.iter().filter(|kind| **kind == JointKind::Revolute).count();
    let rigid = turning == 0 || turning == 1 && subject.task.kind == Kind::Pose;
    // With more equations than joints, and no joint that always leaves one of them alone, singular poses are isolated.
    let isolated = subject.task.holds_a_joint && subject.task.equations() > N;
    assert!(rigid || isolated || !surface.poses.is_empty(), "{}: nothing in the family {}", subject.name, surface.name);
    for family in special.iter().chain([&surface]) {
        for q in &family.poses {
            recover::check(subject, &mut report, family.name, q);
        }
    }
    report.assert_at_most(subject.task.known_losses);
}

/// Targets at the edge of what the arm reaches, and beyond it.
pub fn out_of_reach<const N: usize>(subject: &Subject<N>) {
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    if let Some(carried) = Carried::of(subject) {
        boundary::check_outermost(subject, &carried, DIRECTIONS, &mut random, &mut report);
    }
    match subject.task.equations() {
        equations if equations == N => boundary::check_folds(subject, FOLDS, &mut random, &mut report),
        _ => boundary::check_leftover(subject, FOLDS, &mut random, &mut report),
    }
    boundary::check_far(subject, FAR, &mut random, &mut report);
    report.assert_empty();
}

/// Compares the residual of a joint vector by the arm with that by the chain, near the target and anywhere.
pub fn residuals<A, const N: usize>()
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked + Target<A, f64, N>>,
{
    let (subject, arm) = (Subject::new::<A>(), A::default());
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let space = Space::of(&subject);
    for digits in (0..13).cycle().take(260) {
        let there = space.random(&mut random);
        report.count(&there);
        let step = 10.0_f64.powi(-digits);
        let mut q = std::array::from_fn(|j| there[j] + step * subject.unit(j) * random.uniform(-1.0, 1.0));
        for given in subject.task.given.iter() {
            q[given] = there[given];
        }
        let goal = subject.goal(&there);
        let target = A::Target::of(subject.task.kind, &goal);
        let [position, orientation] = subject.miss(&goal, &q);
        for residual in [arm.residual(&q, &target), target.missed_by(&arm, &q)] {
            let agrees = (residual.position / subject.reach - position).abs() < recover::CLOSES
                && (residual.orientation - orientation).abs() < recover::CLOSES;
            if !agrees {
                report.fail("residuals", "the arm and the chain disagree", || {
                    format!("{residual:?}, not {position} reaches and {orientation} rad, at {q:?} for {there:?}")
                });
            }
        }
    }
    report.assert_empty();
}

/// Compares every complete set of solutions of `inverse_truth.json` that belongs to the arm. Gives the number of sets.
pub fn truths(subject: &Subject<6>) -> usize {
    let truths: Vec<_> = reference::truths().into_iter().filter(|truth| truth.arm == subject.name).collect();
    for truth in &truths {
        let answer: Answer<6> = subject.inverse(&reference::isometry(&truth.pose).into());
        let exact = answer.exact().count();
        assert_eq!((answer.solutions.len(), exact), (truth.real_solution_count, truth.real_solution_count), "{answer}");
        for solution in &truth.solutions {
            let expected: [f64; 6] = solution.as_slice().try_into().expect("six joints");
            // The truth is given to rounding; these poses are well away from singularities.
            let found = answer.exact().any(|s| subject.distance(&s.q, &expected, |_| true) < 1e-9);
            assert!(found, "{expected:?} is missing among\n{answer}");
        }
    }
    truths.len()
}
