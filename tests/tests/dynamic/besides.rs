//! Motion, manipulability, pulses, walks over given values and lists that are kept: what generated code gives, to the bit.

use std::f64::consts::FRAC_PI_4;
use std::path::Path;

use denhart::{Arm, Flags, JointMask, Solutions, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};
use denhart_tests::arms::{Al5d, KukaIiwa7R800, Planar2r, SalmanRrr, ScaraRrrp325275, Ur5};
use denhart_tests::evaluated::bits;
use denhart_tests::random::Random;

use super::more::{LINKED, Linked, SWUNG, Swung};

/// Joint vectors of an arm.
const POSES: usize = 200;

#[derive(Default, Arm)]
#[arm(spec = "arms/given/iiwa_on_a_rail.yaml")]
struct OnARail;

// A wrist of two joints, and no motor that moves its own joint alone.
arm! { Pointing POINTING "
name: pointing
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x}
joints:
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0.35, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.05, alpha: 0, d: 0.1, theta: 0}
" }

fn file(path: &str) -> DynamicArm {
    DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

fn vector<const N: usize>(random: &mut Random, size: f64) -> [f64; N] {
    std::array::from_fn(|_| random.uniform(-size, size))
}

/// Joint values: at random, on a grid of 45 degrees, at zero, and one that is not finite.
fn joints<const N: usize>(random: &mut Random, round: usize) -> [f64; N] {
    let q: [f64; N] = vector(random, 3.1);
    match round % 8 {
        0..4 => q,
        4..6 => q.map(|q| (q / FRAC_PI_4).round() * FRAC_PI_4),
        6 => [0.0; N],
        _ => std::array::from_fn(
            |joint| {
                if joint == round % N { [f64::NAN, f64::INFINITY][round / 8 % 2] } else { q[joint] }
            },
        ),
    }
}

fn same_motion<A: Arm<f64, N>, const N: usize>(arm: &DynamicArm, generated: &A) {
    let mut random = Random::new(N as u64);
    for round in 0..POSES {
        let q: [f64; N] = joints(&mut random, round);
        let (qd, qdd): ([f64; N], [f64; N]) = (vector(&mut random, 2.0), vector(&mut random, 5.0));
        let at = format!("{} at {q:?}", arm.model().name);
        let velocity = arm.velocity(&q, &qd).unwrap().to_array();
        assert_eq!(bits::numbers(velocity), bits::numbers(generated.velocity(&q, &qd).to_array()), "velocity, {at}");
        let acceleration = arm.acceleration(&q, &qd, &qdd).unwrap().to_array();
        assert_eq!(
            bits::numbers(acceleration),
            bits::numbers(generated.acceleration(&q, &qd, &qdd).to_array()),
            "acceleration, {at}"
        );
        let expected = generated.jacobian_dot(&q, &qd).rows;
        assert_eq!(
            bits::rows(&arm.jacobian_dot(&q, &qd).unwrap()),
            bits::numbers(expected.into_iter().flatten()),
            "its rate, {at}"
        );
        let expected = generated.jacobian_tool(&q).rows;
        assert_eq!(
            bits::rows(&arm.jacobian_tool(&q).unwrap()),
            bits::numbers(expected.into_iter().flatten()),
            "in the tool, {at}"
        );
        let found = arm.link_velocities(&q, &qd).unwrap();
        let expected = generated.link_velocities(&q, &qd);
        assert_eq!(found.len(), N);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(bits::numbers(found.to_array()), bits::numbers(expected.to_array()), "link velocities, {at}");
        }
        let found = arm.link_accelerations(&q, &qd, &qdd).unwrap();
        let expected = generated.link_accelerations(&q, &qd, &qdd);
        assert_eq!(found.len(), N);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(bits::numbers(found.to_array()), bits::numbers(expected.to_array()), "link accelerations, {at}");
        }
        let manipulability = arm.manipulability(&q).unwrap();
        assert_eq!(
            bits::numbers([manipulability]),
            bits::numbers([generated.manipulability(&q)]),
            "manipulability, {at}"
        );
    }
    let wrong = Err(DynamicError::Joints { expected: N, found: N + 1 });
    let (q, long) = (vec![0.1; N], vec![0.1; N + 1]);
    assert_eq!(arm.velocity(&q, &long), wrong);
    assert_eq!(arm.acceleration(&q, &q, &long).map(|_| ()), wrong.clone().map(|_| ()));
    assert_eq!(arm.manipulability(&long).map(|_| ()), wrong.map(|_| ()));
}

