//! Arguments of a kernel.

use crate::symbolic::Expr;

/// An argument of a kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum Argument {
    /// The default value of a joint of the stage, by its place there: what the joint takes where it is free.
    Default(usize),
    /// The unit of the equation's numbers, with their typical size.
    Measure,
    /// A number.
    Number(Expr),
    /// Several, in brackets.
    Array(Vec<Argument>),
    /// Two, in parentheses.
    Tuple([Box<Argument>; 2]),
    /// A struct of the runtime with its fields.
    Struct(&'static str, Vec<(&'static str, Argument)>),
    /// The range of a distance or a component, which is worked out from these beforehand.
    Range(Vec<Expr>),
}

impl Argument {
    /// An array of numbers.
    pub fn numbers(numbers: &[Expr]) -> Self {
        Argument::Array(numbers.iter().copied().map(Argument::Number).collect())
    }

    /// An array of arrays of numbers.
    pub fn rows<const K: usize>(rows: &[[Expr; K]]) -> Self {
        Argument::Array(rows.iter().map(|row| Argument::numbers(row)).collect())
    }

    /// The default values of both joints.
    pub fn defaults() -> Self {
        Argument::Array(vec![Argument::Default(0), Argument::Default(1)])
    }

    /// The expressions in it.
    pub fn inputs(&self) -> Vec<Expr> {
        match self {
            Argument::Default(_) | Argument::Measure => Vec::new(),
            Argument::Number(e) => vec![*e],
            Argument::Array(items) => items.iter().flat_map(Argument::inputs).collect(),
            Argument::Tuple(items) => items.iter().flat_map(|item| item.inputs()).collect(),
            Argument::Struct(_, fields) => fields.iter().flat_map(|(_, field)| field.inputs()).collect(),
            Argument::Range(inputs) => inputs.clone(),
        }
    }
}

/// A run-time direction that an angle is counted from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Sine times a positive factor.
    pub y: Expr,
    /// Cosine times the same factor.
    pub x: Expr,
}

/// A quantity that the text of a stage names.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A value.
    Value(Expr),
    /// A value that stands before a sine or cosine.
    Coefficient(Expr),
    /// Several, separated by commas.
    List(Vec<Expr>),
}
