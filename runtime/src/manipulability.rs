//! How far an arm is from a singular position.

use crate::jacobian::Jacobian;
use crate::math::Scalar;

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// Manipulability of Yoshikawa 1985 ("Manipulability of robotic mechanisms", equation 11), over all six rows:
    /// `sqrt(det(J J^T))`; with fewer than six joints `sqrt(det(J^T J))`.
    ///
    /// It is the product of the singular values: the volume of the tool velocities that joint rates of unit norm give. It is
    /// zero where the arm is singular, and for six joints `|det J|`. Lengths are not scaled: the value has the unit of
    /// as many lengths as linear velocities take part. Two arms compare only after
    /// [`with_length_unit`](Self::with_length_unit).
    ///
    /// The value is computed by orthogonalization of `J` itself. Its error is a few roundings of the product of the row
    /// lengths (column lengths for fewer than six joints). The determinant of `J J^T` would lose all digits below the
    /// square root of that. Not a number where an entry is not finite.
    #[must_use]
    pub fn manipulability(&self) -> T {
        self.manipulability_of([true; 6])
    }

    /// Manipulability over the rows that `counts` selects of `vx vy vz wx wy wz`: the rows that matter to the task.
    ///
    /// With `M` rows: `sqrt(det(J J^T))` for `M <= N`, `sqrt(det(J^T J))` for `M > N`; 1 without rows. For the position
    /// of the tool count the first three, for a planar arm `vx vy` or `vx vy wz`. A row that is zero at every position
    /// makes the first of the two roots zero.
    ///
    /// ```
    /// use denhart::Jacobian;
    ///
    /// // Two links of 0.5 and 0.25 in the plane, the elbow at a right angle: l1 l2 |sin(q2)|.
    /// let jacobian = Jacobian { rows: [[-0.25, -0.25], [0.5, 0.0], [0.0; 2], [0.0; 2], [0.0; 2], [1.0; 2]] };
    /// let manipulability: f64 = jacobian.manipulability_of([true, true, false, false, false, false]);
    /// assert!((manipulability - 0.125).abs() < 1e-16);
    /// ```
    #[must_use]
    pub fn manipulability_of(&self, counts: [bool; 6]) -> T {
        if !self.rows.iter().zip(counts).filter(|(_, counts)| *counts).all(|(row, _)| row.iter().all(|x| x.is_finite()))
        {
            return T::NAN;
        }
        let rows = counts.iter().filter(|counts| **counts).count();
        if rows <= N {
            volume(self.rows, counts)
        } else {
            let mut columns = [[T::ZERO; 6]; N];
            for (index, column) in columns.iter_mut().enumerate() {
                for ((entry, row), counts) in column.iter_mut().zip(&self.rows).zip(counts) {
                    if counts && let Some(value) = row.get(index) {
                        *entry = *value;
                    }
                }
            }
            volume(columns, [true; N])
        }
    }

    /// Manipulability for a task that gives a point and the direction of an axis, a unit vector in the base frame. The
    /// rows are `vx vy vz` and the two turns across the axis. A turn about the axis does not count. With fewer than
    /// five joints the value is `sqrt(det(J^T J))`.
    #[must_use]
    pub fn manipulability_pointing(&self, axis: [T; 3]) -> T {
        let [vx, vy, vz, wx, wy, wz] = self.rows;
        let [x, y, z] = axis;
        // Two unit vectors across: Duff et al. 2017, which never divides by zero.
        let sign = if z < T::ZERO { -T::ONE } else { T::ONE };
        let a = -T::ONE / (sign + z);
        let b = x * y * a;
        let across = [[T::ONE + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]];
        let [first, second] = across.map(|[u, v, w]| {
            let mut row = [T::ZERO; N];
            for (((entry, x), y), z) in row.iter_mut().zip(&wx).zip(&wy).zip(&wz) {
                *entry = u * *x + v * *y + w * *z;
            }
            row
        });
        Self { rows: [vx, vy, vz, first, second, [T::ZERO; N]] }
            .manipulability_of([true, true, true, true, true, false])
    }

    /// Manipulability for a task that gives a point and the sum of the joints by `signs` (0 for joints that do not
    /// count). The rows are `vx vy vz` and the rate of that angle.
    #[must_use]
    pub fn manipulability_turning(&self, signs: [T; N]) -> T {
        let [vx, vy, vz, ..] = self.rows;
        let none = [T::ZERO; N];
        Self { rows: [vx, vy, vz, signs, none, none] }.manipulability_of([true, true, true, true, false, false])
    }

    /// Returns the Jacobian with lengths measured in `unit`: the linear rows divided by `unit`.
    ///
    /// With the reach of the arm as the unit, lengths and angles are of one order. Values computed from the Jacobian
    /// then do not depend on meters or millimeters. The unit must be finite and not zero; entries divided by zero are
    /// not finite.
    #[inline]
    #[must_use]
    pub fn with_length_unit(&self, unit: T) -> Self {
        let [x, y, z, a, b, c] = self.rows;
        let [x, y, z] = [x, y, z].map(|row| row.map(|entry| entry / unit));
        Self { rows: [x, y, z, a, b, c] }
    }
}

