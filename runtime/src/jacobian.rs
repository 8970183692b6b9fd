//! The geometric Jacobian.

use core::fmt;

use crate::math::Scalar;

/// Geometric Jacobian `[6, N]` in the base frame, at the tool point.
///
/// Rows `vx vy vz wx wy wz`. With joint rates `dq`, `J dq` is the velocity of the tool point (length unit / s) above
/// the angular velocity of the tool (rad / s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobian<T, const N: usize> {
    /// The matrix, `rows[row][joint]`.
    pub rows: [[T; N]; 6],
}

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// The zero matrix.
    #[inline]
    #[must_use]
    pub const fn zero() -> Self {
        Self { rows: [[T::ZERO; N]; 6] }
    }

    /// Twist of the tool per unit rate of joint `joint` (from 0), `[6]`; `None` if there is no such joint.
    #[inline]
    #[must_use]
    pub fn column(&self, joint: usize) -> Option<[T; 6]> {
        let mut column = [T::ZERO; 6];
        for (to, row) in column.iter_mut().zip(&self.rows) {
            *to = *row.get(joint)?;
        }
        Some(column)
    }

    /// The product `J dq`: twist of the tool `[6]` from joint rates `[N]`.
    #[inline]
    #[must_use]
    pub fn mul(&self, rates: &[T; N]) -> [T; 6] {
        self.rows.map(|row| row.iter().zip(rates).fold(T::ZERO, |sum, (entry, rate)| sum + *entry * *rate))
    }
}

/// Six lines `[ .. ]`. A precision in the format applies to every entry; the default is 6 decimals.
impl<T: fmt::Display, const N: usize> fmt::Display for Jacobian<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision().unwrap_or(6);
        let width = precision + 7;
        for (index, row) in self.rows.iter().enumerate() {
            f.write_str(if index == 0 { "[" } else { "\n[" })?;
            for entry in row {
                write!(f, "{entry:width$.precision$}")?;
            }
            f.write_str(" ]")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    const J: Jacobian<f64, 2> =
        Jacobian { rows: [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0], [9.0, 10.0], [11.0, 12.0]] };

    #[test]
    fn columns_are_the_joints() {
        assert_eq!(J.column(0), Some([1.0, 3.0, 5.0, 7.0, 9.0, 11.0]));
        assert_eq!(J.column(1), Some([2.0, 4.0, 6.0, 8.0, 10.0, 12.0]));
        assert_eq!(J.column(2), None);
    }

    #[test]
    fn product_with_rates() {
        assert_eq!(J.mul(&[1.0, -0.5]), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(Jacobian::<f64, 2>::zero().mul(&[1.0, -0.5]), [0.0; 6]);
    }

    #[test]
    fn display_is_a_matrix() {
        let text = format!("{J:.1}");
        assert_eq!(text.lines().count(), 6);
        assert_eq!(text.lines().next(), Some("[     1.0     2.0 ]"));
        assert_eq!(text.lines().last(), Some("[    11.0    12.0 ]"));
    }
}
