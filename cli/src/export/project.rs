//! The crate's manifest and the file for CMake.

use std::fs;
use std::path::{Component, Path, PathBuf};

use super::arm::Arm;

/// Where the library takes the crate denhart from.
pub enum Dependency {
    /// crates.io, in the version of this command.
    Published,
    /// A folder, as seen from the library's.
    Folder(PathBuf),
}

/// The crate denhart that this command was built beside. It is gone where a clone has been removed, and not there where
/// the command came from crates.io.
pub const BUILT_BESIDE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../runtime");

impl Dependency {
    /// The crate at `named`, else the one at `beside`, else that of crates.io.
    ///
    /// # Errors
    /// The message: there is no such crate at `named`.
    pub fn find(named: Option<&Path>, beside: &Path, folder: &Path) -> Result<Self, String> {
        match named {
            Some(path) => Self::at(path, folder),
            None => Ok(Self::at(beside, folder).unwrap_or(Self::Published)),
        }
    }

    /// The line that says where the crate comes from, before anything is written. crates.io may not have it.
    pub fn remark(&self, folder: &Path) -> String {
        let manifest = folder.join("Cargo.toml");
        let manifest = manifest.display();
        match self {
            Self::Folder(path) => format!("{manifest}: `denhart` is that of `{}`", path.display()),
            Self::Published => format!(
                "warning: {manifest}: `denhart` {} is that of crates.io, which cargo finds only where it is published\n\
                 help: --crate-path DIR, the folder `runtime` of a clone of denhart's repository",
                env!("CARGO_PKG_VERSION")
            ),
        }
    }

    /// The crate at `path`, for a library in `folder`, which need not be there yet.
    ///
    /// # Errors
    /// The message: there is no such crate.
    fn at(path: &Path, folder: &Path) -> Result<Self, String> {
        let shown = path.display();
        let manifest = fs::read_to_string(path.join("Cargo.toml"))
            .map_err(|error| format!("--crate-path: cannot read `{shown}/Cargo.toml`: {error}"))?;
        if !manifest.lines().any(|line| line.replace(' ', "") == "name=\"denhart\"") {
            return Err(format!(
                "--crate-path: `{shown}` is not the crate denhart\nhelp: name the folder `runtime` of its repository"
            ));
        }
        let absolute =
            |path: &Path| std::path::absolute(path).map_err(|error| format!("`{}`: {error}", path.display()));
        // Where links lead: `..` of a link is not what it looks like.
        let to = path.canonicalize().map_err(|error| format!("--crate-path: `{shown}`: {error}"))?;
        let from = resolved(&absolute(folder)?);
        Ok(Self::Folder(relative(&from, &to)))
    }
}

/// An absolute path with the links resolved of what there is of it.
fn resolved(path: &Path) -> PathBuf {
    match (path.canonicalize(), path.parent(), path.file_name()) {
        (Err(_), Some(parent), Some(name)) => resolved(parent).join(name),
        (found, ..) => found.unwrap_or_else(|_| path.to_owned()),
    }
}

/// `to` as seen from `from`, both absolute; `to` itself where they have no beginning in common, as on two drives.
fn relative(from: &Path, to: &Path) -> PathBuf {
    let common = from.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    if !matches!(to.components().next(), Some(first) if from.components().next() == Some(first)) {
        return to.to_owned();
    }
    let up = from.components().skip(common).map(|_| Component::ParentDir);
    up.chain(to.components().skip(common)).collect()
}

/// `Cargo.toml`.
pub fn manifest(arm: &Arm<'_>, denhart: &Dependency) -> String {
    let denhart = match denhart {
        Dependency::Published => r#"version = "@version@""#.to_owned(),
        // A text of JSON is one of TOML.
        Dependency::Folder(path) => {
            format!("path = {}", serde_json::Value::from(path.to_string_lossy().replace('\\', "/")))
        }
    };
    arm.fill(MANIFEST).replace("@denhart@", &arm.fill(&denhart)).replace("@rust@", env!("CARGO_PKG_RUST_VERSION"))
}

/// `CMakeLists.txt`.
pub fn cmake(arm: &Arm<'_>) -> String {
    arm.fill(CMAKE)
}

