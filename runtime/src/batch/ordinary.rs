//! Ordinary targets.

use denhart_core::lanes::Lanes;

use crate::Pose;
use crate::solve::Tolerances;

/// A target farther away than this many times the reach of the arm is not ordinary: the rounding of its coordinates
/// alone can exceed what closes.
pub const FAR: f64 = 10.0;

/// Lanes whose rotation is one to rounding, and whose point is not far away. `strokes`: the given values of slides, as
/// a sum of lengths. What is not a number is not ordinary.
#[inline(always)]
pub fn ordinary<L: Lanes>(pose: &Pose<L>, strokes: L, reach: f64) -> L::Mask {
    let [[a, d, g], [b, e, h], [c, f, i]] = pose.rotation;
    let [x, y, z] = pose.translation;
    let (half, one) = (x.of(0.5), x.of(1.0));
    let unit_x = half * (a * a + b * b + c * c - one);
    let unit_y = half * (d * d + e * e + f * f - one);
    let right = a * d + b * e + c * f;
    let [u, v, w] = [b * f - c * e - g, c * d - a * f - h, a * e - b * d - i];
    let squares = unit_x * unit_x + unit_y * unit_y + right * right;
    let square = squares + u * u + v * v + w * w;
    let size = x.abs() + y.abs() + z.abs() + strokes;
    L::both(square.at_most(x.of(f64::ROUNDING * f64::ROUNDING)), size.at_most(x.of(reach * FAR)))
}
