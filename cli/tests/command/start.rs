//! `denhart new` and `denhart arms`: arm files to start from.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{command, denhart, text};

fn folder(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    directory
}

#[test]
fn each_template_is_written_and_nothing_is_wrong_with_it() {
    let directory = folder("templates");
    for (index, options) in [
        &["--joints", "3"][..],
        &["--joints", "4"],
        &["--joints", "5"],
        &["--joints", "6"],
        &["--joints", "7"],
        &["--scara"],
        &["--joints", "4", "--convention", "modified"],
        &["--scara", "--convention", "modified"],
    ]
    .into_iter()
    .enumerate()
    {
        let name = format!("arm{index}");
        let output = command(&[&["new", &name], options].concat()).current_dir(&directory).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        let path = directory.join(format!("{name}.yaml"));
        let written = fs::read_to_string(&path).unwrap();
        let joints = written.lines().filter(|line| line.starts_with("  - {a: ")).count();
        let asked = if options[0] == "--scara" { 4 } else { options[1].parse().unwrap() };
        assert_eq!(joints, asked, "{written}");
        let checked = denhart(&["check", "--strict", path.to_str().unwrap()]);
        let report = text(&checked.stdout);
        assert!(checked.status.success() && report.contains("\ninverse (task "), "{checked:?}");
        let has_word = options.last() == Some(&"modified");
        assert_eq!(written.contains("\nconvention: modified\n"), has_word, "{written}");
    }
}

#[test]
fn a_known_arm_is_written_under_its_name_or_another() {
    let directory = folder("known");
    let new = |arguments: &[&str]| command(arguments).current_dir(&directory).output().unwrap();
    let original = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml")).unwrap();
    assert!(new(&["new", "--like", "ur5"]).status.success());
    assert_eq!(fs::read_to_string(directory.join("ur5.yaml")).unwrap(), original);
    assert!(new(&["new", "crane", "--like", "ur5"]).status.success());
    let crane = fs::read_to_string(directory.join("crane.yaml")).unwrap();
    assert_eq!(crane, original.replace("\nname: ur5\n", "\nname: crane\n"));
    assert_ne!(crane, original);
    let unknown = new(&["new", "--like", "pumma560"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(text(&unknown.stderr).contains("help: did you mean `puma560`?"), "{unknown:?}");
}

#[test]
fn a_start_is_asked_for_in_one_way() {
    for arguments in [
        &["new"][..],
        &["new", "crane", "--joints", "8"],
        &["new", "crane", "--joints", "4", "--scara"],
        &["new", "--like", "ur5", "--convention", "modified"],
        &["new", "--like", "ur5", "--joints", "6"],
    ] {
        assert_eq!(denhart(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

/// All arms of `specs/`, with what the generator finds in the files there.
#[test]
fn arms_lists_the_arms_that_new_knows() {
    let all: serde_json::Value = serde_json::from_slice(&denhart(&["arms", "--json"]).stdout).unwrap();
    let all = all.as_array().unwrap();
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut names: Vec<String> = fs::read_dir(specs)
        .unwrap()
        .map(|entry| entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    assert_eq!(all.iter().map(|arm| arm["name"].as_str().unwrap()).collect::<Vec<_>>(), names);
    let of = |name: &str| all.iter().find(|arm| arm["name"] == name).unwrap();
    let ur5 = of("ur5");
    assert_eq!((&ur5["joints"], &ur5["task"]), (&"RRRRRR".into(), &"pose".into()));
    assert!(ur5["source"].as_str().unwrap().starts_with("Universal Robots DH table"), "{ur5}");
    assert_eq!(of("scara_rrrp_325_275")["joints"], "RRRP");
    assert_eq!(of("singular_6r")["task"], serde_json::Value::Null);
    let shown = text(&denhart(&["arms"]).stdout);
    let line = shown.lines().find(|line| line.starts_with("franka_panda ")).unwrap();
    let words: Vec<&str> = line.split("  ").filter(|word| !word.is_empty()).map(str::trim).collect();
    assert_eq!(words[..3], ["franka_panda", "RRRRRRR", "pose, q7 given"]);
    assert!(words[3].starts_with("Robotics Toolbox for Python"), "{line}");
}
