//! `denhart draw`: an arm, its frames and its solutions as a picture.

mod output;
mod terminal;

use std::io::Write;
use std::path::PathBuf;

use clap::{ArgGroup, Args, ValueEnum};
use denhart::Branch;
use denhart_draw::{DrawError, Scene, Style, Theme, View, apart, section};
use denhart_dynamic::{DynamicArm, DynamicError};
use denhart_tools::closest::{Closest, Missed};

use crate::Failure;
use crate::answer::{Answer, Asked, Form};
use crate::inverse::{Beside, GivenOrNear, beside};
use crate::number_arguments::joint_vector;
use crate::numbers::{Units, arm, short};
use crate::target::{SPELLINGS, Spelling, Target};

/// The arguments of the command.
#[derive(Args)]
#[command(group = ArgGroup::new("target").args(SPELLINGS))]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    #[command(flatten)]
    spelling: Spelling,
    /// At joint values that show the joints apart, in place of 0
    #[arg(long, conflicts_with = "target")]
    apart: bool,
    /// With --q: every other solution of the pose too
    #[arg(long)]
    solutions: bool,
    /// The value of the redundant joint, or the arm angle [default: that of --near, else of --q]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, conflicts_with = "near")]
    given: Option<String>,
    /// Joint values that the solutions are to be next to, the nearest first
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    near: Option<String>,
    /// From where [default: top for an arm that moves in the xy plane, side with --workspace, else iso]
    #[arg(long, value_name = "VIEW")]
    view: Option<Direction>,
    /// The frames of the table: x and z of each
    #[arg(long)]
    frames: bool,
    /// The lengths a and d of the table, with their values
    #[arg(long)]
    dimensions: bool,
    /// The axes that decide the inverse: those that meet in a point or are parallel
    #[arg(long)]
    axes: bool,
    /// The section that the tool reaches within the limits, and its singular curves
    #[arg(long)]
    workspace: bool,
    /// Colors: auto is light, and dark where the viewer of the SVG prefers that
    #[arg(long, value_name = "THEME", default_value = "auto")]
    theme: Colors,
    /// Width and height of the drawing, px; below a width of 480 names, legend and notes are left out
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "720x440", value_parser = size)]
    size: [f64; 2],
    /// Width of a PNG, px [default: twice that of --size]
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(16..=8000))]
    width: Option<u32>,
    /// Unit of angles
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// Write to this file, .svg or .png; `-` prints the SVG [default: the terminal if it shows pictures, else NAME.svg]
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Direction {
    /// From the tip of x: y to the right, z up
    Front,
    /// From -y: x to the right, z up
    Side,
    /// From above: x to the right, y up
    Top,
    /// From the right in front, a little above
    Iso,
}

#[derive(Clone, Copy, ValueEnum)]
enum Colors {
    Auto,
    Light,
    Dark,
}

impl From<Direction> for View {
    fn from(direction: Direction) -> Self {
        match direction {
            Direction::Front => View::Front,
            Direction::Side => View::Side,
            Direction::Top => View::Top,
            Direction::Iso => View::Iso,
        }
    }
}

/// Reads `720x440`.
fn size(text: &str) -> Result<[f64; 2], String> {
    let wrong = || format!("`{text}` is no size\nhelp: write width and height in px from 160 to 4000, such as 720x440");
    let (width, height) = text.split_once('x').ok_or_else(wrong)?;
    let number = |part: &str| part.parse::<u16>().ok().filter(|px| (160..=4000).contains(px)).map(f64::from);
    Ok([number(width).ok_or_else(wrong)?, number(height).ok_or_else(wrong)?])
}

impl From<DrawError> for Failure {
    fn from(error: DrawError) -> Self {
        match error {
            DrawError::Arm(error) => error.into(),
            other => Self::Other(other.to_string()),
        }
    }
}

