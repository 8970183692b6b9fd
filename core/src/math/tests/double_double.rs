//! Sums of two `f64`, about 104 bits: the reference (Dekker, Numerische Mathematik 18, 1971).

use core::ops::{Add, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug)]
pub(super) struct Wide {
    pub(super) hi: f64,
    pub(super) lo: f64,
}

/// pi/2 in three doubles, 159 bits.
const PI_2: [f64; 3] = [1.5707963267948966, 6.123233995736766e-17, -1.4973849048591833e-33];

fn two_sum(a: f64, b: f64) -> Wide {
    let hi = a + b;
    let part = hi - a;
    Wide { hi, lo: (a - (hi - part)) + (b - part) }
}

fn split(a: f64) -> (f64, f64) {
    let hi = f64::from_bits(a.to_bits() & (u64::MAX << 27));
    (hi, a - hi)
}

pub(super) fn two_product(a: f64, b: f64) -> Wide {
    let hi = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    Wide { hi, lo: ((ah * bh - hi) + ah * bl + al * bh) + al * bl }
}

impl From<f64> for Wide {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = two_sum(sum.hi, sum.lo + low.hi);
        two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.hi, other.hi);
        two_sum(product.hi, product.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Wide {
    /// Quotient by a small integer.
    fn over(self, n: f64) -> Self {
        let first = self.hi / n;
        let rest = self - two_product(first, n);
        two_sum(first, rest.hi / n)
    }
}

/// `(sin, cos)` of |x| < 1e8 by Taylor series.
pub(super) fn sin_cos(x: f64) -> (Wide, Wide) {
    const ROUNDER: f64 = 6755399441055744.0;
    let n = (x / PI_2[0] + ROUNDER) - ROUNDER;
    let r = PI_2.iter().fold(Wide::from(x), |rest, part| rest - two_product(n, *part));
    let (mut sine, mut cosine) = (Wide::from(0.0), Wide::from(0.0));
    let mut term = Wide::from(1.0);
    for k in 0..30 {
        let signed = if k & 2 == 0 { term } else { -term };
        if k & 1 == 0 {
            cosine = cosine + signed
        } else {
            sine = sine + signed
        }
        term = (term * r).over(f64::from(k + 1));
    }
    match (n as i64).rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// Distance of `value` from `exact` in units of the last place of `exact`.
pub(super) fn ulps(value: f64, exact: Wide) -> f64 {
    // The neighbor below has half the spacing if `hi` is a power of two and `lo` points there.
    let magnitude = if exact.hi < 0.0 { -exact } else { exact };
    let below = magnitude.lo < 0.0;
    let least = if below { f64::from_bits(magnitude.hi.to_bits() - 1) } else { magnitude.hi };
    let unit = f64::from_bits(least.to_bits() + 1) - least;
    (((value - exact.hi) - exact.lo) / unit).abs()
}

/// Distance of `value` from `exact` in units of the last place of an `f32` of that size.
pub(super) fn ulps_single(value: f32, exact: f64) -> f64 {
    let exponent = ((exact.to_bits() >> 52) & 0x7ff).max(1023 - 126);
    let unit = f64::from_bits((exponent - 23) << 52);
    ((f64::from(value) - exact) / unit).abs()
}
