//! The generator is a pipeline: each stage imports only itself and the stages before it.

use std::fs;
use std::path::Path;

/// The stages in the order of the data.
const STAGES: [&str; 7] = ["spec", "model", "symbolic", "kinematics", "solve", "lower", "emit"];

/// Notes every line under `folder` that names one of the `later` stages, as `file:line: text`.
fn later_imports(folder: &Path, later: &[&str], found: &mut Vec<String>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            later_imports(&path, later, found);
            continue;
        }
        for (index, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
            let names = |word: &str| later.iter().any(|stage| word.split("::").take(2).eq(["crate", stage]));
            // A grouped `use crate::{..}` would hide the stage on a line of its own.
            if !line.trim_start().starts_with("//") && (words.any(names) || line.contains("crate::{")) {
                found.push(format!("{}:{}: {}", path.display(), index + 1, line.trim()));
            }
        }
    }
}

#[test]
fn no_stage_imports_a_later_one() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../codegen/src");
    let mut found = Vec::new();
    for (index, stage) in STAGES.iter().enumerate() {
        later_imports(&source.join(stage), &STAGES[index + 1..], &mut found);
    }
    assert!(found.is_empty(), "a stage imports a later one:\n{}", found.join("\n"));
}
