//! Numbers, quaternions, matrices and JSON as targets.

use crate::shell::{close, denhart, fed, file, json, said, shown};
use crate::welder;

#[test]
fn six_numbers_of_a_point_and_an_axis_are_no_pose() {
    let welder = welder();
    let answer = json(&["inverse", &welder, "--pose", "300 50 200 0 0 -1", "--json"]);
    close(&answer["target"]["axis"], &[0.0, 0.0, -1.0]);
    close(&answer["target"]["position"], &[300.0, 50.0, 200.0]);
    // The tool's z axis of a solution points downward.
    let q = answer["solutions"][0]["q"].as_array().unwrap();
    let q = q.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    let pose = json(&["forward", &welder, "--q", &q, "--json"]);
    let axis = [0, 1, 2].map(|row| pose["pose"]["matrix"][row][2].as_f64().unwrap());
    assert!((axis[2] + 1.0).abs() < 1e-9, "{axis:?}");
    // A whole pose has a spelling of its own.
    let whole = json(&["inverse", &welder, "--whole-pose", "300 50 200 180 0 0", "--json"]);
    assert_eq!(whole["solutions"].as_array().unwrap().len(), 8);
    close(&whole["target"]["axis"], &[0.0, 0.0, -1.0]);
    for numbers in ["300 50 200 180 0 0", "300 50 200 0 0 0", "300 50 200 0 0 -0.98"] {
        let output = denhart(&["inverse", &welder, "--pose", numbers]);
        let text = said(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains("expected 1\nhelp: ") && text.contains("--pose \"x y z u v w\""), "{text}");
        assert!(text.contains("--whole-pose \"x y z roll pitch yaw\""), "{text}");
    }
    assert!(shown(&["inverse", &welder, "--pose", "300 50 200 0 0 -0.995"]).starts_with("8 solutions"));
    let help = shown(&["inverse", "--help"]);
    assert!(help.contains("position_axis takes \"x y z u v w\"") && help.contains("--whole-pose <NUMBERS>"), "{help}");
}

/// A direction is a unit vector in every spelling.
#[test]
fn an_axis_of_another_length_is_refused_in_json_and_in_columns() {
    let welder = welder();
    for (arguments, text) in [
        (["--json-target", "-"], "{\"position\": [300, 50, 200], \"axis\": [0, 0, -5]}"),
        (["--json-target", "-"], "{\"position\": [300, 50, 200], \"axis\": [0, 0, 0]}"),
        (["--batch", "-"], "x,y,z,u,v,w\n300,50,200,0,0,-3\n"),
    ] {
        let output = fed(&[&["inverse", &welder], &arguments[..]].concat(), text);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(
            said(&output.stderr).contains(", expected 1\nhelp: write the direction as a unit vector"),
            "{output:?}"
        );
    }
}

/// `120,5 40,2 80,7` is three numbers to one who types decimal commas, and six to others: both counts are targets.
#[test]
fn commas_that_may_be_decimal_ones_are_refused() {
    for (arm, numbers, pointed) in [
        ("specs/anthro3r.yaml", "0,5 0,2 0,7", "0.5, 0.2, 0.7"),
        ("specs/planar3r.yaml", "0,5 -0,2 30,5", "0.5, -0.2, 30.5"),
        ("specs/al5d.yaml", "0,2 0,1 0.1 30", "0.2, 0.1, 0.1, 30"),
    ] {
        let output = denhart(&["inverse", arm, "--pose", numbers]);
        let help = format!(
            "--pose: commas stand in numbers or between them\nhelp: write --pose \"{pointed}\", with decimal points"
        );
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{output:?}");
        assert!(said(&output.stderr).contains(&help), "{output:?}");
    }
    for numbers in ["0.5, 0.2, 0.7", "0.5,0.2,0.7", "0.5,0.2,0.7,0,0,0", "0.5, 0.2, 0.7, 0, 0, 0", "0.5 0.2 0.7 0 0 0"]
    {
        let output = denhart(&["inverse", "specs/anthro3r.yaml", "--pose", numbers]);
        assert!(said(&output.stdout).contains("target: point 0.5, 0.2, 0.7 "), "{output:?}");
    }
}

/// A target has one orientation, in as many forms as there are.
#[test]
fn two_orientations_of_one_target_are_refused() {
    let ur5 = ["inverse", "specs/ur5.yaml"];
    let text = "{\"position\": [0.3, 0.1, 0.4], \"rpy\": [0, 90, 0], \"quaternion\": [1, 0, 0, 0]}";
    let output = fed(&[&ur5[..], &["--json-target", "-"]].concat(), text);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("`quaternion` and `rpy` are two orientations"), "{output:?}");
    let quaternion = denhart(&[&ur5[..], &["--quat", "0.3 0 0.3 0.7 0 0.7 0"]].concat());
    assert!(said(&quaternion.stderr).contains("; of length 1 it is 0.707106781, 0, 0.707106781, 0"), "{quaternion:?}");
}

