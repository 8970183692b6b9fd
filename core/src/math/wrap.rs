//! Angles brought into (-pi, pi].

use super::Scalar;

/// Up to this magnitude, three half turns, one turn more or less is enough.
pub(in crate::math) const NEAR: f64 = 9.42;

/// The angle of (-pi, pi] that differs from `angle` (rad) by whole turns; not a number for one that is not finite.
///
/// Within three half turns it is one exact addition or subtraction of `TAU`. Beyond, the turns are those of the real
/// number 2 pi: at most 1 ulp of pi off for every finite angle. The result is never `-PI` itself.
#[inline]
pub fn wrap<T: Scalar>(angle: T) -> T {
    if angle.abs() <= T::from_f64(NEAR) {
        // No branch: which it is depends on the target.
        angle - (T::TAU.when(angle > T::PI) - T::TAU.when(angle <= -T::PI))
    } else {
        turns(angle)
    }
}

#[cold]
#[inline(never)]
fn turns<T: Scalar>(angle: T) -> T {
    if !angle.is_finite() {
        return T::NAN;
    }
    let (hi, lo, quarters) = angle.reduce();
    let half_pi_lo = T::PI_LO * T::HALF;
    let magnitude = match quarters {
        0 => hi + lo,
        1 => T::FRAC_PI_2 + (hi + (half_pi_lo + lo)),
        2 if hi > T::ZERO => (hi - T::PI) + (lo - T::PI_LO),
        2 => (T::PI + hi) + (T::PI_LO + lo),
        _ => (hi - T::FRAC_PI_2) + (lo - half_pi_lo),
    };
    let wrapped = if angle < T::ZERO { -magnitude } else { magnitude };
    if wrapped <= -T::PI || wrapped > T::PI { T::PI } else { wrapped }
}
