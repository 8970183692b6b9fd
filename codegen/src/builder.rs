//! `Builder`: the generator for a build script, and behind `denhart expand`.

use std::env;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::arm_file::{self, ReadError};
use crate::error::{Diagnostic, Errors};
use crate::{Bound, Options, ScalarKind, generate};

/// Writes the code of one arm file: the struct and its impls, formatted.
///
/// In `build.rs`, with `denhart-codegen` as a build dependency:
/// ```no_run
/// fn main() -> Result<(), denhart_codegen::BuildError> {
///     denhart_codegen::Builder::new("specs/ur5.yaml").type_name("Ur5").write_to_out_dir("ur5.rs")
/// }
/// ```
/// and in the crate: `include!(concat!(env!("OUT_DIR"), "/ur5.rs"));`.
///
/// The written file depends on `denhart` alone, has no inner attributes, and compiles under `#![no_std]`.
#[derive(Debug, Clone)]
#[must_use = "a Builder does nothing until one of its write functions, or `generate`, is called"]
pub struct Builder {
    /// Path of the arm file; for an arm given as text, its name in messages.
    path: PathBuf,
    text: Option<String>,
    type_name: Option<String>,
    scalar: Result<ScalarKind, String>,
    crate_path: String,
    runtime_parameters: bool,
    batch: bool,
    warnings: bool,
}

impl Builder {
    /// A builder for the arm file at `path`, relative to the current directory: in a build script, the package's own.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        let crate_path = "::denhart".to_owned();
        let scalar = Ok(ScalarKind::F64);
        let path = path.into();
        Self {
            path,
            text: None,
            type_name: None,
            scalar,
            crate_path,
            runtime_parameters: false,
            batch: false,
            warnings: true,
        }
    }

    /// A builder for the text of an arm file, which messages call `name`. No file is read or watched.
    pub fn of_text(text: impl Into<String>, name: impl Into<String>) -> Self {
        Self { text: Some(text.into()), ..Self::new(name.into()) }
    }

    /// The name of the struct. Without it: the `name` of the file in upper camel case, `kuka_kr6_r700` as
    /// `KukaKr6R700`.
    pub fn type_name(mut self, name: impl Into<String>) -> Self {
        self.type_name = Some(name.into());
        self
    }

    /// The number type of the generated code: a [`ScalarKind`], or its name `"f64"` (the default) or `"f32"`.
    pub fn scalar<S>(mut self, scalar: S) -> Self
    where
        S: TryInto<ScalarKind>,
        S::Error: fmt::Display,
    {
        self.scalar = scalar.try_into().map_err(|error| error.to_string());
        self
    }

    /// Where the generated code finds the crate `denhart`; `::denhart` by default. For a renamed dependency or a
    /// re-export.
    pub fn crate_path(mut self, path: impl Into<String>) -> Self {
        self.crate_path = path.into();
        self
    }

    /// Binds the `parameters` of the file at run time, if true: the struct then has a public field for each. By default
    /// it has none, and their values in the file are constants.
    pub fn runtime_parameters(mut self, bound: bool) -> Self {
        self.runtime_parameters = bound;
        self
    }

    /// Emits the functions over lanes, too, if true, for `denhart::batch`: many poses at a time, in `f64`. The runtime then
    /// needs its feature `batch`. An arm with run-time parameters has none of them, and only an inverse of poses whose
    /// stages all have a lane form has one over lanes. Default: false.
    pub fn batch(mut self, emitted: bool) -> Self {
        self.batch = emitted;
        self
    }

    /// Prints the generator's advice on the file as a `cargo:warning`, one for the file, if true. Default: true.
    pub fn warnings(mut self, printed: bool) -> Self {
        self.warnings = printed;
        self
    }

    /// The generated code, formatted. Writes nothing and prints nothing.
    ///
    /// # Errors
    /// [`BuildError`]: the file cannot be read, its mistakes, or an option that is not valid Rust.
    pub fn generate(&self) -> Result<String, BuildError> {
        self.code().map(|(code, _)| code)
    }

    /// Writes the code to `file` in the directory `OUT_DIR` of the build script, for
    /// `include!(concat!(env!("OUT_DIR"), "/..."))`.
    /// Prints `cargo:rerun-if-changed` for the arm file, and the generator's advice as `cargo:warning`.
    ///
    /// # Errors
    /// [`BuildError`]: as `generate`; no `OUT_DIR` (not in a build script); the file cannot be written.
    pub fn write_to_out_dir(&self, file: impl AsRef<Path>) -> Result<(), BuildError> {
        let directory = env::var_os("OUT_DIR").ok_or(BuildError::OutDir)?;
        self.write_to(Path::new(&directory).join(file))
    }

    /// Writes the code to `path`, for a file that is committed; one that has this content already is left untouched.
    /// Prints `cargo:rerun-if-changed` for the arm file, and the generator's advice as `cargo:warning`.
    ///
    /// # Errors
    /// [`BuildError`]: as `generate`; the file cannot be written.
    pub fn write_to(&self, path: impl AsRef<Path>) -> Result<(), BuildError> {
        if self.text.is_none() {
            println!("cargo:rerun-if-changed={}", self.path.display());
        }
        let (code, advice) = self.code()?;
        if let Some(line) = summary(&advice, &self.path).filter(|_| self.warnings) {
            println!("cargo:warning={line}");
        }
        let path = path.as_ref();
        if fs::read(path).is_ok_and(|present| present == code.as_bytes()) {
            return Ok(());
        }
        fs::write(path, code).map_err(|error| BuildError::Write { path: path.to_owned(), error })
    }

    fn code(&self) -> Result<(String, Vec<Diagnostic>), BuildError> {
        let scalar = self.scalar.clone().map_err(BuildError::Scalar)?;
        let crate_path =
            syn::parse_str(&self.crate_path).map_err(|_| BuildError::CratePath { written: self.crate_path.clone() })?;
        let text = match &self.text {
            Some(text) => text.clone(),
            None => arm_file::read(&env::current_dir().unwrap_or_default(), &self.path)?,
        };
        let file = self.path.display().to_string();
        let type_name = match &self.type_name {
            Some(name) => name.clone(),
            None => self.default_type_name(&text, &file),
        };
        if syn::parse_str::<syn::Ident>(&type_name).is_err() {
            return Err(BuildError::TypeName { written: type_name });
        }
        let bound = if self.runtime_parameters { Bound::All } else { Bound::None };
        let generated = generate(&text, &file, &Options { type_name, scalar, crate_path, bound, batch: self.batch })?;
        Ok((generated.to_file()?, generated.warnings))
    }

    /// From the name in the file, else (a file with mistakes, which `generate` reports) from the name of the file.
    fn default_type_name(&self, text: &str, file: &str) -> String {
        match crate::spec::read(text, file) {
            Ok((spec, _)) => upper_camel_case(&spec.name),
            Err(_) => upper_camel_case(&self.path.file_stem().unwrap_or_default().to_string_lossy()),
        }
    }
}