/// Draws the picture; whether the target, if there is one, is reached.
///
/// # Errors
/// Wrong arguments, mistakes in the file, an arm without inverse where one is asked for, no way to write.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<bool, Failure> {
    let output = output::Output::of(options.output.as_deref())?;
    if let Some(path) = options.output.as_deref().filter(|path| crate::files::are_one(path, &options.file)) {
        let path = path.display();
        return Err(Failure::Usage(format!("--output: `{path}` is the arm file\nhelp: name another file")));
    }
    let arm = arm(&options.file)?;
    let view = options.view.map_or_else(
        || match View::of(&arm) {
            View::Iso if options.workspace => View::Side,
            view => view,
        },
        View::from,
    );
    let (mut scene, q, reached) = scene(&arm, options, view, err)?;
    if options.frames {
        scene = scene.with_frames();
    }
    if options.dimensions {
        scene = scene.with_dimensions();
    }
    if options.axes {
        scene = scene.with_axes(&arm);
    }
    if options.workspace {
        scene = scene.with_section(section(&arm, &q, view)?);
    }
    let theme = match options.theme {
        Colors::Auto => Theme::Auto,
        Colors::Light => Theme::Light,
        Colors::Dark => Theme::Dark,
    };
    let [width, height] = options.size;
    let style = Style::of(view).with_theme(theme).with_size(width, height);
    let pixels = options.width.unwrap_or((2.0 * width) as u32);
    output.write(&scene, &style, pixels, out)?;
    Ok(reached)
}

/// The scene, the joint values of its first figure, and whether the target is reached.
fn scene(
    arm: &DynamicArm,
    options: &Options,
    view: View,
    err: &mut dyn Write,
) -> Result<(Scene, Vec<f64>, bool), Failure> {
    let units = options.units;
    let q = options.spelling.joint_values().map(|text| joint_vector("--q", text, arm, units)).transpose()?;
    if !options.spelling.is_given() || q.is_some() && !options.solutions {
        let unasked = || if options.apart { apart(arm, view) } else { vec![0.0; arm.joints()] };
        let q = q.unwrap_or_else(unasked);
        return Ok((Scene::of(arm, &q)?, q, true));
    }
    if let Err(DynamicError::NoInverse(reason)) = arm.task() {
        return Err(Failure::Other(format!(
            "no inverse kinematics: {reason}\nhelp: --q draws this arm at joint values; without it all joints are at 0"
        )));
    }
    let mut target = options.spelling.read(arm, units)?;
    let asked = GivenOrNear { given: options.given.as_deref(), near: options.near.as_deref(), units };
    let Beside { given, near, hints } = beside(arm, &asked, Some(&target))?;
    target.hints.extend(hints);
    let pose = target.pose;
    let answer =
        Answer::new(arm, Asked { target, given, near }, Form { units, within_limits: false, branch: Branch::NONE })?;
    for hint in answer.hints() {
        writeln!(err, "hint: {hint}")?;
    }
    let reached = answer.is_exact();
    let first = answer.solutions.first().map(|solution| solution.q.to_vec());
    let scene = match (&q, answer.closest()) {
        (_, Some(closest)) => return Ok((missed(arm, &answer.asked.target, &closest, units)?, closest.q, false)),
        (Some(q), None) => Scene::of(arm, q)?.with_solutions(arm, &answer.solutions)?,
        // So far away that no closest approach is known.
        (None, None) if first.is_none() => {
            let start = answer.asked.near.clone().unwrap_or_else(|| vec![0.0; arm.joints()]);
            Scene::of(arm, &start)?.with_target(pose).with_note("no solution, and the closest approach is not known")
        }
        (None, None) => Scene::of_solutions(arm, pose, &answer.solutions)?,
    };
    Ok((scene, q.or(first).unwrap_or_else(|| vec![0.0; arm.joints()]), reached))
}

/// The closest approach to a target that is not reached.
fn missed(arm: &DynamicArm, target: &Target, closest: &Closest, units: Units) -> Result<Scene, Failure> {
    let scene = Scene::of(arm, &closest.q)?.with_target(target.pose);
    let length = arm.length_unit();
    Ok(match closest.missed {
        Missed::Distance(distance) => scene.with_miss().with_note(format!(
            "out of reach: the closest that iteration finds is {} {length} away",
            short(rounded(distance))
        )),
        Missed::Direction(left) => scene.with_note(format!(
            "the point can be reached, but not with this orientation: closest {} {} off",
            short(rounded(units.of(left.orientation))),
            units.symbol()
        )),
    })
}

/// Four digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_two_numbers() {
        assert_eq!(size("720x440"), Ok([720.0, 440.0]));
        for wrong in ["720", "720x", "0x440", "720x440x1", "-720x440", "9999x9999"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }
}
