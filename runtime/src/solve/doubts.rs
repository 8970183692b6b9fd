//! The doubts of the stages of a branch, taken together.

use super::kernel::doubt::Doubt;
use super::kernel::level::LevelOf;
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
    /// A stage is missed by more than rounding, and the joints before it are what they have to be.
    pub(super) clamped: bool,
    /// The way to the last stage: tells the stages on the branches of one run apart, and is the same in every run.
    pub(super) way: u32,
    /// The way to the first stage that is missed, 0 without any: it has no root near the branch, but a joint before it is free.
    /// And the joints before it that may be elsewhere.
    pub(super) missed_at: u32,
    pub(super) missed_for: JointMask,
    /// The level of that stage, NaN if it has none, or follows no such joint.
    pub(super) level: T,
    /// That stage is an equation without a joint of its own.
    pub(super) is_jointless: bool,
    /// A slide is solved behind a joint that is free or weak: what that joint does to later levels is not known.
    has_slide: bool,
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
        way: 1,
        missed_at: 0,
        missed_for: JointMask::NONE,
        level: T::NAN,
        is_jointless: false,
        has_slide: false,
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

    /// The level of the stage that follows the joints `free_or_weak`. NaN if the stage has none, follows no such joint, or a slide
    /// is solved in between.
    pub(super) fn level_behind(&mut self, free_or_weak: JointMask, level: LevelOf<T>) -> T {
        self.has_slide |= matches!(level, LevelOf::Slide) && !free_or_weak.is_empty();
        match level {
            LevelOf::Cosine(level) | LevelOf::Zero(level) if !(free_or_weak.is_empty() || self.has_slide) => level,
            _ => T::NAN,
        }
    }

    /// Returns true if a stage is missed, and may close with a joint before it elsewhere.
    pub(super) fn is_missed(&self) -> bool {
        self.missed_at != 0
    }

    /// Notes that the stage `way` is missed, and may close with the joints `free_or_weak` elsewhere. The first such stage of a
    /// branch counts.
    pub(super) fn miss(&mut self, free_or_weak: JointMask, level: LevelOf<T>, known: T) {
        if !self.is_missed() {
            (self.missed_at, self.missed_for, self.level) = (self.way, free_or_weak, known);
            self.is_jointless = matches!(level, LevelOf::Zero(_));
        }
    }

    /// Adds the doubt of a stage.
    pub(super) fn note(&mut self, doubt: Option<Doubt<T>>) {
        let Some(Doubt { gap, angular, amplitude, closes, weak, boundary, free }) = doubt else { return };
        self.closes &= closes;
        // The next stage magnifies the uncertainty that a stage leaves. Where nothing but uncertainty is left of an
        // amplitude between directions, any value of the joint is as good. Where two roots coincide, refinement still
        // moves the place.
        let product = self.amplitude * amplitude;
        let settled = angular && free.is_empty() && !self.flags.contains(Flags::BOUNDARY);
        let free = if settled && product < T::VANISHING * T::DOUBTFUL { weak } else { free };
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
