//! Starting the iteration from several places, where none of the branches closes.

use super::refine::{Evaluate, refine_briefly, relative};
use super::settle::FREE_STEPS;
use super::{Goal, Search, Tolerances};
use crate::math::wrap;
use crate::{Flags, JointMask, Residual, Solution};

/// Places besides the first.
const RESTARTS: u32 = 16;
/// The golden ratio's fraction.
const GOLDEN: f64 = 0.618_033_988_749_895;

impl<T: Tolerances, G: Goal<T, N>, const N: usize, const M: usize> Search<'_, T, G, N, M> {
    /// At a singular target the first-order steps may not see the direction that is missing. From beside the place they
    /// do: a few fixed offsets are tried, of the free joint if it is known, else of all joints.
    #[cold]
    #[inline(never)]
    pub(super) fn restarted(
        &self,
        q: &[T; N],
        loose: JointMask,
        evaluate: &impl Evaluate<T, N>,
    ) -> ([T; N], Residual<T>) {
        self.best_of((1..=RESTARTS).map(|attempt| self.beside(q, loose, attempt)), evaluate)
    }

    /// Beside a pose where several singularities meet, equations of almost nothing can lead every branch astray. If
    /// nothing is listed, the iteration is started from the reference and from places spread over all joints; what comes
    /// within the tolerance is listed, without the name of a branch.
    #[cold]
    #[inline(never)]
    pub(super) fn rescue(&mut self, evaluate: &impl Evaluate<T, N>) {
        let facts = self.facts;
        let homes = facts.homes(self.near);
        let starts = core::iter::once(homes).chain((1..=RESTARTS).map(|attempt| self.spread(&homes, attempt)));
        let (mut q, mut residual) = self.best_of(starts.map(|start| self.goal.placed(start)), evaluate);
        for (joint, value) in q.iter_mut().enumerate() {
            if !facts.prismatic.contains(joint) && !self.goal.given().contains(joint) {
                *value = wrap(*value);
            }
        }
        let within =
            residual.position <= facts.tolerance.position && residual.orientation <= facts.tolerance.orientation;
        residual.orientation += self.deviation;
        let exact = relative(facts, &residual) <= T::EXACT;
        if within {
            let flags = if exact { Flags::EXACT } else { Flags::APPROXIMATE };
            self.solutions.push(Solution { q, flags, residual, ..Solution::EMPTY });
        }
    }

    /// The first start from which the iteration closes, or the one from which it comes nearest.
    fn best_of(&self, starts: impl Iterator<Item = [T; N]>, evaluate: &impl Evaluate<T, N>) -> ([T; N], Residual<T>) {
        let facts = self.facts;
        let mut best = (self.homes, Residual { position: T::INFINITY, orientation: T::INFINITY });
        for start in starts {
            let next = refine_briefly(facts, self.goal, &start, evaluate, FREE_STEPS);
            if relative(facts, &next.1) < relative(facts, &best.1) {
                best = next;
            }
            if relative(facts, &best.1) <= T::EXACT {
                break;
            }
        }
        best
    }

    /// A place beside a joint vector, farther off with every second attempt.
    fn beside(&self, q: &[T; N], loose: JointMask, attempt: u32) -> [T; N] {
        let facts = self.facts;
        let mut start = *q;
        // A stroke out of all proportion comes from slides that are nearly parallel.
        for joint in facts.prismatic.iter() {
            if let (Some(value), Some(home)) = (start.get_mut(joint), self.homes.get(joint))
                && !(value.abs() < facts.reach * T::from_f64(10.0))
            {
                *value = *home;
            }
        }
        let sign = if attempt.is_multiple_of(2) { -T::ONE } else { T::ONE };
        let size = T::from_f64(f64::from(attempt.div_ceil(2)));
        for (joint, value) in start.iter_mut().enumerate() {
            let unit = if facts.prismatic.contains(joint) { facts.reach } else { T::ONE };
            let offset = if self.goal.given().contains(joint) {
                T::ZERO
            } else if loose.contains(joint) {
                // The whole turn in eighths of half turns, both ways, nearest first.
                sign * size * T::PI * T::from_f64(0.125)
            } else if !loose.is_empty() {
                T::ZERO
            } else {
                // Different for every joint, so that no two stay in line.
                let spread = T::from_f64(0.01 + 0.007 * f64::from((joint as u32 * 5 + 2) % 7));
                sign * size * spread * if joint % 2 == 0 { T::ONE } else { -T::ONE }
            };
            *value += offset * unit;
        }
        start
    }

    /// One of the places that fill the box of all joints evenly: multiples of irrational numbers modulo 1, one for each
    /// joint (Kronecker). A slide is spread about its home, by a reach.
    fn spread(&self, homes: &[T; N], attempt: u32) -> [T; N] {
        let mut start = *homes;
        for (joint, value) in start.iter_mut().enumerate() {
            let turns = T::from_f64(f64::from(attempt) * GOLDEN) * T::from_f64(2.0 + joint as f64).sqrt();
            let angle = wrap(turns * T::TWO * T::PI);
            let slides = self.facts.prismatic.contains(joint);
            *value = if slides { *value + angle / T::PI * self.facts.reach } else { angle };
        }
        start
    }
}
