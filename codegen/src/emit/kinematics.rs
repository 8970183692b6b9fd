//! forward, link_poses, jacobian and both together.

use super::docs;
use super::tokens::{Writer, ident, integer};
use super::{Target, angle};
use crate::lower::{Function, Functions, Slot, Turned};
use crate::model::Model;
use crate::symbolic::AngleSum;
use proc_macro2::TokenStream;
use quote::quote;

/// How many numbers a pose has: rotation and position.
const POSE: usize = 12;

/// The four kinematic functions as methods.
pub fn functions(model: &Model, functions: &Functions, target: &Target) -> TokenStream {
    let joints = model.joints.len();
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(joints));
    let (pose_type, jacobian_type) = (quote!(#krate::Pose<#scalar>), quote!(#krate::Jacobian<#scalar, #n>));
    let Functions { forward, jacobian, both, links } = functions;
    let columns = |w: &Writer, roots: &[Slot]| self::jacobian(w, roots, joints);
    let pose_and_columns = |w: &Writer, roots: &[Slot]| {
        let (first, rest) = roots.split_at_checked(POSE).unwrap_or((roots, &[]));
        let (pose, jacobian) = (pose(w, first), columns(w, rest));
        quote!((#pose, #jacobian))
    };
    let poses = |w: &Writer, roots: &[Slot]| {
        let poses = roots.chunks(POSE).map(|roots| pose(w, roots));
        quote!([#(#poses),*])
    };
    let inline = quote!(#[inline]);
    let methods = [
        ("forward", docs::forward(model, &forward.cost), &inline, &pose_type, body(forward, target, pose)),
        ("jacobian", docs::jacobian(model, &jacobian.cost), &inline, &jacobian_type, body(jacobian, target, columns)),
        (
            "forward_and_jacobian",
            docs::both(model, &both.cost),
            &inline,
            &quote!((#pose_type, #jacobian_type)),
            body(both, target, pose_and_columns),
        ),
        (
            "link_poses",
            docs::link_poses(model, &links.cost),
            &TokenStream::new(),
            &quote!([#pose_type; #n]),
            body(links, target, poses),
        ),
    ];
    let methods = methods.map(|(name, doc, inline, returns, body)| {
        let (name, doc) = (ident(name), docs::lines(&doc));
        quote! {
            #doc
            #inline
            #[must_use]
            pub fn #name(&self, q: &[#scalar; #n]) -> #returns {
                #body
            }
        }
    });
    quote!(#(#methods)*)
}

fn pose(writer: &Writer, roots: &[Slot]) -> TokenStream {
    let krate = writer.krate;
    let mut rows = roots.chunks(3).map(|row| {
        let row = row.iter().map(|e| writer.write(*e));
        quote!([#(#row),*])
    });
    let rotation: Vec<TokenStream> = rows.by_ref().take(3).collect();
    let translation = rows.next();
    quote!(#krate::Pose { rotation: [#(#rotation),*], translation: #translation })
}

fn jacobian(writer: &Writer, roots: &[Slot], joints: usize) -> TokenStream {
    let krate = writer.krate;
    let rows = roots.chunks(joints.max(1)).map(|row| {
        let row = row.iter().map(|e| writer.write(*e));
        quote!([#(#row),*])
    });
    quote!(#krate::Jacobian { rows: [#(#rows),*] })
}

fn body(function: &Function, target: &Target, result: impl Fn(&Writer, &[Slot]) -> TokenStream) -> TokenStream {
    let straight = &function.straight;
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate: &target.krate };
    let pattern = (0..function.joints.len()).map(|joint| {
        let name = format!("q{}", joint + 1);
        if function.reads(joint) { ident(&name) } else { ident(&format!("_{name}")) }
    });
    let sines = sin_cos(function, target);
    let statements = straight.shared.iter().map(|e| writer.statement(*e));
    let result = result(&writer, &straight.roots);
    quote! {
        let [#(#pattern),*] = *q;
        #sines
        #(#statements)*
        #result
    }
}

/// All sines and cosines at once: the kernel works on several angles in parallel.
fn sin_cos(function: &Function, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let straight = &function.straight;
    let name = |slot: Slot| {
        let name = straight.graph.leaf_name(slot).unwrap_or_default();
        if straight.reads(slot) { ident(&name) } else { ident(&format!("_{name}")) }
    };
    let turned = &function.turned;
    let sines = turned.iter().map(|turned| name(turned.sin));
    let cosines = turned.iter().map(|turned| name(turned.cos));
    let sums = turned.iter().map(|turned| sum(&turned.sum, target));
    match turned.as_slice() {
        [] => TokenStream::new(),
        [Turned { .. }] => quote!(let (#(#sines),*, #(#cosines),*) = #krate::math::sin_cos(#(#sums),*);),
        _ => quote!(let ([#(#sines),*], [#(#cosines),*]) = #krate::math::sin_cos_array([#(#sums),*]);),
    }
}

fn sum(sum: &AngleSum, target: &Target) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (index, (joint, negative)) in sum.terms.iter().enumerate() {
        let q = ident(&format!("q{}", joint + 1));
        tokens.extend(match (index, negative) {
            (0, false) => quote!(#q),
            (_, false) => quote!(+ #q),
            (_, true) => quote!(- #q),
        });
    }
    if !sum.constant.is_zero() {
        let negative = sum.constant.rad() < 0.0;
        let constant = angle::tokens(if negative { sum.constant.neg() } else { sum.constant }, target);
        tokens.extend(if negative { quote!(- #constant) } else { quote!(+ #constant) });
    }
    tokens
}
