//! Expressions: a hash-consed graph, vectors and rigid transforms over it, evaluation and operation count.
//!
//! An expression is a small `Copy` id into an arena. Equal expressions have equal ids, so common subexpressions are
//! shared by construction, and ids are in evaluation order. Folding happens in the constructors of [`Graph`], nowhere
//! else.

mod angle_sum;
mod count;
mod dimension;
mod fold;
mod graph;
mod label;
mod rigid;
mod symbol;
mod vector;
mod walk;

pub use angle_sum::{AngleSum, Angles, BoundAngle, Pair};
pub use count::{Cost, cost};
pub use dimension::{ConstantAngle, Dimension};
pub use graph::{Expr, Graph, Node, Products};
pub use label::Label;
pub use rigid::Rigid;
pub use symbol::{Input, Part, Symbol, Unknown};
pub use vector::{Mat3, Vec3, transpose};
