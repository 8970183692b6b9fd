//! Closed form and iteration agree to 1e-9 on every arm of `specs/` that has both.

use std::f64::consts::PI;

use denhart::numeric::{NumericInverse, Task};
use denhart::{Arm, InverseKinematics, JointKind, PlanarPose, PointAngle};
use denhart_tests::arms;
use denhart_tests::random::Random;
use denhart_tests::subject::Specified;
use nalgebra::DMatrix;

/// The iteration ends within 1e-12 of the length and 1e-12 rad of the target, and so does the closed form. A joint may
/// differ by the sum of both over the least singular value, which is 4e-10 here.
const LEAST: f64 = 5e-3;
const PLACE: Task<f64> = Task::Components([true, true, true, false, false, false]);
const PLANE: Task<f64> = Task::Components([true, true, false, false, false, true]);
const FLAT: Task<f64> = Task::Components([true, true, false, false, false, false]);

/// Sum of the lengths of the table, or 1.
fn reach<A: Specified<N>, const N: usize>() -> f64 {
    let sum: f64 = A::TABLE.rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
    if sum > 0.0 { sum } else { 1.0 }
}

/// The least singular value of the rows that the task counts, lengths over reach, without a joint whose value is given.
fn least<A: Specified<N>, const N: usize>(arm: &A, rows: &[usize], given: Option<usize>, q: &[f64; N]) -> f64 {
    let mut all = DMatrix::from_row_iterator(6, N, arm.jacobian(q).rows.into_iter().flatten());
    all.rows_mut(0, 3).scale_mut(1.0 / reach::<A, N>());
    for (joint, kind) in A::JOINT_KINDS.iter().enumerate() {
        if *kind == JointKind::Prismatic {
            all.column_mut(joint).scale_mut(reach::<A, N>());
        }
    }
    let columns: Vec<usize> = (0..N).filter(|joint| Some(*joint) != given).collect();
    all.select_rows(rows).select_columns(&columns).singular_values().min()
}

/// Holds the iteration beside `closed`: every joint vector that does what the tool does at the first, with a given joint
/// as in the second.
fn agree<A, const N: usize>(
    task: Task<f64>,
    given: Option<usize>,
    closed: impl Fn(&A, &[f64; N], &[f64; N]) -> Vec<[f64; N]>,
) where
    A: Specified<N> + Arm<f64, N>,
{
    let (arm, reach) = (A::default(), reach::<A, N>());
    let rows: Vec<usize> = match task {
        Task::Components(asked) => (0..6).filter(|row| asked[*row]).collect(),
        _ => (0..6).collect(),
    };
    let solver = NumericInverse::new().task(task).length(reach).tolerance(1e-12 * reach, 1e-12).within_limits(false);
    let mut random = Random::named(A::NAME);
    let mut compared = 0;
    for _ in 0..60 {
        let goal: [f64; N] = std::array::from_fn(|joint| {
            let [low, high] = A::LIMITS[joint];
            let whole = if A::JOINT_KINDS[joint] == JointKind::Prismatic { reach } else { PI };
            random.uniform(low.max(-whole), high.min(whole))
        });
        let target = arm.forward(&goal);
        for from in closed(&arm, &goal, &goal).iter().filter(|q| least(&arm, &rows, given, q) >= LEAST) {
            let start = std::array::from_fn(|joint| {
                let unit = if A::JOINT_KINDS[joint] == JointKind::Prismatic { reach } else { 1.0 };
                from[joint] + 0.1 * LEAST * unit * random.uniform(-1.0, 1.0)
            });
            let numeric = solver.solve(&arm, &target, &start);
            assert!(numeric.converged(), "{}: {numeric:?} from {start:?}", A::NAME);
            let apart = |q: &[f64; N]| {
                let joints = q.iter().zip(&numeric.q).zip(A::JOINT_KINDS);
                joints.fold(0.0, |most: f64, ((a, b), kind)| {
                    let off = a - b;
                    most.max(if kind == JointKind::Prismatic { off / reach } else { denhart::math::wrap(off) }.abs())
                })
            };
            let nearest = closed(&arm, &goal, &numeric.q).iter().map(apart).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{}: {nearest:e} from {:?}, at {goal:?}", A::NAME, numeric.q);
            compared += 1;
        }
    }
    assert!(compared > 30, "{}: {compared} compared", A::NAME);
}

/// The joint vectors that the closed form calls exact.
fn exact<A: InverseKinematics<f64, N>, const N: usize>(arm: &A, target: &A::Target) -> Vec<[f64; N]> {
    let solutions = arm.inverse(target);
    solutions.as_ref().iter().filter(|solution| solution.is_exact()).map(|solution| solution.q).collect()
}

