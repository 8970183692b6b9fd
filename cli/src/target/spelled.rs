//! Targets typed as numbers.

use denhart::{PlanarPose, PointAngle, PointAxis, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};
use denhart_tools::closest::pose_of;

use super::Target;
use crate::Failure;
use crate::hints;
use crate::number_arguments::NumberList;
use crate::numbers::{Units, count, short};

/// The numbers of a whole pose.
const WHOLE: &str = "x y z roll pitch yaw";
const QUATERNION: &str = "x y z qw qx qy qz";
const MATRIX: &str = "r11 r12 r13 x r21 r22 r23 y r31 r32 r33 z";

/// How far the length of a typed unit vector or unit quaternion may be from 1.
const NOT_UNIT: f64 = 1e-2;
/// How far a matrix may be from a rotation, as the inverse judges.
const NOT_A_ROTATION: f64 = 1e-3;

/// The numbers of a task, as `--pose` takes them.
fn numbers_of(task: &str) -> &'static str {
    match task {
        "position" => "x y z",
        "position_axis" => "x y z u v w",
        "position_angle" => "x y z angle",
        "planar_pose" => "x y phi",
        "planar_position" => "x y",
        _ => WHOLE,
    }
}

/// The target from the numbers of the arm's task. Six numbers are a whole pose for a task that has another count.
///
/// # Errors
/// Text that is no list of numbers; a count that does not fit; a direction that is no unit vector.
pub fn of_task(arm: &DynamicArm, option: &str, text: &str, units: Units) -> Result<Target, Failure> {
    let (task, length) = (arm.task()?, arm.length_unit());
    let wanted = numbers_of(task);
    let needed = wanted.split(' ').count();
    let list = NumberList { option, text, angle: units, length, wanted: &[needed, 6] };
    let values = &list.parse()?[..];
    match (task, values) {
        ("position", &[x, y, z]) => Ok(of(arm, DynamicTarget::Position([x, y, z]))),
        ("position_axis", &[x, y, z, u, v, w]) => position_axis(arm, [x, y, z], [u, v, w]).map_err(|found| {
            let whole = if option.is_empty() { "the columns x, y, z, roll, pitch, yaw" } else { "--whole-pose" };
            let help = format!(
                "the task `position_axis` reads \"{wanted}\", a point and a unit vector: write {}\"{wanted}\"; \
                 a pose is {whole} \"{WHOLE}\"",
                list.option_prefix()
            );
            list.failure(&found, &help)
        }),
        ("position_angle", &[x, y, z, angle]) => {
            Ok(of(arm, DynamicTarget::PositionAngle(PointAngle::new([x, y, z], units.rad(angle))))
                .with(hints::of_angles(option, &[angle], units)))
        }
        ("planar_pose", &[x, y, phi]) => Ok(of(arm, DynamicTarget::PlanarPose(PlanarPose::new(x, y, units.rad(phi))))
            .with(hints::of_angles(option, &[phi], units))),
        ("planar_position", &[x, y]) => Ok(of(arm, DynamicTarget::PlanarPosition([x, y]))),
        (_, &[x, y, z, roll, pitch, yaw]) => of_rpy(arm, option, [x, y, z], [roll, pitch, yaw], units),
        _ => {
            let found = count(values.len(), "number");
            let what = format!("{found}, but the task `{task}` needs {needed}: \"{wanted}\"");
            let whole = match task {
                "pose" => String::new(),
                // A line of a file has no options.
                "position_axis" if option.is_empty() => String::new(),
                "position_axis" => format!(", or --whole-pose \"{WHOLE}\""),
                _ => format!(", or a whole pose, \"{WHOLE}\""),
            };
            let angle = units.symbol();
            let help =
                format!("write {}\"{wanted}\"{whole}; lengths in {length}, angles in {angle}", list.option_prefix());
            Err(list.wrong_count(&what, &help))
        }
    }
}

/// The target of a whole pose, `x y z roll pitch yaw`.
///
/// # Errors
/// Text that is no list of six numbers; a pose that is no target of the arm.
pub fn whole(arm: &DynamicArm, option: &str, text: &str, units: Units) -> Result<Target, Failure> {
    let list = NumberList { option, text, angle: units, length: arm.length_unit(), wanted: &[6] };
    match list.parse()?[..] {
        [x, y, z, roll, pitch, yaw] => of_rpy(arm, option, [x, y, z], [roll, pitch, yaw], units),
        ref values => Err(wrong_count(&list, values, WHOLE, 6)),
    }
}

/// The target of a position and a quaternion.
///
/// # Errors
/// Text that is no list of seven numbers; a quaternion that is no unit quaternion.
pub fn quaternion(arm: &DynamicArm, text: &str, units: Units) -> Result<Target, Failure> {
    let list = NumberList { option: "--quat", text, angle: units, length: arm.length_unit(), wanted: &[7] };
    match list.parse()?[..] {
        [x, y, z, qw, qx, qy, qz] => {
            let pose = of_quaternion([x, y, z], [qw, qx, qy, qz]).map_err(|found| {
                let norm = length_of(&[qw, qx, qy, qz]);
                let unit = [qw, qx, qy, qz].map(|part| part / norm);
                let own = if norm > 0.0 { format!("; of length 1 it is {}", listed(&unit)) } else { String::new() };
                list.failure(
                    &found,
                    &format!("write --quat \"{QUATERNION}\", the scalar part qw before the others{own}"),
                )
            })?;
            Target::of_pose(arm, pose, units)
        }
        ref values => Err(wrong_count(&list, values, QUATERNION, 7)),
    }
}

