//! `denhart new`: an arm file to start from.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::Failure;

/// What the command takes.
#[derive(Args)]
pub struct Options {
    /// Name of the arm; the file is NAME.yaml
    name: String,
    /// Which frame the rows of the table belong to
    #[arg(long, value_name = "CONVENTION", default_value = "standard")]
    convention: Convention,
    /// Write to this file instead, `-` to the standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Convention {
    /// Row i: Rz(theta) Tz(d) Tx(a) Rx(alpha)
    Standard,
    /// Craig, row i: Rx(alpha) Tx(a) Rz(theta) Tz(d), with a and alpha of the link before
    Modified,
}

/// Writes the file, unless there is one.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let text = text(&options.name, options.convention).map_err(Failure::Usage)?;
    let path = options.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.yaml", options.name)));
    if path.as_os_str() == "-" {
        return Ok(out.write_all(text.as_bytes())?);
    }
    let shown = path.display();
    let mut file = File::create_new(&path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            Failure::Other(format!("`{shown}` is there already\nhelp: remove it, or name another file with -o"))
        }
        _ => Failure::Other(format!("cannot write `{shown}`: {error}")),
    })?;
    file.write_all(text.as_bytes())?;
    Ok(writeln!(out, "wrote {shown}; now: denhart check {shown}")?)
}

fn text(name: &str, convention: Convention) -> Result<String, String> {
    let plain = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    if !name.starts_with(char::is_alphabetic) || !name.chars().all(plain) {
        return Err(format!(
            "`{name}` is no name for an arm\nhelp: write letters, digits, `_` and `-`, a letter first; -o names the file"
        ));
    }
    let (word, frame, rows) = match convention {
        Convention::Standard => ("standard", STANDARD, STANDARD_ROWS),
        Convention::Modified => ("modified", MODIFIED, MODIFIED_ROWS),
    };
    Ok(TEMPLATE.replace("NAME", name).replace("CONVENTION", word).replace("FRAME", frame).replace("ROWS\n", rows))
}

const STANDARD: &str = "row i is Rz(theta) Tz(d) Tx(a) Rx(alpha), from joint i's axis to the next one's";
const MODIFIED: &str = "Craig: row i is Rx(alpha) Tx(a) Rz(theta) Tz(d), a and alpha from the axis before to joint i's";

const STANDARD_ROWS: &str = "  - {a: 0,   alpha: 90,  d: 0.4, theta: 0,  limits: [-170, 170]}
  - {a: 0.5, alpha: 0,   d: 0,   theta: 0,  limits: [-60, 200]}
  - {a: 0,   alpha: 90,  d: 0,   theta: 90, limits: [-150, 150]}
  - {a: 0,   alpha: -90, d: 0.5, theta: 0}
  - {a: 0,   alpha: 90,  d: 0,   theta: 0,  limits: [-120, 120]}
  - {a: 0,   alpha: 0,   d: 0.1, theta: 0}
";
const MODIFIED_ROWS: &str = "  - {a: 0,   alpha: 0,   d: 0.4, theta: 0,  limits: [-170, 170]}
  - {a: 0,   alpha: 90,  d: 0,   theta: 0,  limits: [-60, 200]}
  - {a: 0.5, alpha: 0,   d: 0,   theta: 90, limits: [-150, 150]}
  - {a: 0,   alpha: 90,  d: 0.5, theta: 0}
  - {a: 0,   alpha: -90, d: 0,   theta: 0,  limits: [-120, 120]}
  - {a: 0,   alpha: 90,  d: 0.1, theta: 0}
";

const TEMPLATE: &str = "\
# NAME. Write here where the numbers come from: drawing, data sheet, page.
name: NAME
# CONVENTION: FRAME.
convention: CONVENTION
units: {length: m, angle: deg}   # m, cm, mm or in; deg or rad

# One row a joint, from the base to the tool. The joint's value is added to theta, or to d of a sliding joint.
# Angles are exact where people mean exact: 90, pi/2, 45 deg. Limits are optional, null is none on that side.
# Also for a row: `type: prismatic` (slides) or `type: fixed` (a constant row), `name: shoulder`.
joints:
ROWS
# Constant frames before the first row and after the last one; rotation Rz(yaw) Ry(pitch) Rx(roll).
# base: {xyz: [0, 0, 0], rpy: [0, 0, 0]}
tool: {xyz: [0, 0, 0.15], rpy: [0, 0, 0]}

# What the inverse is asked for; without it the most specific task the arm can do. `denhart check` says which.
# inverse: {task: pose, require: true}
";

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::arm;

    #[test]
    fn both_conventions_start_from_the_same_arm_and_nothing_is_wrong_with_it() {
        let [standard, modified] = [Convention::Standard, Convention::Modified].map(|convention| {
            let text = text("first", convention).unwrap();
            let report = denhart_codegen::check(&text, "first.yaml").unwrap();
            assert!(report.warnings.is_empty(), "{:?}", report.warnings);
            assert_eq!(report.max_solutions, Some(8), "{report}");
            arm::of_text(&text, "first.yaml").unwrap().chain
        });
        for q in [[0.0; 6], [0.3, 0.8, -1.1, 0.5, 0.9, -0.4]] {
            let (a, b) = (standard.forward(&q).unwrap(), modified.forward(&q).unwrap());
            assert!((a.to_homogeneous() - b.to_homogeneous()).amax() < 1e-15, "{a} {b}");
        }
    }

    #[test]
    fn a_name_that_is_none_is_refused() {
        for name in ["", "7dof", "my arm", "a/b", "x:"] {
            assert!(text(name, Convention::Standard).is_err(), "{name}");
        }
    }
}
