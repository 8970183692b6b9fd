//! Single precision beside arithmetic with 50 digits (`data/`), and beside `Chain` in double precision where more joint
//! vectors are needed: every arm of `specs/`.
//!
//! Joint values and targets are rounded before: the pose of the rounded vector, and the rounded pose, are what single
//! precision is asked for. Lengths are relative to reach.
//!
//! Directions have a bar of their own, see `rounded_sums`. A sum of joint values is rounded by up to 2.4e-7 rad beyond
//! 4 rad, by 4.8e-7 beyond 8, and by 9.5e-7 beyond 16. Three parallel joints that turn by 360 degrees reach 18.8.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::solve::Tolerances;
use denhart::{Arm, Chain, DhTable, InverseKinematics, Jacobian, JointKind, Pose};
use denhart_tests::random::Random;
use denhart_tests::reference::{self, Sample};
use denhart_tests::subject::{largest, reach, wrap};
use nalgebra::DMatrix;

/// The largest error of a position.
const FORWARD: f64 = 2e-7;
/// The largest error of an entry of a rotation or of the Jacobian where no sum of joint values is beyond `SMALL_SUM`.
const JACOBIAN: f64 = 4e-7;
/// A sum of joint values, rad, that is rounded by no more than 1.2e-7.
const SMALL_SUM: f64 = 4.0;
/// Random joint values times this keep sums of three within half a turn or little more.
const NEAR_ZERO: f64 = 0.2;
/// Largest position error of solutions called exact: of ninety-nine in a hundred, of all. A free joint stays at its
/// default value, though a target beside the singular one determines it. Then the solution misses by up to the diameter
/// of the joint's circle, which is `EXACT`.
const MISSED: [f64; 2] = [3e-7, 1e-6];
/// Random joint vectors.
const RANDOM: usize = 1_000;
/// Two joint vectors are one: the threshold `COINCIDENT` in single precision.
const SAME: f64 = 5.5e-3;
/// A singular value below this is that of a singular pose of the grid; the others are above 1e-2 there.
const SINGULAR: f64 = 1e-3;

fn single<const N: usize>(q: [f64; N]) -> [f32; N] {
    q.map(|x| x as f32)
}

fn double<const N: usize>(q: [f32; N]) -> [f64; N] {
    q.map(f64::from)
}

/// Pose and Jacobian at joint values close to those of a sample: to first order, which leaves 1e-13.
fn moved<const N: usize>(sample: &Sample, q: &[f64; N]) -> (Pose<f64>, Jacobian<f64, N>) {
    let by: [f64; N] = std::array::from_fn(|joint| q[joint] - sample.q[joint]);
    let jacobian =
        Jacobian { rows: std::array::from_fn(|row| std::array::from_fn(|joint| sample.jacobian[row][joint])) };
    let [x, y, z, u, v, w] = jacobian.mul(&by);
    let Pose { rotation, translation: [a, b, c] } = reference::pose(&sample.pose);
    let turn = |[i, j, k]: [f64; 3]| [v * k - w * j, w * i - u * k, u * j - v * i];
    let columns: [[f64; 3]; 3] = std::array::from_fn(|column| {
        let old = rotation.map(|row| row[column]);
        let change = turn(old);
        std::array::from_fn(|row| old[row] + change[row])
    });
    let rotation = std::array::from_fn(|row| columns.map(|column| column[row]));
    let change = jacobian.derivative(&by);
    let rows =
        std::array::from_fn(|row| std::array::from_fn(|joint| jacobian.rows[row][joint] + change.rows[row][joint]));
    (Pose { rotation, translation: [a + x, b + y, c + z] }, Jacobian { rows })
}

/// The largest errors of position, relative to reach, and rotation.
fn pose_error(pose: &Pose<f32>, truth: &Pose<f64>, reach: f64) -> [f64; 2] {
    let positions = (0..3).map(|k| (f64::from(pose.translation[k]) - truth.translation[k]) / reach);
    let rotations = (0..9).map(|k| f64::from(pose.rotation[k / 3][k % 3]) - truth.rotation[k / 3][k % 3]);
    [largest(positions), largest(rotations)]
}

