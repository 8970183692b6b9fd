//! Stages, their roots, and what is remembered along a branch.

use super::{DefaultValue, Tolerances, Turn};
use crate::{Flags, JointMask, Residual};

/// What the numbers of an equation measure: their typical size, and whether a gap is a length or an angle.
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
    pub(super) fn is_angular(self) -> bool {
        self.angular
    }

    /// Amplitudes below this leave a joint free.
    #[inline]
    pub(super) fn vanishing(self) -> T {
        T::VANISHING * self.scale
    }

    /// Rounding of a few operations.
    #[inline]
    pub(super) fn rounding(self) -> T {
        T::ROUNDING * self.scale
    }
}

/// A number that says whether a stage has roots: it has them if and only if `low <= value <= high`.
///
/// A stage with two roots a half difference h apart solves `cos(h) = value` between -1 and 1. A stage that a slide
/// solves needs a square that is not negative. An equation without a joint of its own needs the value 0. The value is
/// known outside its range too. A joint that turns points about an axis moves the value as `a + b cos(x - phi)`. With a
/// slide between that follows, the value moves as a polynomial of degree 2 over the square of the slide's coefficient,
/// the pole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level<T> {
    pub(super) value: T,
    pub(super) low: T,
    pub(super) high: T,
    pub(super) pole: T,
}

impl<T: Tolerances> Level<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self { value: T::NAN, low: T::NAN, high: T::NAN, pole: T::ONE };

    /// Whether it is that of a slide: the coefficient alone.
    pub(super) fn is_slide(&self) -> bool {
        self.low.is_finite() && !self.value.is_finite()
    }

    /// Whether an equation without a joint of its own holds.
    pub(super) fn is_met(&self) -> bool {
        self.low == self.high && self.value.abs() <= T::COINCIDENT
    }
}

/// The level of a stage as its kernel leaves it: one number, and what it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LevelOf<T> {
    /// Nothing is known.
    Nothing,
    /// The cosine of half the difference of two angles.
    Cosine(T),
    /// A square.
    Square(T),
    /// What has to vanish.
    Zero(T),
    /// Nothing but the coefficient of a slide.
    Slide(T),
}

impl<T: Tolerances> From<LevelOf<T>> for Level<T> {
    fn from(level: LevelOf<T>) -> Self {
        match level {
            LevelOf::Nothing => Self::NONE,
            LevelOf::Cosine(value) => Self { value, low: -T::ONE, high: T::ONE, ..Self::NONE },
            LevelOf::Square(value) => Self { value, low: T::ZERO, high: T::MAX, ..Self::NONE },
            LevelOf::Zero(value) => Self { value, low: T::ZERO, high: T::ZERO, ..Self::NONE },
            LevelOf::Slide(pole) => Self { pole, low: T::ZERO, ..Self::NONE },
        }
    }
}

/// The level of a stage behind a free joint, and whether a slide stands between, whose coefficient is part of the pole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Behind<T> {
    pub(super) level: Level<T>,
    pub(super) slides: bool,
}

impl<T: Tolerances> Behind<T> {
    /// No stage.
    pub(super) const NONE: Self = Self { level: Level::NONE, slides: false };
}

/// Where a branch of the cascade is: what generated code hands from stage to stage. The search keeps the
/// doubts of each stage on the way. A branch without doubts has none.
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

    /// A stage is in doubt, or the solution is to be verified.
    #[inline]
    pub(super) fn doubt(self) -> bool {
        self.0 != 0
    }

    /// The solution is to be verified whatever the doubts are.
    pub(super) fn verify(self) -> bool {
        self.0 & Self::VERIFY != 0
    }

    /// The branch leads nowhere: a stage has no root near it, and the joints before it are what they have to be.
    #[inline]
    pub(super) fn ended(self) -> bool {
        self.0 & Self::ENDED != 0
    }

    /// The number of doubts that belong to the branch.
    pub(super) fn depth(self) -> usize {
        (self.0 & (Self::VERIFY - 1)) as usize
    }

    /// The same branch, to be verified if `verify` is set.
    #[inline]
    pub(super) fn doubted(self, verify: bool) -> Self {
        Self(self.0 | Self::start(verify).0)
    }

    /// The same branch with one more state.
    pub(super) fn deeper(self, ended: bool) -> Self {
        Self((self.0 + 1) | if ended { Self::ENDED } else { 0 })
    }
}

/// What puts a branch in doubt, all its stages so far taken together.
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

    /// Whether the solution needs no verification: every stage closes its own equation to rounding, so the solution
    /// closes the target. The joints are known to `3 eps` over the product of the small amplitudes. Below `3 eps`
    /// rounding alone gives a joint.
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

/// What puts a stage in doubt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Doubt<T> {
    pub(super) gap: T,
    pub(super) angular: bool,
    pub(super) boundary: bool,
    /// Relative size of what determines the joint; 1 where that is not in doubt.
    pub(super) amplitude: T,
    /// Whether the roots close the equation of the stage to rounding, however small the amplitude. The vectors of the
    /// later stages then have the lengths that they are to have.
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

