//! Commands of `check.sh` on the host. Each command prints to standard output and fails with a message on standard
//! error:
//!
//! - `arms`: the names of the arms that are measured; `followed`: of those whose followers are
//! - `bits FILE`: computes the digests that the chip wrote to the file, and compares
//! - `c FILE`: the same for the program in C
//! - `flash ELF`, `symbols ELF`: bytes of a program, of its largest functions
//! - `doubles ELF`: fails if the program has a routine of double-precision arithmetic
//! - `panics ELF`: fails if the program has a path to a panic
//! - `profile ELF FUNCTION`: instructions by symbol, from the emulator's trace on standard input
//! - `table FOLDER COMMITTED PAGE [--accept]`: the table of all measurements, compared with the committed one; a short form of
//!   it stands in the page

mod bits;
mod c;
mod elf;
mod page;
mod profile;
mod rows;
mod table;

use std::env;
use std::path::Path;
use std::process::ExitCode;

/// Why a command failed.
type Error = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match arguments.as_slice() {
        ["arms"] => {
            println!("{}", rows::arms().join("\n"));
            Ok(())
        }
        ["followed"] => {
            println!("{}", rows::followed().join("\n"));
            Ok(())
        }
        ["bits", file] => bits::compare(Path::new(file)),
        ["c", file] => c::compare(Path::new(file)),
        ["flash", file] => elf::Program::read(Path::new(file)).map(|program| println!("{}", program.flash)),
        ["symbols", file] => elf::Program::read(Path::new(file)).map(|program| program.print_symbols(30)),
        ["doubles", file] => elf::Program::read(Path::new(file)).and_then(|program| program.has_no_doubles()),
        ["panics", file] => elf::Program::read(Path::new(file)).and_then(|program| program.has_no_panics()),
        ["profile", file, function] => {
            elf::Program::read(Path::new(file)).and_then(|program| profile::print(&program, function))
        }
        ["table", folder, committed, page] => table::check(Path::new(folder), Path::new(committed), Path::new(page), false),
        ["table", folder, committed, page, "--accept"] => table::check(Path::new(folder), Path::new(committed), Path::new(page), true),
        _ => Err(
            "usage: firmware-host arms | followed | bits FILE | c FILE | flash ELF | symbols ELF | doubles ELF | panics ELF | profile ELF FUNCTION | table FOLDER COMMITTED PAGE [--accept]"
                .into(),
        ),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
