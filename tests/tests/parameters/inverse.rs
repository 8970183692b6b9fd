//! The inverse with lengths bound at run time.

use super::arms::*;
use super::kernel_arms::*;
use super::{joints, lengths, reach, unit};
use denhart::{
    Flags, InverseBranch, InverseKinematics, JointKind, PlanarPose, PointAngle, PointAxis, Pose, Residual, Solution,
    Status,
};
use denhart_tests::evaluated::{self, Typed};
use denhart_tests::random::Random;
use denhart_tests::subject::{largest, wrap};
use denhart_tests::task;
use std::fmt::Debug;

/// Largest error of a solution marked exact, positions in reaches and in rad: the promise of `Flags::EXACT`.
const EXACT: f64 = 1e-12;

/// A target made from a joint vector and the pose the chain gives for it, and what others miss of it.
trait Wanted: Clone + Debug {
    fn of(q: &[f64], pose: &Pose<f64>) -> Self;
    fn missed(&self, q: &[f64], pose: &Pose<f64>) -> Residual<f64>;
}

fn distance<const K: usize>(a: [f64; K], b: [f64; K]) -> f64 {
    (0..K).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

impl Wanted for [f64; 2] {
    fn of(_: &[f64], pose: &Pose<f64>) -> Self {
        let [x, y, _] = pose.translation;
        [x, y]
    }

    fn missed(&self, q: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        Residual { position: distance(*self, Self::of(q, pose)), orientation: 0.0 }
    }
}

impl Wanted for PlanarPose<f64> {
    fn of(_: &[f64], pose: &Pose<f64>) -> Self {
        let [[cos, ..], [sin, ..], _] = pose.rotation;
        let [x, y, _] = pose.translation;
        PlanarPose { x, y, phi: sin.atan2(cos) }
    }

    fn missed(&self, q: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        let other = Self::of(q, pose);
        let position = distance([self.x, self.y], [other.x, other.y]);
        Residual { position, orientation: wrap(self.phi - other.phi).abs() }
    }
}

/// Of the Jupiter arm, whose pitch axes have one direction.
impl Wanted for PointAngle<f64> {
    fn of(q: &[f64], pose: &Pose<f64>) -> Self {
        PointAngle { point: pose.translation, angle: q[1] + q[2] + q[3] }
    }

    fn missed(&self, q: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        let other = Self::of(q, pose);
        let position = distance(self.point, other.point);
        Residual { position, orientation: wrap(self.angle - other.angle).abs() }
    }
}

/// Of arms that point the z axis of their tool.
impl Wanted for PointAxis<f64> {
    fn of(_: &[f64], pose: &Pose<f64>) -> Self {
        PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z))
    }

    fn missed(&self, q: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        let other = Self::of(q, pose);
        Residual { position: distance(self.point, other.point), orientation: distance(self.axis, other.axis) }
    }
}

impl Wanted for Pose<f64> {
    fn of(_: &[f64], pose: &Pose<f64>) -> Self {
        *pose
    }

    fn missed(&self, _: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        pose.residual(self)
    }
}

impl Wanted for [f64; 3] {
    fn of(_: &[f64], pose: &Pose<f64>) -> Self {
        pose.translation
    }

    fn missed(&self, _: &[f64], pose: &Pose<f64>) -> Residual<f64> {
        Residual { position: distance(*self, pose.translation), orientation: 0.0 }
    }
}

trait Solvable<const N: usize>: Parametric<N> + InverseKinematics<f64, N, Target: Wanted> {}
impl<A: Parametric<N> + InverseKinematics<f64, N, Target: Wanted>, const N: usize> Solvable<N> for A {}

fn target<A: Solvable<N>, const N: usize>(arm: &A, q: &[f64; N]) -> A::Target {
    A::Target::of(q, &Pose::from(arm.chain().forward(q).unwrap()))
}

