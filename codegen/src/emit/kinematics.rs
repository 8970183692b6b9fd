//! forward, link_poses, jacobian and both together.

use super::docs;
use super::tokens::{Writer, array, bound, ident, integer};
use super::{Target, angle};
use crate::lower::{BoundAngle, Function, Functions, Slot};
use crate::model::Model;
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
        let (pose, jacobian) = pose_and_jacobian(w, roots, joints);
        quote!((#pose, #jacobian))
    };
    let poses = |w: &Writer, roots: &[Slot]| array(roots.chunks(POSE).map(|roots| pose(w, roots)));
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

/// A pose of its twelve numbers.
pub fn pose(writer: &Writer, roots: &[Slot]) -> TokenStream {
    let krate = writer.krate;
    let mut rows = roots.chunks(3).map(|row| array(row.iter().map(|e| writer.write(*e))));
    let rotation: Vec<TokenStream> = rows.by_ref().take(3).collect();
    let translation = rows.next();
    quote!(#krate::Pose { rotation: [#(#rotation),*], translation: #translation })
}

/// A pose and a Jacobian of their numbers.
pub fn pose_and_jacobian(writer: &Writer, roots: &[Slot], joints: usize) -> (TokenStream, TokenStream) {
    let (first, rest) = roots.split_at_checked(POSE).unwrap_or((roots, &[]));
    (pose(writer, first), jacobian(writer, rest, joints))
}

fn jacobian(writer: &Writer, roots: &[Slot], joints: usize) -> TokenStream {
    let krate = writer.krate;
    let rows = roots.chunks(joints.max(1)).map(|row| array(row.iter().map(|e| writer.write(*e))));
    quote!(#krate::Jacobian { rows: [#(#rows),*] })
}

fn body(function: &Function, target: &Target, result: impl Fn(&Writer, &[Slot]) -> TokenStream) -> TokenStream {
    let straight = &function.straight;
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate: &target.krate, lanes: false };
    let pattern = (0..function.joints.len()).map(|joint| bound(&format!("q{}", joint + 1), function.reads(joint)));
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

/// All sines and cosines.
fn sin_cos(function: &Function, target: &Target) -> TokenStream {
    let straight = &function.straight;
    let name = |slot: Slot| {
        let name = bound(&straight.graph.leaf_name(slot).unwrap_or_default(), straight.reads(slot));
        quote!(#name)
    };
    let of = |turned: &BoundAngle| {
        let terms = turned.sum.terms.iter().map(|(joint, negative)| (ident(&format!("q{}", joint + 1)), *negative));
        (name(turned.pair.sin), (name(turned.pair.cos), angle::sum(terms, turned.sum.constant, target)))
    };
    let (sines, (cosines, sums)): (Vec<_>, (Vec<_>, Vec<_>)) = function.turned.iter().map(of).unzip();
    angle::sines(&sines, &cosines, &sums, target)
}
