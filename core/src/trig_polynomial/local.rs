//! Roots on an arc, from samples on this arc alone.
//!
//! Where a function is small all over an arc, as near multiple roots, its values are known much better than those of
//! the polynomial through samples of the whole circle.

use super::roots::{self, Curve, Piece, Range, Root, Roots, direction, turned};
use super::tables::{CHEBYSHEV, INNER, OUTER};
use super::{DEGREE, NOISE, SAMPLES};

/// The check stands here, between two samples, in units of the half arc.
const CHECK: f64 = 0.53;

/// A trigonometric polynomial of degree 8 on an arc: in `x = tan(u / 2)` from its middle, times `(1 + x^2)^8`, a
/// polynomial of degree 16.
pub struct Local {
    /// Bernstein coefficients on the quarters of the arc.
    quarters: [[f64; SAMPLES]; 4],
    /// The greatest x.
    half: f64,
    /// Sine and cosine of the middle.
    middle: (f64, f64),
    /// Values are so far off.
    pub rounding: f64,
    /// The least magnitude of a sample.
    pub least: f64,
    /// Distance of the function from the polynomial at a check, as a share of the greatest sample; infinite if a sample
    /// is not finite.
    pub wrong: f64,
}

impl Local {
    /// Samples a function, which takes the sines and the cosines of two angles at once, on the arc about `middle` that
    /// ends at the half-angle tangents `half` and `-half`.
    #[inline(always)]
    pub fn sampled_in_pairs(
        middle: (f64, f64),
        half: f64,
        mut values: impl FnMut([f64; 2], [f64; 2]) -> [f64; 2],
    ) -> Self {
        let mut pair = |first: f64, second: f64| {
            let [(s, c), (t, d)] = [first, second].map(|node| turned(direction(half * node), middle));
            let [a, b] = values([s, t], [c, d]);
            [a * weight(half * first), b * weight(half * second)]
        };
        let mut samples = [0.0; SAMPLES];
        for (nodes, out) in CHEBYSHEV.chunks_exact(2).zip(samples.chunks_exact_mut(2)) {
            if let ([first, second], [x, y]) = (nodes, out) {
                [*x, *y] = pair(*first, *second);
            }
        }
        let [.., last] = CHEBYSHEV;
        let [at_last, at_check] = pair(last, CHECK);
        let [.., out] = &mut samples;
        *out = at_last;
        let mut quarters = [[0.0; SAMPLES]; 4];
        let [a, b, c, d] = &mut quarters;
        let (mut greatest, mut least, mut size) = (0.0_f64, f64::INFINITY, 0.0_f64);
        for (((sample, mirrored), outer), inner) in samples.iter().zip(samples.iter().rev()).zip(&OUTER).zip(&INNER) {
            (greatest, least) = (greatest.max(sample.abs()), least.min(sample.abs()));
            a.iter_mut().zip(outer).for_each(|(sum, entry)| *sum += entry * sample);
            b.iter_mut().zip(inner).for_each(|(sum, entry)| *sum += entry * sample);
            c.iter_mut().rev().zip(inner).for_each(|(sum, entry)| *sum += entry * mirrored);
            d.iter_mut().rev().zip(outer).for_each(|(sum, entry)| *sum += entry * mirrored);
        }
        for x in quarters.iter().flatten() {
            size = size.max(x.abs());
        }
        let mut local = Self { quarters, half, middle, rounding: NOISE * size, least, wrong: f64::INFINITY };
        let error = (local.at(half * CHECK).0 - at_check).abs();
        if error.is_finite() {
            local.wrong = if error > 0.0 { error / greatest } else { 0.0 };
            local.rounding = local.rounding.max(error);
        }
        local
    }

    /// The roots on the arc. Those are doubtful that rounding may move by more than 1e-7 rad.
    pub fn roots(&self) -> Roots {
        let mut out = Roots::none(self.rounding);
        let (mut low, width) = (-self.half, 0.5 * self.half);
        for quarter in self.quarters {
            let piece = Piece { b: quarter, low, width, depth: 2 };
            roots::isolate(self, piece, Range { half: self.half, near: self.half }, &mut out);
            low += width;
        }
        out
    }
}

impl Curve for Local {
    /// De Casteljau's way.
    #[inline(never)]
    fn at(&self, x: f64) -> (f64, f64) {
        let scale = 2.0 / self.half;
        let place = (x + self.half) * scale;
        let [a, b, c, d] = &self.quarters;
        let (quarter, s) = match place {
            ..1.0 => (a, place),
            ..2.0 => (b, place - 1.0),
            ..3.0 => (c, place - 2.0),
            _ => (d, place - 3.0),
        };
        let mut b = *quarter;
        let mut slope = 0.0;
        for level in (1..SAMPLES).rev() {
            slope = b[1] - b[0];
            for i in 0..level {
                b[i] += s * (b[i + 1] - b[i]);
            }
        }
        (b[0], (2 * DEGREE) as f64 * scale * slope)
    }

    fn root(&self, x: f64, spread: Option<f64>) -> Root {
        let (_, slope) = self.at(x);
        // From x to the angle: dx = (1 + x^2) / 2 du.
        Root::new(turned(direction(x), self.middle), 0.5 * (1.0 + x * x) * slope, spread, self.rounding)
    }
}

/// `(1 + x^2)^8`
fn weight(x: f64) -> f64 {
    let two = 1.0 + x * x;
    let four = two * two;
    let eight = four * four;
    eight * eight
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{sin_cos, wrap};

    /// Eight roots within 1e-2, which no polynomial of the whole circle resolves.
    #[test]
    fn near_roots_are_told_apart() {
        let roots: [f64; 8] = [1.0, 1.0011, 1.0019, 1.0032, 1.0043, 1.0057, 1.0064, 1.0088];
        let value = |sin: f64, cos: f64| {
            let mut value = 1.0 + 0.3 * sin;
            for root in roots {
                let (s, c) = sin_cos(0.5 * root);
                let half = crate::math::atan2(sin, cos) * 0.5;
                let (t, d) = sin_cos(half);
                value *= t * c - d * s;
            }
            value
        };
        let local = Local::sampled_in_pairs(sin_cos(1.003), 6e-3, |[s, t], [c, d]| [value(s, c), value(t, d)]);
        assert!(local.wrong < 1e-10, "{}", local.wrong);
        let found = local.roots();
        assert_eq!(found.as_slice().len(), 8);
        for root in roots {
            assert!(found.as_slice().iter().any(|x| wrap(x.angle - root).abs() < 1e-7), "{root}");
        }
    }
}
