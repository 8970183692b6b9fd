//! Tests that the examples of README.md and of the pages of `docs/` work as they stand.
//!
//! - A fence under a line with the name of a file in backticks is a file of a crate. The crate ends with its
//!   `src/main.rs` or `src/lib.rs`. The crate is built and run. `Cargo.toml` and `arm.yaml` are those of the README
//!   where it has none.
//! - Under the name of a file of this repository, it is an excerpt of that file.
//! - A `yaml` fence without a name is a section of an arm file, tried with the arm of the README.
//! - A `rust` fence `generated from FILE` is an excerpt of the code of an arm file.
//! - A `text` fence is what the crate before it prints, or what the command prints that it is `from`.
//!   Of `text lines from`, the command prints these lines in this order, and others too.
//! - Every line of an `sh` fence meets one of three rules. The line is run (`denhart`), or has the options of its help
//!   (`denhart` where it writes files or reads a pipe). Otherwise the line names an existing thing (`cargo`, a script of this
//!   repository).
//! - A `json` fence is JSON; a `toml` fence without a name has features that the crate has.
//! - There is no other fence.
#![allow(clippy::unwrap_used)]

mod pages;
mod user_crate;

use std::fs;

use denhart_codegen::Options;
use pages::{Fence, Page, in_order, is_excerpt, pages, with_sections, words};
use user_crate::{UserCrate, root};

/// README.md is for someone who has never heard of denhart.
const MOST_LINES: usize = 150;
/// Least number of crates in README.md and `docs/`. Fewer: the fences are not found.
const LEAST_CRATES: usize = 8;

/// The content of a file that the README shows.
fn of_readme(pages: &[Page], name: &str) -> String {
    let fence = pages[0].fences.iter().find(|fence| fence.file.as_deref() == Some(name));
    fence.unwrap_or_else(|| panic!("README.md has no {name}")).content.clone()
}

/// Returns true if a fence shows a file of a crate, not one of this repository.
fn in_a_crate(fence: &Fence) -> bool {
    fence.file.as_ref().is_some_and(|name| !root().join(name).exists() || name == "Cargo.toml")
}

/// The text of an arm file by the name that a page gives it.
fn arm_file(pages: &[Page], page: &Page, name: &str) -> String {
    let shown = page.fences.iter().find(|fence| fence.file.as_deref() == Some(name));
    match shown {
        Some(fence) => fence.content.clone(),
        None if name == "arm.yaml" => of_readme(pages, name),
        None => fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{}: {name}: {error}", page.path)),
    }
}

#[test]
fn every_crate_of_the_readme_works() {
    let pages = pages(&root());
    let [arm, manifest] = ["arm.yaml", "Cargo.toml"].map(|name| of_readme(&pages, name));
    let mut crates = 0;
    for page in &pages {
        let mut files: Vec<&Fence> = Vec::new();
        let mut printed = String::new();
        for fence in &page.fences {
            if fence.info == "text" {
                assert!(in_order(&fence.content, &printed), "{}:{}:\n{printed}", page.path, fence.line);
                continue;
            }
            let Some(name) = fence.file.as_ref().filter(|_| in_a_crate(fence)) else { continue };
            files.push(fence);
            if name.starts_with("src/") {
                crates += 1;
                printed = build(&files, &format!("readme_{crates}"), &arm, &manifest);
                files.clear();
            }
        }
        let alone = |fence: &Fence| ["yaml", "csv"].contains(&fence.language());
        assert!(files.iter().all(|fence| alone(fence)), "{}: a crate without src/main.rs", page.path);
    }
    assert!(crates >= LEAST_CRATES, "{crates} crates are found");
}

/// Builds and runs a crate; what it prints. A mistake in its arm file is an error at the place.
fn build(files: &[&Fence], name: &str, arm: &str, manifest: &str) -> String {
    let user = UserCrate::new(name, "");
    let own = manifest.replace("../denhart", &root().display().to_string()) + "\n[workspace]\n";
    user.write("Cargo.toml", &own);
    user.write("arm.yaml", arm);
    for fence in files {
        let name = fence.file.as_deref().unwrap();
        let here = fence.content.replace("../denhart", &root().display().to_string());
        user.write(name, &if name == "Cargo.toml" { here + "\n[workspace]\n" } else { here });
    }
    let printed = if files.iter().any(|fence| fence.file.as_deref() == Some("src/main.rs")) {
        let printed = user.succeeds(&["run"]);
        assert!(!printed.is_empty());
        printed
    } else {
        user.succeeds(&["check"]);
        String::new()
    };
    // As the README says of a mistake in the file.
    if files.iter().any(|fence| fence.content.contains("\"arm.yaml\"")) {
        user.write("arm.yaml", &arm.replace("alpha: -90, ", ""));
        let errors = user.fails(&["check"]);
        assert!(errors.contains("arm.yaml:9:") && errors.contains("has no `alpha`"), "{errors}");
    }
    printed
}

