//! Limits of sums of joint values.

use crate::limits::within;
use crate::math::Scalar;

/// The range of a sum of joint values, as of two linked joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CombinedLimit<T, const N: usize> {
    /// The factor of every joint; 0 where it is not in the sum.
    pub factors: [T; N],
    /// Lowest and highest value of the sum, rad or length unit; infinite where there is none.
    pub limits: [T; 2],
}

impl<T: Scalar, const N: usize> CombinedLimit<T, N> {
    /// The sum at joint values `q` (rad or length unit, `[N]`), of the values as they are. A joint a turn further on
    /// changes the sum by its factor times a turn.
    #[inline]
    #[must_use]
    pub fn sum(&self, q: &[T; N]) -> T {
        let mut sum = T::ZERO;
        for (factor, q) in self.factors.iter().zip(q) {
            // A joint that is not in the sum may have any value, infinite ones too.
            if *factor != T::ZERO {
                sum += *factor * *q;
            }
        }
        sum
    }

    /// Returns true if the sum is within the limits, up to the rounding of its terms. A sum that is not a number is
    /// outside.
    #[inline]
    #[must_use]
    pub fn holds(&self, q: &[T; N]) -> bool {
        let terms = self.factors.iter().zip(q).filter(|(factor, _)| **factor != T::ZERO);
        within(self.sum(q), self.limits, terms.fold(T::ZERO, |size, (factor, q)| size + (*factor * *q).abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_held_to_their_range() {
        let limit = CombinedLimit { factors: [0.0, 1.0, -2.0], limits: [-1.0, f64::INFINITY] };
        assert_eq!(limit.sum(&[f64::NAN, 3.0, 0.5]), 2.0);
        assert!(limit.holds(&[f64::INFINITY, 3.0, 2.0]) && limit.holds(&[0.0, 1e300, 0.0]));
        assert!(!limit.holds(&[0.0, 3.0, 2.1]) && !limit.holds(&[0.0, f64::NAN, 0.0]));
    }
}
