//! Which expressions become `let` statements, under which names.

use crate::symbolic::{Expr, Graph, Node};
use std::collections::{HashMap, HashSet};

/// The names under which expressions are bound.
pub type Names = HashMap<Expr, String>;

/// Plans the bindings of a set of roots: what is used twice, or has a name and is more than a sign.
pub struct Block<'a> {
    graph: &'a Graph,
    uses: HashMap<Expr, usize>,
    taken: HashSet<String>,
    /// What is bound so far.
    pub bound: Names,
}

impl<'a> Block<'a> {
    /// For all roots of a function; `reserved` names are in use already.
    pub fn new(graph: &'a Graph, roots: &[Expr], reserved: impl IntoIterator<Item = String>) -> Self {
        let mut uses = HashMap::new();
        for root in roots {
            *uses.entry(graph.strip(*root).0).or_default() += 1;
        }
        for e in graph.reachable(roots) {
            // A square names its operand twice but is one use of it.
            let mut operands: Vec<Expr> = graph.operands(e).iter().map(|x| graph.strip(*x).0).collect();
            if matches!(graph.node(e), Node::Neg(_)) {
                continue;
            }
            operands.dedup_by(|a, b| a == b && matches!(graph.node(*a), Node::Symbol(_)));
            for operand in operands {
                *uses.entry(operand).or_default() += 1;
            }
        }
        let mut taken: HashSet<String> = reserved.into_iter().collect();
        for e in graph.reachable(roots) {
            if let Node::Symbol(symbol) = graph.node(e) {
                taken.insert(symbol.name);
            }
        }
        Block { graph, uses, taken, bound: Names::new() }
    }

    /// Whether an expression is to be bound.
    fn wanted(&self, e: Expr) -> bool {
        if self.graph.constant(e).is_some() {
            return false;
        }
        match self.graph.node(e) {
            Node::Number(_) | Node::Symbol(_) | Node::Neg(_) => false,
            Node::Sqrt(_) => true,
            _ => self.uses.get(&e).is_some_and(|n| *n >= 2),
        }
    }

    /// Binds what the roots need and is not bound yet, in evaluation order. Returns the expressions to define.
    pub fn bind(&mut self, roots: &[Expr]) -> Vec<Expr> {
        let mut fresh = Vec::new();
        for e in self.graph.reachable(roots) {
            if self.wanted(e) && !self.bound.contains_key(&e) {
                let name = self.fresh_name(e);
                self.bound.insert(e, name);
                fresh.push(e);
            }
        }
        fresh
    }

    fn fresh_name(&mut self, e: Expr) -> String {
        let base = match self.graph.given_name(e) {
            Some(name) => name.to_string(),
            None => self.structural_name(e),
        };
        let mut name = base.clone();
        let mut count = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{base}_{count}");
            count += 1;
        }
        name
    }

    /// A product of short names is called after its factors; a sum after its larger parts.
    fn structural_name(&self, e: Expr) -> String {
        let part = |x: Expr| {
            let x = self.graph.strip(x).0;
            match (self.graph.node(x), self.bound.get(&x)) {
                (_, Some(name)) => Some(name.clone()),
                (Node::Symbol(symbol), _) => {
                    let name = symbol.name.rsplit('.').next().unwrap_or_default();
                    Some(name.to_lowercase())
                }
                _ => None,
            }
        };
        match self.graph.node(e) {
            Node::Mul(a, b) => match (part(a), part(b)) {
                (Some(a), Some(b)) if a == b => format!("{a}_squared"),
                (Some(a), Some(b)) if a.len() + b.len() <= 16 => format!("{a}_{b}"),
                _ => "product".into(),
            },
            Node::Add(..) => "sum".into(),
            Node::Sub(..) => "difference".into(),
            Node::Sqrt(_) => "length".into(),
            _ => "value".into(),
        }
    }
}
