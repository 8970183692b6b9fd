//! Constant angles in generated code.

use super::Target;
use super::tokens::{ident, number};
use crate::model::Angle;
use crate::settings::short;
use proc_macro2::{Ident, TokenStream};
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

/// A constant angle added to another one, in the text of a doc comment: `+ 90 deg`, `- 2.5 deg`.
pub fn addend(angle: Angle) -> String {
    let degrees = angle.rad().to_degrees();
    let sign = if degrees < 0.0 { '-' } else { '+' };
    format!("{sign} {} deg", short(degrees.abs()))
}

/// A sum of `(name, negative)` and a constant.
pub fn sum(terms: impl IntoIterator<Item = (Ident, bool)>, constant: Angle, target: &Target) -> TokenStream {
    let mut sum = TokenStream::new();
    for (term, negative) in terms {
        sum.extend(match (sum.is_empty(), negative) {
            (true, false) => quote!(#term),
            (_, false) => quote!(+ #term),
            (_, true) => quote!(- #term),
        });
    }
    if !constant.is_zero() {
        let negative = constant.rad() < 0.0;
        let size = tokens(if negative { constant.neg() } else { constant }, target);
        sum.extend(if negative { quote!(- #size) } else { quote!(+ #size) });
    }
    sum
}

/// Sines and cosines of angles in one call: the kernel works on several angles in parallel.
pub fn sines(sines: &[TokenStream], cosines: &[TokenStream], of: &[TokenStream], target: &Target) -> TokenStream {
    let krate = &target.krate;
    match of {
        [] => TokenStream::new(),
        [one] => quote!(let (#(#sines),*, #(#cosines),*) = #krate::math::sin_cos(#one);),
        _ => quote!(let ([#(#sines),*], [#(#cosines),*]) = #krate::math::sin_cos_array([#(#of),*]);),
    }
}

#[cfg(test)]
mod tests {
    use super::{Angle, addend};

    #[test]
    fn an_addend_has_the_digits_it_needs() {
        let cases = [(90.0, "+ 90 deg"), (-90.0, "- 90 deg"), (-2.446_529_785, "- 2.44653 deg"), (0.1, "+ 0.1 deg")];
        for (degrees, text) in cases {
            assert_eq!(addend(Angle::degrees(degrees)), text);
        }
    }
}
