//! Targets in JSON: an object of a target, or what `forward --json` and `inverse --json` print.

use denhart_codegen::spec::nearest;
use denhart_dynamic::DynamicArm;
use serde_json::{Map, Value};

use super::Target;
use super::named::Parts;
use crate::Failure;
use crate::numbers::Units;

/// The keys of a target's parts.
const PARTS: [&str; 7] = ["position", "matrix", "quaternion", "rpy", "axis", "angle", "phi"];
/// The keys beside them that may be left out.
const OPTIONAL: [&str; 3] = ["given", "angle_unit", "length_unit"];
/// The keys that hold the parts.
const HOLDERS: [&str; 2] = ["pose", "target"];

/// The target of a JSON text.
///
/// # Errors
/// Text that is no JSON, with its line and column; an object that is no target.
pub fn of_text(arm: &DynamicArm, text: &str, units: Units) -> Result<Target, Failure> {
    let value: Value = serde_json::from_str(text).map_err(|error| Failure::Usage(format!("not JSON: {error}")))?;
    of_object(arm, &value, units)
}

/// The target of an object: its keys `pose` or `target`, where it has one, hold the parts. Its `angle_unit` counts before
/// `--units`.
fn of_object(arm: &DynamicArm, value: &Value, units: Units) -> Result<Target, Failure> {
    let object = |value: &Value, name: &str| match value {
        Value::Object(object) => Ok(object.clone()),
        _ => Err(Failure::Usage(format!(
            "{name}expected a JSON object\nhelp: write {{\"position\": [x, y, z], \"quaternion\": [w, x, y, z]}}"
        ))),
    };
    let top = object(value, "")?;
    // Without it the target would have another meaning, and nothing would tell.
    if let Some(failure) = misspelt(&top, &OPTIONAL) {
        return Err(failure);
    }
    let own = arm.length_unit().to_string();
    if let Some(unit) = top.get("length_unit").filter(|unit| unit.as_str() != Some(&own)) {
        return Err(Failure::Usage(format!(
            "`length_unit` is {unit}, but the arm's lengths are in {own}\nhelp: convert the lengths to {own}"
        )));
    }
    let units = match top.get("angle_unit").map(Value::as_str) {
        None => units,
        Some(Some("deg")) => Units::Deg,
        Some(Some("rad")) => Units::Rad,
        Some(_) => return Err(Failure::Usage("`angle_unit`: expected \"deg\" or \"rad\"".to_owned())),
    };
    let inner = ["pose", "target"].into_iter().find_map(|key| Some((key, top.get(key)?)));
    let found = match inner {
        Some((key, value)) => object(value, &format!("`{key}`: "))?,
        None => top.clone(),
    };
    let target = parts(&found)?.target(arm, units);
    let target = target.map_err(|failure| misspelt(&found, &PARTS).unwrap_or(failure))?;
    Ok(Target { given: given(&top, arm, units)?, ..target })
}

/// The failure of a key that is probably one of `wanted`, misspelt. Other keys do not count: they are the user's own.
fn misspelt(object: &Map<String, Value>, wanted: &[&str]) -> Option<Failure> {
    let is_read = |key: &str| PARTS.iter().chain(&OPTIONAL).chain(&HOLDERS).any(|known| *known == key);
    let missed = || wanted.iter().copied().filter(|known| !object.contains_key(*known));
    object.keys().filter(|key| !is_read(key)).find_map(|key| {
        let meant = nearest(key, missed()).filter(|meant| meant.len().abs_diff(key.len()) <= 2)?;
        Some(Failure::Usage(format!("the key `{key}` is not known\nhelp: did you mean `{meant}`?")))
    })
}

/// The values that the key `given` has for the redundant joints: a number, or a list.
fn given(object: &Map<String, Value>, arm: &DynamicArm, units: Units) -> Result<Vec<f64>, Failure> {
    let Some(value) = object.get("given").filter(|value| !value.is_null()) else { return Ok(Vec::new()) };
    let (names, slides, mut values) = (arm.given()?, arm.given_slides()?, Vec::new());
    if !flatten(value, &mut values) || values.len() != names.len() {
        let expected = match names.as_slice() {
            [] => "this arm's inverse takes no value beside the target\nhelp: leave `given` out".to_owned(),
            names => format!("expected {}\nhelp: write a number for each", names.join(", ")),
        };
        return Err(Failure::Usage(format!("`given` is {value}: {expected}")));
    }
    Ok(values.into_iter().zip(slides).map(|(value, slides)| if slides { value } else { units.rad(value) }).collect())
}

fn parts(object: &Map<String, Value>) -> Result<Parts, Failure> {
    let list = |key: &str| {
        let read = |value: &Value| {
            let mut values = Vec::new();
            flatten(value, &mut values).then_some(values).ok_or_else(|| {
                Failure::Usage(format!("`{key}` is {value}, expected numbers in brackets\nhelp: write [0.1, 0.2, 0.3]"))
            })
        };
        object.get(key).map(read).transpose()
    };
    let one = |key: &str| {
        let read = |value: &Value| {
            value.as_f64().ok_or_else(|| Failure::Usage(format!("`{key}` is {value}, expected a number")))
        };
        object.get(key).map(read).transpose()
    };
    Ok(Parts {
        position: list("position")?,
        matrix: list("matrix")?,
        quaternion: list("quaternion")?,
        rpy: list("rpy")?,
        axis: list("axis")?,
        angle: one("angle")?,
        phi: one("phi")?,
    })
}

/// Appends the numbers of lists in lists; false where something else is among them.
fn flatten(value: &Value, values: &mut Vec<f64>) -> bool {
    match value {
        Value::Array(inner) => inner.iter().all(|value| flatten(value, values)),
        value => value.as_f64().map(|value| values.push(value)).is_some(),
    }
}
