//! Operands of expressions, and their values.

use super::graph::{Expr, Graph, Node};
use super::symbol::Symbol;
use std::collections::HashMap;

impl Graph {
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

    /// The value under an assignment of the run-time symbols. A symbol without a value counts as zero.
    pub fn evaluate(&self, roots: &[Expr], assignment: &HashMap<Symbol, f64>) -> Vec<f64> {
        let mut values: HashMap<Expr, f64> = HashMap::new();
        for e in self.reachable(roots) {
            let of = |x: Expr| values.get(&x).copied().unwrap_or(0.0);
            let value = match self.node(e) {
                Node::Number(bits) => f64::from_bits(bits),
                Node::Symbol(s) => s.value().or_else(|| assignment.get(&s).copied()).unwrap_or(0.0),
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
    use super::super::Dimension;
    use super::*;

    #[test]
    fn evaluation_follows_the_graph() {
        let mut g = Graph::default();
        let (x, y, k) = (g.symbol("x"), g.symbol("y"), g.dimension(Dimension::LinkLength(0), 2.0));
        let sum = g.add(x, y);
        let e = g.mul(k, sum);
        let values = g.evaluate(&[e], &HashMap::from([("x".into(), 3.0), ("y".into(), 4.0)]));
        assert_eq!(values, [14.0]);
    }
}
