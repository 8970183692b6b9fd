//! Stages of several poses at once: what the lane forms of the kernels share.
//!
//! A kernel has a lane form beside it where plans need one. The two are not one function: a kernel decides by branches
//! between an ordinary equation, an edge and a free joint, and returns what the search needs of each. Lanes all take the
//! ordinary path. A lane whose equation has an edge ends or is in doubt, a lane with a small amplitude is in doubt, and
//! the whole target of a lane in doubt goes to the scalar inverse. On the ordinary path the operations are those of the
//! kernel, so that the bits are the same.

use denhart_core::lanes::Lanes;

use super::tolerances::Tolerances;
use super::turn::Turn;
use crate::math::lanes::{angle, wrap};

/// An amplitude from which on a lane is ordinary. A little above [`Tolerances::DOUBTFUL`]: a lane may compare other
/// terms than the kernel does, and must not take for ordinary what rounding takes across.
pub(super) const SURE: f64 = f64::DOUBTFUL * (1.0 + 1e-9);

/// The unit of an equation over lanes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaneMeasure {
    /// Reach of the arm for lengths, 1 for directions.
    pub scale: f64,
    /// A branch that misses its equation by more ends there.
    pub tolerance: f64,
}

impl LaneMeasure {
    /// Quantities of this size. `tolerance`: the residual up to which a solution is listed; at least rounding.
    #[inline]
    #[must_use]
    pub fn new(scale: f64, tolerance: f64) -> Self {
        Self { scale, tolerance: tolerance.max(f64::ROUNDING * scale) }
    }
}

/// The roots of one equation for `K` joints, `R` of them, in every lane.
#[derive(Debug)]
pub struct LaneRoots<L: Lanes, const K: usize, const R: usize> {
    /// The roots; in a lane that has ended or is in doubt they are some numbers.
    pub roots: [[Turn<L>; K]; R],
    /// Lanes that have each root.
    pub present: [L::Mask; R],
    /// Lanes that miss the equation by more than the tolerance.
    pub ended: L::Mask,
    /// Gap of the lanes that have ended.
    pub gap: L,
    /// Lanes whose equation is not ordinary.
    pub doubt: L::Mask,
}

/// Lanes at an edge of their equation's range, and by how much they are beyond.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge<L: Lanes> {
    pub(super) at: L::Mask,
    pub(super) gap: L,
}

impl<L: Lanes, const K: usize, const R: usize> LaneRoots<L, K, R> {
    /// Roots of an equation that always has them.
    #[inline(always)]
    pub(super) fn solved(roots: [[Turn<L>; K]; R], doubt: L::Mask, set: L::Set, zero: L) -> Self {
        let none = L::mask(set, false);
        Self { roots, present: [L::mask(set, true); R], ended: none, gap: zero, doubt }
    }

    /// Roots of an equation with edges. `weak`: lanes with a small amplitude.
    #[inline(always)]
    pub(super) fn within(
        roots: [[Turn<L>; K]; R],
        edge: Edge<L>,
        weak: L::Mask,
        measure: LaneMeasure,
        set: L::Set,
    ) -> Self {
        let beyond = edge.gap.of(measure.tolerance).less(edge.gap);
        let ended = L::both(edge.at, beyond);
        let doubt = L::either(L::both(edge.at, L::not(beyond)), L::both(weak, L::not(edge.at)));
        Self { roots, present: [L::mask(set, true); R], ended, gap: edge.gap, doubt }
    }

    /// A root; the first one beyond the last.
    #[inline(always)]
    #[must_use]
    pub fn root(&self, index: usize) -> [Turn<L>; K] {
        let zero = self.gap.of(0.0);
        self.roots.get(index).copied().unwrap_or([Turn { value: zero, sin: zero, cos: zero }; K])
    }

    /// The lanes of a mask that have a root.
    #[inline(always)]
    pub fn on(&self, state: L::Mask, index: usize) -> L::Mask {
        self.present.get(index).map_or(state, |present| L::both(state, *present))
    }

    /// The roots turned by a further half turn (first joint) where `product` is negative.
    #[inline(always)]
    #[must_use]
    pub fn turned_back(mut self, product: L) -> Self {
        let reverse = product.less(product.of(0.0));
        for root in &mut self.roots {
            if let Some(first) = root.first_mut() {
                let Turn { value, sin, cos } = first.opposite_lanes();
                *first = Turn {
                    value: value.where_or(reverse, first.value),
                    sin: sin.where_or(reverse, first.sin),
                    cos: cos.where_or(reverse, first.cos),
                };
            }
        }
        self
    }

    /// The roots turned by a further angle (first joint).
    #[inline(always)]
    #[must_use]
    pub fn about(mut self, phase: Turn<L>) -> Self {
        for root in &mut self.roots {
            if let Some(first) = root.first_mut() {
                // Two angles of (-pi, pi] are within three half turns.
                let (value, _) = wrap(first.value + phase.value);
                *first = Turn {
                    value,
                    sin: first.sin * phase.cos + first.cos * phase.sin,
                    cos: first.cos * phase.cos - first.sin * phase.sin,
                };
            }
        }
        self
    }
}

/// Lanes whose amplitude, for quantities of size `scale`, is small or no number.
#[inline(always)]
pub(super) fn small<L: Lanes>(amplitude: L, scale: f64) -> L::Mask {
    L::not(amplitude.of(SURE * scale).at_most(amplitude))
}

/// As [`small`], with the amplitude a share of another number.
#[inline(always)]
pub(super) fn small_beside<L: Lanes>(amplitude: L, whole: L) -> L::Mask {
    L::not((whole.of(SURE) * whole).at_most(amplitude))
}

#[inline(always)]
fn in_range<L: Lanes>(angle: L) -> L {
    let least = angle.of(f64::EPSILON * 2.0 - core::f64::consts::PI);
    angle.where_or(least.less(angle), least)
}

/// The lane forms of the scalar functions of [`Turn`].
impl<L: Lanes> Turn<L> {
    /// From a sine and cosine, `sin^2 + cos^2 = 1`.
    #[inline(always)]
    pub(super) fn of_lanes(sin: L, cos: L) -> Self {
        Self { value: in_range(angle(sin, cos)), sin, cos }
    }

    /// Position of a sliding joint.
    #[inline(always)]
    pub(super) fn position_lanes(value: L) -> Self {
        Self { value, sin: value.of(0.0), cos: value.of(1.0) }
    }

    /// The opposite turn.
    #[inline(always)]
    pub(super) fn reversed_lanes(self) -> Self {
        Self { value: in_range(-self.value), sin: -self.sin, cos: self.cos }
    }

    /// Half a turn further.
    #[inline(always)]
    pub(super) fn opposite_lanes(self) -> Self {
        let (pi, zero) = (self.value.of(core::f64::consts::PI), self.value.of(0.0));
        let value = self.value + pi.copysign(zero - self.value);
        Self { value: in_range(value), sin: -self.sin, cos: -self.cos }
    }

    /// From any vector in the plane, and where it is too short or too long to have a direction: in doubt.
    #[inline(always)]
    #[must_use]
    pub fn direction_lanes(y: L, x: L) -> (Self, L::Mask) {
        let square = x * x + y * y;
        let ordinary = L::both(x.of(0.0).less(square), square.at_most(x.of(f64::MAX)));
        let k = x.of(1.0) / square.sqrt();
        (Self::of_lanes(y * k, x * k), L::not(ordinary))
    }
}
