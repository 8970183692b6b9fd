//! `denhart check`: findings of the generator in arm files, or the mistakes in them.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use denhart_codegen::{Diagnostic, Severity};
use denhart_tools::check::{Checked, Processor, check};
use serde_json::{Value, json};

use crate::arm;
use crate::numbers::Units;

/// Arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm files, YAML; `-` reads the standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Warnings count as mistakes: exit status 1
    #[arg(long)]
    strict: bool,
    /// Print an array with an object for each file: what was found, and all messages with their places
    #[arg(long)]
    json: bool,
    /// Unit of the angles of the arm at its zero, and of the limits with --json
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// Print also kernels and bound of the inverse, and what the code of a similar arm takes on this processor
    #[arg(long, value_name = "PROCESSOR")]
    target: Option<Target>,
}

/// A processor.
#[derive(Clone, Copy, ValueEnum)]
enum Target {
    /// Arm Cortex-M4 with its single-precision unit
    #[value(name = "cortex-m4f")]
    CortexM4f,
}

impl From<Target> for Processor {
    fn from(target: Target) -> Self {
        match target {
            Target::CortexM4f => Self::CortexM4f,
        }
    }
}

/// A file of the command line.
enum File {
    Read(Checked),
    Unread(Unread),
}

/// Why a file could not be read, and what to do.
struct Unread {
    file: String,
    message: String,
    help: Option<String>,
}

impl Unread {
    /// From a message that may end with a help line.
    fn new(file: &Path, text: String) -> Self {
        let file = file.display().to_string();
        match text.split_once("\nhelp: ") {
            Some((message, help)) => Self { file, message: message.to_owned(), help: Some(help.to_owned()) },
            None => Self { file, message: text, help: None },
        }
    }

    fn text(&self) -> String {
        let help = self.help.as_ref().map_or_else(String::new, |help| format!("\nhelp: {help}"));
        format!("error: {}{help}", self.message)
    }

    fn json(&self) -> Value {
        let mut value = json!({"severity": "error", "message": self.message});
        if let (Some(object), Some(help)) = (value.as_object_mut(), &self.help) {
            object.insert("help".to_owned(), json!(help));
        }
        json!({"file": self.file, "messages": [value]})
    }
}

impl File {
    fn check(file: &Path, target: Option<Target>) -> Self {
        match arm::text(file) {
            Ok((text, name)) => Self::Read(check(&text, &name, target.map(Processor::from))),
            Err(message) => Self::Unread(Unread::new(file, message)),
        }
    }

    fn messages(&self) -> &[Diagnostic] {
        match self {
            Self::Read(checked) => checked.messages(),
            Self::Unread(_) => &[],
        }
    }

    fn is_unread(&self) -> bool {
        matches!(self, Self::Unread(_))
    }

    /// True where there are no mistakes, but there may be warnings.
    fn has_report(&self) -> bool {
        matches!(self, Self::Read(checked) if checked.report().is_some())
    }

    fn text(&self, units: Units) -> String {
        match self {
            Self::Read(checked) => checked.text(units),
            Self::Unread(unread) => unread.text(),
        }
    }

    fn json(&self, units: Units) -> Value {
        match self {
            Self::Read(checked) => checked.json(units),
            Self::Unread(unread) => unread.json(),
        }
    }
}

/// Checks all files, and returns true if nothing was wrong.
///
/// # Errors
/// No way to print.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> std::io::Result<bool> {
    let checked: Vec<File> = options.files.iter().map(|file| File::check(file, options.target)).collect();
    let failed = |checked: &File| {
        let counts = |message: &Diagnostic| options.strict || message.severity == Severity::Error;
        checked.is_unread() || checked.messages().iter().any(counts)
    };
    if options.json {
        let all: Vec<Value> = checked.iter().map(|checked| checked.json(options.units)).collect();
        serde_json::to_writer_pretty(&mut *out, &all)?;
        writeln!(out)?;
    } else {
        for (index, checked) in checked.iter().enumerate() {
            let text = checked.text(options.units);
            let text = text.trim_end();
            if index > 0 {
                writeln!(out)?;
            }
            // Whoever reads a pipe that is closed has gone away; the messages still count.
            if failed(checked) { writeln!(err, "{text}")? } else { writeln!(out, "{text}")? }
        }
        let warned: usize = checked.iter().map(|checked| checked.messages().len()).sum();
        let only_warned = checked.iter().all(|checked| checked.has_report()) && options.strict && warned > 0;
        if only_warned {
            let warnings = if warned == 1 { "1 warning" } else { &format!("{warned} warnings") };
            writeln!(err, "\nerror: {warnings}, with --strict a mistake")?;
        }
    }
    out.flush()?;
    Ok(!checked.iter().any(failed))
}
