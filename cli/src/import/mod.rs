//! `denhart import`: an arm file from a serial chain of a URDF, which proves itself against the URDF.
//!
//! The URDF at its zero gives a line for each joint (`axes`), these give the table (`table`), the mimic joints the
//! coupling (`mimic_coupling`). Nothing of this is in the proof (`proof`), which multiplies the joints' origins and
//! motions.

mod axes;
mod candidate;
mod gripper;
mod inverse;
mod lengths;
mod likely;
mod mimic_coupling;
mod number;
mod opw;
mod path;
mod prefixes;
mod proof;
mod report;
mod rigid;
mod table;
mod ur_calibration;
mod urdf;
mod walk;
mod write;

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use crate::files;
use axes::{Change, exact, exact_origin};
use candidate::{CandidateTable, MAX_DIFFERENCE, ProvedTable};
use proof::{Difference, compare};
use report::Report;
use rigid::{Transform, V, of_origin, rpy};
use serde_json::{Value, json};
use table::{Row, Table, table};
use urdf::Robot;

/// Lengths this near to a whole number of micrometers are written as that number. The limit is in m, or relative to the
/// size of a smaller arm. The widest limit with which the proof holds is taken.
const ROUNDED: [f64; 4] = [1e-9, 1e-10, 1e-11, 0.0];

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
    if options.exact_within.is_some_and(|within| !(0.0..=1e-2).contains(&within)) {
        return Err("--exact-within: expected 0 to 1e-2 rad".to_owned());
    }
    let file = [&options.file, &options.ur_calibration, &options.opw].into_iter().find_map(Option::as_ref);
    let file = file.ok_or("no file to import")?;
    let text = read(file)?;
    let at = |message: String| format!("{}: {message}", file.display());
    if let Some(nominal) = &options.nominal {
        return calibrate(&text, nominal, options, out).map_err(at);
    }
    let named = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let from = if named == "-" { "the standard input".to_owned() } else { named };
    let urdf = match () {
        () if options.ur_calibration.is_some() => ur_calibration::urdf(&text).map_err(at)?,
        () if options.opw.is_some() => opw::urdf(&text).map_err(at)?,
        () => text,
    };
    let Imported { text, remarks, mut facts } = import(&urdf, &from, options).map_err(at)?;
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
    let table = read(nominal)?;
    let name = nominal.display().to_string();
    let program = denhart_codegen::program(&table, &name).map_err(|errors| errors.to_string())?;
    if program.model.calibration.is_some() {
        return Err(format!("`{name}` has a `calibration` already: name the maker's table"));
    }
    let meters = program.model.length_unit.symbol();
    if meters != "m" {
        return Err(format!(
            "`{name}` has lengths in {meters}, and a calibration.conf has meters: write the table in m"
        ));
    }
    let text = format!("{}\n{}", table.trim_end(), ur_calibration::entry(conf, program.model.joints.len())?);
    // Numbers that belong to another arm are refused with their place.
    denhart_codegen::program(&text, &name).map_err(|errors| errors.to_string())?;
    match &options.output {
        Some(path) => files::write(&[(path, &text)], options.force),
        None => out.write_all(text.as_bytes()).map_err(|error| format!("cannot print: {error}")),
    }
}

/// An arm file and what there is to say about it.
struct Imported {
    text: String,
    remarks: Vec<String>,
    /// The remarks as JSON.
    facts: Value,
}

fn import(text: &str, from: &str, options: &Options) -> Result<Imported, String> {
    let within = options.exact_within.unwrap_or(if options.ur_calibration.is_some() { 1e-9 } else { 1e-6 });
    let written = urdf::read(text)?;
    let path = path::find(&written, options.base.as_deref(), options.tool.as_deref())?;
    let mut in_origins = Vec::new();
    let on_path = |name: &str| path.joints.iter().any(|passed| passed.joint.name == name);
    let joints = written.joints.iter().map(|joint| match on_path(&joint.name) {
        true => exact_origin(joint, within, &mut in_origins),
        false => joint.clone(),
    });
    let exact_robot = Robot { joints: joints.collect(), ..written.clone() };
    let exact_path = path::find(&exact_robot, Some(&path.base), Some(&path.tool))?;
    let coupling = mimic_coupling::mimic_coupling(&exact_robot, &exact_path)?;
    let plain = table(&coupling.axes);
    let mut in_table = Vec::new();
    let made_exact = exact_table(&plain, within, &mut in_table);

    // The table against the URDF with the angles that were made exact.
    let turns: Vec<bool> = coupling.motors.iter().map(|motor| motor.turns).collect();
    let exact_angles = compare(&exact_robot, &exact_path, &coupling, &|q| plain.pose(q, &turns));
    let turned = |changes: &[Change]| changes.iter().map(Change::size).sum::<f64>();
    let (of_origins, of_table) = (turned(&in_origins), turned(&in_table));
    let reach = lengths::of_table(&plain, &coupling);
    let moved = of_origins * lengths::of_links(&written, &path, &coupling) + of_table * reach;
    let allowed = Difference { position: MAX_DIFFERENCE + moved, angle: MAX_DIFFERENCE + of_origins + of_table };
    let candidate = CandidateTable {
        written: (&written, &path),
        exact: (&exact_robot, &exact_path),
        coupling: &coupling,
        table: &made_exact,
        changed: !in_table.is_empty(),
        exact_angles,
        allowed,
    };
    // Lengths are rounded as far as the proof holds.
    let widths = if within > 0.0 { &ROUNDED[..] } else { &[0.0] };
    let mut proved = Err("nothing was compared".to_owned());
    for width in widths {
        proved = candidate.prove(*width);
        if proved.is_ok() {
            break;
        }
    }
    let ProvedTable { table, lengths, exact_angles, as_written } = proved?;
    let changes = [in_origins, in_table].concat();
    let mut report = Report {
        from,
        path: &path,
        changes: &changes,
        lengths: &lengths,
        coupling: &coupling,
        reach,
        exact_angles,
        as_written,
        is_measured: options.ur_calibration.is_some(),
        inverse: None,
    };
    let mut text = write::file(&written.name, &report.head(), &table, &coupling)?;
    if let Some(inverse) = inverse::of(&text, &path, &coupling) {
        text += &inverse.lines;
        report.inverse = Some(inverse.remark);
    }
    Ok(Imported { text, remarks: report.remarks(within), facts: report.json(within) })
}

/// The table with its angles made exact; a fixed row that then is none is part of the next row.
fn exact_table(table: &Table, within: f64, changes: &mut Vec<Change>) -> Table {
    let mut rows: Vec<Row> = Vec::new();
    let mut carried = 0.0;
    for (index, row) in table.rows.iter().enumerate() {
        let of = |what: &str| format!("{what} of row {}", index + 1);
        let mut row = *row;
        row.theta += std::mem::take(&mut carried);
        row.alpha = exact(row.alpha, within, || of("alpha"), changes);
        if row.axis.is_none() && row.alpha == 0.0 && row.a == 0.0 && row.d == 0.0 {
            carried = row.theta;
            continue;
        }
        row.theta = exact(row.theta, within, || of("theta"), changes);
        rows.push(row);
    }
    let mut frame = |frame: &Transform, what: &str| {
        let angles: V = rpy(frame).map(|angle| exact(angle, within, || format!("rpy of the {what}"), changes));
        of_origin(frame.p, angles)
    };
    Table { base: frame(&table.base, "base"), tool: frame(&table.tool, "tool"), rows, size: table.size }
}
