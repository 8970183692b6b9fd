//! The method `margins`: the factors of the Jacobian's determinant.

use super::block::Block;
use super::constants::Dimensions;
use super::tokens::{Writer, ident, integer};
use super::{Target, angle, docs};
use crate::model::{Angle, Model, Task};
use crate::solve::{Factor, Plan, margins as factors};
use crate::symbolic::{Expr, Graph, Node};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::HashSet;

/// Sine and cosine of the angle that `position_angle` asks for.
const ANGLE: [&str; 2] = ["sin_angle", "cos_angle"];

/// The method, and the dimensions it uses; nothing for a task that has none.
pub fn margins(model: &Model, plan: &Plan, target: &Target, dimensions: &mut Dimensions) -> TokenStream {
    let (graph, factors) = factors(plan);
    let roots: Vec<Expr> = factors.iter().map(|factor| factor.value).collect();
    if factors.is_empty() || !known(&graph, &roots, plan) {
        return TokenStream::new();
    }
    dimensions.collect(&graph, &roots);
    let used = symbols(&graph, &roots);
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let count = integer(factors.len());
    let reserved = used.iter().cloned().chain(["target", "q", "arm", "reach"].map(String::from));
    let mut block = Block::new(&graph, &roots, reserved);
    let fresh = block.bind(&roots);
    let statements = fresh.iter().map(|e| block.statement(*e, krate));
    let writer = Writer { graph: &graph, bound: &block.bound, krate };
    let bound = !model.parameters.is_empty();
    let reach = ident(if bound { "reach" } else { "REACH" });
    let entries = factors.iter().map(|factor| {
        let (name, value) = (&factor.name, scaled(&writer, factor, &reach));
        quote!(#krate::Margin::new(#name, #value))
    });
    let target_parts = target_parts(&used);
    // The expressions are those of the inverse, in which run-time parameters are fields of `arm`.
    let fields = used.iter().any(|name| name.starts_with("arm.")).then(|| quote!(let arm = self;));
    let size = (bound && factors.iter().any(|factor| factor.power > 0)).then(|| quote!(let reach = reach(self);));
    let angles = angles(plan, &used, target);
    let doc = docs::lines(&doc(plan, &writer, &factors, &reach));
    quote! {
        #doc
        #[must_use]
        pub fn margins(&self, q: &[#scalar; #n]) -> [#krate::Margin<#scalar>; #count] {
            #fields
            #size
            #target_parts
            #angles
            #(#statements)*
            [#(#entries),*]
        }
    }
}

/// Whether everything the factors read is a dimension, an entry of the tool's pose, or of a joint.
fn known(graph: &Graph, roots: &[Expr], plan: &Plan) -> bool {
    let entry = |name: &str| name.len() <= 3 && name.starts_with(['r', 'p']);
    let of_joint = |name: &str| {
        let part = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let number = name.get(part.len()..).and_then(|digits| digits.parse::<usize>().ok());
        let own = number.is_some_and(|number| (1..=plan.joints()).contains(&number));
        own && ["q", "s", "c", "sin_t", "cos_t"].contains(&part)
    };
    let of_plane = |name: &str| plan.task.angle.is_some() && ANGLE.contains(&name);
    graph.reachable(roots).into_iter().all(|e| match graph.node(e) {
        Node::Symbol(symbol) => {
            let name = symbol.name.as_str();
            of_plane(name) || symbol.value.is_some() || name.starts_with("arm.") || entry(name) || of_joint(name)
        }
        _ => true,
    })
}

fn symbols(graph: &Graph, roots: &[Expr]) -> HashSet<String> {
    let symbol = |e: Expr| match graph.node(e) {
        Node::Symbol(symbol) => Some(symbol.name),
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

/// What the pivots read of the tool's pose.
fn target_parts(used: &HashSet<String>) -> TokenStream {
    let pattern = |name: String| if used.contains(&name) { ident(&name) } else { ident(&format!("_{name}")) };
    let any = |names: &[String]| names.iter().any(|name| used.contains(name));
    let rows: Vec<Vec<String>> = (1..=3).map(|i| (1..=3).map(|j| format!("r{i}{j}")).collect()).collect();
    let position = ["px", "py", "pz"].map(String::from);
    let rotation = any(&rows.concat()).then(|| {
        let rows = rows.iter().map(|row| {
            let entries = row.iter().cloned().map(pattern);
            quote!([#(#entries),*])
        });
        quote!(let [#(#rows),*] = target.rotation;)
    });
    let translation = any(&position).then(|| {
        let entries = position.map(pattern);
        quote!(let [#(#entries),*] = target.translation;)
    });
    match (&rotation, &translation) {
        (None, None) => TokenStream::new(),
        _ => quote!(let target = self.forward(q); #rotation #translation),
    }
}

/// Sines and cosines of the kernels' variables, and strokes.
fn angles(plan: &Plan, used: &HashSet<String>, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let (mut sines, mut cosines, mut arguments) = (Vec::new(), Vec::new(), Vec::new());
    let mut joints = Vec::new();
    let plane = plan.task.angle.as_ref().filter(|_| ANGLE.iter().any(|name| used.contains(*name)));
    let pitches = |index: usize| plane.is_some_and(|(signs, _)| signs.get(index).is_some_and(|sign| *sign != 0.0));
    for index in 0..plan.joints() {
        let number = index + 1;
        let constant = constant(plan, index);
        let name = format!("q{number}");
        let find = |names: [String; 2]| names.into_iter().find(|name| used.contains(name));
        let sin = find([format!("s{number}"), format!("sin_t{number}")]);
        let cos = find([format!("c{number}"), format!("cos_t{number}")]);
        let turns = sin.is_some() || cos.is_some();
        let joint = ident(&name);
        let unused = ident(&format!("_{name}"));
        joints.push(if turns || used.contains(&name) || pitches(index) { quote!(#joint) } else { quote!(#unused) });
        if !turns {
            continue;
        }
        let part = |name: Option<String>| {
            name.map_or_else(
                || quote!(_),
                |name| {
                    let name = ident(&name);
                    quote!(#name)
                },
            )
        };
        sines.push(part(sin));
        cosines.push(part(cos));
        arguments.push(if constant.is_zero() {
            quote!(#joint)
        } else {
            let negative = constant.rad() > 0.0;
            let size = angle::tokens(if negative { constant } else { constant.neg() }, target);
            if negative { quote!(#joint - #size) } else { quote!(#joint + #size) }
        });
    }
    let trigonometry = match arguments.as_slice() {
        [] => TokenStream::new(),
        [_] => quote!(let (#(#sines),*, #(#cosines),*) = #krate::math::sin_cos(#(#arguments),*);),
        _ => quote!(let ([#(#sines),*], [#(#cosines),*]) = #krate::math::sin_cos_array([#(#arguments),*]);),
    };
    let plane = plane.map(|(signs, offset)| {
        let terms = signs.iter().zip(1..).filter(|(sign, _)| **sign != 0.0).map(|(sign, number)| {
            let joint = ident(&format!("q{number}"));
            if *sign < 0.0 { quote!(- #joint) } else { quote!(+ #joint) }
        });
        let offset = angle::tokens(*offset, target);
        let [sin, cos] = ANGLE.map(|name| if used.contains(name) { ident(name) } else { ident(&format!("_{name}")) });
        quote!(let (#sin, #cos) = #krate::math::sin_cos(#offset #(#terms)*);)
    });
    quote!(let [#(#joints),*] = *q; #trigonometry #plane)
}

fn doc(plan: &Plan, writer: &Writer, factors: &[Factor], reach: &Ident) -> String {
    let rows = if plan.task.task == Task::Pose { "" } else { ", of what the task asks for," };
    let column = plan.task.locked.as_ref().map(|locked| format!(" without q{}", locked.joint + 1)).unwrap_or_default();
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

/// What a kernel's variable is that is not the joint value itself: "; `t3 = q3 +87.3 deg`".
fn shifts(plan: &Plan, used: &HashSet<String>) -> String {
    let shift = |joint: usize| {
        let (number, constant) = (joint + 1, constant(plan, joint));
        let [sin, cos] = ["sin_t", "cos_t"].map(|part| used.contains(&format!("{part}{number}")));
        let plain = ["s", "c"].iter().any(|part| used.contains(&format!("{part}{number}")));
        let variable = match (sin || cos, plain) {
            (true, _) => format!("`t{number}` is"),
            (_, true) => format!("`s{number}` and `c{number}` are of"),
            _ => return None,
        };
        let degrees = -constant.rad().to_degrees();
        (!constant.is_zero()).then(|| format!("; {variable} `q{number}` {degrees:+.6} deg"))
    };
    (0..plan.joints()).filter_map(shift).collect()
}

/// What a kernel's variable is less than the joint value.
fn constant(plan: &Plan, joint: usize) -> Angle {
    let slot = plan.slots.iter().position(|slot| slot.joint == Some(joint));
    slot.and_then(|slot| plan.values.get(slot)).map_or(Angle::ZERO, |value| value.constant)
}
