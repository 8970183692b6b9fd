//! Every arm file of `specs/` and `arms/` is in a list whose arms are compared.

use std::fs;
use std::path::{Path, PathBuf};

/// Lists of the suites that compare every arm of theirs; `main.rs` those that no other suite has.
const LISTS: [&str; 9] = [
    "tests/tasks",
    "tests/given",
    "tests/held_joint",
    "tests/parameters/arms.rs",
    "tests/parameters/kernel_arms.rs",
    "tests/found.rs",
    "tests/calibration.rs",
    "tests/dynamic/main.rs",
    "src/arms/made_up.rs",
];

/// Files of `specs/` that `inverse` and this suite compare by their kind.
macro_rules! by_kind {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        [$((stringify!($kind), $file)),*]
    };
}

fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The files below a path, or the path itself.
fn files(path: PathBuf) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path];
    }
    let entries = fs::read_dir(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    entries.flat_map(|entry| files(entry.unwrap().path())).collect()
}

#[test]
fn every_arm_file_is_compared() {
    let lists: String =
        LISTS.iter().flat_map(|list| files(folder(list))).map(|p| fs::read_to_string(p).unwrap()).collect();
    let published = denhart_tests::published_arms!(by_kind);
    let compared = |file: &str| {
        lists.contains(&format!("\"{file}\""))
            || published.iter().any(|(kind, path)| *path == file && !matches!(*kind, "task" | "held"))
    };
    let all: Vec<String> = [("arms", "arms"), ("../specs", "../specs")]
        .iter()
        .flat_map(|(below, prefix)| {
            let root = folder(below);
            let relative =
                move |path: PathBuf| format!("{prefix}/{}", path.strip_prefix(&root).unwrap().to_str().unwrap());
            files(folder(below)).into_iter().map(relative)
        })
        .filter(|file| file.ends_with(".yaml"))
        .collect();
    assert!(all.len() > 250, "{} files", all.len());
    let missing: Vec<_> = all.iter().filter(|file| !compared(file)).collect();
    assert!(missing.is_empty(), "no suite compares {missing:?}");
}
