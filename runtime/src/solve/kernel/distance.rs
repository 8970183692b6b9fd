//! The elbow: two points a given distance apart, one of them turned about an axis.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{Edge, LaneMeasure, LaneRoots, small};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::JointMask;

/// The range of the distance between a point on one link and a point on the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elbow<T> {
    /// The largest distance.
    pub max: T,
    /// The smallest distance.
    pub min: T,
    /// 1; or -1 for links whose lengths have unlike signs: stretched is where folded would be.
    pub side: T,
}

impl<T: Tolerances> Elbow<T> {
    /// Points at distances `a` and `b` from the axis, `height` apart along it.
    #[inline]
    pub fn new(a: T, b: T, height: T) -> Self {
        let (sum, difference) = (a + b, a - b);
        if height == T::ZERO {
            return Self { max: sum, min: difference.abs(), side: T::ONE };
        }
        let square = height * height;
        Self { max: (sum * sum + square).sqrt(), min: (difference * difference + square).sqrt(), side: T::ONE }
    }

    /// Sets the side by the sign of the product of the links' lengths.
    #[inline]
    pub fn signed(mut self, product: T) -> Self {
        self.side = if product < T::ZERO { -T::ONE } else { T::ONE };
        self
    }
}

/// Solves for the turn `t` from the stretched position (`t = 0`, distance `max`) at which the distance is `rho`. The
/// solution is `t = +-2 atan2(sqrt(max^2 - rho^2), sqrt(rho^2 - min^2))`, the half-angle form of the law of cosines.
/// This form is accurate where the links are stretched and where they are folded, also with links of equal length
/// (`min = 0`).
///
/// Two roots, positive first; one at the ends of the range or outside it, then with the gap to the range.
#[inline(always)]
pub fn distance<T: Tolerances>(
    default: DefaultValue<T>,
    measure: Measure<T>,
    rho: T,
    elbow: Elbow<T>,
) -> Roots<T, 1, 2> {
    let range = elbow.max - elbow.min;
    if default.is_free(range, measure.scale) {
        return Roots::left_free([Turn::ZERO], default, (elbow.max - rho).abs(), measure);
    }
    let mut stage = within(measure, rho, elbow);
    if range < T::DOUBTFUL * measure.scale {
        stage.narrowed(default, measure, range / measure.scale);
    }
    stage
}

#[inline(always)]
fn within<T: Tolerances>(measure: Measure<T>, rho: T, elbow: Elbow<T>) -> Roots<T, 1, 2> {
    let (outer, inner) = (elbow.max - rho, rho - elbow.min);
    // The rounding of the distance itself; roots farther apart are told apart.
    let close = T::EPSILON * T::TWO * elbow.max;
    if !(outer > close && inner > close) {
        return end(measure, outer, inner, elbow.side);
    }
    let (top, bottom) = (outer * (elbow.max + rho), inner * (rho + elbow.min));
    // |(2 sqrt(top bottom), bottom - top)| = top + bottom
    let k = T::ONE / (top + bottom);
    let half_sine = (top * bottom).sqrt() * k;
    let turn = Turn::of((half_sine + half_sine) * elbow.side, (bottom - top) * (k * elbow.side));
    Roots::determined([[turn], [turn.reversed()]], measure, half_sine, JointMask::NONE)
        .closing(half_sine + half_sine >= T::COINCIDENT)
}

/// At the ends of the range or outside it, by how much the distance is inside either end.
#[cold]
#[inline(never)]
fn end<T: Tolerances>(measure: Measure<T>, outer: T, inner: T, side: T) -> Roots<T, 1, 2> {
    let (gap, stretched) = if inner < outer { (-inner, false) } else { (-outer, true) };
    let turn = if stretched == (side > T::ZERO) { Turn::STRETCHED } else { Turn::FOLDED };
    Roots::edge([turn], gap.max(T::ZERO), measure)
}

