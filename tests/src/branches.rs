//! How many branches a target has, counted without the generated code: Newton's method on the chain from many random
//! starts.
//!
//! `data/branch_counts.json` holds such counts for every arm of the target `tasks`. They are made by
//!
//! ```text
//! DENHART_COUNT_BRANCHES=1 cargo test -p denhart-tests --no-default-features --test tasks branch_counts
//! ```
//!
//! which adds the arms that the file does not have; delete a line, or the file, to count again.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};

use crate::poses::Space;
use crate::random::Random;
use crate::singular::Svd;
use crate::subject::Subject;
use crate::task::Goal;

/// Targets of an arm.
const TARGETS: usize = 6;

/// A target and its number of branches.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Counted {
    /// The joint vector that the target is made from, rad or length unit.
    q: Vec<f64>,
    branches: usize,
}

/// The file, by arm. One test at a time writes it.
static FILE: Mutex<()> = Mutex::new(());

/// The exact solutions of the inverse are as many as were counted.
pub fn check<const N: usize>(subject: &Subject<N>) {
    if std::env::var_os("DENHART_COUNT_BRANCHES").is_some_and(|value| value == "1") {
        add(subject);
    }
    let file = read();
    let counted = file.get(&subject.name).unwrap_or_else(|| panic!("{}: branches not counted yet", subject.name));
    assert_eq!(counted.len(), TARGETS);
    for Counted { q, branches } in counted {
        let q: [f64; N] = q.as_slice().try_into().expect("a value a joint");
        let answer = subject.inverse(&subject.goal(&q));
        assert_eq!(answer.exact().count(), *branches, "{}: {q:?}\n{answer}", subject.name);
    }
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data/branch_counts.json")
}

fn read() -> BTreeMap<String, Vec<Counted>> {
    let _alone = FILE.lock();
    parse()
}

fn parse() -> BTreeMap<String, Vec<Counted>> {
    let text = std::fs::read_to_string(path()).unwrap_or_else(|_| "{}".into());
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path().display()))
}

/// Counts the branches of an arm that is not in the file.
fn add<const N: usize>(subject: &Subject<N>) {
    if read().contains_key(&subject.name) {
        return;
    }
    let mut random = Random::named(&subject.name);
    let space = Space::of(subject);
    let mut counted = Vec::new();
    while counted.len() < TARGETS {
        let q = space.random(&mut random);
        let goal = subject.goal(&q);
        if Svd::at(subject, &q).least() < 1e-3 {
            continue;
        }
        let solutions = solutions(subject, &goal, &mut random);
        // Next to a fold two branches are one within what Newton's method tells apart, or none.
        if solutions.iter().all(|q| Svd::at(subject, q).least() > 1e-4) {
            counted.push(Counted { q: q.to_vec(), branches: solutions.len() });
        }
    }
    let _alone = FILE.lock();
    let mut file = parse();
    file.insert(subject.name.clone(), counted);
    let line = |(name, counted)| format!("  {name:?}: {}", serde_json::to_string(counted).expect("numbers"));
    let lines: Vec<String> = file.iter().map(line).collect();
    std::fs::write(path(), format!("{{\n{}\n}}\n", lines.join(",\n"))).expect("the file can be written");
}

/// Every joint vector that reaches the goal, each found from many starts: until the rarest has come eight times.
fn solutions<const N: usize>(subject: &Subject<N>, goal: &Goal, random: &mut Random) -> Vec<[f64; N]> {
    let mut found: Vec<([f64; N], usize)> = Vec::new();
    for start in 0..40_000 {
        let q = std::array::from_fn(|joint| subject.unit(joint) * random.uniform(-1.0, 1.0) * std::f64::consts::PI);
        if let Some(q) = newton(subject, goal, q) {
            match found.iter_mut().find(|(other, _)| subject.distance(other, &q, |_| true) < 1e-6) {
                Some((_, times)) => *times += 1,
                None => found.push((q, 1)),
            }
        }
        if start > 400 && found.iter().all(|(_, times)| *times >= 8) {
            break;
        }
    }
    found.into_iter().map(|(q, _)| q).collect()
}

/// The joint vector that Newton's method reaches from a start, steps being at most half a radian or half a reach long.
fn newton<const N: usize>(subject: &Subject<N>, goal: &Goal, mut q: [f64; N]) -> Option<[f64; N]> {
    for _ in 0..60 {
        let error = subject.error(goal, &q);
        let [position, orientation] = subject.miss(goal, &q);
        if position < 1e-12 && orientation < 1e-12 {
            return Some(q);
        }
        let columns = subject.columns(&q);
        let motion = Svd::new(columns).solve(&columns, &error, 1e-9);
        let longest = crate::subject::largest(motion.iter().copied());
        let share = if longest > 0.5 { 0.5 / longest } else { 1.0 };
        for (joint, m) in motion.iter().enumerate() {
            q[joint] += share * m * subject.unit(joint);
        }
    }
    None
}
