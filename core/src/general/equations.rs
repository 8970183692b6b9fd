//! Six equations in three joints at one target: the polynomial's values, and the two other joints at a root.

use super::lanes::Lanes;
use super::line::PRODUCTS;
use crate::math::sqrt;
use crate::transform::{cross, dot};

/// Six equations, each a sum of products of monomials of e and f.
pub(super) type System = [[f64; PRODUCTS]; 6];

/// Entries of a pivot below this share of the greatest are none at a root.
const DEPENDENT: f64 = 1e-6;

/// Six equations `(cos c) A + (sin c) B + C` in the products of `(cos e, sin e, 1)` and `(cos f, sin f, 1)`, entry
/// `3 e + f`. A prismatic joint has `(q^2, q, 1)` instead.
#[derive(Clone, Copy)]
pub(super) struct Equations {
    pub(super) cos: System,
    pub(super) sin: System,
    pub(super) one: System,
    pub(super) is_prismatic: [bool; 2],
}

/// Joints e and f, a turning joint as its sine and cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Position {
    Turn(f64, f64),
    Slide(f64),
}

/// At most two pairs of e and f.
#[derive(Clone, Copy)]
pub(super) struct Pairs {
    pub(super) list: [(Position, Position); 2],
    pub(super) len: usize,
    /// Nothing depends on f.
    pub(super) is_free: bool,
}

/// With `phi = (cos f, sin f, 1)`: `cos e phi = C phi` and `sin e phi = S phi`.
struct Reduced<L> {
    c: [[L; 3]; 3],
    s: [[L; 3]; 3],
    /// Up to its sign, the determinant of the six equations in the products that have been eliminated.
    determinant: L,
}

/// `(C + iS)(C - iS) - 1`, real and imaginary part. With e prismatic, `S^2 - C` and 0.
struct Conditions<L> {
    re: [[L; 3]; 3],
    im: [[L; 3]; 3],
}

impl Equations {
    /// The equations with f eliminated first, which is e of the result.
    pub(super) fn swapped(&self) -> Self {
        let turned = |m: &System| m.map(|[a, b, c, d, e, f, g, h, i]| [a, d, g, b, e, h, c, f, i]);
        let [e, f] = self.is_prismatic;
        Self { cos: turned(&self.cos), sin: turned(&self.sin), one: turned(&self.one), is_prismatic: [f, e] }
    }

    /// Returns true if all coefficients are numbers.
    pub(super) fn is_finite(&self) -> bool {
        self.cos.iter().chain(&self.sin).chain(&self.one).flatten().all(|x| x.is_finite())
    }

    /// Each equation divided by the length of its coefficients.
    #[inline(always)]
    pub(super) fn normalize(&mut self) {
        for ((a, b), c) in self.cos.iter_mut().zip(&mut self.sin).zip(&mut self.one) {
            let mut square = 0.0;
            for ((x, y), z) in a.iter().zip(b.iter()).zip(c.iter()) {
                square += x * x + y * y + z * z;
            }
            let scale = if square > 0.0 { 1.0 / sqrt(square) } else { 0.0 };
            a.iter_mut().chain(b).chain(c).for_each(|x| *x *= scale);
        }
    }

    /// `f(t) = det(6x6)^2 det((C + iS)(C - iS) - 1)`, a real trigonometric polynomial of degree 8 in the angle of c, at
    /// one angle or two.
    ///
    /// Not a number where the 6x6 is singular to the last bit.
    #[inline(always)]
    pub(super) fn value<L: Lanes>(&self, held: (L, L)) -> L {
        let reduced = self.reduced(held);
        let Conditions { re, im } = reduced.conditions(self.is_prismatic[0]);
        // Along the first row: the real part of the complex determinant, whose imaginary part is 0.
        let minor = |i: usize, j: usize| {
            let (a, b, c, d) = (re[1][i], im[1][i], re[2][j], im[2][j]);
            let (e, f, g, h) = (re[1][j], im[1][j], re[2][i], im[2][i]);
            ((a * c - b * d) - (e * g - f * h), (a * d + b * c) - (e * h + f * g))
        };
        let mut sum = L::ZERO;
        for (k, (x, y)) in [minor(1, 2), minor(2, 0), minor(0, 1)].into_iter().enumerate() {
            sum = sum + (re[0][k] * x - im[0][k] * y);
        }
        reduced.determinant * reduced.determinant * sum
    }

