//! Sliding joints.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

use super::doubt::Doubt;
#[cfg(feature = "batch")]
use super::lanes::{Edge, LaneMeasure, LaneRoots, small};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::JointMask;

/// Solves for the position `x` of a point on a line at which its distance from another point is `rho`. The line passes
/// that point at distance `across` (not negative), at `middle`. The solution is `x = middle +- sqrt(rho^2 - across^2)`.
///
/// Two roots, the longer position first; one at the nearest approach, then with the gap `across - rho`.
#[inline]
pub fn slide<T: Tolerances>(measure: Measure<T>, rho: T, across: T, middle: T) -> Roots<T, 1, 2> {
    let beyond = rho - across;
    if !(beyond > measure.rounding()) {
        return Roots::edge([Turn::position(middle)], (-beyond).max(T::ZERO), measure);
    }
    let half = (beyond * (rho + across)).sqrt();
    let roots = [[Turn::position(middle + half)], [Turn::position(middle - half)]];
    Roots::determined(roots, measure, half / measure.scale, JointMask::NONE)
}

/// Solves `denominator x = numerator`. One root. With the denominator (dimensionless) vanishing the joint is free.
#[inline]
pub fn slide_to<T: Tolerances>(
    default: DefaultValue<T>,
    measure: Measure<T>,
    denominator: T,
    numerator: T,
) -> Roots<T, 1, 1> {
    if default.is_free(denominator.abs(), T::ONE) {
        let mut stage = Roots::left_free([Turn::ZERO], default, numerator.abs(), measure);
        stage.roots = [[Turn::position(default.value)]];
        return stage;
    }
    let root = [Turn::position(numerator / denominator)];
    Roots::determined([root], measure, denominator.abs(), default.joint)
}

/// Solves `a x^2 + b x + c = 0` (`a` dimensionless, `b` a length, `c` its square) without cancellation. Two roots; one
/// where they meet or where there is none, then with the gap; one if `a` vanishes.
#[inline]
pub fn quadratic<T: Tolerances>(measure: Measure<T>, [a, b, c]: [T; 3]) -> Roots<T, 1, 2> {
    let half = b * T::HALF;
    if !(a.abs() > T::VANISHING) {
        let root = if half == T::ZERO { T::ZERO } else { -c / b };
        return Roots { len: 1, doubt: Some(Doubt::NOTHING), ..Roots::solved([[Turn::position(root)]; 2]) };
    }
    let discriminant = half * half - a * c;
    // Rounding of the discriminant itself; roots farther apart are told apart.
    let close = T::EPSILON * T::TWO * (half * half + (a * c).abs());
    if !(discriminant > close) {
        // The equation is a difference of two squared distances, at its extremum off by `discriminant / a`.
        let gap = (-discriminant).max(T::ZERO) / (a.abs() * measure.scale);
        return Roots::edge([Turn::position(-half / a)], gap, measure);
    }
    let root = discriminant.sqrt();
    let larger = if half < T::ZERO { root - half } else { -half - root };
    let roots = [[Turn::position(larger / a)], [Turn::position(c / larger)]];
    Roots::determined(roots, measure, root / measure.scale, JointMask::NONE)
}

/// [`slide`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn slide_lanes<L: Lanes>(set: L::Set, measure: LaneMeasure, rho: L, across: L, middle: L) -> LaneRoots<L, 1, 2> {
    let beyond = rho - across;
    let edge = L::not(rho.of(f64::ROUNDING * measure.scale).less(beyond));
    let half = (beyond * (rho + across)).sqrt();
    let roots = [[Turn::position_lanes(middle + half)], [Turn::position_lanes(middle - half)]];
    LaneRoots::within(roots, Edge { at: edge, gap: -beyond }, small(half, measure.scale), measure, set)
}

/// [`slide_to`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn slide_to_lanes<L: Lanes>(set: L::Set, denominator: L, numerator: L) -> LaneRoots<L, 1, 1> {
    let root = [Turn::position_lanes(numerator / denominator)];
    LaneRoots::solved([root], small(denominator.abs(), 1.0), set, numerator.of(0.0))
}
