//! forward, link_poses, jacobian and both together.

use super::docs;
use super::tokens::{Writer, ident, integer};
use super::{Target, angle};
use crate::kinematics::{Wanted, kinematics, link_poses};
use crate::lower::{Function, Slot, Straight, Turned, function, link_function};
use crate::model::Model;
use crate::model::chain::Chain;
use crate::symbolic::AngleSum;
use proc_macro2::TokenStream;
use quote::quote;

/// How many numbers a pose has: rotation and position.
const POSE: usize = 12;

/// The four kinematic functions as methods, and the expressions they use (for the dimensions to declare).
pub struct Functions {
    /// The methods.
    pub tokens: TokenStream,
    /// The expressions.
    pub used: Vec<Straight>,
}

/// Emits them.
pub fn functions(model: &Model, chain: &Chain, target: &Target) -> Functions {
    let joints = model.joints.len();
    let n = integer(joints);
    let mut tokens = TokenStream::new();
    let mut used = Vec::new();
    let krate = &target.krate;
    let scalar = target.scalar.tokens();
    let (pose_type, jacobian_type) = (quote!(#krate::Pose<#scalar>), quote!(#krate::Jacobian<#scalar, #n>));
    for (name, wanted) in
        [("forward", Wanted::Forward), ("jacobian", Wanted::Jacobian), ("forward_and_jacobian", Wanted::Both)]
    {
        let expressions = kinematics(chain, wanted);
        let function = function(&expressions, wanted, joints);
        let doc = docs::lines(&docs::kinematics(model, wanted, &expressions.cost));
        let (returns, body) = match wanted {
            Wanted::Forward => (pose_type.clone(), body(&function, target, pose)),
            Wanted::Jacobian => (jacobian_type.clone(), body(&function, target, |w, roots| jacobian(w, roots, joints))),
            Wanted::Both => {
                let both = |w: &Writer, roots: &[Slot]| {
                    let (first, rest) = roots.split_at_checked(POSE).unwrap_or((roots, &[]));
                    let (pose, jacobian) = (pose(w, first), jacobian(w, rest, joints));
                    quote!((#pose, #jacobian))
                };
                (quote!((#pose_type, #jacobian_type)), body(&function, target, both))
            }
        };
        let name = ident(name);
        tokens.extend(quote! {
            #doc
            #[inline]
            #[must_use]
            pub fn #name(&self, q: &[#scalar; #n]) -> #returns {
                #body
            }
        });
        used.push(function.straight);
    }
    let poses = link_poses(chain);
    let doc = docs::lines(&docs::link_poses(model, &poses.cost));
    let function = link_function(&poses, joints);
    let body = body(&function, target, |writer, roots| {
        let poses = roots.chunks(POSE).map(|roots| pose(writer, roots));
        quote!([#(#poses),*])
    });
    tokens.extend(quote! {
        #doc
        #[must_use]
        pub fn link_poses(&self, q: &[#scalar; #n]) -> [#krate::Pose<#scalar>; #n] {
            #body
        }
    });
    used.push(function.straight);
    Functions { tokens, used }
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
