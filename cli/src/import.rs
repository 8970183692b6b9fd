//! `denhart import`: an arm file from a serial chain of a URDF, from a calibration, or from OPW parameters.

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use denhart_tools::Error;
use denhart_tools::import::{self, Imported};
use serde_json::json;

use crate::files;

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The URDF; `-` reads the standard input
    #[arg(required_unless_present_any = ["ur_calibration", "opw"])]
    file: Option<PathBuf>,
    /// Calibration of a UR arm, as its driver extracts it; with --nominal the controller's calibration.conf
    #[arg(long, value_name = "FILE", conflicts_with_all = ["file", "opw", "base", "tool"])]
    ur_calibration: Option<PathBuf>,
    /// The arm file that a calibration.conf belongs to: it gets the entry `calibration`
    #[arg(long, value_name = "ARM", requires = "ur_calibration", conflicts_with_all = ["json", "exact_within"])]
    nominal: Option<PathBuf>,
    /// OPW parameters of ROS-Industrial: an orthogonal base and a spherical wrist
    #[arg(long, value_name = "FILE", conflicts_with_all = ["file", "base", "tool"])]
    opw: Option<PathBuf>,
    /// First link of the chain [default: the root of the URDF]
    #[arg(long, value_name = "LINK")]
    base: Option<String>,
    /// Last link of the chain [default: the end of the one with the most moving joints, before its gripper]
    #[arg(long, value_name = "LINK")]
    tool: Option<String>,
    /// Angles that are this near to a multiple of 15 degrees, rad, are taken as that multiple [default: 1e-6; of a calibration
    /// 1e-9]
    #[arg(long, value_name = "RAD", value_parser = crate::number_arguments::single_number)]
    exact_within: Option<f64>,
    /// Print JSON: the proof and the angles made exact, with the arm file as text unless -o names where it goes
    #[arg(long)]
    json: bool,
    /// Write to this file instead of the standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Overwrite the file of -o if it is there
    #[arg(long, requires = "output")]
    force: bool,
}

/// Writes the arm file, and what was found on the way: to `err`, or with the arm file as JSON.
///
/// # Errors
/// The message: a file that is no URDF, a chain that no arm file can say, a difference above 1e-9.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<(), String> {
    let file = [&options.file, &options.ur_calibration, &options.opw].into_iter().find_map(Option::as_ref);
    let file = file.ok_or("no file to import")?;
    let text = read(file)?;
    let at = |message: String| format!("{}: {message}", file.display());
    if let Some(nominal) = &options.nominal {
        return calibrate(&text, nominal, options, out).map_err(at);
    }
    let named = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let from = if named == "-" { "the standard input".to_owned() } else { named };
    let (base, tool) = (options.base.clone(), options.tool.clone());
    let of = import::Options { from, base, tool, exact_within: options.exact_within };
    let imported = match () {
        () if options.ur_calibration.is_some() => import::ur_calibration(&text, &of),
        () if options.opw.is_some() => import::opw(&text, &of),
        () => import::urdf(&text, &of),
    };
    let imported = imported.map_err(|error| match error {
        Error::Option(message) => message,
        error => at(error.to_string()),
    });
    let Imported { arm_file: text, remarks, mut facts, .. } = imported?;
    if !options.json {
        // A remark that nobody reads takes nothing from the file.
        for remark in &remarks {
            let _ = writeln!(err, "{remark}");
        }
    }
    if let Some(path) = &options.output {
        files::write(&[(path, &text)], options.force)?;
    }
    let printed = match &options.output {
        path if options.json => {
            let (key, value) = match path {
                Some(path) => ("output", json!(path.display().to_string())),
                None => ("arm_file", json!(text)),
            };
            if let Some(object) = facts.as_object_mut() {
                object.insert(key.to_owned(), value);
            }
            serde_json::to_string_pretty(&facts).map_err(|error| error.to_string())? + "\n"
        }
        Some(_) => return Ok(()),
        None => text,
    };
    match out.write_all(printed.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(format!("cannot print: {error}")),
        _ => Ok(()),
    }
}

/// The text of a file, or of the standard input.
fn read(file: &Path) -> Result<String, String> {
    if file.as_os_str() == "-" {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text);
        read.map_err(|error| format!("cannot read the standard input: {error}"))?;
        return Ok(text);
    }
    fs::read_to_string(file).map_err(|error| format!("cannot read `{}`: {error}", file.display()))
}

/// Writes the arm file of a nominal table with the entry `calibration`.
fn calibrate(conf: &str, nominal: &Path, options: &Options, out: &mut dyn Write) -> Result<(), String> {
    let text =
        import::calibrated(conf, &read(nominal)?, &nominal.display().to_string()).map_err(|error| match error {
            Error::Mistakes(mistakes) => mistakes.to_string(),
            error => error.to_string(),
        })?;
    match &options.output {
        Some(path) => files::write(&[(path, &text)], options.force),
        None => out.write_all(text.as_bytes()).map_err(|error| format!("cannot print: {error}")),
    }
}
