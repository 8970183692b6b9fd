//! An arm at poses where two solutions are a hundredth of a radian apart: no family lies between them.

use denhart_dynamic::{DynamicArm, DynamicTarget};
use denhart_tests::random::Random;

const ARM: &str = "
name: arm
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q5}
joints:
  - {type: revolute, a: -0.425, alpha: 180, d: -0.39225, theta: -90}
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 180}
  - {type: revolute, a: -0.2, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 180, d: -0.3, theta: 0}
  - {type: prismatic, a: 0.0823, alpha: 0, d: 0.5, theta: 45}
  - {type: revolute, a: 0.2, alpha: -90, d: 0.2, theta: 30}
  - {type: fixed, a: 0, alpha: 180, d: 0, theta: 90}
  - {type: revolute, a: 0, alpha: -90, d: 0.5, theta: 15}
";

/// The numbers of solutions with the value of joint 5 given, and beside the joint vector that made the pose.
fn counts(arm: &DynamicArm, q: &[f64; 7]) -> [usize; 2] {
    let target = DynamicTarget::Pose(arm.forward(q).unwrap());
    let near = arm.inverse_near(&target, q).unwrap();
    assert!(near.iter().any(|solution| solution.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-6)), "{q:?}");
    [arm.inverse(&target, &q[4..5]).unwrap().len(), near.len()]
}

#[test]
fn a_reference_at_one_of_them_hides_no_other() {
    let arm = DynamicArm::from_yaml(ARM).unwrap();
    assert_eq!(counts(&arm, &[1.441, -0.499, -0.148, 0.737, -0.145, 1.163, -1.971]), [4, 4]);
    let mut random = Random::named("two roots");
    for _ in 0..1000 {
        let q = [3.1, 0.5, 3.1, 3.1, 0.5, 3.1, 3.1].map(|most| random.uniform(-most, most));
        let [given, near] = counts(&arm, &q);
        assert!(near >= given, "{q:?}: {near} beside it, {given} in all");
    }
}
