//! Vectors of `fearless_simd`: two, four or eight numbers, as wide as the registers of the instruction set.

use fearless_simd::{
    Bytes, ExtractToken, Select, Simd, SimdBase, SimdFloat, SimdMask, f64x2, f64x4, f64x8, mask64x2, mask64x4,
    mask64x8, u64x2, u64x4, u64x8,
};

use super::turned::Turned;
use super::{Lanes, MOST_LANES, Row, sealed};
use crate::math::{SIGN, UPPER};

macro_rules! vector {
    ($Float:ident $Bits:ident $Mask:ident $width:literal) => {
        impl<S: Simd> sealed::Sealed for $Float<S> {}

        impl<S: Simd> Lanes for $Float<S> {
            type Mask = $Mask<S>;
            type Set = S;
            const WIDTH: usize = $width;
            const EXPLICIT: bool = true;

            #[inline(always)]
            fn all(set: S, value: f64) -> Self {
                SimdBase::splat(set, value)
            }
            #[inline(always)]
            fn of(self, value: f64) -> Self {
                SimdBase::splat(ExtractToken::token(&self), value)
            }
            #[inline(always)]
            fn load(set: S, Row(row): &Row, at: usize) -> Self {
                let (vectors, _) = row.as_chunks::<$width>();
                let zeros = [0.0; $width];
                SimdBase::load_array_ref(set, vectors.get(at).unwrap_or(&zeros))
            }
            #[inline(always)]
            fn store(self, Row(row): &mut Row, at: usize) {
                let (vectors, _) = row.as_chunks_mut::<$width>();
                if let Some(vector) = vectors.get_mut(at) {
                    SimdBase::store_array(self, vector);
                }
            }
            #[inline(always)]
            fn write(self, to: &mut [f64]) {
                if let Some(vector) = to.first_chunk_mut::<$width>() {
                    SimdBase::store_array(self, vector);
                }
            }
            #[inline(always)]
            fn columns(set: S, rows: &[[f64; 4]; MOST_LANES]) -> [Self; 4] {
                Turned::columns(set, rows)
            }
            #[inline(always)]
            fn rows(columns: [Self; 4]) -> [[f64; 4]; MOST_LANES] {
                Turned::rows(columns)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                SimdBase::abs(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                SimdFloat::sqrt(self)
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                SimdFloat::copysign(self, sign)
            }
            #[inline(always)]
            fn turned_by(self, sign: Self) -> Self {
                let (bits, sign): ($Bits<S>, $Bits<S>) = (self.bitcast(), sign.bitcast());
                (bits ^ (sign & SIGN)).bitcast()
            }
            #[inline(always)]
            fn upper(self) -> Self {
                let bits: $Bits<S> = self.bitcast();
                (bits & UPPER).bitcast()
            }
            #[inline(always)]
            fn less(self, other: Self) -> Self::Mask {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn at_most(self, other: Self) -> Self::Mask {
                self.simd_le(other)
            }
            #[inline(always)]
            fn where_or(self, mask: Self::Mask, other: Self) -> Self {
                mask.select(self, other)
            }
            #[inline(always)]
            fn mask(set: S, value: bool) -> Self::Mask {
                let (zero, one) = (Self::all(set, 0.0), Self::all(set, if value { 1.0 } else { 0.0 }));
                zero.less(one)
            }
            #[inline(always)]
            fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask {
                a & b
            }
            #[inline(always)]
            fn either(a: Self::Mask, b: Self::Mask) -> Self::Mask {
                a | b
            }
            #[inline(always)]
            fn not(mask: Self::Mask) -> Self::Mask {
                !mask
            }
            #[inline(always)]
            fn bits(mask: Self::Mask) -> u32 {
                SimdMask::to_bitmask(mask) as u32
            }
            #[inline(always)]
            fn quarters(rounded: Self, sine: Self, cosine: Self, angle: Self) -> (Self, Self) {
                let (quarters, angle): ($Bits<S>, $Bits<S>) = (rounded.bitcast(), angle.bitcast());
                let (sine, cosine): ($Bits<S>, $Bits<S>) = (sine.bitcast(), cosine.bitcast());
                let odd = quarters & 1u64;
                let swap = (sine ^ cosine) & ((quarters ^ quarters) - odd);
                let sine_sign = ((quarters << 62u32) ^ angle) & SIGN;
                let cosine_sign = ((quarters ^ (quarters << 1u32)) << 62u32) & SIGN;
                ((sine ^ swap ^ sine_sign).bitcast(), (cosine ^ swap ^ cosine_sign).bitcast())
            }
        }
    };
}
vector!(f64x2 u64x2 mask64x2 2);
vector!(f64x4 u64x4 mask64x4 4);
vector!(f64x8 u64x8 mask64x8 8);
