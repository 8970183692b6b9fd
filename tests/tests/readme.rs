//! The code in README.md works as it stands: every crate it shows, with the one arm file it shows, is built and run.
#![allow(clippy::unwrap_used)]

mod user_crate;

use std::fs;

use user_crate::{UserCrate, root};

/// The files shown in README.md: a line with the file's name in backticks, then its content between fences.
fn files(readme: &str) -> Vec<(&str, String)> {
    let mut files = Vec::new();
    let mut lines = readme.lines().peekable();
    while let Some(line) = lines.next() {
        let name = line.strip_prefix('`').and_then(|rest| rest.strip_suffix('`')).filter(|name| !name.contains('`'));
        if let Some(name) = name
            && lines.next_if(|next| next.starts_with("```")).is_some()
        {
            let content: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            files.push((name, content.join("\n") + "\n"));
        }
    }
    files
}

#[test]
fn every_crate_of_the_readme_works() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let files = files(&readme);
    let (_, arm) = files.iter().find(|(name, _)| *name == "arm.yaml").unwrap();
    let (_, manifest) = files.iter().find(|(name, _)| *name == "Cargo.toml").unwrap();
    // A crate shown without its manifest has that of the first one.
    let begins = |name: &str, before: &str| name == "Cargo.toml" || name == "planar.yaml" || name == before;
    let crates: Vec<_> = files.chunk_by(|(before, _), (name, _)| !begins(name, before)).collect();
    assert_eq!(crates.len(), 5, "a derive, a build script, a microcontroller, parameters, iteration");
    for (number, files) in crates.into_iter().enumerate() {
        let user = UserCrate::new(&format!("readme_{number}"), "");
        user.write("arm.yaml", arm);
        for (name, content) in [&("Cargo.toml", manifest.clone())].into_iter().chain(files) {
            let here = content.replace("../denhart", &root().display().to_string());
            user.write(name, &if *name == "Cargo.toml" { here + "\n[workspace]\n" } else { here });
        }
        if files.iter().any(|(name, _)| *name == "src/main.rs") {
            assert!(!user.succeeds(&["run"]).is_empty());
        } else {
            user.succeeds(&["check"]);
        }
        // As the README says of a mistake in the file.
        if files.iter().any(|(_, content)| content.contains("\"arm.yaml\"")) {
            user.write("arm.yaml", &arm.replace("alpha: -90, ", ""));
            let errors = user.fails(&["check"]);
            assert!(errors.contains("arm.yaml:9:") && errors.contains("has no `alpha`"), "{errors}");
        }
    }
}

/// The commands of the README for the test and the main example are those that the repository is checked with.
#[test]
fn the_commands_of_the_readme_are_checked() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let check = fs::read_to_string(root().join(".ci/run")).unwrap();
    for command in ["cargo test --workspace", "cargo run --release --example ur5"] {
        assert!(readme.lines().any(|line| line.starts_with(command)), "{command}");
        assert!(check.contains(command) || check.contains(&command.replace("run", "run --quiet")), "{command}");
    }
}