    /// Elimination of the six products with `cos e` and `sin e`, by rows.
    #[inline(always)]
    fn reduced<L: Lanes>(&self, (sin, cos): (L, L)) -> Reduced<L> {
        let mut m = [[L::ZERO; PRODUCTS]; 6];
        for (row, ((a, b), c)) in m.iter_mut().zip(self.cos.iter().zip(&self.sin).zip(&self.one)) {
            for (entry, ((x, y), z)) in row.iter_mut().zip(a.iter().zip(b).zip(c)) {
                *entry = L::all(*x) * cos + L::all(*y) * sin + L::all(*z);
            }
        }
        let mut determinant = L::ONE;
        eliminate::<L, 0>(&mut m, &mut determinant);
        eliminate::<L, 1>(&mut m, &mut determinant);
        eliminate::<L, 2>(&mut m, &mut determinant);
        eliminate::<L, 3>(&mut m, &mut determinant);
        eliminate::<L, 4>(&mut m, &mut determinant);
        eliminate::<L, 5>(&mut m, &mut determinant);
        // From below, the last three columns negated: the products are these times phi.
        let mut x = [[L::ZERO; 3]; 6];
        for k in (0..6).rev() {
            for j in 0..3 {
                let mut sum = m[k][6 + j];
                for i in k + 1..6 {
                    sum = sum + m[k][i] * x[i][j];
                }
                x[k][j] = L::ZERO - sum;
            }
        }
        let [a, b, c, d, e, f] = x;
        Reduced { c: [a, b, c], s: [d, e, f], determinant }
    }

    /// e and f at a root of the polynomial. `reference` gives f's value where nothing depends on it.
    ///
    /// `phi = (cos f, sin f, 1)` is in the null space of the stacked conditions, six rows. Its dimension is 1 for one
    /// solution and 2 for two: then one row n remains, and `n . phi = 0` has two roots.
    pub(super) fn pairs(&self, held: (f64, f64), reference: impl FnOnce() -> Position) -> Pairs {
        let reduced = self.reduced(held);
        let Conditions { re: [a, b, c], im: [d, e, f] } = reduced.conditions(self.is_prismatic[0]);
        let span = Span::of([a, b, c, d, e, f]);
        let mut pairs = Pairs { list: [(Position::Slide(0.0), Position::Slide(0.0)); 2], len: 1, is_free: false };
        let mut phis = [span.normal; 2];
        // The entries of C and S are of the order of 1 at a solution.
        if span.is_zero() {
            phis[0] = match reference() {
                Position::Turn(sin, cos) => [cos, sin, 1.0],
                Position::Slide(q) => [q * q, q, 1.0],
            };
            pairs.is_free = true;
        } else if span.is_line(DEPENDENT) {
            phis = span.roots(self.is_prismatic[1]);
            pairs.len = 2;
        }
        for (pair, phi) in pairs.list.iter_mut().zip(phis).take(pairs.len) {
            let [x, y] = [&reduced.c, &reduced.s].map(|m| dot(m.map(|row| dot(row, phi)), phi));
            let [slides_e, slides_f] = self.is_prismatic;
            *pair = (Position::of(slides_e, [x, y, dot(phi, phi)]), Position::of(slides_f, phi));
        }
        pairs
    }
}

/// The space that some rows over the monomials of a joint span.
pub(super) struct Span {
    /// At right angles to all rows, where their rank is 2: in proportion to the monomials at which they vanish.
    pub(super) normal: [f64; 3],
    longest: [f64; 3],
    /// The squares of the lengths of these two.
    length: f64,
    height: f64,
}

impl Span {
    /// By the longest row, and the one that is farthest from its line.
    pub(super) fn of(rows: [[f64; 3]; 6]) -> Self {
        let (mut longest, mut length) = ([0.0; 3], 0.0);
        for row in rows {
            let square = dot(row, row);
            (longest, length) = if square > length { (row, square) } else { (longest, length) };
        }
        let (mut normal, mut height) = ([0.0; 3], 0.0);
        for row in rows {
            let vector = cross(longest, row);
            let square = dot(vector, vector);
            (normal, height) = if square > height { (vector, square) } else { (normal, height) };
        }
        Self { normal, longest, length, height }
    }

    /// Rank 0, if the entries are of the order of 1.
    pub(super) fn is_zero(&self) -> bool {
        self.length < DEPENDENT * DEPENDENT
    }