/// A planar arm turns its tool about z alone.
#[test]
fn a_tilt_that_a_planar_arm_cannot_have_is_told() {
    let tilt = "hint: the arm turns its tool about z alone";
    for (pose, told) in [("1 1 0 0 0 30", false), ("1 1 5 90 0 0", true), ("1 1 0 0 180 30", true)] {
        let output = denhart(&["inverse", "specs/planar3r.yaml", "--whole-pose", pose]);
        assert_eq!(said(&output.stdout).contains(tilt), told, "{output:?}");
    }
}

/// The axis x of a tool: its pose for the closest approach has that axis along the direction.
#[test]
fn a_direction_that_is_missed_is_that_of_the_arms_own_axis() {
    let arm = "tests/arms/position_axis/meet_123_x.yaml";
    let far = json(&["inverse", arm, "--pose", "0.67 0.1 0.2 0 1 0", "--json"]);
    assert_eq!((far["status"].as_str(), far["missed"]["what"].as_str()), (Some("unreachable"), Some("direction")));
    let q = far["closest"].as_array().unwrap().iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    let there = json(&["forward", arm, "--q", &q, "--json"]);
    let place = there["pose"]["position"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap());
    assert!(place.zip([0.67, 0.1, 0.2]).all(|(x, y)| (x - y).abs() < 1e-3), "{there}");
    let along = there["pose"]["matrix"][1][0].as_f64().unwrap();
    assert!((along.acos().to_degrees() - far["missed"]["orientation"].as_f64().unwrap()).abs() < 1e-6, "{far}");
}

#[test]
fn the_target_is_repeated_in_words_and_units() {
    let welder = welder();
    for (arguments, words) in [
        (
            &["specs/ur5.yaml", "--pose", "-0.4 -0.2 0.4 90 0 0"][..],
            "point -0.4, -0.2, 0.4 m; roll 90, pitch 0, yaw 0 deg",
        ),
        (&[&welder, "--pose", "300 50 200 0 0 -1"], "point 300, 50, 200 mm; axis z towards 0, 0, -1"),
        (&["specs/al5d.yaml", "--pose", "0.2 0.1 0.1 30"], "point 0.2, 0.1, 0.1 m; angle 30 deg"),
        (&["specs/anthro3r.yaml", "--q", "0 0 0"], "point "),
        (&["specs/planar3r.yaml", "--pose", "0.3 0.2 0.5", "--units", "rad"], "point 0.3, 0.2 cm; phi 0.5 rad"),
        (&["specs/planar2r.yaml", "--pose", "0.3 0.2"], "point 0.3, 0.2 cm"),
    ] {
        let text = said(&denhart(&[&["inverse"], arguments].concat()).stdout);
        let second = text.lines().nth(1).unwrap_or_default();
        assert!(second.starts_with(&format!("target: {words}")), "{arguments:?}: {text}");
        assert!(words == "point " || second.ends_with(words), "{text}");
    }
}

