//! Writes the list of presets: the arm files of the repository.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").canonicalize()?;
    println!("cargo:rerun-if-changed={}", specs.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(&specs)? {
        let path = entry?.path();
        if let (Some(name), Some("yaml")) =
            (path.file_stem().and_then(|name| name.to_str()), path.extension().and_then(|kind| kind.to_str()))
        {
            names.push(name.to_owned());
        }
    }
    names.sort();
    let mut list = String::from("[\n");
    for name in names {
        let path = specs.join(format!("{name}.yaml"));
        // Writing to a text cannot fail.
        let _ = writeln!(list, "    ({name:?}, include_str!({:?})),", path.display().to_string());
    }
    list.push_str("]\n");
    let out = env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?;
    fs::write(Path::new(&out).join("presets.rs"), list)
}
