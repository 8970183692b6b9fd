//! The command as it is run from a shell.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

mod colors;
mod start;
mod suggest;
mod trace;
#[cfg(feature = "view")]
mod view;

fn denhart(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

fn command(arguments: &[&str]) -> Command {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut command = Command::new(env!("CARGO_BIN_EXE_denhart"));
    command.args(arguments).current_dir(root).env_remove("CLICOLOR_FORCE");
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

/// Two joints and their sum have limits.
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
        "  axis of q2: through 0, 0, 0.089159, along 0, -1, 0",
        "  axis of q3: through -0.425, 0, 0.089159, along 0, -1, 0",
        "  axis of q5: through -0.81725, -0.10915, 0.089159, along 0, 0, -1",
        "  frame origins (standard: frame i stands at the end of link i, on axis i+1):",
        "    q2: -0.425, 0, 0.089159",
        "  tool: position -0.81725, -0.19145, -0.005491, roll pitch yaw 90, 0, 0",
        "reach: the tool gets 1.038384 m away from the base's origin",
    ] {
        assert!(said.lines().any(|found| found == line), "{line}\n{said}");
    }
}

#[test]
fn check_shows_an_axis_that_points_the_other_way() {
    let said = |convention: &str, rows: [&str; 3]| {
        let rows: String = rows.iter().map(|row| format!("  - {{{row}}}\n")).collect();
        let text = format!("name: axes\nconvention: {convention}\nunits: {{length: mm, angle: deg}}\njoints:\n{rows}");
        let path = arm_file("axes.yaml", &text);
        text_of_zero(&denhart(&["check", path.to_str().unwrap()]))
    };
    // The column of axis 2 and the frame of row 2 are 250 mm apart along the axis: the point stays on the column.
    let right = [
        "a: 0, alpha: 90, d: 400, theta: 0",
        "a: 0, alpha: -90, d: 250, theta: 0",
        "a: 100, alpha: 0, d: 300, theta: 0",
    ];
    let found = said("standard", right);
    assert_eq!(
        found[..3],
        [
            "  axis of q1: through 0, 0, 0, along 0, 0, 1",
            "  axis of q2: through 0, 0, 400, along 0, -1, 0",
            "  axis of q3: through 0, -250, 400, along 0, 0, 1",
        ]
    );
    assert_eq!(found[4], "    q1: 0, 0, 400");
    let wrong = right.map(|row| row.replace("alpha: 90", "alpha: -90"));
    let found = said("standard", wrong.each_ref().map(String::as_str));
    assert_eq!(found[1], "  axis of q2: through 0, 0, 400, along 0, 1, 0");
    // In this convention frames stand on their own axes, and a fixed row moves a frame on.
    let rows = [
        "a: 0, alpha: 0, d: 400, theta: 0",
        "a: 50, alpha: 90, d: 250, theta: 0",
        "type: fixed, a: 0, alpha: 0, d: 30, theta: 0",
    ];
    assert_eq!(
        said("modified", rows)[..5],
        [
            "  axis of q1: through 0, 0, 0, along 0, 0, 1",
            "  axis of q2: through 50, 0, 400, along 0, -1, 0",
            "  frame origins (modified: frame i stands on axis i; fixed rows move it on):",
            "    q1: 0, 0, 400",
            "    q2: 50, -280, 400",
        ]
    );
}

