//! Generated code: names, expressions as statements, one file per generated function, doc text.

mod actuator;
mod angle;
mod arm;
#[cfg(feature = "batch")]
mod batch;
mod combined_limits;
mod constants;
mod coupling;
mod docs;
mod given;
mod held_joint;
mod inverse;
mod inverse_frame;
mod kernel;
mod kinematics;
#[cfg(feature = "file")]
mod legend;
mod margins;
mod motion;
mod nest;
mod parameters;
mod paths;
mod solver_constants;
mod tables;
mod target_at;
mod task;
mod tokens;
mod worked_out;

pub use arm::{Arm, impls, item};
#[cfg(feature = "file")]
pub use legend::legend;
pub(crate) use tokens::Writer;

use proc_macro2::TokenStream;
use quote::quote;
use std::fmt;

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

/// A name of a number type that is neither `f64` nor `f32`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownScalar {
    written: String,
}

impl fmt::Display for UnknownScalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown scalar `{}`\nhelp: write `f64` or `f32`", self.written)
    }
}

impl std::error::Error for UnknownScalar {}

impl TryFrom<&str> for Scalar {
    type Error = UnknownScalar;

    fn try_from(name: &str) -> Result<Self, Self::Error> {
        match name {
            "f64" => Ok(Self::F64),
            "f32" => Ok(Self::F32),
            _ => Err(UnknownScalar { written: name.to_owned() }),
        }
    }
}

/// The settings that every generated function reads.
#[derive(Clone)]
pub struct Target {
    /// The scalar type.
    pub scalar: Scalar,
    /// Path of the runtime crate.
    pub krate: TokenStream,
    /// Name of the user's type.
    pub type_name: proc_macro2::Ident,
}
