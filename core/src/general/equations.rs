//! Six equations in three joints at one target: the polynomial's values, and the two other joints at a root.

use super::line::PRODUCTS;
use crate::math::sqrt;

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
struct Reduced {
    c: [[f64; 3]; 3],
    s: [[f64; 3]; 3],
    /// The determinant of the six equations in the products that have been eliminated.
    determinant: f64,
}

/// `(C + iS)(C - iS) - 1`, real and imaginary part. With e prismatic, `S^2 - C` and 0.
struct Conditions {
    re: [[f64; 3]; 3],
    im: [[f64; 3]; 3],
}

impl Equations {
    /// The equations with f eliminated first, which is e of the result.
    pub(super) fn swapped(&self) -> Self {
        let turned = |m: &System| m.map(|[a, b, c, d, e, f, g, h, i]| [a, d, g, b, e, h, c, f, i]);
        let [e, f] = self.is_prismatic;
        Self { cos: turned(&self.cos), sin: turned(&self.sin), one: turned(&self.one), is_prismatic: [f, e] }
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

    /// `f(t) = det(6x6)^2 det((C + iS)(C - iS) - 1)`, a real trigonometric polynomial of degree 8 in the angle of c.
    ///
    /// Not a number where the 6x6 is singular to the last bit.
    #[inline]
    pub(super) fn value(&self, held: (f64, f64)) -> f64 {
        let reduced = self.reduced(held);
        let Conditions { re, im } = reduced.conditions(self.is_prismatic[0]);
        // Along the first row: the real part of the complex determinant, whose imaginary part is 0.
        let minor = |i: usize, j: usize| {
            let (a, b, c, d) = (re[1][i], im[1][i], re[2][j], im[2][j]);
            let (e, f, g, h) = (re[1][j], im[1][j], re[2][i], im[2][i]);
            ((a * c - b * d) - (e * g - f * h), (a * d + b * c) - (e * h + f * g))
        };
        let mut sum = 0.0;
        for (k, (x, y)) in [minor(1, 2), minor(2, 0), minor(0, 1)].into_iter().enumerate() {
            sum += re[0][k] * x - im[0][k] * y;
        }
        reduced.determinant * reduced.determinant * sum
    }

    /// Elimination of the six products with `cos e` and `sin e`, by rows.
    #[inline(always)]
    fn reduced(&self, (sin, cos): (f64, f64)) -> Reduced {
        let mut m = [[0.0; PRODUCTS]; 6];
        for (row, ((a, b), c)) in m.iter_mut().zip(self.cos.iter().zip(&self.sin).zip(&self.one)) {
            for (entry, ((x, y), z)) in row.iter_mut().zip(a.iter().zip(b).zip(c)) {
                *entry = x * cos + y * sin + z;
            }
        }
        let mut determinant = 1.0;
        eliminate::<0>(&mut m, &mut determinant);
        eliminate::<1>(&mut m, &mut determinant);
        eliminate::<2>(&mut m, &mut determinant);
        eliminate::<3>(&mut m, &mut determinant);
        eliminate::<4>(&mut m, &mut determinant);
        eliminate::<5>(&mut m, &mut determinant);
        let mut x = m.map(|[.., a, b, c]| [-a, -b, -c]);
        for k in (0..5).rev() {
            for i in k + 1..6 {
                let (factor, known) = (m[k][i], x[i]);
                x[k].iter_mut().zip(known).for_each(|(entry, y)| *entry -= factor * y);
            }
        }
        let [a, b, c, d, e, f] = x;
        Reduced { c: [a, b, c], s: [d, e, f], determinant }
    }

    /// e and f at a root of the polynomial. `reference` is f's value where nothing depends on it.
    ///
    /// `phi = (cos f, sin f, 1)` is in the null space of the stacked conditions, six rows. Its dimension is 1 for one
    /// solution and 2 for two: then one row n remains, and `n . phi = 0` has two roots.
    pub(super) fn pairs(&self, held: (f64, f64), reference: Position) -> Pairs {
        let reduced = self.reduced(held);
        let Conditions { re: [a, b, c], im: [d, e, f] } = reduced.conditions(self.is_prismatic[0]);
        let mut m = [a, b, c, d, e, f];
        let greatest = m.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut order = [0, 1, 2];
        let mut rank = 0;
        for k in 0..2 {
            let (mut row, mut column) = (k, k);
            for i in k..6 {
                for j in k..3 {
                    if m[i][j].abs() > m[row][column].abs() {
                        (row, column) = (i, j);
                    }
                }
            }
            // The values of C and S are of the order of 1 at a solution.
            let least = if k == 0 { DEPENDENT } else { DEPENDENT * greatest };
            if m[row][column].abs() < least {
                break;
            }
            rank += 1;
            m.swap(row, k);
            m.iter_mut().for_each(|row| row.swap(column, k));
            order.swap(column, k);
            let pivot = m[k];
            for row in m.iter_mut().skip(k + 1) {
                let factor = row[k] / pivot[k];
                row.iter_mut().zip(pivot).for_each(|(entry, x)| *entry -= factor * x);
            }
        }
        let mut pairs = Pairs { list: [(Position::Slide(0.0), Position::Slide(0.0)); 2], len: 0, is_free: false };
        let mut phis = [[0.0; 3]; 2];
        if rank == 2 {
            let [first, second, ..] = m;
            let y = -second[2] / second[1];
            let values = [-(first[1] * y + first[2]) / first[0], y, 1.0];
            order.into_iter().zip(values).for_each(|(place, value)| phis[0][place] = value);
            pairs.len = 1;
        } else if rank == 1 {
            let mut n = [0.0; 3];
            order.into_iter().zip(m[0]).for_each(|(place, value)| n[place] = value);
            phis = if self.is_prismatic[1] { on_parabola(n) } else { on_circle(n) };
            pairs.len = 2;
        } else {
            phis[0] = match reference {
                Position::Turn(sin, cos) => [cos, sin, 1.0],
                Position::Slide(q) => [q * q, q, 1.0],
            };
            (pairs.len, pairs.is_free) = (1, true);
        }
        for (pair, phi) in pairs.list.iter_mut().zip(phis).take(pairs.len) {
            *pair = (self.eliminated(&reduced, phi), self.other(phi));
        }
        pairs
    }

    /// Joint e: the Rayleigh quotients of C and S.
    fn eliminated(&self, reduced: &Reduced, phi: [f64; 3]) -> Position {
        use crate::transform::dot;
        let (cos, sin) = (dot(reduced.c.map(|row| dot(row, phi)), phi), dot(reduced.s.map(|row| dot(row, phi)), phi));
        if self.is_prismatic[0] { Position::Slide(sin / dot(phi, phi)) } else { Position::direction(sin, cos) }
    }

    /// Joint f.
    fn other(&self, [x, y, z]: [f64; 3]) -> Position {
        if self.is_prismatic[1] {
            return Position::Slide(y / z);
        }
        if z < 0.0 { Position::direction(-y, -x) } else { Position::direction(y, x) }
    }
}

impl Position {
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
fn eliminate<const K: usize>(m: &mut System, determinant: &mut f64) {
    let mut pivot = K;
    for i in K + 1..6 {
        if m[i][K].abs() > m[pivot][K].abs() {
            pivot = i;
        }
    }
    if pivot != K {
        m.swap(pivot, K);
        *determinant = -*determinant;
    }
    let mut row = m[K];
    *determinant *= row[K];
    let inverse = 1.0 / row[K];
    for entry in row.iter_mut().skip(K + 1) {
        *entry *= inverse;
    }
    m[K] = row;
    for line in m.iter_mut().skip(K + 1) {
        let factor = line[K];
        for j in K + 1..PRODUCTS {
            line[j] -= factor * row[j];
        }
    }
}

impl Reduced {
    #[inline(always)]
    fn conditions(&self, is_prismatic: bool) -> Conditions {
        let (c, s) = (&self.c, &self.s);
        let [mut re, mut im] = [[[0.0; 3]; 3]; 2];
        if is_prismatic {
            for i in 0..3 {
                for j in 0..3 {
                    re[i][j] = s[i][0] * s[0][j] + s[i][1] * s[1][j] + s[i][2] * s[2][j] - c[i][j];
                }
            }
            return Conditions { re, im };
        }
        for i in 0..3 {
            for k in 0..3 {
                for j in 0..3 {
                    re[i][j] += c[i][k] * c[k][j] + s[i][k] * s[k][j];
                    im[i][j] += s[i][k] * c[k][j] - c[i][k] * s[k][j];
                }
            }
            re[i][i] -= 1.0;
        }
        Conditions { re, im }
    }
}
