//! Four numbers in an array. The compiler turns the loops into what vector code the target has.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Lanes, MOST_LANES, Row, sealed};
use crate::math::{SIGN, UPPER};

/// Four lanes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Four([f64; 4]);

impl Four {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let Self([a, b, c, d]) = self;
        Self([f(a), f(b), f(c), f(d)])
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let (Self([a, b, c, d]), Self([e, g, h, i])) = (self, other);
        Self([f(a, e), f(b, g), f(c, h), f(d, i)])
    }

    #[inline(always)]
    fn compared(self, other: Self, f: impl Fn(f64, f64) -> bool) -> [u64; 4] {
        let (Self([a, b, c, d]), Self([e, g, h, i])) = (self, other);
        let all = |holds: bool| 0u64.wrapping_sub(u64::from(holds));
        [all(f(a, e)), all(f(b, g)), all(f(c, h)), all(f(d, i))]
    }
}

#[inline(always)]
fn masks([a, b, c, d]: [u64; 4], [e, g, h, i]: [u64; 4], f: impl Fn(u64, u64) -> u64) -> [u64; 4] {
    [f(a, e), f(b, g), f(c, h), f(d, i)]
}

#[inline(always)]
fn picked(mask: u64, a: f64, b: f64) -> f64 {
    f64::from_bits((a.to_bits() & mask) | (b.to_bits() & !mask))
}

macro_rules! operator {
    ($Trait:ident $function:ident $operator:tt) => {
        impl $Trait for Four {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                self.with(other, |a, b| a $operator b)
            }
        }
    };
}
operator!(Add add +);
operator!(Sub sub -);
operator!(Mul mul *);
operator!(Div div /);

impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl sealed::Sealed for Four {}

impl Lanes for Four {
    type Mask = [u64; 4];
    type Set = ();
    const WIDTH: usize = 4;
    const EXPLICIT: bool = false;

    #[inline(always)]
    fn all((): (), value: f64) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn of(self, value: f64) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn load((): (), Row(row): &Row, at: usize) -> Self {
        let (fours, _) = row.as_chunks::<4>();
        fours.get(at).map_or(Self([0.0; 4]), |four| Self(*four))
    }
    #[inline(always)]
    fn store(self, Row(row): &mut Row, at: usize) {
        let (fours, _) = row.as_chunks_mut::<4>();
        if let Some(four) = fours.get_mut(at) {
            *four = self.0;
        }
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        if let Some(four) = to.first_chunk_mut::<4>() {
            *four = self.0;
        }
    }
    #[inline(always)]
    fn columns((): (), [a, b, c, d, ..]: &[[f64; 4]; MOST_LANES]) -> [Self; 4] {
        let ([a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]) = (*a, *b, *c, *d);
        [Self([a, b, c, d]), Self([e, f, g, h]), Self([i, j, k, l]), Self([m, n, o, p])]
    }
    #[inline(always)]
    fn rows([x, y, z, w]: [Self; 4]) -> [[f64; 4]; MOST_LANES] {
        let (Self([a, b, c, d]), Self([e, f, g, h])) = (x, y);
        let (Self([i, j, k, l]), Self([m, n, o, p])) = (z, w);
        let none = [0.0; 4];
        [[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p], none, none, none, none]
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(crate::math::sqrt)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.with(sign, f64::copysign)
    }
    #[inline(always)]
    fn turned_by(self, sign: Self) -> Self {
        self.with(sign, |a, sign| f64::from_bits(a.to_bits() ^ (sign.to_bits() & SIGN)))
    }
    #[inline(always)]
    fn upper(self) -> Self {
        self.map(|a| f64::from_bits(a.to_bits() & UPPER))
    }
    #[inline(always)]
    fn less(self, other: Self) -> [u64; 4] {
        self.compared(other, |a, b| a < b)
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> [u64; 4] {
        self.compared(other, |a, b| a <= b)
    }
    #[inline(always)]
    fn where_or(self, [k, l, m, n]: [u64; 4], other: Self) -> Self {
        let (Self([a, b, c, d]), Self([e, f, g, h])) = (self, other);
        Self([picked(k, a, e), picked(l, b, f), picked(m, c, g), picked(n, d, h)])
    }
    #[inline(always)]
    fn mask((): (), value: bool) -> [u64; 4] {
        [0u64.wrapping_sub(u64::from(value)); 4]
    }
    #[inline(always)]
    fn both(a: [u64; 4], b: [u64; 4]) -> [u64; 4] {
        masks(a, b, |a, b| a & b)
    }
    #[inline(always)]
    fn either(a: [u64; 4], b: [u64; 4]) -> [u64; 4] {
        masks(a, b, |a, b| a | b)
    }
    #[inline(always)]
    fn not(mask: [u64; 4]) -> [u64; 4] {
        masks(mask, mask, |a, _| !a)
    }
    #[inline(always)]
    fn bits([a, b, c, d]: [u64; 4]) -> u32 {
        ((a & 1) | (b & 2) | (c & 4) | (d & 8)) as u32
    }
    #[inline(always)]
    fn quarters(rounded: Self, sine: Self, cosine: Self, angle: Self) -> (Self, Self) {
        let (Self([q, r, s, t]), Self([a, b, c, d])) = (rounded, sine);
        let (Self([e, f, g, h]), Self([x, y, z, w])) = (cosine, angle);
        let turned = [turn(q, a, e, x), turn(r, b, f, y), turn(s, c, g, z), turn(t, d, h, w)];
        let [(a, e), (b, f), (c, g), (d, h)] = turned;
        (Self([a, b, c, d]), Self([e, f, g, h]))
    }
}

#[inline(always)]
fn turn(rounded: f64, sine: f64, cosine: f64, angle: f64) -> (f64, f64) {
    let (quarters, sine, cosine) = (rounded.to_bits(), sine.to_bits(), cosine.to_bits());
    let swap = (sine ^ cosine) & 0u64.wrapping_sub(quarters & 1);
    let sine_sign = ((quarters << 62) ^ angle.to_bits()) & SIGN;
    let cosine_sign = ((quarters ^ (quarters << 1)) << 62) & SIGN;
    (f64::from_bits(sine ^ swap ^ sine_sign), f64::from_bits(cosine ^ swap ^ cosine_sign))
}
