//! `denhart forward`: the pose of the tool of an arm, and the origins of its links.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use denhart::Pose;
use denhart_dynamic::DynamicArm;
use serde_json::{Value, json};

use crate::Failure;
use crate::hints;
use crate::number_arguments::joint_vector;
use crate::numbers::{Units, arm, outside, short};

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// The value of each joint, separated by commas or spaces: "0, -90, 90, 0, 0, 0"
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    q: String,
    /// The origin of each link too
    #[arg(long)]
    links: bool,
    /// Unit of angles, given and printed
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Prints the pose.
///
/// # Errors
/// Wrong arguments, mistakes in the file, no way to print.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let arm = arm(&options.file)?;
    let q = joint_vector("--q", &options.q, &arm, options.units)?;
    let pose = arm.forward(&q)?;
    let links = if options.links { arm.link_poses(&q)? } else { Vec::new() };
    if options.json {
        let text = serde_json::to_string_pretty(&as_json(&arm, &q, &pose, &links, options));
        writeln!(out, "{}", text.map_err(|error| Failure::Other(error.to_string()))?)?;
    } else {
        write!(out, "{}", as_text(&arm, &q, &pose, &links, options.units))?;
    }
    Ok(out.flush()?)
}

fn as_text(arm: &DynamicArm, q: &[f64], pose: &Pose<f64>, links: &[Pose<f64>], units: Units) -> String {
    let length = arm.length_unit().to_string();
    let mut text = format!("tool of {} in the base frame\n\n", arm.model().name);
    let rows = pose.rotation.iter().zip(pose.translation);
    for (row, along) in rows {
        let entries = row.iter().map(|entry| format!("{:>13}", short(*entry))).collect::<String>();
        text += &format!("  {entries}  {:>14}\n", short(along));
    }
    let list = |values: &[f64]| values.iter().map(|value| short(*value)).collect::<Vec<_>>().join("  ");
    let rpy = pose.rpy();
    text += &format!("\nposition    {}  {length}\n", list(&pose.translation));
    text += &format!("roll pitch yaw  {}  {}", list(&rpy.angles.map(|angle| units.of(angle))), units.symbol());
    text += if rpy.singular { " (singular: roll set to 0)\n" } else { "\n" };
    text += &format!("quaternion  {}  (w x y z)\n", list(&pose.quaternion()));
    if !links.is_empty() {
        text += &format!("\norigins of the links, {length}\n");
        for (name, link) in arm.joint_names().zip(links) {
            text += &format!("  {name:<20}  {}\n", list(&link.translation));
        }
    }
    if let Some(hint) = hints::of_joints("--q", arm, q, units) {
        text += &format!("\nhint: {hint}");
    }
    for broken in outside(arm, q, units) {
        text += &format!("\noutside the limits: {broken}");
    }
    text.trim_end().to_owned() + "\n"
}

/// A pose as an object: matrix, position, roll pitch yaw and quaternion.
pub fn pose_json(pose: &Pose<f64>, units: Units) -> Value {
    let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
    let [x, y, z] = pose.translation;
    let rpy = pose.rpy();
    json!({
        "matrix": [[a, b, c, x], [d, e, f, y], [g, h, i, z], [0.0, 0.0, 0.0, 1.0]],
        "position": pose.translation,
        "rpy": rpy.angles.map(|angle| units.of(angle)),
        "rpy_singular": rpy.singular,
        "quaternion": pose.quaternion(),
    })
}

fn as_json(arm: &DynamicArm, q: &[f64], pose: &Pose<f64>, links: &[Pose<f64>], options: &Options) -> Value {
    let units = options.units;
    let shown: Vec<f64> = arm.joint_kinds().iter().zip(q).map(|(kind, q)| units.of_joint(*kind, *q)).collect();
    let mut all = json!({
        "arm": arm.model().name,
        "length_unit": arm.length_unit().to_string(),
        "angle_unit": units.symbol(),
        "q": shown,
        "pose": pose_json(pose, units),
        "outside_limits": outside(arm, q, units),
        "hints": hints::of_joints("--q", arm, q, units).as_slice(),
    });
    if options.links
        && let Some(object) = all.as_object_mut()
    {
        let links = arm.joint_names().zip(links);
        let links: Vec<Value> =
            links.map(|(name, link)| json!({ "joint": name, "origin": link.translation })).collect();
        object.insert("links".to_owned(), Value::from(links));
    }
    all
}
