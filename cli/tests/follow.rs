//! `denhart follow`: a path of poses, and joint values over time.
#![allow(clippy::unwrap_used)]

mod shell;

use serde_json::Value;
use shell::{denhart, fed, file, json, said};

const UR5: &str = "specs/ur5.yaml";
const VELOCITY: f64 = 180.0;
const ACCELERATION: f64 = 900.0;

/// The arguments for a UR5 with rates.
fn ur5<'a>(path: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let rates = ["--max-velocity", "180 180 180 180 180 180", "--max-acceleration", "900 900 900 900 900 900"];
    [&["follow", UR5, "--path", path][..], &rates, more].concat()
}

/// A line before the base, and through it beyond reach.
fn line(name: &str, far: f64) -> String {
    let row = |k: u32| {
        format!("{},{},{},0.4,180,0,0\n", f64::from(k) * 0.25, 0.3 + far * f64::from(k), 0.05 * f64::from(k) - 0.2)
    };
    let rows: String = (0..=8).map(row).collect();
    file(name, &format!("t,x,y,z,roll,pitch,yaw\n{rows}"))
}

/// The columns of CSV by number.
fn columns(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split(',').map(|entry| entry.parse().unwrap_or(f64::NAN)).collect();
    text.lines().skip(1).map(row).collect()
}

#[test]
fn the_path_is_kept_within_the_rates() {
    let path = line("follow_line.csv", 0.0);
    let output = denhart(&ur5(&path, &[]));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = said(&output.stdout);
    assert!(text.starts_with("t,q1,q2,q3,q4,q5,q6,at,branch,tracking,off_by_position,off_by_orientation\n"), "{text}");
    let rows = columns(&text);
    assert!(rows.len() > 2000 && rows[1][0] == 0.001 && rows[30][0] == 0.03, "{:?}", &rows[..2]);
    for window in rows.windows(3).take(rows.len() - 3) {
        for joint in 1..7 {
            let (a, b, c) = (window[0][joint], window[1][joint], window[2][joint]);
            assert!(
                (b - a).abs() <= 1.001e-3 * VELOCITY && (c - 2.0 * b + a).abs() <= 1.05e-6 * ACCELERATION,
                "{window:?}"
            );
        }
    }
    let last = rows.last().unwrap();
    assert!(last[7] == 2.0 && (2.0..2.1).contains(&last[0]), "{last:?}");
    // The tool is where the first and the last pose say.
    for (row, y) in [(&rows[0], -0.2), (last, 0.2)] {
        let q: Vec<String> = row[1..7].iter().map(f64::to_string).collect();
        let pose = json(&["forward", UR5, "--q", &q.join(" "), "--json"]);
        shell::close(&pose["pose"]["position"], &[0.3, y, 0.4]);
    }
    assert!(said(&output.stderr).contains(" s, of a path of 2 s"), "{output:?}");
    // From the first row on the motion is this one; without times it is faster.
    let start = rows[0][1..7].iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    assert_eq!(said(&denhart(&ur5(&path, &["--start", &start])).stdout).lines().count(), rows.len() + 1);
    let untimed = said(&denhart(&ur5(&path, &[])).stdout);
    assert_eq!(untimed, text);
}

#[test]
fn lines_have_names_or_none_or_are_json() {
    let named = line("follow_named.csv", 0.0);
    let expected = said(&denhart(&ur5(&named, &[])).stdout);
    let text = std::fs::read_to_string(&named).unwrap();
    let rows: Vec<&str> = text.lines().skip(1).collect();
    let bare = fed(&ur5("-", &[]), &rows.join("\n"));
    assert_eq!(said(&bare.stdout), expected, "{bare:?}");
    let spaced = fed(&ur5("-", &[]), &rows.join("\n").replace(',', " "));
    assert_eq!(said(&spaced.stdout), expected);
    let objects = rows.iter().map(|row| {
        let entries: Vec<&str> = row.split(',').collect();
        format!("{{\"t\": {}, \"position\": [{}], \"rpy\": [180, 0, 0]}}\n", entries[0], entries[1..4].join(", "))
    });
    let objects = fed(&ur5("-", &[]), &objects.collect::<String>());
    assert_eq!(said(&objects.stdout), expected);
    // Without times the arm goes as fast as it can, and the path has a length.
    let untimed: Vec<&str> = rows.iter().map(|row| row.split_once(',').unwrap().1).collect();
    let output = fed(&ur5("-", &[]), &untimed.join("\n"));
    let found = columns(&said(&output.stdout));
    let last = found.last().unwrap();
    assert!(last[0] < 1.0 && (last[7] - 0.4).abs() < 1e-9, "{last:?}");
    assert!(!said(&output.stderr).contains("of a path of"), "{output:?}");
}

