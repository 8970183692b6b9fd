//! Two equations in two joints that do not separate.

use super::circle::{Circle, angles};
use super::{Home, Measure, Stage, Tolerances, Turn, offset};
use crate::JointMask;

type Row<T> = [T; 3];

/// Solves the two rows `p (cos x, sin x, 1) = q (cos z, sin z, 1)` for `(x, z)`: one side is eliminated, which leaves
/// a trigonometric polynomial of degree two (a quartic), at most four pairs. Where the rows lose rank (a point on a
/// joint axis) they are combined so that one joint drops out, and solved one after the other.
///
/// Every root is marked for a full check: near a double root a candidate may turn out not to be a solution.
pub fn pair<T: Tolerances>(
    [home_x, home_z]: [Home<T>; 2],
    measure: Measure<T>,
    p: [Row<T>; 2],
    q: [Row<T>; 2],
) -> Stage<T, 2, 4> {
    let ((p1, q1), (p2, q2)) = (normalized(p[0], q[0]), normalized(p[1], q[1]));
    let (p, q) = ([p1, p2], [q1, q2]);
    let (det_p, det_q) = (determinant(&p), determinant(&q));
    let mut stage = if det_p.abs().max(det_q.abs()) < T::COINCIDENT {
        separated([home_x, home_z], &p, &q)
    } else if det_p.abs() >= det_q.abs() {
        eliminated(&p, det_p, &q)
    } else {
        swapped(eliminated(&q, det_q, &p))
    };
    stage.angular = Stage::<T, 2, 4>::solved(stage.roots, measure).angular;
    stage.gap = T::ZERO;
    stage.doubt = true;
    stage
}

/// Solves `scale x = line (cos z, sin z, 1)` and `x^2 + m x + n = q (cos z, sin z, 1)` for `(x, z)`, `x` sliding;
/// `scale` is a constant that does not vanish.
pub fn pair_sliding<T: Tolerances>(
    measure: Measure<T>,
    line: Row<T>,
    scale: T,
    [m, n]: [T; 2],
    q: Row<T>,
) -> Stage<T, 2, 4> {
    let [a, b, c] = line.map(|k| k / scale);
    let circle = Circle {
        k0: (a * a + b * b) * T::HALF + c * c + m * c + n - q[2],
        k1: [T::TWO * a * c + m * a - q[0], T::TWO * b * c + m * b - q[1]],
        k2: [(a * a - b * b) * T::HALF, a * b],
    };
    let (roots, len) = angles(&circle);
    let roots = roots.map(|angle| {
        let z = Turn::at(angle);
        [Turn::position(a * z.cos + b * z.sin + c), z]
    });
    Stage { len, doubt: true, ..Stage::solved(roots, measure) }
}

fn normalized<T: Tolerances>(p: Row<T>, q: Row<T>) -> (Row<T>, Row<T>) {
    let size = p.iter().chain(&q).fold(T::ZERO, |sum, k| sum + *k * *k).sqrt();
    if !(size > T::ZERO) {
        return (p, q);
    }
    (p.map(|k| k / size), q.map(|k| k / size))
}

fn determinant<T: Tolerances>([a, b]: &[Row<T>; 2]) -> T {
    a[0] * b[1] - a[1] * b[0]
}

fn swapped<T: Tolerances>(mut stage: Stage<T, 2, 4>) -> Stage<T, 2, 4> {
    for [x, z] in &mut stage.roots {
        core::mem::swap(x, z);
    }
    stage
}

