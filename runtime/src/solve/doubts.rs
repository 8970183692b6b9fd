//! The doubts of the stages of a branch, taken together.

use super::kernel::doubt::Doubt;
use super::kernel::tolerances::Tolerances;
use crate::{Flags, JointMask, Residual};

/// Doubts of a branch, taken together over all stages so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Doubts<T> {
    pub(super) gap: Residual<T>,
    pub(super) flags: Flags,
    pub(super) free: JointMask,
    /// The product of the relative amplitudes of the stages so far.
    pub(super) amplitude: T,
    /// Joints that an equation of very small amplitude gave: good only as far as the joints before are.
    pub(super) weak: JointMask,
    /// Every stage closes its own equation to rounding, see [`Doubt::closes`].
    closes: bool,
    /// A stage has a gap beyond rounding, and no joint before it is free or weak.
    pub(super) clamped: bool,
    /// The order of the root of the first stage that is missed. A stage is missed if its gap exceeds the tolerance, and a joint
    /// before it is free. Where that joint makes the stage just reach, the stage has a double root, as an elbow has: the order
    /// is 2. An equation that leaves its own joint free has a simple root: 1. Without a missed stage 0.
    pub(super) missed_order: u8,
    /// The joints before that stage that are free or weak.
    pub(super) missed_for: JointMask,
}

impl<T: Tolerances> Doubts<T> {
    /// Nothing yet.
    pub(super) const START: Self = Self {
        gap: Residual::ZERO,
        flags: Flags::NONE,
        free: JointMask::NONE,
        amplitude: T::ONE,
        weak: JointMask::NONE,
        closes: true,
        clamped: false,
        missed_order: 0,
        missed_for: JointMask::NONE,
    };

    /// The joints so far that may be elsewhere.
    pub(super) fn free_or_weak(&self) -> JointMask {
        self.free | self.weak
    }

    /// Returns true if the solution needs no verification: every stage closes its own equation to rounding, so the
    /// solution closes the target. The joints are known to `3 eps` over the product of the small amplitudes. Below
    /// `3 eps` rounding alone gives a joint.
    pub(super) fn are_settled(&self) -> bool {
        self.closes && self.free.is_empty() && self.amplitude >= T::VANISHING * T::DOUBTFUL
    }

    /// Returns true if a stage is missed, and may close with a joint before it elsewhere.
    pub(super) fn is_missed(&self) -> bool {
        self.missed_order > 0
    }

    /// Notes that the stage of this doubt is missed, behind the joints `free_or_weak`. The first such stage of a branch counts.
    pub(super) fn miss(&mut self, doubt: &Doubt<T>, free_or_weak: JointMask) {
        if !self.is_missed() {
            (self.missed_order, self.missed_for) = (if doubt.free.is_empty() { 2 } else { 1 }, free_or_weak);
        }
    }

    /// Adds the doubt of a stage.
    pub(super) fn note(&mut self, doubt: &Doubt<T>) {
        let Doubt { gap, angular, amplitude, closes, weak, boundary, free } = *doubt;
        self.closes &= closes;
        // The next stage magnifies the uncertainty that a stage leaves. If the product of amplitudes is below rounding, the joint of
        // an equation between directions counts as free. Where two roots coincide, refinement still moves the place.
        let product = self.amplitude * amplitude;
        let may_be_free = angular && free.is_empty() && !self.flags.contains(Flags::BOUNDARY);
        let free = if may_be_free && product < T::VANISHING * T::DOUBTFUL { weak } else { free };
        self.amplitude = product.max(T::EPSILON * T::EPSILON);
        self.weak |= weak;
        if angular {
            self.gap.orientation += gap;
        } else {
            self.gap.position += gap;
        }
        if boundary {
            self.flags |= Flags::BOUNDARY;
            // Where two roots coincide, the place is known to the root of what the equation is known to.
            self.amplitude = self.amplitude.min((T::ROUNDING * self.amplitude * T::HALF).sqrt());
        }
        if !free.is_empty() {
            self.flags |= Flags::FREE;
            self.free |= free;
        }
    }
}
