//! `denhart follow`: joint values over time that bring the tool along a path of poses.

mod answer;
#[cfg(feature = "draw")]
mod picture;
mod poses;
mod rates;

use std::fs::File;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use denhart_dynamic::plan::{PathError, PlanError};
use denhart_dynamic::{DynamicArm, WholeTarget};
use denhart_tools::follow::{self, Asked, Refused, follow};

use crate::Failure;
use crate::files;
use crate::inverse::{GivenOrNear, beside};
use crate::number_arguments::{joint_vector, single_number};
use crate::numbers::{Units, count, outside};
use crate::progress::Progress;
use crate::target::{is_standard_input, listed, shown};
use answer::{Answer, Form};
use poses::{Pose, Poses};

/// The progress bar, of the path.
const BAR: &str = "{wide_bar} {percent} %, {eta} left";
/// Parts of the path that the bar counts.
const PARTS: f64 = 1000.0;
/// Looks between two looks at the clock.
const BETWEEN_LOOKS: u64 = 1;

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// The poses of the path, one a line, from a file or `-`, the standard input: CSV, with or without names, or JSON lines
    ///
    /// Lines are those of `inverse --batch`. The column or key t has the time of the pose, s; a line without names has it
    /// first. Between poses the path is smooth; where its direction turns by more than 30 degrees it has a corner.
    #[arg(long, value_name = "FILE")]
    path: PathBuf,
    /// The path or its times: one of them is kept where the rates of the joints do not allow both
    #[arg(long, value_name = "WHAT", default_value = "path")]
    keep: Keep,
    /// Joint values at the first pose [default: the best of all solutions]
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    start: Option<String>,
    /// The value of the redundant joint, or the arm angle, along the path; of several "a, b" [default: that of --start]
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    given: Option<String>,
    /// Largest distance of the tool from the path, mm, with --keep path [default: 1e-5 of the reach]
    #[arg(long, value_name = "MM", allow_hyphen_values = true, value_parser = single_number)]
    tolerance: Option<f64>,
    /// Time between two rows, s
    #[arg(long, value_name = "T", default_value_t = 0.001, allow_hyphen_values = true, value_parser = single_number)]
    period: f64,
    /// Greatest velocity of each joint, per s [default: those of the arm file]
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    max_velocity: Option<String>,
    /// Greatest acceleration of each joint, per s^2 [default: those of the arm file, else none]
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    max_acceleration: Option<String>,
    /// Velocities and accelerations are those of the motors, which the arm file's `coupling` links to the joints
    #[arg(long)]
    motor_rates: bool,
    /// Unit of angles, given and printed
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// Print JSON: an object with the units, and one for each row
    #[arg(long)]
    json: bool,
    /// Write to this file instead of the standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw the joints with their limits and their velocities over time too, as SVG
    #[cfg(feature = "draw")]
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Keep {
    /// The tool keeps to the path and slows down
    Path,
    /// The tool keeps the times of the poses and deviates
    Time,
}

impl From<Keep> for follow::Keep {
    fn from(keep: Keep) -> Self {
        match keep {
            Keep::Path => Self::Path,
            Keep::Time => Self::Time,
        }
    }
}

/// Prints the joint values over time; true if the path is continuous, or its end is met.
///
/// # Errors
/// Wrong arguments or lines, mistakes in the file, an arm without inverse, no way to print.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<bool, Failure> {
    if is_standard_input(&options.file) && is_standard_input(&options.path) {
        let twice = "the standard input has either the arm or the path\nhelp: name a file for one of them";
        return Err(Failure::Usage(twice.to_owned()));
    }
    apart(options)?;
    let arm = crate::inverse::arm(&options.file)?;
    let poses = Poses::read(&arm, &options.path, options.units)?;
    let (targets, asked, mut remarks) = asked(&arm, options, &poses)?;
    let keep = options.keep.into();
    let mut progress = Progress::new(PARTS as u64, BAR, BETWEEN_LOOKS, !io::stdout().is_terminal());
    let mut watch = |at: f64| {
        progress.look((PARTS * at / asked.end()) as u64);
        true
    };
    let motion = follow(&asked, keep, &mut watch).map_err(|error| refused(&asked, options, error))?;
    drop(progress);
    if motion.obstacle.is_some() {
        remarks.extend(out_of_reach(&arm, &poses, &targets, &shown(&options.path))?);
    }
    let answer = Answer { keep, motion };
    #[cfg(feature = "draw")]
    if let Some(file) = &options.plot
        && !answer.motion.rows.is_empty()
    {
        picture::write(&asked, &answer, options.units, file)?;
    }
    let form = Form { units: options.units, json: options.json, is_timed: asked.is_timed() };
    match &options.output {
        None => answer.write(&arm, form, out)?,
        // Without rows there is a table for JSON alone, which says why.
        Some(_) if answer.motion.rows.is_empty() && !options.json => {}
        Some(file) => {
            let cannot = |error: io::Error| Failure::Other(format!("cannot write `{}`: {error}", file.display()));
            answer.write(&arm, form, &mut BufWriter::new(File::create(file).map_err(cannot)?))?;
        }
    }
    remarks.extend(rates::without_acceleration(&arm, &asked.rates));
    for line in answer.said(&arm, form).into_iter().chain(remarks) {
        writeln!(err, "{line}")?;
    }
    Ok(answer.motion.obstacle.is_none())
}

