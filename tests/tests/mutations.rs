//! Arm files with numbers and words in wrong places: the generator never panics, and every mistake has its place.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use denhart_codegen::{Bound, Options, ScalarKind, check, generate, takes_a_choice};
use denhart_tests::random::Random;

/// How many files are made.
const FILES: usize = 3_000;

/// Numbers at the ends of what a file can say, and what people write for "none".
const EXTREMES: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "1e308",
    "-1e308",
    "1e-320",
    "-5e-324",
    "1e400",
    "1e100",
    "-1e59",
    "1e15",
    "1e-13",
    ".inf",
    "-.inf",
    ".nan",
    "nan",
    "inf",
    "null",
    "true",
    "1e308*pi",
    "pi/1e308",
    "1e15*pi",
    "1e308 deg",
    "1e307 rad",
    "90 deg",
    "9223372036854775807",
    "-170141183460469231731687303715884105728",
    "1e308*l",
    "1e300 per rev",
    "[1e308]",
    "{q1: 1e308}",
    "''",
    "é",
];

/// Entries that the arms of `specs/` have no use for, so that their numbers are changed too.
const EXTRAS: &[&str] = &[
    "parameters: {l: 0.5, m: 0.25}\n",
    "tool: {xyz: [0, l/2, 0.1], rpy: [0, 90, 0]}\n",
    "base: {xyz: [0.5, 0, 0.1], rpy: [pi/2, 0, 30]}\n",
    "coupling: {q2: {q1: 0.5, q2: 1, offset: 90}}\n",
    "coupling: {matrix: [[1, 0], [1, 1]], offset: [0, 90]}\n",
    "combined_limits: [{sum: {q1: 1, q2: -0.5}, limits: [-90, 90]}]\n",
    "inverse: {tolerance: {length: 0.001, angle: 0.1}, weights: {q1: 2, q2: 0.5}}\n",
    "inverse: {task: pose, redundant: q1, require: true}\n",
];

fn specs() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "yaml"));
    files.sort();
    let mut texts: Vec<String> = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
    texts.push(ALL.to_owned());
    texts
}

/// Everything a file can have.
const ALL: &str = "\
name: all
convention: modified
units: {length: mm, angle: deg}
parameters: {l: 250, m: 80}
base: {xyz: [0, m, 100], rpy: [0, 0, 45]}
tool: {xyz: [2*m, 0, 0], rpy: [0, pi/2, 0]}
inverse: {task: pose, tolerance: {length: 0.1, angle: 0.05}, weights: [1, 2, 0.5, 1]}
coupling: {q2: {q1: 0.5, q2: 1, offset: 10}, q3: {q2: 20 per rev, q3: 1}}
combined_limits:
  - {sum: {q1: 1, q2: 1}, limits: [-90, 150]}
joints:
  - {a: 0, alpha: 0, d: m, theta: 0, limits: [-170, 170], actuator: {pulses_per_rev: 4096, gear_ratio: 80, home: 5}}
  - {a: l, alpha: 0, d: 0, theta: 90, limits: [-120, 120], actuator: {pulses_per_rev: 4096, direction: -1}}
  - {type: prismatic, a: l, alpha: 180, d: 0, theta: 0, limits: [0, 100], actuator: {pulses_per_unit: 200, home: 3}}
  - {a: 0, alpha: 0, d: 10, theta: 0, actuator: {pulses_per_rev: 1000}}
";

/// The numbers and words of a text: where each begins and ends.
fn tokens(text: &str) -> Vec<(usize, usize)> {
    let separates = |c: char| c.is_whitespace() || "{}[],:#".contains(c);
    let mut tokens = Vec::new();
    let mut start = None;
    for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
        match (separates(c), start) {
            (true, Some(begin)) => {
                tokens.push((begin, at));
                start = None;
            }
            (false, None) => start = Some(at),
            _ => {}
        }
    }
    tokens
}

/// A token in place of another; where only numbers are wanted, of a number.
fn replaced(text: &str, random: &mut Random, numbers: bool, by: impl Fn(&mut Random) -> String) -> String {
    let is_number = |(from, to): &(usize, usize)| !numbers || text[*from..*to].parse::<f64>().is_ok();
    let tokens: Vec<_> = tokens(text).into_iter().filter(is_number).collect();
    if tokens.is_empty() {
        return text.to_owned();
    }
    let (from, to) = random.pick(&tokens);
    format!("{}{}{}", &text[..from], by(random), &text[to..])
}

/// One change.
fn mutated(text: &str, random: &mut Random) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    let line = random.below(lines.len().max(1));
    match random.below(10) {
        0 if !lines.is_empty() => {
            lines.remove(line);
            lines.join("\n") + "\n"
        }
        1 if !lines.is_empty() => {
            lines.insert(random.below(lines.len()), lines[line]);
            lines.join("\n") + "\n"
        }
        2 => {
            let words: Vec<&str> = tokens(text).into_iter().map(|(from, to)| &text[from..to]).collect();
            replaced(
                text,
                random,
                false,
                |random| if words.is_empty() { "x".into() } else { random.pick(&words).into() },
            )
        }
        3 => replaced(text, random, false, |random| random.pick(EXTREMES).into()),
        4 => text.to_owned() + random.pick(EXTRAS),
        _ => replaced(text, random, true, |random| random.pick(EXTREMES).into()),
    }
}

/// Generates and checks a file. Returns true if the file is refused.
fn refused(text: &str, random: &mut Random) -> bool {
    let scalar = random.pick(&[ScalarKind::F64, ScalarKind::F32]);
    let bound = if random.below(2) == 0 { Bound::All } else { Bound::None };
    // The choice of the joints that are held takes too long for so many files.
    if takes_a_choice(text, "mutated.yaml", &Bound::None) {
        return false;
    }
    let options = Options { scalar, bound, ..Options::new("Arm") };
    let errors = match generate(text, "mutated.yaml", &options) {
        Ok(generated) => {
            let report = check(text, "mutated.yaml").unwrap().to_string();
            assert!(!report.contains("NaN") && !report.contains("inf "), "{report}");
            let most = if scalar == ScalarKind::F32 { f64::from(f32::MAX) } else { f64::MAX };
            let code = generated.impls.to_string();
            assert!(!code.contains("/ 0.0)"), "a number that is not finite: {code}");
            for literal in code.split([' ', ',', '(', ')', '[', ']']).filter(|word| word.ends_with(".0")) {
                assert!(literal.parse().is_ok_and(|value: f64| value <= most), "{literal}");
            }
            return false;
        }
        Err(errors) => errors,
    };
    assert!(errors.iter().next().is_some(), "refused without a reason");
    for error in &errors {
        assert!(error.at.is_some(), "no place in: {error}");
    }
    true
}

#[test]
fn any_number_anywhere_gives_code_or_a_place() {
    let mut random = Random::named("mutations");
    let specs = specs();
    let mut count = 0;
    for _ in 0..FILES {
        let mut text = specs[random.below(specs.len())].clone();
        for _ in 0..=random.below(3) {
            text = mutated(&text, &mut random);
        }
        let outcome = catch_unwind(AssertUnwindSafe(|| refused(&text, &mut random)));
        count += usize::from(outcome.unwrap_or_else(|_| panic!("see above, for the file:\n{text}")));
    }
    assert!((FILES / 3..FILES).contains(&count), "{count} of {FILES} files are refused");
}
