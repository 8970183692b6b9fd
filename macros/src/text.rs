//! The text of a value in `#[arm(..)]`: a literal, or `concat!` and `env!` of literals, whose value a macro can know.

use quote::ToTokens;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Error, Expr, ExprMacro, Lit, LitStr, Token};

/// The text, and the environment variables it depends on.
pub fn text(key: &str, value: &Expr, environment: &mut Vec<String>) -> Result<LitStr, Error> {
    match value {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Str(text) => Ok(text.clone()),
            _ => Err(not_a_text(key, value)),
        },
        Expr::Macro(_) | Expr::Group(_) | Expr::Paren(_) => {
            Ok(LitStr::new(&known(key, value, environment)?, value.span()))
        }
        _ => Err(not_a_text(key, value)),
    }
}

/// Value of an expression of literals, `concat!` and `env!`.
fn known(key: &str, value: &Expr, environment: &mut Vec<String>) -> Result<String, Error> {
    match value {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Str(text) => Ok(text.value()),
            Lit::Char(one) => Ok(one.value().to_string()),
            Lit::Bool(value) => Ok(value.value.to_string()),
            Lit::Int(number) => Ok(number.base10_digits().to_owned()),
            Lit::Float(number) => Ok(number.base10_digits().to_owned()),
            _ => Err(not_a_text(key, value)),
        },
        Expr::Group(group) => known(key, &group.expr, environment),
        Expr::Paren(inner) => known(key, &inner.expr, environment),
        Expr::Macro(call) => called(key, call, environment),
        _ => Err(not_a_text(key, value)),
    }
}

fn called(key: &str, call: &ExprMacro, environment: &mut Vec<String>) -> Result<String, Error> {
    let name = call.mac.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
    let arguments = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(call.mac.tokens.clone())?;
    match name.as_str() {
        "concat" => arguments.iter().map(|argument| known(key, argument, environment)).collect(),
        "env" => {
            let variable = arguments.first().map(|name| known(key, name, environment)).transpose()?.unwrap_or_default();
            let value = std::env::var(&variable).map_err(|_| {
                let text = format!("the environment variable `{variable}` is not set\nhelp: cargo sets CARGO_MANIFEST_DIR; set others before the build");
                Error::new(call.span(), text)
            })?;
            environment.push(variable);
            Ok(value)
        }
        "include_str" => {
            let file = arguments.first().map(ToTokens::to_token_stream).unwrap_or_default();
            let text = format!("the derive reads the file itself\nhelp: write `spec = {file}`, relative to Cargo.toml");
            Err(Error::new(call.span(), text))
        }
        _ => Err(not_a_text(key, &Expr::Macro(call.clone()))),
    }
}

/// Error for any other expression, with a suggestion of the text to write.
fn not_a_text(key: &str, value: &Expr) -> Error {
    let written = value.to_token_stream().to_string();
    let constant = matches!(value, Expr::Path(_)) && written.chars().all(|c| !c.is_lowercase());
    let text = match value {
        _ if constant => format!(
            "a constant has no value while a macro runs\nhelp: write the text itself, `{key} = \"..\"`; \
             `concat!` and `env!` of texts are read too"
        ),
        Expr::Path(_) | Expr::Lit(_) => format!("not a text\nhelp: write `{key} = \"{written}\"`, in quotes"),
        _ => format!(
            "not a text that is known while a macro runs\nhelp: write `{key} = \"..\"`; `concat!` and `env!` of texts are read too"
        ),
    };
    Error::new_spanned(value, text)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn of(code: &str) -> Result<(String, Vec<String>), String> {
        let mut environment = Vec::new();
        let value = syn::parse_str::<Expr>(code).unwrap();
        let text = text("spec", &value, &mut environment).map_err(|error| error.to_string())?;
        Ok((text.value(), environment))
    }

    #[test]
    fn texts_that_a_macro_knows() {
        let root = env!("CARGO_MANIFEST_DIR");
        assert_eq!(of("\"a\""), Ok(("a".into(), vec![])));
        assert_eq!(of("concat!(\"specs/\", \"ur\", 5, \".yaml\")"), Ok(("specs/ur5.yaml".into(), vec![])));
        let (text, environment) = of("concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/arm.yaml\",)").unwrap();
        assert_eq!((text, environment), (format!("{root}/arm.yaml"), vec!["CARGO_MANIFEST_DIR".to_owned()]));
        assert_eq!(of("::core::concat!(\"a\", concat!(\"b\", 'c'))"), Ok(("abc".into(), vec![])));
    }

    #[test]
    fn advice_is_rust() {
        for (code, said) in [
            ("PATH", "a constant has no value while a macro runs\nhelp: write the text itself, `spec = \"..\"`"),
            ("specs", "not a text\nhelp: write `spec = \"specs\"`, in quotes"),
            ("5", "not a text\nhelp: write `spec = \"5\"`, in quotes"),
            ("include_str!(\"arm.yaml\")", "help: write `spec = \"arm.yaml\"`, relative to Cargo.toml"),
            ("env!(\"DENHART_NO_SUCH_VARIABLE\")", "`DENHART_NO_SUCH_VARIABLE` is not set"),
            ("format!(\"x\")", "not a text that is known while a macro runs"),
            ("concat!(\"a\", PATH)", "a constant has no value"),
        ] {
            let found = of(code).unwrap_err();
            assert!(found.contains(said), "{code}: {found}");
        }
    }
}
