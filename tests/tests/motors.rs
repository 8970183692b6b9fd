//! Links between joints and motors: linked joints, limits of sums, and pulses.

use denhart::{Arm, Flags, InverseKinematics, Jacobian, JointMask, Pose};
use denhart_tests::random::Random;
use denhart_tests::subject::{Specified, largest};
use serde_json::Value;

/// The Fanuc arm with limits of two sums. The joint limits are one-sided, so that the sums decide often.
#[derive(Debug, Clone, Copy, Default, Arm)]
#[arm(yaml = "
        name: linked
        convention: modified
        units: {length: mm, angle: deg}
        joints:
          - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
          - {type: revolute, a: 50, alpha: -90, d: 0, theta: -90, limits: [-100, null]}
          - {type: revolute, a: 330, alpha: 0, d: 0, theta: 0}
          - {type: revolute, a: 35, alpha: -90, d: 335, theta: 0}
          - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
          - {type: revolute, a: 0, alpha: -90, d: 80, theta: 0}
        combined_limits:
          - {sum: {q2: 1, q3: 1}, limits: [-120, 90]}
          - {sum: {q4: 1, q6: -0.5}, limits: [null, 200]}
    ")]
struct Summed;

/// A sliding motor that a turning joint moves, offsets, actuators of all kinds.
#[derive(Debug, Clone, Copy, Default, Arm)]
#[arm(yaml = "
        name: scara
        convention: standard
        units: {length: mm, angle: deg}
        joints:
          - {a: 325, alpha: 0, d: 400, theta: 0, actuator: {pulses_per_rev: 131072, gear_ratio: 80, home: 30}}
          - {a: 275, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_rev: 10000, direction: -1}}
          - {a: 0, alpha: 180, d: 0, theta: 0, actuator: {pulses_per_rev: 4000}}
          - {name: z, type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, actuator: {pulses_per_unit: 250, home: 10}}
        coupling:
          q2: {q1: 1, q2: 3, offset: -90}
          z: {z: 2, q3: 20 per rev, offset: 5}
    ")]
struct Scara;

#[derive(Debug, Clone, Copy, Default, Arm)]
#[arm(spec = "../specs/fanuc_lrmate200id.yaml")]
struct FanucLrmate200id;

#[derive(Debug, Clone, Copy, Default, Arm)]
#[arm(spec = "../specs/salman_rrr.yaml")]
struct SalmanRrr;

#[derive(Debug, Clone, Copy, Default, Arm)]
#[arm(spec = "../specs/salman_rrr.yaml", scalar = "f32")]
struct SalmanSingle;

fn degrees<const N: usize>(q: [f64; N]) -> [f64; N] {
    q.map(f64::to_radians)
}

fn close<const N: usize>(found: [f64; N], expected: [f64; N], tolerance: f64) {
    let error = largest(found.iter().zip(&expected).map(|(a, b)| a - b));
    assert!(error <= tolerance, "{error:e}: {found:?} is not {expected:?}");
}

fn random<const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|_| random.uniform(-3.0, 3.0))
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|index| value[index].as_f64().expect("a number"))
}

fn published(table: &str) -> Vec<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/published_tables.json");
    let text = std::fs::read_to_string(path).expect("the tables can be read");
    let tables: Value = serde_json::from_str(&text).expect("the tables are JSON");
    tables[table].as_array().expect("the table is a list").clone()
}

