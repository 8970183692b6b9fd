//! `denhart inverse --sweep`: the solutions of one target for many values of the redundant joint, or of the arm angle.

use std::f64::consts::PI;
use std::io::Write;

use denhart::solve::steps;
use denhart_dynamic::DynamicArm;
use serde_json::json;

use crate::Failure;
use crate::answer::{Answer, Asked, Form, given_units, merged};
use crate::inverse::pretty;
use crate::numbers::{Units, count, short};
use crate::table::{aligned, fixed};
use crate::target::Target;

/// Prints the solutions of each of `n` values; whether one of them is exact.
///
/// The values are the middles of equal steps over the limits of the joint, as `sample_redundancy` of generated code takes
/// them. Without limits they go over a turn, of a slide from minus to plus the reach; the arm angle goes over a turn.
///
/// # Errors
/// An arm whose inverse takes no such value; no way to print.
pub fn sweep(
    arm: &DynamicArm,
    target: &Target,
    n: u32,
    form: Form,
    as_json: bool,
    out: &mut dyn Write,
) -> Result<bool, Failure> {
    let mut answers = Vec::new();
    for value in values(arm, n)? {
        let asked = Asked { target: target.clone(), given: vec![value], near: None };
        answers.push(Answer::new(arm, asked, form)?);
    }
    let name = arm.given()?.concat();
    if as_json {
        writeln!(out, "{}", pretty(&json(&name, &answers)?)?)?;
    } else {
        write!(out, "{}", text(arm, &name, &answers, form.units)?)?;
    }
    out.flush()?;
    Ok(answers.iter().any(Answer::is_exact))
}

/// The values, rad or length.
fn values(arm: &DynamicArm, n: u32) -> Result<impl Iterator<Item = f64>, Failure> {
    let ranges = arm.given_ranges()?;
    let [low, high] = match *ranges.as_slice() {
        [range] => range,
        [_, _, ..] => {
            return Err(Failure::Usage(format!(
                "--sweep walks one value, and this arm's inverse takes {}: {}\n\
                 help: call it with --given \"a, b\" for each; `sample_redundancy` of generated code walks a grid",
                ranges.len(),
                arm.given()?.join(", ")
            )));
        }
        [] => {
            return Err(Failure::Usage(
                "--sweep: this arm's inverse takes no value beside the target\n\
                 help: leave --sweep out; `redundant` in the arm file names a joint to spare"
                    .to_owned(),
            ));
        }
    };
    // Both ends are finite.
    Ok(steps(low, high, PI, usize::try_from(n).unwrap_or(usize::MAX)))
}

fn json(name: &str, answers: &[Answer]) -> Result<serde_json::Value, Failure> {
    let mut values = Vec::new();
    let mut within = Vec::new();
    for answer in answers {
        if answer.within_limits() > 0 {
            within.extend(answer.given()?);
        }
        values.push(answer.solutions_json()?);
    }
    let head = answers.first().map(Answer::head_json).transpose()?.unwrap_or_default();
    let swept = json!({ "swept": name, "values": values, "values_within_limits": within });
    Ok(merged([head, swept]))
}

fn text(arm: &DynamicArm, name: &str, answers: &[Answer], units: Units) -> Result<String, Failure> {
    let Some(first) = answers.first() else { return Ok(String::new()) };
    let unit = given_units(arm, units)?.concat();
    let found: usize = answers.iter().map(|answer| answer.solutions.len()).sum();
    let mut text = first.head(&count(found, "solution"))?;
    let any_free = answers.iter().any(Answer::any_free);
    let start = |cell: String, row: Vec<String>| [cell].into_iter().chain(row).collect::<Vec<String>>();
    let mut table = vec![start(format!("with {name}"), first.header(any_free))];
    for answer in answers {
        let value = one(answer)?;
        for (number, solution) in answer.listed() {
            table.push(start(fixed(value), answer.row(number, solution, any_free)?));
        }
    }
    if table.len() > 1 {
        text += "\n";
        text += &aligned(&table);
    }
    text += "\n";
    let all = count(answers.len(), "value");
    for (words, is_so) in [
        ("with solutions within limits", (|answer| answer.within_limits() > 0) as fn(&Answer) -> bool),
        ("with solutions outside limits alone", |answer| answer.within_limits() == 0 && !answer.solutions.is_empty()),
        ("without solution", |answer| answer.solutions.is_empty()),
    ] {
        let n = answers.iter().filter(|answer| is_so(answer)).count();
        let ranges = ranges(answers, is_so)?;
        let listed = if n == 0 { String::new() } else { format!(": {name} {} {unit}", ranges.join(", ")) };
        text += &format!("{n} of {all} {words}{listed}\n");
    }
    Ok(text)
}

/// The value that an answer was asked with.
fn one(answer: &Answer) -> Result<f64, Failure> {
    Ok(answer.given()?.first().copied().unwrap_or(f64::NAN))
}

/// The values for which something holds: of neighbors the first and the last.
fn ranges(answers: &[Answer], is_so: fn(&Answer) -> bool) -> Result<Vec<String>, Failure> {
    let mut ranges = Vec::new();
    for run in answers.chunk_by(|one, next| is_so(one) == is_so(next)) {
        let ends = [run.first(), run.last()].map(|end| end.filter(|answer| is_so(answer)));
        if let [Some(first), Some(last)] = ends {
            let [low, high] = [first, last].map(one);
            let [low, high] = [low?, high?].map(short);
            ranges.push(if run.len() == 1 { low } else { format!("{low} to {high}") });
        }
    }
    Ok(ranges)
}
