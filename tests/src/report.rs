//! Failures, counted by family and rule, so that one run shows them all.

use std::collections::BTreeMap;
use std::fmt;

/// How many failures of one family and rule are kept with their details.
const SHOWN: usize = 2;

/// The failures of one arm.
#[derive(Debug)]
pub struct Report {
    arm: &'static str,
    poses: usize,
    failures: BTreeMap<(&'static str, &'static str), Failures>,
}

#[derive(Debug, Default)]
struct Failures {
    count: usize,
    shown: Vec<String>,
}

impl Report {
    /// An empty report.
    pub fn new(arm: &'static str) -> Self {
        Self { arm, poses: 0, failures: BTreeMap::new() }
    }

    /// Counts a pose that is being checked.
    pub fn count(&mut self) {
        self.poses += 1;
    }

    /// Records that `rule` does not hold for a pose of `family`.
    pub fn fail(&mut self, family: &'static str, rule: &'static str, detail: impl FnOnce() -> String) {
        let failures = self.failures.entry((family, rule)).or_default();
        failures.count += 1;
        if failures.shown.len() < SHOWN {
            failures.shown.push(detail());
        }
    }

    /// Number of failures.
    pub fn failed(&self) -> usize {
        self.failures.values().map(|failures| failures.count).sum()
    }

    /// Panics with the whole report if anything failed; also if nothing was checked at all.
    #[track_caller]
    pub fn assert_empty(&self) {
        assert!(self.poses > 0, "{}: no pose was checked", self.arm);
        assert!(self.failures.is_empty(), "{self}");
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {} failures in {} poses", self.arm, self.failed(), self.poses)?;
        for ((family, rule), failures) in &self.failures {
            writeln!(f, "  {:>7} x {family}: {rule}", failures.count)?;
            for detail in &failures.shown {
                writeln!(f, "    {detail}")?;
            }
        }
        Ok(())
    }
}
