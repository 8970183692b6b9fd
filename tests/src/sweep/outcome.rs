//! Findings at one arm.

use denhart::effort::Effort;

use crate::report::Report;

/// The arm under examination, and the findings.
#[derive(Debug)]
pub struct Outcome {
    pub name: String,
    pub structure: &'static str,
    /// The arm file.
    pub text: String,
    /// Why there is no inverse.
    pub refused: Option<String>,
    pub poses: usize,
    pub failures: Vec<Failure>,
    /// The most that a call of the inverse took.
    pub most: Effort,
}

/// Failures of one rule at poses of one family.
#[derive(Debug, Clone)]
pub struct Failure {
    pub family: String,
    pub rule: String,
    pub count: usize,
    /// Joint vectors, and what went wrong.
    pub shown: Vec<(Vec<f64>, String)>,
}

impl Failure {
    /// One failure of the arm as a whole, or at a joint vector.
    pub fn of(family: &str, rule: &str, q: &[f64], detail: String) -> Self {
        Self { family: family.to_owned(), rule: rule.to_owned(), count: 1, shown: vec![(q.to_vec(), detail)] }
    }

    /// Failures of a report.
    pub fn all(report: &Report) -> Vec<Self> {
        let shown = |failures: &crate::report::Failures| {
            failures.shown.iter().map(|shown| (shown.q.clone(), shown.detail.clone())).collect()
        };
        let failures = report.failures();
        failures
            .map(|(family, rule, failures)| Self {
                family: family.to_owned(),
                rule: rule.to_owned(),
                count: failures.count,
                shown: shown(failures),
            })
            .collect()
    }
}

/// How a line that has a joint vector to replay begins.
pub const VECTOR: &str = "# q: ";

impl Outcome {
    /// The arm file with its failures in the comment at its head.
    pub fn replay(&self) -> String {
        let mut text = format!("# {}: {}\n", self.name, self.structure);
        for failure in &self.failures {
            text += &format!("# {} x {}: {}\n", failure.count, failure.family, failure.rule);
            for (q, _) in failure.shown.iter().filter(|(q, _)| !q.is_empty()) {
                text += &format!("{VECTOR}{q:?}\n");
            }
        }
        text + &self.text
    }
}
