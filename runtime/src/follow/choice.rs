//! The choice of a goal among the solutions of a target.

use super::settings::Crossing;
use crate::branch::Branch;
use crate::math::Scalar;
use crate::solution::Solution;

/// A solution, as a place where the arm may go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate<T, const N: usize> {
    pub(super) q: [T; N],
    pub(super) branch: Branch,
    /// The solution, on the turns that are nearest, is within the limits.
    pub(super) is_within_limits: bool,
    /// Time of the way at full rates, in ticks.
    pub(super) ticks: T,
}

impl Crossing {
    /// Returns true if a deviation may lead from a branch to another one.
    pub(super) fn allows(self, from: Branch, to: Branch) -> bool {
        match self {
            Self::Exact => false,
            Self::Wrist => {
                let flips = from.wrist().is_some() && to.wrist().is_some() && from.wrist() != to.wrist();
                flips && from.shoulder() == to.shoulder() && from.elbow() == to.elbow()
            }
            Self::Any => true,
        }
    }
}

/// The candidates that a follower chooses from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Choice<T, const N: usize> {
    /// The nearest solution on the branch that is followed.
    pub(super) own: Option<Candidate<T, N>>,
    /// The nearest one on another branch, within the limits, to which a deviation may lead.
    pub(super) other: Option<Candidate<T, N>>,
}

impl<T: Scalar, const N: usize> Choice<T, N> {
    /// No candidate.
    pub(super) const NONE: Self = Self { own: None, other: None };

    /// Returns true if a solution that is so many ticks away is nearer than one that is known, or one is not known.
    pub(super) fn takes(&self, ticks: T) -> bool {
        let is_nearer = |known: &Option<Candidate<T, N>>| known.as_ref().is_none_or(|known| ticks < known.ticks);
        is_nearer(&self.own) || is_nearer(&self.other)
    }

    /// Notes a solution at joint values that are so many ticks away.
    pub(super) fn note(&mut self, solution: &Solution<T, N>, q: &[T; N], ticks: T, own: bool) {
        let place = if own { &mut self.own } else { &mut self.other };
        if place.as_ref().is_none_or(|known| ticks < known.ticks) {
            let (branch, is_within_limits) = (solution.branch, solution.is_within_limits());
            *place = Some(Candidate { q: *q, branch, is_within_limits, ticks });
        }
    }

    /// The candidate to go to, and true if it is on another branch. `second`: ticks of a second.
    pub(super) fn made(&self, second: T) -> Option<(&Candidate<T, N>, bool)> {
        let part = |share: f64| T::from_f64(share) * second;
        let worth = |other: &&Candidate<T, N>| match &self.own {
            Some(own) if own.is_within_limits => {
                other.ticks < T::from_f64(0.8) * own.ticks && other.ticks < part(0.4) && own.ticks > T::TWO
            }
            Some(_) => false,
            None => other.ticks < part(0.02),
        };
        match self.other.as_ref().filter(worth) {
            Some(other) => Some((other, true)),
            None => self.own.as_ref().map(|own| (own, false)),
        }
    }
}
