//! The arm angle as the given value: `redundant: arm_angle`.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::{Arm, Chain, Flags, InverseBranch, InverseKinematics, JointKind, Pose, Status};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;

/// KUKA's iiwa, by modified rows, mounted on a wall and with a tool.
#[derive(Default, Arm)]
#[arm(yaml = "
name: iiwa_on_a_wall
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: arm_angle, require: true}
base: {xyz: [100, -50, 700], rpy: [0, 90, 20]}
tool: {xyz: [10, 20, 150], rpy: [15, -30, 45]}
joints:
  - {a: 0, alpha: 0, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 380, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
")]
struct Wall;

/// A seven-joint arm in standard rows, the elbow beside the line of the upper arm.
#[derive(Default, Arm)]
#[arm(yaml = "
name: elbow_with_offset
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: arm_angle, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.3, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.05, alpha: -90, d: 0.4, theta: 0}
  - {a: -0.05, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0.39, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
")]
struct Offset;

/// Distance of two joint vectors, whole turns left out.
fn apart(a: &[f64; 7], b: &[f64; 7]) -> f64 {
    a.iter().zip(b).map(|(a, b)| denhart::math::wrap(a - b).abs()).fold(0.0, f64::max)
}

/// Every joint vector comes back with its arm angle; everything exact closes by the chain and has the angle asked for.
fn check<A>(table: denhart::DhTable, reach: f64, angle: impl Fn(&A, &[f64; 7]) -> f64)
where
    A: Arm<f64, 7> + InverseBranch<f64, 7> + InverseKinematics<f64, 7, Target = (Pose<f64>, f64)> + Default,
{
    let (arm, chain) = (A::default(), Chain::from(table));
    let mut random = Random::named("arm angle");
    for _ in 0..1000 {
        let q: [f64; 7] = std::array::from_fn(|_| random.uniform(-PI, PI));
        let target = Pose::from(chain.forward(&q).unwrap());
        let given = angle(&arm, &q);
        let found = arm.inverse(&(target, given));
        let solutions = found.as_ref();
        assert!(solutions.iter().any(|s| s.is_exact() && apart(&s.q, &q) < 1e-6), "{q:?}: {solutions:?}");
        for solution in solutions.iter().filter(|solution| solution.is_exact()) {
            let missed = Pose::from(chain.forward(&solution.q).unwrap()).residual(&target);
            assert!(missed.position < 1e-12 * reach && missed.orientation < 1e-12, "{missed:?} at {q:?}");
            // The angle is off by the joints' error over the elbow's distance from the line: far more where it is stretched.
            let turned = denhart::math::wrap(angle(&arm, &solution.q) - given).abs();
            let elbow = solution.q[3].sin().abs();
            assert!(elbow < 1e-2 || turned < 1e-9, "{turned:e} at {q:?}, {solution:?}");
        }
        for (index, solution) in solutions.iter().enumerate().filter(|(_, solution)| solution.flags == Flags::EXACT) {
            assert_eq!(arm.inverse_branch(&(target, given), solution.branch), Ok(*solution));
            assert!(solutions[..index].iter().all(|other| other.branch != solution.branch), "{solutions:?}");
        }
        let near = arm.inverse_near(&(target, given), &q);
        assert!(near.as_ref().iter().any(|s| s.is_exact() && apart(&s.q, &q) < 1e-6), "{q:?}");
    }
}

#[test]
fn joint_vectors_come_back() {
    check::<Wall>(Wall::DH, 1946.0, |arm, q| arm.arm_angle(q));
    check::<Offset>(Offset::DH, 1.29, |arm, q| arm.arm_angle(q));
}

/// An arm with links of equal length: folded, the wrist comes to the shoulder.
#[derive(Default, Arm)]
#[arm(yaml = "
name: iiwa_of_equal_links
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: arm_angle, require: true}
joints:
  - {a: 0, alpha: 0, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
")]
struct Equal;

/// Grids and the values where such arms are singular, exactly and beside: every pose is reached and what is exact closes;
/// `inverse_near` contains the joint vector, and `inverse` does where shoulder, elbow and wrist are bent.
fn check_awkward<A>(table: denhart::DhTable, reach: f64, angle: impl Fn(&A, &[f64; 7]) -> f64)
where
    A: Arm<f64, 7> + InverseBranch<f64, 7> + InverseKinematics<f64, 7, Target = (Pose<f64>, f64)> + Default,
{
    let (arm, chain) = (A::default(), Chain::from(table));
    let mut random = Random::named("awkward arm angle");
    let space = Space::new(&[JointKind::Revolute; 7], &[[f64::NEG_INFINITY, f64::INFINITY]; 7], reach);
    let special = [space.one_special(&mut random), space.two_special(&mut random), space.all_special(&mut random)];
    let grids = space.grid(4).chain(space.grid_samples(12, 4000, &mut random));
    for q in special.into_iter().flat_map(|family| family.poses).chain(grids) {
        let target = Pose::from(chain.forward(&q).unwrap());
        let asked = (target, angle(&arm, &q));
        let bent = [1, 3, 5].iter().all(|joint| q[*joint].sin().abs() > 1e-3);
        let (all, near) = (arm.inverse(&asked), arm.inverse_near(&asked, &q));
        for (found, contains, own) in [(all, bent, false), (near, true, true)] {
            assert!(A::status(&found).is_reachable(), "{q:?}");
            let exact = || found.as_ref().iter().filter(|solution| solution.is_exact());
            for solution in exact() {
                let missed = Pose::from(chain.forward(&solution.q).unwrap()).residual(&target);
                assert!(
                    missed.position < 1e-12 * reach && missed.orientation < 1e-12,
                    "{missed:?} at {q:?}, {solution}"
                );
                // Where the elbow hardly leaves the line from shoulder to wrist, rounding turns it; on the line its axis
                // tells the angle. The zero is told by a wrist off the first axis, or within 2.4e-7 by the base. A solution
                // with a free joint may have been moved along its family to close, and next to a reference its own place
                // is kept.
                let elbow = solution.q[3].sin().abs();
                let turned = denhart::math::wrap(angle(&arm, &solution.q) - asked.1).abs();
                let told = solution.free.is_empty() && !(1e-15..=1e-2).contains(&elbow);
                assert!(own || !told || turned < 1e-6, "{turned:e} at {q:?}, {solution}");
            }
            assert!(!contains || exact().any(|solution| apart(&solution.q, &q) < 1e-6), "{q:?}");
        }
    }
}

#[test]
fn awkward_joint_vectors_come_back() {
    check_awkward::<Wall>(Wall::DH, 1946.0, |arm, q| arm.arm_angle(q));
    check_awkward::<Offset>(Offset::DH, 1.29, |arm, q| arm.arm_angle(q));
    check_awkward::<Equal>(Equal::DH, 1266.0, |arm, q| arm.arm_angle(q));
}

/// A wrist pushed out of reach: unreachable by that distance, and within the tolerance the stretched arm is listed.
#[test]
fn a_wrist_out_of_reach() {
    let mut random = Random::named("stretched");
    for digits in 3..=11 {
        let mut q: [f64; 7] = std::array::from_fn(|_| random.uniform(-PI, PI));
        q[3] = 0.0;
        let mut pose = Equal.forward(&q);
        // The wrist is 126 mm behind the flange, the shoulder 340 mm up.
        let wrist = pose.transform_point(&[0.0, 0.0, -126.0]);
        let direction = [wrist[0], wrist[1], wrist[2] - 340.0].map(|x| x / 800.0);
        let push = 633.0 * 10.0_f64.powi(-digits);
        pose.translation = std::array::from_fn(|k| pose.translation[k] + push * direction[k]);
        let found = Equal.inverse(&pose, 0.4);
        let Status::Unreachable { residual } = found.status() else { panic!("{push:e}: {:?}", found.status()) };
        assert!((residual / push - 1.0).abs() < 1e-2, "{residual:e} for {push:e}");
        let listed = found.iter().any(|s| Equal.residual(&s.q, &pose).position < 1.01 * push);
        assert_eq!(listed, digits >= 6, "{push:e}: {found:?}");
    }
}

/// Zero is where the elbow stands on the side of the first axis; a quarter turn swings it about the line to the wrist.
#[test]
fn zero_is_up() {
    // Upper arm up and tilted by 45 degrees, forearm level.
    let q = [0.0, PI / 4.0, 0.0, FRAC_PI_2 - PI / 4.0, 0.0, 0.3, 0.0];
    assert!(Offset.arm_angle(&q).abs() < 1e-12, "{}", Offset.arm_angle(&q));
    let pose = Offset.forward(&q);
    let swung = Offset.inverse(&pose, FRAC_PI_2);
    assert_eq!(swung.status(), Status::Reachable);
    for solution in swung.exact() {
        assert!((Offset.arm_angle(&solution.q) - FRAC_PI_2).abs() < 1e-12);
    }
}

#[test]
fn the_walk_covers_a_turn() {
    let pose = Wall.forward(&[0.3, 0.6, -0.4, 1.1, 0.5, -0.7, 0.2]);
    let values: Vec<f64> = Wall.sample_redundancy(&pose, 8).map(|(value, _)| value).collect();
    assert_eq!(values.len(), 8);
    assert!((values[0] + PI * 7.0 / 8.0).abs() < 1e-12 && (values[7] - PI * 7.0 / 8.0).abs() < 1e-12, "{values:?}");
    assert!(Wall.sample_redundancy(&pose, 8).all(|(_, solutions)| solutions.status() == Status::Reachable));
}

#[test]
fn bad_values() {
    let pose = Wall.forward(&[0.1; 7]);
    assert_eq!(Wall.inverse(&pose, f64::NAN).status(), Status::BadTarget);
    assert_eq!(Wall.inverse(&pose, f64::INFINITY).status(), Status::BadTarget);
    assert_eq!(Wall.inverse_near(&pose, &[f64::NAN; 7]).status(), Status::BadTarget);
}
