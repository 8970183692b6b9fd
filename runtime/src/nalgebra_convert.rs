//! Conversions to and from nalgebra.

use nalgebra::{
    Isometry3, Matrix3, Matrix4, Quaternion, RealField, Rotation3, SMatrix, SVector, Translation3, UnitQuaternion,
};

use crate::jacobian::Jacobian;
use crate::math::Scalar;
use crate::pose::Pose;
use crate::solution::Solution;

/// The rotation becomes a unit quaternion: every entry of its matrix changes by rounding, about 1e-16 (f32: 1e-7).
///
/// The quaternion is normalized; a rotation matrix that is not orthonormal is thereby made so.
impl<T: Scalar + RealField> From<Pose<T>> for Isometry3<T> {
    fn from(pose: Pose<T>) -> Self {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = pose.rotation;
        let matrix = nalgebra::Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz);
        let quaternion = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix));
        Self::from_parts(Translation3::from(pose.translation), UnitQuaternion::new_normalize(quaternion.into_inner()))
    }
}

/// The unit quaternion becomes a matrix, up to rounding.
impl<T: Scalar + RealField> From<Isometry3<T>> for Pose<T> {
    fn from(isometry: Isometry3<T>) -> Self {
        let columns: [[T; 3]; 3] = isometry.rotation.to_rotation_matrix().into_inner().into();
        let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = columns;
        Self { rotation: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]], translation: isometry.translation.vector.into() }
    }
}

/// The orientation, as [`Pose::quaternion`]: of length 1, with a scalar part that is not negative.
impl<T: Scalar + RealField> From<Pose<T>> for UnitQuaternion<T> {
    fn from(pose: Pose<T>) -> Self {
        let [w, x, y, z] = pose.quaternion();
        Self::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

/// The orientation, at the origin.
impl<T: Scalar + RealField> From<UnitQuaternion<T>> for Pose<T> {
    fn from(quaternion: UnitQuaternion<T>) -> Self {
        quaternion.to_rotation_matrix().into()
    }
}

/// The orientation, entry for entry.
impl<T: Scalar + nalgebra::Scalar> From<Pose<T>> for Rotation3<T> {
    fn from(pose: Pose<T>) -> Self {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = pose.rotation;
        Self::from_matrix_unchecked(Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz))
    }
}

/// The orientation, entry for entry, at the origin.
impl<T: Scalar + nalgebra::Scalar> From<Rotation3<T>> for Pose<T> {
    fn from(rotation: Rotation3<T>) -> Self {
        let columns: [[T; 3]; 3] = rotation.into_inner().into();
        let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = columns;
        Self { rotation: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]], translation: [T::ZERO; 3] }
    }
}

/// The homogeneous transform `[R p; 0 1]`, entry for entry.
impl<T: Scalar + nalgebra::Scalar> From<Pose<T>> for Matrix4<T> {
    fn from(pose: Pose<T>) -> Self {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = pose.rotation;
        let [px, py, pz] = pose.translation;
        let (o, i) = (T::ZERO, T::ONE);
        Self::new(xx, xy, xz, px, yx, yy, yz, py, zx, zy, zz, pz, o, o, o, i)
    }
}

/// The upper three rows, entry for entry; the last row is taken to be `0 0 0 1`.
impl<T: Scalar + nalgebra::Scalar> From<Matrix4<T>> for Pose<T> {
    fn from(matrix: Matrix4<T>) -> Self {
        let columns: [[T; 4]; 4] = matrix.into();
        let [[xx, yx, zx, _], [xy, yy, zy, _], [xz, yz, zz, _], [px, py, pz, _]] = columns;
        Self { rotation: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]], translation: [px, py, pz] }
    }
}

/// Entry for entry.
impl<T: Scalar + nalgebra::Scalar, const N: usize> From<Jacobian<T, N>> for SMatrix<T, 6, N> {
    fn from(jacobian: Jacobian<T, N>) -> Self {
        Self::from_row_iterator(jacobian.rows.into_iter().flatten())
    }
}

/// Entry for entry.
impl<T: Scalar + nalgebra::Scalar, const N: usize> From<SMatrix<T, 6, N>> for Jacobian<T, N> {
    fn from(matrix: SMatrix<T, 6, N>) -> Self {
        let columns: [[T; 6]; N] = matrix.into();
        let mut jacobian = Self::zero();
        for (row, entries) in jacobian.rows.iter_mut().enumerate() {
            for (entry, column) in entries.iter_mut().zip(&columns) {
                if let Some(value) = column.get(row) {
                    *entry = *value;
                }
            }
        }
        jacobian
    }
}

/// The joint values `q`.
impl<T: nalgebra::Scalar, const N: usize> From<Solution<T, N>> for SVector<T, N> {
    fn from(solution: Solution<T, N>) -> Self {
        Self::from(solution.q)
    }
}

