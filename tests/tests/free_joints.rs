//! Singular poses are seen as such, in both precisions: every arm of `specs/` with an inverse for the pose of six joints.
//!
//! Poses come from the double-precision chain, on zeros of the Jacobian's determinant and on the grid of 90 degrees. They are
//! rounded to the scalar under test, which has to see through the rounding.
#![allow(clippy::unwrap_used)]

use denhart::solve::Tolerances;
use denhart::{Flags, InverseKinematics, Pose, Solution};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::singular::{self, Svd, ZERO, accepts_moved, self_motion};
use denhart_tests::subject::{Specified, Subject, largest};
use nalgebra::Matrix6;

/// Attempts to find a zero of the determinant; each moves one joint.
const ATTEMPTS: usize = 1_500;
/// Random joint vectors.
const RANDOM: usize = 5_000;

/// Bounds of the rules in a scalar. Singular values are those of the Jacobian with lengths in reaches.
struct Bars {
    /// A pose that is singular once: the least singular value but one and the [`slope`] are above this. Below, a second stage is
    /// doubtful too, an elbow nearly stretched.
    once: f64,
    /// A solution whose least singular value is below this is singular to rounding.
    singular: f64,
    /// A solution whose least singular value is above this is regular.
    regular: f64,
    /// Joints that move by less along the null space, of unit length, are at rest.
    rests: f64,
    /// Joint values that are the same, rad and reaches.
    same: f64,
}

impl Bars {
    fn of<T: Tolerances>() -> Self {
        let [vanishing, doubtful, coincident] = [T::VANISHING, T::DOUBTFUL, T::COINCIDENT].map(denhart::Scalar::to_f64);
        // A motion of half a turn either way.
        let rests = coincident / 4.0;
        Self { once: doubtful, singular: vanishing, regular: doubtful, rests, same: coincident }
    }
}

#[derive(Debug, Default)]
struct Found {
    poses: usize,
    free: usize,
    missed: usize,
    isolated: usize,
    /// Free joints said of regular solutions.
    regular: usize,
    /// The largest least singular value of a solution with free joints.
    largest: f64,
    first: Option<String>,
}

/// How fast the determinant grows beside a pose on its zero, over the product of the other singular values. The determinant
/// is the product of the stages' pivots, so that the slope at the zero of one is as small as the others are.
fn slope(subject: &Subject<6>, q: &[f64; 6], svd: &Svd<6>) -> f64 {
    const STEP: f64 = 1e-5;
    let determinant = |joint: usize, by: f64| {
        let mut q = *q;
        q[joint] += by * subject.unit(joint);
        let columns = subject.columns(&q);
        Matrix6::from_fn(|row, column| columns[column][row]).determinant()
    };
    let slopes = (0..6).map(|joint| (determinant(joint, STEP) - determinant(joint, -STEP)) / (2.0 * STEP));
    largest(slopes) / svd.values[..5].iter().product::<f64>()
}

fn check<A, S, T>()
where
    A: Specified<6> + InverseKinematics<f64, 6, Target = Pose<f64>>,
    S: InverseKinematics<T, 6, Target = Pose<T>> + Default,
    T: Tolerances,
{
    let (subject, arm, bars) = (Subject::new::<A>(), S::default(), Bars::of::<T>());
    let mut random = Random::named(A::NAME);
    let space = Space::of(&subject);
    let solved = |q: &[f64; 6]| -> Vec<([f64; 6], Solution<T, 6>)> {
        let pose = Pose::from(subject.pose(q));
        let target = Pose {
            rotation: pose.rotation.map(|row| row.map(T::from_f64)),
            translation: pose.translation.map(T::from_f64),
        };
        let solutions = arm.inverse(&target);
        let exact = solutions.as_ref().iter().filter(|solution| solution.is_exact());
        exact.map(|solution| (solution.q.map(T::to_f64), *solution)).collect()
    };
    let mut found = Found::default();
    let moved = |q: &[f64; 6], below: f64| -> [bool; 6] {
        let svd = Svd::at(&subject, q);
        std::array::from_fn(|j| (0..6).any(|k| svd.values[k] < below && svd.vectors[k][j].abs() > bars.rests))
    };

    // Where the arm is singular.
    let mut poses: Vec<[f64; 6]> =
        singular::surface(&subject, &mut random, ATTEMPTS).into_iter().map(|(q, _)| q).collect();
    poses.extend(space.grid(4));
    for q in &poses {
        let svd = Svd::at(&subject, q);
        if svd.least() > ZERO || svd.values[4] < bars.once || slope(&subject, q, &svd) < bars.once {
            continue;
        }
        found.poses += 1;
        let moves = self_motion(&subject, q, &svd);
        found.free += usize::from(moves);
        let solutions = solved(q);
        let own = |here: &[bool; 6]| {
            solutions.iter().filter(|(_, solution)| solution.flags.contains(Flags::FREE)).any(|(at, _)| {
                let there = moved(at, bars.once);
                subject.distance(at, q, |joint| !(here[joint] || there[joint])) < bars.same
            })
        };
        let missed = moves && !accepts_moved(&subject, q, &svd, own);
        let alone = |(at, solution): &([f64; 6], Solution<T, 6>)| {
            !solution.flags.contains(Flags::FREE)
                && !solution.flags.contains(Flags::BOUNDARY)
                && Svd::at(&subject, at).least() < bars.singular
        };
        // A fold has its two roots; beside a motion of its own a solution is not alone.
        let isolated = moves && solutions.iter().any(alone);
        found.missed += usize::from(missed);
        found.isolated += usize::from(isolated);
        if missed || isolated {
            found.first.get_or_insert_with(|| format!("{q:?} {:?} {moves} {solutions:?}", svd.values));
        }
    }
    // Where it is not.
    poses.retain(|q| Svd::at(&subject, q).least() > ZERO);
    poses.extend((0..RANDOM).map(|_| space.random(&mut random)));
    for q in &poses {
        for (at, _) in solved(q).iter().filter(|(_, solution)| solution.flags.contains(Flags::FREE)) {
            let least = Svd::at(&subject, at).least();
            found.largest = found.largest.max(least);
            found.regular += usize::from(least > bars.regular);
        }
    }
    println!("{}: {found:.2?}", A::NAME);
    assert!(found.free > 0, "{}: no pose lets a joint move", A::NAME);
    assert_eq!([found.missed, found.isolated, found.regular], [0; 3], "{}: {found:#?}", A::NAME);
}

macro_rules! free_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => { $(free_tests! { @$kind $name $Type $file })* };
    (@inverse $name:ident $Type:ident $file:literal) => {
        mod $name {
            use denhart_tests::task::{Kind, Task};

            denhart_tests::arm!($name $Type 6 $file Task::new(Kind::Pose));

            #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
            #[arm(spec = $file, scalar = "f32")]
            struct Single;

            #[test]
            fn double_precision() {
                crate::check::<$Type, $Type, f64>();
            }

            #[test]
            fn single_precision() {
                crate::check::<$Type, Single, f32>();
            }
        }
    };
    (@$other:ident $name:ident $Type:ident $file:literal) => {};
}

denhart_tests::published_arms!(free_tests);
