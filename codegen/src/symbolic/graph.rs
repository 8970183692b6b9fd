//! The arena of expressions and its folding constructors.

use crate::model::Length;
use indexmap::IndexSet;
use std::collections::HashMap;

/// An expression: an id into a [`Graph`]. Equal ids are equal expressions of the same graph.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(u32);

impl Expr {
    /// Zero, the first node of every graph.
    pub const ZERO: Expr = Expr(0);
    /// One, the second node of every graph.
    pub const ONE: Expr = Expr(1);

    /// Its place in the arena: below [`Graph::size`].
    pub fn at(self) -> usize {
        self.0 as usize
    }
}

/// A named leaf.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Symbol {
    /// The name it has in the generated code.
    pub name: String,
    /// The value's bits if it is known when the code is generated (a dimension of the arm).
    pub value: Option<u64>,
}

/// One node. Negation is kept outermost, so that it is written once or folded into a difference.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number, by its bits.
    Number(u64),
    /// A named dimension or a run-time value.
    Symbol(Symbol),
    /// `-a`
    Neg(Expr),
    /// `a + b`
    Add(Expr, Expr),
    /// `a - b`
    Sub(Expr, Expr),
    /// `a * b`
    Mul(Expr, Expr),
    /// The square root.
    Sqrt(Expr),
}

/// Where the constant factor of a product goes. Both forms are equal; which one is cheaper depends on what else is
/// needed, so functions are built in both and the cheaper is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Products {
    /// `(k a) b` stays as built.
    AsBuilt,
    /// `(k a) b` becomes `k (a b)`, so that `a b` can be shared.
    ConstantsOutward,
}

/// The arena. Deterministic: the same calls give the same ids.
#[derive(Debug, Clone)]
pub struct Graph {
    nodes: IndexSet<Node>,
    constant: Vec<Option<f64>>,
    names: HashMap<Expr, String>,
    suggested: HashMap<Expr, String>,
    products: Products,
    owner: &'static str,
}

impl Default for Graph {
    fn default() -> Self {
        Graph::new(Products::AsBuilt)
    }
}

impl Graph {
    /// A graph that holds zero and one.
    pub fn new(products: Products) -> Self {
        let mut graph = Graph {
            nodes: IndexSet::new(),
            constant: Vec::new(),
            names: HashMap::new(),
            suggested: HashMap::new(),
            products,
            owner: "self",
        };
        graph.intern(Node::Number(0.0f64.to_bits()), Some(0.0));
        graph.intern(Node::Number(1.0f64.to_bits()), Some(1.0));
        graph
    }

    fn intern(&mut self, node: Node, value: Option<f64>) -> Expr {
        let (index, fresh) = self.nodes.insert_full(node);
        if fresh {
            self.constant.push(value);
        }
        Expr(u32::try_from(index).unwrap_or(u32::MAX))
    }

    /// The number of expressions.
    pub fn size(&self) -> usize {
        self.nodes.len()
    }

    /// The node of an expression.
    pub fn node(&self, e: Expr) -> Node {
        self.nodes.get_index(e.at()).cloned().unwrap_or(Node::Number(0))
    }

    /// The value of an expression made of numbers and dimensions alone.
    pub fn constant(&self, e: Expr) -> Option<f64> {
        self.constant.get(e.at()).copied().flatten()
    }

    /// Gives a shared expression the name it will have in the generated code. The first name stays.
    pub fn name(&mut self, e: Expr, name: impl Into<String>) -> Expr {
        let bare = self.strip(e).0;
        if matches!(self.node(bare), Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Sqrt(_)) {
            self.names.entry(bare).or_insert_with(|| name.into());
        }
        e
    }

    /// The same, replacing an earlier name: for what turns out to have a role of its own.
    pub fn rename(&mut self, e: Expr, name: impl Into<String>) {
        let bare = self.strip(e).0;
        self.names.remove(&bare);
        self.name(bare, name);
    }

