//! The dimensions of the arm as named constants.

use super::Target;
use super::docs;
use super::tokens::{ident, number};
use crate::lower::Straight;
use crate::model::{Convention, Model};
use crate::symbolic::{ConstantAngle, Dimension, Expr, Graph, Node, Symbol};
use indexmap::IndexMap;
use proc_macro2::TokenStream;
use quote::quote;

/// Dimensions in use, and their values.
#[derive(Debug, Clone, Default)]
pub struct Dimensions {
    used: IndexMap<Dimension, f64>,
}

impl Dimensions {
    /// Adds those that a program uses.
    pub fn collect(&mut self, straight: &Straight) {
        self.collect_from(&straight.graph, &straight.roots);
    }

    /// Adds those the roots of a graph use.
    pub fn collect_from(&mut self, graph: &Graph, roots: &[Expr]) {
        for e in graph.reachable(roots) {
            if let Node::Symbol(Symbol::Dimension(dimension, bits)) = graph.node(e) {
                self.used.insert(dimension, f64::from_bits(bits));
            }
        }
    }

    /// The constant items, in the order of the rows.
    pub fn items(&self, model: &Model, target: &Target) -> TokenStream {
        let scalar = target.scalar.tokens();
        let mut sorted: Vec<(Dimension, String, f64)> =
            self.used.iter().map(|(dimension, value)| (*dimension, dimension.to_string(), *value)).collect();
        sorted.sort_by_cached_key(|(dimension, name, _)| (dimension.number().unwrap_or(usize::MAX), name.clone()));
        let items = sorted.into_iter().map(|(dimension, name, value)| {
            let doc = docs::lines(&meaning(dimension, model));
            let (name, value) = (ident(&name), number(value));
            quote!(#doc const #name: #scalar = #value;)
        });
        quote!(#(#items)*)
    }
}

fn meaning(dimension: Dimension, model: &Model) -> String {
    let unit = model.length_unit.symbol();
    let of_row = |row: usize| {
        let convention = if model.convention == Convention::Modified { ", modified convention" } else { "" };
        format!("of row {}{convention}", row + 1)
    };
    let of_angle = |what: &str, angle: ConstantAngle| match angle {
        ConstantAngle::Alpha(row) => format!("{what} of the twist `alpha` {}.", of_row(row)),
        ConstantAngle::Theta(row) => format!("{what} of `theta` {}.", of_row(row)),
        ConstantAngle::RollPitchYaw(end, which) => {
            let angle = ["roll", "pitch", "yaw"].get(which).copied().unwrap_or_default();
            format!("{what} of the {angle} of the {} frame.", end.to_string().to_lowercase())
        }
        ConstantAngle::Phase(joint) => {
            format!("{what} of the angle between theta {joint} and the angle its equation gives.")
        }
        ConstantAngle::Turn(angle) => format!("{what} of {}, a constant turn between two joints.", angle.text()),
    };
    match dimension {
        Dimension::LinkLength(row) => format!("Link length `a` {}, {unit}.", of_row(row)),
        Dimension::LinkOffset(row) => format!("Link offset `d` {}, {unit}.", of_row(row)),
        Dimension::Origin(end, _) => format!("Of the {} frame, {unit}.", end.to_string().to_lowercase()),
        Dimension::Rotation(end, ..) => format!("Of the {} frame, dimensionless.", end.to_string().to_lowercase()),
        Dimension::Sin(angle) => of_angle("Sine", angle),
        Dimension::Cos(angle) => of_angle("Cosine", angle),
        Dimension::Intersection(..) | Dimension::IntersectionOnY => {
            format!("Where two axes meet, along one of them, {unit}.")
        }
        Dimension::MotorOffset(motor) => {
            format!("Value of motor {} where all joints are 0, rad (of a sliding joint {unit}).", motor + 1)
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::Options;
    use crate::generate;

    /// Joint 1 stands in row 2: its theta is another constant than that of the fixed row 1.
    #[test]
    fn each_constant_has_one_value() {
        let text = "name: mounted\nconvention: standard\nunits: {length: m, angle: deg}\n\
                    inverse: {task: planar_pose, redundant: q1}\njoints:\n\
                    - {type: fixed, a: 0, alpha: 0, d: 0, theta: 20}\n- {a: 1, alpha: 0, d: 0, theta: 33}\n"
            .to_owned()
            + &"- {a: 1, alpha: 0, d: 0, theta: 0}\n".repeat(3);
        let code = generate(&text, "mounted.yaml", &Options::new("Mounted")).unwrap().impls.to_string();
        for (name, value) in [("SIN_THETA1", 20.0_f64.to_radians().sin()), ("SIN_THETA2", 33.0_f64.to_radians().sin())]
        {
            let found: Vec<f64> = code
                .match_indices(&format!("const {name} : f64 = "))
                .filter_map(|(at, start)| code.get(at + start.len()..)?.split_whitespace().next()?.parse().ok())
                .collect();
            assert!(matches!(found[..], [one] if (one - value).abs() < 1e-15), "{name}: {found:?}");
        }
    }
}
