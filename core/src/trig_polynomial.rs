//! Trigonometric polynomials of degree 8, and their real roots.
//!
//! With one joint held at the angle t, what remains of the closure of six joints is one equation `f(t) = 0`. Here f is
//! a sum of the harmonics 0 to 8 of t. Its 17 coefficients follow from 17 samples.

mod local;
mod roots;
mod tables;

pub use local::Local;
pub use roots::{MOST_NODES, MOST_ROOTS, Root, Roots};

use crate::math::ONE_COPY;
use tables::{ANGLES, CHECK_ANGLES, COSINES, OFFSETS, SINES, TURNS};

/// The highest harmonic.
pub const DEGREE: usize = 8;
/// The number of samples that determine a polynomial.
pub const SAMPLES: usize = 2 * DEGREE + 1;
/// The most values that [`Fit::sampled`] asks for: 17 samples and two checks at each of three offsets.
pub const MOST_SAMPLES: usize = 3 * (SAMPLES + tables::CHECKS);

/// Samples that differ from a polynomial by more than this share of the greatest are taken again elsewhere.
const WRONG: f64 = 1e-10;
/// Rounding of a value, relative to the sum of the magnitudes of the coefficients.
const NOISE: f64 = 6.0 * f64::EPSILON;

/// `f(t) = a_0 + sum over k = 1..8 of a_k cos k u + b_k sin k u`, with `u = t - offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrigPolynomial {
    /// a_0 to a_8.
    pub cosines: [f64; DEGREE + 1],
    /// b_0 = 0 and b_1 to b_8.
    pub sines: [f64; DEGREE + 1],
    /// The angle t, rad, at which u is 0. It is no round angle, and neither are the ends of the arcs that are searched.
    pub offset: f64,
    /// Sine and cosine of the offset.
    pub offset_sin_cos: (f64, f64),
}

/// A polynomial with what is known of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The polynomial through the samples.
    pub polynomial: TrigPolynomial,
    /// The greatest magnitude of a sample.
    pub greatest: f64,
    /// Distance of the function from the polynomial at the checks, as a share of `greatest`; infinite if no sample is
    /// finite. A sample may be the quotient of two numbers that both nearly vanish.
    pub wrong: f64,
}

impl Fit {
    /// Samples `value`, a function of the sine and the cosine of t, that is a trigonometric polynomial of degree 8.
    ///
    /// 17 samples determine the polynomial and two more check it. Where they miss it by more than 1e-10 of the
    /// greatest sample, the samples are taken at other angles, at most at three offsets. The best of them counts.
    #[inline]
    pub fn sampled(mut value: impl FnMut((f64, f64)) -> f64) -> Self {
        Self::tried(|nodes, checks| (nodes.map(&mut value), checks.map(&mut value)))
    }

    /// As [`Fit::sampled`], for a function that takes the sines and the cosines of two angles at once.
    #[inline]
    pub fn sampled_in_pairs(mut values: impl FnMut([f64; 2], [f64; 2]) -> [f64; 2]) -> Self {
        Self::tried(|nodes, checks| {
            let (mut samples, [a, b]) = ([0.0; SAMPLES], *checks);
            let mut pair = |(s, c), (t, d)| values([s, t], [c, d]);
            for (nodes, out) in nodes.chunks_exact(2).zip(samples.chunks_exact_mut(2)) {
                if let ([first, second], [x, y]) = (nodes, out) {
                    [*x, *y] = pair(*first, *second);
                }
            }
            let [.., last] = *nodes;
            let [.., out] = &mut samples;
            let [at_last, at_a] = pair(last, a);
            *out = at_last;
            let [at_b, _] = pair(b, b);
            (samples, [at_a, at_b])
        })
    }

