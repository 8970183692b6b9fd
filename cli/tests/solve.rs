//! `denhart forward` and `denhart inverse` as they are run from a shell.
#![allow(clippy::unwrap_used)]

use std::io::Write;
use std::path::Path;
use std::process::Stdio;

use serde_json::Value;

mod shell;

use shell::{close, command, denhart, json, said, shown};

#[test]
fn forward_prints_the_pose() {
    let text = shown(&["forward", "specs/ur5.yaml", "--q", "0, -90, 90, 0, 0, 0", "--links"]);
    for part in [
        "position    -0.39225  -0.19145  0.419509  m",
        "roll pitch yaw  90  0  0  deg",
        "quaternion  0.707106781  0.707106781  0  0",
        "  q2                    0  0  0.514159",
    ] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn forward_in_json_and_in_rad() {
    let pose = json(&["forward", "specs/ur5.yaml", "--q", "0 -90 90 0 0 0", "--json", "--links"]);
    close(&pose["pose"]["position"], &[-0.39225, -0.19145, 0.419509]);
    close(&pose["pose"]["matrix"][1], &[0.0, 0.0, -1.0, -0.19145]);
    close(&pose["links"][1]["origin"], &[0.0, 0.0, 0.514159]);
    let q = "0, -1.5707963267948966, 1.5707963267948966, 0, 0, 0";
    let rad = json(&["forward", "specs/ur5.yaml", "--q", q, "--units", "rad", "--json"]);
    assert_eq!(rad["pose"]["matrix"], pose["pose"]["matrix"]);
    close(&rad["pose"]["rpy"], &[std::f64::consts::FRAC_PI_2, 0.0, 0.0]);
    assert!(rad["links"].is_null());
}

#[test]
fn a_file_comes_from_the_standard_input() {
    let mut child =
        command(&["forward", "-", "--q", "30 -30"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let rows = "joints:\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n";
    let text = format!("name: bent\nconvention: standard\nunits: {{length: m, angle: deg}}\n{rows}");
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(said(&output.stdout).contains("position    1.866025404  0.5  0  m"), "{output:?}");
}

#[test]
fn joints_outside_their_limits_are_named() {
    let text = shown(&["forward", "specs/scara_rrrp_325_275.yaml", "--q", "0, 0, 0, -500"]);
    assert!(text.contains("outside the limits: q4 = -500 is below "), "{text}");
}

#[test]
fn inverse_lists_every_branch() {
    let q = [0.0, -90.0, 90.0, 0.0, 30.0, 0.0];
    let answer = json(&["inverse", "specs/ur5.yaml", "--q", "0, -90, 90, 0, 30, 0", "--json"]);
    let solutions = answer["solutions"].as_array().unwrap();
    assert_eq!((answer["status"].as_str(), solutions.len()), (Some("reachable"), 8));
    let own = |solution: &&Value| {
        let values = solution["q"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap());
        values.zip(q).all(|(x, y)| (x - y).abs() < 1e-9)
    };
    let own = solutions.iter().find(own).unwrap();
    assert_eq!(own["branch"], "shoulder right, elbow up, wrist no-flip");
    assert_eq!(own["flags"], serde_json::json!(["EXACT"]));
    assert!(own["residual"]["position"].as_f64().unwrap() < 1e-12);
    let table = shown(&["inverse", "specs/ur5.yaml", "--q", "0, -90, 90, 0, 30, 0"]);
    assert!(table.starts_with("8 solutions of ur5, task pose"), "{table}");
    assert_eq!(table.lines().filter(|line| line.contains("EXACT")).count(), 8, "{table}");
}

#[test]
fn inverse_of_a_pose_that_forward_printed() {
    let pose = json(&["forward", "specs/puma560.yaml", "--q", "10 20 30 40 50 60", "--json"]);
    let numbers =
        |key: &str| -> Vec<String> { pose["pose"][key].as_array().unwrap().iter().map(|x| x.to_string()).collect() };
    let asked = [numbers("position"), numbers("rpy")].concat().join(" ");
    let answer = json(&["inverse", "specs/puma560.yaml", "--pose", &asked, "--near", "11 20 30 40 50 60", "--json"]);
    close(&answer["solutions"][0]["q"], &[10.0, 20.0, 30.0, 40.0, 50.0, 60.0]);
}

#[test]
fn broken_limits_are_said() {
    let text = shown(&["inverse", "specs/puma560.yaml", "--q", "10 20 30 40 50 60"]);
    assert!(text.contains("broken") && text.contains(" is below ") | text.contains(" is above "), "{text}");
}

#[test]
fn what_is_missed_is_said_with_its_unit() {
    let far = denhart(&["inverse", "specs/ur5.yaml", "--pose", "2 0 0 0 0 0"]);
    assert_eq!(far.status.code(), Some(3));
    let text = said(&far.stdout);
    assert!(text.contains("Missed is the distance") && text.contains(" m away\n"), "{text}");
    // A SCARA cannot turn its tool upward.
    let target = ["inverse", "specs/scara_rrrp_325_275.yaml", "--pose", "400 100 0 90 0 0"];
    let upward = denhart(&target);
    assert_eq!(upward.status.code(), Some(3));
    let text = said(&upward.stdout);
    assert!(text.contains("Missed is the direction") && text.contains(" deg off"), "{text}");
    let answer = json(&[&target[..], &["--json"]].concat());
    assert_eq!(
        (answer["status"].as_str(), answer["missed"]["what"].as_str()),
        (Some("unreachable"), Some("direction"))
    );
    assert!((answer["missed"]["orientation"].as_f64().unwrap() - 90.0).abs() < 1.0, "{answer}");
}

#[test]
fn the_nearest_angle_of_a_tool_that_pitches_is_said() {
    let at = |angle: f64| {
        let pose = format!("0.35 -0.15 0.1 {angle}");
        json(&["inverse", "specs/al5d.yaml", "--pose", &pose, "--json"])
    };
    let answer = at(60.0);
    assert_eq!(
        (answer["status"].as_str(), answer["missed"]["what"].as_str()),
        (Some("unreachable"), Some("direction"))
    );
    let off = answer["missed"]["orientation"].as_f64().unwrap();
    let reachable = |turn: f64| [60.0 + turn, 60.0 - turn].iter().any(|angle| at(*angle)["status"] == "reachable");
    assert!(reachable(off + 1e-6) && !reachable(off - 1e-6), "{off}");
}

#[test]
fn smaller_tasks_take_fewer_numbers() {
    let text = shown(&["inverse", "specs/planar2r.yaml", "--q", "20 30"]);
    assert!(text.starts_with("2 solutions of planar2r, task planar_position"), "{text}");
    for (arm, q) in [("anthro3r", "10 20 30"), ("planar3r", "10 20 30"), ("planar2r", "10 20")] {
        let file = format!("specs/{arm}.yaml");
        let pose = json(&["forward", &file, "--q", q, "--json"]);
        let of = |key: &str, index: usize| pose["pose"][key][index].to_string();
        let (x, y, z, yaw) = (of("position", 0), of("position", 1), of("position", 2), of("rpy", 2));
        let asked = match arm {
            "anthro3r" => [x, y, z].join(" "),
            "planar3r" => [x, y, yaw].join(" "),
            _ => [x, y].join(" "),
        };
        let answer = json(&["inverse", &file, "--pose", &asked, "--near", q, "--json"]);
        assert_eq!(answer["target"]["position"].as_array().unwrap().len(), if arm == "anthro3r" { 3 } else { 2 });
        let q: Vec<f64> = q.split(' ').map(|x| x.parse().unwrap()).collect();
        close(&answer["solutions"][0]["q"], &q);
    }
}

#[test]
fn what_is_given_beside_the_target() {
    let arm = "specs/kuka_iiwa7_r800.yaml";
    let [q, pose] = ["10 20 30 40 50 60 70", "400 100 500 180 0 0"];
    assert!(shown(&["inverse", arm, "--q", q]).starts_with("8 solutions"));
    let none = denhart(&["inverse", arm, "--pose", pose]);
    assert_eq!(none.status.code(), Some(2));
    assert!(said(&none.stderr).contains("help: add --given with its value in deg, or --near"), "{none:?}");
    let given = json(&["inverse", arm, "--pose", pose, "--given", "30", "--json"]);
    assert!(
        given["solutions"]
            .as_array()
            .unwrap()
            .iter()
            .all(|solution| { (solution["q"][2].as_f64().unwrap() - 30.0).abs() < 1e-9 })
    );
    let surplus = denhart(&["inverse", "specs/ur5.yaml", "--pose", "0.3 0.1 0.4 180 0 0", "--given", "30"]);
    assert_eq!(surplus.status.code(), Some(2));
}

#[test]
fn several_values_are_given_beside_the_target() {
    let arm = "tests/arms/given/iiwa_on_a_rail.yaml";
    let (q, pose) = ("250, 10, 30, -17, -70, 20, 50, 5", ["inverse", arm, "--pose", "400 100 500 180 0 0"]);
    let asked = |more: &[&'static str]| denhart(&[&pose[..], more].concat());
    let none = asked(&[]);
    assert_eq!(none.status.code(), Some(2));
    assert!(
        said(&none.stderr)
            .contains("the target leaves q1, q4 to choose\nhelp: add --given with values \"q1 in mm, q4 in deg\"")
    );
    let few = asked(&["--given", "250"]);
    assert!(
        said(&few.stderr)
            .contains("1 number, but the inverse takes 2\nhelp: write a number for each: q1 in mm, q4 in deg")
    );
    let found = json(&["inverse", arm, "--q", q, "--json"]);
    close(&found["given"], &[250.0, -17.0]);
    assert_eq!(found["found"], 8);
    let given = json(&[&pose[..], &["--given", "250, 30", "--json"]].concat());
    close(&given["given"], &[250.0, 30.0]);
    for solution in given["solutions"].as_array().unwrap() {
        assert!((solution["q"][0].as_f64().unwrap() - 250.0).abs() < 1e-9, "{solution}");
        assert!((solution["q"][3].as_f64().unwrap() - 30.0).abs() < 1e-9, "{solution}");
    }
    assert!(said(&asked(&["--given", "250, 30"]).stdout).contains("given: q1 = 250 mm, q4 = 30 deg\n"));
    let swept = asked(&["--sweep", "5"]);
    assert!(
        said(&swept.stderr).contains("--sweep walks one value, and this arm's inverse takes 2: q1, q4"),
        "{swept:?}"
    );
    // Each line of a batch may have values of its own.
    let lines = "{\"position\": [400, 100, 500], \"rpy\": [180, 0, 0], \"given\": [250, 30]}\n\
                 {\"position\": [400, 100, 500], \"rpy\": [180, 0, 0]}\n";
    let mut child = command(&["inverse", arm, "--batch", "-", "--json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(lines.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    let answers: Vec<Value> = said(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(answers[0]["solutions"], given["solutions"]);
    assert!(answers[1]["error"].as_str().unwrap().contains("the target leaves q1, q4 to choose"), "{output:?}");
}

#[test]
fn wrong_arguments_have_status_2_and_wrong_files_status_1() {
    for (arguments, status, part) in [
        (
            &["forward", "specs/ur5.yaml", "--q", "0, 0"][..],
            2,
            "2 values, but the arm has 6 joints\nhelp: write a value for each joint: q1 in deg, ",
        ),
        (&["forward", "specs/ur5.yaml", "--q", "0 0 0 0 0 x"], 2, "`x` is not a number"),
        (&["forward", "specs/ur5.yaml"], 2, "--q"),
        (&["inverse", "specs/ur5.yaml"], 2, "<--pose <NUMBERS>|--whole-pose <NUMBERS>|"),
        (&["inverse", "specs/ur5.yaml"], 2, "|--q <VALUES>|--batch <FILE>>"),
        (
            &["inverse", "specs/ur5.yaml", "--pose", "1 2"],
            2,
            "2 numbers, but the task `pose` needs 6: \"x y z roll pitch yaw\"\nhelp: write --pose",
        ),
        (&["inverse", "specs/ur5.yaml", "--pose", "1 2 3 4 5 6", "--q", "0"], 2, "cannot be used with"),
        (&["inverse", "specs/singular_6r.yaml", "--q", "0 0 0 0 0 0"], 1, "no inverse kinematics: "),
        (
            &["inverse", "specs/singular_6r.yaml", "--q", "0 0 0 0 0 0"],
            1,
            "`denhart::numeric` solves any arm by iteration",
        ),
        (&["forward", "specs/no_such.yaml", "--q", "0"], 1, "no arm file at"),
    ] {
        let output = denhart(arguments);
        assert_eq!(output.status.code(), Some(status), "{output:?}");
        assert!(said(&output.stderr).contains(part), "{output:?}");
    }
}

#[test]
fn numbers_typed_in_another_way_have_the_right_ones_as_help() {
    let (ur5, scara, iiwa) = ("specs/ur5.yaml", "specs/scara_rrrp_325_275.yaml", "specs/kuka_iiwa7_r800.yaml");
    let pose = "400 100 500 180 0 0";
    for (arguments, help) in [
        (&["forward", ur5, "--q", "0,5 90 0 0 0 0"][..], "write --q \"0.5, 90, 0, 0, 0, 0\", with a decimal point"),
        (
            &["forward", ur5, "--q", "0,5; 9; 0; 0; 0; 0"],
            "write --q \"0.5, 9, 0, 0, 0, 0\", with a decimal point, and ",
        ),
        (
            &["forward", ur5, "--q", "pi/2 90\u{b0} 0 0 0 0"],
            "write --q \"90, 90, 0, 0, 0, 0\", as plain numbers: angles",
        ),
        (
            &["forward", scara, "--q", "0 0 0"],
            "write a value for each joint: q1 in deg, q2 in deg, q3 in deg, q4 in mm",
        ),
        (&["inverse", ur5, "--pose", "200mm 0 0 0 0 0"], "write --pose \"0.2, 0, 0, 0, 0, 0\", as plain numbers"),
        (&["inverse", "specs/planar2r.yaml", "--pose", "1"], "write --pose \"x y\", or a whole pose, \"x y z roll"),
        (&["inverse", iiwa, "--pose", pose, "--given", "30deg"], "write --given 30, as plain numbers"),
        (&["inverse", iiwa, "--pose", pose, "--given", "0,5"], "write --given 0.5, with a decimal point"),
        (&["inverse", ur5, "--pose", pose, "--near", "[0; 0; 0; 0; 0; 0]"], "write --near \"0, 0, 0, 0, 0, 0\", with"),
        (&["trace", ur5, "--to", "0,5", "--step", "1", "--law", "t"], "write 0.5, with a decimal point"),
        (&["trace", ur5, "--to", "1", "--step", "1", "--law", "0,5t;0;0;0;0;0"], "write --law \"0.5t, 0, 0, 0, 0, 0\""),
    ] {
        let output = denhart(arguments);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{output:?}");
        assert!(said(&output.stderr).contains(&format!("\nhelp: {help}")), "{output:?}");
    }
    let brackets = shown(&["forward", ur5, "--q", "[0, -90, 90, 0, 0, 0]"]);
    assert_eq!(brackets, shown(&["forward", ur5, "--q", "0 -90 90 0 0 0"]));
}

/// Degrees are printed as typed: -120, not -119.99999999999999. In rad every bit is there.
#[test]
fn degrees_in_json_have_no_rounding_of_their_conversion() {
    let q = "-120 0.1 77.7 -33.3 59.9 1";
    let answer = json(&["forward", "specs/ur5.yaml", "--q", q, "--json"]);
    assert_eq!(answer["q"].to_string(), "[-120.0,0.1,77.7,-33.3,59.9,1.0]");
    let answer = json(&["forward", "specs/ur5.yaml", "--q", "-120 0 0 0 0 0", "--json"]);
    assert_eq!(answer["pose"]["rpy"].to_string(), "[90.0,0.0,-120.0]");
    let rad = json(&["forward", "specs/ur5.yaml", "--q", "-2.0943951023931953 0 0 0 0 0", "--units", "rad", "--json"]);
    assert_eq!(rad["q"].to_string(), "[-2.0943951023931953,0.0,0.0,0.0,0.0,0.0]");
    assert_eq!(rad["pose"]["matrix"], answer["pose"]["matrix"]);
}

#[test]
fn free_joints_have_a_column_of_their_own() {
    let table = shown(&["inverse", "specs/puma560.yaml", "--q", "0 0 0 0 0 0"]);
    let rows: Vec<&str> = table.lines().filter(|line| line.contains("EXACT") || line.starts_with('#')).collect();
    let at = rows[0].find("free joints").unwrap();
    let entries: Vec<&str> = rows[1..].iter().map(|row| row[at..].split_whitespace().next().unwrap()).collect();
    assert_eq!(entries, ["-", "-", "-", "-", "q4", "-", "-"], "{table}");
    assert!(table.contains("EXACT | OUT_OF_LIMITS  -  ") && table.contains("EXACT | FREE           q4 "), "{table}");
    assert!(!shown(&["inverse", "specs/ur5.yaml", "--q", "0 -90 90 0 30 0"]).contains("free joints"));
}

/// An arm without inverse: which request its file could have, or that there is none.
#[test]
fn an_arm_without_inverse_is_told_what_it_can_do() {
    let row = |kind: &str, alpha: f64| format!("  - {{type: {kind}, a: 0.1, alpha: {alpha}, d: 0.1, theta: 0}}\n");
    let rows = [row("revolute", 90.0), row("prismatic", 90.0), row("prismatic", 90.0), row("revolute", 30.0)].concat();
    let file = |name: &str, request: &str| {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let units = "units: {length: m, angle: deg}";
        let text = format!("name: rppr\nconvention: standard\n{units}\n{request}joints:\n{rows}");
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    for request in ["", "inverse: {task: planar_position}\n"] {
        let path = file(&format!("rppr{}.yaml", request.len()), request);
        let output = denhart(&["inverse", &path, "--q", "0 0 0 0"]);
        let text = said(&output.stderr);
        assert_eq!(output.status.code(), Some(1));
        let help = "\nhelp: write `inverse: {task: position, redundant: q1}` in the file, or \
                    `inverse: {task: position, redundant: q2}`, ";
        assert!(text.contains(help), "{text}");
        // What is proposed is there.
        let asked = file("rppr_asked.yaml", "inverse: {task: position, redundant: q1}\n");
        assert!(shown(&["inverse", &asked, "--q", "0 0 0 0"]).contains("task position"));
    }
    let none = denhart(&["inverse", "specs/singular_6r.yaml", "--q", "0 0 0 0 0 0"]);
    assert!(said(&none.stderr).contains("\nhelp: this arm has a closed form for no task"), "{none:?}");
}

/// A joint to give that the arm cannot spare.
#[test]
fn an_inverse_that_is_not_as_asked_for_is_told_and_strict_fails() {
    let ur5 = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml")).unwrap();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("spared.yaml");
    std::fs::write(&path, ur5.replace("{task: pose}", "{redundant: q3}")).unwrap();
    let path = path.to_str().unwrap();
    let text = shown(&["check", path]);
    let reason = "`redundant: q3` leaves 5 joints, fewer than `pose` needs; leaving out `redundant` works";
    assert!(
        text.contains(&format!("spared.yaml:6:10: warning: there is no inverse as the file asks for: {reason}")),
        "{text}"
    );
    assert!(text.contains("= help: write `inverse: {task: pose}`"), "{text}");
    let strict = denhart(&["check", "--strict", path]);
    assert_eq!(strict.status.code(), Some(1), "{strict:?}");
    assert_eq!(denhart(&["check", "--strict", "specs/ur5.yaml"]).status.code(), Some(0));
    let output = denhart(&["inverse", path, "--q", "0 0 0 0 0 0"]);
    assert!(said(&output.stderr).contains("\nhelp: write `inverse: {task: pose}` in the file"), "{output:?}");
}