/// Arm files, sections of them, generated code and excerpts; and no fence that nothing checks.
#[test]
fn every_other_example_is_as_it_is_shown() {
    let pages = pages(&root());
    let arm = of_readme(&pages, "arm.yaml");
    for page in &pages {
        for fence in &page.fences {
            let place = format!("{}:{}", page.path, fence.line);
            let checked = |text: &str| {
                let report = denhart_codegen::check(text, &place).unwrap_or_else(|errors| panic!("{errors}"));
                assert!(report.lacking.is_none(), "{report}");
            };
            match (fence.language(), fence.file.as_deref(), fence.origin()) {
                (language, Some(_), _) if in_a_crate(fence) => {
                    // pictures.rs follows a path in `csv`.
                    assert!(["yaml", "toml", "rust", "csv"].contains(&language), "{place}: a file in `{language}`");
                    if fence.content.starts_with("kinematics:") {
                        // A calibration, with the arm file that it becomes behind it.
                        let name = fence.file.clone().unwrap();
                        let import = ["denhart".to_owned(), "import".to_owned(), "--ur-calibration".to_owned(), name];
                        let printed = denhart(&pages, page, &import, &place);
                        let arm = arm_file(&pages, page, "ur_calibrated.yaml");
                        assert!(in_order(&arm, &printed), "{place}: the arm file is another one:\n{printed}");
                    } else if language == "yaml" {
                        checked(&fence.content);
                    }
                }
                (_, Some(name), _) => {
                    let whole = fs::read_to_string(root().join(name)).unwrap();
                    assert!(is_excerpt(&fence.content, &whole), "{place}: {name} has other lines");
                }
                ("yaml", None, _) => checked(&with_sections(&arm, &fence.content)),
                ("rust", None, Some(origin)) => {
                    let text = arm_file(&pages, page, origin);
                    let code =
                        denhart_codegen::generate(&text, &place, &Options::new("Arm1")).unwrap().to_file().unwrap();
                    assert!(is_excerpt(&fence.content, &code), "{place}: other code is generated:\n{code}");
                }
                ("text", None, Some(command)) => {
                    let printed = denhart(&pages, page, &words(command), &place);
                    if fence.info.starts_with("text lines ") {
                        assert!(in_order(&fence.content, &printed), "{place}: other lines are printed:\n{printed}");
                    } else {
                        assert_eq!(fence.content.trim_end(), printed.trim_end(), "{place}");
                    }
                }
                ("c", None, Some(origin)) => compiles(&pages, page, &fence.content, origin, &place),
                ("text", None, None) => {}
                ("json", None, _) => drop(serde_json::from_str::<serde_json::Value>(&fence.content).unwrap()),
                ("toml", None, _) => {
                    let manifest = fs::read_to_string(root().join("runtime/Cargo.toml")).unwrap();
                    for feature in features(&fence.content) {
                        assert!(manifest.contains(&format!("\n{feature} = [")), "{place}: no feature {feature}");
                    }
                }
                // firmware/host/tests/moves.rs has them received.
                ("moves", None, None) => fence.content.lines().for_each(|line| {
                    let (counts, sum) = line.rsplit_once('*').unwrap();
                    assert_eq!(sum, format!("{:02X}", counts.bytes().fold(0, |all, byte| all ^ byte)), "{place}");
                }),
                // python/tests/test_pages.py runs these.
                ("pycon", None, None) => {}
                ("sh", None, None) => fence.content.lines().for_each(|line| run(&pages, page, &words(line), &place)),
                _ => panic!("{place}: nothing checks a fence `{}`", fence.info),
            }
        }
    }
}

