//! Doc comments begin with the thing they describe, or with what a function returns.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

/// Beginnings that leave the subject to be guessed.
const BEGINNINGS: [&str; 5] = ["What", "Whether", "By how much", "The same", "Those"];

/// Folders of files that nobody writes by hand.
const SKIPPED: [&str; 2] = ["target", "snapshots"];

/// The beginning of a doc line in this line of code, if it is one of [`BEGINNINGS`]. Doc lines in texts count: they are
/// docs of generated code.
fn beginning(line: &str) -> Option<&'static str> {
    line.match_indices("//").find_map(|(at, _)| {
        let text = line[at + 2..].strip_prefix(['/', '!'])?.strip_prefix(' ')?;
        BEGINNINGS.into_iter().find(|words| {
            text.strip_prefix(words).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
        })
    })
}

/// Calls `visit` with each Rust file under `folder`: its path from `root`, and its text.
fn each_file(root: &Path, folder: &Path, visit: &mut impl FnMut(&str, &str)) {
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if !name.starts_with('.') && !SKIPPED.contains(&name.as_str()) {
                each_file(root, &path, visit);
            }
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let file = path.strip_prefix(root).unwrap().display().to_string();
            visit(&file, &fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn a_beginning_is_found_in_any_doc_line() {
    for words in BEGINNINGS {
        for mark in ["///", "//!"] {
            assert_eq!(beginning(&format!("    {mark} {words} it is.")), Some(words));
            assert_eq!(beginning(&format!("code += \"{mark} {words}\";")), Some(words));
        }
        assert_eq!(beginning(&format!("// {words} it is.")), None, "a comment, not a doc line");
        assert_eq!(beginning(&format!("/// {words}ever it is.")), None, "a longer word");
        assert_eq!(beginning(&format!("/// {} it is.", words.to_lowercase())), None, "the middle of a sentence");
    }
}

#[test]
fn doc_lines_begin_with_a_subject() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut files, mut found) = (Vec::new(), Vec::new());
    each_file(&root, &root, &mut |file, text| {
        let lines = (1..).zip(text.lines());
        found.extend(
            lines
                .filter(|(_, line)| beginning(line).is_some())
                .map(|(number, line)| format!("{file}:{number}: {}", line.trim())),
        );
        files.push(file.to_owned());
    });
    for file in ["runtime/src/lib.rs", "codegen/src/lib.rs", "cli/src/main.rs", "firmware/host/src/main.rs", file!()] {
        assert!(files.iter().any(|found| found.replace('\\', "/") == file.replace('\\', "/")), "{file} is not read");
    }
    assert!(
        found.is_empty(),
        "{} doc lines do not say what they describe:\n{}\nhelp: begin with the thing (`Residual of ..`), with `Returns \
         true if ..` for a function, or with `True if ..` for a field",
        found.len(),
        found.join("\n")
    );
}
