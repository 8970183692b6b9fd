//! State of a branch, and the doubts of its stages.

use super::Tolerances;
use super::level::LevelOf;
use crate::{Flags, JointMask, Residual};

/// State of a branch, which generated code hands from stage to stage. The search keeps the doubts of each stage on the
/// way. A branch without doubts has none.
///
/// One number, 0 without doubts: the number of doubts that belong to the branch, and two marks. One mark says that the
/// solution is to be verified whatever the doubts are, the other that the branch has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BranchState(u32);

impl BranchState {
    const VERIFY: u32 = 0x100;
    const ENDED: u32 = 0x200;

    /// The start of every branch.
    #[inline]
    pub(super) fn start(verify: bool) -> Self {
        Self(if verify { Self::VERIFY } else { 0 })
    }

    /// Returns true if a stage is in doubt, or the solution is to be verified.
    #[inline]
    pub(super) fn doubt(self) -> bool {
        self.0 != 0
    }

    /// Returns true if the solution is to be verified whatever the doubts are.
    pub(super) fn verify(self) -> bool {
        self.0 & Self::VERIFY != 0
    }

    /// Returns true if the branch leads nowhere: a stage has no root near it, and no joint before it may move.
    #[inline]
    pub(super) fn ended(self) -> bool {
        self.0 & Self::ENDED != 0
    }

    /// The root of a wrist to follow, if one is wanted. In doubt both are followed: the solution of the second one follows
    /// from that of the first.
    #[inline]
    pub fn flips(self, wanted: Option<usize>) -> Option<usize> {
        wanted.filter(|_| !self.doubt())
    }

    /// The number of doubts that belong to the branch.
    pub(super) fn depth(self) -> usize {
        (self.0 & (Self::VERIFY - 1)) as usize
    }

    /// Marks the branch to be verified if `verify` is set.
    #[inline]
    pub(super) fn doubted(self, verify: bool) -> Self {
        Self(self.0 | Self::start(verify).0)
    }

    /// Adds one more state to the branch.
    pub(super) fn deeper(self, ended: bool) -> Self {
        Self((self.0 + 1) | if ended { Self::ENDED } else { 0 })
    }
}

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
    /// A stage has no root near the branch, but a joint before it is free and may be elsewhere.
    pub(super) missed: bool,
    /// A stage is missed by more than rounding, and the joints before it are what they have to be.
    pub(super) clamped: bool,
    /// The first joint that is free or weak.
    pub(super) first: JointMask,
    /// The level of the last stage, if a joint before it is free or weak.
    pub(super) level: LevelOf<T>,
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
        missed: false,
        clamped: false,
        first: JointMask::NONE,
        level: LevelOf::Nothing,
    };

    /// The joints so far that may be elsewhere.
    pub(super) fn loose(&self) -> JointMask {
        self.free | self.weak
    }

    /// Returns true if the solution needs no verification: every stage closes its own equation to rounding, so the
    /// solution closes the target. The joints are known to `3 eps` over the product of the small amplitudes. Below
    /// `3 eps` rounding alone gives a joint.
    pub(super) fn are_settled(&self) -> bool {
        self.closes && self.free.is_empty() && self.amplitude >= T::VANISHING * T::DOUBTFUL
    }

    /// Adds the doubt of a stage.
    pub(super) fn note(&mut self, doubt: Option<Doubt<T>>, level: LevelOf<T>) {
        self.level = if self.loose().is_empty() { LevelOf::Nothing } else { level };
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
        if self.first.is_empty() {
            self.first = free | weak;
        }
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

/// Doubt of one stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Doubt<T> {
    pub(super) gap: T,
    pub(super) angular: bool,
    pub(super) boundary: bool,
    /// Conditioning of the stage; 1 where it is not in doubt.
    pub(super) amplitude: T,
    /// True if the roots close the equation of the stage to rounding, however small the amplitude. The vectors of the
    /// later stages then have the lengths that they should have. Two roots of one joint close only where they are
    /// farther apart than [`Tolerances::COINCIDENT`]: closer ones may be one solution.
    pub(super) closes: bool,
    pub(super) weak: JointMask,
    pub(super) free: JointMask,
}

impl<T: Tolerances> Doubt<T> {
    /// Nothing.
    pub(super) const NOTHING: Self = Self {
        gap: T::ZERO,
        angular: false,
        boundary: false,
        amplitude: T::ONE,
        closes: false,
        weak: JointMask::NONE,
        free: JointMask::NONE,
    };
}
