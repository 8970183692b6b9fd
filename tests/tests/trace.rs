//! `denhart trace`: the published table of the Denso VS-6556, rates beside differences of the poses, and mistakes.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data")
}

fn spec(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../specs/{name}.yaml")).display().to_string()
}

/// Exit status, output, messages.
fn denhart(arguments: &[&str]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = denhart_cli::run([&["denhart"], arguments].concat(), &mut out, &mut err);
    (status, String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

/// Rows by column name.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn parse(text: &str) -> Self {
        let mut lines = text.lines();
        let header: Vec<String> = lines.next().unwrap().split(',').map(str::to_owned).collect();
        let number = |cell: &str| cell.parse::<f64>().unwrap_or_else(|error| panic!("{cell}: {error}"));
        let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(number).collect()).collect();
        assert!(rows.iter().all(|row| row.len() == header.len()), "{text}");
        Self { header, rows }
    }

    fn trace(arguments: &[&str]) -> Self {
        let (status, out, err) = denhart(&[&["trace"], arguments].concat());
        assert_eq!((status, err.as_str()), (0, ""));
        Self::parse(&out)
    }

    /// The columns of these names, row by row.
    fn columns<const N: usize>(&self, names: [&str; N]) -> Vec<[f64; N]> {
        let place = |name| self.header.iter().position(|known| known == name).unwrap_or_else(|| panic!("{name}"));
        let places = names.map(place);
        self.rows.iter().map(|row| places.map(|place| row[place])).collect()
    }
}

#[derive(Deserialize)]
struct Published {
    denso_vs6556_trajectory: Vec<Row>,
}

/// A row of table 2 of Nguyen, Pham and Chi 2023, by 50 digit arithmetic: s, degrees, mm.
#[derive(Deserialize)]
struct Row {
    t: f64,
    q_deg: [f64; 6],
    #[serde(rename = "X")]
    x: f64,
    #[serde(rename = "Y")]
    y: f64,
    #[serde(rename = "Z")]
    z: f64,
    #[serde(rename = "R")]
    r: [[f64; 3]; 3],
}

const DENSO: &str = "3t, -90+3t, 90+3t, 3t, 3t, 3t";

/// The paper prints seven digits behind the point; 5e-7 mm is what it can be held to. Beside the exact values, rounding
/// is 1e-13 of a reach of 1.2 m.
#[test]
fn the_denso_trajectory() {
    let text = fs::read_to_string(data().join("published_tables.json")).unwrap();
    let Published { denso_vs6556_trajectory: expected } = serde_json::from_str(&text).unwrap();
    assert_eq!(expected.len(), 11);
    let arguments = [&spec("denso_vs6556"), "--law", DENSO, "--from", "0", "--to", "10", "--step", "1"];
    let table = Table::trace(&[&arguments[..], &["--orientation", "matrix"]].concat());
    let times: Vec<[f64; 1]> = table.columns(["t"]);
    assert_eq!(times, expected.iter().map(|row| [row.t]).collect::<Vec<_>>());
    let joints = table.columns(["q1", "q2", "q3", "q4", "q5", "q6"]);
    let positions = table.columns(["x", "y", "z"]);
    let rotations = table.columns(["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"]);
    for (row, ((q, p), r)) in expected.iter().zip(joints.iter().zip(&positions).zip(&rotations)) {
        assert_eq!(*q, row.q_deg);
        for (found, expected) in p.iter().zip([row.x, row.y, row.z]) {
            assert!((found - expected).abs() < 5e-7, "t = {}: {found} for {expected}", row.t);
            assert!((found - expected).abs() < 1.2e-10, "t = {}: {found} for {expected}", row.t);
        }
        for (found, expected) in r.iter().zip(row.r.as_flattened()) {
            assert!((found - expected).abs() < 1e-13, "t = {}: {found} for {expected}", row.t);
        }
    }
}