/// Eliminates the side `p`, whose determinant does not vanish: with `u = adj(P) (q - p3)`, `|u| = |det P|`.
fn eliminated<T: Tolerances>(p: &[Row<T>; 2], det: T, q: &[Row<T>; 2]) -> Stage<T, 2, 4> {
    let [[a, b, e], [c, d, f]] = *p;
    let [[q11, q12, q13], [q21, q22, q23]] = *q;
    let (q13, q23) = (q13 - e, q23 - f);
    let w1 = [d * q11 - b * q21, d * q12 - b * q22, d * q13 - b * q23];
    let w2 = [a * q21 - c * q11, a * q22 - c * q12, a * q23 - c * q13];
    let gram = |i: usize, j: usize| {
        let at = |w: &Row<T>, k: usize| w.get(k).copied().unwrap_or(T::ZERO);
        at(&w1, i) * at(&w1, j) + at(&w2, i) * at(&w2, j)
    };
    let circle = Circle {
        k0: (gram(0, 0) + gram(1, 1)) * T::HALF + gram(2, 2) - det * det,
        k1: [T::TWO * gram(0, 2), T::TWO * gram(1, 2)],
        k2: [(gram(0, 0) - gram(1, 1)) * T::HALF, gram(0, 1)],
    };
    let (roots, len) = angles(&circle);
    let sign = if det < T::ZERO { -T::ONE } else { T::ONE };
    let roots = roots.map(|angle| {
        let z = Turn::at(angle);
        let u1 = w1[0] * z.cos + w1[1] * z.sin + w1[2];
        let u2 = w2[0] * z.cos + w2[1] * z.sin + w2[2];
        let x = if u1 == T::ZERO && u2 == T::ZERO { Turn::ZERO } else { Turn::towards(u2 * sign, u1 * sign) };
        [x, z]
    });
    Stage { len, ..Stage::solved(roots, Measure::DIRECTION) }
}

/// Rows of lost rank: the combination without `x` gives `z`, the other one `x`; or the other way round.
fn separated<T: Tolerances>([home_x, home_z]: [Home<T>; 2], p: &[Row<T>; 2], q: &[Row<T>; 2]) -> Stage<T, 2, 4> {
    let (n, m) = (null_row(p, q), null_row(q, p));
    let amplitude = |n: [T; 2], rows: &[Row<T>; 2]| {
        let [a, b, _] = combined(n, rows);
        a * a + b * b
    };
    if amplitude(n, q) >= amplitude(m, p) {
        in_turn([home_x, home_z], n, p, q)
    } else {
        swapped(in_turn([home_z, home_x], m, q, p))
    }
}

/// A unit combination of the rows in which `x` drops out as far as it can; if it never appears, the combination with
/// the most of `z`.
fn null_row<T: Tolerances>([a, b]: &[Row<T>; 2], [c, d]: &[Row<T>; 2]) -> [T; 2] {
    let size = |v: [T; 2]| v[0] * v[0] + v[1] * v[1];
    let larger = |u: [T; 2], v: [T; 2]| if size(u) >= size(v) { u } else { v };
    let column = larger([a[0], b[0]], [a[1], b[1]]);
    let combination = if size(column) > T::VANISHING * T::VANISHING {
        [-column[1], column[0]]
    } else {
        larger([c[0], d[0]], [c[1], d[1]])
    };
    let length = size(combination).sqrt();
    if length > T::ZERO { [combination[0] / length, combination[1] / length] } else { [T::ONE, T::ZERO] }
}

fn combined<T: Tolerances>([n1, n2]: [T; 2], [a, b]: &[Row<T>; 2]) -> Row<T> {
    [n1 * a[0] + n2 * b[0], n1 * a[1] + n2 * b[1], n1 * a[2] + n2 * b[2]]
}

fn in_turn<T: Tolerances>(
    [home_x, home_z]: [Home<T>; 2],
    n: [T; 2],
    p: &[Row<T>; 2],
    q: &[Row<T>; 2],
) -> Stage<T, 2, 4> {
    let ([.., p0], [qc, qs, q0]) = (combined(n, p), combined(n, q));
    let across = [-n[1], n[0]];
    let ([pc, ps, p1], [rc, rs, r0]) = (combined(across, p), combined(across, q));
    let first = offset(home_z, Measure::DIRECTION, qc, qs, p0 - q0);
    let mut roots = [[Turn::ZERO; 2]; 4];
    let mut slots = roots.iter_mut();
    let (mut len, mut free) = (0, first.free);
    for [z] in first.roots.iter().take(first.len) {
        let wanted = rc * z.cos + rs * z.sin + r0 - p1;
        let second = offset(home_x, Measure::DIRECTION, pc, ps, wanted);
        let fits = second.free == JointMask::NONE || wanted.abs() <= T::COINCIDENT;
        for [x] in second.roots.iter().take(if fits { second.len } else { 0 }) {
            if let Some(slot) = slots.next() {
                *slot = [*x, *z];
                len += 1;
                free |= second.free;
            }
        }
    }
    Stage { len, free, ..Stage::solved(roots, Measure::DIRECTION) }
}
