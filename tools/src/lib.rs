//! Tools for arm files as a library: text in, text or data out.
//!
//! The command `denhart` calls them, and so can a page in a browser or a program in another language. Nothing here reads or
//! writes files or asks the system, so that the crate compiles to WebAssembly.
//!
//! - [`check`](mod@check): the findings of the generator in an arm file, or the mistakes in it, as text and as data.
//! - [`closest`](mod@closest): the closest approach of an arm to a target out of reach.
//! - [`export`]: the arm as a library for C, as files.
//! - [`follow`](mod@follow): joint values over time that bring the tool along a path of poses.
//! - [`import`]: an arm file from a URDF, from the calibration of a UR arm, or from OPW parameters.
//! - [`presets`]: known arms, with their files.
//! - [`schema`]: the JSON schema of arm files, for editors.
//! - [`times`]: equally spaced times.
//!
//! ```
//! use denhart_tools::import::{self, Options};
//!
//! # fn main() -> Result<(), denhart_tools::Error> {
//! let urdf = r#"
//! <robot name="elbow">
//!   <link name="base"/> <link name="upper"/> <link name="lower"/>
//!   <joint name="shoulder" type="revolute">
//!     <parent link="base"/> <child link="upper"/> <axis xyz="0 0 1"/> <limit lower="-2" upper="2"/>
//!   </joint>
//!   <joint name="elbow" type="continuous">
//!     <parent link="upper"/> <child link="lower"/> <origin xyz="0.3 0 0"/> <axis xyz="0 0 1"/>
//!   </joint>
//! </robot>"#;
//! let imported = import::urdf(urdf, &Options::default())?;
//! assert!(imported.arm_file.contains("name: elbow, a: 0, alpha: 0, d: 0, theta: 0"), "{}", imported.arm_file);
//! # Ok(())
//! # }
//! ```
//!
//! A message that proposes an option spells it as the command does: `--tool LINK` is the field `tool` of the options.

mod arm;
pub mod check;
pub mod closest;
mod error;
pub mod export;
pub mod follow;
pub mod import;
pub mod presets;
pub mod schema;
pub mod times;
mod units;

pub use arm::{Arm, chain};
pub use error::Error;
pub use units::Units;
