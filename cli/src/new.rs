//! `denhart new`: an arm file to start from.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

use clap::Args;
use denhart_tools::presets::preset;

use crate::Failure;
use crate::templates::{self, Convention, SCARA};

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// Name of the arm; the file is NAME.yaml [default: with --like that of the arm]
    #[arg(required_unless_present = "like")]
    name: Option<String>,
    /// Start with so many joints, 3 to 7
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(3..=7))]
    joints: u8,
    /// Start with a SCARA: two links that turn, a quill that slides and turns
    #[arg(long, conflicts_with = "joints")]
    scara: bool,
    /// Start with the file of a known arm; `denhart arms` lists them
    #[arg(long, value_name = "ARM", conflicts_with_all = ["joints", "scara", "convention"])]
    like: Option<String>,
    /// Which frame the rows of the table belong to
    #[arg(long, value_name = "CONVENTION", default_value = "standard")]
    convention: Convention,
    /// Write to this file instead, `-` to the standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Writes the file, unless there is one.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let (name, text) = named(options).map_err(Failure::Usage)?;
    let path = options.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}.yaml")));
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

/// The name of the arm, and the text of its file.
fn named(options: &Options) -> Result<(&str, String), String> {
    let Options { name, like, joints, scara, convention, .. } = options;
    let name = name.as_deref().or(like.as_deref()).unwrap_or_default();
    let plain = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    if !name.starts_with(char::is_alphabetic) || !name.chars().all(plain) {
        return Err(format!(
            "`{name}` is no name for an arm\nhelp: write letters, digits, `_` and `-`, a letter first; -o names the file"
        ));
    }
    if let Some(like) = like {
        return Ok((name, renamed(preset(like).map_err(|error| error.to_string())?.arm_file, name)));
    }
    let template = if *scara { Some(&SCARA) } else { templates::of_joints(*joints) };
    let text = template.map(|template| template.text(name, *convention));
    Ok((name, text.ok_or_else(|| format!("no template for {joints} joints\nhelp: --joints takes 3 to 7"))?))
}

/// An arm file with another name of the arm.
fn renamed(file: &str, name: &str) -> String {
    let line = |line: &str| if line.starts_with("name: ") { format!("name: {name}\n") } else { format!("{line}\n") };
    file.lines().map(line).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Whole {
        #[command(flatten)]
        options: Options,
    }

    fn text(arguments: &[&str]) -> Result<String, String> {
        let Whole { options } = Whole::try_parse_from([&["new"], arguments].concat()).unwrap();
        named(&options).map(|(_, text)| text)
    }

    #[test]
    fn a_name_that_is_none_is_refused() {
        for name in ["", "7dof", "my arm", "a/b", "x:"] {
            assert!(text(&[name]).is_err(), "{name}");
            assert!(text(&[name, "--like", "ur5"]).is_err(), "{name}");
        }
    }

    #[test]
    fn a_known_arm_keeps_everything_but_its_name() {
        let own = text(&["--like", "ur5"]).unwrap();
        assert_eq!(own, preset("ur5").unwrap().arm_file);
        let crane = text(&["crane", "--like", "ur5"]).unwrap();
        assert_eq!(crane.replace("name: crane\n", "name: ur5\n"), own);
        assert!(crane.contains("name: crane\n"));
        let said = text(&["--like", "ur55"]).unwrap_err();
        assert!(said.contains("no arm `ur55`") && said.contains("help: did you mean `ur5`?"), "{said}");
    }
}
