//! Least squares within a box.

use super::brake::clamp;
use crate::math::Scalar;

/// The equations `rows x = error` of six rows, with a damping: the least of `|rows x - error|^2 + damping |x|^2`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Normal<T, const N: usize> {
    matrix: [[T; N]; N],
}

/// Where a joint is in its interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AtBound {
    Free,
    Low,
    High,
    Fixed,
}

// Rows and columns as the formulas number them.
#[allow(clippy::needless_range_loop)]
impl<T: Scalar, const N: usize> Normal<T, N> {
    /// The matrix `rows^T rows + damping`.
    pub(super) fn new(rows: &[[T; N]; 6], damping: T) -> Self {
        let product = |i: usize, j: usize| rows.iter().fold(T::ZERO, |sum, row| sum + row[i] * row[j]);
        let mut matrix = [[T::ZERO; N]; N];
        for i in 0..N {
            for j in 0..i {
                let sum = product(i, j);
                (matrix[i][j], matrix[j][i]) = (sum, sum);
            }
            matrix[i][i] = product(i, i) + damping;
        }
        Self { matrix }
    }

    /// The least squares within `low <= x <= high`, where `low <= 0 <= high`, by an active set: every iterate is within
    /// the box and better than the last one (Nocedal and Wright, "Numerical Optimization", section 16.5). At most `4 N`
    /// systems are solved. `factor` is kept from call to call: the next one that starts with the same joints free uses it.
    pub(super) fn within(
        &self,
        rows: &[[T; N]; 6],
        error: &[T; 6],
        low: &[T; N],
        high: &[T; N],
        factor: &mut Option<Factor<T, N>>,
    ) -> [T; N] {
        let mut right = [T::ZERO; N];
        for i in 0..N {
            right[i] = rows.iter().zip(error).fold(T::ZERO, |sum, (row, error)| sum + row[i] * *error);
        }
        let mut x = [T::ZERO; N];
        let mut places = [AtBound::Free; N];
        for (place, (low, high)) in places.iter_mut().zip(low.iter().zip(high)) {
            *place = match () {
                () if *low >= *high => AtBound::Fixed,
                () if *low >= T::ZERO => AtBound::Low,
                () if *high <= T::ZERO => AtBound::High,
                () => AtBound::Free,
            };
        }
        let mut slope = right;
        for _ in 0..4 * N {
            if !factor.as_ref().is_some_and(|known| known.is_of(&places)) {
                *factor = Some(Factor::new(&self.matrix, &places));
            }
            let Some(known) = factor else { break };
            let way = known.solve(&slope);
            // The way of a joint that is not free is 0. A step that stays inside needs no search for the first end.
            let mut stop = None;
            if (0..N).all(|i| x[i] + way[i] >= low[i] && x[i] + way[i] <= high[i]) {
                for i in 0..N {
                    x[i] += way[i];
                }
                if !places.iter().any(|place| matches!(place, AtBound::Low | AtBound::High)) {
                    break;
                }
            } else {
                let share;
                (share, stop) = shortened(&x, &way, low, high);
                for i in 0..N {
                    x[i] = clamp(x[i] + share * way[i], low[i], high[i]);
                }
            }
            slope = self.slope(&right, &x);
            let next = stop.or_else(|| pulled(&places, &slope).map(|joint| (joint, AtBound::Free)));
            let Some((joint, place)) = next else { break };
            if let Some(at) = places.get_mut(joint) {
                *at = place;
            }
        }
        x
    }

    /// Where the sum of squares falls: `right - matrix x`.
    fn slope(&self, right: &[T; N], x: &[T; N]) -> [T; N] {
        let mut slope = *right;
        for (slope, line) in slope.iter_mut().zip(&self.matrix) {
            for (entry, x) in line.iter().zip(x) {
                *slope -= *entry * *x;
            }
        }
        slope
    }
}

/// The Cholesky factor of the rows and columns of free joints; those of the others are 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor<T, const N: usize> {
    lower: [[T; N]; N],
    /// One over the diagonal.
    inverse: [T; N],
}

// Rows and columns as the formulas number them.
#[allow(clippy::needless_range_loop)]
impl<T: Scalar, const N: usize> Factor<T, N> {
    fn new(matrix: &[[T; N]; N], places: &[AtBound; N]) -> Self {
        let (mut lower, mut inverse) = ([[T::ZERO; N]; N], [T::ZERO; N]);
        for i in 0..N {
            if places[i] != AtBound::Free {
                continue;
            }
            let mut square = matrix[i][i];
            for j in 0..i {
                let mut entry = matrix[i][j];
                for k in 0..j {
                    entry -= lower[i][k] * lower[j][k];
                }
                lower[i][j] = entry * inverse[j];
                square -= lower[i][j] * lower[i][j];
            }
            // The damping is above the rounding of a matrix of this size.
            inverse[i] = T::ONE / square.max(T::EPSILON * T::EPSILON).sqrt();
        }
        Self { lower, inverse }
    }

