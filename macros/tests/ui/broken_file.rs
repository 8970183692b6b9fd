//! Every way to use an arm, after one whose file has mistakes: the mistakes are the only error.

use denhart::{Arm, DhTable, InverseKinematics, Jacobian, Pose, Solution};

#[derive(Arm)]
#[arm(
    yaml = "
        name: broken
        convention: standrad
        units: {length: m, angle: deg}
        joints:
          - {type: revolute, a: 0, alpha: 90, d: 0.1, theta: 0}
          - {type: revolute, a: 0.4, d: 0, theta: 0}
          - {type: fixed, a: 0, alpha: 0, d: 0.1, theta: 0}
    "
)]
struct Broken;

fn generic<A: Arm<f64, N> + InverseKinematics<f64, N, Target = Pose<f64>>, const N: usize>(arm: A) -> Jacobian<f64, N> {
    let q = [0.0; N];
    let _nearest: Option<Solution<f64, N>> = arm.inverse_near(&arm.forward(&q), &q).as_ref().first().copied();
    let _target: Pose<f64> = arm.target_at(&q);
    arm.jacobian(&q)
}

fn main() {
    let arm = Broken;
    let q = core::array::from_fn(|i| i as f64);
    let pose = arm.forward(&q);
    let [shoulder, elbow] = arm.link_poses(&q);
    println!("{:?} {:?} {:?}", pose.translation, shoulder.rotation, elbow);
    println!("{:?}", arm.jacobian(&[0.0; Broken::DOF]).rows);
    let (again, jacobian) = arm.forward_and_jacobian(&q);
    println!("{:?} {:?}", again, jacobian.rows);
    for solution in arm.inverse(&pose).iter().chain(&arm.inverse_near(&pose, &q)) {
        println!("{:?} {:?} {:?}", solution.q.map(f64::to_degrees), solution.flags, solution.branch);
        println!("{:?}", arm.forward(&solution.q));
    }
    println!("{:?}", arm.inverse(&pose).status());
    let mut kept = arm.inverse(&pose);
    arm.inverse_into(&pose, &mut kept);
    arm.inverse_near_into(&pose, &q, &mut kept);
    println!("{:?}", arm.inverse(&arm.target_at(&q)).len());
    let table: DhTable = Broken::DH;
    println!("{:?} {:?} {:?}", table, Broken::LIMITS, Broken::JOINT_NAMES.join(" "));
    println!("{:?} {}", Broken::LENGTH_UNIT, Broken::MAX_SOLUTIONS);
    let (pulses, saturated) = arm.to_pulses_checked(&arm.from_motor(&arm.to_motor(&q)));
    println!("{saturated} {:?} {:?}", arm.from_pulses(&pulses), arm.motor_jacobian(&q).rows);
    println!("{:?} {:?}", arm.to_pulses(&q), arm.quantized_error(&q).residual);
    println!("{:?} {:?} {:?}", Broken::RESOLUTION, Broken::ACTUATORS, Broken::COMBINED_LIMITS);
    generic(Broken);
}
