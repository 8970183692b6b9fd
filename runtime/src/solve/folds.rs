//! Solutions that the equations lose beside a singularity: the other root of a fold.
//!
//! Where the table's arm is singular, two of its branches meet, and beyond there is none. The arm that was measured is
//! singular beside that place: between the two it has two solutions where its table has one double root, or none. The
//! arm's own equation, where it holds a joint, may have too few digits to tell the two roots from none. Both
//! follow from a joint vector near the fold: along the direction n in which the joints move the tool least the target is
//! missed by a function of period one turn, `b sin x + a (1 - cos x)`, whose slope and bend two Jacobians give. So both flips
//! of a wrist that is nearly straight are found, half a turn of its outer joints apart.

use super::kernel::tolerances::Tolerances;
use super::least_squares::wrap_angles;
use super::search::Search;
use super::verify::{RESERVED, coincide, distances};
use crate::Solution;

/// A solution at which the joints move the tool by more than this along n, relative to reach and in rad, is not near a
/// fold.
const STEEP: f64 = 0.05;
/// Two solutions that share a root of the equation are nearer to their fold: they move the tool by less.
const SHARED: f64 = 2e-3;
/// Joint vectors that are nearer to each other belong to one fold, in rad and reaches.
const BESIDE: f64 = 1e-3;
/// The bend is taken between Jacobians so far apart, rad.
const ASIDE: f64 = 1e-3;
/// Coordinates of a motion of the tool, and joints that move it.
const SIX: usize = 6;

/// Directions of a square matrix that is nearly singular, of length 1, and the Jacobian's slope `w . J n` along them.
#[derive(Clone, Copy, Debug)]
struct NearlySingular<T> {
    right: [T; SIX],
    left: [T; SIX],
    slope: T,
    /// The part of the error along w.
    missed: T,
}

/// Elimination with complete pivoting, whose last pivot is taken for 0. None if an earlier one vanishes.
#[inline(never)]
fn nearly_singular<T: Tolerances>(columns: &[[T; SIX]; SIX], error: &[T; SIX]) -> Option<NearlySingular<T>> {
    let mut m = [[T::ZERO; SIX]; SIX];
    for (i, row) in m.iter_mut().enumerate() {
        for (entry, column) in row.iter_mut().zip(columns) {
            *entry = column[i];
        }
    }
    let (mut rows, mut joints) = ([0, 1, 2, 3, 4, 5], [0, 1, 2, 3, 4, 5]);
    for k in 0..SIX - 1 {
        let (mut pivot, mut most) = ((k, k), T::ZERO);
        for (i, row) in m.iter().enumerate().skip(k) {
            for (j, entry) in row.iter().enumerate().skip(k) {
                if entry.abs() > most {
                    (pivot, most) = ((i, j), entry.abs());
                }
            }
        }
        if !(most > T::ZERO) {
            return None;
        }
        // Rows and columns of the matrix, as the compiler has to know: nothing here may fail.
        let (row, column) = (pivot.0.min(SIX - 1), pivot.1.min(SIX - 1));
        if let Some([top, .., pivot]) = m.get_mut(k..=row) {
            core::mem::swap(top, pivot);
        }
        rows.swap(k, row);
        m.iter_mut().for_each(|row| row.swap(k, column));
        joints.swap(k, column);
        let top = m[k];
        for row in m.iter_mut().skip(k + 1) {
            let factor = row[k] / top[k];
            // The factors take the place of what vanishes.
            row[k] = factor;
            for (entry, above) in row.iter_mut().zip(&top).skip(k + 1) {
                *entry -= factor * *above;
            }
        }
    }
    let [mut right, mut left] = [[T::ZERO; SIX]; 2];
    (right[SIX - 1], left[SIX - 1]) = (T::ONE, T::ONE);
    for k in (0..SIX - 1).rev() {
        let (mut x, mut y) = (T::ZERO, T::ZERO);
        for i in k + 1..SIX {
            x -= m[k][i] * right[i];
            y -= m[i][k] * left[i];
        }
        (right[k], left[k]) = (x / m[k][k], y);
    }
    let unit = |v: [T; SIX], order: [usize; SIX]| {
        let length = v.iter().fold(T::ZERO, |sum, x| sum + *x * *x).sqrt();
        let mut out = [T::ZERO; SIX];
        for (x, place) in v.iter().zip(order) {
            if let Some(entry) = out.get_mut(place) {
                *entry = *x / length;
            }
        }
        out
    };
    let (right, left) = (unit(right, joints), unit(left, rows));
    let near = NearlySingular { right, left, slope: T::ZERO, missed: dot(error, &left) };
    Some(NearlySingular { slope: slope(columns, &near), ..near })
}

