//! Absolute paths as names: `::denhart::solve::Turn` becomes `Turn`, imported at the head of the block that holds the code.
//!
//! Emitted code has absolute paths, which mean the same wherever they stand. This pass shortens them afterwards:
//! a type or trait to its name, a function or constant to its module and its name. A name that the user's type has, or
//! that a shorter path has, is left to it.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, TokenStream, TokenTree};
use quote::quote;
use std::collections::{BTreeMap, BTreeSet};

/// Variants that are written without their type.
const VARIANTS: [&str; 4] = ["Some", "None", "Ok", "Err"];

/// The code with short names, and the `use` items that they need.
pub fn shortened(code: TokenStream, krate: &TokenStream, type_name: &Ident) -> (TokenStream, TokenStream) {
    let mut roots = vec![vec!["core".to_string()]];
    roots.extend(absolute(&krate.clone().into_iter().collect::<Vec<_>>(), 0).map(|path| path.names()));
    let taken = type_name.to_string().trim_start_matches("r#").to_string();
    let mut paths = Paths { roots, taken, owners: BTreeMap::new(), imports: BTreeSet::new() };
    paths.collect(&code);
    let code = paths.rewrite(code);
    (paths.items(), code)
}

/// A path from `::` on.
struct Absolute {
    segments: Vec<Ident>,
    /// How many tokens it takes.
    tokens: usize,
    /// True for the path of a macro.
    is_macro: bool,
}

impl Absolute {
    fn names(&self) -> Vec<String> {
        self.segments.iter().map(Ident::to_string).collect()
    }
}

/// A shortened path: the segments that stay, and the path that is imported for them.
struct Short {
    keeps: usize,
    import: Vec<String>,
}

struct Paths {
    /// The crates whose paths are shortened.
    roots: Vec<Vec<String>>,
    /// The name of the user's type.
    taken: String,
    /// The path that each name stands for.
    owners: BTreeMap<String, Vec<String>>,
    imports: BTreeSet<Vec<String>>,
}

impl Paths {
    /// Finds the owner of every name: of several paths the shortest.
    fn collect(&mut self, code: &TokenStream) {
        let tokens: Vec<TokenTree> = code.clone().into_iter().collect();
        for (index, token) in tokens.iter().enumerate() {
            if let TokenTree::Group(group) = token {
                self.collect(&group.stream());
            }
            if let Some(path) = absolute(&tokens, index)
                && let Some(Short { import, .. }) = self.by_type(&path).or_else(|| self.by_module(&path))
                && let Some(name) = import.last()
            {
                let owner = self.owners.entry(name.clone()).or_insert_with(|| import.clone());
                if import.len() < owner.len() {
                    *owner = import;
                }
            }
        }
    }