    /// Rank 1: no row is farther from the line of the longest one than this share of its length.
    pub(super) fn is_line(&self, share: f64) -> bool {
        self.height < share * share * self.length * self.length
    }

    /// The two places of the joint at which the longest row vanishes, as monomials.
    pub(super) fn roots(&self, is_prismatic: bool) -> [[f64; 3]; 2] {
        if is_prismatic { on_parabola(self.longest) } else { on_circle(self.longest) }
    }
}

impl Position {
    /// The position whose monomials these are, but for a factor.
    pub(super) fn of(is_prismatic: bool, [x, y, z]: [f64; 3]) -> Self {
        let sign = if z < 0.0 { -1.0 } else { 1.0 };
        if is_prismatic { Self::Slide(y / z) } else { Self::direction(y * sign, x * sign) }
    }

    /// The angle of a vector of any length; 0 for none.
    #[inline]
    pub(super) fn direction(y: f64, x: f64) -> Self {
        let length = sqrt(x * x + y * y);
        if length > 0.0 { Self::Turn(y / length, x / length) } else { Self::Turn(0.0, 1.0) }
    }
}

/// `n . (cos f, sin f, 1) = 0`: two directions. The nearest one, twice, where there is none.
fn on_circle([x, y, level]: [f64; 3]) -> [[f64; 3]; 2] {
    let square = x * x + y * y;
    let rest = square - level * level;
    let height = if rest > 0.0 { sqrt(rest) } else { 0.0 };
    [height, -height].map(|h| [(-level * x - h * y) / square, (-level * y + h * x) / square, 1.0])
}

/// `n . (q^2, q, 1) = 0`: two displacements. That of the least value, twice, where there is none.
fn on_parabola([a, b, c]: [f64; 3]) -> [[f64; 3]; 2] {
    let half = -0.5 * b;
    let rest = half * half - a * c;
    let root = if rest > 0.0 { sqrt(rest) } else { 0.0 };
    let greater = if half < 0.0 { half - root } else { half + root };
    let lesser = if root > 0.0 { c / greater } else { greater / a };
    [greater / a, lesser].map(|q| [q * q, q, 1.0])
}

/// Step K of the elimination: the greatest entry of column K is the pivot.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "loops over constant ranges are unrolled, iterators with `skip` are not")]
fn eliminate<L: Lanes, const K: usize>(m: &mut [[L; PRODUCTS]; 6], determinant: &mut L) {
    // Magnitudes as integers, with the row in the last three bits: no branch depends on the target.
    let mut greatest = 0;
    for (i, row) in m.iter().enumerate().skip(K) {
        let key = (row[K].magnitude().to_bits() & !7) | i as u64;
        greatest = if key > greatest { key } else { greatest };
    }
    let chosen = core::cmp::min(greatest & 7, 5) as usize;
    let pivot = m[chosen][K];
    m[chosen][K] = m[K][K];
    *determinant = *determinant * pivot;
    let inverse = pivot.inverse();
    for j in K + 1..PRODUCTS {
        let entry = m[chosen][j];
        m[chosen][j] = m[K][j];
        m[K][j] = entry * inverse;
    }
    for i in K + 1..6 {
        let factor = m[i][K];
        for j in K + 1..PRODUCTS {
            m[i][j] = m[i][j] - factor * m[K][j];
        }
    }
}

impl<L: Lanes> Reduced<L> {
    #[inline(always)]
    fn conditions(&self, is_prismatic: bool) -> Conditions<L> {
        let (c, s) = (&self.c, &self.s);
        let [mut re, mut im] = [[[L::ZERO; 3]; 3]; 2];
        if is_prismatic {
            for i in 0..3 {
                for j in 0..3 {
                    re[i][j] = s[i][0] * s[0][j] + s[i][1] * s[1][j] + s[i][2] * s[2][j] - c[i][j];
                }
            }
            return Conditions { re, im };
        }
        for i in 0..3 {
            for j in 0..3 {
                for k in 0..3 {
                    re[i][j] = re[i][j] + (c[i][k] * c[k][j] + s[i][k] * s[k][j]);
                    im[i][j] = im[i][j] + (s[i][k] * c[k][j] - c[i][k] * s[k][j]);
                }
            }
            re[i][i] = re[i][i] - L::ONE;
        }
        Conditions { re, im }
    }
}
