//! `denhart export c`: a program in C calls the library of an arm. The program prints the bits that Rust computes, for
//! every task and both scalars.
#![allow(clippy::unwrap_used)]

mod bits;
mod cases;
mod files;
mod link;
mod tools;

use denhart::{Arm, InverseKinematics, PlanarPose, PointAngle, PointAxis, Pose, Scalar};

use bits::shown;
use cases::{Task, cases};
use tools::{cc, export, library, prints, program};

macro_rules! exported {
    ($(
        $name:ident: $spec:literal $type:ident $scalar:literal $prefix:literal [$($definition:literal)*]
        $words:literal |$at:ident| $of:expr, |$w:ident, $g:ident| $target:expr, $given:expr, $extra:expr;
    )*) => {$(
        #[test]
        fn $name() {
            #[derive(Default, Arm)]
            #[arm(spec = $spec, scalar = $scalar)]
            struct Robot;
            let Some(mut cc) = cc() else { return };
            let task: Task<Robot, $type, _, { Robot::DOF }, $words> = Task {
                arm: Robot,
                words: |$at: &<Robot as InverseKinematics<$type, { Robot::DOF }>>::Target| $of,
                target: |$w, $g| $target,
                given: $given,
                extra: $extra,
            };
            let [input, expected] = cases(&task);
            let folder = export($spec, $scalar, stringify!($name));
            let library = library(&folder, $prefix, "release");
            let words = concat!("-DWORDS=", stringify!($words));
            let program = program(&mut cc, &folder, $prefix, &[words, $($definition),*], &library);
            prints(&program, &input, &expected);
        }
    )*};
}

/// No motors, no arm angle.
fn nothing<A, T, const N: usize>(_: &A, _: &[T; N]) -> String {
    String::new()
}

fn zero<A, T: Scalar, const N: usize>(_: &A, _: &[T; N]) -> T {
    T::ZERO
}

fn words<T: Scalar>(pose: Pose<T>) -> [T; 12] {
    let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
    let [x, y, z] = pose.translation;
    [a, b, c, d, e, f, g, h, i, x, y, z]
}

fn of_words<T: Scalar>([a, b, c, d, e, f, g, h, i, x, y, z]: [T; 12]) -> Pose<T> {
    Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }
}

macro_rules! motor {
    () => {
        |arm, q| {
            let motor = arm.to_motor(q);
            format!(" | 0{}{}", shown(&motor), shown(&arm.from_motor(&motor)))
        }
    };
}

macro_rules! pulses {
    () => {
        |arm, q| {
            let (pulses, ends) = arm.to_pulses_checked(q);
            let counts: String = pulses.iter().map(|count| format!(" {count}")).collect();
            let saturated: u16 = ends.iter().map(|joint| 1 << joint).sum();
            format!(" | 0{counts} {saturated}{}", shown(&arm.from_pulses(&pulses)))
        }
    };
}

exported! {
    pose_f64: "../specs/puma560.yaml" f64 "f64" "puma560" ["-DGIVEN="]
        12 |at| words(*at), |w, _given| of_words(w), zero, nothing;
    pose_f32_with_linked_motors: "../specs/fanuc_lrmate200id.yaml" f32 "f32" "fanuc_lrmate200id" ["-DGIVEN=" "-DHAS_MOTOR"]
        12 |at| words(*at), |w, _given| of_words(w), zero, motor!();
    pose_with_a_joint_given: "../specs/kuka_iiwa7_r800.yaml" f32 "f32" "kuka_iiwa7_r800" ["-DGIVEN=given,"]
        12 |at| words(at.0), |w, given| (of_words(w), given), |arm, q| InverseKinematics::target_at(arm, q).1, nothing;
    pose_with_a_list_given: "arms/given/iiwa_list_of_one.yaml" f64 "f64" "iiwa_list_of_one" ["-DGIVEN=(const real[]){given},"]
        12 |at| words(at.0), |w, given| (of_words(w), [given]), |arm, q| InverseKinematics::target_at(arm, q).1[0], nothing;
    pose_with_the_arm_angle_given: "tests/export_c/iiwa.yaml" f64 "f64" "arm_7_iiwa" ["-DGIVEN=given," "-DHAS_ARM_ANGLE"]
        12 |at| words(at.0), |w, given| (of_words(w), given), |arm, q| InverseKinematics::target_at(arm, q).1,
        |arm, q| format!(" | 0{}", shown(&[arm.arm_angle(q)]));
    position_f32_with_pulses: "../specs/salman_rrr.yaml" f32 "f32" "salman_rrr" ["-DGIVEN=" "-DHAS_PULSES"]
        3 |at| *at, |w, _given| w, zero, pulses!();
    position_axis: "arms/position_axis/scorbot_x.yaml" f64 "f64" "scorbot_x" ["-DGIVEN="]
        6 |at| {
            let PointAxis { point: [x, y, z], axis: [u, v, w] } = *at;
            [x, y, z, u, v, w]
        },
        |w, _given| PointAxis { point: [w[0], w[1], w[2]], axis: [w[3], w[4], w[5]] }, zero, nothing;
    position_angle: "../specs/jupiter.yaml" f32 "f32" "jupiter" ["-DGIVEN="]
        4 |at| {
            let PointAngle { point: [x, y, z], angle } = *at;
            [x, y, z, angle]
        },
        |w, _given| PointAngle { point: [w[0], w[1], w[2]], angle: w[3] }, zero, nothing;
    planar_pose_with_a_joint_given: "../specs/planar4r_redundant.yaml" f32 "f32" "planar4r_redundant" ["-DGIVEN=given,"]
        3 |at| [at.0.x, at.0.y, at.0.phi],
        |w, given| (PlanarPose { x: w[0], y: w[1], phi: w[2] }, given),
        |arm, q| InverseKinematics::target_at(arm, q).1, nothing;
    planar_position: "../specs/planar2r.yaml" f64 "f64" "planar2r" ["-DGIVEN="]
        2 |at| *at, |w, _given| w, zero, nothing;
}
