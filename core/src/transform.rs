//! Rigid transforms.

use core::ops::Mul;

use crate::math::{Scalar, sin_cos};

/// A vector of three coordinates.
pub type Vector<T> = [T; 3];

/// Scalar product. Out of line where size counts, see `math::ONE_COPY`.
#[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
#[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline)]
pub fn dot<T: Scalar>([ax, ay, az]: Vector<T>, [bx, by, bz]: Vector<T>) -> T {
    ax * bx + ay * by + az * bz
}

/// Vector product.
#[inline]
pub fn cross<T: Scalar>([ax, ay, az]: Vector<T>, [bx, by, bz]: Vector<T>) -> Vector<T> {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// `a - b`
#[inline]
pub fn difference<T: Scalar>([ax, ay, az]: Vector<T>, [bx, by, bz]: Vector<T>) -> Vector<T> {
    [ax - bx, ay - by, az - bz]
}

/// Maps a point x to `rotation x + translation`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform<T> {
    /// The rows of the rotation matrix.
    pub rotation: [Vector<T>; 3],
    /// The image of the origin, in the arm's unit of length.
    pub translation: Vector<T>,
}

impl<T: Scalar> Transform<T> {
    /// Maps every point to itself.
    pub const IDENTITY: Self = Self {
        rotation: [[T::ONE, T::ZERO, T::ZERO], [T::ZERO, T::ONE, T::ZERO], [T::ZERO, T::ZERO, T::ONE]],
        translation: [T::ZERO; 3],
    };

    /// The image of a direction.
    #[inline]
    pub fn turn(&self, direction: Vector<T>) -> Vector<T> {
        self.rotation.map(|row| dot(row, direction))
    }

    /// The image of a point.
    #[inline]
    pub fn map(&self, point: Vector<T>) -> Vector<T> {
        let [x, y, z] = self.turn(point);
        let [tx, ty, tz] = self.translation;
        [x + tx, y + ty, z + tz]
    }

    /// The images of the three axes: the columns of the rotation matrix.
    #[inline]
    pub fn axes(&self) -> [Vector<T>; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        [[a, d, g], [b, e, h], [c, f, i]]
    }

    /// The image of the z axis.
    #[inline]
    pub fn z(&self) -> Vector<T> {
        let [_, _, z] = self.axes();
        z
    }

    /// The transform that undoes this one.
    #[inline]
    pub fn inverse(&self) -> Self {
        let rotation = self.axes();
        let back = Self { rotation, translation: [T::ZERO; 3] };
        Self { rotation, translation: back.turn(self.translation).map(|x| -x) }
    }

    /// `self * Rz(angle)`, of the sine and the cosine of the angle.
    #[inline]
    pub fn then_turn(&self, (sin, cos): (T, T)) -> Self {
        let rotation = self.rotation.map(|[x, y, z]| [x * cos + y * sin, y * cos - x * sin, z]);
        Self { rotation, translation: self.translation }
    }

    /// `self * Tz(displacement)`.
    #[inline]
    pub fn then_slide(&self, displacement: T) -> Self {
        let ([x, y, z], [zx, zy, zz]) = (self.translation, self.z());
        Self {
            rotation: self.rotation,
            translation: [x + displacement * zx, y + displacement * zy, z + displacement * zz],
        }
    }

    /// `self` moved by a joint: a turn about z, in rad, or a displacement along z.
    #[inline]
    pub fn then_move(&self, is_prismatic: bool, joint: T) -> Self {
        if is_prismatic { self.then_slide(joint) } else { self.then_turn(sin_cos(joint)) }
    }
}

impl<T: Scalar> Mul for Transform<T> {
    type Output = Self;

    /// Maps a point by `other` first. Out of line where size counts, see `math::ONE_COPY`.
    #[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
    #[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline)]
    fn mul(self, other: Self) -> Self {
        let [x, y, z] = other.axes();
        let rotation = self.rotation.map(|row| [dot(row, x), dot(row, y), dot(row, z)]);
        Self { rotation, translation: self.map(other.translation) }
    }
}

#[cfg(test)]
mod tests {
    use super::Transform;
    use crate::math::sin_cos;

    fn sample() -> Transform<f64> {
        let tilted =
            Transform { rotation: [[1.0, 0.0, 0.0], [0.0, 0.6, -0.8], [0.0, 0.8, 0.6]], translation: [1.0, 2.0, 3.0] };
        tilted.then_turn(sin_cos(0.7)).then_slide(0.25)
    }

    #[test]
    fn inverse_undoes() {
        let point = [0.3, -0.4, 0.5];
        let back = sample().inverse().map(sample().map(point));
        assert!(back.iter().zip(point).all(|(a, b)| (a - b).abs() < 1e-15));
    }

    #[test]
    fn a_product_maps_by_its_right_factor_first() {
        let (a, b) = (sample(), sample().inverse().then_turn(sin_cos(-1.2)));
        let point = [0.3, -0.4, 0.5];
        let (once, twice) = ((a * b).map(point), a.map(b.map(point)));
        assert!(once.iter().zip(twice).all(|(a, b)| (a - b).abs() < 1e-14));
    }
}
