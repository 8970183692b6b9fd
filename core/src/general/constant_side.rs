//! The side of the equations that only two joints move: what it leaves to the other side, and how these two follow.

use super::line::{COORDINATES, PRODUCTS};

/// Unknown products of two joints' monomials, all but the constant one.
const UNKNOWNS: usize = PRODUCTS - 1;
/// Equations that remain.
pub const EQUATIONS: usize = COORDINATES - UNKNOWNS;
/// Monomials of one joint alone: two of each of the two joints.
pub const SINGLES: usize = 4;
/// Products of two joints stand before the single ones.
const BOTH: usize = UNKNOWNS - SINGLES;
/// Columns of the orthogonal factor that are needed: those of the single monomials, and the null space.
const NEEDED: usize = SINGLES + EQUATIONS;
/// A column shorter than this share of the longest one depends on those before it.
const DEPENDENT: f64 = 1e-9;
/// Entries up to this are rounding of 0.
const ROUNDING: f64 = 1e-12;

/// Line coordinates w of the other side fulfil `A x = w - constant`, with the unknown monomials x of joints a and b.
#[derive(Clone, Copy)]
pub(super) struct ConstantSide {
    /// Six orthonormal rows n with `n A = 0`.
    pub(super) null: [[f64; COORDINATES]; EQUATIONS],
    /// Four rows of the pseudo-inverse of A: `cos b, sin b, cos a, sin a`.
    pub(super) pseudo: [[f64; COORDINATES]; SINGLES],
}

impl ConstantSide {
    /// Householder's reduction of A, 14 by 8. None if its rank is less than 8.
    ///
    /// Only sums, products, quotients and square roots, in a fixed order: the same bits on every processor.
    pub(super) fn of(sums: &[[f64; PRODUCTS]; COORDINATES]) -> Option<Self> {
        let mut a = sums.map(in_order);
        let mut reflectors = [([0.0; COORDINATES], 0.0); UNKNOWNS];
        let mut diagonal = [0.0; UNKNOWNS];
        let mut longest = 0.0_f64;
        for (k, (reflector, scale)) in reflectors.iter_mut().enumerate() {
            let mut square = 0.0;
            for i in k..COORDINATES {
                reflector[i] = a[i][k];
                square += a[i][k] * a[i][k];
            }
            let length = crate::math::sqrt(square);
            longest = longest.max(length);
            let is_independent = length > DEPENDENT * longest;
            if !is_independent {
                return None;
            }
            let signed = if reflector[k] < 0.0 { -length } else { length };
            // |v|^2 = 2 |x| (|x| + |x_k|)
            *scale = 1.0 / (length * (length + reflector[k].abs()));
            reflector[k] += signed;
            reflect(&mut a, reflector, *scale, k);
            diagonal[k] = -signed;
        }
        // The last columns of the orthogonal factor: the reflections in reverse order.
        let mut q = [[0.0; NEEDED]; COORDINATES];
        for (place, row) in q.iter_mut().skip(BOTH).enumerate() {
            if let Some(entry) = row.get_mut(place) {
                *entry = 1.0;
            }
        }
        for (k, (reflector, scale)) in reflectors.iter().enumerate().rev() {
            reflect(&mut q, reflector, *scale, k);
        }
        let mut null = [[0.0; COORDINATES]; EQUATIONS];
        let mut pseudo = [[0.0; COORDINATES]; SINGLES];
        for (column, row) in q.iter().enumerate() {
            for (i, line) in null.iter_mut().enumerate() {
                line[column] = rounded(row[SINGLES + i]);
            }
            // R x = Q^T w, of which the last four rows have no other unknowns.
            let mut x = [0.0; SINGLES];
            for i in (0..SINGLES).rev() {
                let mut rest = row[i];
                for j in i + 1..SINGLES {
                    rest -= a[BOTH + i][BOTH + j] * x[j];
                }
                x[i] = rest / diagonal[BOTH + i];
                pseudo[i][column] = rounded(x[i]);
            }
        }
        Some(Self { null, pseudo })
    }
}

/// The entries of a row in the order of elimination: products of two joints, then `cos b, sin b, cos a, sin a`.
fn in_order([cc, cs, cos_b, sc, ss, sin_b, cos_a, sin_a, _]: [f64; PRODUCTS]) -> [f64; UNKNOWNS] {
    [cc, cs, sc, ss, cos_b, sin_b, cos_a, sin_a]
}

/// `m - scale v (v^T m)`, where v is zero before row `from`.
#[inline(always)]
fn reflect<const N: usize>(m: &mut [[f64; N]; COORDINATES], v: &[f64; COORDINATES], scale: f64, from: usize) {
    let mut sums = [0.0; N];
    for (row, x) in m.iter().zip(v).skip(from) {
        sums.iter_mut().zip(row).for_each(|(sum, entry)| *sum += x * entry);
    }
    for (row, x) in m.iter_mut().zip(v).skip(from) {
        let factor = scale * x;
        row.iter_mut().zip(&sums).for_each(|(entry, sum)| *entry -= factor * sum);
    }
}

fn rounded(x: f64) -> f64 {
    if x.abs() <= ROUNDING { 0.0 } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_space_and_pseudo_inverse_are_those_of_the_matrix() {
        let mut state = 7_u64;
        let sums: [[f64; PRODUCTS]; COORDINATES] = core::array::from_fn(|_| {
            core::array::from_fn(|_| {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
            })
        });
        let product = |row: &[f64; COORDINATES], column: usize| {
            row.iter().zip(&sums).map(|(x, entries)| x * entries[column]).sum::<f64>()
        };
        let side = ConstantSide::of(&sums);
        assert!(side.is_some());
        let Some(side) = side else { return };
        for (i, row) in side.null.iter().enumerate() {
            assert!((0..UNKNOWNS).all(|column| product(row, column).abs() < 1e-14));
            for (j, other) in side.null.iter().enumerate() {
                let dot: f64 = row.iter().zip(other).map(|(x, y)| x * y).sum();
                assert!((dot - if i == j { 1.0 } else { 0.0 }).abs() < 1e-14);
            }
        }
        for (i, row) in side.pseudo.iter().enumerate() {
            for (j, column) in [0, 1, 3, 4, 2, 5, 6, 7].into_iter().enumerate() {
                assert!((product(row, column) - if j == BOTH + i { 1.0 } else { 0.0 }).abs() < 1e-13);
            }
        }
        let twice = sums.map(|mut row| {
            row[5] = row[0] + row[1];
            row
        });
        assert!(ConstantSide::of(&twice).is_none());
    }
}