const MANIFEST: &str = r#"# The arm `@arm@` for C, exported by denhart @version@.
[package]
name = "@prefix@_c"
version = "0.1.0"
edition = "2024"
rust-version = "@rust@"
publish = false

[lib]
crate-type = ["staticlib"]
# A test needs the standard library, which has a panic handler of its own.
test = false
doctest = false

[features]
# The square root of the standard library: for programs of an operating system, with one such library a program.
std = ["denhart/std"]
# The square root instruction of the processor: for microcontrollers with a floating-point unit.
fpu = ["denhart/fpu"]

[dependencies]
denhart = { @denhart@, default-features = false }

# A crate by itself, also inside the folder of another one.
[workspace]

[profile.release]
opt-level = 3        # or "s"
panic = "abort"
lto = "fat"
codegen-units = 1

# Without optimization checks stay that cannot fail, and the library needs parts of the standard library.
[profile.dev]
opt-level = 3
panic = "abort"
lto = "fat"
codegen-units = 1
debug-assertions = false
overflow-checks = false
"#;

const CMAKE: &str = r#"# The arm `@arm@`, exported by denhart @version@; cargo builds its library.
#
#   add_subdirectory(this_folder)
#   target_link_libraries(my_program PRIVATE @prefix@)
#
# DENHART_RUST_TARGET: target triple of rustc, such as thumbv7em-none-eabihf; empty for this machine.
# DENHART_CARGO_FLAGS: more arguments of `cargo build`, such as "--features;fpu".
cmake_minimum_required(VERSION 3.18)
project(@prefix@ LANGUAGES C)

set(DENHART_RUST_TARGET "" CACHE STRING "Target triple of rustc, empty for this machine")
set(DENHART_CARGO_FLAGS "" CACHE STRING "More arguments of cargo build")
find_program(DENHART_CARGO cargo REQUIRED)

set(@prefix@_cargo ${CMAKE_CURRENT_BINARY_DIR}/cargo)
set(@prefix@_flags build --release --manifest-path ${CMAKE_CURRENT_SOURCE_DIR}/Cargo.toml --target-dir ${@prefix@_cargo})
if(DENHART_RUST_TARGET)
  list(APPEND @prefix@_flags --target ${DENHART_RUST_TARGET})
endif()
set(@prefix@_library
  ${@prefix@_cargo}/${DENHART_RUST_TARGET}/release/${CMAKE_STATIC_LIBRARY_PREFIX}@prefix@_c${CMAKE_STATIC_LIBRARY_SUFFIX})

# Always run: cargo knows best whether anything has changed.
add_custom_target(@prefix@_build ALL
  COMMAND ${DENHART_CARGO} ${@prefix@_flags} ${DENHART_CARGO_FLAGS}
  BYPRODUCTS ${@prefix@_library}
  VERBATIM)

add_library(@prefix@ STATIC IMPORTED GLOBAL)
add_dependencies(@prefix@ @prefix@_build)
set_target_properties(@prefix@ PROPERTIES
  IMPORTED_LOCATION ${@prefix@_library}
  INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_SOURCE_DIR}/include)
"#;

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{BUILT_BESIDE, Dependency, relative};

    #[test]
    fn a_crate_that_is_not_there_is_announced() {
        let folder = Path::new("/no/such/place");
        let published = Dependency::find(None, folder, folder);
        let remark = published.map(|found| found.remark(folder)).unwrap_or_default();
        assert!(
            remark.starts_with("warning: /no/such/place/Cargo.toml: `denhart` ") && remark.contains("--crate-path DIR")
        );
        // Seen from here, which is where the test runs.
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let beside = Dependency::find(None, Path::new(BUILT_BESIDE), here);
        assert!(matches!(beside, Ok(Dependency::Folder(path)) if path.join("src/lib.rs").is_file()));
        assert!(Dependency::find(Some(folder), Path::new(BUILT_BESIDE), folder).is_err());
    }

    #[test]
    fn a_folder_seen_from_another() {
        for (from, to, seen) in
            [("/a/b/c", "/a/d", "../../d"), ("/a", "/a/d/e", "d/e"), ("/a/b", "/a/b", ""), ("/a/b", "/c", "../../c")]
        {
            assert_eq!(relative(Path::new(from), Path::new(to)), Path::new(seen), "{from} {to}");
        }
    }
}
