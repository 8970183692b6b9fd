//! The method `margins`: the factors of the Jacobian's determinant.

use super::constants::Dimensions;
use super::tokens::{Writer, array, bound, ident, integer};
use super::{Target, angle, docs};
use crate::lower::{self, Factor, Goal, Margins, Slot, Variable};
use crate::model::Model;
use crate::solve::{Branching, Plan};
use crate::symbolic::{Expr, Graph, Input, Label, Node, Part, Symbol, Unknown};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::HashSet;

/// The method, and the dimensions it uses; nothing for a task that has none.
pub fn margins(model: &Model, plan: &Plan, target: &Target, dimensions: &mut Dimensions) -> TokenStream {
    let Some(margins) = lower::margins(plan) else { return TokenStream::new() };
    let (straight, factors) = (&margins.straight, &margins.factors);
    dimensions.collect(straight);
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let count = integer(factors.len());
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate, lanes: false };
    let statements = straight.shared.iter().map(|e| writer.statement(*e));
    let bound = !model.parameters.is_empty();
    let reach = ident(if bound { "reach" } else { "REACH" });
    let entries = factors.iter().map(|factor| {
        let (name, value) = (&factor.name, scaled(&writer, factor, &reach));
        quote!(#krate::Margin::new(#name, #value))
    });
    let pose = pose(&margins);
    // The expressions are those of the inverse, in which run-time parameters are fields of `arm`.
    let reads_field = straight.graph.reachable(&straight.roots).into_iter().any(|e| straight.graph.is_field(e));
    let fields = reads_field.then(|| quote!(let arm = self;));
    let size = (bound && factors.iter().any(|factor| factor.power > 0)).then(|| quote!(let reach = reach(self);));
    let angles = angles(&margins, target);
    let doc = docs::lines(&doc(plan, &writer, factors, &reach));
    quote! {
        #doc
        #[must_use]
        pub fn margins(&self, q: &[#scalar; #n]) -> [#krate::Margin<#scalar>; #count] {
            #fields
            #size
            #pose
            #angles
            #(#statements)*
            [#(#entries),*]
        }
    }
}

/// The function that names the branches of a measured arm by the signs of its table's margins.
pub fn table_branch(margins: &Margins, model: &Model, target: &Target) -> TokenStream {
    let straight = &margins.straight;
    let mut dimensions = Dimensions::default();
    dimensions.collect(straight);
    let dimensions = dimensions.items(model, target);
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate, lanes: false };
    let statements = straight.shared.iter().map(|e| writer.statement(*e));
    let parts = margins.factors.iter().filter_map(|factor| {
        let value = writer.write(factor.value);
        match factor.branching {
            Branching::Shoulder => Some(quote!(.with_shoulder(#krate::Shoulder::of_margin(#value)))),
            Branching::Elbow => Some(quote!(.with_elbow(#krate::Elbow::of_margin(#value)))),
            Branching::Wrist => Some(quote!(.with_wrist(#krate::Wrist::of_margin(#value)))),
            Branching::None | Branching::Root => None,
        }
    });
    let (entries, angles) = (entries(margins), angles(margins, target));
    quote! {
        /// The branch that a solution lies on: the signs that the margins of the table have at its joint values. Beside a
        /// singular pose the arm that was measured may have no solution of a name, or several.
        fn table_branch(target: &#krate::Pose<#scalar>, q: &[#scalar; #n]) -> #krate::Branch {
            #dimensions
            #entries
            #angles
            #(#statements)*
            #krate::Branch::NONE #(#parts)*
        }
    }
}

fn symbols(graph: &Graph, roots: &[Expr]) -> HashSet<Symbol> {
    let symbol = |e: Expr| match graph.node(e) {
        Node::Symbol(symbol) => Some(symbol),
        _ => None,
    };
    graph.reachable(roots).into_iter().filter_map(symbol).collect()
}

/// The value over the reach, as often as it has lengths.
fn scaled(writer: &Writer, factor: &Factor, reach: &Ident) -> TokenStream {
    let value = writer.write(factor.value);
    let simple = !matches!(writer.graph.node(factor.value), Node::Add(..) | Node::Sub(..));
    let value =
        if simple || factor.power == 0 || writer.bound.contains_key(&factor.value) { value } else { quote!((#value)) };
    match factor.power {
        0 => value,
        1 => quote!(#value / #reach),
        2 => quote!(#value / (#reach * #reach)),
        _ => quote!(#value / (#reach * #reach * #reach)),
    }
}

/// Statements for the entries of the tool's pose that the pivots read.
fn pose(margins: &Margins) -> TokenStream {
    let entries = entries(margins);
    if entries.is_empty() { entries } else { quote!(let target = self.forward(q); #entries) }
}

/// Statements for the entries of `target` that the pivots read.
fn entries(margins: &Margins) -> TokenStream {
    let reads = |input: Input| margins.pose.iter().any(|(_, read)| *read == input);
    let pattern = |input: Input| bound(&input.name(), reads(input));
    let (rows, position) = (Input::ROTATION, Input::POSITION);
    let rotation = rows.iter().flatten().any(|input| reads(*input)).then(|| {
        let rows = array(rows.map(|row| array(row.map(pattern))));
        quote!(let #rows = target.rotation;)
    });
    let translation = position.iter().any(|input| reads(*input)).then(|| {
        let entries = array(position.map(pattern));
        quote!(let #entries = target.translation;)
    });
    quote!(#rotation #translation)
}

/// Sines and cosines of the kernels' variables, and displacements.
fn angles(margins: &Margins, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let graph = &margins.straight.graph;
    let name = |slot: Slot| graph.leaf_name(slot).unwrap_or_default();
    let joints = (0..margins.joints.len()).map(|joint| bound(&format!("q{}", joint + 1), margins.reads(joint)));
    let part = |slot: Option<Slot>| {
        slot.map_or_else(
            || quote!(_),
            |slot| {
                let name = ident(&name(slot));
                quote!(#name)
            },
        )
    };
    let of = |variable: &Variable| {
        let joint = ident(&format!("q{}", variable.joint + 1));
        let angle = angle::sum([(joint, false)], variable.constant.neg(), target);
        (part(variable.sin), (part(variable.cos), angle))
    };
    let (sines, (cosines, angles)): (Vec<_>, (Vec<_>, Vec<_>)) = margins.variables.iter().map(of).unzip();
    let trigonometry = angle::sines(&sines, &cosines, &angles, target);
    let plane = margins.plane.as_ref().map(|plane| {
        let terms = plane.signs.iter().zip(1..).filter(|(sign, _)| **sign != 0.0).map(|(sign, number)| {
            let joint = ident(&format!("q{number}"));
            if *sign < 0.0 { quote!(- #joint) } else { quote!(+ #joint) }
        });
        let offset = angle::tokens(plane.offset, target);
        let [sin, cos] = [plane.sin, plane.cos].map(|slot| bound(&name(slot), margins.straight.reads(slot)));
        quote!(let (#sin, #cos) = #krate::math::sin_cos(#offset #(#terms)*);)
    });
    quote!(let [#(#joints),*] = *q; #trigonometry #plane)
}

fn doc(plan: &Plan, writer: &Writer, factors: &[Factor], reach: &Ident) -> String {
    let rows = if plan.task.goal == Goal::Pose { "" } else { ", of what the task asks for," };
    let given: Vec<String> = plan.task.given.joints().map(|(joint, _)| format!("q{}", joint + 1)).collect();
    let column = if given.is_empty() { String::new() } else { format!(" without {}", given.join(", ")) };
    let mut text = format!(
        "How far `q` is from each kind of singularity: `det J`{column}{rows} is a constant times the product. Each is 0 \
         exactly there, with opposite signs beside it, without a unit; `px`, `r11` are entries of `forward(q)`.\n\n",
    );
    for factor in factors {
        let value =
            scaled(writer, factor, reach).to_string().replace(" . ", ".").replace("( - (", "(-(").replace("( - ", "(-");
        let value = value.strip_prefix("- ").map_or(value.clone(), |rest| format!("-{rest}"));
        let value = value.strip_prefix("- ").map_or(value.clone(), |rest| format!("-{rest}"));
        let value = if value.len() > 70 { "the determinant of its equations".into() } else { format!("`{value}`") };
        text += &format!("- {}: {value}{}\n", factor.name, shifts(plan, &symbols(writer.graph, &[factor.value])));
    }
    text
}

/// The variable of a kernel where it is not the joint value itself: "; `t3` is `q3 + 87.3 deg`".
fn shifts(plan: &Plan, used: &HashSet<Symbol>) -> String {
    let shift = |joint: usize| {
        let (number, constant) = (joint + 1, lower::constant(plan, joint));
        let [plain, shifted] = [false, true].map(|shifted| {
            let of = |part| Symbol::from(Unknown { joint: Label::Arm(joint), part, shifted });
            used.contains(&of(Part::Sin)) || used.contains(&of(Part::Cos))
        });
        let variable = match (shifted, plain) {
            (true, _) => format!("`t{number}` is"),
            (_, true) => format!("`s{number}` and `c{number}` are of"),
            _ => return None,
        };
        (!constant.is_zero()).then(|| format!("; {variable} `q{number} {}`", angle::addend(constant.neg())))
    };
    (0..plan.joints()).filter_map(shift).collect()
}
