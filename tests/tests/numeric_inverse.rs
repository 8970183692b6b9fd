//! Numeric inverse kinematics on whole arms: success with fixed seeds, limits, singular places, redundancy, tasks, the
//! chain, single precision, and agreement with the closed form.

use std::f64::consts::PI;

use denhart::numeric::{Method, NumericInverse, Stop, Task};
use denhart::{Arm, Chain, Convention, DhRow, DhTable, InverseKinematics, Pose};
use denhart_tests::random::Random;
use nalgebra::DMatrix;

macro_rules! arms {
    ($($Type:ident $spec:literal;)*) => {$(
        #[derive(Clone, Copy, Arm)]
        #[arm(spec = $spec)]
        struct $Type;
    )*};
}

arms! {
    Ur5 "../specs/ur5.yaml";
    Puma560 "../specs/puma560.yaml";
    AbbIrb2400 "../specs/abb_irb2400.yaml";
    KukaKr6 "../specs/kuka_kr6_r700.yaml";
    Stanford "../specs/stanford.yaml";
    SphericalShoulder "../specs/spherical_shoulder_6r.yaml";
    FrankaPanda "../specs/franka_panda.yaml";
    KinovaJaco "../specs/kinova_jaco.yaml";
    KukaLwr4 "../specs/kuka_lwr4.yaml";
    Youbot "../specs/kuka_youbot.yaml";
    Scara "../specs/scara_rrrp_325_275.yaml";
    Cartesian "../specs/cartesian_ppp.yaml";
    Planar2r "../specs/planar2r.yaml";
}

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/ur5.yaml", scalar = "f32")]
struct Ur5Single;

/// A joint vector within the limits; where there are none, within half a turn, or half a meter.
fn draw<A: Arm<f64, N>, const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|joint| {
        let [low, high] = A::LIMITS[joint];
        let around = if A::JOINT_KINDS[joint] == denhart::JointKind::Revolute { PI } else { 0.5 };
        if low.is_finite() && high.is_finite() { random.uniform(low, high) } else { random.uniform(-around, around) }
    })
}

fn is_within<A: Arm<f64, N>, const N: usize>(q: &[f64; N]) -> bool {
    q.iter().zip(A::LIMITS).all(|(q, [low, high])| (low..=high).contains(q))
}

fn judge(table: &DhTable, q: &[f64], target: &Pose<f64>) -> denhart::Residual<f64> {
    Pose::from(Chain::from(*table).forward(q).unwrap()).residual(target)
}

/// How many of `count` random reachable poses are solved. Every answer that claims to converge is checked by the chain,
/// every answer for limits.
fn solved<A: Arm<f64, N>, const N: usize>(
    name: &str,
    arm: &A,
    table: &DhTable,
    solver: &NumericInverse<f64>,
    count: usize,
) -> usize {
    let mut random = Random::named(name);
    let mut converged = 0;
    for _ in 0..count {
        let target = arm.forward(&draw::<A, N>(&mut random));
        let solution = solver.solve(arm, &target, &draw::<A, N>(&mut random));
        assert!(is_within::<A, N>(&solution.q), "{name}: {solution:?}");
        let missed = judge(table, &solution.q, &target);
        // The chain rounds differently, by some 1e-15.
        let same = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(same(missed.position, solution.residual.position), "{name}: {missed} {solution}");
        assert!(same(missed.orientation, solution.residual.orientation), "{name}: {missed} {solution}");
        let close = missed.position <= 1e-6 + 1e-12 && missed.orientation <= 1e-6 + 1e-12;
        assert_eq!(close, solution.converged(), "{name}: {missed} {solution}");
        converged += usize::from(solution.converged());
    }
    converged
}

/// Success of both methods from one start and with restarts. The rates were measured with other seeds on 10,000 poses;
/// 500 poses scatter by 2 %.
#[test]
fn random_reachable_poses_are_solved() {
    let single = NumericInverse::new().tolerance(1e-6, 1e-6);
    let restarted = single.restarts(20);
    let newton = restarted.method(Method::NewtonRaphson);
    macro_rules! check {
        ($name:literal $arm:ident, $least:literal) => {
            let table = $arm::DH;
            let one = solved($name, &$arm, &table, &single, 500);
            assert!(one >= $least, "{}: {one} of 500 from one start", $name);
            for solver in [&restarted, &newton] {
                let all = solved($name, &$arm, &table, solver, 500);
                assert!(all >= 498, "{}: {all} of 500 with restarts, {solver:?}", $name);
            }
        };
    }
    check!("ur5" Ur5, 440);
    check!("puma560" Puma560, 290);
    check!("franka_panda" FrankaPanda, 390);
    check!("kinova_jaco" KinovaJaco, 465);
}

