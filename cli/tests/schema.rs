//! `denhart schema` beside the files it describes. The rules of the schema are applied here, by a reader of the few
//! keywords that it uses.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn schema() -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_denhart")).arg("schema").output().unwrap();
    assert!(output.status.success());
    serde_json::from_slice(&output.stdout).unwrap()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Holds `value` to `rule`; an error names the first part of the rule that is broken.
fn broken(schema: &Value, rule: &Value, value: &Value, at: &str) -> Result<(), String> {
    for (keyword, argument) in rule.as_object().unwrap() {
        match keyword.as_str() {
            "$schema" | "title" | "description" | "definitions" => {}
            "$ref" => {
                let pointer = argument.as_str().unwrap().strip_prefix('#').unwrap();
                broken(schema, schema.pointer(pointer).unwrap(), value, at)?;
            }
            "type" => {
                let is = |kind: &str| match kind {
                    "object" => value.is_object(),
                    "array" => value.is_array(),
                    "string" => value.is_string(),
                    "number" => value.is_number(),
                    "boolean" => value.is_boolean(),
                    "null" => value.is_null(),
                    other => panic!("{other}"),
                };
                let kinds: Vec<&str> = match argument {
                    Value::Array(kinds) => kinds.iter().map(|kind| kind.as_str().unwrap()).collect(),
                    one => vec![one.as_str().unwrap()],
                };
                if !kinds.into_iter().any(is) {
                    return Err(format!("{at}: {value} is not {argument}"));
                }
            }
            "enum" => {
                let equal =
                    |choice: &Value| choice == value || choice.as_f64().is_some_and(|x| Some(x) == value.as_f64());
                if !argument.as_array().unwrap().iter().any(equal) {
                    return Err(format!("{at}: {value} is none of {argument}"));
                }
            }
            "anyOf" => {
                let any = argument.as_array().unwrap().iter().any(|rule| broken(schema, rule, value, at).is_ok());
                if !any {
                    return Err(format!("{at}: {value} fits none"));
                }
            }
            "required" => {
                for key in argument.as_array().unwrap() {
                    if value.is_object() && value.get(key.as_str().unwrap()).is_none() {
                        return Err(format!("{at}: no {key}"));
                    }
                }
            }
            "properties" => {
                for (key, rule) in argument.as_object().unwrap() {
                    if let Some(value) = value.get(key) {
                        broken(schema, rule, value, &format!("{at}.{key}"))?;
                    }
                }
            }
            "additionalProperties" => {
                let known = |key: &String| rule.get("properties").is_some_and(|known| known.get(key).is_some());
                for (key, value) in value.as_object().into_iter().flatten().filter(|(key, _)| !known(key)) {
                    match argument {
                        Value::Bool(false) => return Err(format!("{at}: unknown {key}")),
                        rule => broken(schema, rule, value, &format!("{at}.{key}"))?,
                    }
                }
            }
            "items" => {
                for (index, value) in value.as_array().into_iter().flatten().enumerate() {
                    broken(schema, argument, value, &format!("{at}[{index}]"))?;
                }
            }
            "minItems" | "maxItems" => {
                let (count, bound) = (value.as_array().map(Vec::len), argument.as_u64().map(|n| n as usize));
                let fits = count.is_none() || if keyword == "minItems" { count >= bound } else { count <= bound };
                if !fits {
                    return Err(format!("{at}: {count:?} items"));
                }
            }
            other => panic!("a keyword that this test does not know: {other}"),
        }
    }
    Ok(())
}

fn check(schema: &Value, text: &str) -> Result<(), String> {
    let value: Value = serde_yaml::from_str(text).map_err(|error| error.to_string())?;
    broken(schema, schema, &value, "")
}

fn yaml_files(directory: &str) -> Vec<PathBuf> {
    let files = fs::read_dir(root().join(directory)).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "yaml")).collect();
    files.sort();
    files
}

#[test]
fn every_arm_file_of_the_repository_fits() {
    let (schema, specs) = (schema(), yaml_files("specs"));
    assert!(specs.len() > 50);
    for path in specs {
        let text = fs::read_to_string(&path).unwrap();
        check(&schema, &text).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
    }
}

