//! The arms that the command brings along, and `denhart arms`, which lists them.

use std::io::Write;

use clap::Args;
use denhart::JointKind;
use denhart_codegen::spec::nearest;
use denhart_tools::Arm;
use serde_json::{Value, json};

use crate::Failure;
use crate::inverse::pretty;
use crate::table::aligned;

/// The files of `specs/`, each behind a line `=== NAME`. The test `index` holds them equal and writes them.
const FILES: &str = include_str!("arms.txt");

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// Print JSON: an array with an object for each arm
    #[arg(long)]
    json: bool,
}

/// The name of each arm with its file.
fn files() -> impl Iterator<Item = (&'static str, &'static str)> {
    FILES.split("=== ").filter_map(|part| part.split_once('\n'))
}

/// The arm file of a name.
///
/// # Errors
/// The message, with the nearest name.
pub fn file(name: &str) -> Result<&'static str, String> {
    let found = files().find(|(known, _)| *known == name);
    found.map(|(_, text)| text).ok_or_else(|| {
        let meant = nearest(name, files().map(|(known, _)| known));
        let meant = meant.map_or_else(String::new, |word| format!("did you mean `{word}`? "));
        format!("no arm `{name}`\nhelp: {meant}`denhart arms` lists them")
    })
}

/// Prints the arms.
///
/// # Errors
/// No way to print.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let arms = files().map(Listed::new).collect::<Result<Vec<_>, Failure>>()?;
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
    name: &'static str,
    /// R for each turning joint, P for each sliding one.
    joints: String,
    /// None without an inverse in closed form.
    task: Option<String>,
    /// The first line of the file's comment.
    source: &'static str,
}

impl Listed {
    fn new((name, text): (&'static str, &'static str)) -> Result<Self, Failure> {
        let refused = |mistakes| Failure::Other(crate::each(&mistakes));
        let report = denhart_codegen::check(text, name).map_err(refused)?;
        let kinds = Arm::of_text(text, name).map_err(refused)?.chain.kinds();
        let joints = kinds.iter().map(|kind| if *kind == JointKind::Revolute { 'R' } else { 'P' }).collect();
        let source = text.lines().next().unwrap_or_default().trim_start_matches("# ");
        Ok(Self { name, joints, task: report.task, source })
    }

    fn row(&self) -> Vec<String> {
        let task = self.task.clone().unwrap_or_else(|| "-".to_owned());
        vec![self.name.to_owned(), self.joints.clone(), task, self.source.to_owned()]
    }

    fn json(&self) -> Value {
        json!({"name": self.name, "joints": self.joints, "task": self.task, "source": self.source})
    }
}
