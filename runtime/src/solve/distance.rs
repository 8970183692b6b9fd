//! The elbow: two points a given distance apart, one of them turned about an axis.

use super::tolerances::Tolerances;
use super::{Home, Measure, Stage, Turn};

/// The range of the distance between a point on one link and a point on the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elbow<T> {
    /// The largest distance.
    pub max: T,
    /// The smallest distance.
    pub min: T,
}

impl<T: Tolerances> Elbow<T> {
    /// Points at distances `a` and `b` from the axis, `height` apart along it.
    #[inline]
    pub fn new(a: T, b: T, height: T) -> Self {
        let (sum, difference) = (a + b, a - b);
        if height == T::ZERO {
            return Self { max: sum, min: difference.abs() };
        }
        Self { max: (sum * sum + height * height).sqrt(), min: (difference * difference + height * height).sqrt() }
    }
}

/// Solves for the turn `t` from the stretched position (`t = 0`, distance `max`) at which the distance is `rho`:
/// `t = +-2 atan2(sqrt(max^2 - rho^2), sqrt(rho^2 - min^2))`, the half-angle form of the law of cosines. It is
/// accurate where the links are stretched and where they are folded, also with links of equal length (`min = 0`).
///
/// Two roots, positive first; one at the ends of the range or outside it, then with the gap to the range.
#[inline]
pub fn distance<T: Tolerances>(home: Home<T>, measure: Measure<T>, rho: T, elbow: Elbow<T>) -> Stage<T, 1, 2> {
    let (outer, inner) = (elbow.max - rho, rho - elbow.min);
    // The rounding of the distance itself; roots farther apart are told apart.
    let close = T::EPSILON * T::TWO * elbow.max;
    if elbow.max - elbow.min <= measure.vanishing() {
        return Stage::free([Turn::ZERO], home, outer.abs(), measure);
    }
    if !(outer > close) {
        return Stage::edge([Turn::ZERO], (-outer).max(T::ZERO), measure);
    }
    if !(inner > close) {
        return Stage::edge([Turn { value: T::PI, sin: T::ZERO, cos: -T::ONE }], (-inner).max(T::ZERO), measure);
    }
    let (top, bottom) = (outer * (elbow.max + rho), inner * (rho + elbow.min));
    // |(2 sqrt(top bottom), bottom - top)| = top + bottom
    let k = T::ONE / (top + bottom);
    let half_sine = (top * bottom).sqrt() * k;
    let turn = Turn::of(half_sine + half_sine, (bottom - top) * k);
    Stage::solved([[turn], [turn.reversed()]], measure).with_amplitude(half_sine)
}
