//! Arms in single precision beside the same arms in double precision.

use denhart::{Arm, Chain, InverseKinematics, Pose};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::singular::Svd;
use denhart_tests::subject::{Specified, Subject, largest, reach};

/// About fifty roundings of 6e-8 through forward kinematics and Jacobian.
const ROUNDING: f64 = 4e-6;

/// A pose whose least singular value is greater is a regular one, which closes to rounding.
const REGULAR: f64 = 0.02;

/// A solution called exact at another pose closes within 1.8e-5 by the arm's own forward kinematics. The roundings of
/// the target and of the check come on top.
const CLOSES: f64 = 1.8e-5 + 2.0 * ROUNDING;

/// How far a joint vector may move: the roundings of target and stages, over the least singular value.
const MOVES: f64 = 1e-5;

fn single<const N: usize>(q: [f64; N]) -> [f32; N] {
    q.map(|x| x as f32)
}

fn double<const N: usize>(q: [f32; N]) -> [f64; N] {
    q.map(f64::from)
}

/// A pose rounded to single precision.
fn rounded(pose: &Pose<f64>) -> Pose<f32> {
    Pose { rotation: pose.rotation.map(single), translation: single(pose.translation) }
}

fn check_forward<S: Arm<f32, N> + Default, D: Specified<N>, const N: usize>() {
    let chain = Chain::from(D::TABLE);
    let reach = reach(&D::TABLE, &D::LIMITS);
    let space = Space::new(&D::JOINT_KINDS, &D::LIMITS, reach);
    let mut random = Random::named(D::NAME);
    let arm = S::default();
    for _ in 0..1000 {
        let q = single(space.random(&mut random));
        let expected = Pose::from(chain.forward(&double(q)).unwrap());
        let (pose, jacobian) = arm.forward_and_jacobian(&q);
        for pose in [pose, arm.forward(&q)] {
            let positions = (0..3).map(|k| (f64::from(pose.translation[k]) - expected.translation[k]) / reach);
            let rotations = (0..9).map(|k| f64::from(pose.rotation[k / 3][k % 3]) - expected.rotation[k / 3][k % 3]);
            let error = largest(positions.chain(rotations));
            assert!(error < ROUNDING, "forward at {q:?}: {error:e}");
        }
        let expected = chain.jacobian(&double(q)).unwrap();
        let error = largest((0..6).flat_map(|row| (0..N).map(move |joint| (row, joint))).map(|(row, joint)| {
            let unit = if row < 3 { reach } else { 1.0 };
            (f64::from(jacobian.rows[row][joint]) - expected[(row, joint)]) / unit
        }));
        assert!(error < ROUNDING, "jacobian at {q:?}: {error:e}");
    }
}

fn check_inverse<S, D>()
where
    S: InverseKinematics<f32, 6, Target = Pose<f32>> + Default,
    D: Specified<6> + InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let subject = Subject::new::<D>();
    let space = Space::of(&subject);
    let mut random = Random::named(D::NAME);
    let arm = S::default();
    let mut poses: Vec<[f64; 6]> = (0..2000).map(|_| space.random(&mut random)).collect();
    poses.extend(space.grid_samples(4, 2000, &mut random));
    poses.extend(space.all_special(&mut random).poses);
    for q in poses {
        let target = subject.pose(&q);
        let least = Svd::at(&subject, &q).least();
        let solutions = arm.inverse(&rounded(&Pose::from(target)));
        // The rounding of the target may push it out of reach, by far less than what counts as exact.
        assert!(S::status(&solutions).is_reachable(), "{q:?}, {least:e}: {:?}", S::status(&solutions));
        for solution in solutions.as_ref() {
            assert!(solution.q.iter().all(|x| x.is_finite()), "{q:?}: {solution:?}");
            let miss = largest(subject.miss(&target.into(), &double(solution.q)).into_iter());
            let closes = if least > REGULAR { MOVES } else { CLOSES };
            assert!(!solution.is_exact() || miss < closes, "{q:?}: {solution:?} misses by {miss:e}");
        }
        if least > REGULAR {
            let distance = |s: &denhart::Solution<f32, 6>| subject.distance(&double(s.q), &q, |_| true);
            let nearest = solutions.as_ref().iter().map(distance).fold(f64::INFINITY, f64::min);
            assert!(nearest < MOVES / least, "{q:?}: the nearest solution is {nearest:e} away");
        }
    }
}

macro_rules! single_tests {
    ($($name:ident $Single:ident $Double:ident $file:literal;)*) => {$(
        mod $name {
            use denhart_tests::arms::{$Double, $Single};

            #[test]
            fn forward() {
                crate::check_forward::<$Single, $Double, 6>();
            }

            #[test]
            fn inverse() {
                crate::check_inverse::<$Single, $Double>();
            }
        }
    )*};
}

denhart_tests::single_arms!(single_tests);