/// The joint values `q`.
impl<T: nalgebra::Scalar, const N: usize> From<&Solution<T, N>> for SVector<T, N> {
    fn from(solution: &Solution<T, N>) -> Self {
        Self::from(solution.q.clone())
    }
}

#[cfg(all(test, any(feature = "std", feature = "libm")))]
mod tests {
    use super::*;
    use nalgebra::{Point3, Vector6};

    fn poses() -> [Pose<f64>; 5] {
        // A general rotation, then one near half a turn about each axis: every case of the matrix-to-quaternion step.
        [[0.4, -0.3, 0.2], [3.1, 0.01, 0.02], [0.01, 0.02, 3.1], [3.13, 0.01, 3.12], [0.0, 0.0, 0.0]]
            .map(|rpy| Pose::from_xyz_rpy([0.3, -1.2, 0.7], rpy))
    }

    #[test]
    fn isometry_moves_points_alike_and_comes_back() {
        for pose in poses() {
            let isometry = Isometry3::from(pose);
            let moved = isometry * Point3::new(0.5, -0.25, 2.0);
            let expected = pose.transform_point(&[0.5, -0.25, 2.0]);
            assert!(moved.coords.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-15), "{moved} {expected:?}");
            let gap = pose.residual(&isometry.into());
            assert!(gap.position == 0.0 && gap.orientation < 1e-15, "{gap:?}");
        }
    }

    #[test]
    fn orientations_come_back_and_turn_alike() {
        for pose in poses() {
            let (quaternion, matrix) = (UnitQuaternion::from(pose), Rotation3::from(pose));
            assert_eq!(Pose::from(matrix).rotation, pose.rotation);
            assert_eq!(Pose::from(matrix).translation, [0.0; 3]);
            let turned = Pose { translation: [0.0; 3], ..pose }.transform_point(&[0.5, -0.25, 2.0]);
            for moved in [quaternion * Point3::new(0.5, -0.25, 2.0), matrix * Point3::new(0.5, -0.25, 2.0)] {
                assert!(moved.coords.iter().zip(turned).all(|(a, b)| (a - b).abs() < 2e-15), "{moved} {turned:?}");
            }
            let gap = pose.residual(&Pose { translation: pose.translation, ..Pose::from(quaternion) });
            assert!(gap.orientation < 1e-15, "{gap:?}");
            assert!(quaternion.angle_to(&matrix.into()) < 1e-15);
            let vector = quaternion.scaled_axis();
            assert!(pose.rotation_vector().iter().zip(vector.iter()).all(|(a, b)| (a - b).abs() < 2e-15));
            assert!((quaternion.into_inner().norm() - 1.0).abs() < 4e-16);
        }
    }

    #[test]
    fn isometry_is_normalized() {
        for mut pose in poses() {
            pose.rotation = pose.rotation.map(|row| row.map(|entry| entry * (1.0 + 1e-7)));
            let isometry = Isometry3::from(pose);
            assert!((isometry.rotation.into_inner().norm() - 1.0).abs() < 4e-16);
        }
    }

    #[test]
    fn matrix_is_exact_both_ways() {
        for pose in poses() {
            let matrix = Matrix4::from(pose);
            assert_eq!(Pose::from(matrix), pose);
            assert_eq!(matrix.row(3).into_owned(), nalgebra::RowVector4::new(0.0, 0.0, 0.0, 1.0));
            let moved = matrix.transform_point(&Point3::new(0.5, -0.25, 2.0));
            let expected = pose.transform_point(&[0.5, -0.25, 2.0]);
            assert!(moved.coords.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-15));
        }
    }

    #[test]
    fn single_precision_too() {
        let pose = Pose::<f32>::from_xyz_rpy([1.0, 2.0, 3.0], [0.4, -0.3, 0.2]);
        assert!(pose.residual(&Isometry3::from(pose).into()).orientation < 1e-6);
        assert_eq!(Pose::from(Matrix4::from(pose)), pose);
    }

    #[test]
    fn jacobian_keeps_rows_and_columns() {
        let jacobian = Jacobian { rows: [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0], [9.0, 10.0], [11.0, 12.0]] };
        let matrix = SMatrix::<f64, 6, 2>::from(jacobian);
        assert_eq!(matrix.column(1).into_owned(), Vector6::new(2.0, 4.0, 6.0, 8.0, 10.0, 12.0));
        assert_eq!(Jacobian::from(matrix), jacobian);
        let twist: [f64; 6] = (matrix * nalgebra::Vector2::new(0.5, -2.0)).into();
        assert_eq!(twist, jacobian.mul(&[0.5, -2.0]));
    }

    #[test]
    fn solution_is_its_joint_vector() {
        let solution = Solution { q: [1.0_f32, 2.0, 3.0], ..Solution::EMPTY };
        assert_eq!(SVector::from(&solution), nalgebra::Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(SVector::from(solution), nalgebra::Vector3::new(1.0, 2.0, 3.0));
    }
}
