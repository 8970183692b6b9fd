//! The arm file as types, each value as it was written and with its place.
//!
//! [`read`] goes through the whole file and collects every mistake of form: an unknown key, a wrong type, a missing
//! value. What the values mean together is checked by the next stage, `model`.

mod actuator;
mod angle;
mod angle_field;
mod calibration;
mod combined_limits;
mod coupling;
mod frame;
mod inverse;
mod length;
mod nearest;
mod nesting;
mod parameter;
mod place;
mod range;
mod rate;
mod reader;
mod row;
mod row_kind;
mod source;
mod suggestions;
#[cfg(test)]
mod tests;
mod units;
mod value;
mod weights;
mod yaml;

pub use actuator::{ActuatorSpec, HomeSpec};
pub use angle::{AngleUnit, WrittenAngle, pi_times};
pub use angle_field::looks_like_radians;
pub use calibration::{CalibrationSpec, DeltaSpec};
pub use combined_limits::CombinedLimitSpec;
pub use coupling::{CouplingSpec, Factor, MotorSpec, TermSpec};
pub use frame::FrameSpec;
pub use inverse::{Axis, InverseSpec, RedundantSpec, Task};
pub use length::Length;
pub use nearest::nearest;
pub use parameter::ParameterSpec;
pub use place::Place;
pub use range::{ANGLE, POSITION};
pub use rate::{RateSize, RateSpec};
pub use row::{LimitsSpec, RowSpec};
pub use row_kind::RowKind;
pub use source::Source;
pub use units::{Convention, LengthUnit};
pub use value::{JointRef, WrittenValue};
pub use weights::WeightsSpec;

use crate::error::{Diagnostic, Errors};
use parameter::Context;
use reader::{Field, Fields, Reader};
use yaml::Node;

/// An arm file as written.
#[derive(Debug, Clone)]
pub struct Spec {
    /// The text, to locate what is found to be wrong later.
    pub source: Source,
    /// The arm's name, or the file's without its extension.
    pub name: String,
    /// Which frame a row belongs to.
    pub convention: Convention,
    /// The unit of all lengths.
    pub length_unit: LengthUnit,
    /// The unit of plain numbers that are angles.
    pub angle_unit: AngleUnit,
    /// `joints`; empty only if that is among the mistakes.
    pub rows: Vec<RowSpec>,
    /// The frame before the first row.
    pub base: FrameSpec,
    /// The frame after the last row.
    pub tool: FrameSpec,
    /// Names for lengths, in the order of the file.
    pub parameters: Vec<ParameterSpec>,
    /// The numbers that are added to the rows, where the arm was measured.
    pub calibration: Option<CalibrationSpec>,
    /// The task of the inverse, and what belongs to it.
    pub inverse: InverseSpec,
    /// Which motor moves which joint, where they are linked.
    pub coupling: Option<CouplingSpec>,
    /// Ranges of sums of joint values.
    pub combined_limits: Vec<CombinedLimitSpec>,
    /// The lengths as they were read, with their places; displacements too.
    pub lengths: Vec<(f64, Place)>,
    /// The mistakes of form. They are reported together with those of meaning, so that one run shows all.
    pub mistakes: Vec<Diagnostic>,
}

const KEYS: &[&str] = &[
    "name",
    "convention",
    "units",
    "inverse",
    "joints",
    "base",
    "tool",
    "parameters",
    "calibration",
    "coupling",
    "combined_limits",
];
const SMALLEST: &str = "\
an arm file is a mapping such as
name: arm
convention: standard
units: {length: m, angle: deg}
joints:
  - {type: revolute, a: 0.5, alpha: 0, d: 0, theta: 0}";

