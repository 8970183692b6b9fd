//! The dimensions of the arm as named constants.

use super::Target;
use super::docs;
use super::tokens::{ident, number};
use crate::lower::Straight;
use crate::model::{Convention, Model};
use crate::symbolic::{Expr, Graph, Node, Symbol};
use indexmap::IndexMap;
use proc_macro2::TokenStream;
use quote::quote;

/// Dimensions in use, by name.
#[derive(Debug, Clone, Default)]
pub struct Dimensions {
    used: IndexMap<String, f64>,
}

impl Dimensions {
    /// Adds those that a program uses.
    pub fn collect(&mut self, straight: &Straight) {
        self.collect_from(&straight.graph, &straight.roots);
    }

    /// Adds those the roots of a graph use.
    pub fn collect_from(&mut self, graph: &Graph, roots: &[Expr]) {
        for e in graph.reachable(roots) {
            if let Node::Symbol(Symbol::Dimension(name, bits)) = graph.node(e) {
                self.used.insert(name, f64::from_bits(bits));
            }
        }
    }

    /// The constant items, in the order of the rows.
    pub fn items(&self, model: &Model, target: &Target) -> TokenStream {
        let scalar = target.scalar.tokens();
        let mut sorted: Vec<(&String, f64)> = self.used.iter().map(|(name, value)| (name, *value)).collect();
        sorted.sort_by_key(|(name, _)| (row(name).unwrap_or(usize::MAX), (*name).clone()));
        let items = sorted.into_iter().map(|(name, value)| {
            let doc = docs::lines(&meaning(name, model));
            let (name, value) = (ident(name), number(value));
            quote!(#doc const #name: #scalar = #value;)
        });
        quote!(#(#items)*)
    }
}

fn row(name: &str) -> Option<usize> {
    let digits: String = name.chars().rev().take_while(char::is_ascii_digit).collect();
    digits.chars().rev().collect::<String>().parse().ok()
}

fn meaning(name: &str, model: &Model) -> String {
    let unit = model.length_unit.symbol();
    let text = |row: usize, what: &str, unit: &str| {
        let convention = match model.convention {
            Convention::Standard => "",
            Convention::Modified => ", modified convention",
        };
        format!("{what} of row {row}{convention}{unit}.")
    };
    let length = format!(", {unit}");
    let split = name.trim_end_matches(|c: char| c.is_ascii_digit());
    match (split, row(name)) {
        ("A", Some(n)) => text(n, "Link length `a`", &length),
        ("D", Some(n)) => text(n, "Link offset `d`", &length),
        ("SIN_ALPHA", Some(n)) => text(n, "Sine of the twist `alpha`", ""),
        ("COS_ALPHA", Some(n)) => text(n, "Cosine of the twist `alpha`", ""),
        ("SIN_THETA", Some(n)) => text(n, "Sine of `theta`", ""),
        ("COS_THETA", Some(n)) => text(n, "Cosine of `theta`", ""),
        ("SIN_PHASE", Some(n)) => format!("Sine of the angle between theta {n} and the angle its equation gives."),
        ("COS_PHASE", Some(n)) => format!("Cosine of the angle between theta {n} and the angle its equation gives."),
        ("OFFSET", Some(n)) => format!("Value of motor {n} where all joints are 0, rad (of a sliding joint {unit})."),
        _ if name.starts_with("BASE") => format!("Of the base frame{}.", frame_unit(name, unit)),
        _ if name.starts_with("TOOL") => format!("Of the tool frame{}.", frame_unit(name, unit)),
        _ if name.starts_with("MEET") => format!("Where two axes meet, along one of them, {unit}."),
        _ => "A constant turn between the frames of two joints.".into(),
    }
}

fn frame_unit(name: &str, unit: &str) -> String {
    if name.ends_with(['X', 'Y', 'Z']) { format!(", {unit}") } else { ", dimensionless".into() }
}
