//! `denhart trace`: limits, and the samples as JSON.

use std::path::Path;

use crate::{LIMITED, arm_file, denhart, text};

#[test]
fn a_trace_marks_the_limits_that_are_broken() {
    let path = arm_file("limited.yaml", LIMITED);
    let common = ["trace", path.to_str().unwrap(), "--to", "4", "--step", "1", "--law"];
    let output = denhart(&[&common[..], &["30t, 10t"]].concat());
    let rows = text(&output.stdout);
    let marks: Vec<&str> = rows.lines().map(|row| row.rsplit(',').next().unwrap()).collect();
    // Joint 1 counts 1, joint 2 counts 2, the sum 4.
    assert_eq!(marks, ["out_of_limits", "0", "0", "4", "6", "7"], "{rows}");
    assert!(output.status.success() && output.stderr.is_empty());
}

#[test]
fn a_trace_stops_at_limits_if_asked() {
    let path = arm_file("stops.yaml", LIMITED);
    let common = ["trace", path.to_str().unwrap(), "--to", "4", "--step", "1", "--stop-at-limits"];
    let output = denhart(&[&common[..], &["--law", "0, 10t"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(text(&output.stdout).lines().count(), 1 + 3, "{output:?}");
    let said = text(&output.stderr);
    assert_eq!(said, "error: at t = 3 joint `elbow` is at 30 deg, beyond its limits -10 to 20\n");
    let output = denhart(&[&common[..], &["--units", "rad", "--law", "0, t"]].concat());
    let said = text(&output.stderr);
    let limits = "beyond its limits -0.174532925 to 0.34906585";
    assert_eq!(said, format!("error: at t = 1 joint `elbow` is at 1 rad, {limits}\n"));
    let output = denhart(&[&common[..], &["--law", "5t, 5t"]].concat());
    assert_eq!((output.status.code(), text(&output.stdout).lines().count()), (Some(0), 6));
}

/// Nothing is printed, and no file written, of a motion that has no first sample.
#[test]
fn a_trace_that_cannot_begin_prints_nothing() {
    let path = arm_file("begins.yaml", LIMITED);
    let to = Path::new(env!("CARGO_TARGET_TMPDIR")).join("never.csv");
    for extra in [&[][..], &["-o", to.to_str().unwrap()]] {
        for law in ["1/t, 0", "120, 0"] {
            let common =
                ["trace", path.to_str().unwrap(), "--to", "4", "--step", "1", "--stop-at-limits", "--law", law];
            let output = denhart(&[&common[..], extra].concat());
            assert_eq!((output.status.code(), output.stdout.len()), (Some(1), 0), "{output:?}");
            assert!(text(&output.stderr).starts_with("error: ") && !to.exists(), "{output:?}");
        }
    }
}

/// The samples of `trace --json` are the numbers of the CSV, under the names of its columns.
#[test]
fn a_trace_in_json_is_the_table() {
    let path = arm_file("json.yaml", LIMITED);
    let common = ["trace", path.to_str().unwrap(), "--to", "1", "--step", "0.25", "--law", "90t, 2 sin(t)"];
    for units in [&[][..], &["--units", "rad"]] {
        let arguments = [&common[..], units].concat();
        let table = text(&denhart(&arguments).stdout);
        let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let names = lines.next().unwrap();
        let json = denhart(&[&arguments[..], &["--json"]].concat());
        assert!(json.status.success() && json.stderr.is_empty());
        let all: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
        let symbol = if units.is_empty() { "deg" } else { "rad" };
        for (key, value) in [("arm", "limited"), ("length_unit", "m"), ("angle_unit", symbol)] {
            assert_eq!(all[key], value);
        }
        assert!(all["stopped"].is_null());
        let samples = all["samples"].as_array().unwrap();
        let rows: Vec<Vec<&str>> = lines.collect();
        assert_eq!((samples.len(), rows.len()), (5, 5));
        for (sample, row) in samples.iter().zip(rows) {
            assert_eq!(sample.as_object().unwrap().len(), names.len());
            for (name, value) in names.iter().zip(row) {
                assert_eq!(sample[*name].as_f64().unwrap(), value.parse::<f64>().unwrap(), "{name}");
            }
        }
    }
}

#[test]
fn a_trace_in_json_that_ends_early_says_why() {
    let path = arm_file("early.yaml", LIMITED);
    let common = ["trace", path.to_str().unwrap(), "--json", "--to", "4", "--step", "1", "--stop-at-limits", "--law"];
    for (law, count, said) in [
        ("0, 10t", 3, "at t = 3 joint `elbow` is at 30 deg, beyond its limits -10 to 20"),
        ("120, 0", 0, "at t = 0 joint `q1` is at 120 deg, beyond its limits -90 to 90"),
        ("0, 1/(2 - t)", 2, "the law `1/(2 - t)` has no finite value at t = 2: inf"),
    ] {
        let output = denhart(&[&common[..], &[law]].concat());
        assert_eq!(output.status.code(), Some(1));
        assert_eq!(text(&output.stderr), format!("error: {said}\n"));
        let all: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!((all["samples"].as_array().unwrap().len(), all["stopped"].as_str()), (count, Some(said)));
    }
}
