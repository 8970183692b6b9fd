//! Limits of sums of joint values: the constant, and their place in the search.

use super::Target;
use super::docs;
use super::tables::limit;
use super::tokens::{integer, number};
use crate::model::Model;
use proc_macro2::TokenStream;
use quote::quote;

/// `COMBINED_LIMITS`; nothing for an arm without any.
pub fn constant(model: &Model, target: &Target) -> TokenStream {
    if model.combined_limits.is_empty() {
        return TokenStream::new();
    }
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let count = integer(model.combined_limits.len());
    let entries = model.combined_limits.iter().map(|combined| {
        let factors = combined.factors.iter().map(|factor| number(*factor));
        let [low, high] = combined.limits.map(|end| limit(end, &scalar));
        quote!(#krate::CombinedLimit { factors: [#(#factors),*], limits: [#low, #high] })
    });
    let unit = model.length_unit.symbol();
    let doc = docs::lines(&format!(
        "Limits of sums of joint values, rad (of sliding joints {unit}). A solution outside one of them is out of \
         limits.\n\nThe sums are of the joint values as returned: in (-pi, pi] by `inverse`, unwound by \
         `inverse_near`."
    ));
    quote! {
        #doc
        pub const COMBINED_LIMITS: [#krate::CombinedLimit<#scalar, #n>; #count] = [#(#entries),*];
    }
}

/// The constant as a slice.
pub fn reference(model: &Model, target: &Target) -> TokenStream {
    let name = &target.type_name;
    if model.combined_limits.is_empty() { quote!(&[]) } else { quote!(&#name::COMBINED_LIMITS) }
}
