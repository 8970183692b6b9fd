//! The command `denhart`: see the library of this package.

use std::env;
use std::process::ExitCode;

/// The streams take the colors out unless they lead to a terminal. `NO_COLOR` and `CLICOLOR_FORCE` say otherwise.
fn main() -> ExitCode {
    denhart_cli::run_styled(env::args_os(), &mut anstream::stdout(), &mut anstream::stderr()).into()
}
