//! `denhart draw` and `denhart trace --plot`: files, the standard output, and messages for what cannot be drawn.
#![cfg(feature = "draw")]
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn spec(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(format!("{name}.yaml")).display().to_string()
}

/// An empty folder of one test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("draw").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_denhart")).args(arguments).current_dir(folder).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The message of a run that fails.
fn refused(folder: &Path, arguments: &[&str], status: i32) -> String {
    let output = run(folder, arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {message}");
    message
}

#[test]
fn a_picture_goes_where_it_is_said() {
    let folder = folder("where");
    let ur5 = spec("ur5");
    let output = run(&folder, &["draw", &ur5]);
    assert_eq!((output.status.code(), text(&output.stdout).trim()), (Some(0), "ur5.svg"));
    let svg = fs::read_to_string(folder.join("ur5.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("all joints at 0"));
    // The same bytes once more, over its own file and on the standard output.
    assert_eq!(run(&folder, &["draw", &ur5]).status.code(), Some(0));
    assert_eq!(text(&run(&folder, &["draw", &ur5, "-o", "-"]).stdout), svg);
    run(&folder, &["draw", &ur5, "-o", "arm.png", "--width", "300"]);
    let png = fs::read(folder.join("arm.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG") && png[16..20] == 300_u32.to_be_bytes());
}

#[test]
fn the_axes_that_decide_the_inverse_are_drawn_in_words() {
    let folder = folder("axes");
    for (name, words) in [
        ("ur5", "axes 2, 3, 4 are parallel"),
        ("puma560", "axes 4, 5, 6 meet in a point"),
        ("anthro3r", "axes v1, v2, v3 meet in a point, all of them virtual"),
        ("singular_6r", "no inverse that axes decide"),
    ] {
        let svg = |more: &[&str]| text(&run(&folder, &[&["draw", &spec(name), "-o", "-"], more].concat()).stdout);
        assert!(svg(&["--axes"]).contains(words) && !svg(&[]).contains(words), "{name}");
    }
}

#[test]
fn a_file_of_something_else_is_left_alone() {
    let folder = folder("alone");
    fs::write(folder.join("ur5.svg"), "<svg>mine</svg>").unwrap();
    let message = refused(&folder, &["draw", &spec("ur5")], 1);
    assert!(message.contains("`ur5.svg` is there already") && message.contains("help: name another file with -o"));
    assert_eq!(fs::read_to_string(folder.join("ur5.svg")).unwrap(), "<svg>mine</svg>");
}

#[test]
fn what_cannot_be_drawn_is_told() {
    let folder = folder("told");
    for (arguments, status, parts) in [
        (&["ur5", "--q", "0 0 NaN 0 0 0"][..], 2, &["--q: `NaN` is not a number", "help: "][..]),
        (&["ur5", "--q", "0 0"], 2, &["2 values, but the arm has 6 joints", "help: "]),
        (&["ur5", "-o", "ur5.gif"], 2, &["`ur5.gif` is no file for a picture", "help: ", ".svg or .png"]),
        (&["ur5", "--size", "9x9"], 2, &["`9x9` is no size", "help: "]),
        (&["ur5", "--view", "back"], 2, &["back"]),
        (&["singular_6r", "--pose", "0 0 0 0 0 0"], 1, &["no inverse kinematics: ", "help: --q draws this arm"]),
        (&["kuka_iiwa7_r800", "--pose", "500 0 500 180 0 0"], 2, &["the target leaves q3 to choose", "help: "]),
        (&["ur5", "-o", "no/such/folder/a.svg"], 1, &["cannot write `no/such/folder/a.svg`"]),
    ] {
        let file = spec(arguments[0]);
        let all: Vec<&str> = ["draw", file.as_str()].into_iter().chain(arguments[1..].iter().copied()).collect();
        let message = refused(&folder, &all, status);
        for part in parts {
            assert!(message.contains(part), "{arguments:?}: {message}");
        }
    }
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "nothing is written");
}

#[test]
fn every_solution_has_its_line_in_the_legend() {
    let folder = folder("solutions");
    let svg = text(&run(&folder, &["draw", &spec("salman_rrr"), "--pose", "390 80 300", "-o", "-"]).stdout);
    for line in ["1 shoulder left, elbow up (out of limits)", "3 shoulder right, elbow up<", "4 solutions"] {
        assert!(svg.contains(line), "{line}");
    }
    assert!(svg.contains("stroke-dasharray"));
    let q = ["draw", &spec("ur5"), "--q", "0 -60 60 20 40 10", "--solutions", "-o", "-"].map(str::to_owned);
    let q: Vec<&str> = q.iter().map(String::as_str).collect();
    let svg = text(&run(&folder, &q).stdout);
    assert!(svg.contains("8 shoulder right, elbow down, wrist flip") && svg.contains(">q6"));
}

#[test]
fn a_target_out_of_reach_is_drawn_with_what_misses() {
    let folder = folder("reach");
    let output = run(&folder, &["draw", &spec("planar2r"), "--pose", "40 0", "-o", "-"]);
    assert_eq!(output.status.code(), Some(3));
    let svg = text(&output.stdout);
    assert!(svg.contains("10 cm short") || svg.contains("15 cm short"), "{svg}");
    assert!(svg.contains("out of reach: the closest that iteration finds is"));
    let output = run(&folder, &["draw", &spec("puma560"), "--pose", "0.86 0 0 0 0 0", "-o", "-"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(text(&output.stdout).contains(">target<"));
}

#[test]
fn curves_of_a_motion_are_drawn() {
    let folder = folder("plot");
    let trace = |file: &str, law: &str| {
        run(&folder, &["trace", &spec("planar2r"), "--to", "2", "--step", "1", "--law", law, "--plot", file])
    };
    let output = trace("m.svg", "30t, 20 sin(t)");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(text(&output.stdout).lines().count(), 4, "the table is printed all the same");
    let svg = fs::read_to_string(folder.join("m.svg")).unwrap();
    for part in
        ["joints, deg", "position of the tool, cm", "velocity, cm/s", "angular acceleration, deg/s\u{b2}", "t, s", "q2"]
    {
        assert!(svg.contains(part), "{part}");
    }
    let output = trace("m.png", "30t, t");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("--plot: `m.png` is no SVG\nhelp: "));
    assert_eq!(trace("n.svg", "1/t, t").status.code(), Some(1));
    assert!(!folder.join("n.svg").exists());
    // The acceleration of the tool overflows, though the law has one.
    let output = trace("o.svg", "1e200 t, t");
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("--plot: ") && text(&output.stderr).contains(" is beyond 1e100 "));
    // Nothing is written over the arm file, or over the other output.
    let arm = fs::read_to_string(spec("planar2r")).unwrap();
    fs::write(folder.join("arm.svg"), &arm).unwrap();
    let both = ["trace", "arm.svg", "--to", "2", "--step", "1", "--law", "t, t"];
    for (more, part) in [
        (&["--plot", "arm.svg"][..], "--plot: `arm.svg` is the arm file too"),
        (&["-o", "arm.svg"], "-o: `arm.svg` is the arm file too"),
        (&["-o", "c.svg", "--plot", "c.svg"], "--plot: `c.svg` is -o too"),
    ] {
        let output = run(&folder, &[&both[..], more].concat());
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(text(&output.stderr).contains(part), "{}", text(&output.stderr));
    }
    let output = run(&folder, &["draw", "arm.svg", "-o", "arm.svg"]);
    assert!(text(&output.stderr).contains("--output: `arm.svg` is the arm file"), "{}", text(&output.stderr));
    assert_eq!(fs::read_to_string(folder.join("arm.svg")).unwrap(), arm);
}