#[test]
fn columns_that_do_not_count_are_named() {
    let text = std::fs::read_to_string(line("follow_columns.csv", 0.0)).unwrap();
    let output = fed(&ur5("-", &[]), &text);
    assert!(!said(&output.stderr).contains("left out"), "{output:?}");
    let output = fed(&ur5("-", &[]), &text.replacen("t,x", "tt,x", 1));
    assert!(said(&output.stderr).contains("<stdin>: left out: tt\n"), "{output:?}");
}

#[test]
fn a_joint_whose_acceleration_alone_has_no_limit_is_named() {
    let rates = "max_velocity: 180";
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/ur5.yaml")).unwrap();
    for (limited, remark) in [(&[0, 1, 3][..], true), (&[], false), (&[0, 1, 2, 3, 4, 5], false)] {
        let mut joint = 0;
        let rows = text.lines().map(|line| {
            if !line.contains("{type:") {
                return format!("{line}\n");
            }
            let acceleration = if limited.contains(&joint) { ", max_acceleration: 900" } else { "" };
            joint += 1;
            format!("{}, {rates}{acceleration} }}\n", line.trim_end().trim_end_matches('}').trim_end())
        });
        let arm = file("follow_some_accelerations.yaml", &rows.collect::<String>());
        let output = denhart(&["follow", &arm, "--path", &line("follow_some.csv", 0.0)]);
        let told = said(&output.stderr);
        let named = told.contains("no max_acceleration of q3, q5, q6: only its velocity is limited");
        assert!(output.status.success() && joint == 6 && named == remark, "{output:?}");
    }
}

#[test]
fn times_are_kept_by_a_tool_that_deviates() {
    let path = line("follow_times.csv", 0.0);
    let output = denhart(&ur5(&path, &["--keep", "time", "--period", "0.004"]));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = said(&output.stdout);
    let rows = columns(&text);
    assert!(rows.len() == 501 && rows.last().unwrap()[0] == 2.0, "{}", rows.len());
    for window in rows.windows(2) {
        assert!(
            (1..7).all(|joint| (window[1][joint] - window[0][joint]).abs() <= 4.000001e-3 * VELOCITY),
            "{window:?}"
        );
    }
    // From rest to the speed of the path the tool lags, and is back.
    assert!(
        text.lines().nth(2).unwrap().contains(",rates,") && text.lines().last().unwrap().contains(",exact,0,0"),
        "{text}"
    );
    assert!(said(&output.stderr).contains("off the path from 0.004 s on, in "), "{output:?}");
    // Half of the reach in a tenth of a second: the end is not met.
    let fast = "t x y z roll pitch yaw\n0 0.3 -0.4 0.4 180 0 0\n0.1 0.3 0.4 0.4 180 0 0\n";
    let output = fed(&ur5("-", &["--keep", "time"]), fast);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let told = said(&output.stderr);
    assert!(
        told.contains("error: the arm is away from the path at its end")
            && told.contains("do not allow it in this time"),
        "{told}"
    );
    assert_eq!(said(&output.stdout).lines().count(), 102);
}