/// The target of a matrix, row by row.
///
/// # Errors
/// Text that is no list of 12 or 16 numbers; a matrix that is no pose.
pub fn matrix(arm: &DynamicArm, text: &str, units: Units) -> Result<Target, Failure> {
    let bare = text.replace(['[', ']', '(', ')', '{', '}', ';'], " ");
    let list =
        NumberList { option: "--matrix", text: &bare, angle: units, length: arm.length_unit(), wanted: &[12, 16] };
    let values = list.parse()?;
    if !matches!(values.len(), 12 | 16) {
        let found = count(values.len(), "number");
        let help = format!("write 3 rows of 4, --matrix \"{MATRIX}\", or 4 rows of 4");
        return Err(list.wrong_count(&format!("{found}, but a matrix has 12 or 16"), &help));
    }
    let pose = of_matrix(&values).map_err(|found| {
        list.failure(&found, &format!("write --matrix \"{MATRIX}\": row by row, the position last"))
    })?;
    Target::of_pose(arm, pose, units)
}

fn wrong_count(list: &NumberList, values: &[f64], wanted: &str, needed: usize) -> Failure {
    let found = count(values.len(), "number");
    let (length, angle) = (list.length, list.angle.symbol());
    let help = format!("write {}\"{wanted}\"; lengths in {length}, angles in {angle}", list.option_prefix());
    list.wrong_count(&format!("{found}, but {needed} are needed: \"{wanted}\""), &help)
}

/// The target of a pose given by roll, pitch, yaw in the unit of angles.
pub fn of_rpy(arm: &DynamicArm, option: &str, xyz: [f64; 3], rpy: [f64; 3], units: Units) -> Result<Target, Failure> {
    let pose = Pose::from_xyz_rpy(xyz, rpy.map(|angle| units.rad(angle)));
    Ok(Target::of_pose(arm, pose, units)?.with(hints::of_angles(option, &rpy, units)))
}

/// The pose of a position and a quaternion, or the deviation of the quaternion from length 1.
pub fn of_quaternion(xyz: [f64; 3], quaternion: [f64; 4]) -> Result<Pose<f64>, String> {
    let norm = length_of(&quaternion);
    let pose = Pose::from_xyz_quaternion(xyz, quaternion).filter(|_| (norm - 1.0).abs() <= NOT_UNIT);
    pose.ok_or_else(|| format!("the quaternion {} has length {}, expected 1", listed(&quaternion), short(norm)))
}

/// The pose of 12 or 16 numbers, row by row, or the reason why they are none.
pub fn of_matrix(values: &[f64]) -> Result<Pose<f64>, String> {
    let (rows, last) = match *values {
        [a, b, c, x, d, e, f, y, g, h, i, z, ref last @ ..] => {
            (Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }, last)
        }
        _ => return Err(format!("{}, but a matrix has 12 or 16", count(values.len(), "number"))),
    };
    match *last {
        [] | [0.0, 0.0, 0.0, 1.0] => {}
        [_, _, _, 1.0] if rows.translation == [0.0; 3] => {
            return Err(format!("the last row is {}, expected 0, 0, 0, 1: this is column by column", listed(last)));
        }
        _ => return Err(format!("the last row is {}, expected 0, 0, 0, 1", listed(last))),
    }
    rotation(rows)
}

/// The pose, or the deviation of its matrix from a rotation.
pub fn rotation(pose: Pose<f64>) -> Result<Pose<f64>, String> {
    let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
    let columns = [[a, d, g], [b, e, h], [c, f, i]];
    // Half the Frobenius norm of R^T R - 1, which is the distance of the nearest rotation in first order.
    let mut squares = 0.0;
    for (index, u) in columns.iter().enumerate() {
        for (other, v) in columns.iter().enumerate() {
            let product: f64 = u.iter().zip(v).map(|(x, y)| x * y).sum();
            squares += (product - if index == other { 1.0 } else { 0.0 }).powi(2);
        }
    }
    let deviation = 0.5 * squares.sqrt();
    let determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    match deviation {
        off if off > NOT_A_ROTATION || off.is_nan() => {
            Err(format!("the 3 x 3 part is no rotation: it is off by {off:.2e}, expected at most {NOT_A_ROTATION:e}"))
        }
        _ if determinant < 0.0 => Err("the 3 x 3 part is mirrored: its determinant is -1, expected 1".to_owned()),
        _ => Ok(pose),
    }
}

/// A target with a whole pose that meets it.
pub fn of(arm: &DynamicArm, target: DynamicTarget) -> Target {
    let pose = pose_of(arm, &target);
    Target { target, pose, q: None, given: Vec::new(), hints: Vec::new() }
}

/// A point and a direction, or the length of an axis that is no unit vector.
pub fn position_axis(arm: &DynamicArm, point: [f64; 3], axis: [f64; 3]) -> Result<Target, String> {
    let norm = length_of(&axis);
    if (norm - 1.0).abs() > NOT_UNIT {
        return Err(format!("the axis {} has length {}, expected 1", listed(&axis), short(norm)));
    }
    Ok(of(arm, DynamicTarget::PositionAxis(PointAxis::new(point, axis))))
}

/// The Euclidean length, without overflow of the squares.
fn length_of(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |length: f64, value| length.hypot(*value))
}

/// Numbers with commas between them.
pub fn listed(values: &[f64]) -> String {
    values.iter().map(|value| short(*value)).collect::<Vec<_>>().join(", ")
}