/// Tables 4 and 5 of Salman, Hamzah and Bakhy: counts, joint angles after rounding, and where the tool then is.
#[test]
fn the_published_pulses_come_out() {
    for table in ["salman_rrr_forward_pulses", "salman_rrr_inverse"] {
        for row in published(table) {
            let q = degrees(numbers::<3>(&row["q_deg"]));
            let pulses: [i32; 3] = SalmanRrr.to_pulses(&q);
            assert_eq!(pulses.map(f64::from), numbers(&row["pulses_from_home"]), "{row}");
            // The table has 64-bit degrees.
            close(SalmanRrr.from_pulses(&pulses), degrees(numbers(&row["q_actual_deg"])), 1e-14);
            let end = SalmanRrr.quantized_error(&q);
            assert_eq!((end.pulses, end.saturated), (pulses, JointMask::NONE));
            if row["theoretical"].is_array() {
                let [wanted, reached] = ["theoretical", "actual"].map(|key| numbers::<3>(&row[key]));
                close(SalmanRrr.forward(&q).translation, wanted, 1e-10);
                close(end.pose.translation, reached, 1e-10);
                let missed = wanted.iter().zip(&reached).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
                assert!((end.residual.position - missed).abs() < 1e-10, "{}", end.residual);
            }
        }
    }
    // Case 2 of Table 4 as it is printed, to four decimals.
    let end = SalmanRrr.quantized_error(&degrees([-30.0, 5.0, -5.0]));
    assert_eq!(end.pulses, [-1067, -10144, 5667]);
    close(end.pose.translation, [398.3570, -218.5304, 187.1793], 5e-5);
    close(SalmanRrr.forward(&degrees([-30.0, 5.0, -5.0])).translation, [398.3923, -218.4649, 187.1697], 5e-5);
}

#[test]
fn a_pulse_is_what_its_count_says() {
    close(SalmanRrr::RESOLUTION, degrees([360.0 / 12800.0, 360.0 / 42962.0, 360.0 / 24000.0]), 1e-18);
    // The joint stays within half a pulse of where it was asked to be.
    let mut random = Random::named("pulses");
    for _ in 0..1000 {
        let q = self::random::<3>(&mut random);
        let end = SalmanRrr.quantized_error(&q);
        for joint in 0..3 {
            let off = (end.q[joint] - q[joint]).abs();
            assert!(off <= 0.5 * SalmanRrr::RESOLUTION[joint] + 1e-15, "joint {joint} of {q:?} is {off:e} off");
        }
        assert_eq!(SalmanRrr.to_pulses(&end.q), end.pulses);
    }
}

#[test]
fn counts_out_of_range_are_told() {
    let (pulses, saturated) = SalmanRrr.to_pulses_checked(&[f64::NAN, 1e9, f64::NEG_INFINITY]);
    assert_eq!(pulses, [0, i32::MAX, i32::MIN]);
    assert_eq!(saturated.iter().collect::<Vec<_>>(), [0, 1, 2]);
    let end = SalmanRrr.quantized_error(&[0.0, f64::NAN, 0.0]);
    assert!(end.saturated == JointMask::single(1) && end.residual.position.is_nan() && end.pose.is_finite());
    assert_eq!(SalmanRrr.to_pulses_checked(&degrees([0.0, 90.0, -90.0])), ([0; 3], JointMask::NONE));
}

#[test]
fn single_precision_counts_alike() {
    let q = degrees([-30.0, 5.0, -5.0]).map(|q| q as f32);
    assert_eq!(SalmanSingle.to_pulses(&q), [-1067, -10144, 5667]);
    let end = SalmanSingle.quantized_error(&q);
    // Rounding of f32 in a reach of 645 mm.
    close(end.pose.translation.map(f64::from), [398.3570, -218.5304, 187.1793], 2e-4);
    assert_eq!(SalmanSingle.from_pulses(&[0; 3])[1], std::f32::consts::FRAC_PI_2);
}

/// The way there and back, and the Jacobian of motor rates beside differences of the tool's pose along each motor.
fn check_motors<A: Specified<N>, const N: usize>(
    to_motor: impl Fn(&[f64; N]) -> [f64; N],
    from_motor: impl Fn(&[f64; N]) -> [f64; N],
    motor_jacobian: impl Fn(&[f64; N]) -> Jacobian<f64, N>,
    reach: f64,
) {
    let mut random = Random::named(A::NAME);
    let arm = A::default();
    for _ in 0..200 {
        let q = self::random::<N>(&mut random);
        let motor = to_motor(&q);
        close(from_motor(&motor), q, 1e-13);
        let jacobian = motor_jacobian(&q);
        for index in 0..N {
            let step = 1e-5;
            let [back, ahead] = [-step, step].map(|by| {
                let mut moved = motor;
                moved[index] += by;
                arm.forward(&from_motor(&moved))
            });
            let found: [f64; 6] = std::array::from_fn(|row| jacobian.rows[row][index]);
            let unit = |row: usize| if row < 3 { reach } else { 1.0 };
            let expected = twist(&back, &ahead).map(|moved| moved / (2.0 * step));
            // Third derivatives of a sine of at most 1 / A^-1 a step, and rounding over the step.
            let error = largest((0..6).map(|row| (found[row] - expected[row]) / unit(row)));
            assert!(error < 1e-9, "motor {index} at {q:?}: {error:e}\n{found:?}\n{expected:?}");
        }
    }
}

