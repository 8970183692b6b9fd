//! Puts the memory map where the linker finds it, for every program that depends on this crate.

use std::{env, fs, io, path::Path};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=memory.x");
    let directory = env::var_os("OUT_DIR").ok_or(io::ErrorKind::NotFound)?;
    let mut map = fs::read_to_string("memory.x")?;
    if env::var_os("CARGO_FEATURE_LINKED_ONLY").is_some() {
        map = map.replace("LENGTH = 4M", "LENGTH = 64M");
    }
    fs::write(Path::new(&directory).join("memory.x"), map)?;
    println!("cargo:rustc-link-search={}", Path::new(&directory).display());
    Ok(())
}
