//! Generated code: names, expressions as statements, one file per generated function, doc text.

mod actuator;
mod angle;
mod arm;
mod combined_limits;
mod constants;
mod coupling;
mod docs;
mod inverse;
mod inverse_frame;
mod kernel;
mod kinematics;
mod legend;
mod margins;
mod motion;
mod parameters;
mod paths;
mod tables;
mod task;
mod tokens;
mod worked_out;

pub use arm::{Arm, impls, item};
pub use legend::legend;
pub(crate) use tokens::Writer;

use proc_macro2::TokenStream;
use quote::quote;

/// The scalar type of the generated code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scalar {
    /// `f64`
    #[default]
    F64,
    /// `f32`
    F32,
}

impl Scalar {
    /// The type.
    pub fn tokens(self) -> TokenStream {
        match self {
            Scalar::F64 => quote!(f64),
            Scalar::F32 => quote!(f32),
        }
    }
}

/// What every generated function needs to know.
#[derive(Clone)]
pub struct Target {
    /// The scalar type.
    pub scalar: Scalar,
    /// Path of the runtime crate.
    pub krate: TokenStream,
    /// Name of the user's type.
    pub type_name: proc_macro2::Ident,
}