    /// Returns true if these joints are free.
    fn is_of(&self, places: &[AtBound; N]) -> bool {
        self.inverse.iter().zip(places).all(|(inverse, place)| (*inverse != T::ZERO) == (*place == AtBound::Free))
    }

    /// The step of the free joints to their least; 0 of the others.
    fn solve(&self, slope: &[T; N]) -> [T; N] {
        let mut y = [T::ZERO; N];
        for i in 0..N {
            let mut sum = slope[i];
            for j in 0..i {
                sum -= self.lower[i][j] * y[j];
            }
            y[i] = sum * self.inverse[i];
        }
        for i in (0..N).rev() {
            let mut sum = y[i];
            for k in i + 1..N {
                sum -= self.lower[k][i] * y[k];
            }
            y[i] = sum * self.inverse[i];
        }
        y
    }
}

/// The share of the way up to the first end of an interval, with that joint and end; 1 if there is none.
fn shortened<T: Scalar, const N: usize>(
    x: &[T; N],
    way: &[T; N],
    low: &[T; N],
    high: &[T; N],
) -> (T, Option<(usize, AtBound)>) {
    let (mut share, mut stop) = (T::ONE, None);
    for i in 0..N {
        if way[i] == T::ZERO {
            continue;
        }
        let up = way[i] > T::ZERO;
        let room = if up { high[i] - x[i] } else { low[i] - x[i] };
        if room / way[i] < share {
            share = (room / way[i]).max(T::ZERO);
            stop = Some((i, if up { AtBound::High } else { AtBound::Low }));
        }
    }
    (share, stop)
}

/// The joint at an end of its interval that is pulled inward most.
fn pulled<T: Scalar, const N: usize>(places: &[AtBound; N], slope: &[T; N]) -> Option<usize> {
    let (mut most, mut joint) = (T::EPSILON, None);
    for (i, (place, slope)) in places.iter().zip(slope).enumerate() {
        let inward = match place {
            AtBound::Low => *slope,
            AtBound::High => -*slope,
            AtBound::Free | AtBound::Fixed => T::ZERO,
        };
        if inward > most {
            (most, joint) = (inward, Some(i));
        }
    }
    joint
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: [[f64; 3]; 6] =
        [[2.0, 0.5, 0.0], [0.5, 1.0, -0.3], [0.0, -0.3, 0.7], [0.1, 0.0, 0.2], [0.0; 3], [0.0; 3]];

    fn cost(error: &[f64; 6], damping: f64, x: &[f64; 3]) -> f64 {
        let miss = |(row, e): (&[f64; 3], &f64)| row.iter().zip(x).map(|(a, b)| a * b).sum::<f64>() - e;
        let squares = ROWS.iter().zip(error).map(miss).map(|m| m * m).sum::<f64>();
        squares + damping * x.iter().map(|x| x * x).sum::<f64>()
    }

    /// No point of a fine grid in the box is better.
    #[test]
    fn nothing_in_the_box_is_better() {
        let grid = |low: f64, high: f64| (0..=20).map(move |k| low + (high - low) * f64::from(k) / 20.0);
        for case in 0..60 {
            let at = |k: f64| (f64::from(case) * k).sin();
            let error = [2.0 * at(1.1), at(2.3), at(3.7), at(0.7), 0.0, 0.0];
            let low = [-0.1 - 0.3 * at(1.9).abs(), 0.0, -2.0];
            let high = [0.2 * at(2.9).abs(), 0.4, 0.3 + at(4.1).abs()];
            let normal = Normal::new(&ROWS, 1e-4);
            let x = normal.within(&ROWS, &error, &low, &high, &mut None);
            assert!((0..3).all(|i| x[i] >= low[i] && x[i] <= high[i]), "{x:?}");
            let least = cost(&error, 1e-4, &x);
            for a in grid(low[0], high[0]) {
                for b in grid(low[1], high[1]) {
                    for c in grid(low[2], high[2]) {
                        assert!(cost(&error, 1e-4, &[a, b, c]) >= least - 1e-12, "{case}");
                    }
                }
            }
        }
    }

    #[test]
    fn fixed_joints_stay() {
        let normal = Normal::new(&ROWS, 1e-4);
        let x = normal.within(&ROWS, &[1.0; 6], &[0.0, -5.0, -5.0], &[0.0, 5.0, 5.0], &mut None);
        assert_eq!(x[0], 0.0);
        assert!(x[1] != 0.0 && x[2] != 0.0);
    }
}
