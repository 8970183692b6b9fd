//! Orthogonal axes: two roots that differ by half a turn about the outer axes.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{LaneRoots, small};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};

/// Solves `R_z(a) R_y(b) e_z = m` for `(b, a)`: `b = +-atan2(|(mx, my)|, mz)`, `a = atan2(my, mx)` and half a turn
/// further. With `(mx, my)` vanishing the outer joint `a` is free. `m` is a unit vector within the tolerance for
/// targets; a target that is off by more than rounding is refined at the end.
#[inline]
pub fn flip<T: Tolerances>(default: DefaultValue<T>, m: [T; 3]) -> Roots<T, 2, 2> {
    let [mx, my, mz] = m;
    let rho = (mx * mx + my * my).sqrt();
    if default.is_free(rho, T::ONE) {
        // Order (a, b) so that the free joint comes first, then back.
        let b = if mz < T::ZERO { Turn { value: T::PI, sin: T::ZERO, cos: -T::ONE } } else { Turn::ZERO };
        let mut stage = Roots::<T, 2, 2>::left_free([Turn::ZERO, b], default, T::ZERO, Measure::DIRECTION);
        for [first, second] in &mut stage.roots {
            core::mem::swap(first, second);
        }
        return stage;
    }
    let k = T::ONE / rho;
    let [b, a] = Turn::array([rho, my * k], [mz, mx * k]);
    let roots = [[b, a], [b.reversed(), a.opposite()]];
    Roots::determined(roots, Measure::DIRECTION, rho, default.joint).closing(true)
}

/// Solves `R_z(a) R_y(b) R_z(c) = m` for `(a, b, c)`: `b = +-atan2(|(m13, m23)|, m33)`, `a = atan2(m23, m13)`, and
/// `c` from the second row of `R_z(-a) m`, which is a unit vector whatever `b` is. The second root is half a turn
/// further in `a` and `c`. With `(m13, m23)` vanishing (axes a and c in line) joint `a` is free.
#[inline]
pub fn wrist<T: Tolerances>(default: DefaultValue<T>, m: [[T; 3]; 3]) -> Roots<T, 3, 2> {
    let [[m11, m12, m13], [m21, m22, m23], [_, _, m33]] = m;
    let square = m13 * m13 + m23 * m23;
    let rho = square.sqrt();
    if default.is_free(rho, T::ONE) {
        // Made anew, so that an ordinary target does not store it.
        return in_line(default, [m11, m12, m21, m22, m33]);
    }
    // The root and the division, both slow, at the same time; and what is scaled meanwhile.
    let k = rho * (T::ONE / square);
    let (sin_c, cos_c) = (m13 * m21 - m23 * m11, m13 * m22 - m23 * m12);
    // The last one only fills the vector unit's lanes.
    let [a, b, c, _] = Turn::array([m23 * k, rho, sin_c * k, T::ZERO], [m13 * k, m33, cos_c * k, T::ONE]);
    let roots = [[a, b, c], [a.opposite(), b.reversed(), c.opposite()]];
    Roots::determined(roots, Measure::DIRECTION, rho, default.joint).closing(true)
}

#[cold]
#[inline(never)]
fn in_line<T: Tolerances>(default: DefaultValue<T>, [m11, m12, m21, m22, m33]: [T; 5]) -> Roots<T, 3, 2> {
    let Turn { sin, cos, .. } = Turn::at(default.value);
    let b = if m33 < T::ZERO { Turn { value: T::PI, sin: T::ZERO, cos: -T::ONE } } else { Turn::ZERO };
    let c = Turn::towards(cos * m21 - sin * m11, cos * m22 - sin * m12);
    Roots::left_free([Turn::ZERO, b, c], default, T::ZERO, Measure::DIRECTION)
}

/// [`flip`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn flip_lanes<L: Lanes>(set: L::Set, m: [L; 3]) -> LaneRoots<L, 2, 2> {
    let [mx, my, mz] = m;
    let rho = (mx * mx + my * my).sqrt();
    let k = rho.of(1.0) / rho;
    let (b, a) = (Turn::of_lanes(rho, mz), Turn::of_lanes(my * k, mx * k));
    let roots = [[b, a], [b.reversed_lanes(), a.opposite_lanes()]];
    LaneRoots::solved(roots, small(rho, 1.0), set, rho.of(0.0))
}

/// [`wrist`] over lanes.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn wrist_lanes<L: Lanes>(set: L::Set, m: [[L; 3]; 3]) -> LaneRoots<L, 3, 2> {
    let [[m11, m12, m13], [m21, m22, m23], [_, _, m33]] = m;
    let square = m13 * m13 + m23 * m23;
    let rho = square.sqrt();
    let k = rho * (rho.of(1.0) / square);
    let (sin_c, cos_c) = (m13 * m21 - m23 * m11, m13 * m22 - m23 * m12);
    let (a, b, c) = (Turn::of_lanes(m23 * k, m13 * k), Turn::of_lanes(rho, m33), Turn::of_lanes(sin_c * k, cos_c * k));
    let roots = [[a, b, c], [a.opposite_lanes(), b.reversed_lanes(), c.opposite_lanes()]];
    LaneRoots::solved(roots, small(rho, 1.0), set, rho.of(0.0))
}
