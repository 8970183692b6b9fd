//! The command `denhart` as a function. Each subcommand has a file of its own.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod answer;
mod arm;
mod arms;
mod batch;
mod check;
mod documents;
#[cfg(feature = "draw")]
mod draw;
mod export;
mod files;
mod follow;
mod forward;
mod hints;
mod import;
mod inverse;
mod lines;
mod new;
mod number_arguments;
mod numbers;
mod progress;
mod style;
mod suggest;
mod sweep;
mod table;
mod target;
mod templates;
mod trace;
#[cfg(feature = "view")]
mod view;

use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;

use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use denhart_codegen::{BuildError, Builder, Errors, ScalarKind};

use crate::style::{Labels, Plain};

/// Done.
const SUCCESS: u8 = 0;
/// Mistakes in the arm file, no inverse where one is asked for, or no way to read or to print.
const FAILURE: u8 = 1;
/// Arguments that make no sense.
const USAGE: u8 = 2;
/// A target without an exact solution.
const NO_SOLUTION: u8 = 3;

/// Kinematics of robot arms, generated from their Denavit-Hartenberg table.
#[derive(Parser)]
#[command(name = "denhart", version, arg_required_else_help = true)]
#[command(
    after_help = "Exit status: 0 done; 1 mistakes in the file, an arm without inverse where one is asked for, a limit that ends a \
                  trace; 2 wrong arguments; 3 (of inverse and draw) no exact solution, (of follow) no continuous path."
)]
struct Command {
    #[command(subcommand)]
    action: Action,
}

#[derive(Subcommand)]
enum Action {
    /// Print the generated code of an arm: the struct and its impls, formatted
    ///
    /// It is the code that #[derive(Arm)] and denhart_codegen::Builder make, to read or to commit. It needs the crate
    /// `denhart` alone and compiles under #![no_std].
    Expand(Expand),
    /// Print what the generator found in an arm file, or the mistakes in it
    ///
    /// The axes that are parallel or meet, the way the inverse kinematics is solved, the largest number of solutions,
    /// and the operation counts. Axes, frames and tool of the arm at its zero, and its reach, are to hold against a drawing. Then advice on the file.
    Check(check::Options),
    /// Print the motion of the tool under motion laws of the joints, as CSV or JSON
    ///
    /// Columns: t (s), the joints q1 .. qN, the position x y z of the tool in the base frame, its orientation. Then its
    /// velocity vx vy vz, angular velocity wx wy wz, acceleration ax ay az and angular acceleration dwx dwy dwz.
    /// Lengths are in the unit of the arm file, angles as --units says, times in s. Rates are exact derivatives of the
    /// laws.
    Trace(trace::Options),
    /// Print the pose of the tool at joint values
    ///
    /// As a matrix, as roll, pitch, yaw (R = Rz(yaw) Ry(pitch) Rx(roll)) and as a unit quaternion, scalar part first.
    /// Lengths are in the unit of the arm file. Joints outside their limits are named.
    Forward(forward::Options),
    /// Print every joint vector that brings the tool to a target
    ///
    /// For each solution: joint values, branch, flags, broken limits, and what forward kinematics misses the target by.
    /// Without an exact solution it says whether distance or direction is missed, and the exit status is 3.
    Inverse(inverse::Options),
    /// Print joint values over time that bring the tool along a path of poses, within the rates of the joints
    ///
    /// With --keep path the tool keeps to the path, and takes the time it needs: the fastest of all branches and turns. With
    /// --keep time the tool keeps the times of the poses, and deviates where the rates do not allow them. Rates are those
    /// of the arm file, or of --max-velocity and --max-acceleration. Where no continuous path exists, the time, the branch and the
    /// reason are named, and the exit status is 3.
    Follow(follow::Options),
    /// Draw an arm at joint values, or every solution of a target, as SVG or PNG
    ///
    /// Without joint values and target all joints are at 0, to hold against a drawing: with --frames and --dimensions. A
    /// cylinder turns about its axis, a box slides along it; the arrow shows the positive motion by the right hand. With a
    /// target every solution has its color, those outside the limits are dashed; a target out of reach is drawn with the
    /// closest approach.
    #[cfg(feature = "draw")]
    Draw(draw::Options),
    /// Show an arm in the browser, with the generator in the page, or write that page to a file
    ///
    /// The arm is moved by sliders and by dragging its target, with every solution beside it; the arm file is edited in place,
    /// with its mistakes, the generated code and the report. The page is served at 127.0.0.1 alone, at a free port; it follows
    /// changes of the file, and writes it only with --write.
    #[cfg(feature = "view")]
    View(view::Options),
    /// Print an arm file for a serial chain of a URDF
    ///
    /// Joints that turn, slide or are fixed; limits, velocities and names are kept, and so are zero and direction of each joint.
    /// Mimic joints become the `coupling` of the file where it can say them. The file's poses are compared with the
    /// URDF's own at 1000 random configurations; a difference above 1e-9 is an error.
    Import(import::Options),
    /// Write the arm as a library for C
    Export(export::Options),
    /// Write an arm file to start from: one with comments, or that of an arm that `denhart arms` lists
    New(new::Options),
    /// List the arms whose files `denhart new --like` writes
    ///
    /// Of each its name, its joints (R turns, P slides), the task of its inverse, and the source of its numbers.
    Arms(arms::Options),
    /// Print the JSON schema of arm files, for editors
    Schema,
    /// Print the completions of this command for a shell
    Completions(documents::Completions),
    /// Print the manual page of this command, or write one for each subcommand
    Man(documents::Man),
}

