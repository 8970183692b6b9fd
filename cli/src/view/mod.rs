//! `denhart view`: an arm in the browser, with the generator itself in the page.

mod browser;
mod http;
mod page;
mod server;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use crate::Failure;
use crate::files;
use page::{Given, page};
use server::Served;

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// Write the page with the arm to this file instead: it works without a server and without a network
    #[arg(long, value_name = "FILE", conflicts_with_all = ["write", "no_open"])]
    export: Option<PathBuf>,
    /// Overwrite the file of --export if it is there
    #[arg(long, requires = "export")]
    force: bool,
    /// Let the page write the arm file
    #[arg(long)]
    write: bool,
    /// Print the address alone, and open no browser
    #[arg(long)]
    no_open: bool,
}

/// Serves the page until the command is ended, or writes it.
///
/// # Errors
/// A file that cannot be read or written; no free port, no connection.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let (text, name) = crate::arm::text(&options.file).map_err(Failure::Other)?;
    if let Some(path) = &options.export {
        let html = page(&Given { text: &text, name: &name, follow: false, write: false });
        files::write(&[(path.as_path(), html.as_str())], options.force).map_err(Failure::Other)?;
        return Ok(writeln!(out, "wrote {}", path.display())?);
    }
    // A text from the standard input does not change.
    let file = Some(&options.file).filter(|file| file.as_os_str() != "-");
    if options.write && file.is_none() {
        return Err(Failure::Usage("--write needs a file to write\nhelp: name the arm file instead of `-`".to_owned()));
    }
    let served = Served::new(file.map(|file| Path::new(file).to_path_buf()), text, name, options.write);
    let (listener, address) = server::open(&served).map_err(Failure::Other)?;
    writeln!(out, "{address}\nEnd with Ctrl+C.")?;
    out.flush()?;
    if !options.no_open {
        browser::open(&address);
    }
    server::serve(&listener, &served).map_err(Failure::Other)
}