/// Nothing is not a number, and what is called exact is exact.
fn honest<A: Solvable<N>, const N: usize>(arm: &A, target: &A::Target, solutions: &[Solution<f64, N>]) {
    let (chain, reach) = (arm.chain(), reach(arm));
    for solution in solutions {
        assert!(solution.q.iter().all(|q| q.is_finite()), "{:?}: {solution:?}", arm.values());
        if solution.is_exact() {
            let missed = target.missed(&solution.q, &Pose::from(chain.forward(&solution.q).unwrap()));
            let worst = (missed.position / reach).max(missed.orientation);
            assert!(worst <= EXACT, "{:?} misses {target:?} by {worst:e}: {solution:?}", arm.values());
        }
    }
}

/// Largest difference of two joint vectors, a whole turn being none; strokes in reaches.
fn apart<A: Parametric<N>, const N: usize>(arm: &A, one: &[f64; N], other: &[f64; N]) -> f64 {
    largest((0..N).map(|joint| {
        let difference = (one[joint] - other[joint]) / unit(arm, joint);
        if A::JOINT_KINDS[joint] == JointKind::Prismatic { difference } else { wrap(difference) }
    }))
}

/// Returns true if some exact solution is `q`; double roots of a pose come out to about the root of a rounding.
fn found<A: Parametric<N>, const N: usize>(arm: &A, solutions: &[Solution<f64, N>], q: &[f64; N]) -> bool {
    let near = |s: &&Solution<f64, N>| apart(arm, &s.q, q) < 1e-6;
    solutions.iter().filter(|s| s.is_exact()).any(|s| near(&s))
}

/// Lengths of either sign, none of them small beside another.
fn ordinary<A: Parametric<N>, const N: usize>(random: &mut Random) -> A {
    let scale = 10f64.powf(random.uniform(-3.0, 3.0));
    let sign = |random: &mut Random| random.pick(&[-1.0, 1.0]);
    let values: Vec<f64> = (0..A::COUNT).map(|_| sign(random) * scale * random.uniform(0.2, 1.0)).collect();
    A::with(&values)
}

/// Every pose of arms of many sizes is reached, by the joint vector it was made from among others.
fn recovers<A: Solvable<N>, const N: usize>(name: &str) {
    let mut random = Random::named(name);
    for _ in 0..300 {
        let arm: A = ordinary(&mut random);
        for _ in 0..5 {
            let q = joints(&arm, &mut random);
            let target = target(&arm, &q);
            let solutions = arm.inverse(&target);
            honest(&arm, &target, solutions.as_ref());
            assert!(found(&arm, solutions.as_ref(), &q), "{:?} loses {q:?}", arm.values());
            assert_eq!(A::status(&solutions), Status::Reachable);
            let near = arm.inverse_near(&target, &q);
            honest(&arm, &target, near.as_ref());
            assert!(found(&arm, near.as_ref().get(..1).unwrap(), &q), "{:?} does not begin with {q:?}", arm.values());
        }
    }
}

/// With links of no length, negative ones and some of quite another size: no NaN, and nothing wrong is called exact.
fn stays_honest<A: Solvable<N>, const N: usize>(name: &str) {
    let mut random = Random::named(name);
    let mut reached = 0;
    for _ in 0..400 {
        let arm: A = if random.below(2) == 0 {
            lengths(&mut random)
        } else {
            let any = |random: &mut Random| random.uniform(-1.0, 1.0) * 10f64.powf(random.uniform(-15.0, 3.0));
            A::with(&(0..A::COUNT).map(|_| any(&mut random)).collect::<Vec<_>>())
        };
        let q = joints(&arm, &mut random);
        let target = target(&arm, &q);
        let solutions = arm.inverse(&target);
        honest(&arm, &target, solutions.as_ref());
        assert_ne!(A::status(&solutions), Status::BadTarget, "{:?}", arm.values());
        reached += usize::from(A::status(&solutions) == Status::Reachable);
        honest(&arm, &target, arm.inverse_near(&target, &joints(&arm, &mut random)).as_ref());
    }
    println!("{name}: {reached} of 400 degenerate arms reach");
    assert!(reached >= 360, "{name}: {reached} of 400");
}

