//! `denhart completions` and `denhart man`: what a shell and `man` know of the command.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use clap::{Args, Command};
use clap_complete::Shell;

use crate::Failure;

/// The arguments of `completions`.
#[derive(Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// The arguments of `man`.
#[derive(Args)]
pub struct Man {
    /// Write a page for the command and one for each subcommand to this directory
    #[arg(long, short, value_name = "DIRECTORY")]
    output: Option<PathBuf>,
}

/// Prints the completions.
pub fn completions(options: &Completions, mut command: Command, out: &mut dyn Write) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(options.shell, &mut command, "denhart", &mut text);
    Ok(out.write_all(&text)?)
}

/// Prints the manual page, or writes all of them.
pub fn man(options: &Man, command: Command, out: &mut dyn Write) -> Result<(), Failure> {
    let Some(directory) = &options.output else {
        let mut text = Vec::new();
        clap_mangen::Man::new(command).render(&mut text)?;
        return Ok(out.write_all(&text)?);
    };
    let cannot = |error: std::io::Error| Failure::Other(format!("cannot write to `{}`: {error}", directory.display()));
    fs::create_dir_all(directory).map_err(cannot)?;
    clap_mangen::generate_to(command, directory).map_err(cannot)
}
