//! The folding constructors: `0 x`, `1 x`, signs pulled out, constants first. No pass simplifies afterwards.

use super::dimension::Dimension;
use super::graph::{Expr, Graph, Node, Products};
use super::symbol::Symbol;
use crate::model::Length;

impl Graph {
    /// A run-time value.
    pub fn symbol(&mut self, symbol: impl Into<Symbol>) -> Expr {
        self.intern(Node::Symbol(symbol.into()), None)
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
    pub fn dimension(&mut self, dimension: Dimension, value: f64) -> Expr {
        if value == 0.0 {
            return Expr::ZERO;
        }
        self.intern(Node::Symbol(Symbol::Dimension(dimension, value.to_bits())), Some(value))
    }

    /// A length of the arm: a dimension, or a multiple of a run-time parameter, which is never taken for zero.
    pub fn length(&mut self, dimension: Dimension, length: &Length) -> Expr {
        match length {
            Length::Constant(value) => self.dimension(dimension, *value),
            Length::Multiple { factor, parameter, .. } => {
                let value = self.symbol(self.field(parameter));
                let factor = self.number(*factor);
                self.mul(factor, value)
            }
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
        let (k, e) = (g.dimension(Dimension::LinkLength(0), 2.0), g.sub(y, x));
        assert_eq!(g.sub(k, d), g.add(k, e));
    }

    #[test]
    fn cancelling_dimensions_fold_to_zero() {
        let mut g = Graph::default();
        let (a, b) = (g.dimension(Dimension::LinkOffset(3), 0.1), g.dimension(Dimension::LinkOffset(5), 0.1));
        assert_eq!(g.sub(a, b), Expr::ZERO);
        assert_eq!(g.dimension(Dimension::LinkLength(0), 0.0), Expr::ZERO);
    }

    #[test]
    fn constants_move_outward_only_when_asked() {
        for (products, shared) in [(Products::AsBuilt, false), (Products::ConstantsOutward, true)] {
            let mut g = Graph::new(products);
            let (k, x, y) = (g.dimension(Dimension::LinkOffset(5), 0.3), g.symbol("x"), g.symbol("y"));
            let xy = g.mul(x, y);
            let kx = g.mul(k, x);
            let kxy = g.mul(kx, y);
            assert_eq!(g.operands(kxy).contains(&xy), shared);
        }
    }
}
