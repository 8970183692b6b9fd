//! An arm file from a serial chain of a URDF, which proves itself against the URDF.
//!
//! The URDF at its zero gives a line for each joint (`axes`), these give the table (`table`), the mimic joints the
//! coupling (`mimic_coupling`). Nothing of this is in the proof (`proof`), which multiplies the joints' origins and
//! motions. The calibration of a UR arm and OPW parameters become a URDF first.

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

use denhart_codegen::model::Length;
use serde_json::Value;

use crate::Error;
use axes::{Change, exact, exact_origin};
use candidate::{CandidateTable, MAX_DIFFERENCE, ProvedTable};
use proof::{Difference, compare};
use report::{Report, Source};
use rigid::{Transform, V, of_origin, rpy};
use table::{Row, Table, table};
use urdf::Robot;

/// Lengths this near to a whole number of micrometers are written as that number. The limit is in m, or relative to the
/// size of a smaller arm. The widest limit with which the proof holds is taken.
const ROUNDED: [f64; 4] = [1e-9, 1e-10, 1e-11, 0.0];

/// Angles of a URDF this near to a multiple of 15 degrees, rad, are taken as that multiple; and those of a calibration, whose
/// every angle is measured.
const EXACT_WITHIN: f64 = 1e-6;
const EXACT_WITHIN_OF_MEASURED: f64 = 1e-9;
/// Lengths of one maker's table differ by less, m: some have a digit more.
const SAME_TABLE: f64 = 1e-3;

/// The chain to import, and how its numbers are read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Name of the source, such as that of a file, for the head comment of the arm file.
    pub from: String,
    /// First link of the chain. Without it: the root of the URDF.
    pub base: Option<String>,
    /// Last link of the chain. Without it: the end of the chain with the most moving joints, before its gripper.
    pub tool: Option<String>,
    /// Angles that are this near to a multiple of 15 degrees are taken as that multiple; 0 to 1e-2 rad. Without it: 1e-6, of a
    /// calibration 1e-9.
    pub exact_within: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Self { from: "a text".to_owned(), base: None, tool: None, exact_within: None }
    }
}

/// An arm file and the findings on the way to it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Imported {
    /// The text of the arm file, YAML.
    pub arm_file: String,
    /// The findings, each a line or several: the chain, the proof, angles that were made exact, joints with another name.
    pub remarks: Vec<String>,
    /// The findings as data, an object with the keys `chain`, `made_exact`, `nearly_exact`, `rounded_lengths_by_m`, `remarks` and
    /// `proof`. Lengths are in m, angles in the unit that the key names.
    pub facts: Value,
}

/// The arm file of a serial chain of a URDF.
///
/// Zero, direction, name and limits of each joint are those of the URDF; mimic joints become the `coupling` of the file. The
/// poses of the file are compared with those of the URDF at 1000 configurations, the same at each call.
///
/// # Errors
/// Text that is no URDF, a chain that no arm file can say, a difference of poses above 1e-9 m or rad.
pub fn urdf(text: &str, options: &Options) -> Result<Imported, Error> {
    import(text, options, Source::Urdf)
}

/// The arm file of a UR arm as it was measured: from its calibration as the arm's driver extracts it,
/// `kinematics: {shoulder: {x, y, z, roll, pitch, yaw}, ..}`. Lengths are in m, angles in rad.
///
/// The links are `base`, `shoulder`, `upper_arm`, `forearm`, `wrist_1`, `wrist_2` and `wrist_3`.
///
/// # Errors
/// Text that is no such calibration, and those of [`urdf()`].
pub fn ur_calibration(text: &str, options: &Options) -> Result<Imported, Error> {
    import(&ur_calibration::urdf(text).map_err(Error::Text)?, options, Source::Calibration)
}

/// The arm file of an arm with an orthogonal base and a spherical wrist: from its OPW parameters as ROS-Industrial writes them,
/// `opw_kinematics_geometric_parameters: {a1, a2, b, c1, c2, c3, c4}`. Lengths are in m.
///
/// The links are `base`, `link_1` to `link_6` and `tool0`.
///
/// # Errors
/// Text without these parameters, and those of [`urdf()`].
pub fn opw(text: &str, options: &Options) -> Result<Imported, Error> {
    import(&opw::urdf(text).map_err(Error::Text)?, options, Source::Opw)
}

/// The arm file `nominal` with the entry `calibration` of a UR controller's `calibration.conf`: `delta_theta = [..]` and the like.
/// `name` is that of the arm file, for messages.
///
/// # Errors
/// Mistakes in the arm file; one that has such an entry, is not in m, or is not that of six joints. Text without the lists.
pub fn calibrated(conf: &str, nominal: &str, name: &str) -> Result<String, Error> {
    let program = denhart_codegen::program(nominal, name)?;
    if program.model.calibration.is_some() {
        return Err(Error::Text(format!("`{name}` has a `calibration` already: name the maker's table")));
    }
    let meters = program.model.length_unit.symbol();
    if meters != "m" {
        return Err(Error::Text(format!(
            "`{name}` has lengths in {meters}, and a calibration.conf has meters: write the table in m"
        )));
    }
    let entry = ur_calibration::entry(conf, program.model.joints.len()).map_err(Error::Text)?;
    if let Some([a, d]) = ur_calibration::lengths(conf).map_err(Error::Text)? {
        let joints = program.model.joints.iter().filter_map(|joint| program.model.rows.get(joint.row));
        for (joint, (row, (a, d))) in joints.zip(a.into_iter().zip(d)).enumerate() {
            for (key, own, other) in [("a", &row.a, a), ("d", &row.d, d)] {
                let Length::Constant(own) = own else { continue };
                if (own - other).abs() > SAME_TABLE {
                    let joint = joint + 1;
                    return Err(Error::Text(format!(
                        "`{name}` is the table of another arm: `{key}` of joint {joint} is {own}, and {other} beside the \
                         differences"
                    )));
                }
            }
        }
    }
    let text = format!("{}\n{entry}", nominal.trim_end());
    // Numbers that belong to another arm are refused with their place.
    denhart_codegen::program(&text, name)?;
    Ok(text)
}

fn import(text: &str, options: &Options, source: Source) -> Result<Imported, Error> {
    let default = if source == Source::Calibration { EXACT_WITHIN_OF_MEASURED } else { EXACT_WITHIN };
    let within = options.exact_within.unwrap_or(default);
    if !(0.0..=1e-2).contains(&within) {
        return Err(Error::Option("--exact-within: expected 0 to 1e-2 rad".to_owned()));
    }
    converted(text, options, within, source).map_err(Error::Text)
}

/// The arm file with angles made exact that are off by at most `within`, rad.
fn converted(text: &str, options: &Options, within: f64, source: Source) -> Result<Imported, String> {
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
        from: &options.from,
        path: &path,
        changes: &changes,
        lengths: &lengths,
        coupling: &coupling,
        reach,
        exact_angles,
        as_written,
        source,
        inverse: None,
    };
    let mut text = write::file(&written.name, &report.head(), &table, &coupling)?;
    if let Some(inverse) = inverse::of(&text, &path, &coupling) {
        text += &inverse.lines;
        report.inverse = Some(inverse.remark);
    }
    Ok(Imported { arm_file: text, remarks: report.remarks(within), facts: report.json(within) })
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
