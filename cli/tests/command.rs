//! The command as it is run from a shell.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn denhart(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

fn command(arguments: &[&str]) -> Command {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut command = Command::new(env!("CARGO_BIN_EXE_denhart"));
    command.args(arguments).current_dir(root);
    command
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A file in the directory cargo keeps for tests.
fn arm_file(name: &str, content: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, content).unwrap();
    path
}

#[test]
fn expand_prints_the_code() {
    let output = denhart(&["expand", "specs/ur5.yaml"]);
    let code = text(&output.stdout);
    assert!(output.status.success());
    assert!(code.contains("pub struct Ur5;") && code.contains("fn forward(") && code.contains("f64"), "{code}");
    assert!(output.stderr.is_empty());
}

#[test]
fn expand_takes_a_name_and_a_number_type() {
    let output = denhart(&["expand", "specs/ur5.yaml", "--type", "LeftArm", "--scalar", "f32"]);
    let code = text(&output.stdout);
    assert!(code.contains("pub struct LeftArm;") && code.contains("impl LeftArm {"), "{code}");
    assert!(code.contains("f32"), "{code}");
}

#[test]
fn check_prints_the_report() {
    let output = denhart(&["check", "specs/ur5.yaml"]);
    assert!(output.status.success());
    assert!(text(&output.stdout).contains("ur5"), "{output:?}");
    assert!(output.stderr.is_empty());
}

#[test]
fn check_gives_advice() {
    let rows = "joints:\n  - {a: 1, alpha: 1.5708 rad, d: 0, theta: 0}\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n";
    let path =
        arm_file("advice.yaml", &format!("name: bent\nconvention: standard\nunits: {{length: m, angle: deg}}\n{rows}"));
    let output = denhart(&["check", path.to_str().unwrap()]);
    assert!(output.status.success(), "{output:?}");
    assert!(text(&output.stdout).contains("advice.yaml:5:"), "{output:?}");
}

