//! Following a path: straight lines and circles of 1,000 poses that lead exactly through, or closely past, singular
//! places. Each answer of `inverse_near` is the reference of the next.
//!
//! At every step the nearest solution is exact and closes within 1e-9. A continuation in steps a hundred times finer,
//! by Newton's method, also leads from the reference to the next pose. The nearest solution is at most 1.5 times as far
//! from the reference as the end of that continuation. Steps in which the least singular value of the Jacobian (lengths
//! in reaches) falls below 1e-6 are free to turn as far as they must.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::{InverseKinematics, Jacobian, Margin, Status};
use denhart_tests::arms::{Puma560, Stanford, Ur5};
use denhart_tests::random::Random;
use denhart_tests::singular::Svd;
use denhart_tests::subject::{Specified, Subject};
use denhart_tests::task::{Asked, Given, Goal, Kind, Task};
use nalgebra::{Isometry3, Matrix6, Translation3, Vector3, Vector6};

const POSES: usize = 1000;
const FINER: usize = 100;
const SINGULAR: f64 = 1e-6;
/// A path that leaves the reach by more than the tolerance, over reach, is none to follow.
const TOLERANCE: f64 = 1e-6;
/// Places from which Newton's method is started towards such a pose.
const STARTS: usize = 60;
/// Its steps.
const STEPS: usize = 40;

/// A line (`radius` infinite) or circle through `middle`, which it passes at parameter 0 along `along`, bending towards
/// `side`; orientation stays.
struct Path {
    middle: Isometry3<f64>,
    along: Vector3<f64>,
    side: Vector3<f64>,
    radius: f64,
    length: f64,
}

impl Path {
    /// The pose at `t` from -0.5 to 0.5.
    fn at(&self, t: f64) -> Isometry3<f64> {
        let s = self.length * t;
        let offset = if self.radius.is_finite() {
            let (sin, cos) = (s / self.radius).sin_cos();
            self.radius * (self.along * sin + self.side * (1.0 - cos))
        } else {
            self.along * s
        };
        Translation3::from(offset) * self.middle
    }
}

/// The Jacobian with lengths in reaches, and its determinant.
fn determinant<A: Specified<N>, const N: usize>(subject: &Subject<N>, q: &[f64; N]) -> (f64, Matrix6<f64>) {
    let (_, jacobian) = A::default().forward_and_jacobian(q);
    let matrix = scaled(subject, &jacobian);
    (matrix.determinant(), matrix)
}

/// The six joints that are not given.
fn moving<const N: usize>(subject: &Subject<N>) -> [usize; 6] {
    let mut joints = (0..N).filter(|joint| !subject.task.given.contains(*joint));
    std::array::from_fn(|_| joints.next().expect("an arm of six joints, or of seven with one given"))
}

fn scaled<const N: usize>(subject: &Subject<N>, jacobian: &Jacobian<f64, N>) -> Matrix6<f64> {
    let joints = moving(subject);
    Matrix6::from_fn(|row, column| {
        let (joint, length) = (joints[column], if row < 3 { subject.reach } else { 1.0 });
        jacobian.rows[row][joint] * subject.unit(joint) / length
    })
}

/// Newton's method on the forward kinematics, from a start close by. `None` if it does not close.
fn newton<A: Specified<N>, const N: usize>(
    subject: &Subject<N>,
    target: &Isometry3<f64>,
    start: &[f64; N],
) -> Option<[f64; N]> {
    let mut q = *start;
    for _ in 0..STEPS {
        let (reached, jacobian) = A::default().forward_and_jacobian(&q);
        let reached = Isometry3::from(reached);
        let linear = (target.translation.vector - reached.translation.vector) / subject.reach;
        let angular = (target.rotation * reached.rotation.inverse()).scaled_axis();
        let error = Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z);
        if error.norm() < 1e-13 {
            return Some(q);
        }
        let step = scaled(subject, &jacobian).lu().solve(&error)?;
        if step.norm() < 1e-14 {
            break;
        }
        // A longer step is none of a continuation.
        let scale = (0.3 / step.norm()).min(1.0);
        for (joint, change) in moving(subject).into_iter().zip(&step) {
            q[joint] += scale * change * subject.unit(joint);
        }
    }
    subject.miss(&goal(subject, target, &q), &q).iter().all(|miss| *miss < 1e-10).then_some(q)
}

