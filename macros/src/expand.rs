//! The expansion: read the attribute, call the generator, put each error in its place.

use std::path::Path;

use denhart_codegen::{Bound, Diagnostic, Generated, Options, ScalarKind};
use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::{Data, DeriveInput, Error, LitStr};

use crate::attribute::{ArmAttribute, Source};
use crate::fallback::{self, Outline};
use crate::fields;
use crate::renamed;

/// Name of an arm file given as `yaml = "..."`, for messages.
const INLINE: &str = "<inline>";

/// The impls of the arm; or the errors, and impls in which every call of a function of an arm type-checks.
/// `package`: the directory that relative paths start from.
pub fn expand(input: &DeriveInput, package: Option<&Path>) -> TokenStream {
    let mut errors = Vec::new();
    let mut attribute = ArmAttribute::read(&input.attrs, &mut errors);
    check_shape(input, &mut errors);
    if !attribute.names_crate
        && let Some(name) = renamed::name(package)
    {
        errors.push(renamed::mistake(&name));
        // The impls are those of a right attribute: no error follows from a crate that is not there.
        if let Ok(path) = syn::parse_str(&format!("::{name}")) {
            attribute.crate_path = path;
        }
    }
    let mut outline = Outline::default();
    let arm = attribute.source.as_ref().map(|source| read(source, package)).transpose();
    let arm = arm.map_err(|error| errors.push(error)).unwrap_or(None);
    let text = arm.as_ref().map(|arm| (arm.text.as_str(), arm.file.as_str()));
    let before = errors.len();
    let bound = bound(input, text, attribute.scalar, &mut errors);
    let fields_fit = errors.len() == before;
    let generated = arm.and_then(|arm| {
        outline = Outline::of(&arm.text);
        generate(input, &attribute, bound, &arm).map_err(|error| errors.push(error)).ok()
    });
    let rebuild = attribute.source.as_ref().and_then(|source| rebuild_on_change(source, package));
    // Impls for a generic type would need its parameters, and those for fields that are wrong would repeat it: the stub
    // does neither.
    let impls = match generated {
        Some(impls) if input.generics.params.is_empty() && fields_fit => impls,
        _ => fallback::stub(input, &outline, &attribute.crate_path, attribute.scalar),
    };
    let errors = errors.iter().map(Error::to_compile_error);
    // Cargo builds again when these change.
    let environment = attribute.environment.iter().map(|name| {
        quote! { const _: ::core::option::Option<&::core::primitive::str> = ::core::option_env!(#name); }
    });
    quote! { #(#errors)* #rebuild #(#environment)* #impls }
}

/// The text of the arm file, its name in messages, and the literal in the attribute that messages point at.
struct ArmText<'a> {
    text: String,
    file: String,
    at: &'a LitStr,
}

fn read<'a>(source: &'a Source, package: Option<&Path>) -> Result<ArmText<'a>, Error> {
    match source {
        Source::Inline(at) => Ok(ArmText { text: at.value(), file: INLINE.to_owned(), at }),
        Source::File(at) => {
            let file = at.value();
            let package = package.ok_or_else(|| {
                let text = "CARGO_MANIFEST_DIR is not set, so there is no directory for the path to start from\nhelp: \
                            build with cargo, or give the arm as `yaml = \"...\"`";
                Error::new(at.span(), text)
            })?;
            let text =
                denhart_codegen::read_file(package, Path::new(&file)).map_err(|error| Error::new(at.span(), error))?;
            Ok(ArmText { text, file, at })
        }
    }
}

fn generate(
    input: &DeriveInput,
    attribute: &ArmAttribute,
    bound: Bound,
    arm: &ArmText<'_>,
) -> Result<TokenStream, Error> {
    let options = Options {
        type_name: input.ident.to_string(),
        scalar: attribute.scalar,
        crate_path: attribute.crate_path.clone(),
        bound,
        batch: attribute.batch,
    };
    let Generated { impls, warnings, .. } = denhart_codegen::generate(&arm.text, &arm.file, &options)
        .map_err(|errors| Error::new(arm.at.span(), errors))?;
    let advice = warnings.iter().filter(|_| attribute.warn).map(|advice| warning(advice, arm.at.span()));
    Ok(quote! { #impls #(#advice)* })
}

/// A derive cannot warn on stable Rust, but the use of a deprecated item can.
fn warning(advice: &Diagnostic, at: Span) -> TokenStream {
    let note = advice.to_string();
    let usage = quote_spanned!(at=> ADVICE);
    quote! {
        const _: () = {
            #[deprecated(note = #note)]
            const ADVICE: () = ();
            #usage
        };
    }
}

/// A constant that holds the file: cargo builds again when the file changes. Nothing where the file is missing, as
/// that has its own error.
fn rebuild_on_change(source: &Source, package: Option<&Path>) -> Option<TokenStream> {
    let Source::File(path) = source else { return None };
    let written = path.value();
    if !package?.join(&written).is_file() {
        return None;
    }
    let path = if Path::new(&written).is_absolute() {
        quote! { #written }
    } else {
        quote! { ::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #written) }
    };
    Some(quote! { const _: &[::core::primitive::u8] = ::core::include_bytes!(#path); })
}

/// An arm is a struct without generic parameters.
fn check_shape(input: &DeriveInput, errors: &mut Vec<Error>) {
    let name = &input.ident;
    let as_struct = format!("help: write `struct {name};`");
    match &input.data {
        Data::Struct(_) => {}
        Data::Enum(data) => {
            errors.push(Error::new(data.enum_token.span, format!("an arm is a struct, not an enum\n{as_struct}")));
        }
        Data::Union(data) => {
            errors.push(Error::new(data.union_token.span, format!("an arm is a struct, not a union\n{as_struct}")));
        }
    }
    if !input.generics.params.is_empty() {
        let text = format!("an arm is one type: it has no parameters\n{as_struct}");
        errors.push(Error::new_spanned(&input.generics, text));
    }
}

/// The parameters bound by the fields of the struct; an enum or a union is wrong already.
fn bound(input: &DeriveInput, text: Option<(&str, &str)>, scalar: ScalarKind, errors: &mut Vec<Error>) -> Bound {
    match &input.data {
        Data::Struct(data) => fields::bound(&data.fields, &input.ident, text, scalar, errors),
        Data::Enum(_) | Data::Union(_) => Bound::None,
    }
}
