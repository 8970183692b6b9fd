//! Ticks of a follower, counted by how they stand to their target.

use core::fmt;

use denhart::follow::{Step, Tracking};

/// Ticks of a part of the path.
#[derive(Debug, Clone, Copy)]
pub struct Tally {
    /// On the target.
    pub exact: u32,
    /// Held back by the rates of the motors.
    pub rates: u32,
    /// Held back by the range of a joint.
    pub limits: u32,
    /// Out of reach.
    pub reach: u32,
    /// Without a target that can be used.
    pub target: u32,
    /// The largest distance from the target, mm.
    pub deviation: f32,
    last: Option<Tracking>,
}

impl Tally {
    /// Of no ticks.
    pub const fn new() -> Self {
        Self { exact: 0, rates: 0, limits: 0, reach: 0, target: 0, deviation: 0.0, last: None }
    }

    /// Counts a tick.
    pub fn note<const N: usize>(&mut self, step: &Step<f32, N>) {
        let count = match step.tracking {
            Tracking::Exact => &mut self.exact,
            Tracking::Rates => &mut self.rates,
            Tracking::Limits => &mut self.limits,
            Tracking::Reach => &mut self.reach,
            Tracking::Target => &mut self.target,
        };
        *count += 1;
        self.deviation = self.deviation.max(step.residual.position);
        self.last = Some(step.tracking);
    }

    /// Adds the ticks of a later part.
    pub fn add(&mut self, later: &Self) {
        self.exact += later.exact;
        self.rates += later.rates;
        self.limits += later.limits;
        self.reach += later.reach;
        self.target += later.target;
        self.deviation = self.deviation.max(later.deviation);
        self.last = later.last;
    }

    /// Returns true if the last tick is on its target.
    pub fn ended_exact(&self) -> bool {
        self.last == Some(Tracking::Exact)
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { exact, rates, limits, reach, target, deviation, .. } = self;
        write!(f, "exact {exact:>4}, rates {rates:>3}, limits {limits:>3}, reach {reach:>3}")?;
        if *target > 0 {
            write!(f, ", no target {target:>3}")?;
        }
        write!(f, "; off by up to {deviation:.3} mm")
    }
}
