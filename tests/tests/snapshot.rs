//! The generated code of every arm of `specs/`, and what `denhart check` says about it, as they were last reviewed.
//!
//! `cargo insta review` shows what changed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use denhart_codegen::Options;

/// Bounds on the source of one arm: it is meant to be read.
const MOST_LINES: usize = 1000;
const LONGEST_LINE: usize = 200;

fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs")
}

fn read(name: &str) -> String {
    let path = specs().join(format!("{name}.yaml"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Keeps `text` in `snapshots/<folder>/<name>.snap`.
fn keep(folder: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new("snapshots").join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

fn check_code(name: &str, type_name: &str) {
    let generated = denhart_codegen::generate(&read(name), &format!("specs/{name}.yaml"), &Options::new(type_name))
        .unwrap_or_else(|errors| panic!("{errors}"));
    let code = generated.to_file().unwrap_or_else(|errors| panic!("{errors}"));
    let lines = code.lines().count();
    assert!(lines <= MOST_LINES, "{name}: {lines} lines");
    for (index, line) in code.lines().enumerate() {
        assert!(line.chars().count() <= LONGEST_LINE, "{name}: line {} is too long:\n{line}", index + 1);
    }
    keep("code", name, &code);
}

fn check_report(name: &str) {
    let report =
        denhart_codegen::check(&read(name), &format!("specs/{name}.yaml")).unwrap_or_else(|errors| panic!("{errors}"));
    keep("report", name, &report.to_string());
}

macro_rules! snapshot_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $attribute:tt;)*) => {
        mod code {
            $(#[test]
            fn $name() {
                super::check_code(stringify!($name), stringify!($Type));
            })*
        }

        mod report {
            $(#[test]
            fn $name() {
                super::check_report(stringify!($name));
            })*
        }

        /// The list of arms is the folder `specs/`.
        #[test]
        fn every_file_is_listed() {
            let listed = BTreeSet::from([$(stringify!($name).to_owned()),*]);
            let files = std::fs::read_dir(specs()).expect("specs/ can be read");
            let stems = files.map(|file| file.expect("specs/ can be read").path());
            let found: BTreeSet<String> = stems
                .filter(|path| path.extension().is_some_and(|extension| extension == "yaml"))
                .map(|path| path.file_stem().expect("a file has a name").to_string_lossy().into_owned())
                .collect();
            assert_eq!(listed, found);
        }
    };
}

denhart_tests::published_arms!(snapshot_tests);