/// Where a hundred small steps lead, and whether they come through a singular place.
fn continued<A: Specified<N>, const N: usize>(
    subject: &Subject<N>,
    path: &Path,
    [from, to]: [f64; 2],
    start: &[f64; N],
) -> (Option<[f64; N]>, bool) {
    let (mut q, mut sign) = (*start, 0.0);
    for part in 0..=FINER {
        if part > 0 {
            let t = from + (to - from) * part as f64 / FINER as f64;
            match newton::<A, N>(subject, &path.at(t), &q) {
                Some(next) => q = next,
                None => return (None, false),
            }
        }
        let (determinant, matrix) = determinant::<A, N>(subject, &q);
        // The least singular value is at least |det| over the greatest to the fifth.
        let safe = determinant.abs() > SINGULAR * matrix.norm().powi(5);
        if determinant * sign < 0.0 || !safe && Svd::at(subject, &q).least() < SINGULAR {
            return (Some(q), true);
        }
        sign = determinant;
    }
    (Some(q), false)
}

/// The pose, with the given joint where `q` has it.
fn goal<const N: usize>(subject: &Subject<N>, pose: &Isometry3<f64>, q: &[f64; N]) -> Goal {
    Goal { given: Given::of(subject.task.given.iter().map(|joint| q[joint]), 0.0), ..Goal::from(*pose) }
}

fn distance<const N: usize>(subject: &Subject<N>, a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).map(|joint| ((a[joint] - b[joint]) / subject.unit(joint)).powi(2)).sum::<f64>().sqrt()
}

/// A joint vector with the given joint where `q` has it.
fn anywhere<const N: usize>(subject: &Subject<N>, q: &[f64; N], random: &mut Random) -> [f64; N] {
    let mut start = *q;
    for joint in moving(subject) {
        start[joint] = subject.unit(joint) * random.uniform(-PI, PI);
    }
    start
}

/// Outcome of a path.
#[derive(Debug, PartialEq)]
enum Outcome {
    /// Followed to the end; how many steps were free.
    Followed(usize),
    /// It leaves the reach.
    OutOfReach,
}

fn follow<A, const N: usize>(subject: &Subject<N>, path: &Path, start: &[f64; N], name: &str) -> Outcome
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked>,
{
    let arm = A::default();
    let at = |k: usize| k as f64 / (POSES - 1) as f64 - 0.5;
    let asked = |k: usize, q: &[f64; N]| A::Target::of(Kind::Pose, &goal(subject, &path.at(at(k)), q));
    let gap = |k: usize| match A::status(&arm.inverse(&asked(k, start))) {
        Status::Unreachable { residual } => residual,
        _ => 0.0,
    };
    let (worst, short) =
        (0..POSES).map(|k| (k, gap(k))).fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    if short > TOLERANCE * subject.reach {
        // Newton's method does not come there either, from anywhere.
        let mut random = Random::named(name);
        let reached = (0..STARTS)
            .find_map(|_| newton::<A, N>(subject, &path.at(at(worst)), &anywhere(subject, start, &mut random)));
        assert!(
            reached.is_none(),
            "{name}: step {worst} is within reach, and said to be {short:e} out of it: {reached:?}"
        );
        return Outcome::OutOfReach;
    }
    let (mut q, mut free) = (*start, 0);
    for k in 0..POSES {
        let target = path.at(at(k));
        let solutions = arm.inverse_near(&asked(k, &q), &q);
        let Some(nearest) = solutions.as_ref().first() else {
            panic!("{name}: lost at step {k} from {q:?}: {:?}", A::status(&solutions))
        };
        assert!(nearest.is_exact(), "{name}: step {k} from {q:?} gives {nearest}");
        let miss = subject.miss(&goal(subject, &target, &q), &nearest.q);
        assert!(miss.iter().all(|miss| *miss <= 1e-9), "{name}: step {k} misses by {miss:?}");
        if k > 0 {
            let (fine, singular) = continued::<A, N>(subject, path, [at(k - 1), at(k)], &q);
            let step = distance(subject, &nearest.q, &q);
            match fine {
                _ if singular => free += 1,
                Some(fine) => {
                    let finer = distance(subject, &fine, &q);
                    assert!(step <= 1.5 * finer + 1e-9, "{name}: step {k} from {q:?} is {step:e}, finer {finer:e}");
                }
                // The small steps could not close: beside the place itself.
                None => free += 1,
            }
        }
        q = nearest.q;
    }
    Outcome::Followed(free)
}

