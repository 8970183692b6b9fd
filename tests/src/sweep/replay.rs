//! One arm again, from its file.

use denhart_dynamic::{DynamicArm, DynamicError};

use super::examine::examine;
use super::outcome::{Outcome, VECTOR};

/// Examines an arm file by everything that a sweep asks, and by the joint vectors in its comments.
///
/// Random joint vectors follow the name of the arm: a file that a sweep wrote meets those of the sweep again.
///
/// # Errors
/// A text that is no arm file.
pub fn replay(text: &str) -> Result<Outcome, DynamicError> {
    let arm = DynamicArm::from_yaml(text)?;
    let vectors: Vec<Vec<f64>> = text
        .lines()
        .filter_map(|line| line.strip_prefix(VECTOR))
        .filter_map(vector)
        // What is asked for besides joint vectors may be no number.
        .filter(|q| q.iter().all(|value| value.is_finite()))
        .collect();
    Ok(examine((&arm.model().name, "replayed"), text.to_owned(), None, &vectors))
}

fn vector(text: &str) -> Option<Vec<f64>> {
    let numbers = text.trim().strip_prefix('[')?.strip_suffix(']')?;
    numbers.split(',').map(|number| number.trim().parse().ok()).collect()
}