/// Arms with fewer than six joints reach poses of their own with all of the pose asked for.
#[test]
fn any_number_of_joints() {
    let solver = NumericInverse::new().tolerance(1e-6, 1e-6).restarts(20);
    macro_rules! check {
        ($($name:literal $arm:ident;)*) => {$(
            let all = solved($name, &$arm, &$arm::DH, &solver, 200);
            assert!(all >= 199, "{}: {all} of 200", $name);
        )*};
    }
    check! {
        "kuka_lwr4" KukaLwr4;
        "kuka_youbot" Youbot;
        "stanford" Stanford;
        "cartesian_ppp" Cartesian;
    }
    // These are in millimeters or planar: the tolerance in the file's unit.
    let solver = NumericInverse::new().restarts(20);
    let mut random = Random::named("few joints");
    for _ in 0..200 {
        let target = Scara.forward(&draw::<Scara, 4>(&mut random));
        let solution = solver.solve(&Scara, &target, &draw::<Scara, 4>(&mut random));
        assert!(solution.converged(), "{solution:?}");
        let target = Planar2r.forward(&draw::<Planar2r, 2>(&mut random));
        let solution = solver.solve(&Planar2r, &target, &draw::<Planar2r, 2>(&mut random));
        assert!(solution.converged(), "{solution:?}");
    }
}

/// The least singular value of the Jacobian, lengths in meters.
fn least_singular_value<A: Arm<f64, 6>>(arm: &A, q: &[f64; 6]) -> f64 {
    DMatrix::from_row_iterator(6, 6, arm.jacobian(q).rows.into_iter().flatten()).singular_values().min()
}

/// From a start near a closed-form solution the iteration ends on it. The pose is off by up to 1e-12. A joint is off by
/// as much over the least singular value: up to 1e-9 wherever that value is above 1e-3.
fn agrees<A>(name: &str, arm: &A)
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let solver = NumericInverse::new().tolerance(1e-12, 1e-12).within_limits(false);
    let mut random = Random::named(name);
    let mut compared = 0;
    for _ in 0..200 {
        let target = arm.forward(&draw::<A, 6>(&mut random));
        for solution in arm.inverse(&target).as_ref() {
            if !solution.is_exact() || least_singular_value(arm, &solution.q) < 1e-3 {
                continue;
            }
            // So near that no other branch is nearer: the second-order error of a step is then below a tenth of it.
            let near = 0.1 * least_singular_value(arm, &solution.q);
            let start = solution.q.map(|q| q + random.uniform(-near, near));
            let numeric = solver.solve(arm, &target, &start);
            assert!(numeric.converged() && numeric.iterations <= 8, "{name}: {numeric:?}");
            let apart = numeric.q.iter().zip(solution.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-9, "{name}: {apart:e} apart\n{numeric:?}\n{solution:?}");
            compared += 1;
        }
    }
    assert!(compared > 200, "{name}: {compared}");
}

#[test]
fn closed_form_and_iteration_agree() {
    agrees("ur5", &Ur5);
    agrees("puma560", &Puma560);
    agrees("abb_irb2400", &AbbIrb2400);
    agrees("kuka_kr6_r700", &KukaKr6);
    agrees("stanford", &Stanford);
    agrees("spherical_shoulder_6r", &SphericalShoulder);
}

/// Random starts lead to one of the closed form's branches.
#[test]
fn a_numeric_solution_is_one_of_the_branches() {
    let solver = NumericInverse::new().tolerance(1e-12, 1e-12).restarts(20);
    let mut random = Random::named("branches");
    let mut compared = 0;
    for _ in 0..200 {
        let target = Ur5.forward(&draw::<Ur5, 6>(&mut random));
        let numeric = solver.solve(&Ur5, &target, &draw::<Ur5, 6>(&mut random));
        assert!(numeric.converged(), "{numeric:?}");
        if least_singular_value(&Ur5, &numeric.q) < 1e-3 {
            continue;
        }
        compared += 1;
        let nearest = Ur5.inverse_near(&target, &numeric.q);
        let q = nearest.nearest().unwrap().q;
        let apart = numeric.q.iter().zip(q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9, "{apart:e} apart\n{numeric:?}\n{nearest:?}");
    }
    assert!(compared > 150, "{compared}");
}