/// Paths through the pose of `q`, which is singular, and past it at several distances: `beside` moves the singular joint
/// off its place.
fn through<A, const N: usize>(place: &str, singular: impl Fn(&mut Random, f64) -> [f64; N])
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked>,
{
    let subject = Subject::<N>::new::<A>();
    let mut random = Random::named(&format!("{} {place}", subject.name));
    for beside in [0.0, 1e-9, 1e-6, 1e-4, 1e-2] {
        let (mut lines, mut circles) = (0, 0);
        for _ in 0..40 {
            let near = singular(&mut random.clone(), beside);
            let mut q = singular(&mut random, 0.0);
            // The wrench that the arm cannot yield to: motions against it lead out of reach on one side.
            let matrix = determinant::<A, N>(&subject, &q).1;
            let svd = matrix.svd(true, false);
            let least = svd.singular_values.imin();
            let wrench = svd.u.map_or_else(Vector6::zeros, |u| u.column(least).into_owned());
            let force = Vector3::new(wrench[0], wrench[1], wrench[2]);
            let direction = Vector3::from(random.direction());
            let side = if force.norm() > 1e-6 { force.normalize() } else { Vector3::from(random.direction()) };
            let along = (direction - side * direction.dot(&side)).normalize();
            if beside != 0.0 {
                q = near;
            }
            let middle = subject.pose(&q);
            let length = 0.1 * subject.reach;
            let line = Path { middle, along, side, radius: f64::INFINITY, length };
            let name = |kind: &str| format!("{}, {place}, {beside:e} beside, {kind}", subject.name);
            if lines < 2 && matches!(follow::<A, N>(&subject, &line, &q, &name("line")), Outcome::Followed(_)) {
                lines += 1;
            }
            for side in [side, -side] {
                // Most of a turn around, so that the path comes back.
                let circle = Path { side, radius: length / 5.0, ..line };
                if circles < 2 && matches!(follow::<A, N>(&subject, &circle, &q, &name("circle")), Outcome::Followed(_))
                {
                    circles += 1;
                }
            }
            if lines >= 2 && circles >= 2 {
                break;
            }
        }
        assert!(lines + circles > 0, "{}: no path {place}", subject.name);
    }
}

/// Joints inside the limits, away from other singular places.
fn ordinary(random: &mut Random) -> [f64; 6] {
    let mut joint = |sign: bool| {
        let size = random.uniform(0.3, 1.2);
        if sign && random.bits() & 1 == 1 { -size } else { size }
    };
    [joint(true), joint(true), joint(false), joint(true), joint(true), joint(true)]
}

/// The value of joint 2 at which the shoulder's margin vanishes.
fn shoulder<const K: usize>(margins: impl Fn(f64) -> [Margin<f64>; K]) -> f64 {
    let margin = |q2: f64| {
        let margins = margins(q2);
        margins.iter().find(|margin| margin.name == "shoulder").expect("the arm has a shoulder").value
    };
    // Half a turn changes its sign.
    let (mut low, mut high) = (-FRAC_PI_2, FRAC_PI_2);
    let sign = margin(low);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if margin(middle) * sign > 0.0 { low = middle } else { high = middle }
    }
    low
}

#[test]
fn puma560_wrist() {
    through::<Puma560, 6>("through the wrist", |random, beside| {
        let [q1, q2, q3, q4, _, q6] = ordinary(random);
        [q1, q2, q3, q4, beside, q6]
    });
}

