//! The files, and what the command refuses.

use std::fs;

use crate::tools::{denhart, folder, root};

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
