//! `denhart export`: an arm as a library for another language.

mod arm;
mod header;
mod library;
mod project;

use std::io::Write;
use std::path::PathBuf;

use clap::{Args, Subcommand};
use denhart_codegen::{Options as Code, ScalarKind, generate};

use crate::{Failure, Scalar, arm as arm_file, files};
use arm::Arm;

/// What the command takes.
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

/// What `export c` takes.
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
    /// What the names in C begin with [default: the arm's name, in lower case]
    #[arg(long, value_name = "NAME")]
    prefix: Option<String>,
    /// Take the crate denhart from this folder, not from crates.io
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
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let Language::C(options) = &options.language;
    let (text, name) = arm_file::text(&options.file).map_err(Failure::Other)?;
    let scalar = ScalarKind::from(options.scalar);
    let code = Code { scalar, ..Code::new(arm::TYPE) };
    let code = generate(&text, &name, &code).and_then(|generated| generated.to_file());
    let code = code.map_err(|mistakes| Failure::Other(crate::each(&mistakes)))?;
    let program = denhart_codegen::program(&text, &name).map_err(|mistakes| Failure::Other(crate::each(&mistakes)))?;
    let arm = Arm::new(&program, scalar, options.prefix.as_deref()).map_err(Failure::Usage)?;
    let denhart = match &options.crate_path {
        Some(path) => project::Dependency::at(path, &options.output).map_err(Failure::Other)?,
        None => project::Dependency::Published,
    };
    let folder = &options.output;
    let header = format!("include/{}.h", arm.prefix);
    let written = [
        ("Cargo.toml", project::manifest(&arm, &denhart)),
        ("CMakeLists.txt", project::cmake(&arm)),
        ("src/lib.rs", library::text(&arm)),
        ("src/arm.rs", code),
        (header.as_str(), header::text(&arm)),
    ]
    .map(|(file, text)| (folder.join(file), text));
    let written = written.each_ref().map(|(path, text)| (path.as_path(), text.as_str()));
    files::write(&written, options.force).map_err(Failure::Other)?;
    for (path, _) in written {
        writeln!(out, "wrote {}", path.display())?;
    }
    Ok(())
}
