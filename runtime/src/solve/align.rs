//! Turn one plane vector onto another.

use super::tolerances::Tolerances;
use super::{Home, Measure, Stage, Turn};

/// The turn that takes the direction of `from` to that of `to`: `atan2(from x to, from . to)`. One root. With either
/// vector vanishing the joint is free.
#[inline]
pub fn align<T: Tolerances>(home: Home<T>, measure: Measure<T>, from: [T; 2], to: [T; 2]) -> Stage<T, 1, 1> {
    let ([ux, uy], [vx, vy]) = (from, to);
    let smaller = (ux * ux + uy * uy).min(vx * vx + vy * vy);
    let vanishing = measure.vanishing();
    if !(smaller > vanishing * vanishing) {
        return Stage::free([Turn::ZERO], home, T::ZERO, measure);
    }
    let turn = Turn::towards(ux * vy - uy * vx, ux * vx + uy * vy);
    let doubtful = T::DOUBTFUL * measure.scale;
    let stage = Stage::solved([[turn]], measure);
    if smaller < doubtful * doubtful { stage.with_weak(home, smaller.sqrt() / measure.scale) } else { stage }
}
