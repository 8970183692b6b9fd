//! Failures that are explained: `data/sweep_known.json`.

use std::path::PathBuf;

use serde::Deserialize;

use super::outcome::{Failure, Outcome};

/// Failures of one rule at one arm, with the reason why they stand.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// Name of the arm: `sweep_<seed>_<index>`.
    pub arm: String,
    pub rule: String,
    pub reason: String,
}

impl Known {
    fn is(&self, outcome: &Outcome, failure: &Failure) -> bool {
        self.arm == outcome.name && self.rule == failure.rule
    }
}

/// The list.
pub fn list() -> Vec<Known> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data/sweep_known.json");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The listed failures of the arms of a sweep that did not happen: they are to be taken off the list.
pub fn mended<'k>(known: &'k [Known], names: &[String], failed: &[Outcome]) -> Vec<&'k Known> {
    let happened = |known: &Known| failed.iter().any(|outcome| outcome.failures.iter().any(|f| known.is(outcome, f)));
    known.iter().filter(|known| names.contains(&known.arm) && !happened(known)).collect()
}

/// The reason why a failure stands, if it is listed.
pub fn reason<'k>(known: &'k [Known], outcome: &Outcome, failure: &Failure) -> Option<&'k str> {
    known.iter().find(|known| known.is(outcome, failure)).map(|known| known.reason.as_str())
}
