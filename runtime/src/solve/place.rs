//! Where a free joint has to be for a later stage to have roots.

use super::Tolerances;
use super::stage::Level;
use crate::math::{atan2, wrap};

/// A place of a free joint, as a step from its home (in turns or in [`STROKE`]s), and whether the stage has roots there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place<T> {
    pub(super) step: T,
    pub(super) feasible: bool,
}

/// How far inside the range of feasible places the joint goes, as a part of that range: at its ends two roots meet.
const INSIDE: f64 = 0.25;

/// The place of a joint that turns, from the levels at home and a third of a turn either way:
/// `level = a + b cos(x - phi)` is in its range for x in one interval on either side of phi. The place is the one
/// next to `now` (rad from home), inside the interval by a quarter of it, or by `slack` if that is less. Without a
/// feasible place it is the one where the level comes nearest to its range. `None` if the level does not depend on x.
pub(super) fn turning<T: Tolerances>(levels: &[Level<T>; 3], now: T, slack: T) -> Option<Place<T>> {
    let [Level { value: l0, low, high }, Level { value: l1, .. }, Level { value: l2, .. }] = *levels;
    let third = T::from_f64(1.0 / 3.0);
    let a = (l0 + l1 + l2) * third;
    let c = (l0 + l0 - l1 - l2) * third;
    // 1 / sqrt(3)
    let s = (l1 - l2) * T::from_f64(0.577_350_269_189_625_8);
    let b = (c * c + s * s).sqrt();
    if !(b > T::ROUNDING) || !a.is_finite() {
        return None;
    }
    let phase = atan2(s, c);
    let from = wrap(now - phase);
    let (least, most) = ((a - b).max(low), (a + b).min(high));
    let acos = |x: T| {
        let x = x.min(T::ONE).max(-T::ONE);
        atan2(((T::ONE - x) * (T::ONE + x)).sqrt(), x)
    };
    let feasible = least <= most;
    let x = if feasible {
        let (near, far) = (acos((most - a) / b), acos((least - a) / b));
        let inside = ((far - near) * T::from_f64(INSIDE)).min(slack);
        from.abs().max(near + inside).min(far - inside)
    } else if a > high {
        T::PI
    } else {
        T::ZERO
    };
    let x = if from < T::ZERO { -x } else { x };
    Some(Place { step: wrap(phase + x) / T::TAU, feasible: least < most + T::COINCIDENT })
}

/// The same for a joint that slides, from the levels at home and one unit either way: `level = a + b u + c u^2`.
pub(super) fn sliding<T: Tolerances>(levels: &[Level<T>; 3], now: T) -> Option<Place<T>> {
    let [Level { value: l0, low, high }, Level { value: l1, .. }, Level { value: l2, .. }] = *levels;
    let (a, b, c) = (l0, (l1 - l2) * T::HALF, (l1 + l2) * T::HALF - l0);
    if !(b.abs().max(c.abs()) > T::ROUNDING * (T::ONE + a.abs())) {
        return None;
    }
    let curved = c.abs() > T::COINCIDENT * b.abs();
    let vertex = -b / (c + c);
    let extreme = a - b * b / (c * (T::TWO + T::TWO));
    let (least, most) = match curved {
        true if c > T::ZERO => (low.max(extreme), high),
        true => (low, high.min(extreme)),
        false => (low, high),
    };
    if !(least <= most) {
        return Some(Place { step: vertex, feasible: least < most + T::COINCIDENT });
    }
    let at = a + now * (b + now * c);
    let inside = ((most - least) * T::from_f64(INSIDE)).min(T::from_f64(INSIDE));
    let level = at.min(most - inside).max(least + inside);
    if level == at {
        return Some(Place { step: now, feasible: true });
    }
    let step = if curved {
        let off = ((level - extreme) / c).max(T::ZERO).sqrt();
        if now < vertex { vertex - off } else { vertex + off }
    } else {
        (level - a) / b
    };
    Some(Place { step, feasible: true })
}
