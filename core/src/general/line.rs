//! A line with a point marked on it, as 14 numbers that a rigid motion changes linearly.

use crate::Transform;
use crate::transform::{cross, dot};

/// Point p, direction l, `p.p`, `p.l`, `p x l`, `(p.p) l - 2 (p.l) p`, in this order.
pub const COORDINATES: usize = 14;

/// A row over the coordinates, from its entries for p, for l, for `p.p` and `p.l`, for `p x l`, and for
/// `(p.p) l - 2 (p.l) p`. Generated code has its rows so: one line a vector.
#[inline]
pub const fn row(
    [px, py, pz]: [f64; 3],
    [lx, ly, lz]: [f64; 3],
    [square, product]: [f64; 2],
    [mx, my, mz]: [f64; 3],
    [ix, iy, iz]: [f64; 3],
) -> [f64; COORDINATES] {
    [px, py, pz, lx, ly, lz, square, product, mx, my, mz, ix, iy, iz]
}

/// Where the four vectors begin: these turn with the line, the two other numbers stay.
pub(super) const VECTORS: [usize; 4] = [0, 3, 8, 11];

/// The entries of the four vectors.
#[inline(always)]
pub(super) fn vectors<T>([a, b, c, d, e, f, _, _, g, h, i, j, k, l]: &[T; COORDINATES]) -> [[&T; 3]; 4] {
    [[a, b, c], [d, e, f], [g, h, i], [j, k, l]]
}

/// The coordinates of the line along z whose marked point is the origin.
const ALONG_Z: [f64; COORDINATES] = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// Coordinates of the line through `point` with direction `along`.
#[inline(always)]
pub(super) fn line(point: [f64; 3], along: [f64; 3]) -> [f64; COORDINATES] {
    let ([x, y, z], [u, v, w]) = (point, along);
    let (square, product) = (dot(point, point), dot(point, along));
    let [a, b, c] = cross(point, along);
    let twice = 2.0 * product;
    [x, y, z, u, v, w, square, product, a, b, c, square * u - twice * x, square * v - twice * y, square * w - twice * z]
}

/// The coordinates as sums of monomials: row i has the coefficients of coordinate i.
type Sums<const N: usize> = [[f64; N]; COORDINATES];

/// The monomials of a joint are `cos q, sin q, 1`; of a prismatic one `q^2, q, 1`.
pub(super) const MONOMIALS: usize = 3;
/// Products of the monomials of two joints.
pub(super) const PRODUCTS: usize = MONOMIALS * MONOMIALS;

/// A joint's kind, and whether it moves forwards.
#[derive(Clone, Copy)]
pub(super) struct Move {
    pub(super) is_prismatic: bool,
    /// 1 for the joint itself, -1 for its inverse.
    pub(super) sign: f64,
}

/// The coordinates of `third * outer * second * inner * first` applied to the z axis. Row i: the coefficients of the
/// products of outer and inner monomials, entry `3 outer + inner`.
#[inline(always)]
pub(super) fn moved_twice(
    first: &Transform<f64>,
    inner: Move,
    second: &Transform<f64>,
    outer: Move,
    third: &Transform<f64>,
) -> Sums<PRODUCTS> {
    let start = moved(&ALONG_Z.map(|x| [x]), &[1.0], first);
    let mut three = [[0.0; MONOMIALS]; COORDINATES];
    for (place, monomials) in joined(&start, 0, 1.0, inner).into_iter().enumerate() {
        three.iter_mut().zip(monomials).for_each(|(row, x)| row[place] = x);
    }
    let three = moved(&three, &[0.0, 0.0, 1.0], second);
    let mut nine = [[0.0; PRODUCTS]; COORDINATES];
    for (column, one) in [0.0, 0.0, 1.0].into_iter().enumerate() {
        for (place, monomials) in joined(&three, column, one, outer).into_iter().enumerate() {
            nine.iter_mut().zip(monomials).for_each(|(row, x)| row[MONOMIALS * place + column] = x);
        }
    }
    moved(&nine, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], third)
}

