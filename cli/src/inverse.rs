//! `denhart inverse`: every joint vector that brings the tool of an arm to a target.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{ArgGroup, Args};
use denhart::Branch;
use denhart_codegen::Report;
use denhart_dynamic::{DynamicArm, DynamicError};
use serde_json::Value;

use crate::Failure;
use crate::answer::{Answer, Asked, Form, given_units};
use crate::batch::Batch;
use crate::hints;
use crate::number_arguments::{NumberList, joint_vector};
use crate::numbers::{Units, count};
use crate::sweep::sweep;
use crate::target::{SPELLINGS, Spelling, Target, is_standard_input};

/// The arguments of the command.
#[derive(Args)]
#[command(group = ArgGroup::new("target").args(SPELLINGS).arg("batch").required(true))]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    #[command(flatten)]
    spelling: Spelling,
    /// Many targets, one a line, from a file or `-`, the standard input: CSV, with or without names, or JSON lines
    ///
    /// Lines of CSV have the numbers of --pose. With a first line of names the columns may be x y z, roll pitch yaw,
    /// qw qx qy qz, r11 to r33, u v w, angle and phi; others do not count. Results are CSV, a line for each solution, or
    /// with --json an object a line, printed as they are computed. A wrong line is told and does not end the run.
    #[arg(long, value_name = "FILE")]
    batch: Option<PathBuf>,
    /// Joint values that the solutions are to be next to, the nearest first
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    near: Option<String>,
    /// The value of the redundant joint, or the arm angle; of several "a, b" in the order of the file [default: those of
    /// --near, else of --q]
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true, conflicts_with = "near")]
    given: Option<String>,
    /// Solve for N values of the redundant joint over its limits, or of the arm angle over a turn
    #[arg(long, value_name = "N", conflicts_with_all = ["near", "given", "batch"], value_parser = clap::value_parser!(u32).range(1..))]
    sweep: Option<u32>,
    /// List only solutions within the limits of the joints
    #[arg(long)]
    within_limits: bool,
    /// List only solutions of a branch, by its parts as they are printed, such as "elbow up, wrist flip"
    #[arg(long, value_name = "BRANCH", default_value = "-", hide_default_value = true)]
    branch: Branch,
    /// Unit of angles, given and printed
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Prints the solutions; whether one is exact, of each target.
///
/// # Errors
/// Wrong arguments, mistakes in the file, an arm without inverse, no way to print.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<bool, Failure> {
    let twice = options.spelling.reads_standard_input() || options.batch.as_deref().is_some_and(is_standard_input);
    if twice && is_standard_input(&options.file) {
        return Err(Failure::Usage(
            "the standard input has either the arm or its targets\nhelp: name a file for one of them".to_owned(),
        ));
    }
    let arm = arm(&options.file)?;
    let asked = GivenOrNear { given: options.given.as_deref(), near: options.near.as_deref(), units: options.units };
    let form = Form { units: options.units, within_limits: options.within_limits, branch: options.branch };
    if let Some(file) = &options.batch {
        let Beside { given, near, hints } = beside(&arm, &asked, None)?;
        for hint in hints {
            writeln!(err, "hint: {hint}")?;
        }
        return Batch { arm: &arm, given, near, form, json: options.json }.run(file, out, err);
    }
    let mut target = options.spelling.read(&arm, options.units)?;
    if let Some(values) = options.sweep {
        return sweep(&arm, &target, values, form, options.json, out);
    }
    let Beside { given, near, hints } = beside(&arm, &asked, Some(&target))?;
    target.hints.extend(hints);
    let answer = Answer::new(&arm, Asked { target, given, near }, form)?;
    if options.json {
        writeln!(out, "{}", pretty(&answer.json()?)?)?;
    } else {
        write!(out, "{}", answer.text()?)?;
    }
    out.flush()?;
    Ok(answer.is_exact())
}

/// The arm of a file, which has an inverse.
///
/// # Errors
/// Mistakes in the file, or an arm without inverse: what the file may ask for instead.
pub fn arm(file: &Path) -> Result<DynamicArm, Failure> {
    let (text, name) = crate::arm::text(file).map_err(Failure::Other)?;
    let arm = DynamicArm::named(&text, &name)?;
    if let Err(DynamicError::NoInverse(reason)) = arm.task() {
        let help =
            denhart_codegen::check(&text, &name).map_or_else(|_| BY_ITERATION.to_owned(), |report| instead(&report));
        return Err(Failure::Other(format!("no inverse kinematics: {reason}\nhelp: {help}")));
    }
    Ok(arm)
}

/// JSON over many lines.
///
/// # Errors
/// A value that is no JSON.
pub fn pretty(value: &Value) -> Result<String, Failure> {
    serde_json::to_string_pretty(value).map_err(|error| Failure::Other(error.to_string()))
}