/// The lane forms of the scalar functions of [`Elbow`].
#[cfg(feature = "batch")]
impl<L: Lanes> Elbow<L> {
    /// One range in every lane.
    #[inline(always)]
    #[must_use]
    pub fn in_lanes(set: L::Set, elbow: Elbow<f64>) -> Self {
        Self { max: L::all(set, elbow.max), min: L::all(set, elbow.min), side: L::all(set, elbow.side) }
    }

    /// Points at distances `a` and `b` from the axis, `height` apart along it.
    #[inline(always)]
    #[must_use]
    pub fn new_lanes(a: L, b: L, height: L) -> Self {
        let (sum, difference) = (a + b, a - b);
        let zero = a.of(0.0);
        let flat = L::both(height.at_most(zero), zero.at_most(height));
        let square = height * height;
        Self {
            max: sum.where_or(flat, (sum * sum + square).sqrt()),
            min: difference.abs().where_or(flat, (difference * difference + square).sqrt()),
            side: a.of(1.0),
        }
    }

    /// Sets the side by the sign of the product of the links' lengths.
    #[inline(always)]
    #[must_use]
    pub fn signed_lanes(mut self, product: L) -> Self {
        self.side = product.of(-1.0).where_or(product.less(product.of(0.0)), product.of(1.0));
        self
    }
}

/// [`distance`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn distance_lanes<L: Lanes>(set: L::Set, measure: LaneMeasure, rho: L, elbow: Elbow<L>) -> LaneRoots<L, 1, 2> {
    let Elbow { max, min, side } = elbow;
    let (outer, inner) = (max - rho, rho - min);
    let close = rho.of(f64::EPSILON * 2.0) * max;
    let edge = L::not(L::both(close.less(outer), close.less(inner)));
    let gap = (-inner).where_or(inner.less(outer), -outer);
    let (top, bottom) = (outer * (max + rho), inner * (rho + min));
    let k = rho.of(1.0) / (top + bottom);
    let half_sine = (top * bottom).sqrt() * k;
    let turn = Turn::of_lanes((half_sine + half_sine) * side, (bottom - top) * (k * side));
    let roots = [[turn], [turn.reversed_lanes()]];
    let mut stage = LaneRoots::within(roots, Edge { at: edge, gap }, small(half_sine, 1.0), measure, set);
    stage.doubt = L::either(stage.doubt, small(max - min, measure.scale));
    stage
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point close to the axis turns through any angle within a narrow range of distances: the joint is nearly free.
    #[test]
    fn a_point_close_to_the_axis_leaves_the_joint_nearly_free() {
        let default = DefaultValue::at(0.0, JointMask::single(2));
        let solved = |a: f64| {
            let t = 0.7_f64;
            let rho = (a * a + 0.25 + a * t.cos()).sqrt();
            distance(default, Measure::length(1.0), rho, Elbow::new(a, 0.5, 0.0))
        };
        assert_eq!(solved(0.3).doubt, None);
        assert!(solved(1e-4).doubt.is_some_and(|doubt| doubt.weak.is_empty()));
        assert_eq!(solved(1e-9).doubt.map(|doubt| doubt.weak), Some(default.joint));
        assert!((solved(1e-9).roots[0][0].value - 0.7).abs() < 1e-6);
        assert_eq!(solved(1e-14).free(), default.joint);
    }

    /// Two links of length 1, stretched but for an angle: the roots close the equation, unless they are one solution.
    #[test]
    fn an_elbow_closes_where_its_roots_are_two_solutions() {
        let default = DefaultValue::at(0.0, JointMask::single(2));
        let closes = |half_angle: f64| {
            let rho = 2.0 * half_angle.cos();
            distance(default, Measure::length(2.0), rho, Elbow::new(1.0, 1.0, 0.0)).doubt.map(|doubt| doubt.closes)
        };
        assert_eq!([0.1, 1e-3, 2e-7, 1e-7].map(closes), [None, Some(true), Some(true), Some(false)]);
    }
}
