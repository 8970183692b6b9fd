//! The arm of a file as a chain that is computed at run time.

use std::env;
use std::path::Path;

use denhart::{Chain, Convention, DhFrame, DhRow, JointKind};
use denhart_codegen::model::{self, Frame, Length, Model, RowKind};
use denhart_codegen::spec;

/// The chain of the arm file, with the names of the joints.
pub fn read(file: &Path) -> Result<(Chain, Vec<String>), String> {
    let here = env::current_dir().map_err(|error| error.to_string())?;
    let text = denhart_codegen::read_file(&here, file).map_err(|error| error.to_string())?;
    of_text(&text, &file.display().to_string())
}

/// The same of the text of an arm file; `file` is its name for messages.
pub fn of_text(text: &str, file: &str) -> Result<(Chain, Vec<String>), String> {
    let (spec, _) = spec::read(text, file).map_err(|errors| errors.to_string())?;
    let model = model::check(&spec).map_err(|errors| errors.to_string())?;
    let names = model.joints.iter().map(|joint| joint.name.clone()).collect();
    Ok((chain(&model), names))
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