/// The roots of one equation for `K` joints, at most `R`, and how well they are determined. A stage that is
/// not in doubt has no `doubt`: every ordinary target passes there, and nothing is written for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage<T, const K: usize, const R: usize> {
    pub(super) roots: [[Turn<T>; K]; R],
    pub(super) len: usize,
    /// Whether there are roots.
    pub(super) level: LevelOf<T>,
    pub(super) doubt: Option<Doubt<T>>,
}

impl<T: Tolerances, const K: usize, const R: usize> Stage<T, K, R> {
    /// Roots that solve the equation.
    #[inline]
    pub(super) fn solved(roots: [[Turn<T>; K]; R]) -> Self {
        Self { roots, len: R, level: LevelOf::Nothing, doubt: None }
    }

    /// The same with its level, and the relative amplitude of the equation. A small amplitude makes the stage doubtful,
    /// and an amplitude near zero leaves `weak` nearly free.
    #[inline(always)]
    pub(super) fn determined(
        roots: [[Turn<T>; K]; R],
        measure: Measure<T>,
        level: LevelOf<T>,
        amplitude: T,
        weak: JointMask,
    ) -> Self {
        let stage = Self::solved(roots).at_level(level);
        if amplitude < T::DOUBTFUL { stage.of_amplitude(measure, amplitude, weak, false) } else { stage }
    }

    /// The same where the roots close the equation however small the amplitude, see [`Doubt::closes`].
    #[inline(always)]
    pub(super) fn closing(
        roots: [[Turn<T>; K]; R],
        measure: Measure<T>,
        level: LevelOf<T>,
        amplitude: T,
        weak: JointMask,
    ) -> Self {
        let stage = Self::solved(roots).at_level(level);
        // Two roots of one joint have to be farther apart than what makes two solutions one.
        let closes = !weak.is_empty() || amplitude + amplitude >= T::COINCIDENT;
        if amplitude < T::DOUBTFUL { stage.of_amplitude(measure, amplitude, weak, closes) } else { stage }
    }

    /// The same with a small relative amplitude, in doubt.
    #[inline]
    pub(super) fn of_amplitude(mut self, measure: Measure<T>, amplitude: T, weak: JointMask, closes: bool) -> Self {
        let weak = if amplitude < T::WEAK { weak } else { JointMask::NONE };
        self.doubt = Some(Doubt { angular: measure.angular, amplitude, closes, weak, ..Doubt::NOTHING });
        self
    }

    /// The same with its level.
    #[inline]
    pub(super) fn at_level(mut self, level: LevelOf<T>) -> Self {
        self.level = level;
        self
    }

    /// Its doubt, from now on.
    pub(super) fn doubted(&mut self, measure: Measure<T>) -> &mut Doubt<T> {
        self.doubt.get_or_insert(Doubt { angular: measure.angular, ..Doubt::NOTHING })
    }

    /// The joints that it leaves free.
    #[inline]
    pub(super) fn free(&self) -> JointMask {
        self.doubt.map_or(JointMask::NONE, |doubt| doubt.free)
    }

    /// The same roots where the joint moves its point or direction by a small share of the scale only: the joint is
    /// nearly free.
    #[cold]
    #[inline(never)]
    pub(super) fn narrowed(&mut self, default: DefaultValue<T>, measure: Measure<T>, share: T) {
        let doubt = self.doubted(measure);
        doubt.amplitude *= share;
        if doubt.amplitude < T::WEAK {
            doubt.weak = default.joint;
        }
    }

    /// A further joint that this amplitude leaves nearly free.
    #[inline]
    pub(super) fn nearly_free(mut self, default: DefaultValue<T>, measure: Measure<T>, amplitude: T) -> Self {
        let doubt = self.doubted(measure);
        doubt.amplitude = doubt.amplitude.min(amplitude);
        if amplitude < T::WEAK {
            doubt.weak |= default.joint;
        }
        self
    }

    /// The one place where two roots meet, or the nearest to a solution, missing it by `gap`.
    #[inline]
    pub(super) fn edge(root: [Turn<T>; K], gap: T, measure: Measure<T>) -> Self {
        let doubt = Doubt { gap, angular: measure.angular, boundary: true, ..Doubt::NOTHING };
        Self { len: 1, doubt: Some(doubt), ..Self::solved([root; R]) }
    }

    /// The equation leaves its first joint free: it stays at its reference value.
    #[cold]
    #[inline(never)]
    pub(super) fn left_free(mut root: [Turn<T>; K], default: DefaultValue<T>, gap: T, measure: Measure<T>) -> Self {
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

impl<T: Tolerances, const K: usize> Stage<T, K, 1> {
    /// The root of a stage that has just one.
    #[inline]
    pub fn only(&self) -> [Turn<T>; K] {
        let [root] = self.roots;
        root
    }
}
