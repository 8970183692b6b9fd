//! Constants of the samples and of the Bernstein coefficients, computed by the compiler: nothing is set up at run time.

use super::{DEGREE, SAMPLES};

/// The checks of a fit: two more samples, midway between two of the others.
pub(super) const CHECKS: usize = 2;
/// Angles at which the first sample may stand, rad. No round angle of a joint is a sample or the end of an arc.
pub(super) const OFFSETS: [f64; 3] = [0.2718, 0.3923, 0.5131];
/// The greatest half-angle tangent of an arc: `tan(pi / 8)`.
pub(super) const HALF_ARC: f64 = 0.414_213_562_373_095_03;

/// Sine and cosine.
type SinCos = (f64, f64);
/// A table of all harmonics.
type Harmonics = [[f64; DEGREE + 1]; DEGREE + 1];
/// A table of sines, without what is 0.
type OddHarmonics = [[f64; DEGREE]; DEGREE];

/// Sine and cosine of `2 pi i / 34`, i = 0..33. The even ones belong to the samples, 33 and 15 to the checks.
const HALVES: [SinCos; 2 * SAMPLES] = {
    let mut table = [(0.0, 1.0); 2 * SAMPLES];
    let mut i = 1;
    while i < 2 * SAMPLES {
        table[i] = part_of_turn(i as u32, 2 * SAMPLES as u32);
        i += 1;
    }
    table
};

/// Sine and cosine of the three offsets.
pub(super) const TURNS: [SinCos; 3] = [series(OFFSETS[0]), series(OFFSETS[1]), series(OFFSETS[2])];

/// Sine and cosine of the angles of the samples, `2 pi j / 17`, without the offset.
pub(super) const ANGLES: [SinCos; SAMPLES] = {
    let mut angles = [(0.0, 1.0); SAMPLES];
    let mut j = 0;
    while j < SAMPLES {
        angles[j] = HALVES[2 * j];
        j += 1;
    }
    angles
};

/// Sine and cosine of the angles of the checks, without the offset.
pub(super) const CHECK_ANGLES: [SinCos; CHECKS] = [HALVES[33], HALVES[15]];

/// Coefficient of `cos k t`: the sum over j of row j, entry k, times the even part of the samples. Rows are j.
pub(super) const COSINES: Harmonics = transform(true);
/// As [`COSINES`], of `sin k t` and the odd part, without j = 0 and k = 0.
pub(super) const SINES: OddHarmonics = without_zeros(&transform(false), 1);

/// The weights of samples j and -j in the coefficients of `cos k t` and `sin k t`: what [`COSINES`] and [`SINES`] have.
#[inline(always)]
pub(super) fn weights(j: usize, k: usize) -> (f64, f64) {
    let (sin, cos) = ANGLES.get(j * k % SAMPLES).copied().unwrap_or_default();
    (weight(k) * cos, weight(k) * sin)
}

/// The factor of the sum over all samples in coefficient k.
const fn weight(k: usize) -> f64 {
    let times = if k == 0 { 1.0 } else { 2.0 };
    times / SAMPLES as f64
}

/// The eight rows behind the first of a table, from column `begin` on: the others are 0.
const fn without_zeros(all: &Harmonics, begin: usize) -> OddHarmonics {
    let mut table = [[0.0; DEGREE]; DEGREE];
    let mut row = 0;
    while row < DEGREE {
        let mut column = 0;
        while column < DEGREE {
            table[row][column] = all[row + 1][begin + column];
            column += 1;
        }
        row += 1;
    }
    table
}

const fn transform(is_even: bool) -> Harmonics {
    let mut table = [[0.0; DEGREE + 1]; DEGREE + 1];
    let mut k = 0;
    while k <= DEGREE {
        let mut j = 0;
        while j <= DEGREE {
            let (sin, cos) = HALVES[2 * ((j * k) % SAMPLES)];
            table[j][k] = weight(k) * if is_even { cos } else { sin };
            j += 1;
        }
        k += 1;
    }
    table
}

/// Row k: the first nine Bernstein coefficients of `(1 + x^2)^8 cos k t` on an arc of a quarter turn, with
/// `x = tan(t / 2)` from `-tan(pi / 8)` to `tan(pi / 8)`. The other eight are these in reverse.
pub(super) const EVEN: Harmonics = bernstein(true);
/// As [`EVEN`] for `(1 + x^2)^8 sin k t`, k = 1..8, up to the middle one, which is 0; the other eight are these in reverse,
/// negated.
pub(super) const ODD: OddHarmonics = without_zeros(&bernstein(false), 0);