/// Velocity and acceleration are the derivatives of the positions printed. Angular velocity is that of the matrices
/// printed, and angular acceleration is the derivative of the angular velocity printed. Central differences of step h =
/// 0.001 s are off by `h^2` of the fourth derivatives at most.
#[test]
fn rates_are_those_of_the_motion() {
    let laws = "20 sin(2 pi t / 5), -90 + 3t^2, 90 - 10 exp(-t/2) t, 30/(1+t), 40 sqrt(1 + t), 5t - t^3/9";
    let h = 1e-3;
    for units in ["deg", "rad"] {
        let common = ["--law", laws, "--from", "1", "--to", "1.1", "--step", "0.001", "--units", units];
        let file = spec("denso_vs6556");
        let table = Table::trace(&[&[file.as_str()], &common[..], &["--orientation", "matrix"]].concat());
        assert_eq!(table.rows.len(), 101);
        let positions = table.columns(["x", "y", "z"]);
        let rotations = table.columns(["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"]);
        let velocities = table.columns(["vx", "vy", "vz"]);
        let accelerations = table.columns(["ax", "ay", "az"]);
        let turning = table.columns(["wx", "wy", "wz"]);
        let turning_rates = table.columns(["dwx", "dwy", "dwz"]);
        // In rad the same laws turn 57 times as far, so the differences are the less exact.
        let (degree, scale) = if units == "deg" { (std::f64::consts::PI / 180.0, 1.0) } else { (1.0, 57.3) };
        // A joint turns by up to about 1 rad/s (deg), so the tool's fourth derivatives are below 1e4 mm/s^4.
        let tolerance = |power: i32| h * h * 1e4 * f64::powi(scale, power);
        for k in 1..table.rows.len() - 1 {
            for i in 0..3 {
                let velocity = (positions[k + 1][i] - positions[k - 1][i]) / (2.0 * h);
                assert!((velocity - velocities[k][i]).abs() < tolerance(3), "{units}, row {k}, v{i}");
                let second = (positions[k + 1][i] - 2.0 * positions[k][i] + positions[k - 1][i]) / (h * h);
                assert!((second - accelerations[k][i]).abs() < tolerance(4), "{units}, row {k}, a{i}");
                let rate = (turning[k + 1][i] - turning[k - 1][i]) / (2.0 * h);
                assert!((rate - turning_rates[k][i]).abs() * degree < tolerance(3) / 100.0, "{units}, row {k}, dw{i}");
            }
            // w from dR/dt R^T.
            let rate = |i: usize, j: usize| (rotations[k + 1][3 * i + j] - rotations[k - 1][3 * i + j]) / (2.0 * h);
            let product = |i: usize, j: usize| (0..3).map(|n| rate(i, n) * rotations[k][3 * j + n]).sum::<f64>();
            for (axis, (i, j)) in [(2, 1), (0, 2), (1, 0)].into_iter().enumerate() {
                let w = turning[k][axis] * degree;
                assert!((product(i, j) - w).abs() < tolerance(3) / 100.0, "{units}, row {k}, w{axis}");
            }
        }
    }
}

