//! Pseudo-random starts.

use super::model::Model;
use crate::math::Scalar;

/// SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"): one word of state, the
/// same numbers on every platform.
#[derive(Debug, Clone)]
pub(super) struct Generator(u64);

impl Generator {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `0 .. 1`, with 24 bits, which both scalars hold.
    fn unit<T: Scalar>(&mut self) -> T {
        T::from_i32((self.bits() >> 40) as i32) / T::from_f64(16_777_216.0)
    }

    /// A joint vector within the limits. A joint without limits lies within half a turn of `center`, a prismatic one
    /// within `length`. A joint with one limit lies within a turn of the limit, a prismatic one within twice `length`.
    pub(super) fn start<T: Scalar, M: Model<T>>(&mut self, model: &M, center: &M::Joints, length: T) -> M::Joints {
        let mut q = center.clone();
        for (joint, value) in q.as_mut().iter_mut().enumerate() {
            let [low, high] = model.limits(joint);
            let around = if model.is_prismatic(joint) { length } else { T::PI };
            let [low, high] = match (low.is_finite(), high.is_finite()) {
                (true, true) => [low, high],
                (true, false) => [low, low + T::TWO * around],
                (false, true) => [high - T::TWO * around, high],
                (false, false) => [*value - around, *value + around],
            };
            *value = low + (high - low) * self.unit();
        }
        q
    }
}