/// Volume of the parallelepiped over the vectors that count: the product of the diagonal of their triangular factor.
/// The factor is that of the Gram-Schmidt process in its modified form, as accurate as the factor of orthogonal
/// rotations (Bjorck 1967). The longest remainder is taken first, so that vectors of very different lengths do not
/// spoil one another.
fn volume<T: Scalar, const K: usize, const L: usize>(mut vectors: [[T; L]; K], mut counts: [bool; K]) -> T {
    let mut product = T::ONE;
    for _ in 0..counts.iter().filter(|counts| **counts).count() {
        // The longest, and its length.
        let mut longest: Option<(usize, [T; L], T)> = None;
        for (index, (vector, counts)) in vectors.iter().zip(counts).enumerate() {
            let squared = dot(vector, vector);
            if counts && longest.is_none_or(|(_, _, most)| squared > most) {
                longest = Some((index, *vector, squared));
            }
        }
        let Some((index, vector, squared)) = longest else { break };
        let length = squared.sqrt();
        product *= length;
        if length == T::ZERO {
            return T::ZERO;
        }
        let direction = vector.map(|x| x / length);
        for (other, (vector, counts)) in vectors.iter_mut().zip(&mut counts).enumerate() {
            if other == index {
                *counts = false;
                continue;
            }
            let along = dot(vector, &direction);
            for (x, d) in vector.iter_mut().zip(&direction) {
                *x -= along * *d;
            }
        }
    }
    product
}