#[test]
fn motion_and_manipulability_of_every_kind_of_task() {
    same_motion(&file("../specs/ur5.yaml"), &Ur5);
    same_motion(&file("../specs/kuka_iiwa7_r800.yaml"), &KukaIiwa7R800);
    same_motion(&file("../specs/scara_rrrp_325_275.yaml"), &ScaraRrrp325275);
    same_motion(&file("../specs/planar2r.yaml"), &Planar2r);
    same_motion(&file("../specs/salman_rrr.yaml"), &SalmanRrr);
    same_motion(&file("../specs/al5d.yaml"), &Al5d);
    same_motion(&file("arms/given/iiwa_on_a_rail.yaml"), &OnARail);
    same_motion(&DynamicArm::from_yaml(POINTING).unwrap(), &Pointing);
    same_motion(&DynamicArm::from_yaml(LINKED).unwrap(), &Linked);
    same_motion(&DynamicArm::from_yaml(SWUNG).unwrap(), &Swung);
}

macro_rules! same_pulses {
    ($arm:expr, $Type:ident, $n:literal, $size:literal) => {{
        let (arm, mut random) = ($arm, Random::new($n));
        let actuators = arm.actuators().unwrap();
        assert_eq!(actuators, $Type::ACTUATORS);
        for round in 0..POSES {
            let q: [f64; $n] = joints(&mut random, round).map(|q| q * $size);
            let (counts, saturated) = $Type.to_pulses_checked(&q);
            assert_eq!(arm.to_pulses(&q).unwrap(), (counts.to_vec(), saturated), "{q:?}");
            assert_eq!(
                bits::numbers(arm.from_pulses(&counts).unwrap().to_vec()),
                bits::numbers($Type.from_pulses(&counts)),
                "{q:?}"
            );
            let (found, expected) = (arm.quantized_error(&q).unwrap(), $Type.quantized_error(&q));
            assert_eq!((found.pulses, found.saturated), (expected.pulses.to_vec(), expected.saturated));
            assert_eq!(bits::numbers(found.q.to_vec()), bits::numbers(expected.q));
            assert_eq!(found.pose, expected.pose, "{q:?}");
            let residuals = [found.residual, expected.residual].map(|of| bits::numbers([of.position, of.orientation]));
            assert_eq!(residuals[0], residuals[1], "{q:?}");
        }
        assert_eq!(arm.from_pulses(&[0; $n + 1]), Err(DynamicError::Joints { expected: $n, found: $n + 1 }));
    }};
}

#[test]
fn pulses() {
    same_pulses!(file("../specs/salman_rrr.yaml"), SalmanRrr, 3, 1.0);
    same_pulses!(DynamicArm::from_yaml(LINKED).unwrap(), Linked, 4, 1.0);
    // Counts beyond their range.
    same_pulses!(DynamicArm::from_yaml(LINKED).unwrap(), Linked, 4, 1e8);
    let (_, saturated) = DynamicArm::from_yaml(LINKED).unwrap().to_pulses(&[0.0, 1e9, 0.0, f64::NAN]).unwrap();
    let mut both = JointMask::single(1);
    both.insert(JointMask::single(3));
    assert_eq!(saturated, both);
    let ur5 = file("../specs/ur5.yaml");
    assert_eq!(ur5.to_pulses(&[0.0; 6]), Err(DynamicError::NoActuators));
    assert_eq!(ur5.from_pulses(&[0; 6]), Err(DynamicError::NoActuators));
}

/// A dynamic list holds what a generated one holds.
fn same_list<const N: usize, const M: usize>(found: &DynamicSolutions, expected: &Solutions<f64, N, M>, case: &str) {
    assert_eq!(found.len(), expected.len(), "{case}");
    assert_eq!(found.status(), expected.status(), "{case}");
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(bits::numbers(found.q.to_vec()), bits::numbers(expected.q), "{case}");
        let is = (found.flags, found.free, found.branch);
        assert_eq!(is, (expected.flags, expected.free, expected.branch), "{case}");
    }
}

