//! Braking in whole ticks.

use crate::math::Scalar;

/// Largest step of a joint that has the way `room` left and whose step can shrink by `change` each tick: the joint
/// comes to rest at the end of the way at the latest. 0 without room.
///
/// The steps `x, x - change, x - 2 change, ..` sum to `x (x + change) / (2 change)` or up to `change / 8` more, where `x` is
/// no multiple: the root of that sum.
pub(super) fn brake<T: Scalar>(room: T, change: T) -> T {
    if room <= change || !change.is_finite() {
        return room.max(T::ZERO);
    }
    let half = change * T::HALF;
    let rest = room - change * T::from_f64(0.125);
    (half * half + T::TWO * change * rest).sqrt() - half
}

/// The lesser of [`brake`] and `most`, without the root where `most` is surely the lesser.
///
/// The root is at least `most` where `2 change room >= most (most + change) + change^2 / 4`. The term is `change^2` here: then
/// it holds in no way that is shorter than `change`, which is a step of its own.
pub(super) fn brake_up_to<T: Scalar>(room: T, change: T, most: T) -> T {
    let is_far = || T::TWO * change * room > most * (most + change) + change * change;
    if change.is_finite() && is_far() { most } else { brake(room, change).min(most) }
}

/// The way `room`, in either direction, cut to the step that [`brake`] allows.
pub(super) fn braked<T: Scalar>(room: T, change: T) -> T {
    brake(room.abs(), change).min(room.abs()).copysign(room)
}

/// `x` cut to `[low, high]`, where `low <= high`.
pub(super) fn clamp<T: Scalar>(x: T, low: T, high: T) -> T {
    x.max(low).min(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From every place the joint comes to rest at the end of its way, as fast as it can and not beyond.
    #[test]
    fn the_way_is_not_exceeded() {
        for start in 1..400 {
            let way = f64::from(start) * 0.037;
            let (mut at, mut step, mut ticks) = (0.0, brake(way, 1.0), 0);
            while step > 1e-12 && ticks < 100 {
                at += step;
                assert!(at <= way + 1e-12, "{way}: {at}");
                let next = brake(way - at, 1.0);
                assert!(next >= step - 1.0 - 1e-12, "{way} at {at}: {step} to {next}");
                (step, ticks) = (next, ticks + 1);
            }
            assert!(way - at < 1e-9, "{way}: {at}");
            assert!(f64::from(ticks) < 3.0 + (2.0 * way).sqrt());
        }
    }

    #[test]
    fn a_bound_that_is_less_needs_no_root() {
        for change in [0.3, 1.0, f64::INFINITY] {
            for room in (-4..400).map(|k| f64::from(k) * 0.1) {
                for most in (-10..80).map(|k| f64::from(k) * 0.1).chain([f64::INFINITY]) {
                    assert_eq!(
                        brake_up_to(room, change, most),
                        brake(room, change).min(most),
                        "{room} {change} {most}"
                    );
                }
            }
        }
    }

    #[test]
    fn without_a_bound_the_way_is_one_step() {
        assert_eq!(brake(3.0, f64::INFINITY), 3.0);
        assert_eq!([brake(-1.0, 2.0), brake(0.0, 2.0)], [0.0; 2]);
        assert_eq!([braked(-0.5, 1.0), braked(0.5, 1.0)], [-0.5, 0.5]);
    }
}
