//! Generates every arm of `specs/`, in either scalar, and the calls of all its functions. In `f64` the arms whose inverse
//! holds a joint are left out: the optimizer keeps checks of indices that cannot fail in their solvers.

use std::path::Path;
use std::{env, fs};

use firmware_generate::{Error, Scalar, all_arms, holds_a_joint, specs, write};

fn main() -> Result<(), Error> {
    println!("cargo:rerun-if-changed={}", specs().display());
    let all = all_arms()?;
    let mut closed_forms = Vec::new();
    for name in &all {
        if !holds_a_joint(name)? {
            closed_forms.push(name.clone());
        }
    }
    let directory = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?;
    for (scalar, names) in [(Scalar::F32, &all), (Scalar::F64, &closed_forms)] {
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
