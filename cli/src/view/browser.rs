//! Opens an address in the user's browser.

use std::process::{Command, Stdio};

/// Opens the address, if the system has a way to. The address is printed besides: nothing depends on it.
pub fn open(address: &str) {
    let command: &[&str] = if cfg!(target_os = "macos") {
        &["open"]
    } else if cfg!(target_os = "windows") {
        &["rundll32", "url.dll,FileProtocolHandler"]
    } else {
        &["xdg-open"]
    };
    let Some((program, arguments)) = command.split_first() else { return };
    let quiet = Stdio::null;
    let _ = Command::new(program).args(arguments).arg(address).stdin(quiet()).stdout(quiet()).stderr(quiet()).spawn();
}