/// Lengths that are no numbers, or whose squares are none, are bad, and a status says so.
fn refuses<A: Solvable<N>, const N: usize>(_: &str) {
    let q = joints(&A::file(), &mut Random::named("refused"));
    let target = target(&A::file(), &q);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, f64::MAX] {
        for index in 0..A::COUNT {
            let mut values = A::file().values();
            values[index] = bad;
            let arm = A::with(&values);
            let solutions = arm.inverse(&target);
            assert_eq!(A::status(&solutions), Status::BadTarget, "{values:?}");
            assert_eq!(solutions.as_ref().len(), 0);
            assert_eq!(arm.inverse_near(&target, &q).as_ref().len(), 0);
        }
    }
    for tiny in [0.0, -0.0, 5e-324, 1e-300] {
        let arm = A::with(&vec![tiny; A::COUNT]);
        honest(&arm, &target, arm.inverse(&target).as_ref());
    }
}

/// The two forms of one file give the same solutions, in the same order, with the same names.
fn like_folded<A, const N: usize>(name: &str)
where
    A: Solvable<N>,
    A::Folded: InverseKinematics<f64, N, Target = A::Target>,
{
    let (arm, folded) = (A::file(), A::Folded::default());
    assert_eq!(A::MAX_SOLUTIONS, A::Folded::MAX_SOLUTIONS);
    let mut random = Random::named(name);
    for _ in 0..500 {
        let q = joints(&arm, &mut random);
        let target = target(&arm, &q);
        let (one, other) = (arm.inverse(&target), folded.inverse(&target));
        let (one, other) = (one.as_ref(), other.as_ref());
        assert_eq!(one.len(), other.len(), "{q:?}");
        for (one, other) in one.iter().zip(other) {
            assert_eq!((one.flags, one.free), (other.flags, other.free), "{q:?}");
            // Roots that meet are one solution, which may have the name of either.
            assert!(one.branch == other.branch || one.flags.contains(Flags::BOUNDARY), "{q:?}: {one:?}\n{other:?}");
            // Rounding, magnified by the inverse of an amplitude that is above 1e-4 at all of these poses.
            let apart = apart(&arm, &one.q, &other.q);
            assert!(apart < 1e-10, "{q:?}: {apart:e}\n{one:?}\n{other:?}");
        }
    }
}

/// The arm evaluated from the file, which has the lengths of the file, is the one whose lengths are constants, to the bit.
fn evaluated<A, const N: usize>(_: &str)
where
    A: Parametric<N>,
    A::Folded: InverseBranch<f64, N> + InverseKinematics<f64, N, Target: task::Asked + Typed>,
{
    evaluated::inverse::<A::Folded, N>(A::FILE, A::folded_margins, Some(InverseBranch::inverse_branch));
}

#[test]
fn the_evaluated_file_gives_the_bits_of_constant_lengths() {
    arms!(check evaluated);
}

#[test]
fn every_pose_is_reached_with_any_lengths() {
    arms!(check recovers);
}

#[test]
fn degenerate_lengths_give_no_wrong_answer() {
    arms!(check stays_honest);
}

#[test]
fn lengths_that_are_no_numbers_give_a_status() {
    arms!(check refuses);
}

#[test]
fn the_values_of_the_file_give_the_solutions_of_the_file() {
    arms!(check like_folded);
}

/// Table 1 of Balerao et al. 2023: the lengths of the 2R arm change from row to row, and so do both its solutions, deg.
#[test]
fn published_rows_with_lengths_of_their_own() {
    for (target, [l1, l2], expected) in [
        ([16.0, 13.0], [10.0, 20.0], [[-33.258069, 100.806923], [111.445787, -100.806923]]),
        ([15.0, 5.0], [15.0, 10.0], [[-19.326295, 104.477512], [56.196193, -104.477512]]),
        ([12.99, 2.5], [10.0, 5.0], [[-8.214770, 60.006550], [30.002183, -60.006550]]),
    ] {
        let solutions = Planar2r { l1, l2 }.inverse(&target);
        assert_eq!(solutions.len(), 2);
        for [q1, q2] in expected {
            // Printed to six decimals.
            let near = |s: &&Solution<f64, 2>| {
                (s.q[0].to_degrees() - q1).abs() < 1e-6 && (s.q[1].to_degrees() - q2).abs() < 1e-6
            };
            assert!(solutions.iter().any(|s| near(&s)), "{target:?}: no {q1} {q2} in {solutions:?}");
        }
    }
}