/// No two of arm file, path, table and picture are one file.
fn apart(options: &Options) -> Result<(), Failure> {
    let mut places = vec![("the arm file", options.file.as_path()), ("--path", options.path.as_path())];
    places.extend(options.output.as_deref().map(|path| ("-o", path)));
    #[cfg(feature = "draw")]
    places.extend(options.plot.as_deref().map(|path| ("--plot", path)));
    for (number, (name, path)) in places.iter().enumerate() {
        if let Some((other, _)) = places.iter().take(number).find(|(_, other)| files::are_one(other, path)) {
            let path = path.display();
            return Err(Failure::Usage(format!("{name}: `{path}` is {other} too\nhelp: name another file")));
        }
    }
    Ok(())
}

/// The poses with the values beside them, the task, and remarks about the path.
fn asked<'a>(
    arm: &'a DynamicArm,
    options: &Options,
    poses: &Poses,
) -> Result<(Vec<WholeTarget>, Asked<'a>, Vec<String>), Failure> {
    let units = options.units;
    if options.keep == Keep::Time && options.tolerance.is_some() {
        let message = "--tolerance: a tool that keeps the time deviates as far as the rates ask for\n\
                       help: leave --tolerance out, or keep the path";
        return Err(Failure::Usage(message.to_owned()));
    }
    let rates = rates::read(arm, options.max_velocity.as_deref(), options.max_acceleration.as_deref(), units)?;
    let start = options.start.as_deref().map(|text| joint_vector("--start", text, arm, units)).transpose()?;
    if let Some(broken) = start.as_deref().and_then(|start| outside(arm, start, units).into_iter().next()) {
        return Err(Failure::Usage(format!("--start: {broken}\nhelp: start within the limits of the joints")));
    }
    let given = beside(arm, &GivenOrNear { given: options.given.as_deref(), near: None, units }, None)?.given;
    let given = match &start {
        Some(start) if given.is_empty() => arm.held(start)?,
        _ => given,
    };
    let name = shown(&options.path);
    let targets = whole(arm, options, poses, &given)?;
    let asked = Asked::new(arm, &targets, poses.times.as_deref());
    let mut asked = asked.map_err(|error| no_path(poses, &name, error))?;
    (asked.start, asked.rates, asked.period) = (start, rates, options.period);
    asked.motor_rates = options.motor_rates;
    if let Some(tolerance) = options.tolerance {
        asked.tolerance = tolerance * (1e-3 / arm.length_unit().in_meters());
    }
    let left_out = poses.left_out.join(", ");
    let remarks = if left_out.is_empty() { Vec::new() } else { vec![format!("{name}: left out: {left_out}")] };
    Ok((targets, asked, remarks))
}

/// The poses with the values beside them: their own, in every line or in none, or else `given`.
fn whole(arm: &DynamicArm, options: &Options, poses: &Poses, given: &[f64]) -> Result<Vec<WholeTarget>, Failure> {
    let (name, units) = (shown(&options.path), options.units);
    let have_own = poses.lines.first().is_some_and(|pose| !pose.target.given.is_empty());
    if have_own && options.given.is_some() {
        let message = format!("--given: the poses of {name} have `given` of their own\nhelp: leave one of them out");
        return Err(Failure::Usage(message));
    }
    if let Some(odd) = poses.lines.iter().find(|pose| pose.target.given.is_empty() == have_own) {
        let (found, wanted) = if have_own { ("no", "has one") } else { ("a", "has none") };
        return Err(Failure::Usage(format!(
            "{name}:{}: {found} `given`, but the first pose {wanted}\n\
             help: write it in every line, or in none and --given for all",
            odd.number
        )));
    }
    if !have_own && given.len() != arm.given()?.len() {
        return Err(crate::inverse::not_given(arm, units, "--start with the joint values to begin at")?);
    }
    let own = |pose: &Pose| WholeTarget::new(pose.target.target, if have_own { &pose.target.given } else { given });
    Ok(poses.lines.iter().map(own).collect())
}

