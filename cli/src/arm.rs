//! The arm of a file as a chain that is computed at run time.

use std::env;
use std::io::Read;
use std::path::Path;

use denhart::{Chain, Convention, DhFrame, DhRow, JointKind};
use denhart_codegen::model::{self, Frame, Length, Model, RowKind};
use denhart_codegen::spec;

/// Name of the standard input in messages.
const STANDARD_INPUT: &str = "<stdin>";

/// An arm file, checked.
pub struct Arm {
    pub chain: Chain,
    pub model: Model,
}

/// The text of an arm file and its name for messages; `-` is the standard input.
///
/// # Errors
/// The message.
pub fn text(file: &Path) -> Result<(String, String), String> {
    if file.as_os_str() == "-" {
        let mut bytes = Vec::new();
        let read = std::io::stdin().read_to_end(&mut bytes);
        read.map_err(|error| format!("cannot read the standard input: {error}"))?;
        let text = denhart_codegen::decode(bytes, "the standard input").map_err(|error| error.to_string())?;
        return not_urdf(text, STANDARD_INPUT.to_owned());
    }
    let here = env::current_dir().map_err(|error| error.to_string())?;
    let text = denhart_codegen::read_file(&here, file).map_err(|error| error.to_string())?;
    not_urdf(text, file.display().to_string())
}

/// Text and name, unless the text is a URDF.
fn not_urdf(text: String, name: String) -> Result<(String, String), String> {
    if text.trim_start().starts_with('<') && text.contains("<robot") {
        return Err(format!("{name}: this is a URDF\nhelp: denhart import {name} -o arm.yaml"));
    }
    Ok((text, name))
}

/// The arm of the file, or the mistakes in it.
///
/// # Errors
/// The message.
pub fn read(file: &Path) -> Result<Arm, String> {
    let (text, name) = text(file)?;
    of_text(&text, &name)
}

/// The arm of the text of an arm file, or the mistakes in it; `file` is its name for messages.
///
/// # Errors
/// The message.
pub fn of_text(text: &str, file: &str) -> Result<Arm, String> {
    let (spec, _) = spec::read(text, file).map_err(|errors| crate::each(&errors))?;
    let model = model::check(&spec).map_err(|errors| crate::each(&errors))?;
    Ok(Arm { chain: chain(&model), model })
}

/// The chain of a checked arm.
pub fn chain(model: &Model) -> Chain {
    let convention = match model.convention {
        model::Convention::Standard => Convention::Standard,
        model::Convention::Modified => Convention::Modified,
    };
    let rows: Vec<DhRow> = model
        .rows
        .iter()
        .map(|row| {
            let kind = match row.kind {
                RowKind::Revolute => JointKind::Revolute,
                RowKind::Prismatic => JointKind::Prismatic,
                RowKind::Fixed => JointKind::Fixed,
            };
            DhRow {
                kind,
                a: row.a.default_value(),
                alpha: row.alpha.rad(),
                d: row.d.default_value(),
                theta: row.theta.rad(),
            }
        })
        .collect();
    let frame = |frame: &Frame| DhFrame {
        xyz: frame.xyz.each_ref().map(Length::default_value),
        rpy: frame.rpy.map(|angle| angle.rad()),
    };
    Chain::new(convention, &rows).with_base(frame(&model.base)).with_tool(frame(&model.tool))
}