#[test]
fn check_proposes_rows_with_the_frames_near() {
    let head = "name: far\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n";
    let first = "  - {a: 0, alpha: 90, d: 0.1, theta: 0}\n";
    let far = "  - {a: -0.4, alpha: 0.1, d: 298, theta: 0, limits: [-90, 90]}\n  - {a: -0.4, alpha: 0, d: -297.9, theta: 0}\n";
    let path = arm_file("far.yaml", &[head, first, far].concat());
    let all: serde_json::Value =
        serde_json::from_slice(&denhart(&["check", "--json", path.to_str().unwrap()]).stdout).unwrap();
    let help = all.pointer("/0/messages/0/help").and_then(serde_json::Value::as_str).unwrap();
    let rows: String = help.lines().skip(1).map(|row| format!("  {row}\n")).collect();
    assert!(rows.contains("limits: [-90, 90]}\n  - {type: fixed, a: 0, alpha: 0.1, d: 0, theta: "), "{rows}");
    assert!(
        text(&denhart(&["check", path.to_str().unwrap()]).stdout).contains("  - {type: fixed, a: 0, alpha: 0.1, d: 0,")
    );
    let near = arm_file("near.yaml", &[head, first, &rows].concat());
    let pose = |path: &Path| -> Vec<f64> {
        let output = denhart(&["forward", path.to_str().unwrap(), "--q", "20 -50 70", "--json"]);
        let all: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let rows = all.pointer("/pose/matrix").unwrap().as_array().unwrap().clone();
        rows.iter().flat_map(|row| row.as_array().unwrap().clone()).map(|entry| entry.as_f64().unwrap()).collect()
    };
    for (far, near) in pose(&path).iter().zip(pose(&near)) {
        assert!((far - near).abs() < 1e-12, "{far} {near}");
    }
    assert_eq!(text(&denhart(&["check", "--strict", near.to_str().unwrap()]).stderr), "");
}

/// The lines on the arm at its zero.
fn text_of_zero(output: &Output) -> Vec<String> {
    let said = text(&output.stdout);
    said.lines().skip_while(|line| !line.starts_with("at q = 0")).skip(1).map(str::to_owned).collect()
}

#[test]
fn reach_says_that_sums_of_joints_are_not_counted_in() {
    let path = arm_file("sums.yaml", LIMITED);
    let said = text(&denhart(&["check", path.to_str().unwrap()]).stdout);
    let line = "reach: the tool gets 1 m away from the base's origin, without regard to `combined_limits`";
    assert!(said.lines().any(|found| found == line), "{said}");
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
    assert_eq!(at("/0/home/frame_origins/1/0"), -0.425);
    assert_eq!(at("/0/home/axes/1"), serde_json::json!({"point": [0.0, 0.0, 0.089159], "direction": [0.0, -1.0, 0.0]}));
    assert_eq!(at("/0/messages"), serde_json::json!([]));
    let found = all.pointer("/1/messages").unwrap().as_array().unwrap();
    let convention = found.iter().find(|message| message["line"] == 2).unwrap();
    assert_eq!((&convention["column"], &convention["end_column"]), (&13.into(), &21.into()));
    assert_eq!(convention["severity"], "error");
    assert!(convention["help"].as_str().unwrap().contains("did you mean `standard`?"));
    let message = at("/2/messages/0/message");
    assert!(message.as_str().unwrap().starts_with("no arm file at"), "{message}");
    assert!(!message.as_str().unwrap().contains("help"), "{message}");
    assert!(at("/2/messages/0/help").as_str().unwrap().starts_with("arm files there: "), "{all}");
}

#[test]
fn what_cannot_be_read_has_its_help_apart() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wide.yaml");
    let wide: Vec<u8> = "name: x".encode_utf16().flat_map(u16::to_le_bytes).collect();
    fs::write(&path, wide).unwrap();
    let file = path.to_str().unwrap();
    let all: serde_json::Value = serde_json::from_slice(&denhart(&["check", "--json", file]).stdout).unwrap();
    let message = format!("`{file}` is UTF-16, not UTF-8");
    let expected = serde_json::json!({"severity": "error", "message": message, "help": "save the file as UTF-8"});
    assert_eq!(all.pointer("/0/messages/0"), Some(&expected));
    let said = text(&denhart(&["check", file]).stderr);
    assert_eq!(said, format!("error: {message}\nhelp: save the file as UTF-8\n"));
}

