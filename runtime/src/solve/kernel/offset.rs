//! One trigonometric equation: a point turned about an axis keeps a given offset.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{Edge, LaneMeasure, LaneRoots, small, small_beside};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::JointMask;

/// Solves `a cos(t) + b sin(t) = d` for `t`: `t = atan2(b, a) +- atan2(sqrt(r^2 - d^2), d)`, `r = |(a, b)|`.
///
/// Two roots, in this order; one where they meet (`|d| = r`) or where the equation has no solution, then with the gap
/// `|d| - r`. With `r` vanishing the joint is free.
#[inline]
pub fn offset<T: Tolerances>(default: DefaultValue<T>, measure: Measure<T>, a: T, b: T, d: T) -> Roots<T, 1, 2> {
    let r2 = a * a + b * b;
    let r = r2.sqrt();
    if default.is_free(r, measure.scale) {
        return Roots::left_free([Turn::ZERO], default, d.abs(), measure);
    }
    let h2 = (r - d) * (r + d);
    // The rounding of h2 itself; roots farther apart are told apart.
    if !(h2 > T::EPSILON * (T::TWO + T::TWO) * r2) {
        let side = if d < T::ZERO { -T::ONE / r } else { T::ONE / r };
        return Roots::edge([Turn::of(b * side, a * side)], (d.abs() - r).max(T::ZERO), measure);
    }
    let h = h2.sqrt();
    let k = T::ONE / r2;
    let sines = [(b * d + a * h) * k, (b * d - a * h) * k];
    let cosines = [(a * d - b * h) * k, (a * d + b * h) * k];
    let roots = Turn::array(sines, cosines).map(|turn| [turn]);
    let stage = Roots::solved(roots);
    let (sine, share) = (h / r, r / measure.scale);
    let doubt = sine < T::DOUBTFUL || share < T::DOUBTFUL;
    let stage = if doubt { stage.of_amplitude(measure, sine.min(share), JointMask::NONE) } else { stage };
    stage.closing(sine >= T::COINCIDENT)
}

/// [`offset`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn offset_lanes<L: Lanes>(set: L::Set, measure: LaneMeasure, a: L, b: L, d: L) -> LaneRoots<L, 1, 2> {
    let Circle { r, h, edge, roots } = circle(a, b, d);
    let gap = d.abs() - r;
    let short = small(r, measure.scale);
    let mut stage = LaneRoots::within(roots, Edge { at: edge, gap }, small_beside(h, r), measure, set);
    stage.doubt = L::either(stage.doubt, short);
    stage
}

/// A circle and the line that it meets.
#[cfg(feature = "batch")]
pub(super) struct Circle<L: Lanes> {
    /// Radius.
    pub(super) r: L,
    /// Half the chord.
    pub(super) h: L,
    /// Lanes in which they touch at most.
    pub(super) edge: L::Mask,
    pub(super) roots: [[Turn<L>; 1]; 2],
}

/// Where `a cos(t) + b sin(t) = d`.
#[cfg(feature = "batch")]
#[inline(always)]
pub(super) fn circle<L: Lanes>(a: L, b: L, d: L) -> Circle<L> {
    let r2 = a * a + b * b;
    let r = r2.sqrt();
    let h2 = (r - d) * (r + d);
    let edge = L::not((a.of(f64::EPSILON * 4.0) * r2).less(h2));
    let h = h2.sqrt();
    let k = a.of(1.0) / r2;
    let first = Turn::of_lanes((b * d + a * h) * k, (a * d - b * h) * k);
    let second = Turn::of_lanes((b * d - a * h) * k, (a * d + b * h) * k);
    Circle { r, h, edge, roots: [[first], [second]] }
}
