//! Any bits as joint vector and target of an arm: a status, numbers, and no more than the bound.

use std::sync::OnceLock;

use denhart::effort::{MOST_CASCADES, MOST_EVALUATIONS, MOST_HELD_JOINT_EVALUATIONS, effort_of};
use denhart::{Branch, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};

use crate::bytes::Bytes;

macro_rules! arms {
    ($($path:literal)*) => { &[$(include_str!(concat!("../../", $path))),*] };
}

/// Arms of different kernels and tasks. Their order is part of the corpus: new ones go to the end.
const ARMS: &[&str] = arms! {
    "specs/ur5.yaml"
    "specs/puma560.yaml"
    "specs/stanford.yaml"
    "specs/jupiter.yaml"
    "specs/spherical_shoulder_6r.yaml"
    "tests/arms/meeting/meet_345_b.yaml"
    "specs/scorbot_er5.yaml"
    "specs/kuka_youbot.yaml"
    "specs/scara_rrrp_325_275.yaml"
    "specs/planar3r.yaml"
    "specs/planar2r.yaml"
    "specs/cylindrical_rpp.yaml"
    "specs/al5d.yaml"
    "specs/franka_panda.yaml"
    "specs/kuka_lwr4.yaml"
    "tests/arms/meeting/meet_123_a.yaml"
    "tests/arms/meeting/wrist_45_70.yaml"
    "tests/arms/parallel/parallel_234_b.yaml"
    "tests/arms/sliding/slides_on_either_side.yaml"
    "tests/arms/sliding/turned_slides.yaml"
    "tests/arms/sliding_parallel/rail_to_stretch.yaml"
    "tests/arms/sliding_parallel/slide_flip_234.yaml"
    "tests/arms/position/prp_skew.yaml"
    "tests/arms/position_angle/crane_rrpr.yaml"
    "tests/arms/position_axis/rail_and_four.yaml"
    "tests/arms/pose_of_fewer_joints/gantry_pppr.yaml"
    "tests/arms/redundant_made_up/slide_given_between.yaml"
    "tests/arms/redundant_made_up/puma_on_a_rail.yaml"
    "specs/kinova_jaco.yaml"
    "specs/gen6r_a.yaml"
    "specs/fanuc_crx10ial.yaml"
    "specs/rethink_sawyer.yaml"
    "tests/arms/held_joint/slides_rprrpr.yaml"
};

fn arms() -> &'static [DynamicArm] {
    static BUILT: OnceLock<Vec<DynamicArm>> = OnceLock::new();
    BUILT.get_or_init(|| {
        ARMS.iter().map(|text| DynamicArm::from_yaml(text).unwrap_or_else(|error| panic!("{error}\n{text}"))).collect()
    })
}

/// The first byte chooses the arm. The second byte chooses how joint vector and target are made from the rest:
/// - 0: a joint vector of any bits, and the target of that joint vector;
/// - 1: a joint vector of numbers in `(-4, 4)`, and the target of that joint vector;
/// - 2: as 1, with some numbers of the target and the given joint value changed by less than 1;
/// - 3: as 1, with some numbers of target, given joint value and joint vector replaced by any bits.
pub fn run(data: &[u8]) {
    let mut bytes = Bytes::new(data);
    let arms = arms();
    let arm = &arms[bytes.below(arms.len())];
    let (own, kept) = (bytes.below(4), [bytes.byte(), bytes.byte()]);
    let mut q: Vec<f64> =
        (0..arm.joints()).map(|_| if own == 0 { bytes.bits() } else { 4.0 * bytes.fraction() }).collect();
    let mut target = arm.target_at(&q).unwrap_or_else(|error| panic!("{error}"));
    let mut given = arm.held(&q).unwrap_or_else(|error| panic!("{error}"));
    if own >= 2 {
        let mask = u16::from_le_bytes(kept);
        let mut index = 0;
        let mut replace = |value: &mut f64| {
            if mask >> (index % 16) & 1 == 1 {
                *value = if own == 2 {
                    *value + bytes.fraction() * 10.0_f64.powi(-(bytes.below(17) as i32))
                } else {
                    bytes.bits()
                };
            }
            index += 1;
        };
        numbers(&mut target).into_iter().for_each(&mut replace);
        given.iter_mut().for_each(&mut replace);
        if own == 3 {
            q.iter_mut().for_each(&mut replace);
        }
    }
    ask(arm, &target, &given, &q);
}

/// Every function of the arm.
fn ask(arm: &DynamicArm, target: &DynamicTarget, given: &[f64], q: &[f64]) {
    let all = bounded(|| arm.inverse(target, given)).unwrap_or_else(|error| panic!("{error}"));
    let near = bounded(|| arm.inverse_near(target, q)).unwrap_or_else(|error| panic!("{error}"));
    for solutions in [&all, &near] {
        honest(solutions);
    }
    for branch in all.iter().map(|solution| solution.branch).chain([Branch::NONE]) {
        match bounded(|| arm.inverse_branch(target, given, branch)) {
            Ok(Ok(solution)) => assert!(solution.q.iter().all(|x| x.is_finite()), "{solution:?}"),
            Ok(Err(_)) | Err(DynamicError::NoBranches) => {}
            Err(error) => panic!("{error}"),
        }
    }
    let called = arm.jacobian(q).is_ok() && arm.link_poses(q).is_ok() && arm.residual(q, target).is_ok();
    assert!(called && arm.margins(q).is_ok() && arm.to_motor(q).is_ok());
}

/// The result of a call that keeps to its bound.
fn bounded<R>(call: impl FnOnce() -> R) -> R {
    let (result, effort) = effort_of(call);
    // A call without a cascade is one of an inverse that holds a joint.
    let most = if effort.cascades == 0 { MOST_HELD_JOINT_EVALUATIONS } else { MOST_EVALUATIONS };
    assert!(effort.cascades <= MOST_CASCADES && effort.evaluations <= most, "{effort:?}");
    result
}

/// Solutions are finite, and the status is that of the list.
fn honest(solutions: &DynamicSolutions) {
    for solution in solutions.iter() {
        assert!(solution.q.iter().all(|x| x.is_finite()), "{solutions:?}");
        assert!(solution.residual.position >= 0.0 && solution.residual.orientation >= 0.0, "{solutions:?}");
    }
    let exact = solutions.iter().any(|solution| solution.is_exact());
    match solutions.status() {
        Status::Reachable => assert!(exact, "{solutions:?}"),
        Status::Unreachable { residual } => assert!(residual > 0.0 && !exact, "{solutions:?}"),
        Status::BadTarget => assert!(solutions.is_empty(), "{solutions:?}"),
    }
}

/// The numbers of a target.
fn numbers(target: &mut DynamicTarget) -> Vec<&mut f64> {
    match target {
        DynamicTarget::Pose(pose) => pose.translation.iter_mut().chain(pose.rotation.as_flattened_mut()).collect(),
        DynamicTarget::Position(point) => point.iter_mut().collect(),
        DynamicTarget::PositionAxis(asked) => asked.point.iter_mut().chain(&mut asked.axis).collect(),
        DynamicTarget::PositionAngle(asked) => asked.point.iter_mut().chain([&mut asked.angle]).collect(),
        DynamicTarget::PlanarPose(asked) => vec![&mut asked.x, &mut asked.y, &mut asked.phi],
        DynamicTarget::PlanarPosition(point) => point.iter_mut().collect(),
    }
}
