//! The arm of a file as a chain that is computed at run time.

use denhart::{Chain, Convention, DhFrame, DhRow, JointKind};
use denhart_codegen::model::{self, Frame, Length, Model, RowKind};
use denhart_codegen::{Errors, spec};

/// An arm file, checked.
#[derive(Debug, Clone)]
pub struct Arm {
    /// The table as a chain, which any numbers of joints may have: pose, Jacobian, inverse by iteration.
    pub chain: Chain,
    /// The checked file: names, limits, units.
    pub model: Model,
}

impl Arm {
    /// The arm of the text of an arm file; `file` is its name for messages.
    ///
    /// # Errors
    /// The mistakes in it.
    pub fn of_text(text: &str, file: &str) -> Result<Self, Errors> {
        let (spec, _) = spec::read(text, file)?;
        let model = model::check(&spec)?;
        Ok(Self { chain: chain(&model), model })
    }
}

/// The chain of a checked arm: lengths in the unit of its file, parameters at their values there.
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