/// Displacement and small rotation from one pose to the next.
fn twist(from: &Pose<f64>, to: &Pose<f64>) -> [f64; 6] {
    let [x, y, z] = std::array::from_fn(|i| to.translation[i] - from.translation[i]);
    // Skew part of (R2 - R1) (R1 + R2)^T / 2, which is w x in the base frame, exact to third order.
    let skew = |i: usize, j: usize| -> f64 {
        (0..3)
            .map(|k| (to.rotation[i][k] - from.rotation[i][k]) * 0.5 * (to.rotation[j][k] + from.rotation[j][k]))
            .sum()
    };
    let half = |i: usize, j: usize| 0.5 * (skew(i, j) - skew(j, i));
    [x, y, z, half(2, 1), half(0, 2), half(1, 0)]
}

impl Specified<6> for FanucLrmate200id {
    const NAME: &'static str = "fanuc_lrmate200id";
    const TABLE: denhart::DhTable = FanucLrmate200id::DH;
}

impl Specified<4> for Scara {
    const NAME: &'static str = "scara";
    const TABLE: denhart::DhTable = Scara::DH;
}

#[test]
fn motors_and_joints_agree() {
    let fanuc = FanucLrmate200id;
    check_motors::<FanucLrmate200id, 6>(
        |q| fanuc.to_motor(q),
        |motor| fanuc.from_motor(motor),
        |q| fanuc.motor_jacobian(q),
        830.0,
    );
    check_motors::<Scara, 4>(
        |q| Scara.to_motor(q),
        |motor| Scara.from_motor(motor),
        |q| Scara.motor_jacobian(q),
        1000.0,
    );
    let per_rad = 20.0 / std::f64::consts::TAU;
    let motor = Scara.to_motor(&[0.5, 0.25, 0.125, 8.0]);
    close(motor, [0.5, 1.25 - std::f64::consts::FRAC_PI_2, 0.125, 21.0 + 0.125 * per_rad], 1e-14);
}

/// Fanuc's linkage: J1 to J6 as the teach pendant shows them. Its J3 is the forearm's angle to the horizon, so with J2
/// alone the forearm is carried along without turning.
#[test]
fn the_forearm_of_the_fanuc_keeps_its_angle() {
    let arm = FanucLrmate200id;
    assert_eq!(arm.to_motor(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]), [1.0, 2.0, -5.0, -4.0, -5.0, -6.0]);
    let forearm = |j2: f64, j3: f64| arm.link_poses(&arm.from_motor(&degrees([0.0, j2, j3, 0.0, 0.0, 0.0])))[3];
    for j3 in [-40.0_f64, 0.0, 35.0] {
        let along = |pose: &Pose<f64>| pose.rotation.map(|row| row[2]);
        for j2 in [-30.0, 0.0, 60.0] {
            let expected = [j3.to_radians().cos(), 0.0, j3.to_radians().sin()];
            close(along(&forearm(j2, j3)), expected, 1e-15);
        }
    }
    // J2 forward is positive and moves the elbow ahead and down; J3 up is positive.
    let elbow = |j2: f64| arm.link_poses(&arm.from_motor(&degrees([0.0, j2, 0.0, 0.0, 0.0, 0.0])))[2].translation;
    assert!(elbow(20.0)[0] > elbow(0.0)[0] && elbow(20.0)[2] < elbow(0.0)[2]);
    // The linkage in the motor's rates: with J2 alone the tool moves and does not turn.
    let jacobian = arm.motor_jacobian(&degrees([10.0, 20.0, 30.0, 40.0, 50.0, 60.0]));
    assert!((3..6).all(|row| jacobian.rows[row][1].abs() < 1e-15), "{jacobian}");
}

