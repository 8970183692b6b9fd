//! Failures, counted by family and rule, so that one run shows them all.

use std::collections::BTreeMap;
use std::fmt;

/// How many failures of one family and rule are kept with their details.
const SHOWN: usize = 2;

/// The failures of one arm.
#[derive(Debug)]
pub struct Report {
    arm: String,
    poses: usize,
    /// The joint vector of the pose that is being checked.
    at: Vec<f64>,
    failures: BTreeMap<(&'static str, &'static str), Failures>,
    /// Failures that are allowed at one pose in [`RARE`].
    rare: BTreeMap<(&'static str, &'static str), Failures>,
}

/// A rare failure happens at no more than one pose in so many.
const RARE: usize = 500;

/// Failures of one family and rule.
#[derive(Debug, Default)]
pub struct Failures {
    /// How many.
    pub count: usize,
    /// The first ones.
    pub shown: Vec<Shown>,
}

/// One failure.
#[derive(Debug)]
pub struct Shown {
    /// The joint vector that the target was made from.
    pub q: Vec<f64>,
    /// Message about the failure.
    pub detail: String,
}

impl Report {
    /// An empty report.
    pub fn new(arm: &str) -> Self {
        Self { arm: arm.to_owned(), poses: 0, at: Vec::new(), failures: BTreeMap::new(), rare: BTreeMap::new() }
    }

    /// Counts a pose that is being checked: that of a joint vector, or a target made from it.
    pub fn count(&mut self, q: &[f64]) {
        self.poses += 1;
        self.at = q.to_vec();
    }

    /// The joint vector of the pose that is being checked.
    pub fn at(&self) -> &[f64] {
        &self.at
    }

    /// Number of poses.
    pub fn poses(&self) -> usize {
        self.poses
    }

    /// The failures, by family and rule.
    pub fn failures(&self) -> impl Iterator<Item = (&'static str, &'static str, &Failures)> {
        self.failures.iter().map(|((family, rule), failures)| (*family, *rule, failures))
    }

    /// Records that `rule` does not hold for a pose of `family`.
    pub fn fail(&mut self, family: &'static str, rule: &'static str, detail: impl FnOnce() -> String) {
        self.failures.entry((family, rule)).or_default().add(&self.at, detail);
    }

    /// Records that `rule`, which may be broken at one pose in 500, does not hold for a pose of `family`.
    pub fn rarely(&mut self, family: &'static str, rule: &'static str, detail: impl FnOnce() -> String) {
        self.rare.entry((family, rule)).or_default().add(&self.at, detail);
    }

    /// Number of failures.
    pub fn failed(&self) -> usize {
        self.failures.values().map(|failures| failures.count).sum()
    }

    /// Panics with the whole report if anything failed; also if nothing was checked at all.
    #[track_caller]
    pub fn assert_empty(&self) {
        self.assert_at_most(0);
    }

    /// Panics with the whole report if more failed than is known, or if nothing was checked at all.
    #[track_caller]
    pub fn assert_at_most(&self, known: usize) {
        assert!(self.poses > 0, "{}: no pose was checked", self.arm);
        let rare: usize = self.rare.values().map(|failures| failures.count).sum();
        assert!(self.failed() <= known && rare * RARE <= self.poses, "{self}");
    }
}

impl Failures {
    fn add(&mut self, at: &[f64], detail: impl FnOnce() -> String) {
        self.count += 1;
        if self.shown.len() < SHOWN {
            self.shown.push(Shown { q: at.to_vec(), detail: detail() });
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {} failures in {} poses", self.arm, self.failed(), self.poses)?;
        for ((family, rule), failures) in self.failures.iter().chain(&self.rare) {
            writeln!(f, "  {:>7} x {family}: {rule}", failures.count)?;
            for Shown { detail, .. } in &failures.shown {
                writeln!(f, "    {detail}")?;
            }
        }
        Ok(())
    }
}
