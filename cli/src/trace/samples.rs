//! The samples of a motion as text: CSV, or JSON with an object for each.

use std::io::{self, Write};

use denhart_codegen::model::Model;
use serde_json::json;

use crate::numbers::{Units, printed};

/// The keys of the JSON beside the samples.
pub struct Top {
    arm: String,
    length_unit: &'static str,
    angle_unit: &'static str,
}

impl Top {
    /// That of an arm.
    pub fn of(model: &Model, units: Units) -> Self {
        Self { arm: model.name.clone(), length_unit: model.length_unit.symbol(), angle_unit: units.symbol() }
    }
}

/// Where the samples go, one after the other: a motion may have more of them than fit into memory.
pub struct Samples<'a> {
    out: &'a mut dyn Write,
    names: &'a [String],
    /// JSON, not CSV.
    json: bool,
    count: u64,
}

impl<'a> Samples<'a> {
    /// Writes what stands before the samples; `names` has one for each value of a sample.
    pub fn begin(out: &'a mut dyn Write, names: &'a [String], top: Option<&Top>) -> io::Result<Self> {
        match top {
            None => writeln!(out, "{}", names.join(","))?,
            Some(Top { arm, length_unit, angle_unit }) => {
                writeln!(out, "{{\n  \"arm\": {},", json!(arm))?;
                writeln!(out, "  \"length_unit\": {},\n  \"angle_unit\": {},", json!(length_unit), json!(angle_unit))?;
                write!(out, "  \"samples\": [")?;
            }
        }
        Ok(Self { out, names, json: top.is_some(), count: 0 })
    }

    /// One sample.
    pub fn push(&mut self, values: &[f64]) -> io::Result<()> {
        self.count += 1;
        if !self.json {
            let values: Vec<String> = values.iter().map(|value| printed(*value)).collect();
            return writeln!(self.out, "{}", values.join(","));
        }
        // JSON has no infinity.
        let shown = |value: f64| if value.is_finite() { printed(value) } else { "null".to_owned() };
        let pairs = self.names.iter().zip(values).map(|(name, value)| format!("{}: {}", json!(name), shown(*value)));
        let comma = if self.count == 1 { "" } else { "," };
        write!(self.out, "{comma}\n    {{{}}}", pairs.collect::<Vec<_>>().join(", "))
    }

    /// Writes what stands behind the samples; `stopped` is why there are no more of them.
    pub fn end(self, stopped: Option<&str>) -> io::Result<()> {
        if self.json {
            writeln!(self.out, "\n  ],\n  \"stopped\": {}\n}}", json!(stopped))?;
        }
        self.out.flush()
    }
}
