//! `#[derive(Arm)]`: a robot arm's kinematics from its table, at compile time.
//!
//! Use it through the crate `denhart`, which re-exports it beside the trait of the same name.

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

mod attribute;
mod expand;
mod fallback;
mod fields;
mod renamed;
mod stub_motors;
#[cfg(test)]
mod tests;
mod text;

/// Implements the kinematics of the arm in `#[arm(..)]` for a struct, and the trait `denhart::Arm`.
///
/// The methods are `forward`, `link_poses`, `jacobian`, `forward_and_jacobian`. Where the arm has a closed form, there are
/// `inverse`, `inverse_near`, `inverse_branch`, and `inverse_into`, `inverse_near_into` for a list that the caller keeps.
/// The constants are `DOF`, `LIMITS`, `MAX_VELOCITY`, `MAX_ACCELERATION`, `JOINT_NAMES`, `LENGTH_UNIT`, `DH`, `MAX_SOLUTIONS`.
///
/// ```text
/// use denhart::Arm;
///
/// #[derive(Arm)]
/// #[arm(spec = "specs/ur5.yaml")]
/// struct Ur5;
///
/// let tool = Ur5.forward(&[0.0; 6]);
/// ```
///
/// # Fields
/// A field binds the parameter of its name in the file's `parameters` at run time. A parameter without a field is its
/// value in the file, a constant of the code. A struct with fields has `nominal()`, the arm with the file's values, and
/// `dh_rows()`, `dh_base()` and `dh_tool()`, its table as it is bound.
///
/// ```text
/// #[derive(Arm)]
/// #[arm(spec = "specs/planar.yaml")] // parameters: {l2: 0.425, l3: 0.392}
/// struct Planar {
///     l2: f64,
///     l3: f64,
/// }
/// ```
///
/// # `#[arm(..)]`
/// - `spec = "specs/ur5.yaml"`: the arm file, relative to the directory of the package's `Cargo.toml`. Editing it
///   rebuilds. `concat!` and `env!` of texts are read too: `spec = concat!(env!("OUT_DIR"), "/arm.yaml")`.
/// - `yaml = "..."`: the text of an arm file in its place. Messages call it `<inline>` and count lines inside the
///   string.
/// - `scalar = "f32"`: the number type; `"f64"` if left out.
/// - `crate = "path"`: where the crate `denhart` is, if it is renamed or re-exported; `"::denhart"` if left out.
/// - `batch`: the functions over lanes, too, for `denhart::batch`; needs the feature `batch` of `denhart`.
/// - `warn`: show the generator's advice on the arm file, as warnings of a deprecated item.
///
/// Every mistake in the file is an error at the path, which gives `file:line:column` and what to write.
#[proc_macro_derive(Arm, attributes(arm))]
pub fn derive_arm(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    let package = std::env::var_os("CARGO_MANIFEST_DIR");
    expand::expand(&input, package.as_deref().map(std::path::Path::new)).into()
}