/// Rigid motion of sums of monomials: a rotation, then a shift by t. `ones` are the coefficients of the number 1.
///
/// `p + t, l, p.p + 2 t.p + t.t, p.l + t.l, p x l + t x l`, and the last vector n becomes
/// `n - 2 t x (p x l) + (t.t) l - 2 (p.l + t.l) t`.
#[inline(always)]
fn moved<const N: usize>(sums: &Sums<N>, ones: &[f64; N], motion: &Transform<f64>) -> Sums<N> {
    let [tx, ty, tz] = motion.translation;
    let square = dot(motion.translation, motion.translation);
    let mut out = [[0.0; N]; COORDINATES];
    for i in 0..N {
        let turned = |at: usize| motion.turn([sums[at][i], sums[at + 1][i], sums[at + 2][i]]);
        let ([x, y, z], [u, v, w], [a, b, c], [f, g, h]) = (turned(0), turned(3), turned(8), turned(11));
        let one = ones[i];
        let shift = tx * u + ty * v + tz * w;
        let product = sums[7][i] + shift;
        let twice = 2.0 * product;
        out[0][i] = x + tx * one;
        out[1][i] = y + ty * one;
        out[2][i] = z + tz * one;
        out[3][i] = u;
        out[4][i] = v;
        out[5][i] = w;
        out[6][i] = sums[6][i] + 2.0 * (tx * x + ty * y + tz * z) + square * one;
        out[7][i] = product;
        out[8][i] = a + (ty * w - tz * v);
        out[9][i] = b + (tz * u - tx * w);
        out[10][i] = c + (tx * v - ty * u);
        out[11][i] = f - 2.0 * (ty * c - tz * b) + square * u - twice * tx;
        out[12][i] = g - 2.0 * (tz * a - tx * c) + square * v - twice * ty;
        out[13][i] = h - 2.0 * (tx * b - ty * a) + square * w - twice * tz;
    }
    out
}

/// The three monomials of a joint that moves one column of sums.
#[inline(always)]
fn joined<const N: usize>(sums: &Sums<N>, column: usize, one: f64, joint: Move) -> [[f64; COORDINATES]; MONOMIALS] {
    let x: [f64; COORDINATES] = core::array::from_fn(|i| sums[i][column]);
    let [mut first, mut second, mut third] = [[0.0; COORDINATES]; MONOMIALS];
    if joint.is_prismatic {
        // The motion above with t = (0, 0, q).
        let k = joint.sign;
        third = x;
        second[2] = k * one;
        second[6] = 2.0 * k * x[2];
        second[7] = k * x[5];
        (second[8], second[9]) = (-k * x[4], k * x[3]);
        (second[11], second[12], second[13]) = (2.0 * k * x[9], -2.0 * k * x[8], -2.0 * k * x[7]);
        first[6] = one;
        (first[11], first[12], first[13]) = (x[3], x[4], -x[5]);
    } else {
        for at in VECTORS {
            (first[at], first[at + 1]) = (x[at], x[at + 1]);
            (second[at], second[at + 1]) = (-joint.sign * x[at + 1], joint.sign * x[at]);
            third[at + 2] = x[at + 2];
        }
        (third[6], third[7]) = (x[6], x[7]);
    }
    [first, second, third]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::tests::tilted;
    use crate::math::sin_cos;

    #[test]
    fn sums_are_the_coordinates_of_the_moved_line() {
        let [a, b, c] = [0.4, -1.1, 2.0].map(|x| tilted(x, [0.5 * x, 0.2 - x, 0.7]));
        for kinds in 0..4 {
            for sign in [1.0, -1.0] {
                let [inner, outer] = [1, 2].map(|bit| Move { is_prismatic: kinds & bit != 0, sign });
                let sums = moved_twice(&a, inner, &b, outer, &c);
                for (q, r) in [(0.3, -0.8), (1.7, 0.2), (-2.5, 1.1)] {
                    let motion = c.then_move(false, 0.0)
                        * Transform::IDENTITY.then_move(outer.is_prismatic, sign * r)
                        * b
                        * Transform::IDENTITY.then_move(inner.is_prismatic, sign * q)
                        * a;
                    let expected = line(motion.translation, motion.z());
                    let monomials = |joint: Move, q: f64| {
                        let (sin, cos) = sin_cos(q);
                        if joint.is_prismatic { [q * q, q, 1.0] } else { [cos, sin, 1.0] }
                    };
                    for (row, wanted) in sums.iter().zip(expected) {
                        let mut value = 0.0;
                        for (x, part) in monomials(outer, r).into_iter().zip(row.chunks(3)) {
                            value += part.iter().zip(monomials(inner, q)).map(|(y, z)| x * y * z).sum::<f64>();
                        }
                        assert!((value - wanted).abs() < 1e-13, "{kinds} {sign} {row:?}");
                    }
                }
            }
        }
    }
}
