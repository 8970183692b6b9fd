//! The rotation nearest to a matrix.

use crate::math::Scalar;
use crate::pose::Pose;
use crate::vector::{cross, dot};

impl<T: Scalar> Pose<T> {
    /// Returns the pose with the rotation nearest to its matrix; the position stays.
    ///
    /// Use it for poses that were printed with a few digits, averaged, or multiplied up over a long time.
    /// [`InverseKinematics`](crate::InverseKinematics) does so with a target that is off by at most 1e-3.
    ///
    /// Nearest is the rotation `U` with the least sum of squared differences over all entries (the orthogonal
    /// Procrustes problem). That is the polar factor of `R = U H`, with `H` symmetric and positive definite. Newton's
    /// iteration `X <- (X + X^-T) / 2` from `X = R` gives it, always in four steps. Source: Higham 1986, "Computing the
    /// polar decomposition - with applications", SIAM J. Sci. Stat. Comput. 7(4).
    ///
    /// The result is orthonormal to a few units of rounding if the singular values of `R` are within 0.85 and 1.2.
    /// Entries may be off by 0.05 each for that; those printed with two digits are off by 0.005. A second call then
    /// changes nothing beyond rounding, nor does the first one of a rotation.
    ///
    /// A matrix further off may still be off by more than rounding after the four steps. A mirrored matrix, of negative
    /// determinant, gives the nearest mirrored one, not a rotation. A matrix without inverse, or with an entry that is
    /// not finite, gives entries that are not finite.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// // Thirty degrees about z, with three digits.
    /// let printed = Pose { rotation: [[0.866, -0.5, 0.0], [0.5, 0.866, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] };
    /// let [[cos, minus_sin, _], ..] = printed.orthonormalized().rotation;
    /// assert!((cos * cos + minus_sin * minus_sin - 1.0_f64).abs() < 1e-15);
    /// assert!((cos - 0.866).abs() < 2e-5);
    /// ```
    #[must_use]
    pub fn orthonormalized(&self) -> Self {
        Self { rotation: nearest_rotation(&self.rotation), translation: self.translation }
    }
}

/// The polar factor of a matrix given by rows, see [`Pose::orthonormalized`].
///
/// A step takes each singular value `s` to `(s + 1/s) / 2`, so `1 + e` to `1 + e^2 / 2` in first order. Four steps take
/// `e` to `2 (e/2)^16`: 0.2 to 2e-16. The first step takes what is below 1 to above 1: 0.85 to 1.0132.
#[cold]
#[inline(never)]
pub(crate) fn nearest_rotation<T: Scalar>(rotation: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    const STEPS: usize = 4;
    let mut nearest = *rotation;
    for _ in 0..STEPS {
        let [x, y, z] = nearest;
        // The cofactors: the inverse transposed, times the determinant.
        let mut cofactors = [y, z, x];
        for (row, next) in cofactors.iter_mut().zip([z, x, y]) {
            *row = cross(*row, next);
        }
        let [of_x, ..] = cofactors;
        let half = T::HALF / dot(x, of_x);
        for (row, cofactors) in nearest.iter_mut().zip(cofactors) {
            for (entry, cofactor) in row.iter_mut().zip(cofactors) {
                *entry = T::HALF * *entry + half * cofactor;
            }
        }
    }
    nearest
}

#[cfg(all(test, feature = "nalgebra", feature = "std"))]
mod tests {
    use super::*;
    use crate::vector::scale;

    /// Largest entry of `R^T R - 1`.
    fn skewness<T: Scalar>(pose: &Pose<T>) -> f64 {
        let square = (pose.inverse() * *pose).rotation;
        apart(&square, &Pose::identity().rotation)
    }

    fn apart<T: Scalar>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> f64 {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        pairs.map(|(a, b)| (*a - *b).to_f64().abs()).fold(0.0, f64::max)
    }

    /// The square root of the sum of the squared differences.
    fn distance<T: Scalar>(a: &Pose<T>, b: &Pose<T>) -> f64 {
        let pairs = a.rotation.iter().flatten().zip(b.rotation.iter().flatten());
        pairs.map(|(a, b)| (a.to_f64() - b.to_f64()).powi(2)).sum::<f64>().sqrt()
    }

    /// Rotations of all kinds: general ones, small ones, and quarter turns.
    fn rotations() -> impl Iterator<Item = Pose<f64>> {
        (0..2000_u32).map(|i| {
            let turn = |k: f64| f64::from(i) * k % 6.3 - 3.1;
            let angles = [turn(0.7312), turn(1.9173), turn(0.3377)];
            let quarters = angles.map(|angle| (angle * 2.0 / 3.2).round() * core::f64::consts::FRAC_PI_2);
            let chosen = match i % 4 {
                0 => angles.map(|angle| 1e-5 * angle),
                1 => quarters,
                _ => angles,
            };
            Pose::from_xyz_rpy([1.0, -2.0, f64::from(i)], chosen)
        })
    }

