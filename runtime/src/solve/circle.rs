//! Real roots of a trigonometric polynomial of degree two.

use super::Tolerances;
use crate::math::{atan2, sin_cos};

/// `k0 + k1c cos t + k1s sin t + k2c cos 2t + k2s sin 2t`
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle<T> {
    pub k0: T,
    pub k1: [T; 2],
    pub k2: [T; 2],
}

impl<T: Tolerances> Circle<T> {
    /// The largest coefficient.
    pub(super) fn largest(&self) -> T {
        let Circle { k0, k1: [k1c, k1s], k2: [k2c, k2s] } = *self;
        k0.abs().max(k1c.abs()).max(k1s.abs()).max(k2c.abs()).max(k2s.abs())
    }
}

type Complex<T> = [T; 2];

fn times<T: Tolerances>([a, b]: Complex<T>, [c, d]: Complex<T>) -> Complex<T> {
    [a * c - b * d, a * d + b * c]
}

fn plus<T: Tolerances>([a, b]: Complex<T>, [c, d]: Complex<T>) -> Complex<T> {
    [a + c, b + d]
}

fn over<T: Tolerances>(a: Complex<T>, [c, d]: Complex<T>) -> Complex<T> {
    let size = c * c + d * d;
    if size == T::ZERO {
        return [T::ZERO; 2];
    }
    let [x, y] = times(a, [c, -d]);
    [x / size, y / size]
}

/// Up to four angles in (-pi, pi]. A root and its mirror image in the unit circle that are close to it are a nearly
/// real pair: both are returned as candidates, so that a double root is never lost to rounding.
pub(super) fn angles<T: Tolerances>(circle: &Circle<T>) -> ([T; 4], usize) {
    let Circle { k0, k1: [k1c, k1s], k2: [k2c, k2s] } = *circle;
    let mut found = ([T::ZERO; 4], 0);
    let largest = circle.largest();
    if !(largest > T::ZERO) {
        return found;
    }
    let k = T::ONE / largest;
    let first = [k1c * T::HALF * k, -k1s * T::HALF * k];
    let second = [k2c * T::HALF * k, -k2s * T::HALF * k];
    let mut push = |angle: T| {
        if let (angles, len) = &mut found
            && let Some(slot) = angles.get_mut(*len)
        {
            *slot = polished(circle, angle);
            *len += 1;
        }
    };
    if second[0].abs().max(second[1].abs()) <= T::ROUNDING {
        // a cos t + b sin t = d
        let (r, d) = ((k1c * k1c + k1s * k1s).sqrt(), -k0);
        let base = atan2(k1s, k1c);
        let off = atan2(((r - d) * (r + d)).max(T::ZERO).sqrt(), d);
        push(base - off);
        push(base + off);
        return found;
    }
    // On the circle z = exp(it) the polynomial times z^2 is c2 z^4 + c1 z^3 + k0 z^2 + conj(c1) z + conj(c2).
    let coefficients = [second, first, [k0 * k, T::ZERO], [first[0], -first[1]], [second[0], -second[1]]];
    for [x, y] in ehrlich_aberth(&coefficients) {
        let size = x * x + y * y;
        // |log|z|| < 0.3
        if size > T::from_f64(0.5488) && size < T::from_f64(1.8221) {
            push(atan2(y, x));
        }
    }
    found
}

/// The four roots of a quartic by simultaneous iteration (Ehrlich 1967, Aberth 1973).
fn ehrlich_aberth<T: Tolerances>(coefficients: &[Complex<T>; 5]) -> [Complex<T>; 4] {
    let start = |x: f64, y: f64| [T::from_f64(x), T::from_f64(y)];
    // Not symmetric about any axis, near the circle on which the wanted roots lie.
    let mut roots = [start(0.93, 0.41), start(-0.52, 0.79), start(-0.81, -0.67), start(0.38, -1.05)];
    for _ in 0..60 {
        let mut moved = T::ZERO;
        for i in 0..4 {
            let Some(&z) = roots.get(i) else { continue };
            let (mut value, mut slope) = ([T::ZERO; 2], [T::ZERO; 2]);
            for c in coefficients {
                slope = plus(times(slope, z), value);
                value = plus(times(value, z), *c);
            }
            let newton = over(value, slope);
            let mut repulsion = [T::ZERO; 2];
            for (j, other) in roots.iter().enumerate() {
                if j != i {
                    repulsion = plus(repulsion, over([T::ONE, T::ZERO], plus(z, [-other[0], -other[1]])));
                }
            }
            let [x, y] = times(newton, repulsion);
            let step = over(newton, [T::ONE - x, -y]);
            let relative = (step[0] * step[0] + step[1] * step[1]) / (z[0] * z[0] + z[1] * z[1]).max(T::EPSILON);
            moved = moved.max(relative);
            if let Some(root) = roots.get_mut(i) {
                *root = plus(z, [-step[0], -step[1]]);
            }
        }
        if !(moved > T::EPSILON * T::EPSILON * T::from_f64(64.0)) {
            break;
        }
    }
    roots
}

/// Two Newton steps; at a nearly double root towards the extremum between the two.
fn polished<T: Tolerances>(circle: &Circle<T>, angle: T) -> T {
    let Circle { k0, k1: [k1c, k1s], k2: [k2c, k2s] } = *circle;
    let four = T::TWO + T::TWO;
    let mut t = angle;
    for _ in 0..2 {
        let ((s, c), (s2, c2)) = (sin_cos(t), sin_cos(t + t));
        let value = k0 + k1c * c + k1s * s + k2c * c2 + k2s * s2;
        let slope = k1s * c - k1c * s + T::TWO * (k2s * c2 - k2c * s2);
        let curve = -(k1c * c + k1s * s) - four * (k2c * c2 + k2s * s2);
        let step = if slope * slope > (value * curve).abs() { value / slope } else { slope / curve };
        if !step.is_finite() || step.abs() > T::HALF {
            break;
        }
        t -= step;
    }
    crate::math::wrap(t)
}
