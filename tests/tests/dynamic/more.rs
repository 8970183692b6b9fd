//! Features that few arms have: linked motors, limits of sums, the arm angle; and files that are refused.

use denhart_dynamic::{DynamicArm, DynamicError, DynamicTarget};
use denhart_tests::evaluated::{Generated, bits, compare};
use denhart_tests::margins_of;
use denhart_tests::random::Random;

fn spec(name: &str) -> DynamicArm {
    DynamicArm::from_file(format!("{}/../specs/{name}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn random<const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|_| random.uniform(-3.0, 3.0))
}

arm! { Linked LINKED "
name: linked
convention: standard
units: {length: mm, angle: deg}
joints:
  - {a: 325, alpha: 0, d: 400, theta: 0, limits: [-100, 90], actuator: {pulses_per_rev: 4000, gear_ratio: 20, home: 15}}
  - {a: 275, alpha: 0, d: 0, theta: 0, limits: [-140, 140], actuator: {pulses_per_rev: 6400, direction: -1}}
  - {a: 0, alpha: 180, d: 0, theta: 0, actuator: {pulses_per_rev: 3200, home: -30}}
  - {name: z, type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 200], actuator: {pulses_per_unit: 80}}
coupling:
  q2: {q1: 1, q2: 3, offset: -90}
  z: {z: 2, q3: 20 per rev, offset: 5}
combined_limits:
  - {sum: {q1: 1, q2: 1}, limits: [-120, 90]}
" }

#[test]
fn linked_motors_and_limits_of_sums() {
    let arm = DynamicArm::from_yaml(LINKED).unwrap();
    compare(
        "linked",
        &arm,
        &Generated::with_inverse::<Linked, 4>(&arm, margins_of!(Linked), denhart_tests::branch_of!(Linked)),
    );
    let mut seed = Random::named("linked motors");
    for _ in 0..50 {
        let q = random(&mut seed);
        let motor = arm.to_motor(&q).unwrap();
        assert_eq!(bits::numbers(motor.to_vec()), bits::numbers(Linked.to_motor(&q)));
        assert_eq!(bits::numbers(arm.from_motor(&q).unwrap().to_vec()), bits::numbers(Linked.from_motor(&q)));
        assert_eq!(bits::rows(&arm.motor_jacobian(&q).unwrap()), bits::jacobian(&Linked.motor_jacobian(&q)));
    }
    let unlinked = spec("ur5");
    assert_eq!(*unlinked.to_motor(&[0.5; 6]).unwrap(), [0.5; 6]);
}

arm! { Swung SWUNG "
name: swung
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: arm_angle, require: true}
base: {xyz: [100, -50, 700], rpy: [0, 90, 20]}
joints:
  - {a: 0, alpha: 0, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
" }

#[test]
fn arm_angle() {
    let arm = DynamicArm::from_yaml(SWUNG).unwrap();
    compare(
        "swung",
        &arm,
        &Generated::with_inverse::<Swung, 7>(&arm, margins_of!(Swung), denhart_tests::branch_of!(Swung)),
    );
    let mut seed = Random::named("arm angle");
    for _ in 0..50 {
        let q = random(&mut seed);
        assert_eq!(bits::number(arm.arm_angle(&q).unwrap()), bits::number(Swung.arm_angle(&q)));
    }
    assert_eq!(arm.given(), Ok(vec!["the arm angle".to_owned()]));
}

arm! { Ten TEN "
name: ten
convention: standard
units: {length: m, angle: deg}
joints:
  - {a: 0.1, alpha: 90, d: 0.1, theta: 10}
  - {a: 0.1, alpha: 0, d: 0.2, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 90}
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0.1, theta: 0}
  - {a: 0.1, alpha: 180, d: 0.1, theta: 0}
  - {a: 0.1, alpha: 0, d: 0.1, theta: 35.5}
  - {type: fixed, a: 0.1, alpha: 17, d: 0.1, theta: 20}
  - {a: 0.1, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.2, alpha: -90, d: 0.1, theta: -15}
  - {a: 0.1, alpha: 0, d: 0.1, theta: 0}
tool: {xyz: [0.1, 0.2, 0.3], rpy: [10, 20, 30]}
" }

#[test]
fn ten_joints() {
    let arm = DynamicArm::from_yaml(TEN).unwrap();
    compare("ten", &arm, &Generated::kinematics::<Ten, 10>(margins_of!(Ten)));
    assert!(matches!(arm.task(), Err(DynamicError::NoInverse(_))));
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    let (arm, redundant) = (spec("ur5"), spec("kuka_iiwa7_r800"));
    let target = arm.target_at(&[0.3; 6]).unwrap();
    assert_eq!(arm.forward(&[0.0; 5]), Err(DynamicError::Joints { expected: 6, found: 5 }));
    assert_eq!(arm.inverse(&target, &[0.0]), Err(DynamicError::Given { expected: Vec::new(), found: 1 }));
    let missing = redundant.inverse(&target, &[]).unwrap_err();
    assert_eq!(missing.to_string(), "the inverse takes 1 value (q3) beside the target, not 0");
    let point = DynamicTarget::Position([0.1; 3]);
    assert_eq!(arm.inverse(&point, &[]), Err(DynamicError::Target { expected: "pose", found: "position" }));
    assert!(matches!(DynamicArm::from_yaml("name: x\n"), Err(DynamicError::Mistakes(_))));
    assert!(matches!(DynamicArm::from_file("no/such.yaml"), Err(DynamicError::Read(_))));
}
