//! Expressions as tokens, with only the parentheses they need.

use crate::lower::Names;
use crate::symbolic::{Expr, Graph, Node, Symbol};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

/// Identifier at the call site.
pub fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// A floating point literal; negative ones as minus and the positive literal. What is not finite, which no file can
/// have, is a quotient: there is no literal.
pub fn number(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!((0.0 / 0.0));
    }
    if value.is_infinite() {
        return if value > 0.0 { quote!((1.0 / 0.0)) } else { quote!((-1.0 / 0.0)) };
    }
    let literal = Literal::f64_unsuffixed(value.abs());
    if value.is_sign_negative() && value != 0.0 { quote!(-#literal) } else { quote!(#literal) }
}

/// An integer literal without suffix.
pub fn integer(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// The name that a pattern binds: with `_` before it where nothing reads it.
pub fn bound(name: &str, read: bool) -> Ident {
    if read { ident(name) } else { ident(&format!("_{name}")) }
}

/// `[a, b, c]`
pub fn array(items: impl IntoIterator<Item = impl ToTokens>) -> TokenStream {
    let items = items.into_iter();
    quote!([#(#items),*])
}

#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Unary,
    Atom,
}

/// Writes expressions, using the names of those that are bound.
pub struct Writer<'a> {
    /// The arena.
    pub graph: &'a Graph,
    /// The bound ones.
    pub bound: &'a Names,
    /// Path of the runtime crate.
    pub krate: &'a TokenStream,
    /// True for expressions over lanes, in which a number stands as `of(0.5)`.
    pub lanes: bool,
}

impl Writer<'_> {
    /// An expression.
    pub fn write(&self, e: Expr) -> TokenStream {
        self.at(e, Precedence::Sum)
    }

    /// `let name = definition;`
    pub fn statement(&self, e: Expr) -> TokenStream {
        let definition = self.node(e, Precedence::Sum);
        match self.bound.get(&e) {
            Some(name) => {
                let name = ident(name);
                quote!(let #name = #definition;)
            }
            None => TokenStream::new(),
        }
    }

    fn constant(&self, value: TokenStream) -> TokenStream {
        if self.lanes { quote!(of(#value)) } else { value }
    }

    fn at(&self, e: Expr, precedence: Precedence) -> TokenStream {
        match self.bound.get(&e) {
            Some(name) => {
                let name = ident(name);
                quote!(#name)
            }
            None => self.node(e, precedence),
        }
    }

    fn node(&self, e: Expr, precedence: Precedence) -> TokenStream {
        let (tokens, own) = match self.graph.node(e) {
            Node::Number(bits) => (self.constant(number(f64::from_bits(bits))), Precedence::Atom),
            Node::Symbol(symbol) => {
                let name = ident(&symbol.name());
                match symbol {
                    // A run-time parameter is a field: `self.l2`.
                    Symbol::Parameter { owner, .. } => {
                        let owner = ident(owner);
                        (quote!(#owner.#name), Precedence::Atom)
                    }
                    Symbol::Dimension(..) => (self.constant(quote!(#name)), Precedence::Atom),
                    _ => (quote!(#name), Precedence::Atom),
                }
            }
            Node::Neg(a) => {
                let a = self.at(a, Precedence::Product);
                (quote!(-#a), Precedence::Unary)
            }
            Node::Add(a, b) => {
                let (a, b) = (self.at(a, Precedence::Sum), self.at(b, Precedence::Product));
                (quote!(#a + #b), Precedence::Sum)
            }
            Node::Sub(a, b) => {
                let (a, b) = (self.at(a, Precedence::Sum), self.at(b, Precedence::Product));
                (quote!(#a - #b), Precedence::Sum)
            }
            Node::Mul(a, b) => {
                let (a, b) = (self.at(a, Precedence::Product), self.at(b, Precedence::Unary));
                (quote!(#a * #b), Precedence::Product)
            }
            Node::Sqrt(a) => match self.graph.node(a) {
                // The length of a vector of one component.
                Node::Mul(x, y) if x == y => {
                    let x = self.at(x, Precedence::Atom);
                    (quote!(#x.abs()), Precedence::Atom)
                }
                _ => {
                    let (a, krate) = (self.at(a, Precedence::Sum), self.krate);
                    let math = if self.lanes { quote!(#krate::batch::math) } else { quote!(#krate::math) };
                    (quote!(#math::sqrt(#a)), Precedence::Atom)
                }
            },
        };
        if own < precedence { quote!((#tokens)) } else { tokens }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_can_be_written() {
        for value in [0.0, -1.5, f64::MAX, -f64::MIN_POSITIVE, 5e-324] {
            let written = number(value).to_string().replace(' ', "");
            assert_eq!(written.parse(), Ok(value), "{written}");
        }
        for (value, text) in [(f64::NAN, "(0.0/0.0)"), (f64::INFINITY, "(1.0/0.0)"), (f64::NEG_INFINITY, "(-1.0/0.0)")]
        {
            assert_eq!(number(value).to_string().replace(' ', ""), text);
        }
    }

    #[test]
    fn only_needed_parentheses() {
        let mut g = Graph::default();
        let [a, b, c] = ["a", "b", "c"].map(|name| g.symbol(name));
        let sum = g.add(a, b);
        let product = g.mul(sum, c);
        let difference = g.sub(a, sum);
        let negative = g.neg(product);
        let krate = quote!(::denhart);
        let bound = Names::new();
        let writer = Writer { graph: &g, bound: &bound, krate: &krate, lanes: false };
        assert_eq!(writer.write(product).to_string(), quote!(c * (a + b)).to_string());
        assert_eq!(writer.write(difference).to_string(), quote!(a - (a + b)).to_string());
        // A sign in front of a product needs none: negation is exact.
        assert_eq!(writer.write(negative).to_string(), quote!(-c * (a + b)).to_string());
    }
}
