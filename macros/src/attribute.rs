//! `#[arm(..)]` as a type. Reading goes on after a mistake, so that all of them are reported together.

use crate::text;
use denhart_codegen::ScalarKind;
use quote::ToTokens;
use syn::meta::ParseNestedMeta;
use syn::{Attribute, Error, LitStr, Path, Result, Token};

const KEYS: &str = "the keys of #[arm(..)] are `spec`, `yaml`, `scalar`, `crate`, `batch` and `warn`";

/// Where the arm file is: the literal also carries the place of its messages.
pub enum Source {
    /// `spec = "specs/ur5.yaml"`
    File(LitStr),
    /// `yaml = "..."`
    Inline(LitStr),
}

/// Contents of `#[arm(..)]`, with defaults in place of missing and wrong entries.
pub struct ArmAttribute {
    /// None only after an error.
    pub source: Option<Source>,
    pub scalar: ScalarKind,
    pub crate_path: Path,
    pub warn: bool,
    /// True if the functions are to exist over lanes, too.
    pub batch: bool,
    /// True if the attribute names the path of the crate.
    pub names_crate: bool,
    /// The environment variables that `env!` reads.
    pub environment: Vec<String>,
}

/// The values as written, each at most once.
#[derive(Default)]
struct Written {
    spec: Option<LitStr>,
    yaml: Option<LitStr>,
    scalar: Option<LitStr>,
    crate_path: Option<LitStr>,
    warn: bool,
    batch: bool,
    environment: Vec<String>,
}

impl ArmAttribute {
    /// Reads every `#[arm(..)]` among the attributes of the struct; mistakes go to `errors`.
    pub fn read(attributes: &[Attribute], errors: &mut Vec<Error>) -> Self {
        let mut written = Written::default();
        let mut found = false;
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("arm")) {
            found = true;
            if let Ok(text) = attribute.parse_args::<LitStr>() {
                let help = format!("help: write `spec = {}`; {KEYS}", text.token());
                errors.push(Error::new(text.span(), format!("a value without its key\n{help}")));
                continue;
            }
            let read = attribute.parse_nested_meta(|meta| written.read_key(&meta, errors));
            errors.extend(read.err());
        }
        if !found {
            let text = "#[derive(Arm)] needs to know the arm\nhelp: add #[arm(spec = \"specs/arm.yaml\")]";
            errors.push(Error::new(proc_macro2::Span::call_site(), text));
        }
        let silent = found && errors.is_empty();
        written.finish(attributes, silent, errors)
    }
}

impl Written {
    fn read_key(&mut self, meta: &ParseNestedMeta<'_>, errors: &mut Vec<Error>) -> Result<()> {
        let slot = match meta.path.get_ident().map(ToString::to_string).as_deref() {
            Some("spec") => &mut self.spec,
            Some("yaml") => &mut self.yaml,
            Some("scalar") => &mut self.scalar,
            Some("crate") => &mut self.crate_path,
            Some("warn") => return read_flag("warn", &mut self.warn, meta, errors),
            Some("batch") => return read_flag("batch", &mut self.batch, meta, errors),
            _ => {
                errors.push(Error::new_spanned(&meta.path, format!("unknown key\nhelp: {KEYS}")));
                return skip_value(meta);
            }
        };
        let Some(value) = value_of(meta, &mut self.environment, errors)? else { return Ok(()) };
        if slot.is_some() {
            let key = &meta.path;
            errors.push(Error::new_spanned(key, "this key is given twice"));
        }
        slot.get_or_insert(value);
        Ok(())
    }

    fn finish(self, attributes: &[Attribute], silent: bool, errors: &mut Vec<Error>) -> ArmAttribute {
        let source = match (self.spec, self.yaml) {
            (Some(spec), None) => Some(Source::File(spec)),
            (None, Some(yaml)) => Some(Source::Inline(yaml)),
            (Some(spec), Some(yaml)) => {
                errors.push(Error::new(yaml.span(), "`yaml` beside `spec`: an arm has one of them"));
                Some(Source::File(spec))
            }
            (None, None) => {
                // After another mistake in the attribute this one would only repeat it.
                if silent {
                    let attribute = attributes.iter().find(|attribute| attribute.path().is_ident("arm"));
                    let text = "no arm file is named\nhelp: add `spec = \"specs/arm.yaml\"`, or `yaml = \"...\"` with its text";
                    errors.push(Error::new_spanned(attribute, text));
                }
                None
            }
        };
        let scalar = self.scalar.map_or(Ok(ScalarKind::F64), |written| {
            ScalarKind::try_from(written.value().as_str()).map_err(|error| Error::new(written.span(), error))
        });
        let names_crate = self.crate_path.is_some();
        let default_path = || syn::parse_quote!(::denhart);
        let crate_path = self.crate_path.map_or_else(
            || Ok(default_path()),
            |written| {
                let text = "not a path to the crate denhart\nhelp: write a path, such as `crate = \"::denhart\"`";
                written.parse_with(Path::parse_mod_style).map_err(|_| Error::new(written.span(), text))
            },
        );
        let mut report = |error: Error| errors.push(error);
        ArmAttribute {
            source,
            scalar: scalar.map_err(&mut report).unwrap_or(ScalarKind::F64),
            crate_path: crate_path.map_err(&mut report).unwrap_or_else(|()| default_path()),
            warn: self.warn,
            batch: self.batch,
            environment: self.environment,
            names_crate,
        }
    }
}

/// Reads a key that stands alone.
fn read_flag(name: &str, flag: &mut bool, meta: &ParseNestedMeta<'_>, errors: &mut Vec<Error>) -> Result<()> {
    if *flag {
        errors.push(Error::new_spanned(&meta.path, format!("`{name}` is given twice")));
    }
    *flag = true;
    if meta.input.peek(syn::Token![=]) {
        errors.push(Error::new_spanned(&meta.path, format!("`{name}` takes no value\nhelp: write `{name}` alone")));
        skip_value(meta)?;
    }
    Ok(())
}

/// The value of a key, a text in quotes; none after a mistake.
fn value_of(
    meta: &ParseNestedMeta<'_>,
    environment: &mut Vec<String>,
    errors: &mut Vec<Error>,
) -> Result<Option<LitStr>> {
    let value = match meta.value() {
        Ok(value) => value,
        Err(_) => {
            let help = format!("help: write `{} = \"...\"`", meta.path.to_token_stream());
            errors.push(Error::new_spanned(&meta.path, format!("a key without a value\n{help}")));
            skip_value(meta)?;
            return Ok(None);
        }
    };
    let key = meta.path.to_token_stream().to_string();
    match text::text(&key, &value.parse()?, environment) {
        Ok(text) => Ok(Some(text)),
        Err(error) => {
            errors.push(error);
            Ok(None)
        }
    }
}

/// Steps over the value of a key that is not known, to read on behind it.
fn skip_value(meta: &ParseNestedMeta<'_>) -> Result<()> {
    if meta.input.peek(Token![=]) {
        meta.value()?.parse::<syn::Expr>()?;
    } else if meta.input.peek(syn::token::Paren) {
        meta.input.parse::<proc_macro2::Group>()?;
    }
    Ok(())
}
