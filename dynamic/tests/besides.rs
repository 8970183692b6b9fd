//! Motion, manipulability, pulses, walks over given values and lists that are kept: what generated code gives, to the bit.
#![allow(clippy::unwrap_used)]

use std::f64::consts::FRAC_PI_4;
use std::path::Path;

use denhart::{Arm, Flags, JointMask, Solutions, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicJacobian, DynamicSolutions, DynamicTarget};

/// Joint vectors of an arm.
const POSES: usize = 200;

#[derive(Default, Arm)]
#[arm(spec = "../specs/ur5.yaml")]
struct Ur5;

#[derive(Default, Arm)]
#[arm(spec = "../specs/kuka_iiwa7_r800.yaml")]
struct Iiwa;

#[derive(Default, Arm)]
#[arm(spec = "../specs/scara_rrrp_325_275.yaml")]
struct Scara;

#[derive(Default, Arm)]
#[arm(spec = "../specs/planar2r.yaml")]
struct Planar;

#[derive(Default, Arm)]
#[arm(spec = "../specs/salman_rrr.yaml")]
struct Salman;

#[derive(Default, Arm)]
#[arm(spec = "../specs/al5d.yaml")]
struct Al5d;

#[derive(Default, Arm)]
#[arm(spec = "../tests/arms/given/iiwa_on_a_rail.yaml")]
struct OnARail;

macro_rules! of_text {
    ($Type:ident $text:ident $yaml:literal) => {
        #[derive(Default, Arm)]
        #[arm(yaml = $yaml)]
        struct $Type;

        const $text: &str = $yaml;
    };
}

// A wrist of two joints, and no motor that moves its own joint alone.
of_text! { Pointing POINTING "
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

of_text! { Linked LINKED "
name: linked
convention: standard
units: {length: mm, angle: deg}
joints:
  - {a: 325, alpha: 0, d: 400, theta: 0, limits: [-100, 90], actuator: {pulses_per_rev: 4000, gear_ratio: 20, home: 15}}
  - {a: 275, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_rev: 6400, direction: -1}}
  - {a: 0, alpha: 180, d: 0, theta: 0, actuator: {pulses_per_rev: 3200, home: -30}}
  - {name: z, type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 200], actuator: {pulses_per_unit: 80}}
coupling:
  q2: {q1: 1, q2: 3, offset: -90}
  z: {z: 2, q3: 20 per rev, offset: 5}
" }

of_text! { Swung SWUNG "
name: swung
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: arm_angle, require: true}
joints:
  - {a: 0, alpha: 0, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
" }

fn file(path: &str) -> DynamicArm {
    DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

/// Every value that is not a number is the same.
fn bits(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
    values.into_iter().map(|value| if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }).collect()
}

fn rows(jacobian: &DynamicJacobian) -> Vec<u64> {
    bits(jacobian.iter().flat_map(|row| row.to_vec()))
}

/// Numbers in -1 to 1 (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        2.0 * ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
    }

    fn vector<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| size * self.next())
    }

    /// Joint values: at random, on a grid of 45 degrees, at zero, and one that is not finite.
    fn joints<const N: usize>(&mut self, round: usize) -> [f64; N] {
        let q: [f64; N] = self.vector(3.1);
        match round % 8 {
            0..4 => q,
            4..6 => q.map(|q| (q / FRAC_PI_4).round() * FRAC_PI_4),
            6 => [0.0; N],
            _ => std::array::from_fn(|joint| {
                if joint == round % N { [f64::NAN, f64::INFINITY][round / 8 % 2] } else { q[joint] }
            }),
        }
    }
}

