//! Rigid transforms over expressions.

use super::vector::transpose;
use super::{Expr, Graph, Mat3, Vec3};

/// Rotation and translation: `v -> r v + p`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rigid {
    /// Rotation, `r[row][column]`.
    pub r: Mat3,
    /// Translation.
    pub p: Vec3,
}

impl Rigid {
    /// The transform that changes nothing.
    pub fn identity() -> Self {
        Rigid { r: Graph::identity(), p: [Expr::ZERO; 3] }
    }

    /// Column `j` of the rotation: the direction of axis `j`.
    pub fn axis(&self, j: usize) -> Vec3 {
        self.r.map(|row| row.get(j).copied().unwrap_or(Expr::ZERO))
    }

    /// The z axis, the joint axis of the frame.
    pub fn z(&self) -> Vec3 {
        self.axis(2)
    }

    /// The rotation transposed.
    pub fn transposed(&self) -> Mat3 {
        transpose(&self.r)
    }

    /// `self` after `inner`: `v -> self(inner(v))`.
    pub fn then(&self, g: &mut Graph, inner: &Rigid) -> Rigid {
        let r = g.matmul(&self.r, &inner.r);
        let moved = g.apply3(&self.r, inner.p);
        Rigid { r, p: g.add3(moved, self.p) }
    }

    /// The inverse transform.
    pub fn inverse(&self, g: &mut Graph) -> Rigid {
        let r = self.transposed();
        let back = g.apply3(&r, self.p);
        Rigid { r, p: back.map(|e| g.neg(e)) }
    }

    /// The image of a point.
    pub fn point(&self, g: &mut Graph, v: Vec3) -> Vec3 {
        let rotated = g.apply3(&self.r, v);
        g.add3(rotated, self.p)
    }
}
