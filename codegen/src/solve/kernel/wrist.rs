//! Three axes at right angles give a rotation.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Graph, Mat3};

/// `R_z(a) R_y(b) R_z(c) = m`: the Euler angles of a rotation. With `b = 0` joint a is free.
#[derive(Debug, Clone, PartialEq)]
pub struct Wrist {
    /// The rotation, by rows.
    pub m: Mat3,
}

impl Equation for Wrist {
    fn form(&self) -> Form {
        Form::new(
            "wrist",
            "three axes at right angles give a rotation (2 roots)",
            vec![Argument::Default(0), Argument::rows(&self.m)],
        )
    }

    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        Pivot { value: variables.pair(g, 1).sin, power: 0 }
    }
}