#[test]
fn where_no_continuous_path_exists_time_branch_and_reason_are_named() {
    let path = line("follow_far.csv", 0.1);
    let output = denhart(&ur5(&path, &[]));
    assert_eq!((output.status.code(), output.stdout.len()), (Some(3), 0), "{output:?}");
    let told = said(&output.stderr);
    for part in
        ["error: no continuous path beyond ", " s, on the branch shoulder ", ": the path leaves the reach", "\nhelp: "]
    {
        assert!(told.contains(part), "{told}");
    }
    let found: Value = json(&ur5(&path, &["--json"]));
    let (obstacle, at) = (&found["obstacle"], found["obstacle"]["at"].as_f64().unwrap());
    assert!((1.0..2.0).contains(&at) && obstacle["reason"] == "the path leaves the reach of the branch", "{found}");
    assert!(found["rows"].as_array().unwrap().is_empty() && found["duration"].is_null(), "{found}");
    // A joint that comes to its limit: from this turn of joint 1 on there is no way round.
    let text = std::fs::read_to_string("../specs/ur5.yaml").unwrap();
    let limited = file(
        "follow_limited.yaml",
        &text.replace("theta: 0}", "theta: 0, limits: [-360, 360]}").replacen("a: 0,", "name: pan, a: 0,", 1),
    );
    let turning = |more: &[&str], text: &str| {
        fed(
            &[&["follow", &limited, "--path", "-", "--max-velocity", "180 180 180 180 180 180"][..], more].concat(),
            text,
        )
    };
    let round = (0..=24).map(|k| {
        let angle = f64::from(k) * 15.0 + 20.0;
        let (sin, cos) = angle.to_radians().sin_cos();
        format!("{} {} {} 0.4 180 0 {angle}\n", k, 0.4 * cos, 0.4 * sin)
    });
    let output = turning(&["--json"], &round.clone().collect::<String>());
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), found["obstacle"].is_null()), (Some(0), true), "{}", found["obstacle"]);
    let rows = found["rows"].as_array().unwrap();
    let q = |row: &Value| row["q"].as_array().unwrap().iter().map(|q| q.as_f64().unwrap()).collect::<Vec<_>>();
    let (first, last) = (q(&rows[0]), q(rows.last().unwrap()));
    assert!((last[0] - first[0] - 360.0).abs() < 1e-6, "{first:?} {last:?}");
    assert!(first[0] < 0.0, "{first:?}");
    let mut wound = first.clone();
    wound[0] += 360.0;
    let start = wound.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let output = turning(&["--start", &start], &round.collect::<String>());
    let told = said(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{told}");
    assert!(told.contains(": pan is at its limit and needs a whole turn\n"), "{told}");
}

#[test]
fn the_first_pose_that_no_joints_reach_is_named() {
    let velocity = ["180"; 6].join(" ");
    let follow = |more: &[&str], text: &str| {
        let output = fed(&[&["follow", UR5, "--path", "-", "--max-velocity", &velocity][..], more].concat(), text);
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        said(&output.stderr)
    };
    let timed = "0 0.3 0.2 0.4 180 0 0\n1 0.3 3 0.4 180 0 0\n2 0.3 4 0.4 180 0 0\n3 0.3 0.2 0.4 180 0 0\n";
    let wanted = "<stdin>:2: no joint values reach this pose, nor those of 1 other line\n";
    for more in [&[][..], &["--keep", "time"]] {
        let told = follow(more, timed);
        assert!(told.ends_with(wanted), "{told}");
    }
    let told = follow(&[], "300 200 400 180 0 0\n300 300 400 180 0 0\n");
    assert!(
        told.contains("<stdin>:1: no joint values") && told.contains("if it is in mm, write 0.3, 0.2, 0.4"),
        "{told}"
    );
    let told = follow(&["--keep", "time"], "0 3 0 0.4 180 0 0\n1 0.3 0.3 0.4 180 0 0\n");
    assert!(told.starts_with("error: no motion begins: no joint values within the limits"), "{told}");
}