fn jacobian_error<const N: usize>(jacobian: &Jacobian<f32, N>, truth: &Jacobian<f64, N>, reach: f64) -> f64 {
    let entries = (0..6).flat_map(|row| (0..N).map(move |joint| (row, joint)));
    largest(entries.map(|(row, joint)| {
        let unit = if row < 3 { reach } else { 1.0 };
        (f64::from(jacobian.rows[row][joint]) - truth.rows[row][joint]) / unit
    }))
}

/// Uniform within the limits.
fn random_joints<A: Arm<f32, N>, const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|joint| {
        let [low, high] = A::LIMITS[joint].map(f64::from);
        let end = |value: f64, open: f64| if value.is_finite() { value } else { open };
        random.uniform(end(low, -PI), end(high, PI))
    })
}

fn chain_at<const N: usize>(chain: &Chain, q: &[f64; N]) -> (Pose<f64>, Jacobian<f64, N>) {
    let jacobian = chain.jacobian(q).unwrap();
    let rows = std::array::from_fn(|row| std::array::from_fn(|joint| jacobian[(row, joint)]));
    (Pose::from(chain.forward(q).unwrap()), Jacobian { rows })
}

/// Half the distance between `x` in single precision and the next number: what the nearest number to `x` is off by, at most.
fn half_ulp(x: f64) -> f64 {
    let x = x.abs() as f32;
    f64::from(x.next_up() - x) / 2.0
}

/// Rounding of the sums of joint values over parallel axes, rad. Generated code takes the sine of such a sum, which
/// adds one joint value after the other. A sum within `SMALL_SUM` counts as none. Axes are parallel where the angular
/// columns of the Jacobian are.
fn rounded_sums<const N: usize>(kinds: &[JointKind; N], jacobian: &Jacobian<f64, N>, q: &[f64; N]) -> f64 {
    let turning: Vec<usize> = (0..N).filter(|&joint| kinds[joint] == JointKind::Revolute).collect();
    let axis = |joint: usize| [3, 4, 5].map(|row| jacobian.rows[row][joint]);
    let mut sum = turning.first().map_or(0.0, |&first| q[first]);
    let mut rounded = 0.0;
    for pair in turning.windows(2) {
        let [u, v] = [axis(pair[0]), axis(pair[1])];
        let cosine: f64 = u.iter().zip(&v).map(|(a, b)| a * b).sum();
        if cosine.abs() < 1.0 - 1e-12 {
            sum = q[pair[1]];
            continue;
        }
        // The sum about the second axis.
        sum = cosine.signum() * sum + q[pair[1]];
        if sum.abs() > SMALL_SUM {
            rounded += half_ulp(sum);
        }
    }
    rounded
}

fn forward<A: Arm<f32, N> + Default, const N: usize>(name: &str, table: &DhTable) {
    let (arm, chain) = (A::default(), Chain::from(*table));
    let reach = reach(table, &A::LIMITS.map(|ends| ends.map(f64::from)));
    let mut most = [0.0_f64; 3];
    let mut hold = |q: [f32; N], (pose, jacobian): (Pose<f64>, Jacobian<f64, N>)| {
        let (together, columns) = arm.forward_and_jacobian(&q);
        let poses = [together, arm.forward(&q)].map(|found| pose_error(&found, &pose, reach));
        let columns = [columns, arm.jacobian(&q)].map(|found| jacobian_error(&found, &jacobian, reach));
        let errors = [
            largest(poses.iter().map(|[position, _]| *position)),
            largest(poses.iter().map(|[_, rotation]| *rotation)),
            largest(columns.into_iter()),
        ];
        let directions = JACOBIAN + rounded_sums(&A::JOINT_KINDS, &jacobian, &double(q));
        for ((error, bar), most) in errors.into_iter().zip([FORWARD, directions, directions]).zip(&mut most) {
            assert!(error <= bar, "{name} at {q:?}: position, rotation, Jacobian off by {errors:.2?}, bar {bar:.2e}");
            *most = most.max(error);
        }
    };
    let reference = reference::load(name);
    assert!(!reference.samples.is_empty());
    for sample in &reference.samples {
        let q = single(std::array::from_fn(|joint| sample.q[joint]));
        hold(q, moved(sample, &double(q)));
    }
    let mut random = Random::named(name);
    for scale in [NEAR_ZERO, 1.0] {
        for _ in 0..RANDOM {
            let q = single(random_joints::<A, N>(&mut random).map(|value| scale * value));
            hold(q, chain_at(&chain, &double(q)));
        }
    }
    println!("{name}: position {:.2e}, rotation {:.2e}, Jacobian {:.2e}", most[0], most[1], most[2]);
}