    /// The best fit of at most three.
    #[inline(always)]
    fn tried(
        mut sample: impl FnMut(
            &[(f64, f64); SAMPLES],
            &[(f64, f64); tables::CHECKS],
        ) -> ([f64; SAMPLES], [f64; tables::CHECKS]),
    ) -> Self {
        let mut best = Self { polynomial: TrigPolynomial::ZERO, greatest: 0.0, wrong: f64::INFINITY };
        for (offset, turn) in OFFSETS.into_iter().zip(TURNS) {
            let (nodes, checks) =
                (ANGLES.map(|angle| roots::turned(angle, turn)), CHECK_ANGLES.map(|angle| roots::turned(angle, turn)));
            let (samples, at_checks) = sample(&nodes, &checks);
            let polynomial = TrigPolynomial::through(&samples, (offset, turn));
            let greatest = samples.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let mut error = 0.0_f64;
            for (angle, value) in CHECK_ANGLES.iter().zip(at_checks) {
                let miss = (polynomial.value(*angle) - value).abs();
                // One that is not a number counts as infinite.
                error = if miss <= error {
                    error
                } else if miss.is_finite() {
                    miss
                } else {
                    f64::INFINITY
                };
            }
            let wrong = if error > 0.0 { error / greatest } else { 0.0 };
            if wrong < best.wrong {
                best = Self { polynomial, greatest, wrong };
            }
            if best.wrong <= WRONG {
                break;
            }
        }
        best
    }

    /// Values of the polynomial are so far off, by rounding or at the checks.
    #[inline]
    pub fn rounding(&self) -> f64 {
        let (noise, wrong) = (NOISE * self.polynomial.size(), self.wrong * self.greatest);
        if wrong > noise { wrong } else { noise }
    }

    /// The real roots. Those are doubtful that [`Fit::rounding`] may move by more than 1e-7 rad.
    #[inline]
    pub fn roots(&self) -> Roots {
        let mut roots = Roots::default();
        self.find_roots(&mut roots);
        roots
    }

    /// As [`Fit::roots`], into a list.
    #[inline]
    pub fn find_roots(&self, roots: &mut Roots) {
        roots.clear(self.rounding());
        roots::find(&self.polynomial, roots);
    }
}

impl TrigPolynomial {
    /// Zero everywhere.
    pub const ZERO: Self =
        Self { cosines: [0.0; DEGREE + 1], sines: [0.0; DEGREE + 1], offset: 0.0, offset_sin_cos: (0.0, 1.0) };

    /// From samples at even angles from an offset, given with its sine and cosine: a discrete Fourier transform.
    fn through(samples: &[f64; SAMPLES], (offset, offset_sin_cos): (f64, (f64, f64))) -> Self {
        let (cosines, sines) = if ONE_COPY { without_tables(samples) } else { by_tables(samples) };
        Self { cosines, sines, offset, offset_sin_cos }
    }

    /// The sum of the magnitudes of the coefficients: no value is greater.
    #[inline]
    pub fn size(&self) -> f64 {
        self.cosines.iter().zip(&self.sines).fold(0.0, |sum, (a, b)| sum + (a.abs() + b.abs()))
    }

    /// Value and derivative at the sine and the cosine of t.
    #[inline]
    pub fn at(&self, (sin, cos): (f64, f64)) -> (f64, f64) {
        let (s, c) = self.offset_sin_cos;
        value_and_slope(&self.cosines, &self.sines, (sin * c - cos * s, cos * c + sin * s))
    }

    /// Value at the sine and the cosine of u.
    #[inline]
    fn value(&self, sin_cos: (f64, f64)) -> f64 {
        value_and_slope(&self.cosines, &self.sines, sin_cos).0
    }
}

/// The coefficients of the cosines and of the sines, a_0 to a_8 and b_0 to b_8.
type Coefficients = ([f64; DEGREE + 1], [f64; DEGREE + 1]);