#[derive(Args)]
struct Expand {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// Name of the struct [default: the arm's name, in upper camel case]
    #[arg(long = "type", value_name = "NAME")]
    type_name: Option<String>,
    /// Number type of the generated code
    #[arg(long, value_name = "TYPE", default_value = "f64")]
    scalar: Scalar,
    /// Bind the `parameters` of the file at run time: a public field of the struct for each
    #[arg(long)]
    parameters: bool,
    /// Emit the functions over lanes, too, for denhart::batch: many poses at a time
    #[arg(long)]
    batch: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Scalar {
    F64,
    F32,
}

impl From<Scalar> for ScalarKind {
    fn from(scalar: Scalar) -> Self {
        match scalar {
            Scalar::F64 => Self::F64,
            Scalar::F32 => Self::F32,
        }
    }
}

/// Runs the command with `arguments`, the first being the name of the program; returns the exit status.
///
/// A reader of `out` that goes away, as in `denhart expand ur5.yaml | head`, ends the command quietly.
pub fn run<I>(arguments: I, out: &mut dyn Write, err: &mut dyn Write) -> u8
where
    I: IntoIterator<Item: Into<OsString>>,
{
    run_styled(arguments, &mut Plain::new(out), &mut Plain::new(err))
}

/// [`run`] with colors, as escape sequences for a terminal. `out` and `err` take them out where there is none.
pub fn run_styled<I>(arguments: I, out: &mut dyn Write, err: &mut dyn Write) -> u8
where
    I: IntoIterator<Item: Into<OsString>>,
{
    let arguments: Vec<OsString> = arguments.into_iter().map(Into::into).collect();
    let err = &mut Labels::new(err);
    let result = match Command::try_parse_from(&arguments) {
        Ok(Command { action }) => act(action, out, err),
        Err(shown) if shown.use_stderr() => return say(err, &refused(&shown, &arguments), USAGE),
        Err(help) => print(out, &help.render().ansi().to_string()).map_err(Failure::from),
    };
    match result {
        Ok(()) | Err(Failure::NoReader) => said(err, SUCCESS),
        Err(Failure::Said) => said(err, FAILURE),
        Err(Failure::NoSolution) => said(err, NO_SOLUTION),
        Err(Failure::Usage(mistake)) => say(err, &format!("error: {mistake}"), USAGE),
        Err(Failure::Other(mistake)) => say(err, &format!("error: {mistake}"), FAILURE),
    }
}

/// The message for arguments that make no sense.
fn refused(shown: &clap::Error, arguments: &[OsString]) -> String {
    let words = arguments.iter().skip(1).map(|word| word.to_str().map(str::to_owned)).collect::<Option<Vec<_>>>();
    let suggested = words.and_then(|words| suggest::suggestion(shown, &words, &<Command as CommandFactory>::command()));
    suggested.map_or_else(|| shown.render().ansi().to_string(), |message| format!("error: {message}"))
}

fn act(action: Action, out: &mut dyn Write, err: &mut dyn Write) -> Result<(), Failure> {
    match action {
        Action::Expand(options) => {
            let code = expand(options).map_err(Failure::Other)?;
            Ok(print(out, &code)?)
        }
        Action::Check(options) => match check::run(&options, &mut Labels::new(out), err)? {
            true => Ok(()),
            false => Err(Failure::Said),
        },
        Action::Trace(options) => trace::run(&options, out),
        Action::Forward(options) => forward::run(&options, &mut Labels::new(out)),
        Action::Inverse(options) => match inverse::run(&options, &mut Labels::new(out), err)? {
            true => Ok(()),
            false => Err(Failure::NoSolution),
        },
        #[cfg(feature = "draw")]
        Action::Draw(options) => match draw::run(&options, out, &mut Labels::new(err))? {
            true => Ok(()),
            false => Err(Failure::NoSolution),
        },
        #[cfg(feature = "view")]
        Action::View(options) => view::run(&options, out),
        Action::Import(options) => import::run(&options, out, err).map_err(Failure::Other),
        Action::Export(options) => export::run(&options, out, err),
        Action::Follow(options) => match follow::run(&options, out, err)? {
            true => Ok(()),
            false => Err(Failure::NoSolution),
        },
        Action::New(options) => new::run(&options, out),
        Action::Arms(options) => arms::run(&options, out),
        Action::Schema => Ok(print(out, &denhart_tools::schema::text())?),
        Action::Completions(options) => documents::completions(&options, <Command as CommandFactory>::command(), out),
        Action::Man(options) => documents::man(&options, <Command as CommandFactory>::command(), out),
    }
}

/// Why the command did not do what was asked.
#[derive(Debug)]
enum Failure {
    /// Arguments that make no sense.
    Usage(String),
    /// A mistake in a file, or no way to read or write.
    Other(String),
    /// The messages are printed.
    Said,
    /// No joint vector reaches the target exactly; the answer says so.
    NoSolution,
    /// Whoever read the output has gone away.
    NoReader,
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == ErrorKind::BrokenPipe {
            Self::NoReader
        } else {
            Self::Other(format!("cannot write: {error}"))
        }
    }
}

fn expand(options: Expand) -> Result<String, String> {
    let Expand { file, type_name, scalar, parameters, batch } = options;
    let (text, name) = arm::text(&file)?;
    let mut builder =
        Builder::of_text(text, name).scalar(ScalarKind::from(scalar)).runtime_parameters(parameters).batch(batch);
    if let Some(name) = type_name {
        builder = builder.type_name(name);
    }
    builder.generate().map_err(|error| match error {
        BuildError::Arm(errors) => each(&errors),
        other => other.to_string(),
    })
}

/// The mistakes of a file, each with the prefix that the first one gets where it is printed.
fn each(mistakes: &Errors) -> String {
    denhart_tools::Error::from(mistakes.clone()).to_string()
}

fn print(out: &mut dyn Write, text: &str) -> io::Result<()> {
    writeln!(out, "{}", text.trim_end())?;
    out.flush()
}

/// Prints to the standard error. Where that fails too, the exit status is all that is left to say.
fn say(err: &mut dyn Write, text: &str, status: u8) -> u8 {
    let _ = print(err, text);
    status
}

/// The exit status, with all messages written.
fn said(err: &mut dyn Write, status: u8) -> u8 {
    let _ = err.flush();
    status
}
