//! Linked joints: motor values from joint values and back, and a row of the Jacobian of the motor rates.

use super::{Slot, Straight};
use crate::model::{Coupling, Model};
use crate::symbolic::{Dimension, Expr, Graph};

/// The three products with the matrix of a coupling and its inverse, each a function of as many values as joints.
#[derive(Debug, Clone)]
pub struct Linked {
    /// `A q + b` of the joint values.
    pub to_motor: Linear,
    /// `A^-1 (motor - b)` of the motor values.
    pub from_motor: Linear,
    /// A row of `J A^-1` of a row of the Jacobian.
    pub row: Linear,
}

/// A function of some values.
#[derive(Debug, Clone)]
pub struct Linear {
    /// Where the values go.
    pub values: Vec<Slot>,
    /// The arithmetic.
    pub straight: Straight,
}

impl Linear {
    fn new(graph: &Graph, values: Vec<Slot>, roots: Vec<Slot>) -> Self {
        Linear { values, straight: Straight::new(graph.clone(), roots, ["q".to_owned(), "motor".to_owned()]) }
    }
}

/// The functions of a coupling; `None` for an arm whose motors are its joints.
pub fn linked(model: &Model) -> Option<Linked> {
    let Coupling { matrix, inverse, offset } = model.coupling.as_ref()?;
    let mut graph = Graph::default();
    let n = model.joints.len();
    let numbered = |graph: &mut Graph, letter: &str| {
        (1..=n).map(|number| graph.symbol(format!("{letter}{number}"))).collect::<Vec<Expr>>()
    };
    let [q, m, j] = ["q", "m", "j"].map(|letter| numbered(&mut graph, letter));
    let offsets: Vec<Expr> =
        (0..).zip(offset).map(|(motor, offset)| graph.dimension(Dimension::MotorOffset(motor), *offset)).collect();
    let rows = products(&mut graph, matrix, &q);
    let to_motor: Vec<Expr> = rows.iter().zip(&offsets).map(|(row, offset)| graph.add(*row, *offset)).collect();
    let turned: Vec<Expr> = m.iter().zip(&offsets).map(|(motor, offset)| graph.sub(*motor, *offset)).collect();
    for (number, turned) in (1..).zip(&turned) {
        graph.name(*turned, format!("moved{number}"));
    }
    let from_motor = products(&mut graph, inverse, &turned);
    let row = products(&mut graph, &transposed(inverse), &j);
    Some(Linked {
        to_motor: Linear::new(&graph, q, to_motor),
        from_motor: Linear::new(&graph, m, from_motor),
        row: Linear::new(&graph, j, row),
    })
}

/// Each row of the matrix times the vector.
fn products(graph: &mut Graph, matrix: &[Vec<f64>], vector: &[Expr]) -> Vec<Expr> {
    let row = |row: &Vec<f64>| {
        row.iter().zip(vector).fold(Expr::ZERO, |sum, (factor, value)| {
            let factor = graph.number(*factor);
            let term = graph.mul(factor, *value);
            graph.add(sum, term)
        })
    };
    matrix.iter().map(row).collect()
}

fn transposed(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..matrix.len()).map(|column| matrix.iter().filter_map(|row| row.get(column).copied()).collect()).collect()
}
