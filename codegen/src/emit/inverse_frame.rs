//! What surrounds the loops of an inverse: constants, the function's frame, and the two methods.

use super::tokens::{ident, integer, number};
use super::{Target, docs};
use crate::model::{JointKind, Model};
use crate::solve::Plan;
use crate::symbolic::{Expr, Node};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashSet;

/// `let [[r11, ...]] = target.rotation;` with what is used.
pub(super) fn unpack(inputs: &[Expr], plan: &Plan) -> TokenStream {
    let used: HashSet<String> = plan
        .graph
        .reachable(inputs)
        .into_iter()
        .filter_map(|e| match plan.graph.node(e) {
            Node::Symbol(symbol) => Some(symbol.name),
            _ => None,
        })
        .collect();
    let pattern = |name: String| if used.contains(&name) { ident(&name) } else { ident(&format!("_{name}")) };
    let rows = (1..=3).map(|i| {
        let entries = (1..=3).map(|j| pattern(format!("r{i}{j}")));
        quote!([#(#entries),*])
    });
    let position = ["px", "py", "pz"].map(|name| pattern(name.into()));
    quote! {
        let [#(#rows),*] = target.rotation;
        let [#(#position),*] = target.translation;
    }
}

/// Reach, tolerances and limits as constants.
pub(super) fn items(model: &Model, plan: &Plan, target: &Target, calls: TokenStream) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let reach = number(plan.reach);
    let limited = model.joints.iter().any(|joint| joint.limits.is_some());
    let sliding = model
        .joints
        .iter()
        .enumerate()
        .filter(|(_, joint)| joint.kind == JointKind::Prismatic)
        .map(|(index, _)| integer(index))
        .map(|index| quote!(.union(#krate::JointMask::single(#index))));
    let length = number(model.inverse.tolerance_length.unwrap_or(1e-6 * plan.reach));
    let angle = number(model.inverse.tolerance_angle.unwrap_or(1e-6));
    let unit = docs::unit(model);
    let reach_doc = format!(" Reach of the arm, {unit}: the scale of every length comparison.");
    let type_name = &target.type_name;
    quote! {
        #[doc = #reach_doc]
        const REACH: #scalar = #reach;
        /// Lengths are compared relative to the reach.
        const LENGTH: #krate::solve::Measure<#scalar> = #krate::solve::Measure::length(REACH);
        /// What the search needs to know about the arm.
        const FACTS: #krate::solve::Facts<#scalar, #n> = #krate::solve::Facts {
            limits: #type_name::LIMITS,
            limited: #limited,
            prismatic: #krate::JointMask::NONE #(#sliding)*,
            reach: REACH,
            tolerance: #krate::Residual { position: #length, orientation: #angle },
        };
        #calls
    }
}

fn solutions(plan: &Plan, target: &Target) -> TokenStream {
    let (krate, scalar, n, m) =
        (&target.krate, target.scalar.tokens(), integer(plan.values.len()), integer(plan.max_solutions()));
    quote!(#krate::Solutions<#scalar, #n, #m>)
}

/// The function around the loops.
pub(super) fn function(plan: &Plan, target: &Target, unpack: &TokenStream, body: &TokenStream) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(plan.values.len()));
    let solutions = solutions(plan, target);
    let type_name = &target.type_name;
    let lines: Vec<String> = crate::solve::describe(plan).into_iter().map(|line| format!("- {line}")).collect();
    let doc = docs::lines(&format!("All branches of the inverse.\n\n{}", lines.join("\n")));
    quote! {
        #doc
        fn branches(
            arm: &#type_name,
            target: &#krate::Pose<#scalar>,
            near: ::core::option::Option<&[#scalar; #n]>,
        ) -> #solutions {
            let mut solutions = #krate::Solutions::new(#krate::Status::BadTarget);
            let ::core::option::Option::Some(mut search) =
                #krate::solve::Search::new(&FACTS, target, near, &mut solutions)
            else {
                return solutions;
            };
            let start = search.start();
            #unpack
            #body
            search.finish(|q| #type_name::forward_and_jacobian(arm, q));
            solutions
        }
    }
}

/// `inverse` and `inverse_near`.
pub(super) fn methods(model: &Model, plan: &Plan, target: &Target) -> TokenStream {
    let (krate, scalar, n, m) =
        (&target.krate, target.scalar.tokens(), integer(plan.values.len()), integer(plan.max_solutions()));
    let solutions = solutions(plan, target);
    let unit = docs::unit(model);
    let doc = docs::lines(&format!(
        "Every joint vector that puts the tool at `target`: up to {m} branches, in a fixed order.\n\n\
         `target`: pose of the tool in the base frame, position in {unit}. Angles are in (-pi, pi], each solution once.\n\
         A joint that a singular target leaves free stays at 0 (or its limit nearest to 0) and is named in `free`.\n\
         Status: `Reachable`, `Unreachable` with the least gap, or `BadTarget` if the target is not finite or its\n\
         rotation is not one. Limits only set a flag; filter with `within_limits()`.\n\n\
         Method: Pieper (1968) and cyclic closure around three axes that meet or are parallel; the stages are\n\
         documented where they are solved."
    ));
    quote! {
        /// The largest number of solutions of `inverse`.
        pub const MAX_SOLUTIONS: usize = #m;

        #doc
        #[must_use]
        pub fn inverse(&self, target: &#krate::Pose<#scalar>) -> #solutions {
            branches(self, target, ::core::option::Option::None)
        }

        /// The same solutions, joints unwound next to `q_ref` and sorted nearest first; a free joint stays at its value
        /// in `q_ref`.
        ///
        /// A `q_ref` that is not finite is a `BadTarget`.
        #[must_use]
        pub fn inverse_near(&self, target: &#krate::Pose<#scalar>, q_ref: &[#scalar; #n]) -> #solutions {
            branches(self, target, ::core::option::Option::Some(q_ref))
        }

        /// By how much `q` misses the target, from `forward`: the full check of a solution.
        #[must_use]
        pub fn residual(&self, q: &[#scalar; #n], target: &#krate::Pose<#scalar>) -> #krate::Residual<#scalar> {
            #krate::solve::Goal::residual(target, q, &self.forward(q))
        }
    }
}
