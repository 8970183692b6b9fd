//! `denhart arms`: the arms that come along.

use std::io::Write;

use clap::Args;
use denhart_tools::Error;
use denhart_tools::presets::{Preset, presets};
use serde_json::{Value, json};

use crate::Failure;
use crate::inverse::pretty;
use crate::table::aligned;

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// Print JSON: an array with an object for each arm
    #[arg(long)]
    json: bool,
}

/// Prints the arms.
///
/// # Errors
/// No way to print.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let arms = presets().map(Listed::new).collect::<Result<Vec<_>, Failure>>()?;
    if options.json {
        writeln!(out, "{}", pretty(&arms.iter().map(Listed::json).collect())?)?;
    } else {
        let names = ["name", "joints", "task", "source"].map(str::to_owned).to_vec();
        let rows = [names].into_iter().chain(arms.iter().map(Listed::row));
        write!(out, "{}", aligned(&rows.collect::<Vec<_>>()))?;
        writeln!(out, "\ndenhart new --like NAME writes the file of one")?;
    }
    Ok(out.flush()?)
}

/// An arm of the list.
struct Listed {
    preset: Preset,
    joints: String,
    /// None without an inverse in closed form.
    task: Option<String>,
}

impl Listed {
    fn new(preset: Preset) -> Result<Self, Failure> {
        let (joints, task) = (preset.joints().map_err(Error::from)?, preset.task().map_err(Error::from)?);
        Ok(Self { preset, joints, task })
    }

    fn row(&self) -> Vec<String> {
        let task = self.task.clone().unwrap_or_else(|| "-".to_owned());
        vec![self.preset.name.to_owned(), self.joints.clone(), task, self.preset.source().to_owned()]
    }

    fn json(&self) -> Value {
        json!({"name": self.preset.name, "joints": self.joints, "task": self.task, "source": self.preset.source()})
    }
}
