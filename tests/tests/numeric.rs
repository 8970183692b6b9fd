//! Forward kinematics, link poses and Jacobian of every arm, beside the chain and the reference data.

use denhart::{Chain, Jacobian, JointKind, Pose};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::reference;
use denhart_tests::subject::{Specified, largest, reach};

/// A product of ten transforms rounds about fifty times, each time by at most 1.1e-16 of the value or of reach.
const ROUNDING: f64 = 1e-13;

/// Largest difference of two poses, positions in reaches.
fn pose_error(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let positions = a.translation.iter().zip(&b.translation).map(|(x, y)| (x - y) / reach);
    let rotations = a.rotation.as_flattened().iter().zip(b.rotation.as_flattened()).map(|(x, y)| x - y);
    largest(positions.chain(rotations))
}

/// Largest difference of two Jacobians, velocities in reaches.
fn jacobian_error<const N: usize>(a: &Jacobian<f64, N>, b: impl Fn(usize, usize) -> f64, reach: f64) -> f64 {
    let difference =
        |row: usize, joint: usize| (a.rows[row][joint] - b(row, joint)) / if row < 3 { reach } else { 1.0 };
    largest((0..6).flat_map(|row| (0..N).map(move |joint| (row, joint))).map(|(row, joint)| difference(row, joint)))
}

/// Every forward function of the arm at `q` beside the chain.
fn check_at<A: Specified<N>, const N: usize>(chain: &Chain, reach: f64, q: &[f64; N]) {
    let arm = A::default();
    let expected = Pose::from(chain.forward(q).unwrap());
    // One ulp of a joint value turns everything behind it by as much; the two sides round q + theta differently.
    let tolerance = ROUNDING + 4.0 * f64::EPSILON * largest(q.iter().copied());

    let pose = arm.forward(q);
    let error = pose_error(&pose, &expected, reach);
    assert!(error < tolerance, "forward at {q:?}: {error:e}\n{pose:?}\n{expected:?}");

    let links = arm.link_poses(q);
    for (index, (link, expected)) in links.iter().zip(chain.link_poses(q).unwrap()).enumerate() {
        let error = pose_error(link, &Pose::from(expected), reach);
        assert!(error < tolerance, "link pose {index} at {q:?}: {error:e}\n{link:?}\n{expected:?}");
    }

    let jacobian = arm.jacobian(q);
    let expected = chain.jacobian(q).unwrap();
    let error = jacobian_error(&jacobian, |row, joint| expected[(row, joint)], reach);
    assert!(error < tolerance, "jacobian at {q:?}: {error:e}\n{jacobian:?}\n{expected}");

    let (both_pose, both_jacobian) = arm.forward_and_jacobian(q);
    let error = pose_error(&both_pose, &pose, reach);
    assert!(error < tolerance, "pose of forward_and_jacobian at {q:?}: {error:e}");
    let error = jacobian_error(&both_jacobian, |row, joint| jacobian.rows[row][joint], reach);
    assert!(error < tolerance, "jacobian of forward_and_jacobian at {q:?}: {error:e}");
}

/// The arm beside the chain at random joint vectors, on a 90 degree grid, and after many turns.
fn check_beside_chain<A: Specified<N>, const N: usize>() {
    let chain = Chain::from(A::TABLE);
    let reach = reach(&A::TABLE, &A::LIMITS);
    let space = Space::new(&A::JOINT_KINDS, &A::LIMITS, reach);
    let mut random = Random::named(A::NAME);
    for _ in 0..1000 {
        check_at::<A, N>(&chain, reach, &space.random(&mut random));
    }
    for q in space.grid_samples(4, 500, &mut random) {
        check_at::<A, N>(&chain, reach, &q);
    }
    for _ in 0..100 {
        let q = space.random(&mut random);
        let wound =
            |joint: usize| if A::JOINT_KINDS[joint] == JointKind::Revolute { 100.0 * q[joint] } else { q[joint] };
        check_at::<A, N>(&chain, reach, &std::array::from_fn(wound));
    }
}

/// The arm and the chain beside the reference.
fn check_beside_reference<A: Specified<N>, const N: usize>() {
    let reference = reference::load(A::NAME);
    assert_eq!((reference.name.as_str(), reference.dof), (A::NAME, N));
    assert!(!reference.samples.is_empty());
    let chain = Chain::from(A::TABLE);
    let reach = reach(&A::TABLE, &A::LIMITS);
    for sample in &reference.samples {
        let q: [f64; N] = sample.q.as_slice().try_into().unwrap();
        let expected = reference::pose(&sample.pose);
        for (side, pose) in [("arm", A::default().forward(&q)), ("chain", Pose::from(chain.forward(&q).unwrap()))] {
            let error = pose_error(&pose, &expected, reach);
            assert!(error < ROUNDING, "forward of the {side} at {q:?}: {error:e}\n{pose:?}\n{expected:?}");
        }
        let expected = |row: usize, joint: usize| sample.jacobian[row][joint];
        let error = jacobian_error(&A::default().jacobian(&q), expected, reach);
        assert!(error < ROUNDING, "jacobian at {q:?}: {error:e}");
    }
}

macro_rules! beside_chain {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            super::check_beside_chain::<denhart_tests::arms::$Type, $dof>();
        }
    )*};
}

macro_rules! beside_reference {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            super::check_beside_reference::<denhart_tests::arms::$Type, $dof>();
        }
    )*};
}

mod chain {
    denhart_tests::published_arms!(beside_chain);
    denhart_tests::made_up_arms!(beside_chain);
}

mod data {
    denhart_tests::published_arms!(beside_reference);
}
