//! Three-vectors and 3x3 matrices over expressions.

use super::{ConstantAngle, Dimension, Expr, Graph, Pair};
use crate::model::Angle;

/// A vector of three expressions.
pub type Vec3 = [Expr; 3];
/// A matrix of expressions, `m[row][column]`.
pub type Mat3 = [[Expr; 3]; 3];

impl Graph {
    /// The unit matrix.
    pub fn identity() -> Mat3 {
        let (o, i) = (Expr::ZERO, Expr::ONE);
        [[i, o, o], [o, i, o], [o, o, i]]
    }

    /// The sine and cosine of a constant angle: exact numbers where the angle is exact, else named dimensions.
    pub fn constant_pair(&mut self, angle: Angle, what: ConstantAngle) -> Pair {
        let (sin, cos) = (angle.sin(), angle.cos());
        if angle.quarter_turns().is_some() {
            return Pair { sin: self.number(sin), cos: self.number(cos) };
        }
        let dimension = |g: &mut Graph, dimension: Dimension, value: f64| {
            if value.abs() == 0.5 || value.abs() == 1.0 { g.number(value) } else { g.dimension(dimension, value) }
        };
        Pair { sin: dimension(self, Dimension::Sin(what), sin), cos: dimension(self, Dimension::Cos(what), cos) }
    }

    /// The sine and cosine of a constant angle that belongs to no single row.
    pub fn turn(&mut self, angle: Angle) -> Pair {
        self.constant_pair(angle, ConstantAngle::Turn(angle))
    }

    /// `R_z(angle) v`
    pub fn rotate_z(&mut self, by: Pair, [x, y, z]: Vec3) -> Vec3 {
        let (cx, sy) = (self.mul(by.cos, x), self.mul(by.sin, y));
        let (sx, cy) = (self.mul(by.sin, x), self.mul(by.cos, y));
        [self.sub(cx, sy), self.add(sx, cy), z]
    }

    /// `R_x(angle) v`
    pub fn rotate_x(&mut self, by: Pair, [x, y, z]: Vec3) -> Vec3 {
        let [y, z, _] = self.rotate_z(by, [y, z, Expr::ZERO]);
        [x, y, z]
    }

    /// `R_y(angle) v`
    pub fn rotate_y(&mut self, by: Pair, [x, y, z]: Vec3) -> Vec3 {
        let [z, x, _] = self.rotate_z(by, [z, x, Expr::ZERO]);
        [x, y, z]
    }

    /// `R_z(angle)`
    pub fn rotation_z(&mut self, by: Pair) -> Mat3 {
        transpose(&Self::identity().map(|axis| self.rotate_z(by, axis)))
    }

    /// `R_x(angle)`
    pub fn rotation_x(&mut self, by: Pair) -> Mat3 {
        transpose(&Self::identity().map(|axis| self.rotate_x(by, axis)))
    }

    /// `a . b` in the plane.
    pub fn dot2(&mut self, [ax, ay]: [Expr; 2], [bx, by]: [Expr; 2]) -> Expr {
        let (x, y) = (self.mul(ax, bx), self.mul(ay, by));
        self.add(x, y)
    }

    /// `a x b` in the plane: positive where b is to the left of a.
    pub fn cross2(&mut self, [ax, ay]: [Expr; 2], [bx, by]: [Expr; 2]) -> Expr {
        let (left, right) = (self.mul(ax, by), self.mul(ay, bx));
        self.sub(left, right)
    }

    /// `a + b`
    pub fn add3(&mut self, a: Vec3, b: Vec3) -> Vec3 {
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        [self.add(ax, bx), self.add(ay, by), self.add(az, bz)]
    }

    /// `a - b`
    pub fn sub3(&mut self, a: Vec3, b: Vec3) -> Vec3 {
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        [self.sub(ax, bx), self.sub(ay, by), self.sub(az, bz)]
    }

    /// `k a`
    pub fn scale3(&mut self, k: Expr, [x, y, z]: Vec3) -> Vec3 {
        [self.mul(k, x), self.mul(k, y), self.mul(k, z)]
    }

    /// `a . b`
    pub fn dot3(&mut self, a: Vec3, b: Vec3) -> Expr {
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        let (x, y, z) = (self.mul(ax, bx), self.mul(ay, by), self.mul(az, bz));
        let xy = self.add(x, y);
        self.add(xy, z)
    }

    /// `a x b`
    pub fn cross3(&mut self, [a, b, c]: Vec3, [d, e, f]: Vec3) -> Vec3 {
        [self.cross2([b, c], [e, f]), self.cross2([c, a], [f, d]), self.cross2([a, b], [d, e])]
    }

    /// `m v`
    pub fn apply3(&mut self, m: &Mat3, v: Vec3) -> Vec3 {
        m.map(|row| self.dot3(row, v))
    }

    /// `a b`
    pub fn matmul(&mut self, a: &Mat3, b: &Mat3) -> Mat3 {
        let columns = transpose(b).map(|column| self.apply3(a, column));
        transpose(&columns)
    }
}

/// The transposed matrix.
pub fn transpose(m: &Mat3) -> Mat3 {
    let [[a, b, c], [d, e, f], [g, h, i]] = *m;
    [[a, d, g], [b, e, h], [c, f, i]]
}