/// The flag is that of the joint limits and the sums together, for the joint values as returned.
#[test]
fn sums_out_of_limits_are_flagged() {
    let mut random = Random::named("sums");
    let (mut inside, mut by_sum) = (0, 0);
    for _ in 0..500 {
        let q = self::random::<6>(&mut random);
        let target = Summed.forward(&q);
        let wound = std::array::from_fn(|joint| q[joint] + if joint == 2 { std::f64::consts::TAU } else { 0.0 });
        for solutions in [Summed.inverse(&target), Summed.inverse_near(&target, &wound)] {
            assert!(solutions.status().is_reachable());
            for solution in &solutions {
                let [_, q2, q3, q4, _, q6] = solution.q;
                let joint = q2 >= (-100.0_f64).to_radians();
                let sum = (q2 + q3).to_degrees();
                let sums = (-120.0..=90.0).contains(&sum) && (q4 - 0.5 * q6).to_degrees() <= 200.0;
                assert_eq!(solution.flags.contains(Flags::OUT_OF_LIMITS), !(joint && sums), "{solution}");
                assert_eq!(Summed::COMBINED_LIMITS.iter().all(|limit| limit.holds(&solution.q)), sums);
                inside += usize::from(joint && sums);
                by_sum += usize::from(joint && !sums);
            }
            let listed = solutions.within_limits().count();
            assert_eq!(listed, solutions.iter().filter(|solution| solution.is_within_limits()).count());
        }
    }
    assert!(inside > 500 && by_sum > 500, "{inside} inside, {by_sum} outside by a sum alone");
    let one = |q: [f64; 6]| Summed::COMBINED_LIMITS[0].sum(&q);
    assert_eq!(one([9.0, 1.0, 2.0, 9.0, 9.0, 9.0]), 3.0);
    fn solvable<A: InverseKinematics<f64, 6>>() {}
    solvable::<Summed>();
}

/// Pulses count what the motors turn.
#[test]
fn pulses_of_linked_joints() {
    let q = [0.4, -0.3, 1.7, 33.0];
    let motor = Scara.to_motor(&q);
    let turns = |angle: f64| angle / std::f64::consts::TAU;
    let expected = [
        (131_072.0 * 80.0 * turns(motor[0] - 30.0_f64.to_radians())).round(),
        (-10_000.0 * turns(motor[1])).round(),
        (4000.0 * turns(motor[2])).round(),
        (250.0 * (motor[3] - 10.0)).round(),
    ];
    let pulses = Scara.to_pulses(&q);
    assert_eq!(pulses.map(f64::from), expected);
    let back = Scara.to_motor(&Scara.from_pulses(&pulses));
    for (index, resolution) in Scara::RESOLUTION.iter().enumerate() {
        assert!((back[index] - motor[index]).abs() <= 0.5 * resolution + 1e-13, "motor {index}");
    }
    assert_eq!(Scara.to_pulses(&Scara.from_pulses(&pulses)), pulses);
}

/// A solution that is turned next to a reference is beyond the limits where `inverse_near` says so: of sums too.
#[test]
fn a_turned_solution_keeps_the_limits_of_sums() {
    let mut random = Random::named("turned");
    let (mut inside, mut beyond) = (0, 0);
    for _ in 0..200 {
        let [q, near]: [[f64; 6]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| random.uniform(-2.0, 2.0)));
        let target = Summed.forward(&q);
        for solution in &Summed.inverse_near(&target, &near) {
            let turned = solution.next_to(&Summed, &near);
            assert_eq!(turned.flags, solution.flags, "{q:?} {near:?}");
            assert!(turned.q.iter().zip(solution.q).all(|(a, b)| (a - b).abs() < 1e-14), "{q:?} {near:?}");
            let each = turned.q.iter().zip(Summed.limits()).all(|(q, [low, high])| low <= *q && *q <= high);
            beyond += usize::from(each && !turned.is_within_limits());
            inside += usize::from(turned.is_within_limits());
        }
    }
    assert!(inside > 200 && beyond > 200, "{inside} {beyond}");
}