#[test]
fn check_is_in_the_unit_that_is_asked_for() {
    let json = |arguments: &[&str]| -> serde_json::Value {
        serde_json::from_slice(&denhart(&[&["check", "--json"], arguments].concat()).stdout).unwrap()
    };
    // Joint 1 of a Puma turns by 160 degrees, the tool of a UR5 is turned by 90.
    for (units, symbol, high, roll) in
        [(&[][..], "deg", 160.0, 90.0), (&["--units", "rad"], "rad", 160_f64.to_radians(), std::f64::consts::FRAC_PI_2)]
    {
        let all = json(&[&["specs/puma560.yaml", "specs/ur5.yaml"], units].concat());
        let number = |pointer: &str| all.pointer(pointer).unwrap().as_f64().unwrap();
        assert_eq!(all.pointer("/0/angle_unit"), Some(&symbol.into()));
        assert!((number("/0/joints/0/limits/1") - high).abs() < 1e-12, "{all}");
        assert!((number("/1/home/tool/rpy/0") - roll).abs() < 1e-12, "{all}");
        let shown = text(&denhart(&[&["check", "specs/ur5.yaml"], units].concat()).stdout);
        assert!(shown.contains(&format!("at q = 0, in the base frame (m, {symbol}):")), "{shown}");
        let roll = if symbol == "deg" { "90" } else { "1.570796" };
        assert!(shown.contains(&format!("roll pitch yaw {roll}, 0, 0")), "{shown}");
    }
}

#[test]
fn files_are_read_from_the_standard_input() {
    let arm = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml")).unwrap();
    for arguments in [
        &["check", "-"][..],
        &["expand", "-"],
        &["forward", "-", "--q", "0 0 0 0 0 0"],
        &["inverse", "-", "--q", "0.1 0.2 0.3 0.4 0.5 0.6"],
        &["trace", "-", "--law", "t, t, t, t, t, t", "--to", "1", "--step", "1"],
    ] {
        let output = piped(arguments, &arm);
        assert!(output.status.success() && output.stdout.len() > 100, "{arguments:?}");
    }
    let of_file = text(&denhart(&["expand", "specs/ur5.yaml", "--scalar", "f32"]).stdout);
    assert_eq!(text(&piped(&["expand", "-", "--scalar", "f32"], &arm).stdout), of_file);
    let broken = piped(&["expand", "-"], "name: broken\nconvention: standrad\n");
    assert_eq!(broken.status.code(), Some(1));
    assert!(text(&broken.stderr).contains("<stdin>:2:13"), "{broken:?}");
}

/// Runs the command with a text on its standard input.
fn piped(arguments: &[&str], input: &str) -> Output {
    let mut command = command(arguments);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
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

/// Each mistake of a file begins alike, whatever command finds it.
#[test]
fn every_mistake_has_the_same_prefix() {
    let path = arm_file("twice.yaml", "name: twice\nconvention: standrad\nunits: mm\njoints: 1\n");
    let file = path.to_str().unwrap();
    let to = Path::new(env!("CARGO_TARGET_TMPDIR")).join("twice");
    for arguments in [
        &["check", file][..],
        &["expand", file],
        &["forward", file, "--q", "0"],
        &["inverse", file, "--q", "0"],
        &["trace", file, "--law", "0", "--to", "1", "--step", "1"],
        &["export", "c", file, "-o", to.to_str().unwrap()],
    ] {
        let said = text(&denhart(arguments).stderr);
        let mistakes: Vec<&str> = said.lines().filter(|line| line.contains("twice.yaml:")).collect();
        assert_eq!(mistakes.len(), 3, "{said}");
        assert!(mistakes.iter().all(|line| line.starts_with("error: ")), "{arguments:?}: {said}");
    }
    // A report of an arm with warnings is no mistake, and its mistake is one.
    let rows = "joints:\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n";
    let units = "convention: standard\nunits: {length: m, angle: deg}";
    let path = arm_file("lacks.yaml", &format!("name: lacks\n{units}\ninverse: {{require: true}}\n{rows}"));
    let said = text(&denhart(&["check", path.to_str().unwrap()]).stderr);
    assert!(said.starts_with("lacks: 1 moving joint (R), lengths in m\n"), "{said}");
    assert!(said.lines().any(|line| line.starts_with("error: ") && line.contains("lacks.yaml:4:")), "{said}");
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
