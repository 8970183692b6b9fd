//! Joints e and f with c held, without elimination.
//!
//! With c held, the six equations are `A(f) (cos e, sin e, 1) = 0`: six rows and three columns, whose entries are linear in
//! cos f and sin f. At a solution A has rank 2, and rank 1 where two solutions share c and f. So the determinant of three
//! combinations of the rows vanishes there. The determinant is a trigonometric polynomial of degree 3 in f. At its other roots
//! the other rows do not vanish, and the ring does not close.
//!
//! The 6x6 determinant of the elimination may vanish at a solution, and two roots for c may be nearer to each other than c is
//! known. Neither matters here.

use super::equations::{Equations, Position, Span};
use super::line::{MONOMIALS, PRODUCTS};
use crate::transform::{cross, dot};
use crate::trig_polynomial::{Fit, Roots};

/// Three combinations of six rows, in no proportion that an arm has.
const COMBINED: [[f64; 6]; 3] = [
    [0.61, -0.35, 0.27, 0.48, -0.19, 0.41],
    [0.23, 0.58, -0.44, 0.17, 0.52, -0.36],
    [-0.39, 0.21, 0.55, -0.31, 0.46, 0.43],
];

/// The rows have length 1. A determinant that is nowhere greater than this vanishes.
const VANISHES: f64 = 1e-13;

/// Rows that are no farther from one line than this share may have rank 1: c is not known better.
const NEARLY: f64 = 1e-2;

/// The six equations with c held.
pub(super) struct Held {
    rows: [[f64; PRODUCTS]; 6],
    combined: [[f64; PRODUCTS]; 3],
    is_prismatic: [bool; 2],
}

/// Joint e at a root for f.
pub(super) struct AtF {
    pub(super) f: Position,
    /// If A has rank 2.
    pub(super) one: Position,
    /// If A has rank 1.
    pub(super) two: [Position; 2],
    pub(super) may_be_two: bool,
    /// Nothing depends on e: A has rank 0.
    pub(super) is_free: bool,
}

impl Equations {
    /// The equations with c held at the angle with this sine and cosine.
    pub(super) fn held(&self, (sin, cos): (f64, f64)) -> Held {
        let mut rows = [[0.0; PRODUCTS]; 6];
        for (row, ((a, b), c)) in rows.iter_mut().zip(self.cos.iter().zip(&self.sin).zip(&self.one)) {
            for (entry, ((x, y), z)) in row.iter_mut().zip(a.iter().zip(b).zip(c)) {
                *entry = x * cos + y * sin + z;
            }
        }
        let mut combined = [[0.0; PRODUCTS]; 3];
        for (sum, weights) in combined.iter_mut().zip(&COMBINED) {
            for (row, weight) in rows.iter().zip(weights) {
                sum.iter_mut().zip(row).for_each(|(x, y)| *x += weight * y);
            }
        }
        Held { rows, combined, is_prismatic: self.is_prismatic }
    }
}

impl Held {
    /// The roots of the determinant. None if it vanishes for all f.
    ///
    /// They are angles t with `f = t`, or `f = tan(t / 2)` for a prismatic f.
    pub(super) fn roots(&self) -> Option<Roots> {
        let fit = Fit::sampled(|t| {
            let monomials = self.monomials(t);
            let [a, b, c] = self.combined.map(|row| in_e(&row, &monomials));
            dot(a, cross(b, c))
        });
        (fit.greatest > VANISHES).then(|| fit.roots())
    }

    /// Joint e at a root, given by its sine and cosine.
    pub(super) fn at(&self, root: (f64, f64)) -> AtF {
        let monomials = self.monomials(root);
        let rows = self.rows.map(|row| in_e(&row, &monomials));
        let span = Span::of(rows);
        let [slides_e, slides_f] = self.is_prismatic;
        AtF {
            f: Position::of(slides_f, monomials),
            one: Position::of(slides_e, span.normal),
            two: span.roots(slides_e).map(|monomials| Position::of(slides_e, monomials)),
            may_be_two: span.is_line(NEARLY),
            is_free: span.is_zero(),
        }
    }

