//! The poses of a URDF and of an arm file, computed a second time. The reader of URDF and the product of rows share
//! nothing with the command's.

use std::collections::HashMap;
use std::fs;

use denhart_codegen::model::{self, Model, RowKind};
use denhart_codegen::spec;
use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};

use crate::urdf;

/// A joint of a URDF as the text has it.
pub struct Joint {
    name: String,
    kind: String,
    parent: String,
    child: String,
    origin: Isometry3<f64>,
    axis: Vector3<f64>,
}

/// The value of `key="..."` after `from` in the text.
fn attribute<'t>(text: &'t str, tag: &str, key: &str) -> Option<&'t str> {
    let element = text.split(&format!("<{tag} ")).nth(1)?.split("/>").next()?;
    element.split(&format!("{key}=\"")).nth(1)?.split('"').next()
}

fn vector(text: &str) -> Vector3<f64> {
    Vector3::from_iterator(text.split_whitespace().map(|x| x.parse::<f64>().unwrap()))
}

pub fn joints(name: &str) -> Vec<Joint> {
    let text = fs::read_to_string(urdf(name)).unwrap();
    let body = |part: &str| part.split("</joint>").next().unwrap().to_owned();
    text.split("<joint ")
        .skip(1)
        .filter(|part| part.contains("</joint>"))
        .map(|part| {
            let joint = body(part);
            let head = format!("<joint {joint}");
            let get = |tag, key| attribute(&head, tag, key).unwrap_or_default().to_owned();
            let [roll, pitch, yaw] = *vector(&get("origin", "rpy")).as_ref();
            let rotation = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
            let axis = attribute(&head, "axis", "xyz").map_or(Vector3::x(), vector);
            Joint {
                name: joint.split('"').nth(1).unwrap().to_owned(),
                kind: joint.split("type=\"").nth(1).unwrap().split('"').next().unwrap().to_owned(),
                parent: get("parent", "link"),
                child: get("child", "link"),
                origin: Isometry3::from_parts(Translation3::from(vector(&get("origin", "xyz"))), rotation),
                axis,
            }
        })
        .collect()
}

/// Pose of `tool` in `base`, an ancestor, at the values of the joints.
pub fn urdf_pose(joints: &[Joint], base: &str, tool: &str, values: &HashMap<String, f64>) -> Isometry3<f64> {
    let mut pose = Isometry3::identity();
    let mut link = tool.to_owned();
    while link != base {
        let joint = joints.iter().find(|joint| joint.child == link).unwrap();
        let value = values.get(&joint.name).copied().unwrap_or(0.0);
        let axis = Unit::new_normalize(joint.axis);
        let motion = match joint.kind.as_str() {
            "fixed" => Isometry3::identity(),
            "prismatic" => Isometry3::from_parts(Translation3::from(axis.scale(value)), UnitQuaternion::identity()),
            _ => Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from_axis_angle(&axis, value)),
        };
        pose = joint.origin * motion * pose;
        link = joint.parent.clone();
    }
    pose
}

pub fn model(text: &str) -> Model {
    let (spec, warnings) = spec::read(text, "imported.yaml").unwrap();
    drop(warnings);
    model::check(&spec).unwrap()
}

/// `base rows tool`, standard convention, at the joint values.
pub fn table_pose(model: &Model, q: &[f64]) -> Isometry3<f64> {
    let about =
        |axis, angle| Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from_axis_angle(&axis, angle));
    let shift = |x, z| Isometry3::translation(x, 0.0, z);
    let frame = |frame: &model::Frame| {
        let [x, y, z] = frame.xyz.each_ref().map(|length| length.default_value());
        let [roll, pitch, yaw] = frame.rpy.map(|angle| angle.rad());
        Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
    };
    let mut pose = frame(&model.base);
    for row in &model.rows {
        let value = row.joint.map_or(0.0, |joint| q[joint]);
        let (turn, slide) = if row.kind == RowKind::Revolute { (value, 0.0) } else { (0.0, value) };
        pose = pose
            * about(Vector3::z_axis(), row.theta.rad() + turn)
            * shift(row.a.default_value(), row.d.default_value() + slide)
            * about(Vector3::x_axis(), row.alpha.rad());
    }
    pose * frame(&model.tool)
}

/// A value in -1 to 1.
pub fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// The largest difference at 300 configurations beyond the limits too; `values` gives those of the URDF's joints.
pub fn worst(name: &str, ends: [&str; 2], file: &Model, values: impl Fn(&[f64]) -> HashMap<String, f64>) -> f64 {
    let joints = joints(name);
    let mut state = 7;
    let mut worst: f64 = 0.0;
    for _ in 0..300 {
        let q: Vec<f64> = file.joints.iter().map(|_| 3.2 * random(&mut state)).collect();
        let (a, b) = (table_pose(file, &q), urdf_pose(&joints, ends[0], ends[1], &values(&q)));
        worst = worst.max((a.translation.vector - b.translation.vector).norm()).max(a.rotation.angle_to(&b.rotation));
    }
    worst
}

/// Values under the names that the file gives its joints.
pub fn by_name(file: &Model) -> impl Fn(&[f64]) -> HashMap<String, f64> {
    |q| file.joints.iter().zip(q).map(|(joint, value)| (joint.name.clone(), *value)).collect()
}
