//! For build scripts: modules of generated arms, each with a call of every function that the arm has.
//!
//! The functions are read from the generated code, not from a list. A function that is new in the generator is
//! therefore measured and proved from then on. An argument that no case has is an error of the build.

mod functions;
mod module;

use std::path::{Path, PathBuf};
use std::{env, fs};

pub use module::Scalar;

/// Why a build script wrote nothing.
pub type Error = Box<dyn std::error::Error>;

/// Folders of arm files: those of the repository, and measured ones for the proof alone.
#[must_use]
pub fn folders() -> [PathBuf; 2] {
    ["../../specs", "../proof/arms"].map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder))
}

/// Names of all arm files, sorted.
///
/// # Errors
/// A folder cannot be read.
pub fn all_arms() -> Result<Vec<String>, Error> {
    let mut names = Vec::new();
    for folder in folders() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.extension().is_some_and(|extension| extension == "yaml") {
                names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
            }
        }
    }
    names.sort();
    Ok(names)
}

/// Writes `file` in `OUT_DIR`: a module `puma560_f32` for each arm and scalar.
///
/// # Errors
/// An arm file is missing or refused, or a function has an argument that no case has.
pub fn write(file: &str, arms: &[(&str, Scalar)]) -> Result<(), Error> {
    let mut text = String::new();
    for &(arm, scalar) in arms {
        let [spec, measured] = folders().map(|folder| folder.join(format!("{arm}.yaml")));
        let path = if measured.exists() { measured } else { spec };
        println!("cargo:rerun-if-changed={}", path.display());
        text += &module::of(arm, scalar, &path)?;
    }
    let directory = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    fs::write(Path::new(&directory).join(file), text)?;
    Ok(())
}
