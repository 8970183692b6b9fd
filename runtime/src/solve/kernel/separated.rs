//! Two equations in two joints whose rows lose rank.

use super::curve::Row;
use super::doubt::Doubt;
use super::offset::offset;
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};

impl<T: Tolerances> Roots<T, 2, 4> {
    /// Swaps the two joints in every root.
    pub(super) fn swapped(mut self) -> Self {
        for [x, z] in &mut self.roots {
            core::mem::swap(x, z);
        }
        self
    }
}

/// Rows of lost rank: the combination without `x` gives `z`, the other one `x`; or the other way round.
pub(super) fn separated<T: Tolerances>(
    [default_x, default_z]: [DefaultValue<T>; 2],
    p: &[Row<T>; 2],
    q: &[Row<T>; 2],
) -> Roots<T, 2, 4> {
    let (n, m) = (null_row(p, q), null_row(q, p));
    let amplitude = |n: [T; 2], rows: &[Row<T>; 2]| {
        let [a, b, _] = combined(n, rows);
        a * a + b * b
    };
    if amplitude(n, q) >= amplitude(m, p) {
        in_turn([default_x, default_z], n, p, q)
    } else {
        in_turn([default_z, default_x], m, q, p).swapped()
    }
}

/// A unit combination of the rows in which `x` drops out as far as it can. If `x` never appears, the combination with
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

/// The combination of two rows.
pub(super) fn combined<T: Tolerances>([n1, n2]: [T; 2], [a, b]: &[Row<T>; 2]) -> Row<T> {
    [n1 * a[0] + n2 * b[0], n1 * a[1] + n2 * b[1], n1 * a[2] + n2 * b[2]]
}

fn in_turn<T: Tolerances>(
    [default_x, default_z]: [DefaultValue<T>; 2],
    n: [T; 2],
    p: &[Row<T>; 2],
    q: &[Row<T>; 2],
) -> Roots<T, 2, 4> {
    let ([.., p0], [qc, qs, q0]) = (combined(n, p), combined(n, q));
    let across = [-n[1], n[0]];
    let ([pc, ps, p1], [rc, rs, r0]) = (combined(across, p), combined(across, q));
    let first = offset(default_z, Measure::DIRECTION, qc, qs, p0 - q0);
    let mut roots = [[Turn::ZERO; 2]; 4];
    let mut slots = roots.iter_mut();
    let (mut len, mut free) = (0, first.free());
    // A free z stays where x can follow it; else it goes to the middle of where x can.
    let beyond = |[z]: &[Turn<T>; 1]| {
        let wanted = rc * z.cos + rs * z.sin + r0 - p1;
        wanted * wanted > pc * pc + ps * ps
    };
    let moved = !free.is_empty() && first.roots.first().is_some_and(beyond);
    let first = if moved { offset(default_z, Measure::DIRECTION, rc, rs, p1 - r0) } else { first };
    for [z] in first.roots.iter().take(first.len) {
        let wanted = rc * z.cos + rs * z.sin + r0 - p1;
        let second = offset(default_x, Measure::DIRECTION, pc, ps, wanted);
        let fits = second.free().is_empty() || wanted.abs() <= T::COINCIDENT;
        for [x] in second.roots.iter().take(if fits { second.len } else { 0 }) {
            if let Some(slot) = slots.next() {
                *slot = [*x, *z];
                len += 1;
                free |= second.free();
            }
        }
    }
    let doubt = (!free.is_empty()).then_some(Doubt { free, ..Doubt::NOTHING });
    Roots { len, doubt, ..Roots::solved(roots) }
}
