//! Facts that the page tells of an arm beside its picture.

use denhart::JointKind;
use denhart_codegen::lower::Given;
use denhart_codegen::model::RowKind;
use denhart_dynamic::DynamicArm;
use serde_json::{Value, json};

use crate::arm::PageArm;

/// The page has the inverse of arms of up to so many joints: code of each number of joints is downloaded.
const MOST_JOINTS: usize = 9;

/// Names, units, limits, task. Limits that a joint does not have are `null`.
pub fn facts(arm: &DynamicArm) -> Value {
    let model = arm.model();
    let end = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
    let row_of = |joint: usize| model.rows.iter().position(|row| row.joint == Some(joint));
    let joints: Vec<Value> = arm
        .joint_names()
        .zip(arm.joint_kinds())
        .zip(arm.limits())
        .enumerate()
        .map(|(index, ((name, kind), [low, high]))| {
            let turns = *kind == JointKind::Revolute;
            json!({"name": name, "turns": turns, "low": end(*low), "high": end(*high), "row": row_of(index)})
        })
        .collect();
    let rows: Vec<Value> = model
        .rows
        .iter()
        .map(|row| {
            let fixed = row.kind == RowKind::Fixed;
            let numbers = [row.a.default_value(), row.alpha.rad(), row.d.default_value(), row.theta.rad()];
            json!({"joint": row.joint, "fixed": fixed, "numbers": numbers})
        })
        .collect();
    let ranges = arm.given_ranges().unwrap_or_default();
    let slides = arm.given_slides().unwrap_or_default();
    let values = arm.program().inverse.as_ref().map(|inverse| inverse.given.values.as_slice()).unwrap_or_default();
    let name = |given: &Given| match given {
        Given::Joint { joint, .. } => arm.joint_names().nth(*joint).unwrap_or_default(),
        Given::ArmAngle => "the arm angle",
    };
    let given: Vec<Value> = values
        .iter()
        .map(name)
        .zip(slides)
        .zip(ranges)
        .map(|((name, slides), range)| json!({"name": name, "slides": slides, "range": range}))
        .collect();
    let reach = arm.program().inverse.as_ref().ok().map(|inverse| inverse.constants.reach);
    let planar = denhart_draw::View::of(arm) == denhart_draw::View::Top;
    // A line to write, where the arm has an inverse for another request.
    let instead = arm.program().instead.first().map(|line| match arm.joints() > MOST_JOINTS {
        true => format!(
            ". Write `{line}` for generated code (`denhart expand`): this page has no inverse of so many joints"
        ),
        false => format!(". Write `{line}`"),
    });
    let no_inverse = arm.task().err().map(|error| format!("{error}{}", instead.unwrap_or_default()));
    json!({
        "name": model.name,
        "unit": model.length_unit.symbol(),
        "joints": joints,
        "rows": rows,
        "task": arm.task().ok(),
        "column": PageArm::column(arm),
        "noInverse": no_inverse,
        "given": given,
        "maxSolutions": arm.max_solutions().ok(),
        "reach": reach,
        "axes": denhart_draw::deciding_words(arm),
        "planar": planar,
        "pulses": model.actuators.is_some(),
    })
}
