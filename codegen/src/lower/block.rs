//! Which expressions become `let` statements, under which names.

use crate::symbolic::{Expr, Graph, Node};
use std::collections::{HashMap, HashSet};

/// The names under which expressions are bound.
pub type Names = HashMap<Expr, String>;

/// Longest name that is spelled out of the parts of an expression.
const LONGEST: usize = 36;

/// Plans the bindings of a set of roots: what is used twice, or has a name and is more than a sign.
pub struct Block<'a> {
    graph: &'a Graph,
    uses: HashMap<Expr, usize>,
    taken: HashSet<String>,
    partial_sums: HashMap<Expr, String>,
    /// Names bound so far.
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
                taken.insert(symbol.name());
            }
        }
        Block { graph, uses, taken, partial_sums: partial_sums(graph, roots), bound: Names::new() }
    }

    /// Returns true if an expression is to be bound.
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
        let given = |e: Expr| self.graph.given_name(e).map(str::to_string);
        let reversed = || self.graph.reversed(e).and_then(given).map(|name| format!("minus_{name}"));
        let owned = || self.partial_sums.get(&e).cloned();
        // What has no name is called after its parts; where that is long, by a word.
        let spelled = || self.spelled(e).filter(|name| name.len() <= LONGEST);
        let word = if matches!(self.graph.node(e), Node::Sqrt(_)) { "length" } else { "term" };
        let base = given(e).or_else(reversed).or_else(owned).or_else(spelled).unwrap_or_else(|| word.into());
        let mut name = base.clone();
        let mut count = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{base}_{count}");
            count += 1;
        }
        name
    }

    /// An expression spelled out: `a_b`, `a_plus_b`, `a_minus_b`.
    fn spelled(&self, e: Expr) -> Option<String> {
        let part = |x: Expr| {
            let x = self.graph.strip(x).0;
            match (self.bound.get(&x), self.graph.node(x)) {
                (Some(name), _) => Some(name.clone()),
                (None, Node::Symbol(symbol)) => Some(symbol.name().to_lowercase()),
                (None, Node::Number(bits)) if f64::from_bits(bits) == 0.5 => Some("half".into()),
                (None, Node::Number(bits)) if f64::from_bits(bits) == 2.0 => Some("twice".into()),
                (None, Node::Number(_)) => None,
                (None, _) => self.spelled(x),
            }
        };
        match self.graph.node(e) {
            Node::Mul(a, b) => match (part(a)?, part(b)?) {
                (a, b) if a == b => Some(format!("{a}_squared")),
                (a, b) => Some(format!("{a}_{b}")),
            },
            Node::Add(a, b) => Some(format!("{}_plus_{}", part(a)?, part(b)?)),
            Node::Sub(a, b) => Some(format!("{}_minus_{}", part(a)?, part(b)?)),
            Node::Sqrt(a) => Some(format!("root_{}", part(a)?)),
            _ => None,
        }
    }
}

/// The partial sums of named expressions, and the names that these give them: of `p_1x` the part `p_1x_part`, of a length
/// `rho3` its square `rho3_squared`.
fn partial_sums(graph: &Graph, roots: &[Expr]) -> HashMap<Expr, String> {
    let mut owned = HashMap::new();
    let is_sum = |e: Expr| matches!(graph.node(e), Node::Add(..) | Node::Sub(..));
    for owner in graph.reachable(roots) {
        let Some(name) = graph.given_name(owner) else { continue };
        let mut stack = match graph.node(owner) {
            Node::Sqrt(a) => {
                owned.entry(a).or_insert_with(|| format!("{name}_squared"));
                Vec::new()
            }
            Node::Add(a, b) | Node::Sub(a, b) => vec![a, b],
            _ => Vec::new(),
        };
        while let Some(part) = stack.pop() {
            let part = graph.strip(part).0;
            if is_sum(part) && graph.given_name(part).is_none() {
                owned.entry(part).or_insert_with(|| format!("{name}_part"));
                stack.extend(graph.operands(part));
            }
        }
    }
    owned
}
