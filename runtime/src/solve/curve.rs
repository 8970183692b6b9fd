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

/// Values of both joints.
type Place<T> = [Turn<T>; 2];

impl<T: Tolerances> Across<T> {
    /// What the lengths across may be at most.
    fn scale(&self) -> T {
        let size = |rows: &[Row<T>; 2]| rows.iter().flatten().fold(T::ZERO, |sum, k| sum + *k * *k);
        size(&self.x).max(size(&self.z)).sqrt()
    }

    /// The lengths across, over either joint.
    fn lengths(&self, [x, z]: &Place<T>) -> [T; 2] {
        let length = |[u, v]: &[Row<T>; 2], turn: &Turn<T>| {
            let (u, v) = (at(u, turn), at(v, turn));
            (u * u + v * v).sqrt()
        };
        [length(&self.x, x), length(&self.z, z)]
    }

    /// The larger of the lengths, relative to what it may be.
    pub(super) fn relative(&self, place: &Place<T>) -> T {
        let ([a, b], scale) = (self.lengths(place), self.scale());
        if scale > T::ZERO { a.max(b) / scale } else { T::ONE }
    }

    /// By how much the lengths differ, relative to what they may be, or the row does if that is more.
    pub(super) fn gap(&self, [p, q]: [&Row<T>; 2], place: &Place<T>) -> T {
        let ([a, b], [x, z]) = (self.lengths(place), place);
        ((a - b) / self.scale()).abs().max((at(p, x) - at(q, z)).abs())
    }
}

/// The value of a row.
pub(super) fn at<T: Tolerances>([a, b, k]: &Row<T>, turn: &Turn<T>) -> T {
    *a * turn.cos + *b * turn.sin + *k
}

pub(super) fn slope<T: Tolerances>([a, b, _]: &Row<T>, turn: &Turn<T>) -> T {
    *b * turn.cos - *a * turn.sin
}

pub(super) fn curvature<T: Tolerances>([a, b, _]: &Row<T>, turn: &Turn<T>) -> T {
    -(*a * turn.cos + *b * turn.sin)
}

fn moved<T: Tolerances>([x, z]: &Place<T>, [dx, dz]: [T; 2]) -> Place<T> {
    [Turn::at(wrap(x.value + dx)), Turn::at(wrap(z.value + dz))]
}

/// A few steps of Newton's method on both rows, as long as they bring the root closer.
pub(super) fn newton<T: Tolerances>(p: &[Row<T>; 2], q: &[Row<T>; 2], root: Place<T>) -> Place<T> {
    let ([p1, p2], [q1, q2]) = (p, q);
    let miss = |[x, z]: &Place<T>| [at(p1, x) - at(q1, z), at(p2, x) - at(q2, z)];
    let square = |[u, v]: [T; 2]| u * u + v * v;
    let mut best = root;
    let mut size = square(miss(&best));
    // The rounding of the rows, which are of unit length.
    let floor = T::EPSILON * T::from_f64(8.0);
    for _ in 0..4 {
        if !(size > floor * floor) {
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
        let next = moved(&best, [dx, dz]);
        let next_size = square(miss(&next));
        if !(next_size < size) {
            break;
        }
        (best, size) = (next, next_size);
    }
    best
}

/// The two roots of `p = q` and of equal lengths across the axis that are nearest to a place where those lengths are
/// small; none where the steps do not lead to one.
///
/// Along the curve of the row, the difference of the squared lengths is to second order a quadratic polynomial, and it
/// is accurate to rounding where the lengths vanish.
pub(super) fn beside<T: Tolerances>(row: [&Row<T>; 2], across: &Across<T>, place: Place<T>) -> [Option<Place<T>>; 2] {
    let Some(start) = Ahead::new(row, across, place) else { return [None; 2] };
    let square = |[dx, dz]: &[T; 2]| *dx * *dx + *dz * *dz;
    start.steps.map(|first| {
        let (mut place, mut step) = (start.place, first?);
        for _ in 0..16 {
            if square(&step) < T::EPSILON * T::EPSILON {
                break;
            }
            let ahead = Ahead::new(row, across, moved(&place, step))?;
            let [low, high] = ahead.steps;
            step = match (low, high) {
                (Some(low), Some(high)) => {
                    if square(&low) < square(&high) {
                        low
                    } else {
                        high
                    }
                }
                (low, high) => low.or(high)?,
            };
            place = ahead.place;
        }
        // Far below what tells two solutions apart.
        let still = T::COINCIDENT * T::from_f64(0.1);
        (square(&step) < still * still).then(|| moved(&place, step))
    })
}

/// A place on the curve of a row, and the steps along it to where the lengths across are equal; none where that is too
/// far to say.
struct Ahead<T> {
    place: Place<T>,
    steps: [Option<[T; 2]>; 2],
}

impl<T: Tolerances> Ahead<T> {
    /// From a place near the curve. `None` if the row does not say which way it goes.
    fn new([p, q]: [&Row<T>; 2], across: &Across<T>, mut place: Place<T>) -> Option<Self> {
        let mut along = [T::ZERO; 2];
        for _ in 0..2 {
            let [x, z] = &place;
            let (miss, dx, dz) = (at(p, x) - at(q, z), slope(p, x), -slope(q, z));
            let square = dx * dx + dz * dz;
            if !(square > T::WEAK * T::WEAK) {
                return None;
            }
            let k = -miss / square;
            along = [-dz / square.sqrt(), dx / square.sqrt()];
            place = moved(&place, [k * dx, k * dz]);
        }
        let ([x, z], [tx, tz]) = (&place, along);
        // The squared length along the curve: half its slope, and half its curvature.
        let second = |rows: &[Row<T>; 2], turn: &Turn<T>, t: T| {
            rows.iter().fold([T::ZERO; 2], |[n1, n2], row| {
                let (v, d, c) = (at(row, turn), slope(row, turn) * t, curvature(row, turn) * t * t);
                [n1 + v * d, n2 + d * d + v * c]
            })
        };
        let ([a1, a2], [b1, b2]) = (second(&across.x, x, tx), second(&across.z, z, tz));
        // The difference of the squares as a product, so that it is as accurate as the lengths.
        let [a0, b0] = across.lengths(&place);
        let (a, half, c) = (a2 - b2, a1 - b1, (a0 - b0) * (a0 + b0));
        let root = (half * half - a * c).max(T::ZERO).sqrt();
        let larger = if half < T::ZERO { root - half } else { -half - root };
        let step = |n: T, d: T| {
            // Without any difference, here is as good as anywhere.
            let s = if n == T::ZERO { T::ZERO } else { n / d };
            (s.abs() < T::HALF).then_some([s * tx, s * tz])
        };
        Some(Self { place, steps: [step(larger, a), step(c, larger)] })
    }
}
