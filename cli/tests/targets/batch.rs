//! Many targets at once.

use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

use serde_json::Value;

use crate::shell::{close, command, denhart, fed, file, json, said};

const UR5: &str = "specs/ur5.yaml";

fn objects(text: &[u8]) -> Vec<Value> {
    said(text).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// The first words of the lines of CSV, without the line of names.
fn rows(text: &[u8]) -> Vec<String> {
    said(text).lines().skip(1).map(|line| line.splitn(4, ',').take(3).collect::<Vec<_>>().join(",")).collect()
}

#[test]
fn a_bad_line_is_told_and_does_not_end_the_run() {
    let text = "0.3 0.1 0.4 180 0 0\n\n# a remark\n0.3 0.1 x 180 0 0\n3,0,0,0,0,0\n0,3;0,1;0,4;180;0;0\n";
    let path = file("targets_bad.csv", text);
    let output = denhart(&["inverse", UR5, "--batch", &path]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let told = said(&output.stderr);
    for part in [
        ":4: `x` is not a number\nhelp: write numbers",
        ":6: `3;0` is not a number\nhelp: write \"0.3, 0.1, 0.4, 180, 0, 0\", with a decimal point",
        ": 2 of 4 targets wrong",
    ] {
        assert!(told.contains(&format!("error: {path}{part}")), "{told}");
    }
    let rows = rows(&output.stdout);
    let first: Vec<String> = (1..=8).map(|index| format!("1,reachable,{index}")).collect();
    assert_eq!(rows[..8], first[..], "{rows:?}");
    assert_eq!(rows[8..], ["4,error,", "5,unreachable,", "6,error,"], "{rows:?}");
    // Every line has as many columns as there are names.
    let columns = |line: &str| line.split('"').step_by(2).map(|part| part.matches(',').count()).sum::<usize>();
    let text = said(&output.stdout);
    let names = text.lines().next().unwrap();
    assert!(names.starts_with("line,status,solution,q1,q2,q3,q4,q5,q6,branch,flags,within_limits,off_by_"), "{names}");
    assert!(text.lines().all(|line| columns(line) == columns(names)), "{text}");
}

#[test]
fn the_exit_status_is_3_where_a_target_is_out_of_reach() {
    let path = file("targets_far.csv", "3 0 0 0 0 0\n0.3 0.1 0.4 180 0 0\n");
    let output = denhart(&["inverse", UR5, "--batch", &path]);
    assert_eq!((output.status.code(), output.stderr.len()), (Some(3), 0), "{output:?}");
    let near = fed(&["inverse", UR5, "--batch", "-"], "0.3 0.1 0.4 180 0 0\n");
    assert_eq!((near.status.code(), near.stderr.len()), (Some(0), 0), "{near:?}");
    assert_eq!(denhart(&["inverse", UR5, "--batch", "no_such.csv"]).status.code(), Some(1));
    let none = fed(&["inverse", UR5, "--batch", "-"], "\n");
    assert_eq!(none.status.code(), Some(2));
    assert!(said(&none.stderr).contains("no targets\nhelp: "), "{none:?}");
    // Within the limits alone.
    let outside = "0.112748409 -0.132484177 1.11262069 -92.083659 -0.479531106 129.5375981\n";
    let output = fed(&["inverse", "specs/puma560.yaml", "--batch", "-", "--within-limits"], outside);
    assert_eq!(rows(&output.stdout), ["1,reachable,1", "1,reachable,2", "1,reachable,5"], "{output:?}");
}

/// Two lines in, the result of the first one out, before the second one comes.
#[test]
fn results_come_as_they_are_computed() {
    let mut child = command(&["inverse", UR5, "--batch", "-", "--json"]);
    let mut child = child.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap());
    for (number, x) in [(1, "0.3"), (2, "0.35")] {
        writeln!(input, "{x} 0.1 0.4 180 0 0").unwrap();
        let mut line = String::new();
        output.read_line(&mut line).unwrap();
        let answer: Value = serde_json::from_str(&line).unwrap();
        assert_eq!((answer["line"].as_u64(), answer["found"].as_u64()), (Some(number), Some(8)));
    }
    drop(input);
    assert!(child.wait().unwrap().success());
}

#[test]
fn columns_have_names() {
    let poses = ["10 20 30 40 50 60", "-20 30 10 20 30 40"];
    let arm = "specs/puma560.yaml";
    let list = |value: &Value| value.to_string().replace(['[', ']'], "");
    for (names, key) in [("note,x,y,z,roll,pitch,yaw", "rpy"), ("note,x,y,z,QW,QX,QY,QZ", "quaternion")] {
        let mut text = format!("{names}\n");
        for q in poses {
            let pose = json(&["forward", arm, "--q", q, "--json"])["pose"].clone();
            text += &format!("weld,{},{}\n", list(&pose["position"]), list(&pose[key]));
        }
        let output = fed(&["inverse", arm, "--batch", "-", "--near", poses[0], "--json"], &text);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let found = objects(&output.stdout);
        assert_eq!(found.iter().map(|answer| answer["line"].as_u64().unwrap()).collect::<Vec<_>>(), [2, 3]);
        close(&found[0]["solutions"][0]["q"], &[10.0, 20.0, 30.0, 40.0, 50.0, 60.0]);
    }
    let lacking = fed(&["inverse", arm, "--batch", "-"], "x,y,z,roll\n1,2,3,4\n");
    assert_eq!(lacking.status.code(), Some(2));
    assert!(said(&lacking.stderr).contains(":1: the columns x, y, z, roll are no target"), "{lacking:?}");
    let entry = fed(&["inverse", arm, "--batch", "-"], "x,y,z,roll,pitch,yaw\n1,2,3,a,0,0\n1,2\n");
    let told = said(&entry.stderr);
    assert!(told.contains(":2: `roll`: `a` is not a number") && told.contains(":3: 2 numbers, but 6 names"), "{told}");
}

/// Tables end their lines with commas; the columns stay those of their names.
#[test]
fn a_comma_at_the_end_of_the_names_is_no_column() {
    let arm = "specs/puma560.yaml";
    let plain = "yaw,pitch,roll,z,y,x\n0,10,170,0.3,0.1,0.4\n";
    let rows = |text: &str| {
        let output = fed(&["inverse", arm, "--batch", "-"], text);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        said(&output.stdout)
    };
    assert_eq!(rows(&plain.replace('\n', ",,\n")), rows(plain));
    assert_eq!(rows(&plain.replacen('\n', ",\n", 1)), rows(plain));
    let twice = fed(&["inverse", arm, "--batch", "-"], "x,X,y,z,roll,pitch,yaw\n1,1,0,0,0,0,0\n");
    assert_eq!(twice.status.code(), Some(2));
    assert!(said(&twice.stderr).contains(":1: the column x is there twice\nhelp: "), "{twice:?}");
}

/// Numbers beyond all that an arm has are answered, and the lines behind them too.
#[test]
fn absurd_numbers_do_not_end_the_run() {
    let text = "0.3 0.1 0.4 1e300 10 20\n1e300 0 0 0 0 0\n0.3 0.1 0.4 180 0 0\n";
    let output = fed(&["inverse", UR5, "--batch", "-", "--json"], text);
    let found = objects(&output.stdout);
    assert_eq!(found.len(), 3, "{output:?}");
    assert_eq!(found[2]["status"], "reachable");
    // Nothing is closest to a point whose distance overflows.
    assert!(found[1]["closest"].is_null() && found[1]["missed"].is_null(), "{}", found[1]);
}

/// The samples of a motion are targets: the axis of `position_axis` is not their acceleration `ax`.
#[test]
fn a_trace_is_a_list_of_targets() {
    let welder = crate::welder();
    let law = ["--law", "5t, 10, 20, 30, 40", "--to", "2", "--step", "1"];
    for form in ["rpy", "quaternion", "matrix"] {
        let trace = said(&denhart(&[&["trace", &welder, "--orientation", form], &law[..]].concat()).stdout);
        let output = fed(&["inverse", &welder, "--batch", "-", "--near", "5 10 20 30 40", "--json"], &trace);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        for (index, answer) in (0..).zip(objects(&output.stdout)) {
            close(&answer["solutions"][0]["q"], &[5.0 * f64::from(index), 10.0, 20.0, 30.0, 40.0]);
        }
    }
}

#[test]
fn json_lines_are_targets() {
    let good = "{\"position\": [0.3, 0.1, 0.4], \"rpy\": [180, 0, 0]}";
    let radians = "{\"position\": [0.3, 0.1, 0.4], \"rpy\": [3.14159265, 0, 0]}";
    let text = format!("{good}\n{{\"position\": [0.3, 0.1]}}\n{{\"position\n{radians}\n");
    let output = fed(&["inverse", UR5, "--batch", "-", "--json"], &text);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let found = objects(&output.stdout);
    let lines: Vec<u64> = found.iter().map(|answer| answer["line"].as_u64().unwrap()).collect();
    assert_eq!(lines, [1, 2, 3, 4]);
    let wrong: Vec<bool> = found.iter().map(|answer| answer["error"].is_string()).collect();
    assert_eq!(wrong, [false, true, true, false]);
    assert_eq!(found[3]["hints"].as_array().unwrap().len(), 1);
    assert!(said(&output.stderr).contains("error: <stdin>:3: not JSON: "), "{output:?}");
}