#[test]
fn bad_input_names_its_place_and_the_way_out() {
    let good = "0 0.3 -0.2 0.4 180 0 0\n1 0.3 0.2 0.4 180 0 0\n";
    let six = |value: &str| [value; 6].join(" ");
    let velocity = six("180");
    for (text, more, parts) in [
        ("", &[][..], &["<stdin>: no poses", "help: write one a line"][..]),
        ("0 0.3 -0.2 0.4 180 0 0\n", &[], &["<stdin>: a path needs two targets that differ", "two lines at least"]),
        (
            "1 0.3 0 0.4 180 0 0\n# x\n0.5 0.3 0.2 0.4 180 0 0\n",
            &[],
            &["<stdin>:3: the time 0.5 is not above 1, the one before it", "sort the lines"],
        ),
        ("0 0.3 -0.2 0.4 180 0 0\n1 nan 0.2 0.4 180 0 0\n", &[], &["<stdin>:2: `nan` is not a number"]),
        (
            "t,x,y,z,roll,pitch,yaw\nnan,0.3,-0.2,0.4,180,0,0\n",
            &[],
            &["<stdin>:2: `t`: `nan` is not a time", "in s, such as 0.5"],
        ),
        (
            "0.3 -0.2 0.4 180 0 0\n0.3 0.2 0.4 180 0 0\n",
            &["--keep", "time"],
            &["--keep time: <stdin> has no times", "add a column t"],
        ),
        (
            "Time [s],x,y,z,roll,pitch,yaw\n0,0.3,-0.2,0.4,180,0,0\n",
            &[],
            &["<stdin>:1: `Time [s]`: the times of a path have another name", "help: call them t, in s"],
        ),
        ("t_s,x,y,z,roll,pitch,yaw\n0,0.3,-0.2,0.4,180,0,0\n", &[], &["<stdin>:1: `t_s`: the times of a path"]),
        (
            "{\"position\": [0.3, -0.2, 0.4], \"rpy\": [180, 0, 0], \"time\": 0}\n",
            &[],
            &["<stdin>:1: `time`: the times of a path have another name"],
        ),
        ("x,y,t\n1,2,3\n", &[], &["<stdin>:1: the columns x, y, t are no target of the task `pose`"]),
        (good, &["--period", "0"], &["--period: 0 is no time between rows", "above 0, such as 0.001"]),
        (good, &["--period", "1e-9"], &["--period: 0.000000001 s gives ", "write a longer one"]),
        (
            good,
            &["--keep", "time", "--tolerance", "1"],
            &["--tolerance: a tool that keeps the time", "or keep the path"],
        ),
        (
            "{\"positon\": [0.3, -0.2, 0.4], \"rpy\": [180, 0, 0]}\n",
            &[],
            &["<stdin>:1: the key `positon` is not known", "help: did you mean `position`?"],
        ),
        (
            "t,x,y,z,rol,pitch,yaw\n0,0.3,-0.2,0.4,180,0,0\n",
            &[],
            &["<stdin>:1: the columns t, x, y, z, rol", "help: did you mean `roll` by `rol`?"],
        ),
        (good, &["--tolerance", "0"], &["--tolerance: 0 is no distance", "in mm, such as 0.1"]),
        (
            good,
            &["--start", "0 0 0 0 0 0"],
            &[
                "--start: these joint values are not at the first pose",
                "help: the nearest solution there is --start \"",
            ],
        ),
        (
            good,
            &["--keep", "time", "--start", "0 0 0 0 0 0"],
            &["--start: these joint values are not at the first pose"],
        ),
        (
            good,
            &["--max-acceleration", "1 2 3 4 5 0"],
            &["--max-acceleration: 0 of q6 is no rate", "above 0 for each joint"],
        ),
        (good, &["--plot", "joints.png"], &["--plot: `joints.png` is no SVG"]),
    ] {
        let rates = ["--max-velocity", velocity.as_str()];
        let output = fed(&[&["follow", UR5, "--path", "-"][..], &rates, more].concat(), text);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{text} {more:?}: {output:?}");
        let told = said(&output.stderr);
        assert!(parts.iter().all(|part| told.contains(part)), "{text} {more:?}: {told}");
    }
    for (velocity, part) in [
        (six("0"), "--max-velocity: 0 of q1 is no rate"),
        (six("inf"), "`inf` is not a number"),
        ("1 2".to_owned(), "2 values, but the arm has 6 joints"),
    ] {
        let output = fed(&["follow", UR5, "--path", "-", "--max-velocity", &velocity], good);
        assert!(output.status.code() == Some(2) && said(&output.stderr).contains(part), "{output:?}");
    }
    let text = std::fs::read_to_string("../specs/puma560.yaml").unwrap();
    let limited = file("follow_start.yaml", &text);
    let start = ["follow", &limited, "--path", "-", "--max-velocity", &velocity, "--start", "400 0 0 0 0 0"];
    let told = said(&fed(&start, good).stderr);
    assert!(
        told.contains("--start: ") && told.contains(" = 400 is above ") && told.contains("within the limits"),
        "{told}"
    );
    let told = said(&fed(&["follow", UR5, "--path", "-"], good).stderr);
    assert!(
        told.contains("the arm file has no velocity of q1, q2, q3, q4, q5, q6\nhelp: write max_velocity"),
        "{told}"
    );
    let path = file("follow_same.csv", good);
    let told = said(&denhart(&ur5(&path, &["-o", &path])).stderr);
    assert!(told.contains("is --path too\nhelp: name another file"), "{told}");
    assert_eq!(denhart(&ur5("no_such.csv", &[])).status.code(), Some(1));
    assert_eq!(fed(&["follow", "-", "--path", "-"], good).status.code(), Some(2));
}

