//! `docs/arms.md` lists the arms of `specs/` as the generator finds them, and the command has their files.
//!
//! `DENHART_ACCEPT=1 cargo test -p denhart-cli --test index` writes the page and the files of the command.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};

const HEAD: &str = "\
# The arms of `specs/`

Each has its source in the head comment of its file. R is a turning joint, P a sliding one; axes count from 1. An arm without a
closed form has forward kinematics and Jacobian all the same, and `denhart::numeric`. The pictures are those of
`denhart draw NAME.yaml --apart --size 300x230`: each arm stands where its joints are seen apart ([pictures](draw.md)). This page and its
pictures are written by a test: `DENHART_ACCEPT=1 cargo test -p denhart-cli --test index`.

| | arm | joints | axes | inverse | solutions at most |
|---|---|---|---|---|---|
";

/// Most bytes of all pictures.
#[cfg(feature = "draw")]
const MOST_BYTES: usize = 2_000_000;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The row of an arm.
fn row(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let file = path.file_name().unwrap().to_string_lossy().into_owned();
    let report = denhart_codegen::check(&text, &file).unwrap();
    let shown = report.to_string();
    let kinds = shown.lines().next().unwrap().split(['(', ')']).nth(1).unwrap().to_owned();
    // `  2, 3, 4 are parallel`
    let triples: Vec<&str> = shown
        .lines()
        .skip_while(|line| *line != "axes:")
        .take_while(|line| *line != "operations:")
        .map(str::trim)
        .filter(|line| line.matches(',').count() == 2 && !line.contains("apart"))
        .collect();
    let (task, most) = match (&report.task, &report.unsupported) {
        (Some(task), _) => (format!("`{task}`"), report.max_solutions.unwrap().to_string()),
        (None, Some(reason)) => (format!("none: {}", reason.split(';').next().unwrap()), "-".to_owned()),
        (None, None) => unreachable!(),
    };
    let axes = if triples.is_empty() { "-".to_owned() } else { triples.join("; ") };
    let name = &report.name;
    let picture = format!("<img src=\"pictures/arms/{name}.svg\" width=\"220\" alt=\"{name}, drawn\">");
    format!("| {picture} | [{name}](../specs/{file}) | {kinds} | {axes} | {task} | {most} |\n")
}

/// The files of `specs/`, by name.
fn files() -> Vec<PathBuf> {
    let files = fs::read_dir(root().join("specs")).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "yaml")).collect();
    files.sort();
    assert!(files.len() > 50);
    files
}

/// A committed file has this text; it is written if that is asked for.
fn is_current(file: &str, text: &str) {
    let path = root().join(file);
    if std::env::var_os("DENHART_ACCEPT").is_some() {
        fs::write(&path, text).unwrap();
    }
    let present = fs::read_to_string(&path).unwrap_or_default();
    assert!(present == text, "{file} is not current: DENHART_ACCEPT=1 cargo test -p denhart-cli --test index");
}

#[test]
fn the_page_is_current() {
    let page: String = [HEAD.to_owned()].into_iter().chain(files().iter().map(|path| row(path))).collect();
    is_current("docs/arms.md", &page);
}

/// A picture for each arm, and no other; all together they are small.
#[cfg(feature = "draw")]
#[test]
fn the_pictures_are_current() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("arms");
    fs::create_dir_all(&folder).unwrap();
    fs::create_dir_all(root().join("docs/pictures/arms")).unwrap();
    let (mut names, mut bytes) = (Vec::new(), 0);
    for file in files() {
        let name = format!("{}.svg", file.file_stem().unwrap().to_string_lossy());
        let picture = folder.join(&name);
        let (file, output) = (file.display().to_string(), picture.display().to_string());
        let arguments = ["denhart", "draw", &file, "--apart", "--size", "300x230", "-o", &output];
        let (mut out, mut errors) = (Vec::new(), Vec::new());
        assert_eq!(denhart_cli::run(arguments, &mut out, &mut errors), 0, "{}", String::from_utf8_lossy(&errors));
        let text = fs::read_to_string(picture).unwrap();
        bytes += text.len();
        is_current(&format!("docs/pictures/arms/{name}"), &text);
        names.push(name);
    }
    assert!(bytes <= MOST_BYTES, "{bytes} bytes");
    let present = fs::read_dir(root().join("docs/pictures/arms")).unwrap();
    let mut present: Vec<String> =
        present.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    present.sort();
    assert_eq!(present, names);
}

/// The package of the command ends at its folder, so that it has the files of the arms once more.
#[test]
fn the_command_has_the_files() {
    let file = |path: &PathBuf| {
        let (name, text) = (path.file_stem().unwrap().to_str().unwrap(), fs::read_to_string(path).unwrap());
        assert!(text.starts_with("# ") && text.contains(&format!("\nname: {name}\n")), "{name}");
        assert!(text.ends_with('\n') && !text.contains("=== "), "{name}");
        format!("=== {name}\n{text}")
    };
    is_current("tools/src/arms.txt", &files().iter().map(file).collect::<String>());
}