    fn to_digits<T: Scalar>(pose: &Pose<f64>, digits: i32) -> Pose<T> {
        let power = 10.0_f64.powi(digits);
        let round = |value: f64| T::from_f64((value * power).round() / power);
        Pose { rotation: pose.rotation.map(|row| row.map(round)), translation: pose.translation.map(T::from_f64) }
    }

    fn printed_copies<T: Scalar>() {
        let eps = T::EPSILON.to_f64();
        let mut worst = [0.0_f64; 3];
        for (exact, digits) in rotations().flat_map(|pose| [2, 3, 4, 5, 6].map(|digits| (pose, digits))) {
            let printed = to_digits::<T>(&exact, digits);
            let nearest = printed.orthonormalized();
            assert_eq!(nearest.translation, printed.translation);
            let exact = to_digits::<T>(&exact, 18);
            let deviation = distance(&printed, &exact) + 4.0 * eps;
            // The exact rotation is one too, so the nearest is at most as far, and at most twice from it.
            assert!(distance(&printed, &nearest) <= deviation && distance(&exact, &nearest) <= 2.0 * deviation);
            let again = nearest.orthonormalized();
            let oracle = oracle(&printed);
            for (worst, value) in worst.iter_mut().zip([
                skewness(&nearest),
                apart(&again.rotation, &nearest.rotation),
                apart(&oracle.rotation, &nearest.rotation),
            ]) {
                *worst = worst.max(value / eps);
            }
        }
        // The oracle has rounding of its own.
        assert!(worst.iter().zip([4.0, 4.0, 16.0]).all(|(worst, bound)| *worst < bound), "{worst:?}");
    }

    /// By the singular value decomposition `R = V S W^T`, in `f64`: `V W^T`.
    fn oracle<T: Scalar>(pose: &Pose<T>) -> Pose<T> {
        let entries = pose.rotation.map(|row| row.map(T::to_f64));
        let parts = nalgebra::Matrix3::from_fn(|i, j| entries[i][j]).svd(true, true);
        let product = parts.u.zip(parts.v_t).map(|(v, w)| v * w).unwrap_or_default();
        let row = |i: usize| [0, 1, 2].map(|j| T::from_f64(product[(i, j)]));
        Pose { rotation: [row(0), row(1), row(2)], translation: pose.translation }
    }

    #[test]
    fn printed_copies_double() {
        printed_copies::<f64>();
    }

    #[test]
    fn printed_copies_single() {
        printed_copies::<f32>();
    }

    #[test]
    fn as_far_off_as_promised() {
        for (i, exact) in rotations().enumerate() {
            // Stretched by 0.85 to 1.2 along the axes of another rotation.
            let axes = Pose::from_xyz_rpy([0.0; 3], [i as f64, 0.3 * i as f64, 1.7 * i as f64]);
            let [x, y, z] = (axes.inverse()).rotation;
            let stretched = Pose { rotation: [scale(0.85, x), scale(1.2, y), scale(0.95, z)], translation: [0.0; 3] };
            let stretch = axes * stretched;
            let nearest = (exact * stretch).orthonormalized();
            let (skewness, apart) = (skewness(&nearest), apart(&nearest.rotation, &exact.rotation));
            assert!(skewness < 1e-15 && apart < 2e-15, "{skewness:e} {apart:e}");
        }
        // Entries off by 0.05 each, signs as bad as they come: a change of norm 0.15.
        let mut off = Pose::<f64>::identity();
        off.rotation.iter_mut().flatten().for_each(|entry| *entry -= 0.05);
        assert!(skewness(&off.orthonormalized()) < 1e-15);
    }

    #[test]
    fn rotations_stay() {
        let quarter = Pose::<f64> {
            rotation: [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]],
            translation: [f64::INFINITY, 0.0, 1.0],
        };
        assert_eq!(quarter.orthonormalized(), quarter);
        for pose in rotations() {
            assert!(apart(&pose.orthonormalized().rotation, &pose.rotation) < 4e-16);
        }
    }

    #[test]
    fn what_has_no_nearest_rotation() {
        let mirrored =
            Pose { rotation: [[1.001, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -0.999]], translation: [0.0; 3] };
        let expected = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        assert!(apart(&mirrored.orthonormalized().rotation, &expected) < 1e-15);
        for broken in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut pose = Pose::identity();
            pose.rotation[1][1] = broken;
            assert!(!pose.orthonormalized().is_finite());
        }
        assert!(!Pose { rotation: [[0.0_f32; 3]; 3], translation: [0.0; 3] }.orthonormalized().is_finite());
    }
}
