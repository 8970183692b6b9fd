//! The command `denhart` as a function: `denhart expand FILE` prints the generated code of an arm, `denhart check FILE`
//! what the generator found in it, `denhart trace FILE` the motion of its tool under a motion law, `denhart forward FILE`
//! where the tool is, and `denhart inverse FILE` the joint vectors that bring it somewhere.

mod arm;
mod import;
mod trace;

use std::env;
use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueEnum};
use denhart_codegen::{Builder, ScalarKind};

/// Done.
const SUCCESS: u8 = 0;
/// Mistakes in the arm file, or no way to read it or to print.
const FAILURE: u8 = 1;
/// Arguments that make no sense.
const USAGE: u8 = 2;
/// A target without an exact solution.
const NO_SOLUTION: u8 = 3;

/// Kinematics of robot arms, generated from their Denavit-Hartenberg table.
#[derive(Parser)]
#[command(name = "denhart", version, arg_required_else_help = true)]
#[command(
    after_help = "Exit status: 0 done, 1 mistakes in the file, 2 wrong arguments, 3 (of inverse) no exact solution."
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
    /// the operation counts, and advice on the file.
    Check(Check),
    /// Print the motion of the tool under motion laws of the joints, as CSV
    ///
    /// Columns: t (s), the joints q1 .. qN, the position x y z of the tool in the base frame, its orientation, its
    /// velocity vx vy vz and angular velocity wx wy wz, its acceleration ax ay az and angular acceleration dwx dwy dwz.
    /// Lengths are in the unit of the arm file, angles as --units says, times in s. Rates are exact derivatives of the
    /// laws.
    Trace(trace::Options),
    /// Print an arm file for a serial chain of a URDF
    ///
    /// Joints that turn, slide or are fixed; limits and names are kept, and so are zero and direction of each joint.
    /// Mimic joints become the `coupling` of the file where it can say them. The file's poses are compared with the
    /// URDF's own at 1000 random configurations; a difference above 1e-9 is an error.
    Import(import::Options),
}

#[derive(Args)]
struct Expand {
    /// The arm file, YAML
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
}

#[derive(Args)]
struct Check {
    /// The arm file, YAML
    file: PathBuf,
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
    I: IntoIterator<Item: Into<OsString> + Clone>,
{
    let result = match Command::try_parse_from(arguments) {
        Ok(Command { action: Action::Expand(options) }) => expand(options),
        Ok(Command { action: Action::Check(Check { file }) }) => check(&file),
        Ok(Command { action: Action::Trace(options) }) => {
            return match trace::run(&options, out) {
                Ok(()) | Err(trace::Failure::NoReader) => SUCCESS,
                Err(trace::Failure::Usage(mistake)) => say(err, &format!("error: {mistake}"), USAGE),
                Err(trace::Failure::Other(mistake)) => say(err, &format!("error: {mistake}"), FAILURE),
            };
        }
        Ok(Command { action: Action::Import(options) }) => {
            return match import::run(&options, out, err) {
                Ok(()) => SUCCESS,
                Err(mistake) => say(err, &format!("error: {mistake}"), FAILURE),
            };
        }
        Err(shown) if shown.use_stderr() => return say(err, &shown.render().to_string(), USAGE),
        Err(help) => Ok(help.render().to_string()),
    };
    match result {
        Ok(text) => match print(out, &text) {
            Ok(()) => SUCCESS,
            Err(error) if error.kind() == ErrorKind::BrokenPipe => SUCCESS,
            Err(error) => say(err, &format!("error: cannot print: {error}"), FAILURE),
        },
        Err(mistakes) => say(err, &format!("error: {mistakes}"), FAILURE),
    }
}

fn expand(options: Expand) -> Result<String, String> {
    let Expand { file, type_name, scalar, parameters } = options;
    let mut builder = Builder::new(file).scalar(ScalarKind::from(scalar)).runtime_parameters(parameters);
    if let Some(name) = type_name {
        builder = builder.type_name(name);
    }
    builder.generate().map_err(|error| error.to_string())
}

fn check(file: &Path) -> Result<String, String> {
    let here = env::current_dir().map_err(|error| error.to_string())?;
    let text = denhart_codegen::read_file(&here, file).map_err(|error| error.to_string())?;
    let report = denhart_codegen::check(&text, &file.display().to_string()).map_err(|errors| errors.to_string())?;
    let mut shown = report.to_string();
    for advice in &report.warnings {
        shown = format!("{}\n\n{advice}", shown.trim_end());
    }
    match &report.lacking {
        Some(mistake) => Err(format!("{}\n\n{mistake}", shown.trim_end())),
        None => Ok(shown),
    }
}

/// The exit status, after saying why there is no answer.
fn said(result: Result<u8, numbers::Failure>, err: &mut dyn Write) -> u8 {
    match result {
        Ok(status) => status,
        Err(numbers::Failure::NoReader) => SUCCESS,
        Err(numbers::Failure::Usage(mistake)) => say(err, &format!("error: {mistake}"), USAGE),
        Err(numbers::Failure::Other(mistake)) => say(err, &format!("error: {mistake}"), FAILURE),
    }
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
