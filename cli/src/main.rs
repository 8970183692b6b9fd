//! The command `denhart`: see the library of this package.

use std::env;
use std::io;
use std::process::ExitCode;

fn main() -> ExitCode {
    denhart_cli::run(env::args_os(), &mut io::stdout(), &mut io::stderr()).into()
}