/// Reason for which a [`Builder`] wrote nothing. `Debug` shows the same text as `Display`, so that a build script whose `main`
/// returns it fails readably.
pub enum BuildError {
    /// The arm file is missing or unreadable.
    Read(ReadError),
    /// The mistakes in the arm file, all of them.
    Arm(Errors),
    /// The name given to `scalar` is not `f64` or `f32`.
    Scalar(String),
    /// `type_name` is not an identifier.
    TypeName {
        /// The name as it was given.
        written: String,
    },
    /// `crate_path` is not a path.
    CratePath {
        /// The path as it was given.
        written: String,
    },
    /// There is no `OUT_DIR`.
    OutDir,
    /// The generated file cannot be written.
    Write {
        /// Where it was to be written.
        path: PathBuf,
        /// Error of the system.
        error: io::Error,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(error) => error.fmt(f),
            Self::Arm(errors) => errors.fmt(f),
            Self::Scalar(message) => f.write_str(message),
            Self::TypeName { written } => {
                write!(f, "`{written}` cannot be the name of a struct\nhelp: give an identifier, such as `Ur5`")
            }
            Self::CratePath { written } => {
                write!(f, "`{written}` is not a path to the crate denhart\nhelp: give a path, such as `::denhart`")
            }
            Self::OutDir => f.write_str(
                "OUT_DIR is not set: cargo sets it for a build script\nhelp: elsewhere, give a path to `write_to`",
            ),
            Self::Write { path, error } => write!(f, "cannot write `{}`: {error}", path.display()),
        }
    }
}

