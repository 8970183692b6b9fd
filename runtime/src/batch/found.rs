//! The outcome of each target of a batch.

use crate::{Flags, Status};

/// The most solutions of a target.
pub const MOST_SOLUTIONS: usize = 16;

/// The outcome of one target of a batch; its joint values stand in a slice of their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// Outcome, as of [`Solutions::status`](crate::Solutions::status).
    pub status: Status<f64>,
    /// Deviation of the target's matrix from a rotation, as of [`Solutions::deviation`](crate::Solutions::deviation).
    pub deviation: f64,
    /// The number of solutions.
    pub count: u8,
    /// True if the target took the ordinary inverse, not lanes.
    pub scalar: bool,
    /// Facts about each solution; no flag beyond `count`.
    pub flags: [Flags; MOST_SOLUTIONS],
}

impl Found {
    /// Nothing: what a new slice is filled with.
    pub const NOTHING: Self = Self {
        status: Status::BadTarget,
        deviation: 0.0,
        count: 0,
        scalar: false,
        flags: [Flags::NONE; MOST_SOLUTIONS],
    };

    /// The outcome of a single call, without its solutions.
    pub(super) const fn of_single_call(status: Status<f64>, deviation: f64) -> Self {
        Self { status, deviation, scalar: true, ..Self::NOTHING }
    }

    /// The flags of the solutions, in their order.
    #[inline]
    #[must_use]
    pub fn flags(&self) -> &[Flags] {
        self.flags.get(..usize::from(self.count)).unwrap_or(&self.flags)
    }

    /// The numbers of the solutions within the arm's limits.
    pub fn within_limits(&self) -> impl Iterator<Item = usize> {
        let inside = |(number, flags): (usize, &Flags)| (!flags.contains(Flags::OUT_OF_LIMITS)).then_some(number);
        self.flags().iter().enumerate().filter_map(inside)
    }
}

/// No target.
impl Default for Found {
    fn default() -> Self {
        Self::NOTHING
    }
}

/// Counts over a batch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Summary {
    /// Targets with a solution that is exact; of a call for the nearest solution, within the limits.
    pub reached: usize,
    /// Targets that took the ordinary inverse.
    pub scalar: usize,
}

impl Summary {
    /// Adds a target.
    #[inline]
    pub fn add(&mut self, found: &Found) {
        self.reached += usize::from(found.flags().iter().any(|flags| flags.contains(Flags::EXACT)));
        self.scalar += usize::from(found.scalar);
    }
}
