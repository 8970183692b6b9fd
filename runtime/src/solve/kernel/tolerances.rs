//! The thresholds of the cascade, from the rounding of the scalar.
//!
//! Six numbers, each a formula of `eps`, the distance from 1 to the next number. The formulas are the same for both
//! scalars.
//!
//! An amplitude is the sine between two directions, or the radius of a circle relative to reach. At a singular pose the
//! amplitude is 0, and rounding leaves [`LEFT`] of it. This rounding is that of the target, and that of the rotations
//! which take the target's axis to the joint's frame. A stage of amplitude `a` on the way there, an elbow nearly
//! stretched, magnifies the rounding by `1/a`.

use crate::math::Scalar;

/// Bound on the rounding of an amplitude that vanishes, in units of `eps`, where the stages before are well
/// conditioned.
///
/// A component of the wrist's axis is a sum of three products, of a column of the target and a column of a rotation.
/// Either column has length 1, so that by Cauchy and Schwarz relative errors of the entries add up. The entry of the
/// target adds half a unit, that of the rotation two halves, the products and their sum three halves.
const LEFT: f64 = 3.0;

/// Thresholds relative to the size of the quantities compared (reach for lengths, 1 for directions).
pub trait Tolerances: Scalar {
    /// Rounding of a chain: `64 eps`. Below it two roots are one, a gap is none, a rotation is one. A component passes
    /// the rotations of six joints and six links, three products and two sums each.
    const ROUNDING: Self;
    /// Joint vectors closer than this in every joint (rad, relative to reach) are one solution: `2 sqrt(ROUNDING)`. Two
    /// roots `+-h` merge where `h^2` is below `ROUNDING`.
    const COINCIDENT: Self;
    /// Amplitude below which a stage is in doubt: the cube root of `3 eps / COINCIDENT`. Of the `3 eps` that rounding
    /// leaves, three stages in a row (shoulder, elbow, wrist) of this amplitude make `COINCIDENT`. So a solution without
    /// a stage in doubt is no other one.
    const DOUBTFUL: Self;
    /// Amplitude below which an equation does not determine its joint: `3 eps / DOUBTFUL`, what rounding leaves behind
    /// a stage that is not in doubt. Behind one that is, its own amplitude counts in the place of `DOUBTFUL`.
    const VANISHING: Self;
    /// Amplitude below which a joint may be all wrong: `sqrt(eps) / DOUBTFUL`. A double root before it is known to
    /// `sqrt(eps)`, which makes the joint wrong by `sqrt(eps)` over its amplitude. Steps of verification lead back from
    /// `DOUBTFUL`. A root that misses another equation by more belongs to another branch.
    const WEAK: Self;
    /// A residual up to this (relative to reach, and in rad) is exact: `2 VANISHING`. A joint that stays at its default
    /// value, anywhere on its circle, misses by the diameter.
    const EXACT: Self;
    /// A sine far below rounding whose fourth power is a number.
    const LEAST_SINE: Self;
    /// -1.
    const MINUS_ONE: Self;
    /// An angle beyond this, rad, is no reference: half a unit of its last place in every joint is about
    /// [`Self::EXACT`].
    const MOST_WOUND: Self;
    /// An arm of this reach or more has squares of areas that overflow.
    const LARGEST_REACH: Self;
    /// An arm of this reach or less has squares of areas that underflow where they count.
    const SMALLEST_REACH: Self;
}

/// The thresholds of a scalar.
struct Derived {
    rounding: f64,
    coincident: f64,
    doubtful: f64,
    vanishing: f64,
    weak: f64,
    exact: f64,
}

impl Derived {
    /// From `eps`, while the code is compiled.
    const fn from(epsilon: f64) -> Self {
        let rounding = 64.0 * epsilon;
        let coincident = 2.0 * root(2, rounding);
        let doubtful = root(3, LEFT * epsilon / coincident);
        let vanishing = LEFT * epsilon / doubtful;
        let weak = root(2, epsilon) / doubtful;
        Self { rounding, coincident, doubtful, vanishing, weak, exact: 2.0 * vanishing }
    }
}

/// The root of degree `n` of `x` below 1: Newton's method on `y^n = x` from above. Each step leaves at most
/// `(n - 1) / n` of y until it is close. From 1 to the least root here, that of `2^-52`, are 26 steps.
const fn root(n: u32, x: f64) -> f64 {
    let mut y = 1.0;
    let mut steps = 0;
    while steps < 60 {
        let mut power = 1.0;
        let mut k = 1;
        while k < n {
            power *= y;
            k += 1;
        }
        y -= (y - x / power) / n as f64;
        steps += 1;
    }
    y
}

const DOUBLE: Derived = Derived::from(f64::EPSILON);
const SINGLE: Derived = Derived::from(f32::EPSILON as f64);

impl Tolerances for f64 {
    const ROUNDING: f64 = DOUBLE.rounding;
    const COINCIDENT: f64 = DOUBLE.coincident;
    const DOUBTFUL: f64 = DOUBLE.doubtful;
    const VANISHING: f64 = DOUBLE.vanishing;
    const WEAK: f64 = DOUBLE.weak;
    const EXACT: f64 = DOUBLE.exact;
    const LEAST_SINE: f64 = 5e-32;
    const MINUS_ONE: f64 = -1.0;
    const MOST_WOUND: f64 = 2048.0;
    const LARGEST_REACH: f64 = 1e60;
    const SMALLEST_REACH: f64 = 1e-60;
}

impl Tolerances for f32 {
    const ROUNDING: f32 = SINGLE.rounding as f32;
    const COINCIDENT: f32 = SINGLE.coincident as f32;
    const DOUBTFUL: f32 = SINGLE.doubtful as f32;
    const VANISHING: f32 = SINGLE.vanishing as f32;
    const WEAK: f32 = SINGLE.weak as f32;
    const EXACT: f32 = SINGLE.exact as f32;
    const LEAST_SINE: f32 = 1e-9;
    const MINUS_ONE: f32 = -1.0;
    const MOST_WOUND: f32 = 64.0;
    const LARGEST_REACH: f32 = 1e8;
    const SMALLEST_REACH: f32 = 1e-4;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<T: Tolerances>() {
        let [eps, rounding, coincident, doubtful, vanishing] =
            [T::EPSILON, T::ROUNDING, T::COINCIDENT, T::DOUBTFUL, T::VANISHING].map(Scalar::to_f64);
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 8.0 * eps;
        assert!(close(coincident, 2.0 * rounding.sqrt()));
        assert!(close(3.0 * eps / doubtful.powi(3), coincident));
        assert!(close(vanishing * doubtful, 3.0 * eps));
        assert!(close(T::WEAK.to_f64() * doubtful, eps.sqrt()));
        // What is exact is more than a target may deviate from a rotation by.
        assert!(vanishing < T::EXACT.to_f64() && rounding < T::EXACT.to_f64());
    }

    #[test]
    fn the_thresholds_are_what_they_are_derived_to_be() {
        check::<f64>();
        check::<f32>();
        // Half of the last place at the most wound reference, in six joints, against what is exact.
        for (most, eps, exact) in [
            (f64::MOST_WOUND, f64::EPSILON, f64::EXACT),
            (f32::MOST_WOUND.into(), f32::EPSILON.into(), f32::EXACT.into()),
        ] {
            let missed = 6.0 * most * eps / 4.0;
            assert!((0.5..1.0).contains(&(missed / exact)), "{missed} {exact}");
        }
    }
}