/// Runs the command `denhart`, which must succeed; what it prints.
fn denhart(pages: &[Page], page: &Page, words: &[String], place: &str) -> String {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages");
    fs::create_dir_all(&folder).unwrap();
    let arguments = words.iter().map(|word| {
        if !word.ends_with(".yaml") {
            return word.clone();
        }
        let path = folder.join(word.replace('/', "_"));
        fs::write(&path, arm_file(pages, page, word)).unwrap();
        path.display().to_string()
    });
    let (mut out, mut errors) = (Vec::new(), Vec::new());
    let status = denhart_cli::run(arguments, &mut out, &mut errors);
    assert_eq!(status, 0, "{place}: {words:?}: {}", String::from_utf8_lossy(&errors));
    String::from_utf8(out).unwrap()
}

/// A piece of C compiles with the header of the arm that it is for, where there is a compiler.
fn compiles(pages: &[Page], page: &Page, code: &str, arm: &str, place: &str) {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages_in_c");
    let library = folder.display().to_string();
    denhart(pages, page, &words(&format!("denhart export c {arm} -o {library} --scalar f32 --force")), place);
    let file = folder.join("page.c");
    fs::write(&file, code).unwrap();
    let mut cc = std::process::Command::new("cc");
    match cc
        .args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"])
        .arg("-I")
        .arg(folder.join("include"))
        .arg(file)
        .output()
    {
        Ok(output) => assert!(output.status.success(), "{place}: {}", String::from_utf8_lossy(&output.stderr)),
        Err(_) => println!("{place}: skipped, there is no C compiler `cc`"),
    }
}

/// The features that a manifest asks for.
fn features(manifest: &str) -> Vec<&str> {
    let lists = manifest.split("features = [").skip(1).filter_map(|rest| rest.split(']').next());
    lists.flat_map(|list| list.split('"').skip(1).step_by(2)).collect()
}

/// A command that writes files, or serves a page until it is stopped, is not run: its subcommand and its options are those
/// of its help.
fn has_its_options(words: &[String], place: &str) {
    let (mut out, mut errors) = (Vec::new(), Vec::new());
    // `export` has subcommands of its own.
    let named = if words[1] == "export" { 3 } else { 2 };
    let command = words[..named].iter().map(String::as_str).chain(["--help"]);
    let status = denhart_cli::run(command, &mut out, &mut errors);
    assert_eq!(status, 0, "{place}: {words:?}: {}", String::from_utf8_lossy(&errors));
    let help = String::from_utf8(out).unwrap();
    for option in words[named..].iter().filter(|word| word.starts_with('-') && word.len() > 1) {
        assert!(help.contains(option.as_str()), "{place}: {words:?}: no {option} in the help:\n{help}");
    }
}

/// A line of a shell: `denhart` is run, what `cargo` is told to run exists.
fn run(pages: &[Page], page: &Page, words: &[String], place: &str) {
    let Some(program) = words.first() else { return };
    // Variables of the environment come first.
    if program.contains('=') {
        return run(pages, page, &words[1..], place);
    }
    // A pipe: the first command is run, the others have the options of their help.
    if let Some(pipe) = words.iter().position(|word| word == "|") {
        has_its_options(&words[pipe + 1..], place);
        return run(pages, page, &words[..pipe], place);
    }
    match program.as_str() {
        "denhart"
            if words
                .iter()
                .any(|word| ["new", "view", "-o", "--plot", ">"].contains(&word.as_str()) || word.contains('*')) =>
        {
            has_its_options(words, place);
        }
        "denhart" => assert!(!denhart(pages, page, words, place).is_empty(), "{place}"),
        "cargo" => {
            for pair in words.windows(2) {
                let folders = match pair[0].as_str() {
                    "--example" => ["runtime/examples", "runtime/examples"],
                    "--test" => ["tests/tests", "cli/tests"],
                    "--bench" => ["tests/benches", "tests/benches"],
                    _ => continue,
                };
                let exists = folders.iter().any(|folder| {
                    let folder = root().join(folder);
                    folder.join(format!("{}.rs", pair[1])).exists() || folder.join(&pair[1]).join("main.rs").exists()
                });
                assert!(exists, "{place}: there is no {} {}", pair[0], pair[1]);
            }
            let known = ["run", "test", "bench", "install", "new", "insta", "build", "clippy", "fmt", "doc"];
            assert!(words.get(1).is_some_and(|word| known.contains(&word.as_str())), "{place}: {words:?}");
        }
        "pip" => {
            let folder = words.iter().find(|word| word.starts_with("./"));
            assert!(
                folder.is_some_and(|folder| root().join(folder).join("pyproject.toml").is_file()),
                "{place}: {words:?}"
            );
        }
        _ => assert!(root().join(program).is_file(), "{place}: {program} is no command of these pages"),
    }
}

