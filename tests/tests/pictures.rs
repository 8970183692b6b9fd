//! The pictures of README.md and of the pages of `docs/` are those that the command draws now.
//!
//! A comment above a picture has its command: `<!-- denhart draw ARM .. -->`, or `trace` or `follow` in place of `draw`, without
//! the file that it writes. `DENHART_ACCEPT=1 cargo test -p denhart-tests --no-default-features --test pictures` draws them.
#![allow(clippy::unwrap_used, clippy::panic)]

#[allow(dead_code)] // The parts for fences.
mod pages;

use std::fs;
use std::path::{Path, PathBuf};

use pages::{Page, pages, words};

/// Least number of pictures. Fewer: the comments are not found.
const LEAST: usize = 11;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The picture that a command draws: the text of its SVG file.
fn drawn(page: &Page, command: &str, name: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    fs::create_dir_all(&folder).unwrap();
    let picture = folder.join(name);
    // An arm file or a path of the page, or one of the repository.
    let argument = |word: String| {
        if !word.ends_with(".yaml") && !word.ends_with(".csv") {
            return word;
        }
        let shown = page.fences.iter().find(|fence| fence.file.as_deref() == Some(&word));
        let text = shown.map_or_else(|| fs::read_to_string(root().join(&word)).unwrap(), |fence| fence.content.clone());
        let file = folder.join(word.replace('/', "_"));
        fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let arguments = words(command).into_iter().map(argument);
    let option = if command.contains(" draw ") { "-o" } else { "--plot" };
    let arguments: Vec<String> = arguments.chain([option.to_owned(), picture.display().to_string()]).collect();
    let (mut out, mut errors) = (Vec::new(), Vec::new());
    let status = denhart_cli::run(&arguments, &mut out, &mut errors);
    // A target out of reach is drawn, and said.
    assert!([0, 3].contains(&status), "{}: {command}: {}", page.path, String::from_utf8_lossy(&errors));
    fs::read_to_string(picture).unwrap()
}

#[test]
fn pictures_are_current() {
    let accept = std::env::var_os("DENHART_ACCEPT").is_some();
    let (mut found, mut old) = (0, Vec::new());
    for page in pages(&root()) {
        for (line, next) in page.text.lines().zip(page.text.lines().skip(1)) {
            let Some(command) = line.strip_prefix("<!-- denhart ").and_then(|rest| rest.strip_suffix(" -->")) else {
                continue;
            };
            let link = next.split_once("](").and_then(|(_, rest)| rest.split_once(')'));
            let (path, _) = link.unwrap_or_else(|| panic!("{}: no picture below `{line}`", page.path));
            let file = root().join(&page.path).parent().unwrap().join(path);
            let name = file.file_name().unwrap().to_string_lossy().into_owned();
            let text = drawn(&page, &format!("denhart {command}"), &name);
            found += 1;
            if accept {
                fs::write(&file, &text).unwrap();
            }
            if fs::read_to_string(&file).unwrap_or_default() != text {
                old.push(format!("{}: {path}", page.path));
            }
        }
    }
    assert!(
        old.is_empty(),
        "not current: {old:?}\nDENHART_ACCEPT=1 cargo test -p denhart-tests --no-default-features --test pictures"
    );
    assert!(found >= LEAST, "{found} pictures are found");
}
