//! Bounds of a chain's length, m: a changed angle moves the tool by at most this, times the change.

use super::mimic_coupling::{MimicCoupling, Motor, joint_value};
use super::path::Path;
use super::rigid::length;
use super::table::Table;
use super::urdf::{Kind, Robot};

/// The sum of the joints' origins and strokes: the lever of an origin's angle. Origins that cancel at zero do so no
/// more once an angle between them is changed.
pub fn of_links(robot: &Robot, path: &Path, coupling: &MimicCoupling) -> f64 {
    let links = path.joints.iter().map(|passed| {
        let joint = passed.joint;
        let stroke = |end: fn(&Motor) -> f64| {
            let of = |name: &str| coupling.motors.iter().find(|motor| motor.name == name).map_or(0.0, end);
            joint_value(robot, joint, &of).abs()
        };
        let slides = joint.kind == Kind::Sliding;
        let most = if slides { stroke(|m| m.sampled_range()[0]).max(stroke(|m| m.sampled_range()[1])) } else { 0.0 };
        length(joint.xyz) + most
    });
    links.sum()
}

/// The sum of the rows' lengths and strokes, base and tool: the lever of an angle of the table.
pub fn of_table(table: &Table, coupling: &MimicCoupling) -> f64 {
    let rows: f64 = table.rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
    let farthest = |motor: &Motor| motor.sampled_range().iter().fold(0.0, |most: f64, end| most.max(end.abs()));
    let axes = coupling.axes.axes.iter().zip(&coupling.matrix).zip(&coupling.constant);
    let strokes = axes.filter(|((axis, _), _)| !axis.turns).map(|((_, row), constant)| {
        constant.abs()
            + row.iter().zip(&coupling.motors).map(|(factor, motor)| factor.abs() * farthest(motor)).sum::<f64>()
    });
    rows + strokes.sum::<f64>() + length(table.base.p) + length(table.tool.p)
}
