//! The branches of the targets in the lanes: what the scalar search is for one target.

use denhart_core::lanes::Lanes;

use super::ordinary;
use crate::Pose;
use crate::math::lanes::{atan2, wrap};
use crate::solve::{LaneMeasure, LaneRoots, Turn};

/// Solutions of several targets at once, at most `S` each, of an arm with `N` joints.
pub struct Branches<L: Lanes, const N: usize, const S: usize> {
    set: L::Set,
    /// Joint values of each place, and the lanes that have a solution there.
    q: [[L; N]; S],
    exists: [u32; S],
    len: usize,
    /// Lanes that are left to the scalar inverse.
    doubt: L::Mask,
    /// The least gap of a branch that has ended; negative where none has.
    least: L,
}

impl<L: Lanes, const N: usize, const S: usize> Branches<L, N, S> {
    /// No branch yet.
    #[inline(always)]
    pub fn new(set: L::Set) -> Self {
        Self {
            set,
            q: [[L::all(set, 0.0); N]; S],
            exists: [0; S],
            len: 0,
            doubt: L::mask(set, false),
            least: L::all(set, -1.0),
        }
    }

    /// Begins anew. Lanes whose target is ordinary; the others are in doubt.
    #[inline(always)]
    pub fn begins(&mut self, target: &Pose<L>, reach: f64) -> L::Mask {
        self.len = 0;
        self.least = L::all(self.set, -1.0);
        let ordinary = ordinary(target, L::all(self.set, 0.0), reach);
        self.doubt = L::not(ordinary);
        ordinary
    }

    /// No solution, and every lane in doubt.
    #[inline(always)]
    pub(super) fn leave(&mut self) {
        self.len = 0;
        self.least = L::all(self.set, -1.0);
        self.doubt = L::mask(self.set, true);
    }

    /// Returns true if a lane of the mask is not in doubt.
    #[inline(always)]
    pub fn go_on(&self, state: L::Mask) -> bool {
        L::bits(L::both(state, L::not(self.doubt))) != 0
    }

    /// The lanes that go on after a stage.
    #[inline(always)]
    pub fn follow<const K: usize, const R: usize>(&mut self, state: L::Mask, stage: &LaneRoots<L, K, R>) -> L::Mask {
        self.doubts(state, stage.doubt);
        let ended = L::both(state, stage.ended);
        let less = L::either(self.least.less(self.least.of(0.0)), stage.gap.less(self.least));
        self.least = stage.gap.where_or(L::both(ended, less), self.least);
        L::both(state, L::not(L::either(stage.ended, stage.doubt)))
    }

    /// The angle of the vector (`x`, `y`), rad.
    #[inline(always)]
    pub fn angle(&mut self, state: L::Mask, y: L, x: L) -> L {
        let (angle, unusual) = atan2(y, x);
        self.doubts(state, unusual);
        angle
    }

    /// An angle in (-pi, pi], rad.
    #[inline(always)]
    pub fn wrap(&mut self, state: L::Mask, angle: L) -> L {
        let (wrapped, far) = wrap(angle);
        self.doubts(state, far);
        wrapped
    }

    /// The direction of a vector.
    #[inline(always)]
    pub fn direction(&mut self, state: L::Mask, y: L, x: L) -> Turn<L> {
        let (turn, unusual) = Turn::direction_lanes(y, x);
        self.doubts(state, unusual);
        turn
    }

    /// The lanes in which equations without a joint to meet them hold to rounding.
    #[inline(always)]
    pub fn agree<const K: usize>(&mut self, state: L::Mask, measure: LaneMeasure, misses: [L; K]) -> L::Mask {
        let rounding = LaneMeasure::new(measure.scale, 0.0).tolerance;
        let mut agreed = state;
        for miss in misses {
            agreed = L::both(agreed, miss.abs().at_most(miss.of(rounding)));
        }
        self.doubts(state, L::not(agreed));
        agreed
    }

    /// Adds a solution of the lanes of the mask.
    #[inline(always)]
    pub fn push(&mut self, state: L::Mask, q: [L; N]) {
        match (self.q.get_mut(self.len), self.exists.get_mut(self.len)) {
            (Some(place), Some(exists)) => {
                *place = q;
                *exists = L::bits(state);
                self.len += 1;
            }
            _ => self.doubts(state, state),
        }
    }

    #[inline(always)]
    fn doubts(&mut self, state: L::Mask, unsure: L::Mask) {
        self.doubt = L::either(self.doubt, L::both(state, unsure));
    }

    /// The places in use: joint values, and the lanes that have them.
    #[inline(always)]
    pub(super) fn places(&self) -> impl Iterator<Item = (&[L; N], u32)> {
        self.q.iter().zip(self.exists).take(self.len)
    }

    /// Lanes in doubt.
    #[inline(always)]
    pub(super) fn doubt(&self) -> u32 {
        L::bits(self.doubt)
    }

    /// The least gap of a branch that has ended.
    #[inline(always)]
    pub(super) fn least(&self) -> L {
        self.least
    }
}
