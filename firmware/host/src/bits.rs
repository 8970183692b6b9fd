//! The digests of the chip beside those of this machine.

use std::fs;
use std::path::Path;

use firmware_cases::{CASES, digests};

use crate::Error;

/// The most differences that are listed.
const LISTED: usize = 20;

/// Compares what the chip printed with what this machine computes.
///
/// # Errors
/// A result differs, lines are missing, or the file names no arm.
pub fn compare(file: &Path) -> Result<(), Error> {
    let chip = fs::read_to_string(file)?;
    let first = chip.lines().next().unwrap_or_default();
    let Some(name) = first.split_whitespace().nth(1).filter(|_| first.starts_with("ARM ")) else {
        return Err(format!("{}: the chip printed no digests, but `{first}`", file.display()).into());
    };
    let host = host(name).ok_or_else(|| format!("the chip names an arm that is not here, `{name}`"))?;
    let functions: Vec<&str> = first.split_whitespace().skip(3).collect();
    let mut differences = Vec::new();
    let mut lines = chip.lines();
    for expected in host.lines() {
        let line = lines.next().unwrap_or("nothing");
        if line == expected {
            continue;
        }
        let case = expected.split_whitespace().take(3).collect::<Vec<_>>().join(" ");
        let words = expected.split_whitespace().zip(line.split_whitespace()).skip(3);
        let wrong: Vec<&str> =
            functions.iter().zip(words).filter(|(_, (host, chip))| host != chip).map(|(name, _)| *name).collect();
        differences.push(format!("{case}: {}", if wrong.is_empty() { line.to_owned() } else { wrong.join(", ") }));
    }
    if lines.next().is_some() {
        differences.push("the chip printed more lines".to_owned());
    }
    if differences.is_empty() {
        println!("{name}: {CASES} cases of {} functions, every bit equal", functions.len());
        return Ok(());
    }
    let count = differences.len();
    differences.truncate(LISTED);
    Err(format!("{name}: {count} cases differ between chip and host:\n{}", differences.join("\n")).into())
}

/// Output of this machine for the arm `name`.
fn host(name: &str) -> Option<String> {
    let mut text = String::new();
    let mut print = |part: std::fmt::Arguments<'_>| text += &part.to_string();
    macro_rules! each {
        ($arm:ident, $scalar:ident) => {
            if stringify!($arm) == name {
                use firmware_arms::$arm::Robot;
                digests::<Robot, $scalar, { Robot::DOF }>(&mut print);
                return Some(text);
            }
        };
    }
    firmware_arms::each_arm!(each);
    None
}
