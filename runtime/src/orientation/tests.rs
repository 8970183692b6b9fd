//! Orientations on grids, beside singular ones, and there and back.

#![allow(clippy::unwrap_used)]

use super::*;
use crate::math::{self, Scalar};
use crate::pose::Pose;
use core::f64::consts::{FRAC_PI_2, PI};
use std::vec::Vec;

const DEGREE: f64 = PI / 180.0;

/// The deviations from a special angle that are tried, rad.
const BESIDE: [f64; 13] = [0.0, 1e-9, -1e-9, 1e-8, -1e-8, 1e-7, -1e-7, 1e-6, -1e-6, 1e-5, -1e-5, 1e-3, -1e-3];

/// A turn about one axis.
fn about(axis: char, angle: f64) -> Pose<f64> {
    Pose::from_xyz_rpy([0.0; 3], ['x', 'y', 'z'].map(|name| if name == axis { angle } else { 0.0 }))
}

fn rotate(turn: &Pose<f64>, vector: [f64; 3]) -> [f64; 3] {
    turn.transform_point(&vector)
}

/// Largest difference of two rotations, entry by entry.
fn apart<T: Scalar>(a: &Pose<T>, b: &Pose<T>) -> f64 {
    let pairs = a.rotation.iter().flatten().zip(b.rotation.iter().flatten());
    pairs.map(|(x, y)| (x.to_f64() - y.to_f64()).abs()).fold(0.0, f64::max)
}

/// Angles on grids of 15, 30, 45 and 90 degrees, all of them multiples of 15.
fn grid() -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    for a in (-180..=180).step_by(45) {
        for b in (-180..=180).step_by(15) {
            for c in (-180..=180).step_by(30) {
                all.push([a, b, c].map(|degrees| f64::from(degrees) * DEGREE));
            }
        }
    }
    all
}

#[test]
fn every_order_is_the_product_of_its_turns() {
    for order in EulerOrder::ALL {
        let name = std::format!("{order:?}").to_lowercase();
        for angles in [[0.3, -1.1, 2.5], [-2.0, 0.4, 0.9], [3.0, 1.5, -0.2]] {
            let turns = name.chars().zip(angles).map(|(axis, angle)| about(axis, angle));
            let product = turns.fold(Pose::identity(), |all, turn| all * turn);
            let pose = Pose::from_xyz_euler([1.0, 2.0, 3.0], order, angles);
            assert!(apart(&pose, &product) < 4e-16, "{order:?}");
            assert_eq!(pose.translation, [1.0, 2.0, 3.0]);
        }
    }
}

/// Three products of rounded sines and cosines, and the angles' own rounding (up to 2 ulp of pi each): some ten units.
const FEW: f64 = 10.0 * f64::EPSILON;

#[test]
fn angles_give_the_rotation_back_on_grids_and_beside_them() {
    for order in EulerOrder::ALL {
        for [a, b, c] in grid() {
            for beside in BESIDE {
                let pose = Pose::from_xyz_euler([0.0; 3], order, [a, b + beside, c]);
                let Euler { angles, singular } = pose.euler(order);
                let [first, middle, third] = angles;
                let back = Pose::from_xyz_euler([0.0; 3], order, angles);
                assert!(apart(&pose, &back) < FEW, "{order:?} {a} {b} {beside}: {angles:?}");
                // Where sine or cosine of the middle angle vanishes at beside = 0.
                let degrees = (b / DEGREE).round() as i32;
                let special = if order.is_proper() { degrees % 180 == 0 } else { (degrees + 90) % 180 == 0 };
                assert_eq!(singular, special && beside == 0.0, "{order:?} {a} {b} {beside}");
                assert!(!singular || third == 0.0);
                let range = if order.is_proper() { 0.0..=PI } else { -FRAC_PI_2..=FRAC_PI_2 };
                assert!(range.contains(&middle) && first.abs() <= PI && third.abs() <= PI, "{angles:?}");
            }
        }
    }
}

#[test]
fn ordinary_angles_come_back_themselves() {
    for order in EulerOrder::ALL {
        for beside in BESIDE {
            let middle = if order.is_proper() { 1.2 } else { -0.7 } + beside;
            let Euler { angles, singular } = Pose::from_xyz_euler([0.0; 3], order, [2.9, middle, -1.3]).euler(order);
            assert!(!singular);
            for (angle, expected) in angles.iter().zip([2.9, middle, -1.3]) {
                assert!((angle - expected).abs() < FEW, "{order:?} {angles:?}");
            }
        }
    }
}