#[test]
fn rates_of_the_file_and_a_redundant_joint() {
    let text = std::fs::read_to_string("../specs/planar4r_redundant.yaml").unwrap();
    let arm =
        file("follow_planar4r.yaml", &text.replace("theta: 0}", "theta: 0, max_velocity: 90, max_acceleration: 300}"));
    let path = file("follow_planar4r.csv", "0.7 0.2 20\n0.5 0.5 60\n");
    let output = denhart(&["follow", &arm, "--path", &path, "--given", "10"]);
    let rows = columns(&said(&output.stdout));
    assert!(rows.len() > 100 && rows.iter().all(|row| (row[1] - 10.0).abs() < 1e-9), "{output:?}");
    let told = said(&denhart(&["follow", &arm, "--path", &path]).stderr);
    assert!(told.contains("leaves q1 to choose\nhelp: add --given"), "{told}");
    assert!(told.contains("or --start with the joint values to begin at") && !told.contains("--near"), "{told}");
    let lines = |second: &str| {
        format!(
            "{{\"position\": [0.7, 0.2], \"phi\": 20, \"given\": 10}}\n{{\"position\": [0.6, 0.2], \"phi\": 20{second}}}\n"
        )
    };
    for (second, more, part) in [
        ("", &[][..], "<stdin>:2: no `given`, but the first pose has one\nhelp: write it in every line"),
        (", \"given\": 10", &["--given", "10"], "--given: the poses of <stdin> have `given` of their own"),
        (", \"givn\": 10", &[], "<stdin>:2: the key `givn` is not known\nhelp: did you mean `given`?"),
    ] {
        let told = said(&fed(&[&["follow", &arm, "--path", "-"][..], more].concat(), &lines(second)).stderr);
        assert!(told.contains(part), "{told}");
    }
    let start = rows[0][1..5].iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let from = columns(&said(&denhart(&["follow", &arm, "--path", &path, "--start", &start]).stdout));
    assert_eq!(from.len(), rows.len());
}

#[cfg(feature = "draw")]
#[test]
fn the_joints_are_drawn() {
    let path = line("follow_drawn.csv", 0.0);
    let plot = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("follow.svg");
    let table = plot.with_extension("csv");
    let files = ["--plot", plot.to_str().unwrap(), "-o", table.to_str().unwrap(), "--keep", "time"];
    let output = denhart(&ur5(&path, &files));
    assert!(output.status.success() && output.stdout.is_empty(), "{output:?}");
    let picture = std::fs::read_to_string(&plot).unwrap();
    for part in ["<svg", "joints, deg", "velocities, deg/s", "off the path", "q6"] {
        assert!(picture.contains(part), "{part}");
    }
    assert!(std::fs::read_to_string(&table).unwrap().lines().count() > 2000);
}
