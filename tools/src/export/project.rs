//! The crate's manifest and the file for CMake.

use super::Dependency;
use super::arm::Arm;

/// `Cargo.toml`.
pub fn manifest(arm: &Arm<'_>, denhart: &Dependency) -> String {
    let denhart = match denhart {
        Dependency::Published => r#"version = "@version@""#.to_owned(),
        // A text of JSON is one of TOML.
        Dependency::Folder(path) => {
            format!("path = {}", serde_json::Value::from(path.replace('\\', "/")))
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
