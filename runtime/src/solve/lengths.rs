//! Two vectors of equal length, each moved by the same angle.

use super::curve::{Row, at, curvature, slope};
use super::{Tolerances, Turn};
use crate::math::wrap;

/// Components of two vectors in a plane, as rows of one angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lengths<T> {
    /// The one as a sliding joint moves it, which follows the angle.
    pub of_x: [Row<T>; 2],
    /// The other.
    pub of_z: [Row<T>; 2],
}

impl<T: Tolerances> Lengths<T> {
    fn scale(&self) -> T {
        let size = |rows: &[Row<T>; 2]| rows.iter().flatten().fold(T::ZERO, |sum, k| sum + *k * *k);
        size(&self.of_x).max(size(&self.of_z)).sqrt()
    }

    fn lengths(&self, z: &Turn<T>) -> [T; 2] {
        [&self.of_x, &self.of_z].map(|[u, v]| {
            let (u, v) = (at(u, z), at(v, z));
            (u * u + v * v).sqrt()
        })
    }

    /// The longer of the two, relative to what it may be.
    pub(super) fn relative(&self, z: &Turn<T>) -> T {
        let ([a, b], scale) = (self.lengths(z), self.scale());
        if scale > T::ZERO { a.max(b) / scale } else { T::ONE }
    }

    /// By how much they differ, relative to what they may be.
    pub(super) fn gap(&self, z: &Turn<T>) -> T {
        let [a, b] = self.lengths(z);
        ((a - b) / self.scale()).abs()
    }

    /// The steps to where the lengths are equal, to second order, the difference of their squares as a product; none that is too far.
    fn steps(&self, z: &Turn<T>) -> [Option<T>; 2] {
        let second = |rows: &[Row<T>; 2]| {
            rows.iter().fold([T::ZERO; 3], |[n1, n2, size], row| {
                let (v, d, c) = (at(row, z), slope(row, z), curvature(row, z));
                [n1 + v * d, n2 + d * d + v * c, size + d * d + (v * c).abs()]
            })
        };
        let ([a1, a2, size_a], [b1, b2, size_b], [a0, b0]) = (second(&self.of_x), second(&self.of_z), self.lengths(z));
        let (a, half, c) = (a2 - b2, a1 - b1, (a0 - b0) * (a0 + b0));
        // Three roots that meet are more than a second order knows.
        if !(a.abs() > T::DOUBTFUL * (size_a + size_b)) {
            return [None; 2];
        }
        let root = (half * half - a * c).max(T::ZERO).sqrt();
        let larger = if half < T::ZERO { root - half } else { -half - root };
        let step = |n: T, d: T| {
            // Without any difference, here is as good as anywhere.
            let s = if n == T::ZERO { T::ZERO } else { n / d };
            (s.abs() < T::HALF).then_some(s)
        };
        [step(larger, a), step(c, larger)]
    }

    /// The two angles of equal lengths that are nearest to a place where both are small; none where the steps do not lead to one.
    pub(super) fn equal_beside(&self, start: Turn<T>) -> [Option<Turn<T>>; 2] {
        self.steps(&start).map(|first| {
            let (mut z, mut step) = (start, first?);
            for _ in 0..16 {
                z = Turn::at(wrap(z.value + step));
                if step.abs() < T::EPSILON {
                    break;
                }
                let [low, high] = self.steps(&z);
                step = match (low, high) {
                    (Some(low), Some(high)) => {
                        if low.abs() < high.abs() {
                            low
                        } else {
                            high
                        }
                    }
                    (low, high) => low.or(high)?,
                };
            }
            // Far below what tells two solutions apart.
            (step.abs() < T::COINCIDENT * T::from_f64(0.1)).then_some(z)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beside(middle: f64, apart: f64) -> Lengths<f64> {
        // |of_x|^2 - |of_z|^2 is to first order a multiple of (z - middle)^2 - apart^2.
        let (s, c) = middle.sin_cos();
        let of_x = [[-s, c, 0.0], [0.0, 0.0, 0.5]];
        Lengths { of_x, of_z: [[0.0, 0.0, apart.sin()], [0.0, 0.0, 0.5]] }
    }

    #[test]
    fn two_equal_lengths_beside_each_other_are_told_apart() {
        for digits in 1..=7 {
            let apart = 10.0_f64.powi(-digits);
            let found = beside(0.7, apart).equal_beside(Turn::at(0.7)).map(|z| z.map_or(9.0, |z| z.value - 0.7));
            let [low, high] = if found[0] < found[1] { found } else { [found[1], found[0]] };
            // The lengths themselves are of order one, so that their difference is known to rounding.
            let accuracy = 1e-15 / apart;
            assert!((low + apart).abs() < accuracy && (high - apart).abs() < accuracy, "{apart}: {found:?}");
        }
    }

    #[test]
    fn lengths_far_from_equal_have_nothing_beside() {
        let far = Lengths { of_x: [[0.0, 0.0, 2.0], [0.0; 3]], of_z: [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0]] };
        assert_eq!(far.equal_beside(Turn::at(0.3)), [None; 2]);
    }
}
