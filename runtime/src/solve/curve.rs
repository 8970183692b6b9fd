//! Roots of two equations in two joints, from a place nearby.

use super::{Tolerances, Turn};
use crate::math::wrap;

/// `a cos + b sin + k` as `[a, b, k]`.
pub type Row<T> = [T; 3];

/// The components of a vector across an axis, as either of two joints moves it: two rows for each joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Across<T> {
    /// As joint x moves it.
    pub x: [[T; 3]; 2],
    /// As joint z moves it.
    pub z: [[T; 3]; 2],
}

impl<T: Tolerances> Across<T> {
    /// The larger of the vector's two lengths across the axis, relative to what they may be.
    pub(super) fn relative(&self, [x, z]: &[Turn<T>; 2]) -> T {
        let size = |rows: &[Row<T>; 2]| rows.iter().flatten().fold(T::ZERO, |sum, k| sum + *k * *k);
        let largest = size(&self.x).max(size(&self.z));
        let square = |rows: &[Row<T>; 2], turn: &Turn<T>| rows.iter().fold(T::ZERO, |sum, row| sum + at(row, turn) * at(row, turn));
        let square = square(&self.x, x).max(square(&self.z, z));
        if largest > T::ZERO { (square / largest).sqrt() } else { T::ONE }
    }
}

/// The value of a row.
pub(super) fn at<T: Tolerances>([a, b, k]: &Row<T>, turn: &Turn<T>) -> T {
    *a * turn.cos + *b * turn.sin + *k
}

fn slope<T: Tolerances>([a, b, _]: &Row<T>, turn: &Turn<T>) -> T {
    *b * turn.cos - *a * turn.sin
}

fn curvature<T: Tolerances>([a, b, _]: &Row<T>, turn: &Turn<T>) -> T {
    -(*a * turn.cos + *b * turn.sin)
}

fn moved<T: Tolerances>([x, z]: &[Turn<T>; 2], dx: T, dz: T) -> [Turn<T>; 2] {
    [Turn::at(wrap(x.value + dx)), Turn::at(wrap(z.value + dz))]
}

/// A few steps of Newton's method on both rows, as long as they bring the root closer.
pub(super) fn newton<T: Tolerances>(p: &[Row<T>; 2], q: &[Row<T>; 2], root: [Turn<T>; 2]) -> [Turn<T>; 2] {
    let ([p1, p2], [q1, q2]) = (p, q);
    let miss = |[x, z]: &[Turn<T>; 2]| [at(p1, x) - at(q1, z), at(p2, x) - at(q2, z)];
    let square = |[u, v]: [T; 2]| u * u + v * v;
    let mut best = root;
    let mut size = square(miss(&best));
    for _ in 0..4 {
        if !(size > T::EPSILON * T::EPSILON) {
            break;
        }
        let [x, z] = &best;
        let [u, v] = miss(&best);
        let (a, b, c, d) = (slope(p1, x), -slope(q1, z), slope(p2, x), -slope(q2, z));
        let k = T::ONE / (a * d - b * c);
        let (dx, dz) = ((b * v - d * u) * k, (c * u - a * v) * k);
        if !(dx.abs().max(dz.abs()) < T::HALF) {
            break;
        }
        let next = moved(&best, dx, dz);
        let next_size = square(miss(&next));
        if !(next_size < size) {
            break;
        }
        (best, size) = (next, next_size);
    }
    best
}

/// The two roots of `p = q` and of equal lengths across the axis that are nearest to a place where those lengths are small. `None`
/// if the row does not say which way to go.
///
/// Along the curve of the row, the difference of the squared lengths is to second order a quadratic polynomial, and that is accurate to
/// rounding where the lengths vanish.
pub(super) fn beside<T: Tolerances>(
    p: &Row<T>,
    q: &Row<T>,
    across: &Across<T>,
    place: [Turn<T>; 2],
) -> Option<[[Turn<T>; 2]; 2]> {
    let (start, [low, high]) = steps(p, q, across, place)?;
    let mut roots = [start; 2];
    for (root, first) in roots.iter_mut().zip([low, high]) {
        let mut step = first;
        for _ in 0..4 {
            *root = moved(root, step[0], step[1]);
            let (on_curve, [low, high]) = steps(p, q, across, *root)?;
            *root = on_curve;
            let length = |step: &[T; 2]| step[0] * step[0] + step[1] * step[1];
            step = if length(&low) < length(&high) { low } else { high };
        }
        *root = moved(root, step[0], step[1]);
    }
    Some(roots)
}

/// The place moved onto the curve of the row, and from there the steps to the two roots along it.
fn steps<T: Tolerances>(
    p: &Row<T>,
    q: &Row<T>,
    across: &Across<T>,
    mut place: [Turn<T>; 2],
) -> Option<([Turn<T>; 2], [[T; 2]; 2])> {
    let mut along = [T::ZERO; 2];
    for _ in 0..2 {
        let [x, z] = &place;
        let (l, lx, lz) = (at(p, x) - at(q, z), slope(p, x), -slope(q, z));
        let square = lx * lx + lz * lz;
        if !(square > T::WEAK * T::WEAK) {
            return None;
        }
        let k = -l / square;
        along = [-lz / square.sqrt(), lx / square.sqrt()];
        place = moved(&place, k * lx, k * lz);
    }
    // |v|^2 along the curve: value, slope and half the curvature.
    let length = |rows: &[Row<T>; 2], turn: &Turn<T>, t: T| {
        rows.iter().fold([T::ZERO; 3], |[n0, n1, n2], row| {
            let (v, d, c) = (at(row, turn), slope(row, turn) * t, curvature(row, turn) * t * t);
            [n0 + v * v, n1 + T::TWO * v * d, n2 + d * d + v * c]
        })
    };
    let ([x, z], [tx, tz]) = (&place, along);
    let ([a0, a1, a2], [b0, b1, b2]) = (length(&across.x, x, tx), length(&across.z, z, tz));
    // The difference of the values as a product, so that it is as accurate as the lengths.
    let (va, vb) = (a0.sqrt(), b0.sqrt());
    let (c, half, a) = ((va - vb) * (va + vb), (a1 - b1) * T::HALF, a2 - b2);
    let root = (half * half - a * c).max(T::ZERO).sqrt();
    let larger = if half < T::ZERO { root - half } else { -half - root };
    let safe = |n: T, d: T| if d == T::ZERO { T::ZERO } else { n / d };
    let step = |s: T| {
        let s = if s.abs() < T::HALF { s } else { T::ZERO };
        [s * tx, s * tz]
    };
    Some((place, [step(safe(larger, a)), step(safe(c, larger))]))
}