impl std::error::Error for BuildError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Write { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<ReadError> for BuildError {
    fn from(error: ReadError) -> Self {
        Self::Read(error)
    }
}

impl From<Errors> for BuildError {
    fn from(errors: Errors) -> Self {
        Self::Arm(errors)
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// All advice in one line: the first piece, and where the others are.
fn summary(advice: &[Diagnostic], file: &Path) -> Option<String> {
    let first = one_line(advice.first()?);
    let file = file.display();
    Some(match advice.len() - 1 {
        0 => first,
        1 => format!("{first} (and 1 remark more: `denhart check {file}` shows both)"),
        more => format!("{first} (and {more} remarks more: `denhart check {file}` shows all)"),
    })
}

/// A piece of advice on one line: cargo shows one line for each `cargo:warning`.
fn one_line(advice: &Diagnostic) -> String {
    let mut line = String::new();
    if let Some(at) = &advice.at {
        line += &format!("{}:{}:{}: ", at.file, at.line, at.column);
    }
    line += &advice.message;
    if let Some(help) = &advice.help {
        line += "; ";
        line += help;
    }
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `abb_irb2400` as `AbbIrb2400`; a name that would begin with a digit gets `Arm` before it.
fn upper_camel_case(name: &str) -> String {
    let mut camel = String::new();
    for word in name.split(|c: char| !c.is_alphanumeric()) {
        let mut letters = word.chars();
        camel.extend(letters.next().map(|first| first.to_ascii_uppercase()));
        camel.push_str(letters.as_str());
    }
    if camel.starts_with(|c: char| c.is_alphabetic()) && camel != "Self" { camel } else { format!("Arm{camel}") }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]

    use super::*;

    fn specs(file: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(file)
    }

    #[test]
    fn type_names() {
        for (name, camel) in [
            ("ur5", "Ur5"),
            ("kuka_kr6_r700", "KukaKr6R700"),
            ("abb-irb 120", "AbbIrb120"),
            ("UR5e", "UR5e"),
            ("2r_planar", "Arm2rPlanar"),
            ("self", "ArmSelf"),
            ("__", "Arm"),
        ] {
            assert_eq!(upper_camel_case(name), camel);
            assert!(syn::parse_str::<syn::Ident>(camel).is_ok(), "{camel}");
        }
    }

    #[test]
    fn advice_is_one_line() {
        let advice = |n: usize| vec![Diagnostic::warning("`alpha`: 1.5708 is nearly 90").help("write 90"); n];
        let line = |n| summary(&advice(n), Path::new("arm.yaml")).unwrap_or_default();
        assert_eq!(line(0), "");
        assert_eq!(line(1), "`alpha`: 1.5708 is nearly 90; write 90");
        assert_eq!(
            line(5),
            "`alpha`: 1.5708 is nearly 90; write 90 (and 4 remarks more: `denhart check arm.yaml` shows all)"
        );
    }

    #[test]
    fn the_struct_is_named_after_the_arm() {
        let code = Builder::new(specs("kuka_kr6_r700.yaml")).generate().unwrap();
        assert!(code.contains("pub struct KukaKr6R700;"), "{code}");
    }

    #[test]
    fn options_reach_the_code() {
        let code = Builder::new(specs("ur5.yaml"))
            .type_name("Left")
            .scalar("f32")
            .crate_path("crate::arm")
            .generate()
            .unwrap();
        assert!(code.contains("pub struct Left;"), "{code}");
        // The DH table is f64 whatever the scalar: it is the input of `Chain`.
        assert!(code.contains("q: &[f32; 6]") && !code.replace("::core::f64::consts", "").contains("f64"), "{code}");
        assert!(code.contains("crate::arm::Pose") && !code.contains("::denhart"), "{code}");
        assert_eq!(
            Builder::new(specs("ur5.yaml")).scalar(ScalarKind::F32).generate().unwrap(),
            Builder::new(specs("ur5.yaml")).scalar("f32").generate().unwrap()
        );
    }

    #[test]
    fn wrong_options_are_named() {
        let text = |builder: Builder| builder.generate().unwrap_err().to_string();
        let ur5 = || Builder::new(specs("ur5.yaml"));
        assert_eq!(text(ur5().scalar("f16")), "unknown scalar `f16`\nhelp: write `f64` or `f32`");
        assert_eq!(
            text(ur5().type_name("my arm")),
            "`my arm` cannot be the name of a struct\nhelp: give an identifier, such as `Ur5`"
        );
        assert_eq!(
            text(ur5().crate_path("den hart")),
            "`den hart` is not a path to the crate denhart\nhelp: give a path, such as `::denhart`"
        );
    }

    #[test]
    fn debug_reads_as_display() {
        let error = Builder::new("no/such.yaml").generate().unwrap_err();
        assert_eq!(format!("{error:?}"), error.to_string());
        assert!(error.to_string().starts_with("no arm file at `"), "{error}");
    }

    #[test]
    fn a_file_with_this_content_is_left_untouched() {
        let path = env::temp_dir().join(format!("denhart-builder-{}.rs", std::process::id()));
        let builder = Builder::new(specs("ur5.yaml"));
        builder.write_to(&path).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), builder.generate().unwrap());
        let written = fs::metadata(&path).unwrap().modified().unwrap();
        builder.write_to(&path).unwrap();
        assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), written);
        fs::remove_file(&path).unwrap();
    }

    #[test]
    fn a_place_that_cannot_be_written_is_named() {
        let error = Builder::new(specs("ur5.yaml")).write_to("/no/such/place.rs").unwrap_err();
        assert!(error.to_string().starts_with("cannot write `/no/such/place.rs`: "), "{error}");
    }
}
