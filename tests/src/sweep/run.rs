//! Many arms, on several threads.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

use denhart::effort::Effort;
use indicatif::{ProgressBar, ProgressStyle};

use super::known::{self, Known};
use super::outcome::Outcome;
use super::{Kind, draw, examine, structure};

/// Which arms.
#[derive(Debug, Clone, Copy)]
pub struct Sweep {
    pub kind: Kind,
    pub seed: u64,
    /// Index of the first arm.
    pub from: usize,
    pub arms: usize,
    pub threads: usize,
}

/// The name of an arm.
fn name(kind: Kind, seed: u64, index: usize) -> String {
    format!("{}_{seed}_{index}", kind.name())
}

/// The arm of a kind, a seed and an index, drawn and examined.
pub fn one(kind: Kind, seed: u64, index: usize) -> Outcome {
    let (structure, table) = draw(kind, seed, index);
    let name = name(kind, seed, index);
    let text = table.yaml(&name);
    examine::examine((&name, structure), text, Some(&table.chain()), &[])
}

/// Findings of a sweep, in the order of the arms whatever the threads did.
#[derive(Debug, Default)]
pub struct Found {
    /// By structure.
    pub structures: BTreeMap<&'static str, Tally>,
    /// Failures by family and rule: how many, at how many arms, the first of these.
    pub rules: BTreeMap<(String, String), (usize, usize, String)>,
    /// Why arms have no inverse, without numbers: how many, the first of them.
    pub refusals: BTreeMap<String, (usize, String)>,
    /// The arms with failures.
    pub failed: Vec<Outcome>,
    /// The most that a call of the inverse took.
    pub most: Effort,
    /// Failures that are not in the list of known ones.
    pub unknown: usize,
}

/// Numbers of one structure.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tally {
    pub arms: usize,
    pub with_inverse: usize,
    pub poses: usize,
    pub failures: usize,
    pub failed_arms: usize,
}

impl Sweep {
    /// The names of its arms.
    pub fn names(&self) -> Vec<String> {
        (self.from..self.from + self.arms).map(|index| name(self.kind, self.seed, index)).collect()
    }

    /// Examines the arms; `each` sees every outcome in order as soon as those before it are known.
    pub fn run(&self, known: &[Known], mut each: impl FnMut(&Outcome)) -> Found {
        let next = AtomicUsize::new(self.from);
        let end = self.from + self.arms;
        let (sender, receiver) = mpsc::channel();
        let bar = progress(self.arms);
        let mut found = Found::default();
        std::thread::scope(|scope| {
            for _ in 0..self.threads.max(1) {
                let (sender, next) = (sender.clone(), &next);
                scope.spawn(move || {
                    loop {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        if index >= end || sender.send((index, one(self.kind, self.seed, index))).is_err() {
                            break;
                        }
                    }
                });
            }
            drop(sender);
            let mut waiting = BTreeMap::new();
            let mut at = self.from;
            for (index, outcome) in receiver {
                waiting.insert(index, outcome);
                while let Some(outcome) = waiting.remove(&at) {
                    each(&outcome);
                    found.add(outcome, known);
                    at += 1;
                    bar.inc(1);
                }
            }
        });
        bar.finish_and_clear();
        found
    }
}

fn progress(arms: usize) -> ProgressBar {
    let bar = ProgressBar::new(arms as u64);
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {human_pos}/{human_len} arms, {eta} left") {
        bar.set_style(style);
    }
    bar
}

/// A reason with `#` for its numbers, and no more of it than fits a line.
fn pattern(reason: &str) -> String {
    let mut text = String::new();
    let reason = reason.trim_start_matches("no inverse kinematics: ");
    // Every reason ends with the same advice.
    let reason = reason.split("; denhart::numeric").next().unwrap_or(reason);
    for letter in reason.chars().take(160) {
        let digit = letter.is_ascii_digit();
        if !digit {
            text.push(if letter == '\n' { ' ' } else { letter });
        } else if !text.ends_with('#') {
            text.push('#');
        }
    }
    text.chars().take(100).collect()
}

impl Found {
    /// Adds what was found at one more arm.
    pub fn add(&mut self, outcome: Outcome, known: &[Known]) {
        let tally = self.structures.entry(outcome.structure).or_default();
        tally.arms += 1;
        tally.with_inverse += usize::from(outcome.refused.is_none());
        tally.poses += outcome.poses;
        tally.failed_arms += usize::from(!outcome.failures.is_empty());
        if let Some(reason) = &outcome.refused {
            self.refusals.entry(pattern(reason)).or_insert_with(|| (0, outcome.name.clone())).0 += 1;
        }
        for failure in &outcome.failures {
            tally.failures += failure.count;
            let rule = self.rules.entry((failure.rule.clone(), failure.family.clone()));
            let (count, arms, _) = rule.or_insert_with(|| (0, 0, outcome.name.clone()));
            *count += failure.count;
            *arms += 1;
            self.unknown += usize::from(known::reason(known, &outcome, failure).is_none());
        }
        self.most.cascades = self.most.cascades.max(outcome.most.cascades);
        self.most.evaluations = self.most.evaluations.max(outcome.most.evaluations);
        if !outcome.failures.is_empty() {
            self.failed.push(outcome);
        }
    }

    /// The tables: structures, then failures by rule and family, then the bound.
    pub fn tables(&self) -> String {
        let mut text = format!(
            "{:<40} {:>7} {:>12} {:>9} {:>12} {:>9}\n",
            "structure", "arms", "with inverse", "poses", "failed arms", "failures"
        );
        let mut line = |name: &str, tally: &Tally| {
            let Tally { arms, with_inverse, poses, failures, failed_arms } = tally;
            text += &format!("{name:<40} {arms:>7} {with_inverse:>12} {poses:>9} {failed_arms:>12} {failures:>9}\n");
        };
        let mut total = Tally::default();
        for name in structure::names() {
            let Some(tally) = self.structures.get(name) else { continue };
            line(name, tally);
            total.arms += tally.arms;
            total.with_inverse += tally.with_inverse;
            total.poses += tally.poses;
            total.failures += tally.failures;
            total.failed_arms += tally.failed_arms;
        }
        line("all", &total);
        if !self.rules.is_empty() {
            text += &format!("\n{:<60} {:<38} {:>8} {:>6}  first\n", "rule", "family", "failures", "arms");
        }
        for ((rule, family), (count, arms, first)) in &self.rules {
            text += &format!("{rule:<60} {family:<38} {count:>8} {arms:>6}  {first}\n");
        }
        if !self.refusals.is_empty() {
            text += &format!("\n{:<100} {:>6}  first\n", "no inverse because", "arms");
        }
        for (reason, (arms, first)) in &self.refusals {
            text += &format!("{reason:<100} {arms:>6}  {first}\n");
        }
        let Effort { cascades, evaluations, .. } = self.most;
        text + &format!("\nthe most of one call: {cascades} runs of the nest, {evaluations} evaluations\n")
    }
}
