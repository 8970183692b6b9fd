//! One direction seen from two revolute joints, with a prismatic one between them.

use super::argument::Argument;
use super::equation::{Equation, Form};
use super::pivot::{Pivot, Variables};
use crate::symbolic::{Graph, Mat3, Vec3, transpose};

/// A direction that lies on a cone about either joint: subproblem 2 of Paden and Kahan, and of IK-Geo. For each joint it
/// has the vector that the joint turns, and the rotation from the prismatic joint's frame to its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Aim {
    /// The vectors.
    pub moved: [Vec3; 2],
    /// The rotations, by rows.
    pub frames: [Mat3; 2],
}

impl Equation for Aim {
    fn form(&self) -> Form {
        let sights = self.moved.iter().zip(&self.frames).map(|(moved, frame)| {
            let fields = vec![("moved", Argument::numbers(moved)), ("frame", Argument::rows(frame))];
            Argument::Struct("Sight", fields)
        });
        Form {
            extra_roots: 1,
            ..Form::new(
                "aim",
                "one direction seen over a sliding joint, two cones (2 roots)",
                [Argument::defaults()].into_iter().chain(sights).collect(),
            )
        }
    }

    /// The triple product of the direction and both axes.
    fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        let ([_, moved], [[_, _, nx], frame]) = (self.moved, self.frames);
        let [_, _, nz] = frame;
        let t = variables.pair(g, 1);
        let seen = g.rotate_z(t, moved);
        let h = g.apply3(&transpose(&frame), seen);
        let normal = g.cross3(nx, nz);
        Pivot { value: g.dot3(normal, h), power: 0 }
    }
}
