//! `denhart export`: an arm as a library for another language.

mod dependency;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use denhart_codegen::ScalarKind;
use denhart_tools::export::{self, COptions, Dependency};

use crate::{Failure, Scalar, arm, files};

/// The arguments of `denhart export`.
#[derive(Args)]
pub struct Options {
    #[command(subcommand)]
    language: Language,
}

#[derive(Subcommand)]
enum Language {
    /// Write a crate that is a static library for C, its header, and a CMakeLists.txt
    ///
    /// The crate needs the crate `denhart` alone, neither `std` nor an allocator. Its functions: forward, jacobian, both
    /// together. An arm with an inverse has inverse, inverse_near and inverse_branch, and one with motors their values
    /// and pulses. Everything is named after the arm.
    C(C),
}

/// The arguments of `denhart export c`.
#[derive(Args)]
struct C {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// The folder of the crate
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    /// Number type of all values: float or double in C
    #[arg(long, value_name = "TYPE", default_value = "f64")]
    scalar: Scalar,
    /// Beginning of the names in C [default: the arm's name, in lower case]
    #[arg(long, value_name = "NAME")]
    prefix: Option<String>,
    /// The folder of the crate denhart [default: where this command was built, if that is there, else crates.io]
    #[arg(long, value_name = "DIR")]
    crate_path: Option<PathBuf>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
}

/// Writes the library.
///
/// # Errors
/// Mistakes in the arm file, a prefix that is none, files that are there or cannot be written.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<(), Failure> {
    let Language::C(options) = &options.language;
    let (text, name) = arm::text(&options.file).map_err(Failure::Other)?;
    let folder = &options.output;
    let found = dependency::find(options.crate_path.as_deref(), Path::new(dependency::BUILT_BESIDE), folder);
    // Mistakes in the arm file are told before that there is no crate.
    let denhart = found.clone().unwrap_or(Dependency::Published);
    let of = COptions { scalar: ScalarKind::from(options.scalar), prefix: options.prefix.clone(), denhart };
    let library = export::c(&text, &name, &of)?;
    let denhart = found.map_err(Failure::Other)?;
    let remark = dependency::remark(&denhart, folder);
    match denhart {
        Dependency::Folder(_) => writeln!(out, "{remark}")?,
        Dependency::Published => writeln!(err, "{remark}")?,
    }
    if let Some(reason) = &library.without_inverse {
        writeln!(err, "warning: {reason}")?;
    }
    let written: Vec<(PathBuf, &str)> =
        library.files.iter().map(|file| (folder.join(&file.path), file.text.as_str())).collect();
    let written: Vec<(&Path, &str)> = written.iter().map(|(path, text)| (path.as_path(), *text)).collect();
    files::write(&written, options.force).map_err(Failure::Other)?;
    for (path, _) in written {
        writeln!(out, "wrote {}", path.display())?;
    }
    Ok(())
}
