//! The crates as they are published: documentation with its features, examples that work from the package.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// Runs cargo in the repository, which must succeed; its output.
fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO")).args(arguments).arg("--offline").current_dir(root()).output().unwrap();
    assert!(output.status.success(), "cargo {arguments:?}:\n{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// docs.rs builds every feature of a published library that is not for tests, and marks the items that need one.
#[test]
fn docs_rs_shows_the_features() {
    let metadata: Value = serde_json::from_str(&cargo(&["metadata", "--no-deps", "--format-version", "1"])).unwrap();
    let mut with_features = 0;
    for package in metadata["packages"].as_array().unwrap() {
        let features = package["features"].as_object().unwrap();
        // An empty list of registries: the package is not published.
        if features.is_empty() || !package["publish"].is_null() {
            continue;
        }
        with_features += 1;
        let name = package["name"].as_str().unwrap();
        let docs = &package["metadata"]["docs"]["rs"];
        let by_default: Vec<&Value> = features["default"].as_array().unwrap().iter().collect();
        let named: Vec<&Value> = docs["features"].as_array().into_iter().flatten().collect();
        for feature in features.keys().filter(|feature| !["default", "count"].contains(&feature.as_str())) {
            let shown = by_default.iter().chain(&named).any(|shown| shown.as_str() == Some(feature));
            assert!(shown || docs["all-features"] == true, "{name}: docs.rs has no {feature}");
        }
        let arguments = docs["rustdoc-args"].as_array().unwrap();
        assert!(arguments.iter().any(|argument| argument == "docsrs"), "{name}: {arguments:?}");
        let manifest = Path::new(package["manifest_path"].as_str().unwrap());
        let library = fs::read_to_string(manifest.parent().unwrap().join("src/lib.rs")).unwrap();
        assert!(library.contains("#![cfg_attr(docsrs, feature(doc_cfg))]"), "{name}: items without their feature");
    }
    assert_eq!(with_features, 6);
}

/// Every example is in the package with the arm file that it reads, a copy of the one in `specs/`.
#[test]
fn examples_work_from_the_package() {
    let packed = cargo(&["package", "--list", "--allow-dirty", "-p", "denhart"]);
    let packed: Vec<&str> = packed.lines().collect();
    let mut examples = 0;
    for entry in fs::read_dir(root().join("runtime/examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        examples += 1;
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(packed.contains(&format!("examples/{name}").as_str()), "{name}");
        let code = fs::read_to_string(&path).unwrap();
        let arms: Vec<&str> = code.split("spec = \"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        assert!(!arms.is_empty(), "{name} reads no arm file");
        for arm in arms {
            assert!(packed.contains(&arm), "{name}: {arm} is not in the package");
            let copy = fs::read_to_string(root().join("runtime").join(arm)).unwrap();
            let original = root().join("specs").join(Path::new(arm).file_name().unwrap());
            assert_eq!(copy, fs::read_to_string(&original).unwrap(), "{arm} differs from {}", original.display());
        }
    }
    assert!(examples >= 6, "{examples} examples are found");
}
