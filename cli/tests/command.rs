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
        (&["check", "specs/ur5.yaml", "extra"], "unexpected argument 'extra'"),
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