/// Advice for an arm without closed form.
const BY_ITERATION: &str = "`denhart::numeric` solves any arm by iteration";

/// The requests that an arm file may have in place of one without inverse.
fn instead(report: &Report) -> String {
    match (&report.hint, &report.instead[..]) {
        (Some(hint), _) => format!("{hint}; {BY_ITERATION}"),
        (None, []) => format!("this arm has a closed form for no task of docs/tasks.md; {BY_ITERATION}"),
        (None, [one]) => format!("write `{one}` in the file; {BY_ITERATION}"),
        (None, [one, others @ ..]) => {
            let others: Vec<String> = others.iter().map(|request| format!("`{request}`")).collect();
            format!("write `{one}` in the file, or {}; {BY_ITERATION}", others.join(", "))
        }
    }
}

/// The options beside the target, as typed.
pub struct GivenOrNear<'a> {
    pub given: Option<&'a str>,
    pub near: Option<&'a str>,
    pub units: Units,
}

/// The options beside the target.
pub struct Beside {
    pub given: Vec<f64>,
    pub near: Option<Vec<f64>>,
    pub hints: Vec<String>,
}

/// Reads them; a target at joint values, or with values of its own, gives the redundant joints theirs.
///
/// # Errors
/// No numbers, or a value too many or too few.
pub fn beside(arm: &DynamicArm, options: &GivenOrNear, target: Option<&Target>) -> Result<Beside, Failure> {
    let units = options.units;
    let near = options.near.map(|text| joint_vector("--near", text, arm, units)).transpose()?;
    let mut hints: Vec<String> = Vec::new();
    hints.extend(near.as_deref().and_then(|near| hints::of_joints("--near", arm, near, units)));
    let names = arm.given()?;
    let own = target.map(|target| target.given.as_slice()).filter(|given| !given.is_empty());
    let given = match options.given {
        Some(_) if names.is_empty() => {
            return Err(Failure::Usage(
                "--given: this arm's inverse takes no such value\nhelp: leave --given out".to_owned(),
            ));
        }
        Some(text) => {
            let values = given(text, arm, &names, units)?;
            // A slide is a length; everything else that is given is an angle.
            let slides = arm.given_slides()?;
            let turning = values.iter().zip(&slides).filter(|(_, slides)| !**slides);
            let angles: Vec<f64> = turning.map(|(value, _)| *value).collect();
            hints.extend(hints::of_angles("--given", &angles, units));
            let each = values.into_iter().zip(slides);
            each.map(|(value, slides)| if slides { value } else { units.rad(value) }).collect()
        }
        None => match (own, target.and_then(|target| target.q.as_deref())) {
            (Some(own), _) => own.to_vec(),
            (None, Some(q)) => arm.held(q)?,
            // Each line of a batch may have its own.
            (None, None) if names.is_empty() || near.is_some() || target.is_none() => Vec::new(),
            (None, None) => return Err(not_given(arm, units, NEAR)?),
        },
    };
    Ok(Beside { given, near, hints })
}

/// The other way of a target to its values beside it.
pub const NEAR: &str = "--near with the joint values to be next to";

/// The failure of a target without the values that the inverse takes beside it. `or`: what can be written in place of
/// `--given`.
///
/// # Errors
/// An arm without inverse.
pub fn not_given(arm: &DynamicArm, units: Units, or: &str) -> Result<Failure, Failure> {
    let (names, each) = (arm.given()?, given_units(arm, units)?);
    let (values, in_units) = match (names.as_slice(), each.as_slice()) {
        ([_], [unit]) => ("its value", format!("in {unit}")),
        _ => {
            let named = names.iter().zip(&each).map(|(name, unit)| format!("{name} in {unit}"));
            ("values", format!("\"{}\"", named.collect::<Vec<_>>().join(", ")))
        }
    };
    Ok(Failure::Usage(format!(
        "the target leaves {} to choose\n\
         help: add --given with {values} {in_units}, or {or}",
        names.join(", ")
    )))
}

/// A number for each of these values.
fn given(text: &str, arm: &DynamicArm, names: &[String], units: Units) -> Result<Vec<f64>, Failure> {
    let (option, wanted) = ("--given", [names.len()]);
    let list = NumberList { option, text, angle: units, length: arm.length_unit(), wanted: &wanted };
    let values = list.parse()?;
    if values.len() == names.len() {
        return Ok(values);
    }
    let found = count(values.len(), "number");
    Err(match names {
        [_] => list.wrong_count(&format!("{found}, but one is needed"), &format!("write one, such as {option} 0.5")),
        names => {
            let each: Vec<String> =
                names.iter().zip(given_units(arm, units)?).map(|(name, unit)| format!("{name} in {unit}")).collect();
            let help = format!("write a number for each: {}", each.join(", "));
            list.wrong_count(&format!("{found}, but the inverse takes {}", names.len()), &help)
        }
    })
}
