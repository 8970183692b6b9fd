//! Stages and their roots.

use super::branch_state::BranchState;
use super::doubt::Doubt;
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::JointMask;

/// The unit of an equation: the typical size of its numbers, and whether a stage residual is a length or an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure<T> {
    /// Reach of the arm for lengths, 1 for directions.
    pub scale: T,
    angular: bool,
}

impl<T: Tolerances> Measure<T> {
    /// Components of unit vectors; gaps are in rad.
    pub const DIRECTION: Self = Self { scale: T::ONE, angular: true };

    /// Lengths of an arm with this reach.
    pub const fn length(reach: T) -> Self {
        Self { scale: reach, angular: false }
    }

    #[inline]
    pub(in crate::solve) fn is_angular(self) -> bool {
        self.angular
    }

    /// Amplitudes below this leave a joint free.
    #[inline]
    pub(in crate::solve) fn vanishing(self) -> T {
        T::VANISHING * self.scale
    }

    /// Rounding of a few operations.
    #[inline]
    pub(in crate::solve) fn rounding(self) -> T {
        T::ROUNDING * self.scale
    }
}

/// The roots of one equation for `K` joints, at most `R`, and how well they are determined. A stage that is
/// not in doubt has no `doubt`: every ordinary target passes there, and nothing is written for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roots<T, const K: usize, const R: usize> {
    pub(in crate::solve) roots: [[Turn<T>; K]; R],
    pub(in crate::solve) len: usize,
    pub(in crate::solve) doubt: Option<Doubt<T>>,
}

impl<T: Tolerances, const K: usize, const R: usize> Roots<T, K, R> {
    /// Roots that solve the equation.
    #[inline]
    pub(in crate::solve) fn solved(roots: [[Turn<T>; K]; R]) -> Self {
        Self { roots, len: R, doubt: None }
    }

    /// Roots of an equation with a relative amplitude. A small amplitude puts the stage in doubt. An
    /// amplitude below [`Tolerances::WEAK`] makes the joints of `weak` weak.
    #[inline(always)]
    pub(in crate::solve) fn determined(
        roots: [[Turn<T>; K]; R],
        measure: Measure<T>,
        amplitude: T,
        weak: JointMask,
    ) -> Self {
        let stage = Self::solved(roots);
        if amplitude < T::DOUBTFUL { stage.of_amplitude(measure, amplitude, weak) } else { stage }
    }

    /// Puts the stage in doubt for its small relative amplitude.
    #[inline]
    pub(in crate::solve) fn of_amplitude(mut self, measure: Measure<T>, amplitude: T, weak: JointMask) -> Self {
        let weak = if amplitude < T::WEAK { weak } else { JointMask::NONE };
        self.doubt = Some(Doubt { angular: measure.angular, amplitude, weak, ..Doubt::NOTHING });
        self
    }

    /// Sets whether the roots close the equation although the stage is in doubt, see [`Doubt::closes`].
    #[inline(always)]
    pub(in crate::solve) fn closing(mut self, closes: bool) -> Self {
        if let Some(doubt) = &mut self.doubt {
            doubt.closes = closes;
        }
        self
    }

    /// The doubt of the stage; a stage without one gets an empty doubt.
    pub(in crate::solve) fn doubted(&mut self, measure: Measure<T>) -> &mut Doubt<T> {
        self.doubt.get_or_insert(Doubt { angular: measure.angular, ..Doubt::NOTHING })
    }

    /// How far the equation is from having a root, a length or rad: 0 where it has one. `None` of an equation without roots
    /// that does not tell.
    pub fn gap(&self) -> Option<T> {
        (self.len > 0).then(|| self.doubt.map_or(T::ZERO, |doubt| doubt.gap))
    }

    /// The joints that the stage leaves free.
    #[inline]
    pub(in crate::solve) fn free(&self) -> JointMask {
        self.doubt.map_or(JointMask::NONE, |doubt| doubt.free)
    }

