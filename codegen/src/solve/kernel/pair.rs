//! Two equations in two revolute joints.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables, derivative};
use crate::symbolic::{Expr, Graph};

/// `p . (cos x, sin x, 1) = q . (cos z, sin z, 1)`, twice: of the kind of subproblem 6 of IK-Geo.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// Rows of the first joint: of the cosine, of the sine, constant.
    pub p: [[Expr; 3]; 2],
    /// Rows of the second.
    pub q: [[Expr; 3]; 2],
    /// Where the joint between the two is revolute: rows of the vector's components across its axis. They are given as the
    /// first joint moves it, and as the second does. The second row of `p` and `q` is then the one that compares lengths.
    pub across: Option<[[[Expr; 3]; 2]; 2]>,
    /// How many lengths the determinant of both equations is a product of.
    pub power: u32,
}

impl Equation for Pair {
    fn form(&self) -> Form {
        let function = if self.across.is_some() { "pair_turning" } else { "pair" };
        let across = self.across.map(|across| Argument::rows(&across.concat()));
        let rows = [Argument::rows(&self.p), Argument::rows(&self.q)];
        Form {
            roots: 4,
            ..Form::new(
                function,
                "two equations together, a quartic (up to 4 roots)",
                [Argument::defaults(), Argument::Measure].into_iter().chain(rows).chain(across).collect(),
            )
        }
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let (x, z) = (variables.pair(g, 0), variables.pair(g, 1));
        let [px, qx] = self.p.map(|row| derivative(g, row, x));
        let [pz, qz] = self.q.map(|row| derivative(g, row, z));
        Pivot { value: g.cross2([px, qx], [pz, qz]), power: self.power }
    }
}
