//! The thresholds in ARCHITECTURE.md are those of the code.
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
const CONSTANTS: [Constant; 12] = constants!(
    ROUNDING VANISHING WEAK DOUBTFUL EXACT CLOSE COINCIDENT LEAST_SINE MINUS_ONE MOST_WOUND LARGEST_REACH SMALLEST_REACH
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

/// The rows of the section that begin with a name in backticks: the name and the columns after it.
fn rows<'a>(document: &'a str, heading: &str) -> Vec<(&'a str, Vec<&'a str>)> {
    let section = document.lines().skip_while(|line| *line != heading).skip(1);
    let section = section.take_while(|line| !line.starts_with('#'));
    section
        .filter_map(|line| line.strip_prefix("| `")?.split_once("` |"))
        .map(|(name, columns)| (name, columns.split('|').map(str::trim).collect()))
        .collect()
}

/// A number of the table: `4e-13`, or `64 eps`.
fn number(text: &str, epsilon: f64) -> f64 {
    match text.strip_suffix(" eps") {
        Some(factor) => factor.parse::<f64>().unwrap() * epsilon,
        None => text.parse().unwrap_or_else(|_| panic!("{text} is no number")),
    }
}

#[test]
fn the_table_of_thresholds_has_every_constant_and_its_values() {
    let (document, source) = (text("ARCHITECTURE.md"), text("runtime/src/solve/tolerances.rs"));
    let rows = rows(&document, "### Thresholds");
    let declared = declared(&source);
    assert!(!declared.is_empty(), "no constant is found in the trait");
    for name in &declared {
        assert!(CONSTANTS.iter().any(|constant| constant.name == *name), "{name} is not compared by this test");
        assert_eq!(rows.iter().filter(|(row, _)| row == name).count(), 1, "rows of {name}");
    }
    for (name, columns) in &rows {
        let constant = CONSTANTS.iter().find(|constant| constant.name == *name);
        let Constant { double, single, .. } = constant.unwrap_or_else(|| panic!("the code has no {name}"));
        let [in_double, in_single, ..] = columns[..] else { panic!("the row of {name} has two numbers") };
        assert_eq!(number(in_double, f64::EPSILON), *double, "{name} in double precision");
        assert_eq!(number(in_single, f64::from(f32::EPSILON)) as f32, *single, "{name} in single precision");
    }
}

#[test]
fn the_bound_of_a_call_is_the_one_that_is_promised() {
    let bound = format!("at most {MOST_CASCADES} cascades and {MOST_EVALUATIONS} evaluations");
    for path in ["ARCHITECTURE.md", "docs/results.md", "runtime/src/arm.rs", "codegen/src/emit/inverse_frame.rs"] {
        // A line may end within it.
        let text = text(path);
        let words: Vec<&str> = text.split_whitespace().filter(|word| *word != "///").collect();
        assert!(words.join(" ").contains(&bound), "{path}: {bound}");
    }
}
