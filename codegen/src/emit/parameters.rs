//! Run-time parameters: the fields of the struct, and what is computed from them outside the kinematics.

use super::tables::{dh_frame, dh_row};
use super::tokens::{array, ident, integer, number};
use super::{Target, docs, worked_out};
use crate::model::{Length, Model, Parameter, ReachTerm, reach_terms};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashMap;

/// The struct of a written file: a field for each run-time parameter.
pub fn item(model: &Model, doc: &TokenStream, target: &Target) -> TokenStream {
    let (name, scalar) = (&target.type_name, target.scalar.tokens());
    if model.parameters.is_empty() {
        return quote! {
            #doc
            #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
            pub struct #name;
        };
    }
    let fields = model.parameters.iter().map(|parameter| {
        let text = format!(
            "{}, {}; {} in the arm file.",
            uses(model, parameter),
            model.length_unit.symbol(),
            parameter.default
        );
        let (doc, field) = (docs::lines(&text), ident(&parameter.name));
        quote!(#doc pub #field: #scalar)
    });
    // A field has the name in the file, whatever its case.
    let cased = model.parameters.iter().any(|parameter| parameter.name.to_lowercase() != parameter.name);
    let case = cased.then(|| quote!(#[allow(non_snake_case, reason = "the names of the arm file")]));
    quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq)]
        #case
        pub struct #name {
            #(#fields),*
        }

        /// The arm with the parameters at the values of its file.
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::nominal()
            }
        }
    }
}

/// `a` of row 2, twice `d` of row 3.
fn uses(model: &Model, parameter: &Parameter) -> String {
    let mut uses = Vec::new();
    let mut note = |length: &Length, place: String| {
        if let Length::Multiple { factor, parameter: name, .. } = length
            && *name == parameter.name
        {
            let factor = if *factor == 1.0 { String::new() } else { format!(" times {factor}") };
            uses.push(format!("{place}{factor}"));
        }
    };
    for (row, number) in model.rows.iter().zip(1..) {
        note(&row.a, format!("`a` of row {number}"));
        note(&row.d, format!("`d` of row {number}"));
    }
    for (frame, what) in [(&model.base, "base"), (&model.tool, "tool")] {
        for (length, axis) in frame.xyz.iter().zip(["x", "y", "z"]) {
            note(length, format!("`{axis}` of the {what}"));
        }
    }
    let text = if uses.is_empty() { "not used".to_owned() } else { uses.join(", ") };
    format!("Parameter `{}`: {text}", parameter.name)
}

/// The arm with the file's values, and its table as it is bound.
pub fn methods(model: &Model, target: &Target) -> TokenStream {
    if model.parameters.is_empty() {
        return TokenStream::new();
    }
    let krate = &target.krate;
    let values = model.parameters.iter().map(|parameter| {
        let (field, value) = (ident(&parameter.name), number(parameter.default));
        quote!(#field: #value)
    });
    let length = |length: &Length| value(length, target);
    let rows = array(model.rows.iter().map(|row| dh_row(row, length, target)));
    let [base, tool] = [&model.base, &model.tool].map(|frame| dh_frame(frame, length, target));
    let count = integer(model.rows.len());
    let symbol = model.length_unit.symbol();
    let rows_doc = docs::lines(&format!(
        "The rows of the Denavit-Hartenberg table with the parameters of this arm, `[{count}]`; lengths in {symbol}, \
         angles in rad. With `dh_base` and `dh_tool` they make a `Chain`; the constant `DH` has the file's values."
    ));
    quote! {
        /// The arm with the parameters at the values of its file.
        #[must_use]
        pub const fn nominal() -> Self {
            Self { #(#values),* }
        }

        #rows_doc
        #[must_use]
        pub fn dh_rows(&self) -> [#krate::DhRow; #count] {
            #rows
        }

        /// The constant frame before the first row, with the parameters of this arm.
        #[must_use]
        pub fn dh_base(&self) -> #krate::DhFrame {
            #base
        }

        /// The constant frame after the last row, with the parameters of this arm.
        #[must_use]
        pub fn dh_tool(&self) -> #krate::DhFrame {
            #tool
        }
    }
}

/// A length as an f64 in a method.
fn value(length: &Length, target: &Target) -> TokenStream {
    match length {
        Length::Constant(value) => number(*value),
        Length::Multiple { factor, parameter, .. } => {
            let field = ident(parameter);
            let field = match target.scalar {
                super::Scalar::F64 => quote!(self.#field),
                super::Scalar::F32 => quote!(::core::primitive::f64::from(self.#field)),
            };
            multiple(*factor, &field)
        }
    }
}

/// The reach of the arm as it is bound: what `REACH` is where all lengths are numbers.
pub fn reach(model: &Model, target: &Target) -> TokenStream {
    let (krate, scalar, name) = (&target.krate, target.scalar.tokens(), &target.type_name);
    let mut constant = 0.0;
    let mut parts: Vec<TokenStream> = Vec::new();
    let size = |length: &Length| {
        let Length::Multiple { factor, parameter, .. } = length else { return None };
        let field = ident(parameter);
        Some(multiple(factor.abs(), &quote!(arm.#field.abs())))
    };
    let mut terms: Vec<ReachTerm> = reach_terms(model).collect();
    terms.sort_by_key(|term| !matches!(term, ReachTerm::Displacements(_)));
    for term in terms {
        let lengths = match &term {
            ReachTerm::Displacements(_) => Vec::new(),
            ReachTerm::Row(lengths) => lengths.to_vec(),
            ReachTerm::Frame(xyz) => xyz.iter().filter(|length| !length.is_zero()).collect(),
        };
        match (&term, lengths.as_slice()) {
            (ReachTerm::Row(_), lengths) => {
                for length in lengths {
                    match size(length) {
                        Some(part) => parts.push(part),
                        None => constant += length.default_value().abs(),
                    }
                }
            }
            (_, lengths) if lengths.iter().all(|length| length.parameter().is_none()) => {
                constant += term.at(&HashMap::new());
            }
            (_, [one]) => parts.extend(size(one)),
            (_, lengths) => {
                let squares = lengths.iter().map(|length| {
                    let size = size(length).unwrap_or_else(|| number(length.default_value().abs()));
                    quote!(#size * #size)
                });
                parts.push(quote!(#krate::math::sqrt(#(#squares)+*)));
            }
        }
    }
    if constant > 0.0 || parts.is_empty() {
        parts.push(number(constant));
    }
    let unit = model.length_unit.symbol();
    let doc = format!(" Reach of the arm as it is bound, {unit}; 1 without any length.");
    quote! {
        #[doc = #doc]
        fn reach(arm: &#name) -> #scalar {
            let reach = #(#parts)+*;
            if reach == 0.0 { 1.0 } else { reach }
        }
    }
}

/// The size of the arm as it is bound, and what follows from it: `length`, `constants`.
pub fn sizes(model: &Model, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let tolerance = worked_out::bound_tolerance(model);
    quote! {
        let reach = reach(arm);
        let ::core::option::Option::Some(constants) = CONSTANTS.with_reach(reach, #tolerance) else {
            return;
        };
        let length = #krate::solve::Measure::length(constants.reach);
    }
}

/// A factor of 1 is not written.
fn multiple(factor: f64, of: &TokenStream) -> TokenStream {
    if factor == 1.0 {
        return of.clone();
    }
    if factor == -1.0 {
        return quote!(-#of);
    }
    let factor = number(factor);
    quote!(#factor * #of)
}
