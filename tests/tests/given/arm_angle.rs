//! The arm angle in a list, beside the rail or the torso that carries the arm.

use std::f64::consts::PI;

use denhart::{Arm, InverseKinematics, Pose, math};
use denhart_tests::random::Random;

macro_rules! carried {
    ($Type:ident, $first:literal) => {
        /// A KUKA iiwa on one more joint.
        #[derive(Default, Arm)]
        #[arm(yaml = $first)]
        struct $Type;
    };
}

carried!(
    Rail,
    "
name: iiwa_on_a_rail
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: [rail, arm_angle], require: true}
tool: {xyz: [10, 20, 150], rpy: [15, -30, 45]}
joints:
  - {name: rail, type: prismatic, a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 50, alpha: 90, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
"
);

carried!(
    Torso,
    "
name: iiwa_on_a_torso
convention: standard
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: [arm_angle, q1, q9], require: true}
base: {xyz: [100, -50, 700], rpy: [0, 90, 20]}
joints:
  - {a: 200, alpha: 75, d: 300, theta: 20}
  - {type: fixed, a: 50, alpha: 0, d: 0, theta: 10}
  - {a: 0, alpha: -90, d: 340, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 400, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 390, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 20, alpha: 40, d: 100, theta: 0}
  - {a: 30, alpha: 0, d: 50, theta: 0}
"
);

/// Every joint vector comes back with its arm angle and the other given values.
fn check<A, const N: usize, const K: usize>(given: impl Fn(&A, &[f64; N]) -> [f64; K])
where
    A: Arm<f64, N> + InverseKinematics<f64, N, Target = (Pose<f64>, [f64; K])> + Default,
{
    let arm = A::default();
    let mut random = Random::named("arm angle in a list");
    for _ in 0..1000 {
        let q: [f64; N] = std::array::from_fn(|_| random.uniform(-PI, PI));
        let target = (arm.forward(&q), given(&arm, &q));
        assert_eq!(arm.target_at(&q), target);
        let same = |other: &[f64; N]| q.iter().zip(other).all(|(a, b)| math::wrap(a - b).abs() < 1e-6);
        let found = arm.inverse(&target);
        assert!(found.as_ref().iter().any(|s| s.is_exact() && same(&s.q)), "{q:?}: {:?}", found.as_ref());
        for solution in found.as_ref().iter().filter(|solution| solution.is_exact()) {
            assert!(arm.residual(&solution.q, &target).position < 1e-8, "{solution:?} at {q:?}");
        }
        let near = arm.inverse_near(&target, &q);
        assert!(near.as_ref().iter().any(|s| s.is_exact() && same(&s.q)), "{q:?}");
    }
}

#[test]
fn on_a_rail() {
    check::<Rail, 8, 2>(|arm, q| [q[0], arm.arm_angle(q)]);
    // The rail moves the shoulder, and the arm angle stays.
    let q = [0.3, 0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1];
    let mut moved = q;
    moved[0] = 700.0;
    assert!((Rail.arm_angle(&q) - Rail.arm_angle(&moved)).abs() < 1e-12);
}

#[test]
fn between_two_joints_that_turn() {
    check::<Torso, 9, 3>(|arm, q| [arm.arm_angle(q), q[0], q[8]]);
    let q = [0.3, 0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1, 0.5];
    let mut moved = q;
    moved[0] = -2.0;
    assert!((Torso.arm_angle(&q) - Torso.arm_angle(&moved)).abs() < 1e-12);
}