/// Stretched, folded and aligned configurations as start and as target. Every answer is finite and states truly whether
/// it converged, and no step is longer than the cap.
#[test]
fn singular_starts_and_targets() {
    let mut random = Random::named("singular");
    let specials = [0.0, 1e-12, -1e-9, 1e-6, PI / 2.0, -PI / 2.0, PI];
    let mut converged = 0;
    for round in 0..400 {
        let mut special = || -> [f64; 6] { std::array::from_fn(|_| random.pick(&specials)) };
        let (goal, start) = (special(), special());
        let target = Ur5.forward(&goal);
        for method in [Method::DampedLeastSquares, Method::NewtonRaphson] {
            let solver = NumericInverse::new().method(method).tolerance(1e-6, 1e-6).max_step(0.5);
            let step = solver.max_iterations(1).solve(&Ur5, &target, &start);
            let longest = step.q.iter().zip(start).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(longest <= 0.5 + 1e-12, "{round}: {longest}");
            let solution = solver.restarts(5).solve(&Ur5, &target, &start);
            assert!(solution.q.iter().all(|q| q.is_finite()), "{round}: {solution:?}");
            let missed = judge(&Ur5::DH, &solution.q, &target);
            assert_eq!(solution.converged(), missed.position <= 1e-6 && missed.orientation <= 1e-6, "{solution:?}");
            converged += usize::from(solution.converged());
        }
    }
    assert!(converged > 700, "{converged} of 800");
}

/// A target beyond reach is not claimed, and the arm ends stretched towards it.
#[test]
fn out_of_reach() {
    let mut target = Ur5.forward(&[0.2, -1.0, 0.8, 0.3, 1.0, 0.0]);
    target.translation = [3.0, 0.5, 0.4];
    for method in [Method::DampedLeastSquares, Method::NewtonRaphson] {
        let solution = NumericInverse::new().method(method).restarts(3).solve(&Ur5, &target, &[0.1; 6]);
        assert!(matches!(solution.stop, Stop::Stalled | Stop::IterationBound), "{solution}");
        assert!(solution.q.iter().all(|q| q.is_finite()) && solution.restarts == 3);
        let missed = judge(&Ur5::DH, &solution.q, &target);
        assert!((missed.position - solution.residual.position).abs() < 1e-12, "{missed} {solution}");
    }
}

/// A seven-joint arm ends nearer to its preferred posture than without one, on the target and within the limits.
#[test]
fn redundancy_serves_the_posture() {
    let posture = FrankaPanda::LIMITS.map(|[low, high]| 0.5 * (low + high));
    let distance = |q: &[f64; 7]| q.iter().zip(posture).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    let solver = NumericInverse::new().tolerance(1e-6, 1e-6).restarts(20);
    let mut random = Random::named("posture");
    let (mut nearer, mut least) = (0, f64::INFINITY);
    for _ in 0..100 {
        let target = FrankaPanda.forward(&draw::<FrankaPanda, 7>(&mut random));
        let start = draw::<FrankaPanda, 7>(&mut random);
        let plain = solver.solve(&FrankaPanda, &target, &start);
        assert!(plain.converged(), "{plain}");
        // From where the plain one ended, so that both are on the same branch.
        let near = solver.solve_towards(&FrankaPanda, &target, &plain.q, &posture);
        assert!(near.converged() && is_within::<FrankaPanda, 7>(&near.q), "{near:?}");
        nearer += usize::from(distance(&near.q) <= distance(&plain.q));
        least = least.min(distance(&near.q) - distance(&plain.q));
    }
    assert!(nearer >= 98 && least < -1.0, "{nearer} of 100, {least}");
}

/// Position alone, and position with the direction of one tool axis; what is not asked for stays free.
#[test]
fn tasks_ask_for_less() {
    let mut random = Random::named("tasks");
    let axis = [0.0, 0.6, 0.8];
    for _ in 0..100 {
        let target = Youbot.forward(&draw::<Youbot, 5>(&mut random));
        let start = draw::<Youbot, 5>(&mut random);
        let point = NumericInverse::new().task(Task::POSITION).tolerance(1e-6, 0.0).restarts(20);
        let solution = point.solve(&Youbot, &target, &start);
        assert!(solution.converged(), "{solution}");
        assert!(judge(&Youbot::DH, &solution.q, &target).position < 1e-6 + 1e-12);

        let target = KinovaJaco.forward(&draw::<KinovaJaco, 6>(&mut random));
        let start = draw::<KinovaJaco, 6>(&mut random);
        let pointing = NumericInverse::new().task(Task::PositionAxis(axis)).tolerance(1e-6, 1e-6).restarts(20);
        let solution = pointing.solve(&KinovaJaco, &target, &start);
        assert!(solution.converged(), "{solution}");
        let reached = KinovaJaco.forward(&solution.q);
        assert!(reached.residual(&target).position < 1e-6 + 1e-12);
        let turn = |pose: Pose<f64>| Pose { translation: [0.0; 3], ..pose }.transform_point(&axis);
        let apart: f64 = turn(reached).iter().zip(turn(target)).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        assert!(apart < 1.001e-6, "{apart}");
    }
}

