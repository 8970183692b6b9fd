//! Many targets, one a line: CSV or JSON lines in, CSV or JSON lines out, each result as soon as it is computed.
//!
//! Targets take single calls, not lanes: what is printed of a solution has its branch and its residual, which lanes do not
//! give, and a block would keep results back until it is full.

use std::fs;
use std::io::{self, BufRead, IsTerminal, Write};
use std::path::Path;

use denhart_dynamic::DynamicArm;
use serde_json::{Value, json};

use crate::Failure;
use crate::answer::{Answer, Asked, Form, merged};
use crate::inverse::{NEAR, not_given};
use crate::lines::Lines;
use crate::numbers::{count, printed};
use crate::progress::Progress;
use crate::target::{Target, check_columns, is_standard_input, open, shown};

/// The progress bar, of the bytes read.
const BAR: &str = "{wide_bar} {percent} %, {eta} left";
/// Lines between two looks at the clock.
const BETWEEN_LOOKS: u64 = 16;

/// The options of a run.
pub struct Batch<'a> {
    pub arm: &'a DynamicArm,
    /// The values of the redundant joints, of every target that has none of its own.
    pub given: Vec<f64>,
    pub near: Option<Vec<f64>>,
    pub form: Form,
    pub json: bool,
}

impl Batch<'_> {
    /// Answers every line; whether each target has an exact solution.
    ///
    /// # Errors
    /// A file that cannot be read, or with wrong lines; no way to print.
    pub fn run(&self, file: &Path, out: &mut dyn Write, err: &mut dyn Write) -> Result<bool, Failure> {
        let size = if is_standard_input(file) { None } else { fs::metadata(file).ok().map(|found| found.len()) };
        let may_show = size.is_some() && !io::stdout().is_terminal();
        let mut progress = Progress::new(size.unwrap_or_default(), BAR, BETWEEN_LOOKS, may_show);
        let mut input = open(file)?;
        let (name, mut form) = (shown(file), None);
        let (mut number, mut read, mut targets, mut wrong, mut exact) = (0_u64, 0_u64, 0_usize, 0_usize, true);
        let mut bytes = Vec::new();
        loop {
            bytes.clear();
            let length = input.read_until(b'\n', &mut bytes);
            let length = length.map_err(|error| Failure::Other(format!("cannot read {name}: {error}")))?;
            if length == 0 {
                break;
            }
            number += 1;
            read += length as u64;
            let line = String::from_utf8_lossy(&bytes);
            let line = line.trim_start_matches('\u{feff}').trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let lines = match &form {
                Some(lines) => lines,
                None => {
                    let lines = &*form.insert(Lines::of(line));
                    // Only lines of JSON may have values of their own.
                    if !matches!(lines, Lines::Json) {
                        self.needs(&self.given)?;
                    }
                    if let Lines::Named(names) = lines {
                        check_columns(names, self.arm.task()?)
                            .map_err(|failure| failure.at(&format!("{name}:{number}")))?;
                    }
                    if !self.json {
                        writeln!(out, "{}", self.header())?;
                    }
                    if matches!(lines, Lines::Named(_)) {
                        continue;
                    }
                    lines
                }
            };
            targets += 1;
            match lines.target(self.arm, line, self.form.units).and_then(|target| self.answer(target)) {
                Ok(answer) => {
                    exact &= answer.is_exact();
                    for hint in answer.hints().iter().filter(|_| !self.json) {
                        progress.aside(|| writeln!(err, "hint: {name}:{number}: {hint}"))?;
                    }
                    self.print(number, &answer, out)?;
                }
                Err(Failure::Usage(message) | Failure::Other(message)) => {
                    wrong += 1;
                    progress.aside(|| writeln!(err, "error: {name}:{number}: {message}"))?;
                    self.print_wrong(number, &message, out)?;
                }
                Err(other) => return Err(other),
            }
            out.flush()?;
            progress.look(read);
        }
        drop(progress);
        match (targets, wrong) {
            (0, _) => Err(Failure::Usage(format!("{name}: no targets\nhelp: write one a line, as in --pose"))),
            (_, 0) => Ok(exact),
            (1, _) => Err(Failure::Usage(format!("{name}: the one target is wrong"))),
            _ => Err(Failure::Usage(format!("{name}: {wrong} of {} wrong", count(targets, "target")))),
        }
    }

    /// Refuses a target without the values that the inverse takes beside it.
    fn needs(&self, given: &[f64]) -> Result<(), Failure> {
        match given.is_empty() && self.near.is_none() && !self.arm.given()?.is_empty() {
            true => Err(not_given(self.arm, self.form.units, &format!("{NEAR}, lines of JSON with `given`"))?),
            false => Ok(()),
        }
    }

    fn answer(&self, target: Target) -> Result<Answer<'_>, Failure> {
        let given = if target.given.is_empty() { self.given.clone() } else { target.given.clone() };
        self.needs(&given)?;
        let asked = Asked { target, given, near: self.near.clone() };
        Answer::new(self.arm, asked, self.form)
    }

    /// The names of the columns.
    fn header(&self) -> String {
        let names = ["line", "status", "solution"].into_iter().chain(self.arm.joint_names());
        let rest = ["branch", "flags", "within_limits", "off_by_position", "off_by_orientation"];
        names.chain(rest).collect::<Vec<_>>().join(",")
    }

    /// A line for each solution, or one that says that there is none.
    fn print(&self, number: u64, answer: &Answer, out: &mut dyn Write) -> Result<(), Failure> {
        if self.json {
            return json_line(&merged([json!({ "line": number }), answer.json()?]), out);
        }
        let status = answer.status();
        if answer.listed().next().is_none() {
            return self.print_empty(number, status, out);
        }
        for (index, solution) in answer.listed() {
            let q: Vec<String> = answer.values(&solution.q).iter().map(|value| printed(*value)).collect();
            let residual = answer.residual(solution)?;
            writeln!(
                out,
                "{number},{status},{index},{},\"{}\",{},{},{},{}",
                q.join(","),
                solution.branch,
                solution.flags,
                solution.is_within_limits(),
                printed(residual.position),
                printed(self.form.units.of(residual.orientation)),
            )?;
        }
        Ok(())
    }

    fn print_wrong(&self, number: u64, message: &str, out: &mut dyn Write) -> Result<(), Failure> {
        match self.json {
            true => json_line(&json!({ "line": number, "error": message }), out),
            false => self.print_empty(number, "error", out),
        }
    }

    /// A line without a solution: its columns are empty.
    fn print_empty(&self, number: u64, status: &str, out: &mut dyn Write) -> Result<(), Failure> {
        Ok(writeln!(out, "{number},{status}{}", ",".repeat(self.arm.joints() + 6))?)
    }
}

fn json_line(value: &Value, out: &mut dyn Write) -> Result<(), Failure> {
    let text = serde_json::to_string(value).map_err(|error| Failure::Other(error.to_string()))?;
    Ok(writeln!(out, "{text}")?)
}
