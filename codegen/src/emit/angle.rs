//! Constant angles in generated code.

use super::Target;
use super::tokens::{ident, number};
use crate::model::Angle;
use proc_macro2::TokenStream;
use quote::quote;

/// An angle in rad: a constant of `core` where there is one, else a literal.
pub fn tokens(angle: Angle, target: &Target) -> TokenStream {
    let scalar = target.scalar.tokens();
    let named = |name: &str| {
        let name = ident(name);
        quote!(::core::#scalar::consts::#name)
    };
    let positive = match angle.exact_twelfths().map(i64::abs) {
        Some(0) => quote!(0.0),
        Some(12) => named("PI"),
        Some(6) => named("FRAC_PI_2"),
        Some(4) => named("FRAC_PI_3"),
        Some(3) => named("FRAC_PI_4"),
        Some(2) => named("FRAC_PI_6"),
        _ => number(angle.rad().abs()),
    };
    if angle.rad() < 0.0 { quote!(-#positive) } else { positive }
}
