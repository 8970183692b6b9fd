//! Every dependency can be used under a license of `deny.toml`: what `cargo deny` checks, without it.
#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// The licenses for all crates, and those for one crate alone.
fn allowed() -> (BTreeSet<String>, BTreeMap<String, BTreeSet<String>>) {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../deny.toml")).unwrap();
    let list = text.split("\nallow = [").nth(1).unwrap().split(']').next().unwrap();
    let all = list.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    let mut alone: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for line in text.lines().filter(|line| line.trim_start().starts_with("{ allow = [")) {
        let words: Vec<&str> = line.split('"').skip(1).step_by(2).collect();
        if let [licenses @ .., name] = words.as_slice() {
            alone.entry((*name).to_owned()).or_default().extend(licenses.iter().map(|license| (*license).to_owned()));
        }
    }
    (all, alone)
}

/// Returns true if an expression of licenses can be met: `OR` by one side, `AND` by both.
fn met(expression: &str, holds: &dyn Fn(&str) -> bool) -> bool {
    /// The parts between an operator that stands outside parentheses.
    fn parts<'e>(expression: &'e str, operator: &str) -> Vec<&'e str> {
        let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
        for (at, letter) in expression.char_indices() {
            match letter {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ if depth == 0 && expression[at..].starts_with(operator) => {
                    parts.push(&expression[start..at]);
                    start = at + operator.len();
                }
                _ => {}
            }
        }
        parts.push(&expression[start..]);
        parts
    }
    let expression = expression.trim();
    let either = parts(expression, " OR ");
    if either.len() > 1 {
        return either.iter().any(|part| met(part, holds));
    }
    let both = parts(expression, " AND ");
    if both.len() > 1 {
        return both.iter().all(|part| met(part, holds));
    }
    match expression.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        Some(inside) => met(inside, holds),
        None => holds(expression),
    }
}

#[test]
fn expressions_are_read() {
    let holds = |license: &str| ["MIT", "Unicode-3.0"].contains(&license);
    for (expression, expected) in [
        ("MIT", true),
        ("GPL-3.0-only", false),
        ("GPL-3.0-only OR MIT", true),
        ("(MIT OR Apache-2.0) AND Unicode-3.0", true),
        ("MIT AND GPL-3.0-only", false),
        ("(GPL-3.0-only AND MIT) OR Zlib", false),
    ] {
        assert_eq!(met(expression, &holds), expected, "{expression}");
    }
}

#[test]
fn licenses_are_those_that_are_allowed() {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("../Cargo.toml");
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--all-features", "--locked", "--manifest-path"])
        .arg(manifest)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).unwrap();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let packages: BTreeMap<String, &Value> =
        metadata["packages"].as_array().unwrap().iter().map(|package| (text(&package["id"]), package)).collect();
    let nodes: BTreeMap<String, &Value> =
        metadata["resolve"]["nodes"].as_array().unwrap().iter().map(|node| (text(&node["id"]), node)).collect();
    // What the members need: a lock file has more.
    let mut todo: Vec<String> = metadata["workspace_members"].as_array().unwrap().iter().map(text).collect();
    let mut needed = BTreeSet::new();
    while let Some(id) = todo.pop() {
        if needed.insert(id.clone()) {
            todo.extend(nodes[&id]["dependencies"].as_array().unwrap().iter().map(text));
        }
    }
    assert!(needed.len() > 80, "{}", needed.len());
    let (all, mut alone) = allowed();
    let mut wrong = Vec::new();
    for package in needed.iter().map(|id| packages[id]) {
        let (name, license) = (text(&package["name"]), text(&package["license"]));
        // The spelling of old manifests.
        let license = license.replace('/', " OR ");
        let own = alone.get(&name).cloned().unwrap_or_default();
        if !met(&license, &|one| all.contains(one) || own.contains(one)) {
            wrong.push(format!("{name}: {license}"));
        } else if !own.is_empty() && met(&license, &|one| all.contains(one)) {
            wrong.push(format!("{name}: its exception is not needed"));
        } else {
            alone.remove(&name);
        }
    }
    assert!(wrong.is_empty(), "licenses that deny.toml does not allow:\n{}", wrong.join("\n"));
    assert!(alone.is_empty(), "exceptions for crates that are not needed: {:?}", alone.keys());
}