    /// Scales the amplitude by `share`, where the joint moves its point or direction by a small share of the scale
    /// only. The joint is weak below [`Tolerances::WEAK`].
    #[cold]
    #[inline(never)]
    pub(in crate::solve) fn narrowed(&mut self, default: DefaultValue<T>, measure: Measure<T>, share: T) {
        let doubt = self.doubted(measure);
        doubt.amplitude *= share;
        if doubt.amplitude < T::WEAK {
            doubt.weak = default.joint;
        }
    }

    /// Adds a joint that is weak if `amplitude` is below [`Tolerances::WEAK`].
    #[inline]
    pub(in crate::solve) fn nearly_free(mut self, default: DefaultValue<T>, measure: Measure<T>, amplitude: T) -> Self {
        let doubt = self.doubted(measure);
        doubt.amplitude = doubt.amplitude.min(amplitude);
        if amplitude < T::WEAK {
            doubt.weak |= default.joint;
        }
        self
    }

    /// The one place where two roots meet, or the nearest to a solution, missing it by `gap`.
    #[inline]
    pub(in crate::solve) fn edge(root: [Turn<T>; K], gap: T, measure: Measure<T>) -> Self {
        let doubt = Doubt { gap, angular: measure.angular, boundary: true, ..Doubt::NOTHING };
        Self { len: 1, doubt: Some(doubt), ..Self::solved([root; R]) }
    }

    /// The equation leaves its first joint free: the joint takes its default value.
    #[cold]
    #[inline(never)]
    pub(in crate::solve) fn left_free(
        mut root: [Turn<T>; K],
        default: DefaultValue<T>,
        gap: T,
        measure: Measure<T>,
    ) -> Self {
        if let Some(first) = root.first_mut() {
            *first = Turn::at(default.value);
        }
        let doubt = Doubt { gap, angular: measure.angular, free: default.joint, ..Doubt::NOTHING };
        Self { len: 1, doubt: Some(doubt), ..Self::solved([root; R]) }
    }

    /// The roots to go on with, each with its index; none if the branch has ended. With `wanted` only the root of that
    /// index, which is the one root where two coincide, or where a free joint leaves but one.
    #[inline]
    pub fn each(&self, state: &BranchState, wanted: Option<usize>) -> impl Iterator<Item = (usize, &[Turn<T>; K])> {
        let len = if state.ended() { 0 } else { self.len.min(R) };
        let (first, end, name) = match wanted {
            None => (0, len, 0),
            Some(index) if index >= len && self.doubt.is_some_and(|doubt| doubt.boundary || !doubt.free.is_empty()) => {
                (0, len.min(1), index)
            }
            Some(index) => (index.min(len), index.saturating_add(1).min(len), index),
        };
        self.roots.get(first..end).unwrap_or(&[]).iter().enumerate().map(move |(index, root)| (name + index, root))
    }

    /// The roots to go on with, as [`each`](Self::each), for a wrist whose two roots differ by a flip.
    #[inline]
    pub fn each_flip(
        &self,
        state: &BranchState,
        wanted: Option<usize>,
    ) -> impl Iterator<Item = (usize, &[Turn<T>; K])> {
        self.each(state, state.flips(wanted))
    }

    /// The roots turned by a further half turn (first joint) if `reverse` is set. For links whose lengths have unlike
    /// signs, stretched is where folded would be.
    #[inline]
    pub fn turned_back(mut self, reverse: bool) -> Self {
        if reverse && self.free().is_empty() {
            for root in &mut self.roots {
                if let Some(first) = root.first_mut() {
                    *first = first.opposite();
                }
            }
        }
        self
    }

    /// The roots turned by a further angle (first joint).
    #[inline]
    pub fn about(mut self, phase: Turn<T>) -> Self {
        if self.free().is_empty() {
            for root in &mut self.roots {
                if let Some(first) = root.first_mut() {
                    *first = first.plus(phase);
                }
            }
        }
        self
    }
}

impl<T: Tolerances, const K: usize> Roots<T, K, 1> {
    /// The root of a stage that has just one.
    #[inline]
    pub fn only(&self) -> [Turn<T>; K] {
        let [root] = self.roots;
        root
    }
}
