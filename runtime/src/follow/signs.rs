//! On which side of each singularity joint values are.

use crate::arm::InverseKinematics;
use crate::deviation::Deviation;
use crate::math::Scalar;

/// Most factors of an arm that are looked at.
const MOST: usize = 8;

/// Bound of the change of a factor with a joint, per rad or per stroke over the reach. Factors are products of sines, cosines
/// and lengths over the reach: 1 for nearly all arms, and 2.3 where the last of two slides makes an arm longer than its reach.
const SLOPE: f64 = 3.0;

/// The signs of the factors of the determinant of a Jacobian: one bit each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Signs {
    above: u8,
    below: u8,
    open: u8,
}

/// The factors of the determinant of a Jacobian.
pub(super) struct Factors<T> {
    values: [T; MOST],
    count: usize,
}

impl<T: Scalar> Factors<T> {
    /// The factors at `q`; none of an arm that has none.
    #[inline(always)]
    pub(super) fn at<A: InverseKinematics<T, N>, const N: usize>(arm: &A, q: &[T; N]) -> Self {
        let mut values = [T::ZERO; MOST];
        let count = arm.factors(q, &mut values);
        Self { values, count }
    }

    /// Their signs. Without factors the sign of the determinant at `q`, where the rows that the target asks for are as many
    /// as the joints that move. A factor of 0, up to rounding, has no sign.
    // An arm has a constant number of factors: inlined, one with factors does without the code of the determinant.
    #[inline(always)]
    pub(super) fn signs<A: InverseKinematics<T, N>, const N: usize>(
        &self,
        arm: &A,
        q: &[T; N],
        target: Option<&A::Target>,
    ) -> Signs {
        if self.count > 0 { self.noted() } else { Signs::of_determinant(arm, q, target) }
    }

    #[inline(never)]
    fn noted(&self) -> Signs {
        let mut signs = Signs::default();
        for (place, factor) in self.values.iter().take(self.count).enumerate() {
            signs.note(place, *factor);
        }
        signs
    }

    /// The size of the smallest, but for the one at a place; 0 where not all are known.
    pub(super) fn least(&self, but: Option<usize>) -> T {
        if self.count > MOST {
            return T::ZERO;
        }
        let others = self.values.iter().take(self.count).enumerate().filter(|(place, _)| but != Some(*place));
        others.fold(T::INFINITY, |least, (_, factor)| least.min(factor.abs()))
    }
}

/// The most that the factors of an arm change by as its joints move. `steps`: the sum of their ways, angles in rad and strokes
/// over the reach.
pub(super) fn change_of_factors<T: Scalar>(steps: T) -> T {
    T::from_f64(SLOPE) * steps
}

impl Signs {
    /// The signs of the [`Factors`] at `q`.
    pub(super) fn at<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        q: &[T; N],
        target: Option<&A::Target>,
    ) -> Self {
        Factors::at(arm, q).signs(arm, q, target)
    }

    /// The sign of the determinant at `q`, of an arm without factors.
    #[inline(never)]
    fn of_determinant<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
        arm: &A,
        q: &[T; N],
        target: Option<&A::Target>,
    ) -> Self {
        let deviation = |target| arm.deviation(q, target, &arm.forward_and_jacobian(q));
        let mut signs = Self::default();
        signs.note(0, target.map_or(T::ZERO, |target| determinant(&deviation(target))));
        signs
    }

    fn note<T: Scalar>(&mut self, place: usize, factor: T) {
        let bit = 1u8.checked_shl(place as u32).unwrap_or(0);
        let rounding = T::from_f64(64.0) * T::EPSILON;
        if factor > rounding {
            self.above |= bit;
        } else if factor < -rounding {
            self.below |= bit;
        } else {
            self.open |= bit;
        }
    }

    /// Returns true if a factor has opposite signs in the two.
    pub(super) const fn differ(self, other: Self) -> bool {
        self.above & other.below | self.below & other.above != 0
    }

    /// These signs; those of `before` for factors that have none.
    pub(super) const fn or(self, before: Self) -> Self {
        let (above, below) = (self.above | before.above & self.open, self.below | before.below & self.open);
        Self { above, below, open: self.open & !(above | below) }
    }

    /// Returns true if the factor at `place` has opposite signs in the two, and no other has.
    pub(super) const fn differ_in(self, other: Self, place: usize) -> bool {
        place < MOST && self.above & other.below | self.below & other.above == 1 << place
    }
}

/// The determinant of the rows that the target asks for by the joints that move, relative to the lengths of its rows; 0
/// where that matrix is not square.
fn determinant<T: Scalar, const N: usize>(deviation: &Deviation<T, N>) -> T {
    let mut matrix = [[T::ZERO; 6]; 6];
    let mut rows = 0;
    let moving = || (0..N).filter(|joint| !deviation.given.contains(*joint));
    let columns = moving().count();
    for row in &deviation.jacobian.rows {
        if columns > 6 || row.iter().all(|entry| *entry == T::ZERO) {
            continue;
        }
        let length = row.iter().fold(T::ZERO, |sum, entry| sum + *entry * *entry).sqrt();
        if let Some(line) = matrix.get_mut(rows) {
            for (entry, joint) in line.iter_mut().zip(moving()) {
                *entry = row.get(joint).copied().unwrap_or(T::ZERO) / length;
            }
        }
        rows += 1;
    }
    if rows == columns { eliminated(matrix, rows) } else { T::ZERO }
}

/// The determinant of the first `size` rows and columns, by elimination with the largest entry of each column.
fn eliminated<T: Scalar>(mut matrix: [[T; 6]; 6], size: usize) -> T {
    let mut product = T::ONE;
    let size = size.min(6);
    for column in 0..size {
        let rows = matrix.get_mut(column..size).and_then(<[_]>::split_first_mut);
        let Some((pivot, below)) = rows else { return T::ZERO };
        for line in below.iter_mut() {
            if line[column].abs() > pivot[column].abs() {
                core::mem::swap(line, pivot);
                product = -product;
            }
        }
        product *= pivot[column];
        if pivot[column] == T::ZERO {
            return T::ZERO;
        }
        for line in below {
            let share = line[column] / pivot[column];
            for (entry, above) in line.iter_mut().zip(&*pivot) {
                *entry -= share * *above;
            }
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Jacobian, JointMask};

    #[test]
    fn a_factor_of_zero_has_the_sign_it_had() {
        let of = |factors: [f64; 2]| {
            let mut signs = Signs::default();
            for (place, factor) in factors.into_iter().enumerate() {
                signs.note(place, factor);
            }
            signs
        };
        let (start, zero, other) = (of([1.0, -1.0]), of([1e-17, -0.5]), of([-0.1, -0.5]));
        assert!(!start.differ(zero) && zero.or(start) == start);
        assert!(start.differ(other) && zero.or(start).differ(other) && !zero.differ(other));
    }

    #[test]
    fn the_determinant_is_that_of_what_moves() {
        let rows = [[2.0, 9.0, 0.0], [0.0, 9.0, -3.0], [0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]];
        let of = |given| determinant(&Deviation { twist: [0.0; 6], jacobian: Jacobian { rows }, given });
        let along = |x: f64, y: f64| (x * x + y * y).sqrt();
        let wanted = -6.0 / (along(2.0, 9.0) * along(9.0, 3.0));
        assert!((of(JointMask::single(1)) - wanted).abs() < 1e-15);
        assert_eq!(of(JointMask::NONE), 0.0);
    }
}