#[test]
fn beside_a_singular_orientation_only_the_sum_is_sharp() {
    for beside in [1e-9, 1e-6, 1e-3] {
        let pose = Pose::from_xyz_rpy([0.0; 3], [0.4, FRAC_PI_2 - beside, -1.0]);
        let Euler { angles: [roll, pitch, yaw], singular } = pose.rpy();
        assert!(!singular && (pitch - (FRAC_PI_2 - beside)).abs() < FEW);
        assert!(((roll - yaw) - 1.4).abs() < FEW, "{beside}: {}", roll - yaw);
        assert!((roll - 0.4).abs() < FEW / beside, "{beside}: {roll}");
    }
    let at = Pose::from_xyz_rpy([0.0; 3], [0.4, FRAC_PI_2, -1.0]).rpy();
    let [roll, pitch, yaw] = at.angles;
    assert!(at.singular && roll == 0.0 && pitch == FRAC_PI_2 && (yaw + 1.4).abs() < FEW);
    let down = Pose::from_xyz_rpy([0.0; 3], [0.4, -FRAC_PI_2, -1.0]).rpy();
    let [roll, pitch, yaw] = down.angles;
    assert!(down.singular && roll == 0.0 && pitch == -FRAC_PI_2 && (yaw + 0.6).abs() < FEW);
}

#[test]
fn a_singular_orientation_after_several_turns_is_still_reported() {
    let before = Pose::from_xyz_rpy([0.0; 3], [0.7, -0.4, 2.0]);
    let up = Pose::from_xyz_rpy([0.0; 3], [0.4, FRAC_PI_2, -1.0]);
    let rounded = before.inverse() * (before * up);
    assert!(rounded.rpy().singular, "{:?}", rounded.rpy());
}

#[test]
fn quaternions_go_both_ways() {
    for [a, b, c] in grid() {
        for beside in BESIDE {
            let pose = Pose::from_xyz_rpy([0.0; 3], [a + beside, b, c]);
            let q = pose.quaternion();
            let length = q.iter().map(|part| part * part).sum::<f64>();
            let [w, ..] = q;
            assert!(w >= 0.0 && (length - 1.0).abs() < 4.0 * f64::EPSILON, "{q:?}");
            let back = Pose::from_xyz_quaternion([0.0; 3], q).unwrap();
            assert!(apart(&pose, &back) < FEW, "{q:?}");
            let negative = Pose::from_xyz_quaternion([0.0; 3], q.map(|part| -3.0 * part)).unwrap();
            assert!(apart(&pose, &negative) < FEW, "{q:?}");
        }
    }
    assert_eq!(Pose::<f64>::identity().quaternion(), [1.0, 0.0, 0.0, 0.0]);
    // Half a turn: the sign is settled by the first part that is not zero.
    for half in [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [0.0, -3.0, 4.0]] {
        let [x, y, z] = half;
        let [w, x, y, z] = Pose::from_xyz_quaternion([0.0; 3], [0.0, x, y, z]).unwrap().quaternion();
        let first = [x, y, z].into_iter().find(|part| *part != 0.0).unwrap();
        assert!(w == 0.0 && first > 0.0, "{half:?}");
    }
    assert_eq!(Pose::from_xyz_quaternion([0.0; 3], [0.0_f64; 4]), None);
    assert_eq!(Pose::from_xyz_quaternion([0.0; 3], [1.0, f64::NAN, 0.0, 0.0]), None);
    assert_eq!(Pose::from_xyz_quaternion([0.0; 3], [1.0, f64::INFINITY, 0.0, 0.0]), None);
    let tiny = Pose::from_xyz_quaternion([0.0; 3], [1e-300, 0.0, 0.0, 1e-300]).unwrap();
    assert!(apart(&tiny, &about('z', FRAC_PI_2)) < FEW);
    let worn = Pose { rotation: about('y', 2.0).rotation.map(|row| row.map(|x| x * 1.001)), translation: [0.0; 3] };
    assert!((worn.quaternion().iter().map(|part| part * part).sum::<f64>() - 1.0).abs() < 1e-15);
}

const ANGLES: [f64; 16] = [
    1e-300,
    1e-160,
    1e-30,
    1e-16,
    1e-9,
    1e-4,
    0.5,
    1.0,
    FRAC_PI_2,
    2.0,
    2.4,
    2.5,
    3.0,
    PI - 1e-3,
    PI - 1e-9,
    PI - 1e-14,
];

