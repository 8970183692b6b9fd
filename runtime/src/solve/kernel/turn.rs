//! A joint angle together with its sine and cosine.

use super::tolerances::Tolerances;
use crate::JointMask;
use crate::math::{angle, angle_array, sin_cos};

/// A joint value. For an angle also its sine and cosine, so that the next stage needs no trigonometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn<T> {
    /// The angle in (-pi, pi], rad; for a sliding joint its position in the length unit.
    pub value: T,
    /// Its sine (0 for a sliding joint).
    pub sin: T,
    /// Its cosine (1 for a sliding joint).
    pub cos: T,
}

impl<T: Tolerances> Turn<T> {
    /// No turn.
    pub const ZERO: Self = Self { value: T::ZERO, sin: T::ZERO, cos: T::ONE };

    /// No turn, where two roots coincide: the limit of the first root, whose sine is positive. Far below rounding, the
    /// sine still tells a later stage the direction of a vector. That vector has become too short to have a direction
    /// of its own.
    pub(in crate::solve) const STRETCHED: Self = Self { sin: T::LEAST_SINE, ..Self::ZERO };

    /// Half a turn, where two roots coincide: the limit of the first root, as for [`Turn::STRETCHED`].
    pub(in crate::solve) const FOLDED: Self = Self { value: T::PI, sin: T::LEAST_SINE, cos: T::MINUS_ONE };

    /// From a sine and cosine, `sin^2 + cos^2 = 1`.
    #[inline]
    pub fn of(sin: T, cos: T) -> Self {
        Self { value: in_range(angle(sin, cos)), sin, cos }
    }

    /// From several sines and cosines at once.
    #[inline(always)]
    pub fn array<const N: usize>(sines: [T; N], cosines: [T; N]) -> [Self; N] {
        let values = angle_array(sines, cosines);
        let mut turns = [Self::ZERO; N];
        for (turn, ((value, sin), cos)) in turns.iter_mut().zip(values.into_iter().zip(sines).zip(cosines)) {
            *turn = Self { value: in_range(value), sin, cos };
        }
        turns
    }

    /// From any vector in the plane that is not zero.
    #[inline(never)]
    pub fn towards(y: T, x: T) -> Self {
        let k = T::ONE / (x * x + y * y).sqrt();
        Self::of(y * k, x * k)
    }

    /// From any vector in the plane; no turn for one that is zero, or too short to have a direction.
    #[inline]
    pub fn direction(y: T, x: T) -> Self {
        let square = x * x + y * y;
        if !(square > T::ZERO && square.is_finite()) {
            return Self::ZERO;
        }
        let k = T::ONE / square.sqrt();
        Self::of(y * k, x * k)
    }

    /// From an angle.
    #[inline(never)]
    pub fn at(value: T) -> Self {
        let (sin, cos) = sin_cos(value);
        Self { value, sin, cos }
    }

    /// Position of a sliding joint.
    #[inline]
    pub fn position(value: T) -> Self {
        Self { value, sin: T::ZERO, cos: T::ONE }
    }

    /// The opposite turn.
    #[inline]
    pub fn reversed(self) -> Self {
        Self { value: in_range(-self.value), sin: -self.sin, cos: self.cos }
    }

    /// Half a turn further.
    #[inline]
    pub fn opposite(self) -> Self {
        // Towards 0, without a branch; from 0, of either sign, to pi.
        let value = self.value + T::PI.copysign(T::ZERO - self.value);
        Self { value: in_range(value), sin: -self.sin, cos: -self.cos }
    }

    /// One turn after the other.
    #[inline]
    pub fn plus(self, other: Self) -> Self {
        Self {
            value: crate::math::wrap(self.value + other.value),
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }
}

/// -pi is not in the range; the float above it is the same angle to rounding.
#[inline]
fn in_range<T: Tolerances>(angle: T) -> T {
    let least = T::EPSILON * T::TWO - T::PI;
    if angle > least { angle } else { least }
}

/// Where a joint stays if an equation leaves it free: its reference value, and its bit in the mask of free joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DefaultValue<T> {
    /// In the variable of the kernel.
    pub value: T,
    /// The joint.
    pub joint: JointMask,
    /// The joints that already an amplitude near zero leaves free.
    pub(in crate::solve) nearly_free: JointMask,
}

impl<T: Tolerances> DefaultValue<T> {
    /// A joint that stays at a value where it is free.
    #[inline]
    pub fn at(value: T, joint: JointMask) -> Self {
        Self { value, joint, nearly_free: JointMask::NONE }
    }

    /// An equation of less amplitude than this leaves the joint free.
    pub(in crate::solve) fn free_below(self) -> T {
        if self.nearly_free.meets(self.joint) { T::WEAK } else { T::VANISHING }
    }

    /// Returns true if an equation of this amplitude, for quantities of size `scale`, leaves the joint free. An
    /// amplitude that is not a number also leaves the joint free.
    #[inline(always)]
    pub(in crate::solve) fn is_free(self, amplitude: T, scale: T) -> bool {
        // An ordinary amplitude is above either bound.
        !(amplitude > T::WEAK * scale) && self.is_free_below(amplitude, scale)
    }

    #[cold]
    #[inline(never)]
    fn is_free_below(self, amplitude: T, scale: T) -> bool {
        !(amplitude > self.free_below() * scale)
    }

    /// For a kernel whose variable is the joint value plus `by`.
    #[inline]
    pub fn shifted(self, by: T) -> Self {
        Self { value: self.value + by, ..self }
    }

    /// For a kernel whose variable runs against the joint.
    #[inline]
    pub fn reversed(self) -> Self {
        Self { value: -self.value, ..self }
    }
}