/// Reads an arm file; `file` is its name for messages. Also returns the warnings.
///
/// # Errors
/// Text that is not YAML, or no mapping, or has fifty mistakes or more. Fewer mistakes are in [`Spec::mistakes`], which
/// `model::check` reports.
pub fn read(text: &str, file: &str) -> Result<(Spec, Vec<Diagnostic>), Errors> {
    let source = Source::new(file, text);
    let root = root(&source)?;
    let mut reader = Reader::new(&source);
    let field = Field { node: &root, place: Place::default(), key: "arm file".to_owned() };
    let Some(fields) = reader.mapping(&field, "an arm file", KEYS) else { return Err(Errors::new(reader.mistakes)) };
    let parameters = reader.parameters(&fields);
    let units = reader.units(&fields);
    let context = Context { angle: units.angle, parameters: parameters.as_deref() };
    let name = match fields.get("name") {
        Some(field) => reader.text(&field, "the arm's name", "write a name, such as `name: ur5`"),
        None => None,
    };
    let convention = reader.convention(&fields);
    let rows = reader.rows(&fields, context);
    let base = reader.frame(&fields, "base", context);
    let tool = reader.frame(&fields, "tool", context);
    let parameters = parameters.unwrap_or_default();
    let lengths = rows.iter().flat_map(|row| [&row.a, &row.d]).chain(&base.xyz).chain(&tool.xyz);
    reader.unused_parameters(&parameters, lengths);
    let calibration = reader.calibration(&fields, units.angle);
    let inverse = reader.inverse(&fields, units.angle);
    let coupling = reader.coupling(&fields, units.angle);
    let combined_limits = reader.combined_limits(&fields, units.angle);
    if reader.is_full() {
        return Err(reader.into_most());
    }
    let Reader { mistakes, warnings, lengths, .. } = reader;
    let name = name.unwrap_or_else(|| source.stem());
    let spec = Spec {
        name,
        convention,
        length_unit: units.length,
        angle_unit: units.angle.unwrap_or(AngleUnit::Degree),
        rows,
        base,
        tool,
        parameters,
        calibration,
        inverse,
        coupling,
        combined_limits,
        lengths,
        mistakes,
        source,
    };
    Ok((spec, warnings))
}

/// The tree of the file, which must be a mapping.
fn root(source: &Source) -> Result<Node, Errors> {
    let start = source.location_at(1, 1);
    let content =
        source.text().lines().map(str::trim).any(|line| !line.is_empty() && !line.starts_with('#') && line != "---");
    if !content {
        return Err(Diagnostic::error("the file is empty: expected an arm").at(start).help(SMALLEST).into());
    }
    let root = yaml::parse(source.text()).map_err(|broken| {
        let at = broken.at.map_or(start, |(line, column)| source.location_at(line, column));
        let help = advice(&broken.message, &at.source_line).map(str::to_owned);
        let message = match broken.message.strip_prefix("a second document") {
            Some(_) => broken.message,
            None => format!("this is not YAML: {}", broken.message),
        };
        Diagnostic { help, ..Diagnostic::error(message).at(at) }
    })?;
    if matches!(root, Node::Mapping(_)) {
        return Ok(root);
    }
    let at = source.location(&Place::default());
    Err(Diagnostic::error("expected an arm, a mapping of keys and values").at(at).help(SMALLEST).into())
}

/// Advice on a line that is not YAML by `message`.
fn advice(message: &str, line: &str) -> Option<&'static str> {
    let says = |words: &str| message.contains(words);
    if says("second document") {
        Some("an arm file is one document: remove this line and what follows")
    } else if line.contains('\t') {
        Some("YAML is indented with spaces, not with tabs")
    } else if says("parsing a flow") {
        Some("close every `{` with `}` and every `[` with `]`, and put a comma between entries")
    } else if says("parsing a block") {
        Some("begin all entries of one list, and all keys of one mapping, in the same column")
    } else if says("expected ':'") || says("mapping values are not allowed") {
        Some("write `key: value`, with a space after the colon, one on a line or with commas inside `{ }`")
    } else {
        None
    }
}

impl Reader<'_> {
    fn rows(&mut self, root: &Fields<'_>, context: Context<'_>) -> Vec<RowSpec> {
        let help = "write one row a joint, such as\njoints:\n  - {type: revolute, a: 0.5, alpha: 0, d: 0, theta: 0}";
        let Some(field) = root.get("joints") else {
            if !root.has("joints") {
                self.mistakes
                    .push(self.source.mistake(&root.place, "no `joints`: expected at least one joint").help(help));
            }
            return Vec::new();
        };
        match field.node {
            Node::List(rows) if !rows.is_empty() => {
                let row = |(number, row)| self.row(&Field { key: format!("row {number}"), ..row }, number, context);
                (1..).zip(field.items(rows)).map(row).collect()
            }
            Node::List(_) | Node::Null => {
                let mistake = self.source.mistake(&field.place, "`joints` is empty: expected at least one joint");
                self.mistakes.push(mistake.help(help));
                Vec::new()
            }
            _ => {
                self.unexpected(&field, "a list of rows", Some(help.to_owned()));
                Vec::new()
            }
        }
    }
}
