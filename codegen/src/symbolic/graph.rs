//! The arena of expressions: their nodes, values and names.

use super::Symbol;
use indexmap::IndexSet;
use std::collections::HashMap;

/// An expression: an id into a [`Graph`]. Equal ids are equal expressions of the same graph.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(pub(super) u32);

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
    pub(super) nodes: IndexSet<Node>,
    constant: Vec<Option<f64>>,
    names: HashMap<Expr, String>,
    suggested: HashMap<Expr, String>,
    pub(super) products: Products,
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

    pub(super) fn intern(&mut self, node: Node, value: Option<f64>) -> Expr {
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

    /// Names the components of a vector: the name and x, y or z.
    pub fn name_each(&mut self, vector: &[Expr], name: &str) {
        for (e, axis) in vector.iter().zip(["x", "y", "z"]) {
            self.name(*e, format!("{name}{axis}"));
        }
    }

    /// Names a shared expression, replacing an earlier name: for one that turns out to have a role of its own.
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

    /// Suggests names for the components of a vector.
    pub fn suggest_each(&mut self, vector: &[Expr], name: &str) {
        for (e, axis) in vector.iter().zip(["x", "y", "z"]) {
            self.suggest(*e, format!("{name}{axis}"));
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

    /// Returns the graph for a function that calls the arm `owner`. The arm's fields are the run-time parameters.
    pub fn with_owner(self, owner: &'static str) -> Self {
        Graph { owner, ..self }
    }

    /// The symbol of a run-time parameter: a field of the arm, so that its name is in nobody's way.
    pub fn field(&self, parameter: &str) -> Symbol {
        Symbol::Parameter { owner: self.owner, field: parameter.to_string() }
    }

    /// Returns true for a run-time parameter.
    pub fn is_field(&self, e: Expr) -> bool {
        matches!(self.node(e), Node::Symbol(Symbol::Parameter { .. }))
    }

    /// The name of a leaf.
    pub fn leaf_name(&self, e: Expr) -> Option<String> {
        match self.node(e) {
            Node::Symbol(symbol) => Some(symbol.name()),
            _ => None,
        }
    }

    /// The expression without its leading negation, and whether there was one.
    pub fn strip(&self, e: Expr) -> (Expr, bool) {
        match self.node(e) {
            Node::Neg(inner) => (inner, true),
            _ => (e, false),
        }
    }
}
