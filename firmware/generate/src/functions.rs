//! The functions of a generated arm and how a case gives their arguments.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Block, Expr, File, FnArg, ImplItem, Item, ItemImpl, Pat, ReturnType, Signature, Stmt, Type, Visibility};

use crate::Error;

/// Functions of an arm that are called.
pub(crate) struct Functions {
    pub(crate) calls: Vec<Call>,
    /// The name of the joint whose value comes with the target, such as `q3`.
    pub(crate) given: Option<String>,
    pub(crate) has_inverse: bool,
}

/// One call.
pub(crate) struct Call {
    pub(crate) name: String,
    /// The arguments, of a `case`.
    pub(crate) arguments: Vec<TokenStream>,
    /// True if the function returns an iterator.
    pub(crate) many: bool,
    /// True if the function fills a list that the caller keeps.
    pub(crate) keeps: bool,
}

/// The methods that come by `motion_methods!`, and their arguments.
const MOTION: [(&str, &[&str]); 6] = [
    ("velocity", &["q", "qd"]),
    ("acceleration", &["q", "qd", "qdd"]),
    ("jacobian_dot", &["q", "qd"]),
    ("jacobian_tool", &["q"]),
    ("link_velocities", &["q", "qd"]),
    ("link_accelerations", &["q", "qd", "qdd"]),
];

/// Every public method of the struct `robot` in generated code.
pub(crate) fn read(code: &str, robot: &str) -> Result<Functions, Error> {
    let file: File = syn::parse_str(code)?;
    let methods: Vec<ImplItem> = file.items.into_iter().flat_map(|item| inherent(item, robot)).collect();
    let mut signatures = Vec::new();
    let mut calls = Vec::new();
    for method in &methods {
        match method {
            ImplItem::Fn(method) if matches!(method.vis, Visibility::Public(_)) => signatures.push(&method.sig),
            ImplItem::Macro(called) if called.mac.path.segments.last().is_some_and(|s| s.ident == "motion_methods") => {
                for (name, arguments) in MOTION {
                    let arguments = arguments.iter().map(|name| argument(name, None)).collect::<Option<_>>();
                    calls.push(Call {
                        name: name.to_owned(),
                        arguments: arguments.unwrap_or_default(),
                        many: false,
                        keeps: false,
                    });
                }
            }
            ImplItem::Macro(called) => {
                let path = &called.mac.path;
                return Err(format!("`{}` adds methods that are not called here", quote!(#path)).into());
            }
            _ => {}
        }
    }
    let inverse = signatures.iter().find(|signature| is_inverse(signature));
    let given = inverse.and_then(|signature| names(signature).into_iter().find(|name| name != "target"));
    let has_inverse = inverse.is_some();
    for signature in signatures {
        // An arm without inverse has methods whose call does not compile and says why.
        let name = signature.ident.to_string();
        let asks = name == "target_at" || name.starts_with("inverse");
        // So has `inverse_branch` of an arm whose inverse holds a joint.
        if asks && (!has_inverse || !signature.generics.params.is_empty()) {
            continue;
        }
        calls.push(call(signature, given.as_deref())?);
    }
    Ok(Functions { calls, given, has_inverse })
}

fn is_inverse(signature: &Signature) -> bool {
    signature.ident == "inverse" && signature.generics.params.is_empty()
}

/// The items of `impl robot`, which stands in the block of a constant.
fn inherent(item: Item, robot: &str) -> Vec<ImplItem> {
    let Item::Const(constant) = item else { return Vec::new() };
    let Expr::Block(block) = *constant.expr else { return Vec::new() };
    let Block { stmts, .. } = block.block;
    let of_robot = |item: &ItemImpl| {
        item.trait_.is_none() && matches!(&*item.self_ty, Type::Path(path) if path.path.is_ident(robot))
    };
    let items = stmts.into_iter().filter_map(|stmt| match stmt {
        Stmt::Item(Item::Impl(item)) if of_robot(&item) => Some(item.items),
        _ => None,
    });
    items.flatten().collect()
}

/// Names of the arguments after `self`.
fn names(signature: &Signature) -> Vec<String> {
    let typed = signature.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => Some(&typed.pat),
        FnArg::Receiver(_) => None,
    });
    typed.map(|pat| if let Pat::Ident(name) = &**pat { name.ident.to_string() } else { String::new() }).collect()
}

fn call(signature: &Signature, given: Option<&str>) -> Result<Call, Error> {
    let name = signature.ident.to_string();
    let mut arguments = Vec::new();
    let written = names(signature);
    let keeps = written.iter().any(|name| name == "solutions");
    for written in written {
        let Some(tokens) = argument(&written, given) else {
            return Err(format!("no case has the argument `{written}` of `{name}`: add it to firmware/cases").into());
        };
        arguments.push(tokens);
    }
    let many = matches!(&signature.output, ReturnType::Type(_, of) if matches!(**of, Type::ImplTrait(_)));
    Ok(Call { name, arguments, many, keeps })
}

/// How a case gives the argument `name`; `given`: the joint whose value comes with the target.
fn argument(name: &str, given: Option<&str>) -> Option<TokenStream> {
    Some(match name {
        "target" if given.is_some() => quote!(&case.target.0),
        "target" => quote!(&case.target),
        "branch" => quote!(case.branch),
        "n" => quote!(case.samples),
        "q" | "qd" | "qdd" | "q_ref" | "pulses" | "motor" => {
            let field = format_ident!("{name}");
            quote!(&case.#field)
        }
        "solutions" => quote!(kept),
        _ if given == Some(name) => quote!(case.target.1),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn arm(methods: &str) -> Result<Functions, Error> {
        read(&format!("pub struct Robot; const _: () = {{ impl Robot {{ {methods} }} }};"), "Robot")
    }

    #[test]
    fn every_public_method_is_called() {
        let functions =
            arm("pub fn forward(&self, q: &[f32; 1]) -> Pose { Pose } fn hidden(&self) {} m::motion_methods!(f32);");
        let names: Vec<String> = functions.unwrap().calls.into_iter().map(|call| call.name).collect();
        assert_eq!(names.len(), 7, "{names:?}");
        assert!(names.contains(&"forward".to_owned()) && !names.contains(&"hidden".to_owned()));
    }

    #[test]
    fn what_is_not_known_is_an_error() {
        let error = arm("pub fn forward(&self, torque: f32) -> f32 { torque }").err().unwrap();
        assert!(error.to_string().starts_with("no case has the argument `torque` of `forward`"), "{error}");
        let error = arm("m::other_methods!(f32);").err().unwrap();
        assert!(error.to_string().contains("other_methods"), "{error}");
    }

    #[test]
    fn a_joint_that_is_given_comes_with_the_target() {
        let functions = arm("pub fn inverse(&self, target: &Pose, q3: f32) -> f32 { q3 }").unwrap();
        assert_eq!(functions.given.as_deref(), Some("q3"));
        let arguments: Vec<String> = functions.calls[0].arguments.iter().map(ToString::to_string).collect();
        assert_eq!(arguments, ["& case . target . 0", "case . target . 1"]);
    }
}
