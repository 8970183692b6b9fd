//! `denhart export`: an arm as a library for another language.

mod arm;
mod header;
mod library;
mod project;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use denhart_codegen::{Options as Code, ScalarKind, generate};

use crate::{Failure, Scalar, arm as arm_file, files};
use arm::Arm;
use project::Dependency;

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
    let (text, name) = arm_file::text(&options.file).map_err(Failure::Other)?;
    let scalar = ScalarKind::from(options.scalar);
    let code = Code { scalar, ..Code::new(arm::TYPE) };
    let refused = |mistakes| Failure::Other(crate::each(&mistakes));
    let generated = generate(&text, &name, &code).map_err(refused)?;
    let code = generated.to_file().map_err(refused)?;
    let program = denhart_codegen::program(&text, &name).map_err(refused)?;
    let arm = Arm::new(&program, scalar, options.prefix.as_deref()).map_err(Failure::Usage)?;
    let (folder, beside) = (&options.output, Path::new(project::BUILT_BESIDE));
    let denhart = Dependency::find(options.crate_path.as_deref(), beside, folder).map_err(Failure::Other)?;
    match denhart {
        Dependency::Folder(_) => writeln!(out, "{}", denhart.remark(folder))?,
        Dependency::Published => writeln!(err, "{}", denhart.remark(folder))?,
    }
    if let Some(reason) = &generated.report.unsupported {
        writeln!(err, "{}", without_inverse(&name, reason, generated.report.hint.as_deref()))?;
    }
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

/// The warning of an arm whose library has no inverse.
fn without_inverse(name: &str, reason: &str, hint: Option<&str>) -> String {
    let help = hint.unwrap_or("`denhart::numeric`, in a program in Rust, solves any arm by iteration");
    format!("warning: {name}: the library has no inverse kinematics: {reason}\nhelp: {help}")
}