/// `(1 + x^2)^8 e^(i k t) = (1 + i x)^(8 + k) (1 - i x)^(8 - k)`: a product of 16 linear factors.
const fn bernstein(is_even: bool) -> Harmonics {
    let mut table = [[0.0; DEGREE + 1]; DEGREE + 1];
    let mut k = 0;
    while k <= DEGREE {
        // Coefficients of s^m (1 - s)^(16 - m), where x runs from its least value at s = 0.
        let (mut re, mut im) = ([0.0; SAMPLES], [0.0; SAMPLES]);
        re[0] = 1.0;
        let mut factor = 0;
        while factor < 2 * DEGREE {
            let y = if factor < DEGREE + k { HALF_ARC } else { -HALF_ARC };
            // The factor is 1 - i y at s = 0 and 1 + i y at s = 1.
            let mut m = factor + 1;
            while m > 0 {
                let (a, b) = (re[m] + y * im[m], im[m] - y * re[m]);
                let (c, d) = (re[m - 1] - y * im[m - 1], im[m - 1] + y * re[m - 1]);
                (re[m], im[m]) = (a + c, b + d);
                m -= 1;
            }
            (re[0], im[0]) = (re[0] + y * im[0], im[0] - y * re[0]);
            factor += 1;
        }
        let mut choose = 1.0;
        let mut m = 0;
        while m <= DEGREE {
            table[k][m] = if is_even { re[m] } else { im[m] } / choose;
            choose = choose * (2 * DEGREE - m) as f64 / (m + 1) as f64;
            m += 1;
        }
        k += 1;
    }
    table
}

/// Where a function is sampled on an arc, in units of its half length: `cos((2 j + 1) pi / 34)`.
pub(super) const CHEBYSHEV: [f64; SAMPLES] = {
    let mut nodes = [0.0; SAMPLES];
    let mut j = 0;
    while j < SAMPLES {
        let (_, cos) = part_of_turn(2 * j as u32 + 1, 4 * SAMPLES as u32);
        nodes[j] = if j == DEGREE { 0.0 } else { cos };
        j += 1;
    }
    nodes
};

/// Row j: the Bernstein coefficients on [-1, -1/2] of the polynomial of degree 16 that is 1 at node j of [`CHEBYSHEV`] and 0
/// at the others. On [-1, 1] their greatest is 5,700, here 3.
pub(super) const OUTER: [[f64; SAMPLES]; SAMPLES] = lagrange(-1.0, -0.5);
/// As [`OUTER`], on [-1/2, 0].
pub(super) const INNER: [[f64; SAMPLES]; SAMPLES] = lagrange(-0.5, 0.0);

/// Bernstein coefficients on [low, high], see [`OUTER`].
const fn lagrange(low: f64, high: f64) -> [[f64; SAMPLES]; SAMPLES] {
    let mut table = [[0.0; SAMPLES]; SAMPLES];
    let mut j = 0;
    while j < SAMPLES {
        // Coefficients of s^m (1 - s)^(degree - m) of a product of linear factors.
        let mut row = [0.0; SAMPLES];
        row[0] = 1.0;
        let mut degree = 0;
        let mut i = 0;
        while i < SAMPLES {
            if i != j {
                let scale = 1.0 / (CHEBYSHEV[j] - CHEBYSHEV[i]);
                let (at_low, at_high) = ((low - CHEBYSHEV[i]) * scale, (high - CHEBYSHEV[i]) * scale);
                degree += 1;
                let mut m = degree;
                while m > 0 {
                    row[m] = row[m] * at_low + row[m - 1] * at_high;
                    m -= 1;
                }
                row[0] *= at_low;
            }
            i += 1;
        }
        let mut choose = 1.0;
        let mut m = 0;
        while m < SAMPLES {
            table[j][m] = row[m] / choose;
            choose = choose * (2 * DEGREE - m) as f64 / (m + 1) as f64;
            m += 1;
        }
        j += 1;
    }
    table
}