/// `left . J right`.
fn slope<T: Tolerances>(columns: &[[T; SIX]; SIX], NearlySingular { right, left, .. }: &NearlySingular<T>) -> T {
    columns.iter().zip(right).fold(T::ZERO, |sum, (column, x)| sum + dot(column, left) * *x)
}

fn dot<T: Tolerances>(a: &[T; SIX], b: &[T; SIX]) -> T {
    a.iter().zip(b).fold(T::ZERO, |sum, (x, y)| sum + *x * *y)
}

/// The angles x at which `b sin x + a (1 - cos x) = missed`, by the tangent of x / 2; without roots twice an angle near the
/// extremum.
fn turned<T: Tolerances>(b: T, a: T, missed: T) -> [T; 2] {
    let (square, discriminant) = (a + a - missed, b * b + missed * (a + a - missed));
    let root = discriminant.max(T::ZERO).sqrt();
    let sign = if square < T::ZERO { -T::ONE } else { T::ONE };
    let mut angles = [root - b, -root - b];
    for angle in &mut angles {
        *angle = T::TWO * crate::math::atan2(*angle * sign, square.abs());
    }
    angles
}

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'_, T, N, M, S> {
    /// Returns true if the arm that was measured may have solutions to which no branch of its table leads: a solution is
    /// nearly singular, a branch is missed by little, or there is no solution. Several singularities together take a target
    /// farther out of the table's reach than one.
    #[inline(never)]
    pub(super) fn is_near_singular(&mut self) -> bool {
        if self.is_nearly_missed || self.solutions.is_empty() {
            return true;
        }
        for place in 0..M {
            let Some(q) = self.solutions.get(place).map(|solution| solution.q) else { break };
            let Some(evaluations_left) = self.evaluations_left.checked_sub(1 + RESERVED) else { return true };
            self.evaluations_left = evaluations_left + RESERVED;
            let singular = self.nearly_singular_at(&q);
            if !singular.is_some_and(|singular| singular.slope.abs() > self.least_slope()) {
                return true;
            }
        }
        false
    }

    /// Lists what lies on the other side of a fold from the solutions that are listed. One that missed its target was a
    /// start, and leaves the list where it led to solutions.
    #[cold]
    #[inline(never)]
    pub(super) fn unfold(&mut self) {
        // The compiler leaves the rest out for arms of few joints.
        if N < SIX {
            return;
        }
        // Whether a solution that is a start was exact.
        let mut starts = [None; M];
        // What is found on the way lengthens the list, up to its M places.
        for (place, was_exact) in starts.iter_mut().enumerate() {
            let Some(solution) = self.solutions.get(place).copied() else { break };
            // An exact solution of an arm that was not measured has been unfolded where a root led to it.
            if self.slack == T::ZERO && solution.is_exact() {
                continue;
            }
            let both = self.beyond(&solution, T::from_f64(STEEP));
            // Where one of them is its own place it is a solution itself.
            let may_be_start =
                !self.is_rounding(&solution) && (!solution.is_exact() || both.iter().all(Option::is_some));
            for start in both.into_iter().flatten() {
                let found = self.towards(&solution, &start);
                let is_same = |q: [T; N]| !solution.is_exact() || self.is_beside(&q, &solution.q);
                if may_be_start && found.is_some_and(is_same) {
                    *was_exact = Some(solution.is_exact());
                }
            }
        }
        let mut starts = starts.iter();
        // An exact solution may have taken the place of a start that was not.
        self.solutions.retain(|solution| starts.next() != Some(&Some(solution.is_exact())));
    }

    /// Returns true for a solution that misses its target by rounding alone. Beside a fold one that misses it by more is off
    /// by the square root of that.
    fn is_rounding(&self, solution: &Solution<T, N>) -> bool {
        self.constants.relative(&solution.residual) <= T::ROUNDING
    }

    /// Returns true for joint vectors that belong to one fold.
    fn is_beside(&self, a: &[T; N], b: &[T; N]) -> bool {
        distances(self.constants, a, b).all(|distance| distance <= T::from_f64(BESIDE))
    }

    /// Lists the solution on the other side of a fold from an exact one that has a root in common with it.
    #[cold]
    #[inline(never)]
    pub(super) fn unfold_one(&mut self, solution: &Solution<T, N>) {
        if N < SIX {
            return;
        }
        for start in self.beyond(solution, T::from_f64(SHARED)).into_iter().flatten() {
            self.towards(solution, &start);
        }
    }

    /// Solutions that share a name have numbers, but for the first where it had none. Exact ones come first.
    pub(super) fn number_shared(&mut self) {
        for place in 0..M {
            let Some(own) = self.solutions.get(place).copied() else { break };
            let comes_before = |(other_place, other): &(usize, &Solution<T, N>)| {
                let is_first = if other.is_exact() == own.is_exact() { *other_place < place } else { other.is_exact() };
                is_first && other.branch.with_root(0) == own.branch.with_root(0)
            };
            let before = self.solutions.iter().enumerate().filter(comes_before).count();
            let has_number = before > 0 || own.branch.root().is_some();
            if let Some(solution) = self.solutions.as_mut_slice().get_mut(place).filter(|_| has_number) {
                solution.branch = own.branch.with_root_index(before);
            }
        }
    }

    /// The solution to which steps from a joint vector lead. It is listed under the name of that beside it, unless it
    /// already is.
    fn towards(&mut self, neighbor: &Solution<T, N>, start: &[T; N]) -> Option<[T; N]> {
        let constants = self.constants;
        if self.evaluations_left <= RESERVED {
            return None;
        }
        let (mut q, residual) = self.settled(start, true);
        if !(constants.relative(&residual) <= T::EXACT) {
            return None;
        }
        wrap_angles(&mut q, self.goal.given(), constants.prismatic);
        let is_listed = self.solutions.exact().any(|other| coincide(constants, &other.q, &q));
        if !is_listed {
            // Apart from the fold: what is free or on the boundary beside it is not so here.
            let mut solution = Solution::exact(q, neighbor.branch);
            solution.residual = residual;
            self.solutions.mark_awkward();
            if !self.solutions.push(solution) {
                match self.solutions.as_mut_slice().iter_mut().find(|other| !other.is_exact()) {
                    Some(start) => *start = solution,
                    None => self.solutions.mark_incomplete(),
                }
            }
        }
        Some(q)
    }

    /// The joint vectors along n from a solution at which the function vanishes. None if the joints move the tool by more than
    /// `steep` along n.
    fn beyond(&mut self, solution: &Solution<T, N>, steep: T) -> [Option<[T; N]>; 2] {
        let none = [None; 2];
        let Some(evaluations_left) = self.evaluations_left.checked_sub(2 + RESERVED) else { return none };
        self.evaluations_left = evaluations_left + 1 + RESERVED;
        let Some(near) = self.nearly_singular_at(&solution.q) else { return none };
        if !(near.slope.abs() <= steep) {
            return none;
        }
        self.evaluations_left = evaluations_left + RESERVED;
        let aside = T::from_f64(ASIDE);
        let bend = (self.slope_at(&self.along(&solution.q, &near, aside), &near) - near.slope) / aside;
        // Of a solution one root is its own place.
        let missed = if self.is_rounding(solution) { T::ZERO } else { near.missed };
        let rate = self.rate(&near);
        turned(near.slope / rate, bend / (rate * rate), missed).map(|angle| {
            let distance = angle / rate;
            (distance.abs() > T::COINCIDENT).then(|| self.along(&solution.q, &near, distance))
        })
    }

    /// The directions at a joint vector; `None` if the joints that move are not six, or more than one direction vanishes. Out of
    /// line, as [`slope_at`](Self::slope_at): a Jacobian is on the stack for as long as it takes.
    #[inline(never)]
    fn nearly_singular_at(&self, q: &[T; N]) -> Option<NearlySingular<T>> {
        if !self.has_six() {
            return None;
        }
        let (columns, error) = &self.columns(q);
        nearly_singular(columns, error)
    }

    /// The slope along known directions at another joint vector.
    #[inline(never)]
    fn slope_at(&self, q: &[T; N], near: &NearlySingular<T>) -> T {
        let (columns, _) = &self.columns(q);
        slope(columns, near)
    }

    /// The angle by which the joint that turns most turns along n, for a motion of length 1.
    fn rate(&self, singular: &NearlySingular<T>) -> T {
        let (constants, given) = (self.constants, self.goal.given());
        let moving = (0..N).filter(|joint| !given.contains(*joint)).zip(&singular.right);
        let turning = moving.filter(|(joint, _)| !constants.prismatic.contains(*joint));
        turning.fold(T::EPSILON, |most, (_, change)| most.max(change.abs()))
    }

    /// A joint vector so far away in the direction n.
    fn along(&self, q: &[T; N], singular: &NearlySingular<T>, distance: T) -> [T; N] {
        let (mut out, given) = (*q, self.goal.given());
        let moving = out.iter_mut().enumerate().filter(|(joint, _)| !given.contains(*joint));
        for ((joint, value), change) in moving.zip(&singular.right) {
            *value += *change * distance * self.constants.unit(joint);
        }
        out
    }

    /// Returns true if six joints move.
    fn has_six(&self) -> bool {
        let given = self.goal.given();
        N >= SIX && (0..N).filter(|joint| !given.contains(*joint)).count() == SIX
    }

    /// The columns of the first six joints that move, and the error.
    fn columns(&self, q: &[T; N]) -> ([[T; SIX]; SIX], [T; SIX]) {
        let given = self.goal.given();
        let (pose, mut jacobian) = self.arm.evaluate(q);
        self.goal.restrict(&pose, &mut jacobian);
        let k = T::ONE / self.constants.reach;
        let mut columns = [[T::ZERO; SIX]; SIX];
        let moving = (0..N).filter(|joint| !given.contains(*joint));
        for (column, joint) in columns.iter_mut().zip(moving) {
            let unit = self.constants.unit(joint);
            for (place, (entry, row)) in column.iter_mut().zip(&jacobian.rows).enumerate() {
                let scale = if place < 3 { k * unit } else { unit };
                *entry = row.get(joint).copied().unwrap_or(T::ZERO) * scale;
            }
        }
        let [x, y, z, u, v, w] = self.goal.error(q, &pose);
        (columns, [x * k, y * k, z * k, u, v, w])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns without structure, the third one a sum of two others but for a part of the last axis.
    fn columns(part: f64) -> [[f64; SIX]; SIX] {
        let mut columns: [[f64; SIX]; SIX] = core::array::from_fn(|joint| {
            core::array::from_fn(|row| ((7 * row + 3 * joint + row * joint) as f64 + 0.3).sin())
        });
        let (first, last) = (columns[0], columns[5]);
        for ((entry, x), y) in columns[2].iter_mut().zip(first).zip(last) {
            *entry = x - 2.0 * y;
        }
        columns[2][5] += part;
        columns
    }

    #[test]
    fn the_directions_are_those_of_the_singular_matrix() {
        let matrix = columns(0.0);
        let near = nearly_singular(&matrix, &[0.0; SIX]);
        assert!(near.is_some());
        let Some(near) = near else { return };
        // n is in proportion to (1, 0, -1, 0, 0, -2), and w is at right angles to every column.
        let [a, b, c, d, e, f] = near.right;
        assert!((a + c).abs() < 1e-12 && (2.0 * c - f).abs() < 1e-12 && b.abs() + d.abs() + e.abs() < 1e-12);
        assert!(matrix.iter().all(|column| dot(column, &near.left).abs() < 1e-12));
        assert!(near.slope.abs() < 1e-12);
    }

    #[test]
    fn the_function_vanishes_at_both_angles() {
        for (b, a) in [(0.3, 0.2), (-0.01, 0.4), (0.2, -0.3), (0.0, 0.1)] {
            for angle in [-3.0, -0.4, 0.0, 1e-3, 2.2] {
                let function = |x: f64| b * x.sin() + a * (1.0 - x.cos());
                let missed = function(angle);
                let found = turned(b, a, missed);
                assert!(found.iter().all(|x| (function(*x) - missed).abs() < 1e-14), "{b} {a} {angle} {found:?}");
                let distance = |x: &f64| crate::math::wrap(x - angle).abs();
                assert!(found.iter().any(|x| distance(x) < 1e-6), "{b} {a} {angle} {found:?}");
            }
        }
        // Nowhere so far from 0: near the extremum at half a turn.
        assert_eq!(turned(0.0, 0.1, 0.3).map(f64::abs), [0.0; 2]);
    }

    #[test]
    fn the_slope_is_that_along_the_directions() {
        let error = [0.1, -0.4, 0.3, 0.2, 0.0, 0.7];
        let near = nearly_singular(&columns(1e-4), &error);
        assert!(near.is_some_and(|near| near.slope.abs() > 1e-7 && near.slope.abs() < 1e-4));
        assert!(near.is_some_and(|near| near.missed == dot(&error, &near.left)));
        assert!(nearly_singular(&[[0.0; SIX]; SIX], &error).is_none());
    }
}