#[test]
fn position_angle_takes_a_pose_that_forward_printed() {
    let arm = "specs/al5d.yaml";
    let printed = shown(&["forward", arm, "--q", "10 20 30 40"]);
    let numbers = |start: &str| {
        let line = printed.lines().find(|line| line.starts_with(start)).unwrap();
        line.split_whitespace().filter(|word| word.parse::<f64>().is_ok()).take(3).collect::<Vec<_>>().join(" ")
    };
    let pose = format!("{} {}", numbers("position"), numbers("roll pitch yaw"));
    for option in ["--pose", "--whole-pose"] {
        let answer = json(&["inverse", arm, option, &pose, "--near", "10 20 30 40", "--json"]);
        assert!((answer["target"]["angle"].as_f64().unwrap() - 120.0).abs() < 1e-6, "{answer}");
        let q: Vec<f64> = answer["solutions"][0]["q"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        assert!(q.iter().zip([10.0, 20.0, 30.0, 40.0]).all(|(x, y)| (x - y).abs() < 1e-4), "{q:?}");
    }
    // Two degrees of roll more take the tool out of its plane.
    let output = denhart(&["inverse", arm, "--pose", "0.060864061 0.345177242 0.028602701 90 60 82"]);
    let text = said(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(
        text.contains("misses that plane by 2.0000000")
            && text.contains(" deg\nhelp: ")
            && text.contains("--pose \"0.060864061 0.3451"),
        "{text}"
    );
}

#[test]
fn a_quaternion_and_a_matrix_are_the_pose_that_forward_has() {
    let arm = "specs/puma560.yaml";
    let q = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    let pose = json(&["forward", arm, "--q", "10 20 30 40 50 60", "--json"])["pose"].clone();
    let list = |key: &str| pose[key].to_string().replace(['[', ']'], "");
    let quaternion = format!("{},{}", list("position"), list("quaternion"));
    let rows: Vec<String> = pose["matrix"].as_array().unwrap().iter().map(ToString::to_string).collect();
    let matlab = format!("[{}]", rows[..3].join("; ").replace(['[', ']'], ""));
    for arguments in [
        ["--quat", &quaternion],
        ["--matrix", &list("matrix")],
        ["--matrix", &format!("[{}]", rows.join("\n "))],
        ["--matrix", &matlab],
    ] {
        let near = ["--near", "11 20 30 40 50 60", "--json"];
        let answer = json(&[&["inverse", arm][..], &arguments, &near].concat());
        close(&answer["solutions"][0]["q"], &q);
    }
}

#[test]
fn a_rotation_that_is_none_is_told_with_its_deviation() {
    let arm = "specs/ur5.yaml";
    for (option, numbers, parts) in [
        ("--matrix", "1 0 0 0.3 0 1 0 0.1 0 0 1.1 0.4", ["it is off by 1.05e-1", "write --matrix \"r11 r12"]),
        ("--matrix", "1 0 0 0.3 0 1 0 0.1 0 0 -1 0.4", ["is mirrored", "row by row"]),
        ("--matrix", "1 0 0 0 0 1 0 0 0 0 1 0 .3 .1 .4 1", ["this is column by column", "row by row"]),
        ("--matrix", "1 0 0 0 1 0 0 0 1", ["9 numbers, but a matrix has 12 or 16", "3 rows of 4"]),
        ("--quat", "0.3 0.1 0.4 0 1 0 0.5", ["has length 1.118033989, expected 1", "scalar part qw before"]),
        ("--quat", "0.3 0.1 0.4 0 0 0 0", ["has length 0", "scalar part"]),
        ("--quat", "0.3 0.1 0.4 1 0 0", ["6 numbers, but 7 are needed", "write --quat \"x y z qw qx qy qz\""]),
        ("--whole-pose", "0.3 0.1 0.4", ["3 numbers, but 6 are needed", "write --whole-pose"]),
    ] {
        let output = denhart(&["inverse", arm, option, numbers]);
        let text = said(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(parts.iter().all(|part| text.contains(part)) && text.contains("\nhelp: "), "{text}");
    }
}

#[test]
fn json_of_forward_and_of_inverse_is_a_target() {
    let welder = welder();
    for (arm, q) in [
        ("specs/puma560.yaml", "10 20 30 40 50 60"),
        ("specs/al5d.yaml", "10 20 30 40"),
        ("specs/anthro3r.yaml", "10 20 30"),
        ("specs/planar3r.yaml", "10 20 30"),
        ("specs/planar2r.yaml", "10 20"),
        (&welder, "10 20 30 40 50"),
    ] {
        let expected: Vec<f64> = q.split(' ').map(|x| x.parse().unwrap()).collect();
        let of_forward = said(&denhart(&["forward", arm, "--q", q, "--json"]).stdout);
        // The units of the text count before those of the command.
        let of_inverse = fed(&["inverse", arm, "--json-target", "-", "--json", "--units", "rad"], &of_forward);
        for text in [of_forward, said(&of_inverse.stdout)] {
            let output = fed(&["inverse", arm, "--json-target", "-", "--near", q, "--json"], &text);
            let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            close(&answer["solutions"][0]["q"], &expected);
        }
    }
}

#[test]
fn json_that_is_no_target_is_told() {
    for (text, part) in [
        ("{\"position\": [1, 2, 3]}", "<stdin>: the task `pose` needs a whole pose: found `position`, 3 numbers"),
        ("{\"position\": [1, 2, 3], \"rpy\": \"0 0 0\"}", "`rpy` is \"0 0 0\", expected numbers in brackets"),
        (
            "{\"length_unit\": \"mm\", \"position\": [1, 2, 3]}",
            "`length_unit` is \"mm\", but the arm's lengths are in m",
        ),
        ("{\"position\": [1, 2,", "not JSON: EOF while parsing a value at line 1 column 19"),
        ("[1, 2]", "expected a JSON object"),
    ] {
        let output = fed(&["inverse", "specs/ur5.yaml", "--json-target", "-"], text);
        let said = said(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(part), "{said}");
    }
    let twice = fed(&["inverse", "-", "--json-target", "-"], "");
    assert!(said(&twice.stderr).contains("either the arm or its targets"), "{twice:?}");
    let none = denhart(&["inverse", "specs/ur5.yaml", "--json-target", "no_such.json"]);
    assert_eq!(none.status.code(), Some(1), "{none:?}");
    let path = file("targets_pose.json", "{\"position\": [0.3, 0.1, 0.4], \"rpy\": [180, 0, 0]}");
    assert!(shown(&["inverse", "specs/ur5.yaml", "--json-target", &path]).starts_with("8 solutions"));
}

/// Keys of the user's own do not count, however near to a key that is read.
#[test]
fn keys_of_the_user_do_not_count() {
    for key in ["rotation", "target_id", "angles", "length", "quat", "name", "pos"] {
        let text = format!("{{\"position\": [0.3, 0.2, 0.4], \"rpy\": [180, 0, 0], \"{key}\": 1}}");
        let output = fed(&["inverse", "specs/ur5.yaml", "--json-target", "-"], &text);
        assert_eq!(output.status.code(), Some(0), "{key}: {output:?}");
    }
    let text = "{\"position\": [0.3, 0.2, 0.4], \"rpy\": [3, 0, 0], \"angle_unti\": \"rad\"}";
    let output = fed(&["inverse", "specs/ur5.yaml", "--json-target", "-"], text);
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && told.contains("did you mean `angle_unit`?"), "{told}");
}
