//! Generates the arms that are measured, and with the feature `extra` one more.

use std::path::Path;
use std::{env, fs};

use firmware_generate::{Error, Scalar, write};

fn main() -> Result<(), Error> {
    let arms = [
        ("puma560", Scalar::F32),
        ("ur5", Scalar::F32),
        ("abb_irb2400", Scalar::F32),
        ("stanford", Scalar::F32),
        ("kuka_iiwa7_r800", Scalar::F32),
        ("jupiter", Scalar::F32),
        ("salman_rrr", Scalar::F32),
        ("ur5_measured", Scalar::F32),
        ("puma560", Scalar::F64),
    ];
    write("arms.rs", &arms)?;
    println!("cargo:rerun-if-env-changed=DENHART_FIRMWARE_ARM");
    if env::var_os("CARGO_FEATURE_EXTRA").is_none() {
        return Ok(());
    }
    let arm = env::var("DENHART_FIRMWARE_ARM")?;
    write("extra.rs", &[(&arm, Scalar::F32)])?;
    let file = Path::new(&env::var("OUT_DIR")?).join("extra.rs");
    let module = fs::read_to_string(&file)?;
    fs::write(file, format!("{module}pub use {arm}_f32::*;\n"))?;
    Ok(())
}
