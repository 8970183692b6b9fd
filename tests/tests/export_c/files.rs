//! The files, and what the command refuses.

use std::fs;

use crate::tools::{denhart, folder, root, said, succeeds};

/// The files as they are: one with a redundant joint in single precision, one with pulses in double precision.
#[test]
fn the_files() {
    for (arm, scalar) in [("kuka_iiwa7_r800", "f32"), ("salman_rrr", "f64")] {
        let name = format!("files_{arm}");
        let folder = folder(&name);
        let spec = root().join("specs").join(format!("{arm}.yaml"));
        let _ = fs::remove_dir_all(&folder);
        let output = folder.to_str().unwrap();
        denhart(&["export", "c", spec.to_str().unwrap(), "--scalar", scalar, "-o", output], None);
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../snapshots/export_c");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let header = format!("include/{arm}.h");
        for (kind, file) in
            [("header", header.as_str()), ("lib", "src/lib.rs"), ("cargo", "Cargo.toml"), ("cmake", "CMakeLists.txt")]
        {
            let text = fs::read_to_string(folder.join(file)).unwrap();
            // The folder is where this repository is, seen from that of the test.
            let runtime = text.split('"').find(|path| path.ends_with("/runtime")).unwrap_or("/runtime");
            let text = text.replace(runtime, "[denhart]/runtime");
            settings.bind(|| insta::assert_snapshot!(format!("{arm}_{kind}"), text));
        }
        // The code is what `expand` prints.
        let options = denhart_codegen::Builder::new(&spec).type_name("Robot").scalar(scalar);
        assert_eq!(fs::read_to_string(folder.join("src/arm.rs")).unwrap(), options.generate().unwrap());
    }
}

#[test]
fn what_is_there_is_not_overwritten() {
    let spec = root().join("specs/planar2r.yaml");
    let folder = folder("kept");
    let _ = fs::remove_dir_all(&folder);
    let command = ["export", "c", spec.to_str().unwrap(), "-o", folder.to_str().unwrap()];
    denhart(&command, None);
    // The same again is no change.
    denhart(&command, None);
    let library = folder.join("src/lib.rs");
    fs::write(&library, "mine").unwrap();
    denhart(&command, Some("lib.rs` is there already\nhelp: --force overwrites it"));
    assert_eq!(fs::read_to_string(&library).unwrap(), "mine");
    denhart(&[&command[..], &["--force"]].concat(), None);
    assert!(fs::read_to_string(&library).unwrap().contains("planar2r_forward"));
}

#[test]
fn wrong_arguments_are_named() {
    let spec = root().join("specs/planar2r.yaml");
    let folder = folder("refused");
    let command = ["export", "c", spec.to_str().unwrap(), "-o", folder.to_str().unwrap()];
    let with = |more: &[&str], says| denhart(&[&command[..], more].concat(), Some(says));
    with(&["--prefix", "2R-arm"], "`2R-arm` cannot name a library for C\nhelp: write `arm_2r_arm`");
    with(&["--prefix", "math"], "`math` cannot name a library for C\nhelp: write `arm_math`");
    with(&["--crate-path", "/no/such/folder"], "--crate-path: cannot read `/no/such/folder/Cargo.toml`");
    let wrong = root().join("codegen");
    with(&["--crate-path", wrong.to_str().unwrap()], "is not the crate denhart");
    with(&["--scalar", "f16"], "invalid value 'f16'");
    assert!(!folder.exists());
}

/// Exports an arm anew; the folder, the output, the errors.
fn exported(spec: &str, name: &str) -> (std::path::PathBuf, String, String) {
    let (spec, folder) = (root().join(spec), folder(name));
    let _ = fs::remove_dir_all(&folder);
    let (status, out, err) = said(&["export", "c", spec.to_str().unwrap(), "-o", folder.to_str().unwrap()]);
    assert_eq!(status, 0, "{err}");
    (folder, out, err)
}

/// Without `--crate-path` the crate is one that cargo finds, and the command says where.
#[test]
fn the_crate_is_found_without_being_named() {
    let (folder, out, err) = exported("specs/planar2r.yaml", "unnamed");
    assert_eq!(err, "");
    let first = out.lines().next().unwrap();
    assert!(first.contains("Cargo.toml: `denhart` is that of `") && first.ends_with("runtime`"), "{out}");
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    let target = self::folder("target");
    let mut cargo = std::process::Command::new(env!("CARGO"));
    succeeds(cargo.args(["check", "--quiet", "--offline"]).current_dir(&folder).env("CARGO_TARGET_DIR", target));
}

/// A library without inverse is one that was not expected: the terminal says why.
#[test]
fn an_arm_without_inverse_is_announced() {
    let (folder, _, err) = exported("specs/singular_6r.yaml", "announced");
    let first = "singular_6r.yaml: the library has no inverse kinematics: the arm is singular everywhere";
    assert!(err.starts_with("warning: ") && err.contains(first) && err.contains("\nhelp: "), "{err}");
    let header = fs::read_to_string(folder.join("include/singular_6r.h")).unwrap();
    assert!(!header.contains("singular_6r_inverse") && !header.contains("singular_6r_target_at"));
}

/// The angle of `position_angle` is written out: joints, signs and the angles of the table.
#[test]
fn the_header_says_the_sum_of_the_angle() {
    for (spec, name, sum) in [
        ("specs/jupiter.yaml", "jupiter", "q[1] + q[2] + q[3]"),
        ("specs/al5d.yaml", "al5d", "q[1] - q[2] + q[3] + 1.5707963267948966"),
        (
            "tests/arms/position_angle/yaw_pitch_turned.yaml",
            "yaw_pitch_turned",
            "q[1] - q[2] + q[3] + 1.5707963267948966",
        ),
        ("tests/arms/position_angle/crane_rrpr.yaml", "crane_rrpr", "q[1] + q[3] + 0.5235987755982989"),
    ] {
        let (folder, _, _) = exported(spec, &format!("angle_{name}"));
        let header = fs::read_to_string(folder.join(format!("include/{name}.h"))).unwrap();
        let said = format!("/** Of the tool in the plane of its links, rad: `{sum}` of the joint values q. */");
        assert!(header.contains(&said), "{sum}: {header}");
        assert!(header.contains(&format!("the tool's angle in the plane, `{sum}`.")), "{sum}: {header}");
        assert!(!header.contains("denhart check"), "{header}");
    }
}
