//! The text of an arm file, and its arm as a chain that is computed at run time.

use std::env;
use std::io::Read;
use std::path::Path;

use denhart_tools::Arm;

/// Name of the standard input in messages.
const STANDARD_INPUT: &str = "<stdin>";

/// The text of an arm file and its name for messages; `-` is the standard input.
///
/// # Errors
/// The message.
pub fn text(file: &Path) -> Result<(String, String), String> {
    if file.as_os_str() == "-" {
        let mut bytes = Vec::new();
        let read = std::io::stdin().read_to_end(&mut bytes);
        read.map_err(|error| format!("cannot read the standard input: {error}"))?;
        let text = denhart_codegen::decode(bytes, "the standard input").map_err(|error| error.to_string())?;
        return not_urdf(text, STANDARD_INPUT.to_owned());
    }
    let here = env::current_dir().map_err(|error| error.to_string())?;
    let text = denhart_codegen::read_file(&here, file).map_err(|error| error.to_string())?;
    not_urdf(text, file.display().to_string())
}

/// Text and name, unless the text is a URDF.
fn not_urdf(text: String, name: String) -> Result<(String, String), String> {
    if text.trim_start().starts_with('<') && text.contains("<robot") {
        return Err(format!("{name}: this is a URDF\nhelp: denhart import {name} -o arm.yaml"));
    }
    Ok((text, name))
}

/// The arm of the file, or the mistakes in it.
///
/// # Errors
/// The message.
pub fn read(file: &Path) -> Result<Arm, String> {
    let (text, name) = text(file)?;
    Arm::of_text(&text, &name).map_err(|mistakes| crate::each(&mistakes))
}