/// A sliding joint's law is in the length unit, whatever the angles are in.
#[test]
fn strokes_are_lengths() {
    let file = spec("cylindrical_rpp");
    let arguments = ["--law", "0, 0.1 + 0.2t, 0.3 t^2", "--to", "1", "--step", "0.5"];
    let in_deg = Table::trace(&[&[file.as_str()], &arguments[..], &["--units", "deg"]].concat());
    let in_rad = Table::trace(&[&[file.as_str()], &arguments[..], &["--units", "rad"]].concat());
    let names = ["t", "q2", "q3", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az"];
    assert_eq!(in_deg.columns(names), in_rad.columns(names));
    assert_eq!(in_deg.columns(["q2", "q3"]), [[0.1, 0.0], [0.2, 0.075], [0.30000000000000004, 0.3]]);
    let speeds: Vec<f64> = in_deg.columns(["vx", "vy", "vz"]).iter().map(|v| v.iter().map(|x| x * x).sum()).collect();
    // The two slides are at right angles: 0.2^2 + (0.6 t)^2.
    for (speed, t) in speeds.iter().zip([0.0, 0.5, 1.0]) {
        assert!((speed - (0.04 + 0.36 * t * t)).abs() < 1e-15, "{speeds:?}");
    }
}

#[test]
fn forms_of_the_orientation() {
    let file = spec("ur5");
    let trace = |form: &str| {
        let laws = "0.1, -0.5 + t, 0.4, 0.2 t, 0.7, 0.3";
        let common = ["--law", laws, "--to", "1", "--step", "0.5", "--units", "rad"];
        Table::trace(&[&[file.as_str()], &common[..], &["--orientation", form]].concat())
    };
    let matrices = trace("matrix").columns(["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"]);
    let rpy = trace("rpy").columns(["roll", "pitch", "yaw"]);
    let quaternions = trace("quaternion").columns(["qw", "qx", "qy", "qz"]);
    for (matrix, (rpy, quaternion)) in matrices.iter().zip(rpy.iter().zip(&quaternions)) {
        let of_rpy = denhart::Pose::from_xyz_rpy([0.0; 3], *rpy);
        let of_quaternion = denhart::Pose::from_xyz_quaternion([0.0; 3], *quaternion).unwrap();
        for pose in [of_rpy, of_quaternion] {
            assert!(pose.rotation.as_flattened().iter().zip(matrix).all(|(a, b)| (a - b).abs() < 1e-14), "{pose}");
        }
    }
}

#[test]
fn the_output_file_is_what_is_printed() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("trace.csv");
    let file = spec("planar2r");
    let arguments = ["trace", &file, "--law", "t, -t", "--from", "-1", "--to", "1", "--step", "0.25"];
    let (status, printed, err) = denhart(&arguments);
    assert_eq!((status, err.as_str(), printed.lines().count()), (0, "", 10));
    let output = path.display().to_string();
    let written = denhart(&[&arguments[..], &["--output", &output]].concat());
    assert_eq!(written, (0, String::new(), String::new()));
    assert_eq!(fs::read_to_string(&path).unwrap(), printed);
    // No place to write to.
    let nowhere = path.join("deeper.csv").display().to_string();
    let (status, _, err) = denhart(&[&arguments[..], &["--output", &nowhere]].concat());
    assert!(status == 1 && err.contains(&nowhere), "{err}");
}

#[test]
fn mistakes_say_what_and_where() {
    let file = spec("planar2r");
    let cases: [(&str, &[&str], u8, &str); 10] = [
        (
            "t, 2*",
            &[],
            2,
            "--law, character 6: expected a number, `t`, `pi`, a function or `(`, found the end\n  t, 2*\n       ^",
        ),
        ("t, 3 + x", &[], 2, "--law, character 8: `x` is unknown"),
        ("t", &[], 2, "1 law for 2 joints; one for each is needed: q1, q2"),
        ("t, t, 5 t", &[], 2, "--law, character 7: 3 laws for 2 joints"),
        ("t, t", &["--from", "2"], 2, "--from 2 is later than --to 1"),
        ("t, t", &["--step", "0"], 2, "--step 0 is not a positive time"),
        ("t, t", &["--step=-1"], 2, "--step -1 is not a positive time"),
        ("t, t", &["--to", "nan"], 2, "--to NaN is not a finite time"),
        ("t, sqrt(t)", &[], 1, "the law `sqrt(t)` has no finite rate at t = 0: inf"),
        ("t, 1/(2t - 1)", &[], 1, "the law `1/(2t - 1)` has no finite value at t = 0.5: inf"),
    ];
    for (laws, more, status, message) in cases {
        let mut arguments = vec!["trace", &file, "--law", laws];
        for (option, value) in [("--to", "1"), ("--step", "0.5")] {
            if !more.iter().any(|given| given.starts_with(option)) {
                arguments.extend([option, value]);
            }
        }
        arguments.extend(more);
        let (found, _, err) = denhart(&arguments);
        assert!(found == status && err.contains(message), "{laws} {more:?}: status {found}\n{err}");
    }
    let (status, _, err) = denhart(&["trace", "no_such.yaml", "--law", "t", "--to", "1", "--step", "1"]);
    assert!(status == 1 && err.contains("no_such.yaml"), "{err}");
}
