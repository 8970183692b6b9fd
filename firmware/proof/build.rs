//! Generates every arm of `specs/` and of `arms/`, in either scalar, and the calls of all its functions.

use std::path::Path;
use std::{env, fs};

use firmware_generate::{Error, Scalar, all_arms, folders, write};

/// The arms whose followers are linked too: a pose, of six and of five joints and with one given, and a point. A follower is
/// compiled for each arm, and takes as long to link as the arm's own functions.
const WITH_FOLLOWERS: [&str; 4] = ["kuka_iiwa7_r800", "salman_rrr", "scorbot_er5", "ur5"];

fn main() -> Result<(), Error> {
    for folder in folders() {
        println!("cargo:rerun-if-changed={}", folder.display());
    }
    let names = all_arms()?;
    let directory = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?;
    for scalar in [Scalar::F32, Scalar::F64] {
        let arms: Vec<_> = names.iter().map(|name| (name.as_str(), scalar)).collect();
        write(&format!("{scalar}.rs"), &arms)?;
        let call = |function: &str, name: &str| {
            format!("arms::{name}_{scalar}::call::{function}(black_box(&arms::{name}_{scalar}::Case::BLANK));\n")
        };
        let every = names.iter().map(|name| call("every", name));
        let calls: String = every.chain(WITH_FOLLOWERS.iter().map(|name| call("followers", name))).collect();
        fs::write(Path::new(&directory).join(format!("{scalar}_calls.rs")), format!("{{\n{calls}}}"))?;
    }
    Ok(())
}