fn pose<A, const N: usize>()
where
    A: Specified<N> + InverseKinematics<f64, N, Target = denhart::Pose<f64>>,
{
    agree::<A, N>(Task::Pose, None, |arm, goal, _| exact(arm, &arm.forward(goal)));
}

fn given<A>(joint: usize)
where
    A: Specified<7> + InverseKinematics<f64, 7, Target = (denhart::Pose<f64>, f64)>,
{
    agree::<A, 7>(Task::Pose, Some(joint), |arm, goal, numeric| exact(arm, &(arm.forward(goal), numeric[joint])));
}

fn position<A>()
where
    A: Specified<3> + InverseKinematics<f64, 3, Target = [f64; 3]>,
{
    agree::<A, 3>(PLACE, None, |arm, goal, _| exact(arm, &arm.forward(goal).translation));
}

/// The iteration is asked for the pose: with the point and the angle these arms have no more to choose.
fn point_and_angle<A>(signs: [f64; 4], offset: f64)
where
    A: Specified<4> + InverseKinematics<f64, 4, Target = PointAngle<f64>>,
{
    agree::<A, 4>(Task::Pose, None, |arm, goal, _| {
        let angle = goal.iter().zip(signs).fold(offset, |sum, (q, sign)| sum + sign * q);
        let target = arm.forward(goal);
        let solutions = exact(arm, &PointAngle::new(target.translation, angle));
        // Half of the branches turn the arm's plane around: the same point and angle, but another pose.
        solutions.into_iter().filter(|q| arm.forward(q).residual(&target).orientation < 1e-6).collect()
    });
}

fn in_plane(pose: &denhart::Pose<f64>) -> PlanarPose<f64> {
    let [[cos, ..], [sin, ..], _] = pose.rotation;
    PlanarPose::new(pose.translation[0], pose.translation[1], sin.atan2(cos))
}

macro_rules! six_joints {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(six_joints! { @$kind $name $Type })*
    };
    (@inverse $name:ident $Type:ident) => {
        #[test]
        fn $name() {
            pose::<arms::$Type, 6>();
        }
    };
    (@$kind:ident $name:ident $Type:ident) => {};
}

denhart_tests::published_arms!(six_joints);

#[test]
fn seven_joints_with_one_given() {
    given::<arms::FrankaPanda>(6);
    given::<arms::KinovaGen37dof>(2);
    given::<arms::KukaIiwa7R800>(2);
    given::<arms::KukaLwr4>(2);
    given::<arms::YaskawaSia10d>(2);
}

#[test]
fn poses_of_four_and_five_joints() {
    pose::<arms::Cobra600Rrpr, 4>();
    pose::<arms::ScaraRrrp325275, 4>();
    pose::<arms::ScorbotEr5, 5>();
    pose::<arms::KukaYoubot, 5>();
}

#[test]
fn points() {
    position::<arms::Anthro3r>();
    position::<arms::CartesianPpp>();
    position::<arms::CylindricalRpp>();
    position::<arms::PolarRrp>();
    position::<arms::SalmanRrr>();
    position::<arms::SalmanRrrTable1>();
}

#[test]
fn points_and_angles() {
    point_and_angle::<arms::Jupiter>([0.0, 1.0, 1.0, 1.0], 0.0);
    point_and_angle::<arms::JupiterL46cm>([0.0, 1.0, 1.0, 1.0], 0.0);
    let offset = 180.0 + 2.4465297852086154 - 92.44652978520861;
    point_and_angle::<arms::Al5d>([0.0, 1.0, -1.0, 1.0], f64::to_radians(offset));
}

#[test]
fn in_the_plane() {
    agree::<arms::Planar2r, 2>(FLAT, None, |arm, goal, _| {
        let [x, y, _] = Arm::forward(arm, goal).translation;
        exact(arm, &[x, y])
    });
    agree::<arms::Planar2rUnit, 2>(FLAT, None, |arm, goal, _| {
        let [x, y, _] = Arm::forward(arm, goal).translation;
        exact(arm, &[x, y])
    });
    agree::<arms::Planar3r, 3>(PLANE, None, |arm, goal, _| exact(arm, &in_plane(&Arm::forward(arm, goal))));
    agree::<arms::Planar4rRedundant, 4>(PLANE, Some(0), |arm, goal, numeric| {
        exact(arm, &(in_plane(&Arm::forward(arm, goal)), numeric[0]))
    });
}
