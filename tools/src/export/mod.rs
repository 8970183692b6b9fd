//! An arm as a library for another language.

mod arm;
mod header;
mod library;
mod project;

use denhart_codegen::{Options, ScalarKind, generate};

use crate::Error;
use arm::Arm;

/// The form of a library for C.
#[derive(Debug, Clone, PartialEq)]
pub struct COptions {
    /// Number type of all values: `double` in C, or `float`.
    pub scalar: ScalarKind,
    /// Beginning of the names in C: letters in lower case, digits and `_`. Without it: the arm's name.
    pub prefix: Option<String>,
    /// Where the library takes the crate denhart from.
    pub denhart: Dependency,
}

impl Default for COptions {
    fn default() -> Self {
        Self { scalar: ScalarKind::F64, prefix: None, denhart: Dependency::Published }
    }
}

/// Where a library takes the crate denhart from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Dependency {
    /// crates.io, in the version of this crate.
    Published,
    /// The folder of the crate, as seen from that of the library.
    Folder(String),
}

/// A library as files.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Library {
    /// All files of the library's folder.
    pub files: Vec<File>,
    /// The reason why the library has no inverse, for an arm without one, with a line `help: ..`.
    pub without_inverse: Option<String>,
}

/// A file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its place in the folder, with `/`.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// The arm as a static library for C: a crate, its header, and a `CMakeLists.txt`.
///
/// The crate needs the crate denhart alone, neither `std` nor an allocator. `name` is that of the arm file, for messages.
///
/// # Errors
/// Mistakes in the arm file; a prefix that is no name in C, or is taken.
///
/// ```
/// use denhart_tools::export::{self, COptions};
///
/// # fn main() -> Result<(), denhart_tools::Error> {
/// let arm = "
/// name: elbow
/// convention: standard
/// joints:
///   - {a: 0.3, alpha: 0, d: 0, theta: 0}
///   - {a: 0.2, alpha: 0, d: 0, theta: 0}
/// ";
/// let library = export::c(arm, "elbow.yaml", &COptions::default())?;
/// let paths: Vec<&str> = library.files.iter().map(|file| file.path.as_str()).collect();
/// assert_eq!(paths, ["Cargo.toml", "CMakeLists.txt", "src/lib.rs", "src/arm.rs", "include/elbow.h"]);
/// # Ok(())
/// # }
/// ```
pub fn c(text: &str, name: &str, options: &COptions) -> Result<Library, Error> {
    let code = Options { scalar: options.scalar, ..Options::new(arm::TYPE) };
    let generated = generate(text, name, &code)?;
    let code = generated.to_file()?;
    let program = denhart_codegen::program(text, name)?;
    let arm = Arm::new(&program, options.scalar, options.prefix.as_deref()).map_err(Error::Option)?;
    let files = [
        ("Cargo.toml".to_owned(), project::manifest(&arm, &options.denhart)),
        ("CMakeLists.txt".to_owned(), project::cmake(&arm)),
        ("src/lib.rs".to_owned(), library::text(&arm)),
        ("src/arm.rs".to_owned(), code),
        (format!("include/{}.h", arm.prefix), header::text(&arm)),
    ];
    let report = &generated.report;
    let without_inverse = |reason: &String| without_inverse(name, reason, report.hint.as_deref());
    Ok(Library {
        files: files.map(|(path, text)| File { path, text }).into(),
        without_inverse: report.unsupported.as_ref().map(without_inverse),
    })
}

/// The remark on an arm whose library has no inverse.
fn without_inverse(name: &str, reason: &str, hint: Option<&str>) -> String {
    let help = hint.unwrap_or("`denhart::numeric`, in a program in Rust, solves any arm by iteration");
    format!("{name}: the library has no inverse kinematics: {reason}\nhelp: {help}")
}
