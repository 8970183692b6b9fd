//! Unit quaternions.

use crate::math::{self, Scalar};
use crate::pose::Pose;

impl<T: Scalar> Pose<T> {
    /// Pose from a position, in the length unit, and a quaternion `[w, x, y, z]`, scalar part first.
    ///
    /// The quaternion is brought to unit length; it and its negative are the same rotation. `None` for one that is zero
    /// or not finite.
    ///
    /// ```
    /// use denhart::Pose;
    ///
    /// let quarter = Pose::from_xyz_quaternion([0.0; 3], [1.0, 0.0, 0.0, 1.0]).map(|pose| pose.rotation);
    /// assert_eq!(quarter, Some([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]));
    /// ```
    #[must_use]
    pub fn from_xyz_quaternion(xyz: [T; 3], quaternion: [T; 4]) -> Option<Self> {
        let largest = quaternion.iter().fold(T::ZERO, |most, part| most.max(part.abs()));
        if !(largest > T::ZERO && quaternion.iter().all(|part| part.is_finite())) {
            return None;
        }
        // Scaled so that no square overflows or vanishes; the norm then only stands in one division.
        let [w, x, y, z] = quaternion.map(|part| part / largest);
        let two = T::TWO / (w * w + x * x + y * y + z * z);
        let rotation = [
            [T::ONE - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)],
            [two * (x * y + w * z), T::ONE - two * (x * x + z * z), two * (y * z - w * x)],
            [two * (x * z - w * y), two * (y * z + w * x), T::ONE - two * (x * x + y * y)],
        ];
        Some(Self { rotation, translation: xyz })
    }

    /// The orientation as a unit quaternion `[w, x, y, z]`, scalar part first.
    ///
    /// Of the two signs, the one with `w >= 0`. For half a turn (`w = 0`) the first part that is not zero is positive.
    /// Taken from the largest of the four parts (Shepperd 1978, "Quaternion from rotation matrix", J. Guidance and
    /// Control 1(3)), so no part loses accuracy anywhere. Not a number where the rotation is not finite.
    #[must_use]
    pub fn quaternion(&self) -> [T; 4] {
        of_rotation(&self.rotation)
    }
}

/// The unit quaternion `[w, x, y, z]` of a rotation matrix; of length 1 also where the matrix deviates from a rotation.
pub(super) fn of_rotation<T: Scalar>(&[[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]: &[[T; 3]; 3]) -> [T; 4] {
    let trace = xx + yy + zz;
    // Four times one part times all four: which part, by the largest of 4 w^2 - 1, 4 x^2 - 1, ..
    let scaled = if trace >= xx && trace >= yy && trace >= zz {
        [T::ONE + trace, zy - yz, xz - zx, yx - xy]
    } else if xx >= yy && xx >= zz {
        [zy - yz, T::ONE + xx - yy - zz, xy + yx, xz + zx]
    } else if yy >= zz {
        [xz - zx, xy + yx, T::ONE + yy - xx - zz, yz + zy]
    } else {
        [yx - xy, xz + zx, yz + zy, T::ONE + zz - xx - yy]
    };
    let first = scaled.iter().copied().find(|part| *part != T::ZERO).unwrap_or(T::ONE);
    let length = math::sqrt(scaled.iter().fold(T::ZERO, |sum, part| sum + *part * *part));
    // Adding zero leaves no negative zero.
    let scale = T::ONE.copysign(first) / length;
    scaled.map(|part| part * scale + T::ZERO)
}