/// Error of `q` against the target: position over reach, angle.
fn missed<const N: usize>(chain: &Chain, q: &[f32; N], target: &Pose<f32>, reach: f64) -> [f64; 2] {
    let wanted = Pose { rotation: target.rotation.map(double), translation: double(target.translation) };
    let wanted = wanted.orthonormalized();
    let residual = Pose::from(chain.forward(&double(*q)).unwrap()).residual(&wanted);
    [residual.position / reach, residual.orientation]
}

fn inverse<A, const N: usize>(name: &str, table: &DhTable)
where
    A: InverseKinematics<f32, N, Target = Pose<f32>> + Default,
{
    let (arm, chain) = (A::default(), Chain::from(*table));
    let reach = reach(table, &A::LIMITS.map(|ends| ends.map(f64::from)));
    let mut targets: Vec<Pose<f64>> =
        reference::load(name).samples.iter().map(|sample| reference::pose(&sample.pose)).collect();
    let mut random = Random::named(name);
    targets.extend((0..RANDOM).map(|_| chain_at(&chain, &random_joints::<A, N>(&mut random)).0));
    let mut misses = Vec::new();
    for target in targets {
        let target = Pose { rotation: target.rotation.map(single), translation: single(target.translation) };
        let solutions = arm.inverse(&target);
        assert!(A::status(&solutions).is_reachable(), "{name}: {target}");
        let exact = solutions.as_ref().iter().filter(|solution| solution.is_exact());
        for solution in exact {
            let q = double(solution.q);
            let [position, turned] = missed(&chain, &solution.q, &target, reach);
            // Verification sees a rotation whose entries have the error of a direction, three of which make the angle. Joint
            // values are rounded after it.
            let joints: f64 = q.iter().map(|&value| half_ulp(value)).sum();
            let bar = 3.0_f64.sqrt() * JACOBIAN + joints + rounded_sums(&A::JOINT_KINDS, &chain_at(&chain, &q).1, &q);
            assert!(
                turned <= bar && position <= if solution.free.is_empty() { MISSED[1] } else { f32::EXACT.into() },
                "{name}: {target}\n{solution:?}\nmisses by {position:.2e} of reach, and is turned by {turned:.2e}, bar {bar:.2e}"
            );
            misses.push([position, turned / bar]);
        }
    }
    let sorted = |part: usize| {
        let mut all: Vec<f64> = misses.iter().map(|miss: &[f64; 2]| miss[part]).collect();
        all.sort_by(f64::total_cmp);
        [0.99, 1.0].map(|share| all[((all.len() - 1) as f64 * share) as usize])
    };
    let ([p99, most], [_, turned]) = (sorted(0), sorted(1));
    let count = misses.len();
    let said = format!(
        "{name}: {count} solutions, position p99 {p99:.2e}, at most {most:.2e}; orientation at most {turned:.2} of its bar"
    );
    println!("{said}");
    assert!(p99 <= MISSED[0], "{said}");
}