#[test]
fn the_readme_is_short() {
    let pages = pages(&root());
    let lines = pages[0].text.lines().count();
    assert!(lines <= MOST_LINES, "{lines} lines");
}

/// Links to files and to headings of this repository lead somewhere.
#[test]
fn every_link_leads_somewhere() {
    let mut pages = pages(&root());
    let decisions = fs::read_dir(root().join("docs/design")).unwrap().map(|entry| entry.unwrap().file_name());
    let decisions = decisions.map(|name| format!("docs/design/{}", name.to_string_lossy()));
    for path in decisions.chain(["CONTRIBUTING.md", "tests/README.md", "ARCHITECTURE.md"].map(str::to_owned)) {
        let text = fs::read_to_string(root().join(&path)).unwrap();
        pages.push(Page { path, text, fences: Vec::new() });
    }
    let heading = |line: &str| {
        let kept = |c: &char| c.is_alphanumeric() || *c == ' ' || *c == '-' || *c == '_';
        line.trim_start_matches('#').trim().to_lowercase().chars().filter(kept).collect::<String>().replace(' ', "-")
    };
    let mut links = 0;
    for page in &pages {
        let folder = root().join(&page.path).parent().unwrap().to_owned();
        for (at, _) in page.text.match_indices("](") {
            let link = page.text[at + 2..].split(')').next().unwrap();
            if link.starts_with("http") {
                continue;
            }
            links += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let path = if file.is_empty() { root().join(&page.path) } else { folder.join(file) };
            assert!(path.exists(), "{}: {link}", page.path);
            if !anchor.is_empty() {
                let text = fs::read_to_string(path).unwrap();
                let found = text.lines().filter(|line| line.starts_with('#')).any(|line| heading(line) == anchor);
                assert!(found, "{}: no heading {link}", page.path);
            }
        }
    }
    assert!(links > 20, "{links} links are found");
}

/// A build of the command takes the versions that the repository is tested with. Without `--locked` cargo takes others.
#[test]
fn every_install_is_locked() {
    let mut commands = 0;
    for page in pages(&root()) {
        for (at, _) in page.text.match_indices("cargo install") {
            commands += 1;
            let command = page.text[at..].split(['`', '\n']).next().unwrap();
            assert!(command.contains(" --locked"), "{}: {command}", page.path);
        }
    }
    assert!(commands >= 3, "{commands} commands are found");
}

/// A table in either convention is the table of one arm: the tool has the same pose, to all digits that are printed.
#[test]
fn both_tables_of_a_drawing_are_of_one_arm() {
    let pages = pages(&root());
    let page = pages.iter().find(|page| page.path == "docs/drawing-to-table.md").unwrap();
    for (arm, q) in [("desk_arm", "30 10 -20 40"), ("six_axis", "30 10 -20 40 50 60")] {
        let [standard, modified] = ["", "_modified"].map(|convention| {
            let file = format!("{arm}{convention}.yaml");
            denhart(&pages, page, &words(&format!("denhart forward {file} --q \"{q}\"")), &page.path)
        });
        assert_eq!(standard, modified, "{arm}");
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

#[test]
fn versions_are_those_of_the_workspace() {
    let read = |name: &str| fs::read_to_string(root().join(name)).unwrap();
    let manifest = read("Cargo.toml");
    let version = |key: &str| manifest.split(key).nth(1).and_then(|rest| rest.split('"').next()).unwrap();
    let rust = format!("Rust has to be {} or later", version("rust-version = \""));
    assert!(read("README.md").contains(&rust), "{rust}");
    let citation = format!("\nversion: {}\n", version("[workspace.package]\nversion = \""));
    assert!(read("CITATION.cff").contains(&citation), "CITATION.cff: {citation}");
    let policy = format!("`rust-version` in `Cargo.toml`, now {}.", version("rust-version = \""));
    assert!(read("CONTRIBUTING.md").contains(&policy), "CONTRIBUTING.md: {policy}");
    let nalgebra = version("nalgebra = { version = \"");
    for (page, said) in [
        ("docs/generate.md", format!("with nalgebra {nalgebra}:")),
        ("README.md", format!("`nalgebra` (version {nalgebra})")),
    ] {
        assert!(read(page).contains(&said), "{page}: {said}");
    }
}