/// The coefficients of the polynomial through samples.
#[inline(always)]
fn by_tables([first, others @ ..]: &[f64; SAMPLES]) -> Coefficients {
    let [mut cosines, mut sines] = [[0.0; DEGREE + 1]; 2];
    let row = COSINES[0].map(|weight| weight * first);
    cosines.copy_from_slice(&row);
    // Samples at opposite angles: their sum belongs to the cosines, their difference to the sines.
    let pairs = others.iter().zip(others.iter().rev()).take(DEGREE);
    for ((x, y), (even, odd)) in pairs.zip(COSINES.iter().skip(1).zip(&SINES)) {
        let (sum, difference) = (x + y, x - y);
        cosines.iter_mut().zip(even).for_each(|(a, weight)| *a += weight * sum);
        sines.iter_mut().skip(1).zip(odd).for_each(|(b, weight)| *b += weight * difference);
    }
    (cosines, sines)
}

/// As [`by_tables`], with each weight worked out: 1 kB less where size counts.
#[inline(always)]
fn without_tables([first, others @ ..]: &[f64; SAMPLES]) -> Coefficients {
    let [mut cosines, mut sines] = [[0.0; DEGREE + 1]; 2];
    // Of the first sample, which stands alone, each half is one of a pair.
    let pairs = core::iter::once((first * 0.5, first * 0.5));
    let pairs = pairs.chain(others.iter().zip(others.iter().rev()).take(DEGREE).map(|(x, y)| (*x, *y)));
    for (j, (x, y)) in pairs.enumerate() {
        for (k, (a, b)) in cosines.iter_mut().zip(&mut sines).enumerate() {
            let (even, odd) = tables::weights(j, k);
            *a += even * (x + y);
            *b += odd * (x - y);
        }
    }
    (cosines, sines)
}