/// Sine and cosine of `2 pi part / whole`, `part < whole`.
const fn part_of_turn(part: u32, whole: u32) -> SinCos {
    // The angle in eighths of a turn, and the distance from the nearest multiple of a quarter turn.
    let quarters = (8 * part + whole) / (2 * whole);
    let rest = 4.0 * part as f64 - (quarters * whole) as f64;
    let (sin, cos) = series(rest / whole as f64 * core::f64::consts::FRAC_PI_2);
    match quarters % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Taylor series of sine and cosine, for |angle| up to 0.8.
const fn series(angle: f64) -> SinCos {
    let square = angle * angle;
    let (mut sin, mut cos) = (0.0, 0.0);
    let mut k = 10;
    while k > 0 {
        let even = (2 * k * (2 * k - 1)) as f64;
        let odd = (2 * k * (2 * k + 1)) as f64;
        cos = square / even * (1.0 - cos);
        sin = square / odd * (1.0 - sin);
        k -= 1;
    }
    (angle - angle * sin, 1.0 - cos)
}

#[cfg(test)]
mod tests {
    use super::super::roots::turned;
    use super::*;
    use crate::math::sin_cos;
    use core::f64::consts::TAU;

    /// The angle itself is rounded.
    fn near((s, c): SinCos, angle: f64) -> bool {
        let (sin, cos) = sin_cos(angle);
        (s - sin).abs() < 2e-15 && (c - cos).abs() < 2e-15
    }

    #[test]
    fn angles_are_those_of_the_samples() {
        for (turn, offset) in TURNS.into_iter().zip(OFFSETS) {
            let is_at = |angle: SinCos, wanted: f64| near(turned(angle, turn), wanted + offset);
            assert!(ANGLES.iter().enumerate().all(|(j, angle)| is_at(*angle, TAU * j as f64 / 17.0)));
            let [first, second] = CHECK_ANGLES;
            assert!(is_at(first, TAU * 16.5 / 17.0) && is_at(second, TAU * 7.5 / 17.0));
        }
        assert!((HALF_ARC - (core::f64::consts::SQRT_2 - 1.0)).abs() < 2e-16);
    }

    /// Bernstein coefficients from samples give back a power.
    #[test]
    fn samples_on_an_arc_give_bernstein_coefficients() {
        for power in [0, 1, 2, 7, 16] {
            let value = |x: f64| (0..power).fold(1.0, |y, _| y * (0.3 + 0.7 * x));
            for (table, low, high) in [(OUTER, -1.0, -0.5), (INNER, -0.5, 0.0)] {
                let mut b = [0.0; SAMPLES];
                for (node, row) in CHEBYSHEV.iter().zip(table) {
                    b.iter_mut().zip(row).for_each(|(sum, entry)| *sum += entry * value(*node));
                }
                assert!((b[0] - value(low)).abs() < 1e-14 && (b[16] - value(high)).abs() < 1e-14);
                if power == 16 {
                    // Of the power of a linear function: products of its values at the ends.
                    for (i, x) in b.iter().enumerate() {
                        let at = |x: f64, count: usize| (0..count).fold(1.0, |y, _| y * (0.3 + 0.7 * x));
                        let wanted = at(low, 16 - i) * at(high, i);
                        assert!((x - wanted).abs() < 1e-14, "{i} {x} {wanted}");
                    }
                }
            }
        }
    }

    /// The Bernstein form of each harmonic has its values on the arc.
    #[test]
    fn bernstein_coefficients_are_those_of_the_harmonics() {
        for k in 0..=DEGREE {
            for i in 0..=20 {
                let s = f64::from(i) / 20.0;
                let x = HALF_ARC * (2.0 * s - 1.0);
                let half_angle = crate::math::atan2(x, 1.0);
                let weight = (0..DEGREE).fold(1.0, |w, _| w * (1.0 + x * x));
                let (sin, cos) = sin_cos(2.0 * k as f64 * half_angle);
                let mut odd = [0.0; DEGREE + 1];
                if k > 0 {
                    odd[..DEGREE].copy_from_slice(&ODD[k - 1]);
                }
                for (row, value, sign) in [(EVEN[k], cos, 1.0), (odd, sin, -1.0)] {
                    // De Casteljau.
                    let mut b: [f64; SAMPLES] =
                        core::array::from_fn(|m| if m <= DEGREE { row[m] } else { sign * row[2 * DEGREE - m] });
                    for level in 1..SAMPLES {
                        for m in 0..SAMPLES - level {
                            b[m] = b[m] * (1.0 - s) + b[m + 1] * s;
                        }
                    }
                    assert!((b[0] - weight * value).abs() < 1e-14, "{k} {s}");
                }
            }
        }
    }
}
