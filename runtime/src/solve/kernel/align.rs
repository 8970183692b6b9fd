//! Turn one plane vector onto another.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{LaneMeasure, LaneRoots, SURE};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};

/// The turn that takes the direction of `from` to that of `to`: `atan2(from x to, from . to)`. One root. With either
/// vector vanishing the joint is free.
#[inline]
pub fn align<T: Tolerances>(default: DefaultValue<T>, measure: Measure<T>, from: [T; 2], to: [T; 2]) -> Roots<T, 1, 1> {
    let ([ux, uy], [vx, vy]) = (from, to);
    let (u2, v2) = (ux * ux + uy * uy, vx * vx + vy * vy);
    let (cross, dot) = (ux * vy - uy * vx, ux * vx + uy * vy);
    let doubtful = T::DOUBTFUL * measure.scale;
    if !(u2 >= doubtful * doubtful && v2 >= doubtful * doubtful) {
        return short(default, measure, from, to);
    }
    // |(cross, dot)| = |from| |to|. The root and the division, both slow, at the same time.
    let square = u2 * v2;
    let k = square.sqrt() * (T::ONE / square);
    Roots::solved([[Turn::of(cross * k, dot * k)]])
}

/// Solves [`align`] where one of the vectors is short. Both vectors have one length. Where a stage before is at the
/// edge of its range, one of the vectors has the sine of the edge root alone. With that sine the vector has the
/// direction of the limit on its branch.
#[cold]
#[inline(never)]
fn short<T: Tolerances>(default: DefaultValue<T>, measure: Measure<T>, from: [T; 2], to: [T; 2]) -> Roots<T, 1, 1> {
    let [u, v] = [from, to].map(|[x, y]| x.abs().max(y.abs()));
    let vanishing = default.free_below() * measure.scale;
    // What a later stage sees of an edge root's sine; rounding leaves more of a vector that vanishes by itself.
    let limit = u.min(v) > T::ZERO && u.min(v) <= T::LEAST_SINE * T::TWO * measure.scale;
    if !(u.min(v) > vanishing || limit && u.max(v) > vanishing) {
        return Roots::left_free([Turn::ZERO], default, T::ZERO, measure);
    }
    // Scaled first, so that no square vanishes.
    let ([ux, uy], [vx, vy]) = (from.map(|e| e / u), to.map(|e| e / v));
    let lengths = [u * (ux * ux + uy * uy).sqrt(), v * (vx * vx + vy * vy).sqrt()];
    let turn = Turn::towards(ux * vy - uy * vx, ux * vx + uy * vy);
    let amplitude = (u.min(v) / measure.scale).max(T::VANISHING);
    // The stages before have given both vectors one length, or miss by the difference.
    let closes = (lengths[0] - lengths[1]).abs() <= measure.rounding();
    Roots::solved([[turn]]).of_amplitude(measure, amplitude, default.joint).closing(closes)
}

/// [`align`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn align_lanes<L: Lanes>(set: L::Set, measure: LaneMeasure, from: [L; 2], to: [L; 2]) -> LaneRoots<L, 1, 1> {
    let ([ux, uy], [vx, vy]) = (from, to);
    let (u2, v2) = (ux * ux + uy * uy, vx * vx + vy * vy);
    let (cross, dot) = (ux * vy - uy * vx, ux * vx + uy * vy);
    let least = ux.of(SURE * measure.scale * (SURE * measure.scale));
    let doubt = L::not(L::both(least.at_most(u2), least.at_most(v2)));
    let square = u2 * v2;
    let k = square.sqrt() * (ux.of(1.0) / square);
    LaneRoots::solved([[Turn::of_lanes(cross * k, dot * k)]], doubt, set, ux.of(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointMask;

    /// Short vectors of one length close the equation. Those of two lengths miss it by the difference.
    #[test]
    fn short_vectors_close_if_they_have_one_length() {
        let default = DefaultValue::at(0.0, JointMask::single(1));
        let closes = |length: f64| {
            let (sin, cos) = 0.8_f64.sin_cos();
            let stage = align(default, Measure::DIRECTION, [1e-4, 0.0], [length * cos, length * sin]);
            assert!((stage.roots[0][0].value - 0.8).abs() < 1e-12);
            stage.doubt.map(|doubt| doubt.closes)
        };
        assert_eq!([1e-4, 1e-4 + 1e-15, 1e-4 + 1e-13].map(closes), [Some(true), Some(true), Some(false)]);
    }
}