fn same_motion<A: Arm<f64, N>, const N: usize>(arm: &DynamicArm, generated: &A) {
    let mut random = Random(N as u64);
    for round in 0..POSES {
        let q: [f64; N] = random.joints(round);
        let (qd, qdd): ([f64; N], [f64; N]) = (random.vector(2.0), random.vector(5.0));
        let at = format!("{} at {q:?}", arm.model().name);
        let velocity = arm.velocity(&q, &qd).unwrap().to_array();
        assert_eq!(bits(velocity), bits(generated.velocity(&q, &qd).to_array()), "velocity, {at}");
        let acceleration = arm.acceleration(&q, &qd, &qdd).unwrap().to_array();
        assert_eq!(bits(acceleration), bits(generated.acceleration(&q, &qd, &qdd).to_array()), "acceleration, {at}");
        let expected = generated.jacobian_dot(&q, &qd).rows;
        assert_eq!(rows(&arm.jacobian_dot(&q, &qd).unwrap()), bits(expected.into_iter().flatten()), "its rate, {at}");
        let expected = generated.jacobian_tool(&q).rows;
        assert_eq!(rows(&arm.jacobian_tool(&q).unwrap()), bits(expected.into_iter().flatten()), "in the tool, {at}");
        let found = arm.link_velocities(&q, &qd).unwrap();
        let expected = generated.link_velocities(&q, &qd);
        assert_eq!(found.len(), N);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(bits(found.to_array()), bits(expected.to_array()), "link velocities, {at}");
        }
        let found = arm.link_accelerations(&q, &qd, &qdd).unwrap();
        let expected = generated.link_accelerations(&q, &qd, &qdd);
        assert_eq!(found.len(), N);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(bits(found.to_array()), bits(expected.to_array()), "link accelerations, {at}");
        }
        let manipulability = arm.manipulability(&q).unwrap();
        assert_eq!(bits([manipulability]), bits([generated.manipulability(&q)]), "manipulability, {at}");
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
    same_motion(&file("../specs/kuka_iiwa7_r800.yaml"), &Iiwa);
    same_motion(&file("../specs/scara_rrrp_325_275.yaml"), &Scara);
    same_motion(&file("../specs/planar2r.yaml"), &Planar);
    same_motion(&file("../specs/salman_rrr.yaml"), &Salman);
    same_motion(&file("../specs/al5d.yaml"), &Al5d);
    same_motion(&file("../tests/arms/given/iiwa_on_a_rail.yaml"), &OnARail);
    same_motion(&DynamicArm::from_yaml(POINTING).unwrap(), &Pointing);
    same_motion(&DynamicArm::from_yaml(LINKED).unwrap(), &Linked);
    same_motion(&DynamicArm::from_yaml(SWUNG).unwrap(), &Swung);
}

macro_rules! same_pulses {
    ($arm:expr, $Type:ident, $n:literal, $size:literal) => {{
        let (arm, mut random) = ($arm, Random($n));
        let actuators = arm.actuators().unwrap();
        assert_eq!(actuators, $Type::ACTUATORS);
        for round in 0..POSES {
            let q: [f64; $n] = random.joints(round).map(|q| q * $size);
            let (counts, saturated) = $Type.to_pulses_checked(&q);
            assert_eq!(arm.to_pulses(&q).unwrap(), (counts.to_vec(), saturated), "{q:?}");
            assert_eq!(bits(arm.from_pulses(&counts).unwrap().to_vec()), bits($Type.from_pulses(&counts)), "{q:?}");
            let (found, expected) = (arm.quantized_error(&q).unwrap(), $Type.quantized_error(&q));
            assert_eq!((found.pulses, found.saturated), (expected.pulses.to_vec(), expected.saturated));
            assert_eq!(bits(found.q.to_vec()), bits(expected.q));
            assert_eq!(found.pose, expected.pose, "{q:?}");
            let residuals = [found.residual, expected.residual].map(|of| bits([of.position, of.orientation]));
            assert_eq!(residuals[0], residuals[1], "{q:?}");
        }
        assert_eq!(arm.from_pulses(&[0; $n + 1]), Err(DynamicError::Joints { expected: $n, found: $n + 1 }));
    }};
}

#[test]
fn pulses() {
    same_pulses!(file("../specs/salman_rrr.yaml"), Salman, 3, 1.0);
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
        assert_eq!(bits(found.q.to_vec()), bits(expected.q), "{case}");
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
            assert_eq!(bits(values.iter().copied()), bits(flat(*given)));
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
    same_walk!(file("../specs/kuka_iiwa7_r800.yaml"), Iiwa, q, 24, [24]);
    same_walk!(DynamicArm::from_yaml(SWUNG).unwrap(), Swung, q, 24, [24]);
    let q = [350.0, 0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1];
    same_walk!(file("../tests/arms/given/iiwa_on_a_rail.yaml"), OnARail, q, [3, 8], [3, 8]);
    let on_a_rail = file("../tests/arms/given/iiwa_on_a_rail.yaml");
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
    let mut random = Random(17);
    for round in 0..POSES {
        let q: [f64; 6] = random.joints(round);
        let pose = Ur5.forward(&q);
        let target = DynamicTarget::Pose(pose);
        arm.inverse_into(&target, &[], &mut list).unwrap();
        Ur5.inverse_into(&pose, &mut generated);
        same_list(&list, &generated, &format!("{q:?}"));
        let beside: [f64; 6] = std::array::from_fn(|joint| q[joint] + 0.2 * random.next());
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