/// The chain solves as the generated arm does, step by step, and has arms of any number of joints.
#[test]
fn the_chain_too() {
    let solver = NumericInverse::new();
    let mut random = Random::named("chain");
    let chain = Chain::from(Puma560::DH);
    for _ in 0..50 {
        let (goal, start) = (draw::<Puma560, 6>(&mut random), draw::<Puma560, 6>(&mut random));
        let target = chain.forward(&goal).unwrap();
        let solution = solver.restarts(20).solve_chain(&chain, &target, &start, Some(&Puma560::LIMITS)).unwrap();
        assert!(solution.converged(), "{solution}");
        assert!(is_within::<Puma560, 6>(&solution.q.try_into().unwrap()));
        // Few steps, over which two ways of rounding cannot drift apart.
        let start: [f64; 6] = std::array::from_fn(|joint| goal[joint] + 0.02 * (start[joint] - goal[joint]));
        let target = Pose::from(target);
        let arm = solver.solve(&Puma560, &target, &start);
        let chain = solver.solve_chain(&chain, &target.into(), &start, Some(&Puma560::LIMITS)).unwrap();
        assert_eq!(arm.converged(), chain.converged());
        if arm.converged() && least_singular_value(&Puma560, &arm.q) > 1e-2 {
            // Both are within 1e-9 of the target, and quadratically so.
            let apart = arm.q.iter().zip(&chain.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-6, "{apart:e}");
        }
    }
    for joints in [1, 3, 9, 70] {
        let rows: Vec<DhRow> = (0..joints)
            .map(|joint| match joint % 4 {
                3 => DhRow::prismatic(0.1, PI / 2.0, 0.1, 0.3),
                _ => DhRow::revolute(0.2, if joint % 2 == 0 { PI / 2.0 } else { -1.0 }, 0.1, 0.0),
            })
            .collect();
        let chain = Chain::new(Convention::Standard, &rows);
        let mut vector = || (0..joints).map(|_| random.uniform(-0.8, 0.8)).collect::<Vec<f64>>();
        let target = chain.forward(&vector()).unwrap();
        let start = vector();
        let solution = solver.restarts(20).solve_chain(&chain, &target, &start, None).unwrap();
        assert!(solution.converged(), "{joints} joints: {solution}");
        let missed = Pose::from(chain.forward(&solution.q).unwrap()).residual(&Pose::from(target));
        assert!(missed.orientation < 2e-9, "{joints} joints: {missed}");
        let posture = vec![0.0; joints];
        let near = solver.restarts(20).solve_chain_towards(&chain, &target, &start, &posture, None).unwrap();
        assert!(near.converged(), "{joints} joints: {near}");
        assert!(solver.solve_chain(&chain, &target, &start[1..], None).is_err());
        assert!(solver.solve_chain(&chain, &target, &start, Some(&[[0.0, 1.0]; 2])).is_err());
        assert!(solver.solve_chain_towards(&chain, &target, &start, &start[1..], None).is_err());
    }
}

#[test]
fn single_precision() {
    let solver = NumericInverse::<f32>::new().restarts(20);
    let mut random = Random::named("single");
    for _ in 0..200 {
        let goal = draw::<Ur5, 6>(&mut random).map(|q| q as f32);
        let start = draw::<Ur5, 6>(&mut random).map(|q| q as f32);
        let solution = solver.solve(&Ur5Single, &Ur5Single.forward(&goal), &start);
        assert!(solution.converged(), "{solution}");
        let target = Ur5.forward(&goal.map(f64::from));
        let missed = judge(&Ur5::DH, &solution.q.map(f64::from), &target);
        // The tolerance of 1e-5, of a reach of 1 m, and single precision's own error of some 1e-6.
        assert!(missed.position < 1.3e-5 && missed.orientation < 1.3e-5, "{missed}");
    }
}