/// Names the first pose that no joint values reach, with a hint if its unit may be another; of others how many they are.
fn out_of_reach(
    arm: &DynamicArm,
    poses: &Poses,
    targets: &[WholeTarget],
    name: &str,
) -> Result<Option<String>, Failure> {
    let mut missed = Vec::new();
    for (pose, WholeTarget { target, given }) in poses.lines.iter().zip(targets) {
        if !arm.inverse(target, given)?.status().is_reachable() {
            missed.push(pose);
        }
    }
    let [first, rest @ ..] = &missed[..] else { return Ok(None) };
    let rest =
        if rest.is_empty() { String::new() } else { format!(", nor those of {}", count(rest.len(), "other line")) };
    let hint = first.target.hint_of_unit(arm).map(|hint| format!("\nhint: {hint}")).unwrap_or_default();
    Ok(Some(format!("{name}:{}: no joint values reach this pose{rest}{hint}", first.number)))
}

/// The failure of what is refused, with the options of the command.
fn refused(asked: &Asked, options: &Options, error: Refused) -> Failure {
    let units = options.units;
    Failure::Usage(match error {
        Refused::NoVelocity(joints) => format!(
            "the arm file has no velocity of {}\n\
             help: write max_velocity in the rows of the file, or --max-velocity with a value per s for each joint",
            joints.join(", ")
        ),
        Refused::Untimed => {
            let name = shown(&options.path);
            format!(
                "--keep time: {name} has no times\nhelp: add a column t with the time of each pose in s, or keep the path"
            )
        }
        Refused::Tolerance(_) => {
            let tolerance = options.tolerance.unwrap_or_default();
            format!(
                "--tolerance: {tolerance} is no distance from the path\nhelp: write one above 0, in mm, such as 0.1"
            )
        }
        Refused::Period(_) => format!("--period: {error}\nhelp: write one above 0, such as 0.001"),
        Refused::Rows { .. } => format!("--period: {error}\nhelp: write a longer one"),
        Refused::Plan(PlanError::StartAway { nearest, .. }) => {
            let kinds = asked.arm.joint_kinds().iter().zip(&nearest);
            let values: Vec<f64> = kinds.map(|(kind, value)| units.of_joint(*kind, *value)).collect();
            format!(
                "--start: these joint values are not at the first pose\n\
                 help: the nearest solution there is --start \"{}\"; leave --start out for the best of all",
                listed(&values)
            )
        }
        Refused::Plan(PlanError::Target { at }) => format!("--path: the pose at {at} is not finite, or no rotation"),
        Refused::Arm(error) => return error.into(),
        Refused::Joints(_) => return Failure::Other(error.to_string()),
        error => error.to_string(),
    })
}

/// The failure of poses that are no path, with the line.
fn no_path(poses: &Poses, name: &str, error: PathError) -> Failure {
    let line = |index: usize| poses.lines.get(index).map_or(0, |pose| pose.number);
    let times = |index: usize| {
        let at = |index: usize| poses.times.as_ref().and_then(|times| times.get(index)).copied().unwrap_or(f64::NAN);
        (at(index), at(index.saturating_sub(1)))
    };
    Failure::Usage(match error {
        PathError::Unsorted(index) => {
            let (time, before) = times(index);
            let line = line(index);
            format!(
                "{name}:{line}: the time {time} is not above {before}, the one before it\nhelp: sort the lines by t, each time once"
            )
        }
        PathError::HalfTurn(index) => format!(
            "{name}:{}: the direction is opposite to the one before it, and no way between them is the shorter\nhelp: add a pose between them",
            line(index)
        ),
        PathError::NotFinite(index) | PathError::Kind(index) => {
            format!("{name}:{}: {error}\nhelp: write finite numbers, of the arm's task", line(index))
        }
        PathError::TooShort | PathError::Times { .. } => {
            format!("{name}: {error}\nhelp: write one pose a line, two lines at least")
        }
        _ => format!("{name}: {error}"),
    })
}