/// The Jacobian's singular values and the joints that its null space moves, lengths relative to reach.
fn null_space<const N: usize>(chain: &Chain, q: &[f64; N], reach: f64) -> (usize, [bool; N]) {
    let mut jacobian = DMatrix::from_fn(6, N, |row, joint| chain.jacobian(q).unwrap()[(row, joint)]);
    jacobian.rows_mut(0, 3).scale_mut(1.0 / reach);
    for (joint, kind) in chain.kinds().into_iter().enumerate() {
        if kind == JointKind::Prismatic {
            jacobian.column_mut(joint).scale_mut(reach);
        }
    }
    let svd = jacobian.svd(false, true);
    let vectors = svd.v_t.unwrap();
    let null: Vec<usize> = (0..N).filter(|&k| svd.singular_values[k] < SINGULAR).collect();
    (null.len(), std::array::from_fn(|joint| null.iter().any(|&k| vectors[(k, joint)].abs() > SINGULAR)))
}

/// The rule of singular poses in single precision. An exact solution equals the joint vector that the pose was made
/// from, in every joint that no null space moves. The null spaces are those at the joint vector and at the solution. At
/// a rank at least two lower, some exact solution is there.
fn grid<A, const N: usize>(name: &str, table: &DhTable)
where
    A: InverseKinematics<f32, N, Target = Pose<f32>> + Default,
{
    let (arm, chain) = (A::default(), Chain::from(*table));
    let reach = reach(table, &A::LIMITS.map(|ends| ends.map(f64::from)));
    let (mut lost, mut first) = (0, None);
    let count = 4_usize.pow(N as u32);
    for index in 0..count {
        let q: [f64; N] = std::array::from_fn(|joint| {
            let step = (index / 4_usize.pow(joint as u32) % 4) as f64;
            match A::JOINT_KINDS[joint] {
                JointKind::Prismatic => {
                    let [low, high] = A::LIMITS[joint].map(f64::from);
                    if low.is_finite() && high.is_finite() {
                        low + (high - low) * step / 3.0
                    } else {
                        step * reach / 4.0
                    }
                }
                _ => (step - 1.0) * FRAC_PI_2,
            }
        });
        let target = Pose::from(chain.forward(&q).unwrap());
        let target = Pose { rotation: target.rotation.map(single), translation: single(target.translation) };
        let (free, here) = null_space(&chain, &q, reach);
        let solutions = arm.inverse(&target);
        let found = solutions.as_ref().iter().filter(|solution| solution.is_exact()).any(|solution| {
            let there = null_space(&chain, &double(solution.q), reach).1;
            free > 1
                || (0..N).all(|joint| {
                    let by = f64::from(solution.q[joint]) - q[joint];
                    let by = if A::JOINT_KINDS[joint] == JointKind::Prismatic { by / reach } else { wrap(by) };
                    here[joint] || there[joint] || by.abs() < SAME
                })
        });
        if !found {
            lost += 1;
            first.get_or_insert((q, free, format!("{:?} {:?}", A::status(&solutions), solutions.as_ref())));
        }
    }
    assert!(lost == 0, "{name}: {lost} of {count} poses lose a branch, first {first:?}");
}

macro_rules! truth_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        mod $name {
            #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
            #[arm(spec = $file, scalar = "f32")]
            struct Robot;

            #[test]
            fn forward() {
                crate::forward::<Robot, $dof>(stringify!($name), &Robot::DH);
            }

            truth_tests!(@$kind $name $dof);
        }
    )*};
    (@inverse $name:ident $dof:tt) => {
        #[test]
        fn inverse() {
            crate::inverse::<Robot, $dof>(stringify!($name), &Robot::DH);
        }

        #[test]
        fn grid() {
            crate::grid::<Robot, $dof>(stringify!($name), &Robot::DH);
        }
    };
    (@$other:ident $name:ident $dof:tt) => {};
}

denhart_tests::published_arms!(truth_tests);
