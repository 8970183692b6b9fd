//! Generates every arm of `specs/` and of `arms/`, in either scalar, and the calls of all its functions.

use std::path::Path;
use std::{env, fs};

use firmware_generate::{Error, Scalar, all_arms, folders, write};

fn main() -> Result<(), Error> {
    for folder in folders() {
        println!("cargo:rerun-if-changed={}", folder.display());
    }
    let names = all_arms()?;
    let directory = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?;
    for scalar in [Scalar::F32, Scalar::F64] {
        let arms: Vec<_> = names.iter().map(|name| (name.as_str(), scalar)).collect();
        write(&format!("{scalar}.rs"), &arms)?;
        let calls: String = names
            .iter()
            .map(|name| {
                format!("arms::{name}_{scalar}::call::every(black_box(&arms::{name}_{scalar}::Case::BLANK));\n")
            })
            .collect();
        fs::write(Path::new(&directory).join(format!("{scalar}_calls.rs")), format!("{{\n{calls}}}"))?;
    }
    Ok(())
}