macro_rules! same_walk {
    ($arm:expr, $Type:ident, $q:expr, $steps:expr, $n:expr) => {{
        let arm = $arm;
        let pose = $Type.forward(&$q);
        let walked: Vec<_> = arm.sample_redundancy(&DynamicTarget::Pose(pose), &$n).unwrap().collect();
        let expected: Vec<_> = $Type.sample_redundancy(&pose, $steps).collect();
        assert_eq!(walked.len(), expected.len());
        let mut found = 0;
        for ((values, solutions), (given, expected)) in walked.iter().zip(&expected) {
            assert_eq!(bits::numbers(values.iter().copied()), bits::numbers(flat(*given)));
            same_list(solutions, expected, &format!("{values:?}"));
            found += solutions.len();
        }
        assert!(found > 0);
    }};
}

/// A given value, or the list of them.
trait Flat {
    fn flat(self) -> Vec<f64>;
}

impl Flat for f64 {
    fn flat(self) -> Vec<f64> {
        vec![self]
    }
}

impl<const K: usize> Flat for [f64; K] {
    fn flat(self) -> Vec<f64> {
        self.to_vec()
    }
}

fn flat(given: impl Flat) -> Vec<f64> {
    given.flat()
}

#[test]
fn walks_over_given_values() {
    let q = [0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1];
    same_walk!(file("../specs/kuka_iiwa7_r800.yaml"), KukaIiwa7R800, q, 24, [24]);
    same_walk!(DynamicArm::from_yaml(SWUNG).unwrap(), Swung, q, 24, [24]);
    let q = [350.0, 0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1];
    same_walk!(file("arms/given/iiwa_on_a_rail.yaml"), OnARail, q, [3, 8], [3, 8]);
    let on_a_rail = file("arms/given/iiwa_on_a_rail.yaml");
    let target = on_a_rail.target_at(&q).unwrap();
    assert_eq!(on_a_rail.sample_redundancy(&target, &[3, 0]).unwrap().count(), 0);
    let names = on_a_rail.given().unwrap();
    let refused = on_a_rail.sample_redundancy(&target, &[3]).map(|_| ());
    assert_eq!(refused, Err(DynamicError::Given { expected: names, found: 1 }));
    // Beside the target of an arm without a joint to spare nothing is given.
    let ur5 = file("../specs/ur5.yaml");
    let target = ur5.target_at(&[0.3; 6]).unwrap();
    let walked: Vec<_> = ur5.sample_redundancy(&target, &[]).unwrap().collect();
    assert_eq!(walked, [(Vec::new(), ur5.inverse(&target, &[]).unwrap())]);
}

#[test]
fn a_list_that_is_kept_is_overwritten() {
    let arm = file("../specs/ur5.yaml");
    let mut list = DynamicSolutions::default();
    assert!(list.is_empty() && list.status() == Status::BadTarget);
    let mut generated = Solutions::new(Status::BadTarget);
    let mut random = Random::new(17);
    for round in 0..POSES {
        let q: [f64; 6] = joints(&mut random, round);
        let pose = Ur5.forward(&q);
        let target = DynamicTarget::Pose(pose);
        arm.inverse_into(&target, &[], &mut list).unwrap();
        Ur5.inverse_into(&pose, &mut generated);
        same_list(&list, &generated, &format!("{q:?}"));
        let beside: [f64; 6] = std::array::from_fn(|joint| q[joint] + random.uniform(-0.2, 0.2));
        arm.inverse_near_into(&target, &beside, &mut list).unwrap();
        Ur5.inverse_near_into(&pose, &beside, &mut generated);
        same_list(&list, &generated, &format!("near {q:?}"));
        assert!(!q.iter().all(|q| q.is_finite()) || list.iter().any(|solution| solution.flags.contains(Flags::EXACT)));
    }
    // An error leaves the list as it is.
    arm.inverse_into(&arm.target_at(&[0.3; 6]).unwrap(), &[], &mut list).unwrap();
    let before = list.clone();
    assert!(arm.inverse_into(&DynamicTarget::Position([0.0; 3]), &[], &mut list).is_err());
    assert_eq!(list, before);
}