    /// The name of an expression that is given none: for a partial sum, the vector that it belongs to. The first stays.
    pub fn suggest(&mut self, e: Expr, name: impl Into<String>) {
        let bare = self.strip(e).0;
        if matches!(self.node(bare), Node::Add(..) | Node::Sub(..)) {
            self.suggested.entry(bare).or_insert_with(|| name.into());
        }
    }

    /// The name an expression was given, else the one that was suggested.
    pub fn given_name(&self, e: Expr) -> Option<&str> {
        self.names.get(&e).or_else(|| self.suggested.get(&e)).map(String::as_str)
    }

    /// Of `a - b` the expression `b - a`, if it is in the graph.
    pub fn reversed(&self, e: Expr) -> Option<Expr> {
        let Node::Sub(a, b) = self.node(e) else { return None };
        let index = self.nodes.get_index_of(&Node::Sub(b, a))?;
        u32::try_from(index).ok().map(Expr)
    }

    /// A number.
    pub fn number(&mut self, value: f64) -> Expr {
        if value == 0.0 {
            return Expr::ZERO;
        }
        if value < 0.0 {
            let positive = self.number(-value);
            return self.neg(positive);
        }
        self.intern(Node::Number(value.to_bits()), Some(value))
    }

    /// A named dimension of the arm; zero if its value is zero.
    pub fn dimension(&mut self, name: impl Into<String>, value: f64) -> Expr {
        if value == 0.0 {
            return Expr::ZERO;
        }
        self.intern(Node::Symbol(Symbol { name: name.into(), value: Some(value.to_bits()) }), Some(value))
    }

    /// The same graph for a function in which the arm, whose fields are the run-time parameters, is called `owner`.
    pub fn with_owner(self, owner: &'static str) -> Self {
        Graph { owner, ..self }
    }

    /// The symbol of a run-time parameter: a field of the arm, so that its name is in nobody's way.
    pub fn field(&self, parameter: &str) -> String {
        format!("{}.{parameter}", self.owner)
    }

    /// Whether an expression is a run-time parameter.
    pub fn is_field(&self, e: Expr) -> bool {
        let prefix = self.field("");
        matches!(self.node(e), Node::Symbol(symbol) if symbol.name.starts_with(&prefix))
    }

    /// The name of a leaf.
    pub fn leaf_name(&self, e: Expr) -> Option<String> {
        match self.node(e) {
            Node::Symbol(symbol) => Some(symbol.name),
            _ => None,
        }
    }

    /// A length of the arm: a dimension, or a multiple of a run-time parameter, which is never taken for zero.
    pub fn length(&mut self, name: impl Into<String>, length: &Length) -> Expr {
        match length {
            Length::Constant(value) => self.dimension(name, *value),
            Length::Multiple { factor, parameter, .. } => {
                let value = self.symbol(self.field(parameter));
                let factor = self.number(*factor);
                self.mul(factor, value)
            }
        }
    }

    /// A run-time value.
    pub fn symbol(&mut self, name: impl Into<String>) -> Expr {
        self.intern(Node::Symbol(Symbol { name: name.into(), value: None }), None)
    }

    /// The expression without its leading negation, and whether there was one.
    pub fn strip(&self, e: Expr) -> (Expr, bool) {
        match self.node(e) {
            Node::Neg(inner) => (inner, true),
            _ => (e, false),
        }
    }

    /// `-a`
    pub fn neg(&mut self, a: Expr) -> Expr {
        if a == Expr::ZERO {
            return a;
        }
        match self.node(a) {
            Node::Neg(inner) => inner,
            Node::Sub(x, y) => self.sub(y, x),
            _ => {
                let value = self.constant(a).map(|v| -v);
                self.intern(Node::Neg(a), value)
            }
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.strip(a), self.strip(b)) {
            _ if a == Expr::ZERO => b,
            _ if b == Expr::ZERO => a,
            ((a, true), (b, true)) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            ((_, false), (b, true)) => self.sub(a, b),
            ((a, true), (_, false)) => self.sub(b, a),
            _ => {
                let known = [(a, b), (b, a)].map(|(a, b)| self.known(a, b, Node::Sub));
                if let Some(known) = known.into_iter().flatten().next() {
                    return known;
                }
                let (a, b) = (a.min(b), a.max(b));
                let value = self.both(a, b, |x, y| x + y);
                self.intern(Node::Add(a, b), value)
            }
        }
    }