    /// The monomials of f, but for a factor.
    fn monomials(&self, (sin, cos): (f64, f64)) -> [f64; MONOMIALS] {
        let [_, slides] = self.is_prismatic;
        if slides { [0.5 * (1.0 - cos), 0.5 * sin, 0.5 * (1.0 + cos)] } else { [cos, sin, 1.0] }
    }
}

/// The row of A at the monomials of f.
fn in_e(row: &[f64; PRODUCTS], monomials: &[f64; MONOMIALS]) -> [f64; MONOMIALS] {
    let [a, b, c, d, e, f, g, h, i] = *row;
    [[a, b, c], [d, e, f], [g, h, i]].map(|part| dot(part, *monomials))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{angle, sin_cos, wrap};

    /// Equations that vanish at the given pairs of angles, whatever c is.
    fn equations(pairs: &[(f64, f64)]) -> Equations {
        let mut state = 5_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let products = |(e, f): (f64, f64)| {
            let ((se, ce), (sf, cf)) = (sin_cos(e), sin_cos(f));
            [ce * cf, ce * sf, ce, se * cf, se * sf, se, cf, sf, 1.0]
        };
        // An orthonormal basis of the products, by Gram and Schmidt; the rows are at right angles to it.
        let mut basis: [[f64; PRODUCTS]; 2] = [[0.0; PRODUCTS]; 2];
        for (place, pair) in pairs.iter().enumerate() {
            let mut row = products(*pair);
            for other in basis.iter().take(place) {
                let part: f64 = other.iter().zip(row).map(|(x, y)| x * y).sum();
                row.iter_mut().zip(other).for_each(|(x, y)| *x -= part * y);
            }
            let length = crate::math::sqrt(row.iter().map(|x| x * x).sum::<f64>());
            basis[place] = row.map(|x| x / length);
        }
        let one = core::array::from_fn(|_| {
            let mut row: [f64; PRODUCTS] = core::array::from_fn(|_| random());
            for other in &basis {
                let part: f64 = other.iter().zip(row).map(|(x, y)| x * y).sum();
                row.iter_mut().zip(other).for_each(|(x, y)| *x -= part * y);
            }
            row
        });
        let zero = [[0.0; PRODUCTS]; 6];
        let mut equations = Equations { cos: zero, sin: zero, one, is_prismatic: [false; 2] };
        equations.normalize();
        equations
    }

    fn is_near(position: Position, wanted: f64) -> bool {
        matches!(position, Position::Turn(sin, cos) if wrap(angle(sin, cos) - wanted).abs() < 1e-6)
    }

    /// Two solutions with this c, which may share f or e.
    #[test]
    fn all_solutions_are_among_the_roots() {
        for pairs in [[(0.3, -1.0), (2.0, 0.4)], [(0.3, 1.2), (-1.1, 1.2)], [(0.7, 1.2), (0.7, -2.9)]] {
            let held = equations(&pairs).held((0.0, 1.0));
            let roots = held.roots();
            assert!(roots.is_some());
            let Some(roots) = roots else { return };
            for (e, f) in pairs {
                let is_found = roots.as_slice().iter().map(|root| held.at(root.sin_cos)).any(|at| {
                    let is_e = |x: &Position| is_near(*x, e);
                    is_near(at.f, f) && (is_e(&at.one) || at.may_be_two && at.two.iter().any(is_e))
                });
                assert!(is_found, "{e} {f}");
            }
        }
    }

    #[test]
    fn equations_without_f_have_no_determinant() {
        let mut equations = equations(&[(0.3, 0.4)]);
        for row in &mut equations.one {
            let [_, _, a, _, _, b, _, _, c] = *row;
            *row = [0.0, 0.0, a, 0.0, 0.0, b, 0.0, 0.0, c];
        }
        // Of one equation in e all others are multiples.
        let first = equations.one[0];
        equations.one.iter_mut().for_each(|row| *row = first);
        assert!(equations.held((0.0, 1.0)).roots().is_none());
    }
}