#[test]
fn rotation_vectors_go_both_ways_from_the_smallest_turn_to_half_a_turn() {
    for axis in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.6, 0.8], [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0]] {
        for angle in ANGLES {
            let vector = axis.map(|part: f64| part * angle);
            let pose = Pose::from_xyz_rotation_vector([0.0; 3], vector);
            for (part, expected) in pose.rotation_vector().iter().zip(vector) {
                assert!((part - expected).abs() <= 8.0 * f64::EPSILON * angle, "{axis:?} {angle}: {part} {expected}");
            }
            let AxisAngle { axis: found, angle: size } = pose.axis_angle();
            assert!((size - angle).abs() <= 8.0 * f64::EPSILON * angle && size <= PI);
            assert!(found.iter().zip(axis).all(|(a, b)| (a - b).abs() < FEW), "{angle} {axis:?} {found:?}");
            let again = Pose::from_xyz_axis_angle([0.0; 3], axis.map(|part| part * 1e200), angle).unwrap();
            assert!(apart(&again, &pose) < FEW);
        }
        let half = Pose::from_xyz_rotation_vector([0.0; 3], axis.map(|part| part * PI));
        let vector = half.rotation_vector();
        let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
        assert!((length - PI).abs() < FEW, "{vector:?}");
        assert!(apart(&Pose::from_xyz_rotation_vector([0.0; 3], vector), &half) < FEW);
    }
    assert_eq!(Pose::<f64>::identity().rotation_vector(), [0.0; 3]);
    let none = Pose::<f64>::identity().axis_angle();
    assert_eq!(none, AxisAngle { axis: [0.0, 0.0, 1.0], angle: 0.0 });
    let exactly_half = Pose { rotation: [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] };
    assert_eq!(exactly_half.rotation_vector(), [0.0, 0.0, PI]);
    assert_eq!(Pose::from_xyz_axis_angle([0.0; 3], [0.0; 3], 1.0), None);
    assert_eq!(Pose::from_xyz_axis_angle([0.0; 3], [1.0, 0.0, 0.0], f64::INFINITY), None);
    assert!(!Pose::from_xyz_rotation_vector([0.0; 3], [f64::NAN, 0.0, 0.0]).is_finite());
    let bad = Pose::from_xyz_rotation_vector([0.0; 3], [f64::NAN, 0.0, 0.0]);
    assert!(bad.rotation_vector().iter().all(|part| part.is_nan()));
    assert!(bad.axis_angle().angle.is_nan() && bad.rpy().angles.iter().all(|angle| angle.is_nan()));
    assert!(bad.quaternion().iter().all(|part| part.is_nan()));
}

#[test]
fn the_error_is_the_motion_in_the_base_frame() {
    let here = Pose::from_xyz_rpy([0.1, 0.2, 0.3], [0.7, -0.4, 2.0]);
    for axis in [[1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0]] {
        for angle in [0.0, 1e-16, 1e-12, 1e-6, 0.5, 2.0, 2.4, 2.5, 3.0, PI - 1e-9] {
            let vector = axis.map(|part: f64| part * angle);
            // In the base frame the turn stands on the left.
            let turn = Pose::from_xyz_rotation_vector([0.0; 3], vector);
            let mut there = turn * here;
            there.translation = [1.1, 0.0, 0.3];
            let [vx, vy, vz, wx, wy, wz] = here.error_to(&there);
            assert_eq!([vx, vy, vz], [1.0, -0.2, 0.0]);
            for (part, expected) in [wx, wy, wz].iter().zip(vector) {
                // The entries of the product are rounded by themselves, also where the turn is small.
                assert!((part - expected).abs() < 2e-15, "{angle}: {part} {expected}");
            }
            // It agrees with the residual, and as a vector on the axis it is the same seen from the body.
            assert!((here.residual(&there).orientation - angle).abs() < 2e-15);
            let body = (here.inverse() * there).rotation_vector();
            let seen = Pose { translation: [0.0; 3], ..here };
            assert!(rotate(&seen, body).iter().zip(vector).all(|(a, b)| (a - b).abs() < 2e-15), "{angle}");
        }
        let half = Pose::from_xyz_rotation_vector([0.0; 3], axis.map(|part| part * PI)) * here;
        let [.., wx, wy, wz] = here.error_to(&half);
        assert!(([wx, wy, wz].iter().map(|w| w * w).sum::<f64>().sqrt() - PI).abs() < 2e-15);
    }
    assert_eq!(here.error_to(&here), [0.0; 6]);
    assert_eq!(Pose::identity().error_to(&about('x', 1e-100)), [0.0, 0.0, 0.0, 1e-100, 0.0, 0.0]);
}

#[test]
fn single_precision_too() {
    let few = 10.0 * f64::from(f32::EPSILON);
    for [a, b, c] in grid() {
        let pose = Pose::<f32>::from_xyz_rpy([0.0; 3], [a as f32, b as f32, c as f32]);
        for order in EulerOrder::ALL {
            let back = Pose::from_xyz_euler([0.0; 3], order, pose.euler(order).angles);
            // Singular orientations that are one only up to rounding: 16 units.
            assert!(apart(&pose, &back) < 2.0 * few, "{order:?}");
        }
        let back = Pose::from_xyz_quaternion([0.0; 3], pose.quaternion()).unwrap();
        assert!(apart(&pose, &back) < few);
        let back = Pose::from_xyz_rotation_vector([0.0; 3], pose.rotation_vector());
        assert!(apart(&pose, &back) < few);
    }
    let (sin, _) = math::sin_cos(1e-20_f32);
    assert_eq!(Pose::from_xyz_rotation_vector([0.0; 3], [0.0, 0.0, sin]).rotation_vector(), [0.0, 0.0, 1e-20]);
}
