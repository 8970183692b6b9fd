//! Puts the memory map where the linker finds it, for every program that depends on this crate.

use std::{env, fs, io, path::Path};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=memory.x");
    let directory = env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?;
    fs::copy("memory.x", Path::new(&directory).join("memory.x"))?;
    println!("cargo:rustc-link-search={}", Path::new(&directory).display());
    Ok(())
}
