//! Facts in the pages for developers that have to hold in the code: thresholds, the bound of a call, the names of
//! files.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

use denhart::effort::{MOST_CASCADES, MOST_EVALUATIONS};
use denhart::solve::Tolerances;

/// A constant in both precisions.
struct Constant {
    name: &'static str,
    double: f64,
    single: f32,
}

macro_rules! constants {
    ($($name:ident)*) => {
        [$(Constant { name: stringify!($name), double: <f64 as Tolerances>::$name, single: <f32 as Tolerances>::$name }),*]
    };
}

/// Every constant of the trait.
const CONSTANTS: [Constant; 11] = constants!(
    ROUNDING VANISHING WEAK DOUBTFUL EXACT COINCIDENT LEAST_SINE MINUS_ONE MOST_WOUND LARGEST_REACH SMALLEST_REACH
);

fn text(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap()
}

/// The names of the constants that the trait declares.
fn declared(source: &str) -> Vec<&str> {
    source
        .lines()
        .filter_map(|line| line.trim().strip_prefix("const ")?.split_once(": Self;"))
        .map(|(name, _)| name)
        .collect()
}

/// The rows of tables that begin with a name in backticks: the name and the columns after it.
fn rows(document: &str) -> Vec<(&str, Vec<&str>)> {
    document
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split_once("` |"))
        .map(|(name, columns)| (name, columns.split('|').map(str::trim).collect()))
        .collect()
}

/// The formula of a threshold as the table has it, and its value; `None` for a constant that is a number by itself.
fn formula(name: &str, epsilon: f64, of: impl Fn(&str) -> f64) -> Option<(&'static str, f64)> {
    Some(match name {
        "ROUNDING" => ("64 eps", 64.0 * epsilon),
        "COINCIDENT" => ("2 sqrt(ROUNDING)", 2.0 * of("ROUNDING").sqrt()),
        "DOUBTFUL" => ("cbrt(3 eps / COINCIDENT)", (3.0 * epsilon / of("COINCIDENT")).cbrt()),
        "VANISHING" => ("3 eps / DOUBTFUL", 3.0 * epsilon / of("DOUBTFUL")),
        "WEAK" => ("sqrt(eps) / DOUBTFUL", epsilon.sqrt() / of("DOUBTFUL")),
        "EXACT" => ("2 VANISHING", 2.0 * of("VANISHING")),
        _ => return None,
    })
}

/// A constant of one scalar beside its column, and beside its formula if it has one.
fn compare(name: &str, column: &str, epsilon: f64, of: impl Fn(&str) -> f64) {
    let value = of(name);
    let Some((_, derived)) = formula(name, epsilon, of) else {
        let column: f64 = column.parse().unwrap_or_else(|_| panic!("{column} is no number"));
        let nearest = if epsilon == f64::EPSILON { column } else { f64::from(column as f32) };
        assert_eq!(nearest, value, "{name}");
        return;
    };
    assert_eq!(column, format!("{value:.2e}"), "{name}");
    assert!((value / derived - 1.0).abs() < 8.0 * epsilon, "{name} is {value:e}, its formula {derived:e}");
}

fn constant(name: &str) -> &'static Constant {
    CONSTANTS.iter().find(|constant| constant.name == name).unwrap_or_else(|| panic!("the code has no {name}"))
}

#[test]
fn the_table_of_thresholds_has_every_constant_and_its_values() {
    let (document, source) = (text("docs/design/thresholds.md"), text("runtime/src/solve/kernel/tolerances.rs"));
    let rows = rows(&document);
    let declared = declared(&source);
    assert!(!declared.is_empty(), "no constant is found in the trait");
    for name in &declared {
        assert!(CONSTANTS.iter().any(|constant| constant.name == *name), "{name} is not compared by this test");
        assert_eq!(rows.iter().filter(|(row, _)| row == name).count(), 1, "rows of {name}");
    }
    let mut derived = 0;
    for (name, columns) in &rows {
        let columns = match formula(name, f64::EPSILON, |name| constant(name).double) {
            Some((formula, _)) => {
                derived += 1;
                assert_eq!(columns[0], formula, "{name}");
                &columns[1..]
            }
            None => &columns[..],
        };
        let [in_double, in_single, ..] = columns else { panic!("the row of {name} has two numbers") };
        compare(name, in_double, f64::EPSILON, |name| constant(name).double);
        compare(name, in_single, f32::EPSILON.into(), |name| constant(name).single.into());
    }
    // Six thresholds are enough.
    assert_eq!(derived, 6);
}

#[test]
fn the_bound_of_a_call_is_the_one_that_is_promised() {
    let bound = format!("at most {MOST_CASCADES} cascades and {MOST_EVALUATIONS} evaluations");
    for path in ["ARCHITECTURE.md", "docs/results.md", "runtime/src/arm.rs", "codegen/src/emit/inverse.rs"] {
        // A line may end within it.
        let text = text(path);
        let words: Vec<&str> = text.split_whitespace().filter(|word| *word != "///").collect();
        assert!(words.join(" ").contains(&bound), "{path}: {bound}");
    }
}

/// Pages that name files beside those of a folder, and the file that one of them makes up for its recipe.
const PAGES: [&str; 3] = ["ARCHITECTURE.md", "CONTRIBUTING.md", "tests/README.md"];
const DECISIONS: &str = "docs/design/";
const MADE_UP: &str = "hinge.rs";

/// The files of the repository, by their paths from its root.
fn files(folder: &Path, from: &str, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{from}/{name}");
        if !entry.path().is_dir() {
            found.push(path);
        } else if name != "target" && !name.starts_with('.') {
            files(&entry.path(), &path, found);
        }
    }
}

/// The names in backticks that end like those of files.
fn named_files(page: &str) -> Vec<&str> {
    let is_file = |name: &&str| [".rs", ".md", ".sh", ".toml"].iter().any(|end| name.ends_with(end));
    page.lines().flat_map(|line| line.split('`').skip(1).step_by(2)).filter(is_file).collect()
}

#[test]
fn every_file_that_is_named_exists() {
    let mut all = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."), "", &mut all);
    assert_eq!(named_files("a `b.rs`, c.rs and `d` in `e/f.md`"), ["b.rs", "e/f.md"]);
    let decisions = all.iter().map(|path| path.trim_start_matches('/')).filter(|path| path.starts_with(DECISIONS));
    let decisions: Vec<&str> = decisions.collect();
    assert!(!decisions.is_empty(), "no page in {DECISIONS}");
    for page in decisions.into_iter().chain(PAGES) {
        let text = text(page);
        let named = named_files(&text);
        assert!(!named.is_empty() || !PAGES.contains(&page), "{page} names no file");
        for name in named.into_iter().filter(|name| !name.ends_with(MADE_UP)) {
            assert!(all.iter().any(|path| path.ends_with(&format!("/{name}"))), "{page}: there is no `{name}`");
        }
    }
}