#[test]
fn strict_makes_warnings_mistakes() {
    let rows = "joints:\n  - {a: 1, alpha: 1.5708 rad, d: 0, theta: 0}\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n";
    let path =
        arm_file("strict.yaml", &format!("name: bent\nconvention: standard\nunits: {{length: m, angle: deg}}\n{rows}"));
    let output = denhart(&["check", "--strict", path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("strict.yaml:5:") && text(&output.stderr).contains("--strict"), "{output:?}");
    let output = denhart(&["check", "--strict", "specs/ur5.yaml"]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
}

#[test]
fn check_shows_the_arm_at_its_zero_and_its_reach() {
    let said = text(&denhart(&["check", "specs/puma560.yaml", "specs/ur5.yaml"]).stdout);
    for line in [
        "at q = 0, in the base frame (m, deg):",
        "  link of q2: origin -0.425, 0, 0.089159",
        "  tool: position -0.81725, -0.19145, -0.005491, roll pitch yaw 90, 0, 0",
        "reach: the tool gets 1.038384 m away from the base's origin",
    ] {
        assert!(said.lines().any(|found| found == line), "{line}\n{said}");
    }
}

#[test]
fn check_in_json_has_places_and_what_was_found() {
    let broken = arm_file("places.yaml", "name: broken\nconvention: standrad\n");
    let output = denhart(&["check", "--json", "specs/ur5.yaml", broken.to_str().unwrap(), "specs/no_such.yaml"]);
    assert_eq!((output.status.code(), output.stderr.len()), (Some(1), 0));
    let all: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let at = |pointer: &str| all.pointer(pointer).cloned().unwrap_or_default();
    assert_eq!(at("/0/inverse/max_solutions"), 8);
    assert_eq!(at("/0/inverse/task"), "pose");
    assert_eq!(at("/0/home/origins/1/0"), -0.425);
    assert_eq!(at("/0/messages"), serde_json::json!([]));
    let found = all.pointer("/1/messages").unwrap().as_array().unwrap();
    let convention = found.iter().find(|message| message["line"] == 2).unwrap();
    assert_eq!((&convention["column"], &convention["end_column"]), (&13.into(), &21.into()));
    assert_eq!(convention["severity"], "error");
    assert!(convention["help"].as_str().unwrap().contains("did you mean `standard`?"));
    assert!(at("/2/messages/0/message").as_str().unwrap().starts_with("no arm file at"));
}

#[test]
fn files_are_read_from_the_standard_input() {
    let arm = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml")).unwrap();
    for arguments in [&["check", "-"][..], &["trace", "-", "--law", "t, t, t, t, t, t", "--to", "1", "--step", "1"]] {
        let mut child = command(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        std::io::Write::write_all(&mut child.stdin.take().unwrap(), arm.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success() && output.stdout.len() > 100, "{arguments:?}");
    }
}

#[test]
fn a_new_arm_is_written_once() {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new");
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    let new = || command(&["new", "crane"]).current_dir(&directory).output().unwrap();
    assert!(new().status.success());
    let path = directory.join("crane.yaml");
    assert!(fs::read_to_string(&path).unwrap().contains("name: crane\n"));
    let output = denhart(&["check", "--strict", path.to_str().unwrap()]);
    assert!(output.status.success(), "{output:?}");
    let again = new();
    assert_eq!(again.status.code(), Some(1));
    assert!(text(&again.stderr).contains("`crane.yaml` is there already"), "{again:?}");
    assert_eq!(denhart(&["new", "my arm"]).status.code(), Some(2));
}

#[test]
fn shells_and_man_know_every_subcommand() {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("man");
    assert!(denhart(&["man", "-o", directory.to_str().unwrap()]).status.success());
    let page = text(&denhart(&["man"]).stdout);
    let bash = text(&denhart(&["completions", "bash"]).stdout);
    for name in ["check", "expand", "trace", "import", "new", "schema"] {
        assert!(page.contains(name) && bash.contains(name), "{name}");
        let own = fs::read_to_string(directory.join(format!("denhart-{name}.1"))).unwrap();
        assert!(own.contains(".TH"), "{own}");
    }
    for shell in ["zsh", "fish", "powershell", "elvish"] {
        assert!(denhart(&["completions", shell]).stdout.len() > 1000, "{shell}");
    }
}

const LIMITED: &str = "\
name: limited
convention: standard
units: {length: m, angle: deg}
joints:
  - {a: 0.5, alpha: 0, d: 0, theta: 0, limits: [-90, 90]}
  - {a: 0.5, alpha: 0, d: 0, theta: 0, limits: [-10, 20], name: elbow}
combined_limits:
  - {sum: {q1: 1, elbow: 1}, limits: [null, 65]}
";

#[test]
fn a_trace_marks_the_limits_that_are_broken() {
    let path = arm_file("limited.yaml", LIMITED);
    let common = ["trace", path.to_str().unwrap(), "--units", "deg", "--to", "4", "--step", "1", "--law"];
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
    let common = ["trace", path.to_str().unwrap(), "--units", "deg", "--to", "4", "--step", "1", "--stop-at-limits"];
    let output = denhart(&[&common[..], &["--law", "0, 10t"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(text(&output.stdout).lines().count(), 1 + 3, "{output:?}");
    let said = text(&output.stderr);
    assert_eq!(said, "error: at t = 3 joint `elbow` is at 30 deg, beyond its limits -10 to 20\n");
    let output = denhart(&[&common[..], &["--law", "5t, 5t"]].concat());
    assert_eq!((output.status.code(), text(&output.stdout).lines().count()), (Some(0), 6));
}

#[test]
fn mistakes_go_to_stderr_with_status_1() {
    let path = arm_file("broken.yaml", "name: broken\nconvention: standrad\n");
    for action in ["check", "expand"] {
        let output = denhart(&[action, path.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(1));
        assert!(output.stdout.is_empty());
        assert!(text(&output.stderr).contains("broken.yaml:2:13"), "{output:?}");
    }
}

#[test]
fn a_missing_file_is_named_and_the_nearest_suggested() {
    for action in ["check", "expand"] {
        let output = denhart(&[action, "specs/pumma560.yaml"]);
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stderr);
        assert!(said.starts_with("error: no arm file at `/"), "{said}");
        assert!(said.ends_with("/specs/pumma560.yaml`\nhelp: did you mean `specs/puma560.yaml`?\n"), "{said}");
    }
}

#[test]
fn wrong_arguments_have_status_2() {
    for (arguments, said) in [
        (&["expand"][..], "Usage: denhart expand"),
        (&["expand", "specs/ur5.yaml", "extra"], "unexpected argument 'extra'"),
        (&["expand", "specs/ur5.yaml", "--scalar", "f16"], "[possible values: f64, f32]"),
        (&[], "Usage: denhart"),
    ] {
        let output = denhart(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(said), "{output:?}");
    }
}

#[test]
fn help_goes_to_stdout() {
    let output = denhart(&["--help"]);
    let help = text(&output.stdout);
    assert!(output.status.success());
    for word in ["expand", "check", "Exit status"] {
        assert!(help.contains(word), "{help}");
    }
    assert!(text(&denhart(&["expand", "--help"]).stdout).contains("--scalar <TYPE>"));
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let mut child =
        command(&["expand", "specs/ur5.yaml"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(text(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}
