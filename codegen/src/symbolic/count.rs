//! Cost of an expression: the operations left at run time.

use super::{Expr, Graph, Node};
use std::fmt;

/// Operations of a set of expressions, each shared subexpression counted once. Signs are free; what is made of
/// dimensions alone is folded by the compiler and costs nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Calls of `sin_cos`.
    pub sin_cos: usize,
}

impl Cost {
    /// Additions and multiplications together.
    pub fn arithmetic(&self) -> usize {
        self.additions + self.multiplications
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Cost { additions, multiplications, sin_cos, .. } = self;
        write!(f, "{additions} additions, {multiplications} multiplications, {sin_cos} sin_cos")
    }
}

/// The arithmetic cost of the roots (`sin_cos` calls are added by the caller, who binds them).
pub fn cost(graph: &Graph, roots: &[Expr]) -> Cost {
    let mut cost = Cost::default();
    for e in graph.reachable(roots) {
        if graph.constant(e).is_some() {
            continue;
        }
        match graph.node(e) {
            Node::Add(..) | Node::Sub(..) => cost.additions += 1,
            Node::Mul(..) => cost.multiplications += 1,
            Node::Sqrt(_) => cost.square_roots += 1,
            Node::Neg(_) | Node::Number(_) | Node::Symbol(_) => {}
        }
    }
    cost
}
