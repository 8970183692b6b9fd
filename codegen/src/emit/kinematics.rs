//! forward, link_poses, jacobian and both together.

use super::block::Block;
use super::docs;
use super::tokens::{Writer, ident, integer};
use super::{Target, angle};
use crate::kinematics::{Column, Kinematics, LinkPoses, Wanted, kinematics, link_poses};
use crate::model::Model;
use crate::model::chain::Chain;
use crate::symbolic::{AngleSum, Angles, BoundAngle, Expr, Graph, Rigid};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The four kinematic functions as methods, and the expressions they use (for the dimensions to declare).
pub struct Functions {
    /// The methods.
    pub tokens: TokenStream,
    /// The graphs with their roots.
    pub used: Vec<(Graph, Vec<Expr>)>,
}

/// Emits them.
pub fn functions(model: &Model, chain: &Chain, target: &Target) -> Functions {
    let joints = model.joints.len();
    let n = integer(joints);
    let [forward, jacobian, both] =
        [Wanted::Forward, Wanted::Jacobian, Wanted::Both].map(|wanted| kinematics(chain, wanted));
    let poses = link_poses(chain);
    let mut tokens = TokenStream::new();
    let mut used = Vec::new();
    let krate = &target.krate;
    let scalar = target.scalar.tokens();
    for (name, function, wanted) in [
        ("forward", &forward, Wanted::Forward),
        ("jacobian", &jacobian, Wanted::Jacobian),
        ("forward_and_jacobian", &both, Wanted::Both),
    ] {
        let doc = docs::lines(&docs::kinematics(model, wanted, &function.cost));
        let (returns, roots, result) = outputs(function, wanted, target, &n);
        let body = body(&function.graph, &function.angles, &roots, target, joints, result);
        let name = ident(name);
        tokens.extend(quote! {
            #doc
            #[inline]
            #[must_use]
            pub fn #name(&self, q: &[#scalar; #n]) -> #returns {
                #body
            }
        });
        used.push((function.graph.clone(), roots));
    }
    let doc = docs::lines(&docs::link_poses(model, &poses.cost));
    let roots = pose_roots(&poses);
    let result = |writer: &Writer| {
        let poses = poses.poses.iter().map(|pose| self::pose(writer, pose));
        quote!([#(#poses),*])
    };
    let body = body(&poses.graph, &poses.angles, &roots, target, joints, result);
    tokens.extend(quote! {
        #doc
        #[must_use]
        pub fn link_poses(&self, q: &[#scalar; #n]) -> [#krate::Pose<#scalar>; #n] {
            #body
        }
    });
    used.push((poses.graph.clone(), roots));
    Functions { tokens, used }
}

type Result<'a> = Box<dyn Fn(&Writer) -> TokenStream + 'a>;

fn outputs<'a>(
    function: &'a Kinematics,
    wanted: Wanted,
    target: &Target,
    n: &Literal,
) -> (TokenStream, Vec<Expr>, Result<'a>) {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let pose_type = quote!(#krate::Pose<#scalar>);
    let jacobian_type = quote!(#krate::Jacobian<#scalar, #n>);
    let tool = Rigid { r: function.rotation, p: function.translation };
    let pose_roots: Vec<Expr> = tool.r.iter().flatten().chain(&tool.p).copied().collect();
    let jacobian_roots: Vec<Expr> = rows(&function.columns).concat();
    match wanted {
        Wanted::Forward => (pose_type, pose_roots, Box::new(move |w| pose(w, &tool))),
        Wanted::Jacobian => (jacobian_type, jacobian_roots, Box::new(|w| jacobian(w, &function.columns))),
        Wanted::Both => {
            let roots = [pose_roots, jacobian_roots].concat();
            let result = move |w: &Writer| {
                let (pose, jacobian) = (pose(w, &tool), jacobian(w, &function.columns));
                quote!((#pose, #jacobian))
            };
            (quote!((#pose_type, #jacobian_type)), roots, Box::new(result))
        }
    }
}

fn pose_roots(poses: &LinkPoses) -> Vec<Expr> {
    poses.poses.iter().flat_map(|pose| pose.r.iter().flatten().chain(&pose.p)).copied().collect()
}

fn rows(columns: &[Column]) -> Vec<Vec<Expr>> {
    let of = |pick: fn(&Column) -> [Expr; 3]| {
        (0..3).map(move |i| columns.iter().filter_map(|c| pick(c).get(i).copied()).collect::<Vec<_>>())
    };
    of(|c| c.v).chain(of(|c| c.w)).collect()
}

fn pose(writer: &Writer, pose: &Rigid) -> TokenStream {
    let krate = writer.krate;
    let rows = pose.r.iter().map(|row| {
        let row = row.iter().map(|e| writer.write(*e));
        quote!([#(#row),*])
    });
    let translation = pose.p.iter().map(|e| writer.write(*e));
    quote!(#krate::Pose { rotation: [#(#rows),*], translation: [#(#translation),*] })
}

fn jacobian(writer: &Writer, columns: &[Column]) -> TokenStream {
    let krate = writer.krate;
    let rows = rows(columns).into_iter().map(|row| {
        let row = row.into_iter().map(|e| writer.write(e));
        quote!([#(#row),*])
    });
    quote!(#krate::Jacobian { rows: [#(#rows),*] })
}

fn body(
    graph: &Graph,
    angles: &Angles,
    roots: &[Expr],
    target: &Target,
    joints: usize,
    result: impl Fn(&Writer) -> TokenStream,
) -> TokenStream {
    let used = graph.reachable(roots);
    let mut ordered: Vec<&BoundAngle> = angles.bound.iter().collect();
    ordered.sort_by_key(|bound| bound.sum.terms.clone());
    let mut symbols: Vec<String> =
        ordered.iter().flat_map(|bound| &bound.sum.terms).map(|(joint, _)| format!("q{}", joint + 1)).collect();
    let sines = sin_cos(&ordered, &used, target);
    for e in &used {
        if let crate::symbolic::Node::Symbol(symbol) = graph.node(*e)
            && symbol.name.starts_with('q')
        {
            symbols.push(symbol.name);
        }
    }
    let pattern = (1..=joints).map(|i| {
        let name = format!("q{i}");
        if symbols.contains(&name) { ident(&name) } else { ident(&format!("_{name}")) }
    });
    let reserved = (1..=joints).map(|i| format!("q{i}")).chain(["q".to_string()]);
    let mut block = Block::new(graph, roots, reserved);
    let fresh = block.bind(roots);
    let statements = fresh.iter().map(|e| block.statement(*e, &target.krate));
    let writer = Writer { graph, bound: &block.bound, krate: &target.krate };
    let result = result(&writer);
    quote! {
        let [#(#pattern),*] = *q;
        #sines
        #(#statements)*
        #result
    }
}

/// All sines and cosines at once: the kernel works on several angles in parallel.
fn sin_cos(bound: &[&BoundAngle], used: &[Expr], target: &Target) -> TokenStream {
    let krate = &target.krate;
    let name = |e: Expr, name: &str| if used.contains(&e) { ident(name) } else { ident(&format!("_{name}")) };
    let sines = bound.iter().map(|b| name(b.pair.sin, b.names.first().map_or("", String::as_str)));
    let cosines = bound.iter().map(|b| name(b.pair.cos, b.names.last().map_or("", String::as_str)));
    let sums = bound.iter().map(|b| sum(&b.sum, target));
    match bound {
        [] => TokenStream::new(),
        [_] => quote!(let (#(#sines),*, #(#cosines),*) = #krate::math::sin_cos(#(#sums),*);),
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