#[test]
fn puma560_elbow() {
    let straight = 0.0203_f64.atan2(0.4318) - FRAC_PI_2;
    through::<Puma560, 6>("through the stretched elbow", |random, beside| {
        let [q1, q2, _, q4, q5, q6] = ordinary(random);
        [q1, q2, straight + beside, q4, q5, q6]
    });
}

#[test]
fn puma560_shoulder() {
    through::<Puma560, 6>("through the shoulder", |random, beside| {
        let [q1, _, q3, q4, q5, q6] = ordinary(random);
        let q2 = shoulder(|q2| Puma560.margins(&[q1, q2, q3, q4, q5, q6]));
        [q1, q2 + beside, q3, q4, q5, q6]
    });
}

#[test]
fn ur5_wrist() {
    through::<Ur5, 6>("through the wrist", |random, beside| {
        let [q1, q2, q3, q4, _, q6] = ordinary(random);
        [q1, -q2.abs(), q3, q4, beside, q6]
    });
}

#[test]
fn ur5_elbow() {
    through::<Ur5, 6>("through the stretched elbow", |random, beside| {
        let [q1, q2, _, q4, q5, q6] = ordinary(random);
        [q1, -q2.abs(), beside, q4, q5, q6]
    });
    through::<Ur5, 6>("through the folded elbow", |random, beside| {
        let [q1, q2, _, q4, q5, q6] = ordinary(random);
        [q1, -q2.abs(), PI - beside, q4, q5, q6]
    });
}

#[test]
fn ur5_shoulder() {
    through::<Ur5, 6>("through the shoulder", |random, beside| {
        let [q1, _, q3, q4, q5, q6] = ordinary(random);
        let q2 = shoulder(|q2| Ur5.margins(&[q1, q2, q3, q4, q5, q6]));
        [q1, q2 + beside, q3, q4, q5, q6]
    });
}

#[test]
fn stanford_wrist() {
    through::<Stanford, 6>("through the wrist", |random, beside| {
        let [q1, q2, q3, q4, _, q6] = ordinary(random);
        [q1, q2, 0.5 * q3 + 0.2, q4, beside, q6]
    });
}

#[test]
fn stanford_elbow() {
    through::<Stanford, 6>("through the slide's middle", |random, beside| {
        let [q1, q2, _, q4, q5, q6] = ordinary(random);
        [q1, q2, beside, q4, q5, q6]
    });
}

#[test]
fn stanford_shoulder() {
    through::<Stanford, 6>("through the shoulder", |random, beside| {
        let [q1, _, q3, q4, q5, q6] = ordinary(random);
        let q3 = 0.5 * q3 + 0.2;
        let q2 = shoulder(|q2| Stanford.margins(&[q1, q2, q3, q4, q5, q6]));
        [q1, q2 + beside, q3, q4, q5, q6]
    });
}

/// KUKA's iiwa with joint 3 given, which stays where it is.
#[derive(Debug, Default, denhart::Arm)]
#[arm(spec = "../specs/kuka_iiwa7_r800.yaml")]
struct Iiwa;

impl Specified<7> for Iiwa {
    const NAME: &'static str = "iiwa";
    const TABLE: denhart::DhTable = Self::DH;
    const TASK: Task = Task::new(Kind::Pose).redundant(3);
}

#[test]
fn iiwa_wrist() {
    through::<Iiwa, 7>("through the wrist", |random, beside| {
        let [q1, q2, q4, q5, q7, q3] = ordinary(random);
        [q1, q2, 0.5 * q3, q4, q5, beside, q7]
    });
}

#[test]
fn iiwa_elbow() {
    through::<Iiwa, 7>("through the stretched elbow", |random, beside| {
        let [q1, q2, q6, q5, q7, q3] = ordinary(random);
        [q1, q2, 0.5 * q3, beside, q5, q6, q7]
    });
}

#[test]
fn iiwa_shoulder() {
    through::<Iiwa, 7>("through the shoulder", |random, beside| {
        let [q1, q6, q4, q5, q7, q3] = ordinary(random);
        let q2 = shoulder(|q2| Iiwa.margins(&[q1, q2, 0.5 * q3, q4, q5, q6, q7]));
        [q1, q2 + beside, 0.5 * q3, q4, q5, q6, q7]
    });
}
