//! What a call of the inverse costs: no more than the bound, whatever it is asked.

use denhart::effort::{Effort, MOST_CASCADES, MOST_EVALUATIONS, effort_of};
use denhart::{Branch, InverseKinematics, PlanarPose, PointAngle, PointAxis, Pose, Solution, Status};

use crate::poses::{Space, singular_surface};
use crate::random::Random;
use crate::report::Report;
use crate::subject::{Specified, Subject};
use crate::task::{Asked, EQUATIONS};

/// The result of a call of the inverse, which must keep to its bound.
#[track_caller]
pub fn bounded<R>(call: impl FnOnce() -> R) -> R {
    let (result, Effort { cascades, evaluations }) = effort_of(call);
    assert!(cascades <= MOST_CASCADES, "{cascades} runs of the nest");
    assert!(evaluations <= MOST_EVALUATIONS, "{evaluations} evaluations");
    result
}

/// A target made of any bits.
pub trait Absurd: Asked {
    /// A copy with some of its numbers replaced.
    fn absurd(&self, random: &mut Random) -> Self;
}

/// A number that no one means: random bits, the ends of the range, what is no number.
fn number(random: &mut Random) -> f64 {
    let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let special = [0.0, 5e-324, 1e-310, 1e-160, 1e-12, 1e12, 1e150, 1e308, f64::MAX, f64::INFINITY, f64::NAN];
    sign * if random.below(2) == 0 { f64::from_bits(random.bits()) } else { random.pick(&special) }
}

fn spoil(values: &mut [f64], random: &mut Random) {
    for value in values {
        if random.below(3) == 0 {
            *value = number(random);
        }
    }
}

impl Absurd for Pose<f64> {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut target = *self;
        spoil(&mut target.translation, random);
        // Most rotations with another number are none, and are refused at once.
        if random.below(4) == 0 {
            spoil(target.rotation.as_flattened_mut(), random);
        }
        target
    }
}

impl<const K: usize> Absurd for [f64; K]
where
    Self: Asked,
{
    fn absurd(&self, random: &mut Random) -> Self {
        let mut target = *self;
        spoil(&mut target, random);
        target
    }
}

impl Absurd for PointAxis<f64> {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut target = *self;
        spoil(&mut target.point, random);
        spoil(&mut target.axis, random);
        target
    }
}

impl Absurd for PointAngle<f64> {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut target = *self;
        spoil(&mut target.point, random);
        spoil(std::slice::from_mut(&mut target.angle), random);
        target
    }
}

impl Absurd for PlanarPose<f64> {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut numbers = [self.x, self.y, self.phi];
        spoil(&mut numbers, random);
        let [x, y, phi] = numbers;
        Self { x, y, phi }
    }
}

impl<A: Absurd> Absurd for (A, f64) {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut given = [self.1];
        spoil(&mut given, random);
        (self.0.absurd(random), given[0])
    }
}

/// Every function of the arm keeps to the bound at random, grid, singular, pushed and absurd targets, and answers each
/// with a status and with numbers.
///
/// Singular: two and three joints at special values, zeros of det J by bisection. Each target is also pushed in a random
/// direction of what is asked for, by 1e-13 to 1e-2 of reach or rad.
pub fn check<A, const N: usize>()
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Absurd>,
{
    let (subject, arm) = (Subject::new::<A>(), A::default());
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    let space = Space::of(&subject);
    let sampled = |poses: Vec<[f64; N]>, random: &mut Random| -> Vec<[f64; N]> {
        (0..250.min(poses.len())).map(|_| random.pick(&poses)).collect()
    };
    let mut families = vec![
        ("random", (0..250).map(|_| space.random(&mut random)).collect()),
        ("90 degree grid", space.grid_samples(4, 250, &mut random)),
        ("45 degree grid", space.grid_samples(8, 250, &mut random)),
    ];
    let awkward = [
        space.two_special(&mut random),
        space.three_special(&mut random),
        space.all_special(&mut random),
        singular_surface(&subject, &mut random),
    ];
    families.extend(awkward.map(|family| (family.name, sampled(family.poses, &mut random))));
    let mut most = Effort::default();
    for (family, q) in families.iter().flat_map(|(family, poses)| poses.iter().map(move |q| (*family, q))) {
        let goal = subject.goal(q);
        let twist: [f64; EQUATIONS] = std::array::from_fn(|_| random.uniform(-1.0, 1.0));
        let push = 10.0_f64.powi(random.below(12) as i32 - 13);
        for goal in [goal, subject.moved(&goal, &twist, push)] {
            let target = A::Target::of(subject.task.kind, &goal);
            ask(&arm, &mut report, family, &mut most, &target, q);
            let mut q_ref = *q;
            spoil(&mut q_ref, &mut random);
            ask(&arm, &mut report, "absurd", &mut most, &target.absurd(&mut random), &q_ref);
        }
    }
    // For whoever looks: `cargo test .. -- effort --nocapture`.
    println!("{}: {most:?}", subject.name);
    report.assert_empty();
}

/// Asks every inverse function.
fn ask<A, const N: usize>(
    arm: &A,
    report: &mut Report,
    family: &'static str,
    most: &mut Effort,
    target: &A::Target,
    q_ref: &[f64; N],
) where
    A: Specified<N> + InverseKinematics<f64, N, Target: Absurd>,
{
    report.count();
    let (all, effort) = effort_of(|| arm.inverse(target));
    let (near, effort_near) = effort_of(|| arm.inverse_near(target, q_ref));
    let branch = all.as_ref().last().map_or(Branch::NONE, |solution| solution.branch);
    let (_, effort_one) = effort_of(|| arm.inverse_branch(target, branch));
    for Effort { cascades, evaluations } in [effort, effort_near, effort_one] {
        most.cascades = most.cascades.max(cascades);
        most.evaluations = most.evaluations.max(evaluations);
        if cascades > MOST_CASCADES || evaluations > MOST_EVALUATIONS {
            report.fail(family, "beyond the bound", || {
                format!("{cascades} runs, {evaluations} evaluations: {target:?}, {q_ref:?}")
            });
        }
    }
    for solutions in [&all, &near] {
        let numbers = |s: &Solution<f64, N>| s.q.iter().all(|x| x.is_finite());
        let listed = solutions.as_ref();
        let honest = match A::status(solutions) {
            Status::Reachable => listed.iter().any(Solution::is_exact),
            Status::Unreachable { residual } => residual > 0.0 && !listed.iter().any(Solution::is_exact),
            Status::BadTarget => listed.is_empty(),
        };
        if !honest || !listed.iter().all(numbers) {
            report.fail(family, "wrong status or solution", || {
                format!("{target:?}, {q_ref:?}: {:?}", A::status(solutions))
            });
        }
    }
}
