//! Effort of a call of the inverse: no more than the bound, whatever the target.

use denhart::effort::{Effort, MOST_CASCADES, MOST_EVALUATIONS, MOST_HELD_JOINT_EVALUATIONS, effort_of};
use denhart::{Branch, InverseKinematics, PlanarPose, PointAngle, PointAxis, Pose, Solution, Status};
use denhart_dynamic::DynamicTarget;

use crate::bad_targets::each_task;
use crate::inverse::{Derived, Inverse, OneBranch, Request};
use crate::poses::{SURFACE, Space, singular_surface};
use crate::random::Random;
use crate::report::Report;
use crate::subject::{Specified, Subject};
use crate::task::{Asked, EQUATIONS};

/// The result of a call of the inverse, which must keep to its bound.
#[track_caller]
pub fn bounded<R>(call: impl FnOnce() -> R) -> R {
    let (result, effort) = effort_of(call);
    assert!(is_bounded(&effort), "{effort:?}");
    result
}

/// Returns true if a call has kept to its bound.
fn is_bounded(effort: &Effort) -> bool {
    let most = if effort.holds_a_joint { MOST_HELD_JOINT_EVALUATIONS } else { MOST_EVALUATIONS };
    effort.cascades <= MOST_CASCADES && effort.evaluations <= most
}

/// A target made of any bits.
pub trait Absurd {
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

impl<const K: usize> Absurd for [f64; K] {
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

impl<A: Absurd, const K: usize> Absurd for (A, [f64; K]) {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut given = self.1;
        spoil(&mut given, random);
        (self.0.absurd(random), given)
    }
}

impl<A: Absurd> Absurd for (A, f64) {
    fn absurd(&self, random: &mut Random) -> Self {
        let mut given = [self.1];
        spoil(&mut given, random);
        (self.0.absurd(random), given[0])
    }
}

impl Absurd for Request {
    fn absurd(&self, random: &mut Random) -> Self {
        let target = each_task!(&self.target, target, make => make(target.absurd(random)));
        let mut given = self.given;
        given.iter_mut().for_each(|value| spoil(std::slice::from_mut(value), random));
        Self { target, given }
    }
}

/// Joint vectors of each family that the suites ask for.
const POSES: usize = 250;

/// [`check_some`] of a generated arm.
pub fn check<A, const N: usize>(one_branch: Option<OneBranch<A, N>>)
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked + Absurd>,
{
    let subject = Subject::new::<A>();
    // Behind a pointer, so that the questions compile once for each target and not once an arm.
    let inverse: &dyn Inverse<N, Target = A::Target> = &Derived { arm: A::default(), kind: A::TASK.kind, one_branch };
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let most = check_some(&subject, inverse, POSES, SURFACE, &mut random, &mut report);
    // For whoever looks: `cargo test .. -- effort --nocapture`.
    println!("{}: {most:?}", subject.name);
    report.assert_empty();
}

/// Every function of the arm keeps to the bound at random, grid, singular, pushed and absurd targets. Each target gets
/// an answer with a status and with numbers. The result is the most that a call took.
///
/// Singular: two and three joints at special values, zeros of det J by bisection, found in so many attempts. Each target
/// is also pushed in a random direction of what is asked for, by 1e-13 to 1e-2 of reach or rad.
pub fn check_some<I: Inverse<N, Target: Absurd> + ?Sized, const N: usize>(
    subject: &Subject<N>,
    inverse: &I,
    poses: usize,
    attempts: usize,
    random: &mut Random,
    report: &mut Report,
) -> Effort {
    let space = Space::of(subject);
    let sampled = |family: Vec<[f64; N]>, random: &mut Random| -> Vec<[f64; N]> {
        (0..poses.min(family.len())).map(|_| random.pick(&family)).collect()
    };
    let mut families = vec![
        ("random", (0..poses).map(|_| space.random(random)).collect()),
        ("90 degree grid", space.grid_samples(4, poses, random)),
        ("45 degree grid", space.grid_samples(8, poses, random)),
    ];
    let awkward = [
        space.two_special(random),
        space.three_special(random),
        space.all_special(random),
        singular_surface(subject, attempts, random),
    ];
    families.extend(awkward.map(|family| (family.name, sampled(family.poses, random))));
    let mut most = Effort::default();
    for (family, q) in families.iter().flat_map(|(family, poses)| poses.iter().map(move |q| (*family, q))) {
        let goal = subject.goal(q);
        // Arms with fewer equations have as many numbers as ever, so that seeds keep their poses.
        let rows = subject.task.equations().max(7);
        let twist: [f64; EQUATIONS] =
            std::array::from_fn(|row| if row < rows { random.uniform(-1.0, 1.0) } else { 0.0 });
        let push = 10.0_f64.powi(random.below(12) as i32 - 13);
        for goal in [goal, subject.moved(&goal, &twist, push)] {
            let target = inverse.target(&goal);
            ask(inverse, report, family, &mut most, &target, q);
            let mut q_ref = *q;
            spoil(&mut q_ref, random);
            ask(inverse, report, "absurd", &mut most, &target.absurd(random), &q_ref);
        }
    }
    most
}

/// Asks every inverse function.
fn ask<I: Inverse<N> + ?Sized, const N: usize>(
    inverse: &I,
    report: &mut Report,
    family: &'static str,
    most: &mut Effort,
    target: &I::Target,
    q_ref: &[f64; N],
) {
    report.count(q_ref);
    let (all, effort) = effort_of(|| inverse.all(target));
    let (near, effort_near) = effort_of(|| inverse.near(target, q_ref));
    let branch = all.solutions.last().map_or(Branch::NONE, |solution| solution.branch);
    let (_, effort_one) = effort_of(|| inverse.branch(target, branch));
    for effort in [effort, effort_near, effort_one] {
        most.cascades = most.cascades.max(effort.cascades);
        most.evaluations = most.evaluations.max(effort.evaluations);
        if !is_bounded(&effort) {
            report.fail(family, "beyond the bound", || format!("{effort:?}: {target:?}, {q_ref:?}"));
        }
    }
    for answer in [&all, &near] {
        let numbers = |s: &Solution<f64, N>| s.q.iter().all(|x| x.is_finite());
        let honest = match answer.status {
            Status::Reachable => answer.exact().next().is_some(),
            Status::Unreachable { residual } => residual > 0.0 && answer.exact().next().is_none(),
            Status::BadTarget => answer.solutions.is_empty(),
        };
        if !honest || !answer.solutions.iter().all(numbers) {
            report.fail(family, "wrong status or solution", || format!("{target:?}, {q_ref:?}\n      {answer}"));
        }
    }
}
