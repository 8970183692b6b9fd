//! The component of a vector that one joint turns: linear in the joint's cosine and sine.

use crate::symbolic::{Expr, Graph, Vec3};

/// `c cos + s sin + k`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// Of the cosine.
    pub c: Expr,
    /// Of the sine.
    pub s: Expr,
    /// Constant.
    pub k: Expr,
}

impl Sinusoid {
    /// As an array.
    pub fn array(self) -> [Expr; 3] {
        [self.c, self.s, self.k]
    }
}

/// `n . (R_z(t) v) + k`
pub fn turned(g: &mut Graph, n: Vec3, v: Vec3, k: Expr) -> Sinusoid {
    let ([nx, ny, nz], [x, y, z]) = (n, v);
    let (nxx, nyy) = (g.mul(nx, x), g.mul(ny, y));
    let (nyx, nxy) = (g.mul(ny, x), g.mul(nx, y));
    let nzz = g.mul(nz, z);
    Sinusoid { c: g.add(nxx, nyy), s: g.sub(nyx, nxy), k: g.add(nzz, k) }
}

/// `n . (R_z(-t) v) + k`
pub fn turned_back(g: &mut Graph, n: Vec3, v: Vec3, k: Expr) -> Sinusoid {
    let row = turned(g, n, v, k);
    Sinusoid { s: g.neg(row.s), ..row }
}
