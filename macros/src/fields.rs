//! The fields of the struct: each binds the run-time parameter of its name.

use denhart_codegen::spec::{nearest, read};
use denhart_codegen::{Bound, ScalarKind};
use syn::{Error, Field, Fields, Ident, Type};

/// Types of numbers and texts that are no scalar of the generated code, whatever else is imported.
const OTHER: &[&str] = &[
    "f16", "f128", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64", "u128", "usize", "bool",
    "char", "str", "String",
];

/// The parameters that the fields bind. What is wrong with a field goes to `errors`; `text` is the arm file, if it can
/// be read at all.
pub fn bound(
    fields: &Fields,
    name: &Ident,
    text: Option<(&str, &str)>,
    scalar: ScalarKind,
    errors: &mut Vec<Error>,
) -> Bound {
    let parameters = text.and_then(|(text, file)| read(text, file).ok()).map(|(spec, _)| spec.parameters);
    let parameters: Option<Vec<String>> =
        parameters.map(|parameters| parameters.into_iter().map(|parameter| parameter.name).collect());
    let mut bound = Vec::new();
    for field in fields {
        let Some(ident) = &field.ident else {
            let text = "a field binds the run-time parameter of its name, and this field has no name";
            let help = named(parameters.as_deref().unwrap_or_default(), name, scalar);
            errors.push(Error::new_spanned(&field.ty, format!("{text}\n{help}")));
            continue;
        };
        let field_name = ident.to_string();
        // Of a file that is no YAML nothing is known of its parameters: that mistake is the one to tell.
        if let Some(known) = &parameters
            && !known.contains(&field_name)
        {
            let text = "a field binds the run-time parameter of its name, and the arm file has no parameter";
            let meant = nearest(&field_name, known.iter().map(String::as_str));
            let help = match meant {
                Some(word) => format!("help: did you mean `{word}`? the parameters are {}", known.join(", ")),
                None => named(known, name, scalar),
            };
            errors.push(Error::new(ident.span(), format!("{text} `{field_name}`\n{help}")));
            continue;
        }
        errors.extend(wrong_type(field, &field_name, scalar));
        bound.push(field_name);
    }
    if bound.is_empty() { Bound::None } else { Bound::Fields(bound) }
}

/// How the struct is written instead.
fn named(parameters: &[String], name: &Ident, scalar: ScalarKind) -> String {
    if parameters.is_empty() {
        return format!("help: write `struct {name};`");
    }
    let scalar = word(scalar);
    let fields: Vec<String> = parameters.iter().map(|parameter| format!("{parameter}: {scalar}")).collect();
    format!("help: write `struct {name} {{ {} }}`, or fewer fields, or `struct {name};`", fields.join(", "))
}

fn word(scalar: ScalarKind) -> &'static str {
    match scalar {
        ScalarKind::F64 => "f64",
        ScalarKind::F32 => "f32",
    }
}

/// A type that is not the scalar, as far as its tokens tell: of an alias rustc judges.
fn wrong_type(field: &Field, name: &str, scalar: ScalarKind) -> Option<Error> {
    let expected = word(scalar);
    let last = match &field.ty {
        Type::Path(path) => path.path.segments.last(),
        _ => None,
    };
    let plain = last.filter(|segment| segment.arguments.is_none()).map(|segment| segment.ident.to_string());
    let other_float = if expected == "f64" { "f32" } else { "f64" };
    let wrong = plain.is_none_or(|word| word == other_float || OTHER.contains(&word.as_str()));
    let mut help = format!("help: write `{name}: {expected}`");
    if let Some(kind) = match &field.ty {
        Type::Path(path) if path.path.is_ident("f32") => Some("f32"),
        Type::Path(path) if path.path.is_ident("f64") => Some("f64"),
        _ => None,
    } {
        help += &format!(", or `scalar = \"{kind}\"` in #[arm(..)]");
    }
    let text = format!("the parameter `{name}` is of the arm's scalar type, {expected}\n{help}");
    wrong.then(|| Error::new_spanned(&field.ty, text))
}
