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

/// The entries of the four vectors: these turn with the line, the two other numbers stay.
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
        three.iter_mut().zip(monomials).for_each(|(row, x)| set(row, place, x));
    }
    let three = moved(&three, &[0.0, 0.0, 1.0], second);
    let mut nine = [[0.0; PRODUCTS]; COORDINATES];
    for (column, one) in [0.0, 0.0, 1.0].into_iter().enumerate() {
        for (place, monomials) in joined(&three, column, one, outer).into_iter().enumerate() {
            nine.iter_mut().zip(monomials).for_each(|(row, x)| set(row, MONOMIALS * place + column, x));
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
    for (i, one) in ones.iter().enumerate() {
        let [px, py, pz, lx, ly, lz, p_p, p_l, mx, my, mz, nx, ny, nz] = column_of(sums, i);
        let [x, y, z] = motion.turn([px, py, pz]);
        let [u, v, w] = motion.turn([lx, ly, lz]);
        let [a, b, c] = motion.turn([mx, my, mz]);
        let [f, g, h] = motion.turn([nx, ny, nz]);
        let shift = tx * u + ty * v + tz * w;
        let product = p_l + shift;
        let twice = 2.0 * product;
        let column = row(
            [x + tx * one, y + ty * one, z + tz * one],
            [u, v, w],
            [p_p + 2.0 * (tx * x + ty * y + tz * z) + square * one, product],
            [a + (ty * w - tz * v), b + (tz * u - tx * w), c + (tx * v - ty * u)],
            [
                f - 2.0 * (ty * c - tz * b) + square * u - twice * tx,
                g - 2.0 * (tz * a - tx * c) + square * v - twice * ty,
                h - 2.0 * (tx * b - ty * a) + square * w - twice * tz,
            ],
        );
        out.iter_mut().zip(column).for_each(|(row, x)| set(row, i, x));
    }
    out
}

#[inline(always)]
fn column_of<const N: usize>(sums: &Sums<N>, column: usize) -> [f64; COORDINATES] {
    sums.each_ref().map(|row| row.get(column).copied().unwrap_or(0.0))
}

#[inline(always)]
fn set<const N: usize>(row: &mut [f64; N], place: usize, value: f64) {
    if let Some(entry) = row.get_mut(place) {
        *entry = value;
    }
}

/// The three monomials of a joint that moves one column of sums.
#[inline(always)]
fn joined<const N: usize>(sums: &Sums<N>, column: usize, one: f64, joint: Move) -> [[f64; COORDINATES]; MONOMIALS] {
    let x = column_of(sums, column);
    let [px, py, pz, lx, ly, lz, p_p, p_l, mx, my, mz, nx, ny, nz] = x;
    let k = joint.sign;
    if joint.is_prismatic {
        // The motion above with t = (0, 0, q).
        let square = row([0.0; 3], [0.0; 3], [one, 0.0], [0.0; 3], [lx, ly, -lz]);
        let inverted = [2.0 * k * my, -2.0 * k * mx, -2.0 * k * p_l];
        let linear = row([0.0, 0.0, k * one], [0.0; 3], [2.0 * k * pz, k * lz], [-k * ly, k * lx, 0.0], inverted);
        [square, linear, x]
    } else {
        [
            row([px, py, 0.0], [lx, ly, 0.0], [0.0; 2], [mx, my, 0.0], [nx, ny, 0.0]),
            row(
                [-k * py, k * px, 0.0],
                [-k * ly, k * lx, 0.0],
                [0.0; 2],
                [-k * my, k * mx, 0.0],
                [-k * ny, k * nx, 0.0],
            ),
            row([0.0, 0.0, pz], [0.0, 0.0, lz], [p_p, p_l], [0.0, 0.0, mz], [0.0, 0.0, nz]),
        ]
    }
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
