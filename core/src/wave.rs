//! Vectors as functions of the held angle.

use crate::Transform;
use crate::math::Scalar;
use crate::transform::Vector;

/// A vector as a function of an angle t: `constant + cosine cos t + sine sin t`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wave<T> {
    constant: Vector<T>,
    cosine: Vector<T>,
    sine: Vector<T>,
}

impl<T: Scalar> Wave<T> {
    /// The direction `to Rz(-t) (x, y, z)`.
    pub fn of([x, y, z]: Vector<T>, to: &Transform<T>) -> Self {
        Self {
            constant: to.turn([T::ZERO, T::ZERO, z]),
            cosine: to.turn([x, y, T::ZERO]),
            sine: to.turn([y, -x, T::ZERO]),
        }
    }

    /// This vector with a constant one added.
    pub fn plus(self, [dx, dy, dz]: Vector<T>) -> Self {
        let [x, y, z] = self.constant;
        Self { constant: [x + dx, y + dy, z + dz], ..self }
    }

    /// Returns true if all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        [&self.constant, &self.cosine, &self.sine].iter().all(|vector| vector.iter().all(|x| x.is_finite()))
    }

    /// The vector at an angle, of its sine and cosine. Out of line where size counts, see `math::ONE_COPY`.
    #[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
    #[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline(always))]
    pub fn at(&self, (sin, cos): (T, T)) -> Vector<T> {
        let ([x, y, z], [cx, cy, cz], [sx, sy, sz]) = (self.constant, self.cosine, self.sine);
        [x + cx * cos + sx * sin, y + cy * cos + sy * sin, z + cz * cos + sz * sin]
    }
}