/// Value and derivative of a sum of harmonics. Out of line where size counts, see `math::ONE_COPY`.
#[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
#[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline(always))]
fn value_and_slope(cosines: &[f64; DEGREE + 1], sines: &[f64; DEGREE + 1], once: (f64, f64)) -> (f64, f64) {
    // Sine and cosine of the multiples of the angle, by addition of two smaller ones: four steps in all.
    let two = roots::turned(once, once);
    let (three, four) = (roots::turned(once, two), roots::turned(two, two));
    let (five, six) = (roots::turned(two, three), roots::turned(three, three));
    let (seven, eight) = (roots::turned(three, four), roots::turned(four, four));
    let multiples: [_; DEGREE + 1] = [(0.0, 1.0), once, two, three, four, five, six, seven, eight];
    let (mut value, mut slope) = (0.0, 0.0);
    for (k, ((a, b), (sin, cos))) in cosines.iter().zip(sines).zip(multiples).enumerate() {
        value += a * cos + b * sin;
        slope += k as f64 * (b * cos - a * sin);
    }
    (value, slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{sin_cos, wrap};
    use core::f64::consts::TAU;

    /// A product of sines of half the distances from 16 angles, which has exactly these roots.
    fn product(roots: &[f64; 16], (sin, cos): (f64, f64)) -> f64 {
        let mut value = 1.0;
        for pair in roots.chunks(2) {
            let [a, b] = pair else { continue };
            // 2 sin((t - a) / 2) sin((t - b) / 2) = cos((a - b) / 2) - cos(t - (a + b) / 2)
            let ((_, near), (s, c)) = (sin_cos(0.5 * (a - b)), sin_cos(0.5 * (a + b)));
            value *= near - (cos * c + sin * s);
        }
        value
    }

    fn uniform(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 11) as f64 / (1_u64 << 53) as f64
    }

    #[test]
    fn weights_give_the_same_bits_with_tables_and_without() {
        let mut state = 5;
        for scale in [1.0, 1e-150, 1e150] {
            for _ in 0..100 {
                let samples = core::array::from_fn(|_| scale * (uniform(&mut state) - 0.5));
                assert_eq!(by_tables(&samples), without_tables(&samples));
            }
        }
    }

    fn distance(root: f64, found: &Roots) -> f64 {
        found.as_slice().iter().map(|x| wrap(x.angle - root).abs()).fold(9.0, f64::min)
    }

    #[test]
    fn sixteen_roots_are_found() {
        let mut state = 1;
        let mut nodes = 0;
        for _ in 0..2000 {
            // One in each sixteenth of a turn, at least a tenth of it from the ends.
            let turn = uniform(&mut state);
            let roots = core::array::from_fn(|i| (i as f64 + turn + 0.8 * uniform(&mut state)) * TAU / 16.0);
            let fit = Fit::sampled(|t| product(&roots, t));
            assert!(fit.wrong < 1e-13);
            let found = fit.roots();
            nodes += found.nodes;
            assert!(found.is_complete);
            assert_eq!(found.as_slice().len(), 16);
            for root in roots {
                let slope = fit.polynomial.at(sin_cos(root)).1.abs();
                let miss = distance(root, &found);
                assert!(miss < 4e-15 + 2.0 * fit.rounding() / slope, "{root} {miss} {:e}", fit.rounding() / slope);
            }
            for root in found.as_slice() {
                let (sin, cos) = sin_cos(root.angle);
                assert!((sin - root.sin_cos.0).abs() < 1e-14 && (cos - root.sin_cos.1).abs() < 1e-14);
                assert!((fit.polynomial.at(root.sin_cos).1 - root.slope).abs() < 1e-12 * fit.polynomial.size());
            }
        }
        assert!(nodes < 2000 * 120, "{nodes}");
    }

    /// Pairs that meet, fourfold roots, roots at round angles and at the ends of the arcs.
    #[test]
    fn multiple_roots_are_found_and_doubtful() {
        let ends = core::array::from_fn::<f64, 4, _>(|i| OFFSETS[0] + (i as f64 + 0.5) * TAU / 4.0);
        let round = core::array::from_fn::<f64, 24, _>(|i| i as f64 * TAU / 24.0);
        for (number, root) in ends.into_iter().chain(round).enumerate() {
            for times in [1, 2, 4, 8] {
                let roots =
                    core::array::from_fn(|i| if i < times { root } else { root + 0.3 * (i - times + 1) as f64 });
                let found = Fit::sampled(|t| product(&roots, t)).roots();
                // A root of order n is known to the n-th root of the rounding.
                let bound = [1e-11, 3e-6, 5e-3, 0.1][[1, 2, 4, 8].iter().position(|n| *n == times).unwrap_or(0)];
                let miss = distance(root, &found);
                assert!(miss < bound, "{number}: {root} {times} times, {miss}");
                assert!(found.is_complete);
                let nearest = found.as_slice().iter().filter(|x| wrap(x.angle - root).abs() < bound);
                assert!(times == 1 || nearest.into_iter().all(|x| x.is_doubtful));
            }
        }
    }

    /// A pair that has just become complex counts as double.
    #[test]
    fn a_touching_place_is_found() {
        for push in [1e-15, 1e-12, 1e-9] {
            let fit = Fit::sampled(|(sin, cos)| (1.0 - sin) * (2.0 + cos) + push);
            let found = fit.roots();
            assert!(distance(TAU / 4.0, &found) < 1e-2, "{push}");
            assert!(found.as_slice().iter().all(|root| root.is_doubtful));
        }
        assert!(Fit::sampled(|(sin, _)| 1.5 - sin).roots().as_slice().is_empty());
    }

    #[test]
    fn a_wrong_sample_moves_the_samples() {
        let bad = roots::turned(ANGLES[5], TURNS[0]);
        let fit = Fit::sampled(|t| if t == bad { 7.0 } else { product(&core::array::from_fn(|i| i as f64), t) });
        assert!(fit.wrong < 1e-12 && fit.polynomial.offset == OFFSETS[1]);
        let fit = Fit::sampled(|_| f64::NAN);
        assert!(fit.wrong == f64::INFINITY && fit.polynomial == TrigPolynomial::ZERO);
    }

    #[test]
    fn harmonics_above_eight_are_wrong() {
        let high =
            |(sin, cos): (f64, f64)| (0..9).fold((0.0, 1.0), |(s, c), _| (s * cos + c * sin, c * cos - s * sin)).1;
        assert!(Fit::sampled(high).wrong > 1e-2);
    }
}