/// All keys there are, each in a form of the documentation.
#[test]
fn every_key_of_an_arm_file_is_in_it() {
    let text = "
name: all
convention: modified
units: {length: mm, angle: deg}
parameters: {l2: 425}
base: {xyz: [0, l2, 0], rpy: [0, pi/2, 90 deg]}
tool: {xyz: [0, 0, 0], rpy: [0, 0, 0]}
inverse: {task: pose, require: true, redundant: null, axis: x, tolerance: {length: 0.1, angle: 1e-3 rad}, weights: {q1: 2}}
joints:
  - {type: revolute, name: one, a: -2*l2, alpha: pi/2, d: 0, theta: 0, limits: [-90, null], actuator: {pulses_per_rev: 200, gear_ratio: 50, home: 0, direction: -1}}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: null, actuator: {pulses_per_unit: 80, home: 10}}
coupling: {q2: {one: 20 per rev, q2: 1, offset: 3}}
combined_limits: [{sum: {one: 1}, limits: [-90, 90 deg]}]
";
    let schema = schema();
    check(&schema, text).unwrap();
    check(
        &schema,
        &text.replace("{q2: {one: 20 per rev, q2: 1, offset: 3}}", "{matrix: [[1, 0], [1, 1]], offset: [0, 90]}"),
    )
    .unwrap();
    check(&schema, &text.replace("redundant: null", "redundant: [one, q2]")).unwrap();
    assert!(check(&schema, &text.replace("redundant: null", "redundant: []")).is_err());
    // Numbers may stand in quotes, and a sum of factors 1 is a list of names.
    let mut quoted = text.replace("sum: {one: 1}", "sum: [one, q2]");
    for number in ["425", "0.1", "200", "50", "80", "-1", "2"] {
        quoted = quoted.replace(&format!(": {number}}}"), &format!(": '{number}'}}"));
        quoted = quoted.replace(&format!(": {number},"), &format!(": '{number}',"));
    }
    assert!(quoted.contains("gear_ratio: '50'") && quoted.contains("direction: '-1'") && quoted.contains("{q1: '2'}"));
    check(&schema, &quoted).unwrap();
    // The reader takes every key of it too.
    denhart_codegen::check(text, "all.yaml").unwrap();
    denhart_codegen::check(&quoted.replace("sum: [one, q2]", "sum: [one]"), "all.yaml").unwrap();
}

#[test]
fn what_is_wrong_in_form_does_not_fit() {
    let schema = schema();
    let arm = |rows: &str, more: &str| format!("convention: standard\njoints: [{rows}]\n{more}");
    let row = "{a: 0, alpha: 0, d: 0, theta: 0}";
    check(&schema, &arm(row, "")).unwrap();
    for (text, why) in [
        (arm("", ""), "items"),
        (arm("{a: 0, alpha: 0, d: 0}", ""), "no \"theta\""),
        (arm("{a: 0, alfa: 0, alpha: 0, d: 0, theta: 0}", ""), "unknown alfa"),
        (arm("{a: 0, alpha: 0, d: 0, theta: 0, type: rotary}", ""), "none of"),
        (arm("{a: [0], alpha: 0, d: 0, theta: 0}", ""), "is not"),
        (arm("{a: 0, alpha: 0, d: 0, theta: 0, limits: [1]}", ""), "fits none"),
        (arm(row, "units: {length: km}"), "none of"),
        (arm(row, "colour: red"), "unknown colour"),
        (arm(row, "tool: {xyz: [0, 0], rpy: [0, 0, 0]}"), "items"),
        (arm(row, "inverse: {task: poses}"), "none of"),
        (arm(row, "").replace("standard", "standrad"), "none of"),
        ("joints: [{a: 0, alpha: 0, d: 0, theta: 0}]".to_owned(), "no \"convention\""),
    ] {
        let found = check(&schema, &text).unwrap_err();
        assert!(found.contains(why), "{text}\n{found}");
    }
}
