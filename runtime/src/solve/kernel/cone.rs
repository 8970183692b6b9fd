//! A direction or point, turned about one axis, with a given component along another.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{Edge, LaneMeasure, LaneRoots, small};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::JointMask;

/// The range of that component. The vector's length is fixed, so each end also has a component across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone<T> {
    /// Largest component along the other axis, and the (signed) component across it there.
    pub max: [T; 2],
    /// Smallest component along the other axis, and the (signed) component across it there.
    pub min: [T; 2],
}

impl<T: Tolerances> Cone<T> {
    /// A vector with component `along` the turning axis and `across` (not negative) it. The other axis has cosine `cos`
    /// and sine `sin` (not negative) to the turning axis.
    #[inline]
    pub fn new(along: T, across: T, cos: T, sin: T) -> Self {
        Self {
            max: [along * cos + across * sin, across * cos - along * sin],
            min: [along * cos - across * sin, across * cos + along * sin],
        }
    }
}

/// Solves for the turn `t` from the position nearest the other axis at which the component along that axis is `d`. The
/// component across that axis is `rho` (not negative, `d^2 + rho^2` the squared length). The solution is
/// `t = +-2 atan2(sqrt(max - d), sqrt(d - min))`. Where `d` is near the length, `max - d` is taken from `rho`, which is
/// accurate there.
///
/// Two roots, positive first; one at the ends of the range or outside it, then with the gap to the range.
#[inline]
pub fn cone<T: Tolerances>(
    default: DefaultValue<T>,
    measure: Measure<T>,
    d: T,
    rho: T,
    cone: Cone<T>,
) -> Roots<T, 1, 2> {
    let ([max, max_across], [min, _]) = (cone.max, cone.min);
    let range = max - min;
    if default.is_free(range, measure.scale) {
        return Roots::left_free([Turn::ZERO], default, gap(d, rho, max, max_across), measure);
    }
    let mut stage = within(measure, d, rho, cone);
    if range < T::DOUBTFUL * measure.scale {
        stage.narrowed(default, measure, range / measure.scale);
    }
    stage
}

#[inline]
fn within<T: Tolerances>(measure: Measure<T>, d: T, rho: T, cone: Cone<T>) -> Roots<T, 1, 2> {
    let ([max, max_across], [min, min_across]) = (cone.max, cone.min);
    let below = |end: T, across: T| {
        // end - d, by the form that cancels less: the components along, or (where both are the larger) those across.
        if end * d > T::ZERO && (d + end).abs() > rho + across.abs() {
            (rho - across) * (rho + across) / (d + end)
        } else {
            end - d
        }
    };
    let (top, bottom) = (below(max, max_across), -below(min, min_across));
    // The rounding of the component itself; roots farther apart are told apart.
    let close = T::EPSILON * (T::TWO + T::TWO) * measure.scale;
    let touches = |end: T, across: T| (end - d).abs() <= close && (rho - across.abs()).abs() <= close;
    if !(top > T::ZERO) || touches(max, max_across) {
        return Roots::edge([Turn::STRETCHED], gap(d, rho, max, max_across), measure);
    }
    if !(bottom > T::ZERO) || touches(min, min_across) {
        return Roots::edge([Turn::FOLDED], gap(d, rho, min, min_across), measure);
    }
    // |(2 sqrt(top bottom), bottom - top)| = top + bottom
    let k = T::ONE / (top + bottom);
    let half_sine = (top * bottom).sqrt() * k;
    let turn = Turn::of(half_sine + half_sine, (bottom - top) * k);
    Roots::determined([[turn], [turn.reversed()]], measure, half_sine, JointMask::NONE)
        .closing(half_sine + half_sine >= T::COINCIDENT)
}

/// The angle (times length, for points) between `(d, rho)` and an end of the range, zero within rounding.
#[inline]
fn gap<T: Tolerances>(d: T, rho: T, end: T, across: T) -> T {
    let length = (d * d + rho * rho).sqrt();
    if length > T::ZERO { (rho * end - d * across.abs()).abs() / length } else { T::ZERO }
}

/// The lane form of the scalar function of [`Cone`].
#[cfg(feature = "batch")]
impl<L: Lanes> Cone<L> {
    /// One range in every lane.
    #[inline(always)]
    #[must_use]
    pub fn in_lanes(set: L::Set, cone: Cone<f64>) -> Self {
        let ([a, b], [c, d]) = (cone.max, cone.min);
        Self { max: [L::all(set, a), L::all(set, b)], min: [L::all(set, c), L::all(set, d)] }
    }

    /// A vector with component `along` the turning axis and `across` it, and the angle to the other axis.
    #[inline(always)]
    #[must_use]
    pub fn new_lanes(along: L, across: L, cos: L, sin: L) -> Self {
        Self {
            max: [along * cos + across * sin, across * cos - along * sin],
            min: [along * cos - across * sin, across * cos + along * sin],
        }
    }
}

/// [`cone()`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn cone_lanes<L: Lanes>(set: L::Set, measure: LaneMeasure, d: L, rho: L, cone: Cone<L>) -> LaneRoots<L, 1, 2> {
    let ([max, max_across], [min, min_across]) = (cone.max, cone.min);
    let zero = d.of(0.0);
    let below = |end: L, across: L| {
        let along = L::both(zero.less(end * d), (rho + across.abs()).less((d + end).abs()));
        ((rho - across) * (rho + across) / (d + end)).where_or(along, end - d)
    };
    let (top, bottom) = (below(max, max_across), -below(min, min_across));
    let close = d.of(f64::EPSILON * 4.0 * measure.scale);
    let touches =
        |end: L, across: L| L::both((end - d).abs().at_most(close), (rho - across.abs()).abs().at_most(close));
    let stretched = L::either(L::not(zero.less(top)), touches(max, max_across));
    let folded = L::either(L::not(zero.less(bottom)), touches(min, min_across));
    let length = (d * d + rho * rho).sqrt();
    let gap = |end: L, across: L| ((rho * end - d * across.abs()).abs() / length).where_or(zero.less(length), zero);
    let gap = gap(max, max_across).where_or(stretched, gap(min, min_across));
    let k = d.of(1.0) / (top + bottom);
    let half_sine = (top * bottom).sqrt() * k;
    let turn = Turn::of_lanes(half_sine + half_sine, (bottom - top) * k);
    let roots = [[turn], [turn.reversed_lanes()]];
    let edge = Edge { at: L::either(stretched, folded), gap };
    let mut stage = LaneRoots::within(roots, edge, small(half_sine, 1.0), measure, set);
    stage.doubt = L::either(stage.doubt, small(max - min, measure.scale));
    stage
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A short vector across the turning axis, next to a long one along it: the angle is as accurate as the component.
    #[test]
    fn a_small_component_of_a_long_vector() {
        let default = DefaultValue::at(0.0, JointMask::single(0));
        for t in [0.3, 1.2, 1.57, 2.0, 3.0_f64] {
            let (along, across) = (-0.8, 4e-8);
            let d = across * t.cos();
            let rho = (along * along + (across * t.sin()).powi(2)).sqrt();
            let stage = cone(default, Measure::length(1.0), d, rho, Cone::new(along, across, 0.0, 1.0));
            assert!((stage.roots[0][0].value - t).abs() < 1e-12, "{t}: {:?}", stage.roots);
        }
    }
}
