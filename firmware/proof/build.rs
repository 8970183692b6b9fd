//! Generates every arm of `specs/`, in either scalar, and the calls of all its functions.

use std::path::Path;
use std::{env, fs};

use firmware_generate::{Error, Scalar, all_arms, specs, write};

fn main() -> Result<(), Error> {
    println!("cargo:rerun-if-changed={}", specs().display());
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
