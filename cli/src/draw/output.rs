//! Where a picture goes: a file, the standard output, or the terminal.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use denhart_draw::{Scene, Style};

use super::terminal::{Protocol, escapes};
use crate::Failure;

/// The mark of pictures of this command in an SVG file.
const OWN: &[u8] = b"data-by=\"denhart draw\"";

/// Where a picture goes.
pub enum Output {
    Svg(PathBuf),
    Png(PathBuf),
    /// The standard output, as SVG.
    Print,
    /// The terminal if it shows pictures, else a file that is called as the arm.
    Unnamed,
}

impl Output {
    /// Reads the option.
    ///
    /// # Errors
    /// A file of another kind.
    pub fn of(option: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = option else { return Ok(Self::Unnamed) };
        if path.as_os_str() == "-" {
            return Ok(Self::Print);
        }
        let kind = path.extension().map(|kind| kind.to_string_lossy().to_lowercase());
        match kind.as_deref() {
            Some("svg") => Ok(Self::Svg(path.to_owned())),
            Some("png") => Ok(Self::Png(path.to_owned())),
            _ => Err(Failure::Usage(format!(
                "--output: `{}` is no file for a picture\nhelp: write a name that ends in .svg or .png",
                path.display()
            ))),
        }
    }

    /// Writes the picture, and its place to `out`. A PNG is `width` pixels wide.
    ///
    /// # Errors
    /// No way to write; a file of something else under the name of the arm.
    pub fn write(&self, scene: &Scene, style: &Style, width: u32, out: &mut dyn Write) -> Result<(), Failure> {
        match self {
            Self::Svg(path) => saved(path, scene.svg(style).as_bytes(), out),
            Self::Png(path) => saved(path, &scene.png(style, width)?, out),
            Self::Print => Ok(out.write_all(scene.svg(style).as_bytes())?),
            Self::Unnamed => {
                let terminal = io::stdout().is_terminal().then(|| Protocol::of(&|name| std::env::var(name).ok()));
                if let Some(protocol) = terminal.flatten() {
                    // Not by `out`, which may take escape sequences out.
                    let mut terminal = io::stdout().lock();
                    terminal.write_all(escapes(protocol, &scene.png(style, width)?).as_bytes())?;
                    return Ok(terminal.flush()?);
                }
                let path = PathBuf::from(file_name(&scene.name) + ".svg");
                if let Ok(there) = fs::read(&path)
                    && !there.windows(OWN.len()).any(|part| part == OWN)
                {
                    return Err(Failure::Other(format!(
                        "`{}` is there already, and no picture of this command\nhelp: name another file with -o",
                        path.display()
                    )));
                }
                saved(&path, scene.svg(style).as_bytes(), out)
            }
        }
    }
}

fn saved(path: &Path, bytes: &[u8], out: &mut dyn Write) -> Result<(), Failure> {
    let cannot = |error: io::Error| Failure::Other(format!("cannot write `{}`: {error}", path.display()));
    fs::write(path, bytes).map_err(cannot)?;
    Ok(writeln!(out, "{}", path.display())?)
}

/// A name without characters that file systems or shells take for something else.
fn file_name(name: &str) -> String {
    let letter = |c: char| if c.is_alphanumeric() || c == '_' || c == '-' { c } else { '_' };
    name.chars().take(80).map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_arms_make_names_of_files() {
        assert_eq!(file_name("ur5"), "ur5");
        assert_eq!(file_name("../arm 1"), "___arm_1");
    }
}
