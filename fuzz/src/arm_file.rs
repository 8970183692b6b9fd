//! Bytes of an arm file to the checker: mistakes with their places, or a report.

use denhart_codegen::{Bound, check, decode, takes_a_choice};

/// Any bytes: refused with a message, or an arm.
pub fn run(data: &[u8]) {
    let text = match decode(data.to_vec(), "`fuzz.yaml`") {
        Ok(text) => text,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    if takes_a_choice(&text, "fuzz.yaml", &Bound::None) {
        return;
    }
    match check(&text, "fuzz.yaml") {
        Ok(report) => {
            assert!((1..=10).contains(&report.dof), "{} joints", report.dof);
            assert!(!report.to_string().is_empty());
        }
        Err(errors) => {
            assert!(errors.iter().next().is_some(), "refused without a mistake");
            for mistake in errors.iter() {
                assert!(!mistake.message.is_empty(), "a mistake without a message");
                if let Some(at) = &mistake.at {
                    // A place may be behind the last line, where something is missing.
                    let lines = text.lines().count() + 1;
                    assert!((1..=lines).contains(&at.line) && at.column >= 1, "{}:{} of {lines}", at.line, at.column);
                }
            }
            assert!(!errors.to_string().is_empty());
        }
    }
}
