//! Damped least-squares steps on a chain, for the choice of cuts at build time and for tests.

use crate::chain::{Chain, Miss};
use crate::{Scalar, Transform};

/// An error up to so many roundings is none.
const ROUNDING: f64 = 8.0;
/// No joint moves farther in a step, in rad or reaches.
const LONGEST: f64 = 0.6;
/// Damping at first, in units of the squared error.
const DAMPING: f64 = 0.1;

/// A joint vector after refinement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refined<T> {
    /// The best joint vector. Angles are not wrapped.
    pub joints: [T; 6],
    /// Its residual, see [`Miss`].
    pub residual: T,
    /// The number of evaluations of pose and Jacobian.
    pub evaluations: usize,
}

impl<T: Scalar> Chain<T> {
    /// Descends from `joints` towards the target.
    ///
    /// A step solves `(J^T J + damping |e|^2) dq = J^T e`, or `J dq = e` where the damping is below rounding. Towards a
    /// double root each step leaves a quarter of the error: the next one is taken twice. At most `most` evaluations,
    /// and at least one.
    pub fn refined(&self, joints: &[T; 6], target: &Transform<T>, most: usize) -> Refined<T> {
        let mut best = Place::at(self, *joints, target);
        let mut evaluations = 1;
        let rounding = T::from_f64(ROUNDING) * T::EPSILON;
        let (mut damping, mut stretch) = (T::from_f64(DAMPING), T::ONE);
        for _ in 1..most {
            if best.size <= rounding || !best.size.is_finite() {
                break;
            }
            let Some(step) = step(&best.columns, &best.error, damping * best.size * best.size) else { break };
            let longest = step.iter().fold(T::ZERO, |most, x| most.max(x.abs()));
            let limit = T::from_f64(LONGEST);
            let share = if longest > limit { limit / longest } else { stretch };
            let mut joints = best.joints;
            for ((joint, dq), is_prismatic) in joints.iter_mut().zip(step).zip(self.is_prismatic) {
                *joint += share * dq * if is_prismatic { self.reach } else { T::ONE };
            }
            let next = Place::at(self, joints, target);
            evaluations += 1;
            if next.size < best.size {
                let left = next.size / best.size;
                damping *= T::from_f64(0.3);
                if left > T::from_f64(0.9) {
                    damping *= T::from_f64(10.0);
                }
                let is_quarter = left > T::from_f64(0.15) && left < T::from_f64(0.4);
                stretch = if stretch == T::ONE && is_quarter { T::TWO } else { T::ONE };
                best = next;
            } else if stretch > T::ONE {
                stretch = T::ONE;
            } else if best.size < T::from_f64(50.0) * rounding {
                break;
            } else {
                damping = (damping * T::from_f64(30.0)).max(T::from_f64(1e-3));
            }
        }
        Refined { joints: best.joints, residual: best.residual, evaluations }
    }
}

/// A joint vector with what it misses the target by.
struct Place<T> {
    joints: [T; 6],
    error: [T; 6],
    /// Length of the error.
    size: T,
    residual: T,
    /// The Jacobian, displacements in reaches.
    columns: [[T; 6]; 6],
}

impl<T: Scalar> Place<T> {
    fn at(chain: &Chain<T>, joints: [T; 6], target: &Transform<T>) -> Self {
        let Miss { error, mut jacobian, residual } = chain.miss(&joints, target);
        for row in &mut jacobian {
            for (entry, is_prismatic) in row.iter_mut().zip(chain.is_prismatic) {
                *entry *= if is_prismatic { chain.reach } else { T::ONE };
            }
        }
        let size = error.iter().fold(T::ZERO, |sum, x| sum + *x * *x).sqrt();
        Self { joints, error, size, residual, columns: jacobian }
    }
}

/// The solution of `(J^T J + damping) x = J^T e`; of `J x = e` where the damping is below rounding and J regular.
fn step<T: Scalar>(jacobian: &[[T; 6]; 6], error: &[T; 6], damping: T) -> Option<[T; 6]> {
    if damping < T::from_f64(1e-12)
        && let Some(x) = eliminated(*jacobian, *error, T::from_f64(1e-6))
    {
        return Some(x);
    }
    let (mut normal, mut right) = ([[T::ZERO; 6]; 6], [T::ZERO; 6]);
    for (row, e) in jacobian.iter().zip(error) {
        for ((sums, sum), x) in normal.iter_mut().zip(&mut right).zip(row) {
            *sum += *x * *e;
            sums.iter_mut().zip(row).for_each(|(entry, y)| *entry += *x * *y);
        }
    }
    for (place, row) in normal.iter_mut().enumerate() {
        row[place] += damping + T::from_f64(4.0) * T::EPSILON;
    }
    eliminated(normal, right, T::ZERO)
}

/// Solves a linear system with row pivots. None if a pivot is not greater than `least`.
fn eliminated<T: Scalar>(mut matrix: [[T; 6]; 6], mut right: [T; 6], least: T) -> Option<[T; 6]> {
    for k in 0..6 {
        let mut pivot = k;
        for i in k + 1..6 {
            if matrix[i][k].abs() > matrix[pivot][k].abs() {
                pivot = i;
            }
        }
        matrix.swap(pivot, k);
        right.swap(pivot, k);
        let (row, value) = (matrix[k], right[k]);
        if row[k].abs() <= least {
            return None;
        }
        let inverse = T::ONE / row[k];
        for i in k + 1..6 {
            let factor = matrix[i][k] * inverse;
            for j in k + 1..6 {
                matrix[i][j] -= factor * row[j];
            }
            right[i] -= factor * value;
        }
    }
    for k in (0..6).rev() {
        for j in k + 1..6 {
            let known = matrix[k][j] * right[j];
            right[k] -= known;
        }
        right[k] /= matrix[k][k];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use crate::Chain;
    use crate::chain::tests::tilted;

    #[test]
    fn near_starts_reach_the_target() {
        let links = [0.3, -1.0, 0.7, 1.5, -0.4, 0.9, 2.0].map(|x| tilted(x, [0.2 * x, 0.1, 0.3 - x]));
        for slide in 0..6 {
            let chain = Chain::new(links, core::array::from_fn(|joint| joint == slide));
            let joints = [0.3, -0.8, 0.25, 2.0, -0.1, 1.2];
            let target = chain.pose(&joints);
            let found = chain.refined(&joints.map(|q| q + 0.02), &target, 12);
            assert!(found.residual < 1e-14, "{slide}: {found:?}");
            assert!(found.joints.iter().zip(joints).all(|(a, b)| (a - b).abs() < 1e-12));
            assert!(found.evaluations < 7);
        }
    }
}
