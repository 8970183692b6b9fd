//! The same questions to generated code and to the evaluated program.

use denhart::{JointKind, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};
use denhart_tests::random::Random;

use crate::bits::{self, evaluated};
use crate::generated::{Generated, Inverse};

/// Joint vectors of an arm.
const POSES: usize = 60;
/// Joints are often at multiples of this, where arms are singular.
const STEP: f64 = std::f64::consts::FRAC_PI_4;

/// Compares every function at random joint vectors, at those of a grid, and at targets in and out of reach.
pub fn compare(name: &str, arm: &DynamicArm, generated: &Generated) {
    let mut random = Random::named(name);
    // Some lists leave out what the inverse of an arm is asked for.
    assert!(generated.inverse.is_none() || arm.task().is_ok(), "{name}: {:?}", arm.task());
    let mut solutions = 0;
    for round in 0..POSES {
        let q = joints(arm, round, &mut random);
        let at = || format!("{name} at {q:?}");
        assert_eq!(bits::pose(&arm.forward(&q).unwrap()), (generated.forward)(&q), "forward, {}", at());
        assert_eq!(bits::poses(&arm.link_poses(&q).unwrap()), (generated.links)(&q), "link poses, {}", at());
        assert_eq!(bits::rows(&arm.jacobian(&q).unwrap()), (generated.jacobian)(&q), "Jacobian, {}", at());
        let (pose, jacobian) = arm.forward_and_jacobian(&q).unwrap();
        assert_eq!([bits::pose(&pose), bits::rows(&jacobian)].concat(), (generated.both)(&q), "both, {}", at());
        if let Some(inverse) = &generated.inverse {
            let given = arm.held(&q).unwrap();
            for target in targets(&arm.target_at(&q).unwrap(), round, &mut random) {
                solutions += ask(&format!("{target:?} and {}", at()), arm, inverse, &target, given, &q, &mut random);
            }
        }
    }
    assert!(generated.inverse.is_none() || solutions > POSES, "{name}: {solutions} solutions");
}

/// A joint vector: at random, or each joint on a grid or beside it.
fn joints(arm: &DynamicArm, round: usize, random: &mut Random) -> Vec<f64> {
    let joint = |(kind, [low, high]): (&JointKind, &[f64; 2])| {
        let (low, high) = match kind {
            JointKind::Revolute => (low.max(-3.1), high.min(3.1)),
            _ => (low.max(-1.0), high.min(1.0)),
        };
        let value = random.uniform(low, high);
        match round % 4 {
            0 | 1 => value,
            2 => (value / STEP).round() * STEP,
            _ => (value / STEP).round() * STEP + random.uniform(-1.0, 1.0) * 10.0_f64.powi(-(round as i32 / 4)),
        }
    };
    arm.joint_kinds().iter().zip(arm.limits()).map(joint).collect()
}

/// The target; the same a little off, far out, a little way out, turned off a rotation, and not a number.
fn targets(target: &DynamicTarget, round: usize, random: &mut Random) -> Vec<DynamicTarget> {
    let near = moved(target, |x| x + 1e-9 * random.uniform(-1.0, 1.0));
    let mut all = vec![*target, near];
    match round % 6 {
        0 => all.push(moved(target, |x| 3.0 * x)),
        1 => all.push(moved(target, |x| 1.02 * x)),
        2 => all.push(moved(target, |x| (x * 1e4).round() / 1e4)),
        3 => all.push(moved(target, |_| f64::NAN)),
        4 => all.push(moved(target, |_| 0.0)),
        _ => all.push(moved(target, |x| 1e200 * x)),
    }
    if let DynamicTarget::Pose(pose) = target {
        let rotation = pose.rotation.map(|row| row.map(|entry| (entry * 1e5).round() / 1e5));
        all.push(DynamicTarget::Pose(Pose { rotation, ..*pose }));
    }
    all
}

/// The target with every coordinate of its point changed.
fn moved(target: &DynamicTarget, mut change: impl FnMut(f64) -> f64) -> DynamicTarget {
    let mut target = *target;
    match &mut target {
        DynamicTarget::Pose(pose) => pose.translation = pose.translation.map(change),
        DynamicTarget::Position(point) => *point = point.map(change),
        DynamicTarget::PositionAxis(asked) => asked.point = asked.point.map(change),
        DynamicTarget::PositionAngle(asked) => asked.point = asked.point.map(change),
        DynamicTarget::PlanarPose(asked) => (asked.x, asked.y) = (change(asked.x), change(asked.y)),
        DynamicTarget::PlanarPosition(point) => *point = point.map(change),
    }
    target
}

/// Asks for one target; returns how many solutions it has.
fn ask(
    case: &str,
    arm: &DynamicArm,
    generated: &Inverse,
    target: &DynamicTarget,
    given: Option<f64>,
    q: &[f64],
    random: &mut Random,
) -> usize {
    let value = given.unwrap_or(0.0);
    let solutions = arm.inverse(target, given).unwrap();
    assert_eq!(bits::answer(&solutions), (generated.all)(target, value), "inverse, {case}");
    let beside: Vec<f64> = q.iter().map(|q| q + random.uniform(-0.3, 0.3)).collect();
    for reference in [q, &beside] {
        let near = bits::answer(&arm.inverse_near(target, reference).unwrap());
        let held = arm.held(reference).unwrap().unwrap_or(0.0);
        assert_eq!(near, (generated.near)(target, held, reference), "inverse_near, {case}");
        let residual = arm.residual(reference, target).unwrap();
        let residual = [residual.position, residual.orientation].map(bits::number);
        assert_eq!(residual, (generated.residual)(target, value, reference), "residual, {case}");
    }
    if let Some(generated) = &generated.branch {
        for solution in solutions.iter() {
            let one = arm.inverse_branch(target, given, solution.branch).unwrap();
            let one = one.map(|solution| evaluated(&solution)).map_err(bits::status);
            assert_eq!(one, generated(target, value, solution.branch), "inverse_branch, {case}");
        }
    }
    solutions.len()
}