fn dot<T: Scalar, const L: usize>(a: &[T; L], b: &[T; L]) -> T {
    a.iter().zip(b).fold(T::ZERO, |sum, (x, y)| sum + *x * *y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    const PLANE: [bool; 6] = [true, true, false, false, false, false];

    /// Two links in the plane.
    fn two_links<T: Scalar>([l1, l2]: [T; 2], [q1, q2]: [T; 2]) -> Jacobian<T, 2> {
        let ((s1, c1), (s12, c12)) = (math::sin_cos(q1), math::sin_cos(q1 + q2));
        let o = [T::ZERO; 2];
        let rows = [[-(l1 * s1 + l2 * s12), -l2 * s12], [l1 * c1 + l2 * c12, l2 * c12], o, o, o, [T::ONE; 2]];
        Jacobian { rows }
    }

    /// Three roundings of products of lengths, each of 2.2e-16; the determinant of the square would be off by 1e-8.
    #[test]
    fn accurate_where_the_elbow_is_stretched() {
        for exponent in 0..16 {
            let q2 = 10_f64.powi(-exponent);
            let exact = 0.5 * 0.25 * q2.sin();
            let found = two_links([0.5, 0.25], [0.7, q2]).manipulability_of(PLANE);
            assert!((found - exact).abs() < 5e-16, "{q2:e}: {found:e} for {exact:e}");
        }
        let exact = 0.5 * 0.25 * (1e-3_f32).sin();
        let found = two_links([0.5_f32, 0.25], [0.7, 1e-3]).manipulability_of(PLANE);
        assert!((found - exact).abs() < 3e-7, "{found:e}");
    }

    /// The determinant of a 6 x 6 matrix of known factors, with rows of millimetres over rows of rad.
    #[test]
    fn six_joints_give_the_determinant() {
        let mut rows = [[0.0; 6]; 6];
        for (i, row) in rows.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let unit = if i < 3 { 1000.0 } else { 1.0 };
                // Lower times upper triangular with unit diagonals, save the factor 1/2 in the last place.
                let low = |i: usize, k: usize| {
                    if i == k {
                        1.0
                    } else if i > k {
                        0.1 * (i + 2 * k) as f64
                    } else {
                        0.0
                    }
                };
                let up = |k: usize, j: usize| {
                    if k == j {
                        if k == 5 { 0.5 } else { 1.0 }
                    } else if k < j {
                        0.2 * (j as f64 - 1.5 * k as f64)
                    } else {
                        0.0
                    }
                };
                *entry = unit * (0..6).map(|k| low(i, k) * up(k, j)).sum::<f64>();
            }
        }
        let jacobian = Jacobian { rows };
        assert!((jacobian.manipulability() / 0.5e9 - 1.0).abs() < 1e-12, "{}", jacobian.manipulability());
        let scaled = jacobian.with_length_unit(1000.0);
        assert!((scaled.manipulability() / 0.5 - 1.0).abs() < 1e-12, "{}", scaled.manipulability());
    }

    #[test]
    fn fewer_joints_than_rows() {
        // J^T J of two columns (v, w): |a|^2 |b|^2 - (a b)^2.
        let jacobian = two_links([0.5, 0.25], [0.0, 0.0]);
        let (aa, bb, ab): (f64, f64, f64) = (0.75 * 0.75 + 1.0, 0.25 * 0.25 + 1.0, 0.75 * 0.25 + 1.0);
        let exact = (aa * bb - ab * ab).sqrt();
        assert!((jacobian.manipulability() - exact).abs() < 1e-15);
        // A zero row among as many rows as joints; no rows at all.
        assert_eq!(jacobian.manipulability_of([true, false, true, false, false, false]), 0.0);
        assert_eq!(jacobian.manipulability_of([false; 6]), 1.0);
    }

    #[test]
    fn singular_and_not_finite() {
        assert_eq!(Jacobian::<f64, 6>::zero().manipulability(), 0.0);
        assert_eq!(Jacobian::<f32, 3>::zero().manipulability(), 0.0);
        for bad in [f64::NAN, f64::INFINITY] {
            let mut jacobian = two_links([0.5, 0.25], [0.1, 0.2]);
            jacobian.rows[4][1] = bad;
            assert!(jacobian.manipulability().is_nan());
            assert!(jacobian.manipulability_of(PLANE) > 0.0);
        }
    }

    /// A turn about the axis that points is not counted, and turns across it are, whichever way it points.
    #[test]
    fn pointing_counts_the_turns_across_the_axis() {
        let o = [0.0; 5];
        let slides = [[1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0, 0.0]];
        let (four, five) = ([0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0]);
        let [x, y, z] = slides;
        let about_x_and_y = Jacobian { rows: [x, y, z, four, five, o] };
        assert_eq!(about_x_and_y.manipulability_pointing([0.0, 0.0, 1.0]), 1.0);
        assert_eq!(about_x_and_y.manipulability_pointing([0.0, 0.0, -1.0]), 1.0);
        assert_eq!(about_x_and_y.manipulability_pointing([1.0, 0.0, 0.0]), 0.0);
        // The turns are along x and y: across a direction tilted by 60 degrees they span cos 60.
        let tilted = about_x_and_y.manipulability_pointing([0.0, 0.75_f64.sqrt(), 0.5]);
        assert!((tilted - 0.5).abs() < 1e-15, "{tilted}");
    }

    #[test]
    fn turning_counts_the_sum_of_the_joints() {
        let o = [0.0; 4];
        let rows = [[2.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], o, o, o];
        assert_eq!(Jacobian { rows }.manipulability_turning([0.0, 1.0, 1.0, -1.0]), 2.0);
        assert!(Jacobian { rows }.manipulability_turning([0.0, 1.0, 1.0, 0.0]) < 1e-15);
    }
}