    /// `a - b`
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.strip(a), self.strip(b)) {
            _ if a == b => Expr::ZERO,
            _ if b == Expr::ZERO => a,
            _ if a == Expr::ZERO => self.neg(b),
            (_, (b, true)) => self.add(a, b),
            ((a, true), (b, false)) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            _ => {
                let value = self.both(a, b, |x, y| x - y);
                // Dimensions that cancel (d4 - d4 of another row) are structure, not rounding.
                if value.is_some_and(|v| v.abs() <= 1e-14 * self.both(a, b, |x, y| x.abs() + y.abs()).unwrap_or(0.0)) {
                    return Expr::ZERO;
                }
                let known = self.known(a, b, |a, b| Node::Add(a.min(b), a.max(b)));
                known.unwrap_or_else(|| self.intern(Node::Sub(a, b), value))
            }
        }
    }

    /// `k + (x - y)` is `k - (y - x)` to the bit where `k` is a constant other than zero: the one that is in the graph.
    fn known(&self, constant: Expr, b: Expr, node: impl Fn(Expr, Expr) -> Node) -> Option<Expr> {
        self.constant(constant).filter(|value| *value != 0.0)?;
        let index = self.nodes.get_index_of(&node(constant, self.reversed(b)?))?;
        u32::try_from(index).ok().map(Expr)
    }

    /// `a * b`
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        let ((a, na), (b, nb)) = (self.strip(a), self.strip(b));
        let product = if a == Expr::ZERO || b == Expr::ZERO {
            Expr::ZERO
        } else if a == Expr::ONE {
            b
        } else if b == Expr::ONE {
            a
        } else {
            self.product(a, b)
        };
        if na != nb { self.neg(product) } else { product }
    }

    fn product(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = match (self.constant(a).is_some(), self.constant(b).is_some()) {
            (false, true) => (b, a),
            (true, false) => (a, b),
            _ => (a.min(b), a.max(b)),
        };
        if self.products == Products::ConstantsOutward {
            for (factor, other) in [(a, b), (b, a)] {
                if let Node::Mul(k, rest) = self.node(factor)
                    && self.constant(k).is_some()
                    && self.constant(rest).is_none()
                {
                    if self.constant(other).is_some() {
                        break;
                    }
                    let inner = self.mul(rest, other);
                    return self.mul(k, inner);
                }
            }
        }
        let value = self.both(a, b, |x, y| x * y);
        self.intern(Node::Mul(a, b), value)
    }

    /// Length of a vector: `sqrt(x^2 + ...)`; a single component keeps its sign folded away.
    pub fn norm(&mut self, components: &[Expr]) -> Expr {
        let parts: Vec<Expr> = components.iter().copied().filter(|e| *e != Expr::ZERO).collect();
        if parts.is_empty() {
            return Expr::ZERO;
        }
        if let [one] = parts.as_slice()
            && let Some(value) = self.constant(*one)
        {
            return if value < 0.0 { self.neg(*one) } else { *one };
        }
        let mut sum = Expr::ZERO;
        for part in parts {
            let square = self.mul(part, part);
            sum = self.add(sum, square);
        }
        let value = self.constant(sum).map(f64::sqrt);
        self.intern(Node::Sqrt(sum), value)
    }

    fn both(&self, a: Expr, b: Expr, f: impl Fn(f64, f64) -> f64) -> Option<f64> {
        Some(f(self.constant(a)?, self.constant(b)?))
    }

    /// The operands of an expression.
    pub fn operands(&self, e: Expr) -> Vec<Expr> {
        match self.node(e) {
            Node::Number(_) | Node::Symbol(_) => Vec::new(),
            Node::Neg(a) | Node::Sqrt(a) => vec![a],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) => vec![a, b],
        }
    }

    /// Everything the roots are made of, each once, in evaluation order.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        // Operands stand before what is made of them.
        let end = roots.iter().map(|root| root.at() + 1).max().unwrap_or(0).min(self.nodes.len());
        let mut seen = vec![false; end];
        let mut found = Vec::new();
        let mut stack = roots.to_vec();
        while let Some(e) = stack.pop() {
            if let Some(mark) = seen.get_mut(e.at())
                && !*mark
            {
                *mark = true;
                found.push(e);
                match self.nodes.get_index(e.at()) {
                    Some(Node::Neg(a) | Node::Sqrt(a)) => stack.push(*a),
                    Some(Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b)) => stack.extend([*a, *b]),
                    Some(Node::Number(_) | Node::Symbol(_)) | None => {}
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// The value under an assignment of the run-time symbols, by name. A symbol without a value counts as zero.
    pub fn evaluate(&self, roots: &[Expr], assignment: &HashMap<String, f64>) -> Vec<f64> {
        let mut values: HashMap<Expr, f64> = HashMap::new();
        for e in self.reachable(roots) {
            let of = |x: Expr| values.get(&x).copied().unwrap_or(0.0);
            let value = match self.node(e) {
                Node::Number(bits) => f64::from_bits(bits),
                Node::Symbol(s) => {
                    s.value.map(f64::from_bits).or_else(|| assignment.get(&s.name).copied()).unwrap_or(0.0)
                }
                Node::Neg(a) => -of(a),
                Node::Sqrt(a) => of(a).sqrt(),
                Node::Add(a, b) => of(a) + of(b),
                Node::Sub(a, b) => of(a) - of(b),
                Node::Mul(a, b) => of(a) * of(b),
            };
            values.insert(e, value);
        }
        roots.iter().map(|e| values.get(e).copied().unwrap_or(0.0)).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn folding_is_in_the_constructors() {
        let mut g = Graph::default();
        let (x, y) = (g.symbol("x"), g.symbol("y"));
        assert_eq!(g.mul(Expr::ZERO, x), Expr::ZERO);
        assert_eq!(g.mul(x, Expr::ONE), x);
        assert_eq!(g.add(x, Expr::ZERO), x);
        assert_eq!(g.sub(x, x), Expr::ZERO);
        assert_eq!(g.add(x, y), g.add(y, x));
        let (nx, ny) = (g.neg(x), g.neg(y));
        assert_eq!(g.neg(nx), x);
        assert_eq!(g.mul(nx, ny), g.mul(x, y));
        assert_eq!(g.add(x, ny), g.sub(x, y));
        let d = g.sub(x, y);
        assert_eq!(g.neg(d), g.sub(y, x));
        let (k, e) = (g.dimension("K", 2.0), g.sub(y, x));
        assert_eq!(g.sub(k, d), g.add(k, e));
    }

    #[test]
    fn cancelling_dimensions_fold_to_zero() {
        let mut g = Graph::default();
        let (a, b) = (g.dimension("D4", 0.1), g.dimension("D6", 0.1));
        assert_eq!(g.sub(a, b), Expr::ZERO);
        assert_eq!(g.dimension("A1", 0.0), Expr::ZERO);
    }

    #[test]
    fn constants_move_outward_only_when_asked() {
        for (products, shared) in [(Products::AsBuilt, false), (Products::ConstantsOutward, true)] {
            let mut g = Graph::new(products);
            let (k, x, y) = (g.dimension("D6", 0.3), g.symbol("x"), g.symbol("y"));
            let xy = g.mul(x, y);
            let kx = g.mul(k, x);
            let kxy = g.mul(kx, y);
            assert_eq!(g.operands(kxy).contains(&xy), shared);
        }
    }

    #[test]
    fn evaluation_follows_the_graph() {
        let mut g = Graph::default();
        let (x, y, k) = (g.symbol("x"), g.symbol("y"), g.dimension("K", 2.0));
        let sum = g.add(x, y);
        let e = g.mul(k, sum);
        let values = g.evaluate(&[e], &HashMap::from([("x".into(), 3.0), ("y".into(), 4.0)]));
        assert_eq!(values, [14.0]);
    }
}