    fn rewrite(&mut self, code: TokenStream) -> TokenStream {
        let tokens: Vec<TokenTree> = code.into_iter().collect();
        let (mut out, mut index) = (Vec::new(), 0);
        while let Some(token) = tokens.get(index) {
            if let Some(path) = absolute(&tokens, index)
                && let Some(short) = self.short(&path)
            {
                let from = path.segments.len().saturating_sub(short.keeps);
                let kept = path.segments.get(from..).unwrap_or_default();
                out.push(quote!(#(#kept)::*));
                self.imports.insert(short.import);
                index += path.tokens;
                continue;
            }
            let token = match token {
                TokenTree::Group(group) => {
                    let mut inner = Group::new(group.delimiter(), self.rewrite(group.stream()));
                    inner.set_span(group.span());
                    TokenTree::Group(inner)
                }
                other => other.clone(),
            };
            out.push(token.into());
            index += 1;
        }
        out.into_iter().collect()
    }

    /// The first way that imports a name which is this path's own.
    fn short(&self, path: &Absolute) -> Option<Short> {
        let owns = |short: &Short| {
            let name = short.import.last();
            name.is_some_and(|name| {
                *name != self.taken && self.owners.get(name).is_none_or(|path| *path == short.import)
            })
        };
        self.by_type(path).filter(owns).or_else(|| self.by_module(path).filter(owns))
    }

    fn root(&self, names: &[String]) -> Option<usize> {
        self.roots.iter().find(|root| names.starts_with(root)).map(Vec::len)
    }

    /// From the first type or trait of the path on, or from a variant of `Option` or `Result` on.
    fn by_type(&self, path: &Absolute) -> Option<Short> {
        let names = path.names();
        let root = self.root(&names)?;
        let is_type = |name: &String| name.starts_with(char::is_uppercase) && name.contains(char::is_lowercase);
        let variant = names.iter().position(|name| VARIANTS.contains(&name.as_str()));
        let first = variant.or_else(|| names.iter().skip(root).position(is_type).map(|index| index + root))?;
        (!path.is_macro)
            .then(|| Short { keeps: names.len() - first, import: names.into_iter().take(first + 1).collect() })
    }

    /// From the module of the last segment on.
    fn by_module(&self, path: &Absolute) -> Option<Short> {
        let names = path.names();
        let root = self.root(&names)?;
        let module = names.len().checked_sub(2).filter(|module| *module >= root)?;
        let is_module = names.get(module)?.starts_with(char::is_lowercase);
        (is_module && !path.is_macro)
            .then(|| Short { keeps: names.len() - module, import: names.into_iter().take(module + 1).collect() })
    }

    /// One `use` item for each module.
    fn items(&self) -> TokenStream {
        let mut modules: BTreeMap<&[String], Vec<&String>> = BTreeMap::new();
        for import in &self.imports {
            if let [module @ .., name] = import.as_slice() {
                modules.entry(module).or_default().push(name);
            }
        }
        let items = modules.into_iter().map(|(module, names)| {
            let module = module.iter().map(|name| super::tokens::ident(name));
            let names = names.into_iter().map(|name| super::tokens::ident(name));
            quote!(use #(::#module)*::{#(#names),*};)
        });
        quote!(#(#items)*)
    }
}

/// The absolute path that begins at a token, if one does.
fn absolute(tokens: &[TokenTree], index: usize) -> Option<Absolute> {
    let is_colons = |at: usize| {
        matches!(tokens.get(at), Some(TokenTree::Punct(first)) if first.as_char() == ':' && first.spacing() == Spacing::Joint)
            && matches!(tokens.get(at + 1), Some(TokenTree::Punct(second)) if second.as_char() == ':')
    };
    if !is_colons(index) || index.checked_sub(1).is_some_and(|before| continues(tokens, before)) {
        return None;
    }
    let (mut segments, mut at) = (Vec::new(), index);
    while is_colons(at)
        && let Some(TokenTree::Ident(segment)) = tokens.get(at + 2)
    {
        segments.push(segment.clone());
        at += 3;
    }
    let is_macro = matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == '!');
    (!segments.is_empty()).then_some(Absolute { segments, tokens: at - index, is_macro })
}

/// True if `::` after this token continues a path, as in `Self::DH` or `<T>::X`.
fn continues(tokens: &[TokenTree], before: usize) -> bool {
    let is = |token: Option<&TokenTree>, sign: char| matches!(token, Some(TokenTree::Punct(p)) if p.as_char() == sign);
    match tokens.get(before) {
        Some(TokenTree::Ident(word)) => syn::parse_str::<Ident>(&word.to_string()).is_ok() || word == "Self",
        Some(TokenTree::Punct(punct)) if punct.as_char() == '>' => {
            !before.checked_sub(1).is_some_and(|arrow| is(tokens.get(arrow), '-') || is(tokens.get(arrow), '='))
        }
        Some(TokenTree::Punct(punct)) => is_colon(punct),
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::None,
        _ => false,
    }
}

/// The second half of `::`.
fn is_colon(punct: &Punct) -> bool {
    punct.as_char() == ':' && punct.spacing() == Spacing::Joint
}

#[cfg(test)]
mod tests {
    use super::*;

    fn short(code: TokenStream, type_name: &str) -> [String; 2] {
        let (items, code) = shortened(code, &quote!(::denhart), &super::super::tokens::ident(type_name));
        [items.to_string(), code.to_string()]
    }

    #[test]
    fn types_functions_and_variants() {
        let code = quote! {
            fn f(a: ::core::option::Option<::denhart::Pose<f64>>) -> ::denhart::solve::Turn<f64> {
                Self::X; ::core::option::Option::None; ::denhart::math::sqrt(::core::f64::consts::PI);
                ::denhart::methods!(::denhart::Pose);
            }
        };
        let [items, code] = short(code, "Arm1");
        let expected = quote! {
            fn f(a: Option<Pose<f64>>) -> Turn<f64> {
                Self::X; None; math::sqrt(consts::PI);
                ::denhart::methods!(Pose);
            }
        };
        assert_eq!(code, expected.to_string());
        let expected = quote! {
            use ::core::f64::{consts};
            use ::core::option::{Option};
            use ::core::option::Option::{None};
            use ::denhart::{Pose, math};
            use ::denhart::solve::{Turn};
        };
        assert_eq!(items, expected.to_string());
    }

    /// The user's type keeps its name, and of two paths with one name the shorter has it.
    #[test]
    fn names_are_taken_from_nobody() {
        let [_, code] = short(quote!(::denhart::Pose; ::denhart::solve::Elbow; ::denhart::Elbow::Up), "Pose");
        assert_eq!(code, quote!(::denhart::Pose; solve::Elbow; Elbow::Up).to_string());
    }
}
