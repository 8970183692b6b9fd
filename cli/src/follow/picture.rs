//! The joints and their velocities over time as a picture.

use std::path::Path;

use denhart::JointKind;
use denhart_tools::follow::{Asked, Keep};

use super::answer::Answer;
use crate::Failure;
use crate::numbers::Units;
use crate::trace::plot::{Curve, Panel, svg};

/// Writes the picture.
///
/// # Errors
/// A name that is not one of an SVG; no way to write.
pub fn write(asked: &Asked, answer: &Answer, units: Units, file: &Path) -> Result<(), Failure> {
    if file.extension().is_none_or(|kind| !kind.eq_ignore_ascii_case("svg")) {
        let given = file.display();
        return Err(Failure::Usage(format!("--plot: `{given}` is no SVG\nhelp: write a name that ends in .svg")));
    }
    let arm = asked.arm;
    let times: Vec<f64> = answer.motion.rows.iter().map(|row| row.t).collect();
    let (length, angle) = (arm.length_unit().to_string(), units.symbol());
    let free = [f64::NEG_INFINITY, f64::INFINITY];
    let panel = |title: &str, unit: &str, kind: JointKind, is_rate: bool| {
        let joints = arm.joint_names().zip(arm.joint_kinds()).zip(arm.limits()).enumerate();
        let own = joints.filter(|(_, ((_, other), _))| **other == kind);
        let curves = own.map(|(joint, ((name, _), limits))| {
            let most = asked.rates.velocity.get(joint).copied().unwrap_or(f64::INFINITY);
            let limits = if is_rate { [-most, most] } else { *limits };
            let values =
                answer.motion.rows.iter().filter_map(|row| if is_rate { &row.velocity } else { &row.q }.get(joint));
            let shown = |value: f64| if value.is_finite() { units.of_joint(kind, value) } else { value };
            Curve {
                name: name.to_owned(),
                values: values.map(|value| shown(*value)).collect(),
                limits: limits.map(shown),
            }
        });
        Panel { title: title.to_owned(), unit: unit.to_owned(), curves: curves.collect() }
    };
    let off = |title: &str, unit: &str, values: Vec<f64>| Panel {
        title: title.to_owned(),
        unit: unit.to_owned(),
        curves: vec![Curve { name: "off the path".to_owned(), values, limits: free }],
    };
    let mut panels = vec![
        panel("joints", angle, JointKind::Revolute, false),
        panel("velocities", &format!("{angle}/s"), JointKind::Revolute, true),
        panel("slides", &length, JointKind::Prismatic, false),
        panel("velocities of slides", &format!("{length}/s"), JointKind::Prismatic, true),
    ];
    if answer.keep == Keep::Time {
        panels.push(off("position", &length, answer.motion.rows.iter().map(|row| row.off.position).collect()));
        let turned = answer.motion.rows.iter().map(|row| units.of(row.off.orientation));
        panels.push(off("orientation", angle, turned.collect()));
    }
    panels.retain(|panel| !panel.curves.is_empty());
    let text = svg(&arm.model().name, &times, &panels).map_err(Failure::Other)?;
    let cannot = |error| Failure::Other(format!("cannot write `{}`: {error}", file.display()));
    std::fs::write(file, text).map_err(cannot)
}
