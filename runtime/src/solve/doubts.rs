//! What is remembered of an awkward pose.

use super::Tolerances;
use super::elsewhere::Elsewhere;
use crate::JointMask;

/// What a search remembers of an awkward pose; at an ordinary one there is nothing to remember.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Doubts<T, const M: usize> {
    /// Branches that have to be followed again with a free joint elsewhere.
    pub(super) elsewhere: Elsewhere<T, M>,
    /// Bit i: solution i is to be checked in full.
    pub(super) solutions: u32,
    /// Whether any of them has such joints.
    pub(super) astray: bool,
    /// For each solution the joints that are free or nearly so.
    pub(super) loose: [JointMask; M],
    /// The least residual of the branches that were checked in full and are none.
    pub(super) checked_gap: Option<T>,
    /// The least gap of a stage at which a branch ended.
    pub(super) stage_gap: Option<T>,
    /// The same over reach, or in rad.
    pub(super) relative_gap: T,
    /// Branches that are missed by no more than this (over reach, or rad) are followed to their end, as the nearest
    /// approach to a target out of reach.
    pub(super) nearest: T,
}

impl<T: Tolerances, const M: usize> Doubts<T, M> {
    pub(super) const NONE: Self = Self {
        elsewhere: Elsewhere::START,
        solutions: 0,
        astray: false,
        loose: [JointMask::NONE; M],
        checked_gap: None,
        stage_gap: None,
        relative_gap: T::INFINITY,
        nearest: T::ZERO,
    };

    /// A branch has been checked in full and misses by this.
    pub(super) fn misses(&mut self, residual: T) {
        self.checked_gap = Some(self.checked_gap.map_or(residual, |least| least.min(residual)));
    }

    /// A stage is missed by this, over reach (or in rad) by `relative`. Returns whether its branch ends there.
    pub(super) fn ends(&mut self, gap: T, relative: T) -> bool {
        self.relative_gap = self.relative_gap.min(relative);
        let ends = relative > self.nearest;
        if ends {
            self.stage_gap = Some(self.stage_gap.map_or(gap, |least| least.min(gap)));
        }
        ends
    }
}
