//! Pages of the documentation, split into their fences.

use std::fs;
use std::path::{Path, PathBuf};

/// A fence of a page, and its content.
#[derive(Debug, Clone)]
pub struct Fence {
    /// The line of the page, from 1.
    pub line: usize,
    /// The file it shows: the line before it, a name in backticks.
    pub file: Option<String>,
    /// The words after the opening fence: the language, then where the content comes from.
    pub info: String,
    /// The lines, each with its end.
    pub content: String,
}

/// A page of the documentation.
#[derive(Debug)]
pub struct Page {
    /// Its path in the repository.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Its fences in order.
    pub fences: Vec<Fence>,
}

/// README.md, then every page of `docs/`, sorted by name.
pub fn pages(root: &Path) -> Vec<Page> {
    let mut paths: Vec<PathBuf> = fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    paths.sort();
    paths.insert(0, root.join("README.md"));
    let page = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let path = path.strip_prefix(root).unwrap().display().to_string();
        Page { fences: fences(&path, &text), path, text }
    };
    paths.into_iter().map(page).collect()
}

fn fences(path: &str, text: &str) -> Vec<Fence> {
    let mut fences = Vec::new();
    let mut before = "";
    let mut lines = (1..).zip(text.lines());
    while let Some((line, text)) = lines.next() {
        if let Some(info) = text.strip_prefix("```") {
            let file = before.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
            let file = file.filter(|name| !name.contains('`')).map(str::to_owned);
            let content: Vec<&str> =
                lines.by_ref().map(|(_, line)| line).take_while(|line| !line.starts_with("```")).collect();
            fences.push(Fence { line, file, info: info.to_owned(), content: content.join("\n") + "\n" });
        }
        assert!(!text.trim_start().starts_with("```") || text.starts_with("```"), "{path}:{line}: an indented fence");
        before = text;
    }
    fences
}

impl Fence {
    /// The language.
    pub fn language(&self) -> &str {
        self.info.split(' ').next().unwrap_or_default()
    }

    /// Source of the content: the words after ` from `.
    pub fn origin(&self) -> Option<&str> {
        self.info.split_once(" from ").map(|(_, origin)| origin)
    }
}

/// Returns true if all lines of `part` follow each other in `whole`, whatever the indentation and the doc comments.
pub fn is_excerpt(part: &str, whole: &str) -> bool {
    let lines = |text: &str| -> Vec<String> {
        let lines = text.lines().map(str::trim).filter(|line| !line.starts_with("///") && !line.is_empty());
        lines.map(str::to_owned).collect()
    };
    let (part, whole) = (lines(part), lines(whole));
    !part.is_empty() && whole.windows(part.len()).any(|window| window == part)
}

/// Returns true if the lines of `part` occur in `whole` in this order, others between them.
pub fn in_order(part: &str, whole: &str) -> bool {
    let mut printed = whole.lines();
    part.lines().all(|line| printed.any(|other| other == line))
}

/// The words of a command line. A text in double quotes is one word, and `#` begins a comment.
pub fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (index, part) in line.split('"').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_owned());
            continue;
        }
        for word in part.split_whitespace() {
            if word.starts_with('#') {
                return words;
            }
            words.push(word.to_owned());
        }
    }
    words
}

/// The arm file `arm` with the sections that `fragment` has, those of the same key replaced.
pub fn with_sections(arm: &str, fragment: &str) -> String {
    let key =
        |line: &str| line.split_once(':').map(|(key, _)| key.to_owned()).filter(|key| !key.starts_with([' ', '#']));
    let replaced: Vec<String> = fragment.lines().filter_map(key).collect();
    assert!(!replaced.is_empty(), "no section in {fragment}");
    let mut kept = String::new();
    let mut keeps = true;
    for line in arm.lines() {
        if let Some(key) = key(line) {
            keeps = !replaced.contains(&key);
        }
        if keeps {
            kept += line;
            kept += "\n";
        }
    }
    kept + fragment
}
