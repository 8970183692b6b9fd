//! Square root: the processor's with `std`, that of `libm` with the feature of that name, else one in integers.
//! All three are correctly rounded, so they agree in every bit.

/// Square root of an `f64`.
#[inline]
pub(super) fn double(x: f64) -> f64 {
    #[cfg(feature = "std")]
    {
        x.sqrt()
    }
    #[cfg(all(not(feature = "std"), feature = "libm"))]
    {
        libm::sqrt(x)
    }
    #[cfg(not(any(feature = "std", feature = "libm")))]
    {
        integer::double(x)
    }
}

/// Square root of an `f32`.
#[inline]
pub(super) fn single(x: f32) -> f32 {
    #[cfg(feature = "std")]
    {
        x.sqrt()
    }
    #[cfg(all(not(feature = "std"), feature = "libm"))]
    {
        libm::sqrtf(x)
    }
    #[cfg(not(any(feature = "std", feature = "libm")))]
    {
        integer::single(x)
    }
}

#[cfg(any(test, not(any(feature = "std", feature = "libm"))))]
pub(super) mod integer {
    //! One guard bit is enough: a square root is never halfway between two floats, that would take twice their bits.

    /// Correctly rounded square root of an `f64`.
    pub(in crate::math) fn double(x: f64) -> f64 {
        if x == 0.0 || x.is_nan() || x == f64::INFINITY {
            return x;
        }
        if x < 0.0 {
            return f64::NAN;
        }
        // x = mantissa * 2^exponent, the exponent even, the mantissa of 107 or 108 bits: its root has 54.
        let bits = x.to_bits();
        let subnormal = bits >> 52 == 0;
        let stored = if subnormal { bits } else { (bits & ((1 << 52) - 1)) | (1 << 52) };
        let exponent = (bits >> 52) as i32 - 1075 + i32::from(subnormal);
        let shift = u128::from(stored).leading_zeros() as i32 - 20;
        let odd = (exponent - shift) & 1;
        let root = (u128::from(stored) << (shift - odd)).isqrt() as u64;
        let half = (exponent - shift + odd) / 2;
        // 2^53 <= root < 2^54; rounding up to 2^53 in the end carries into the exponent.
        let rounded = (root + 1) >> 1;
        let biased = (half + 1 + 52 + 1023 - 1) as u64;
        f64::from_bits((biased << 52) + rounded)
    }

    /// Correctly rounded square root of an `f32`.
    pub(in crate::math) fn single(x: f32) -> f32 {
        if x == 0.0 || x.is_nan() || x == f32::INFINITY {
            return x;
        }
        if x < 0.0 {
            return f32::NAN;
        }
        // x = mantissa * 2^exponent, the exponent even, the mantissa of 49 or 50 bits: its root has 25.
        let bits = x.to_bits();
        let subnormal = bits >> 23 == 0;
        let stored = if subnormal { bits } else { (bits & ((1 << 23) - 1)) | (1 << 23) };
        let exponent = (bits >> 23) as i32 - 150 + i32::from(subnormal);
        let shift = u64::from(stored).leading_zeros() as i32 - 14;
        let odd = (exponent - shift) & 1;
        let root = (u64::from(stored) << (shift - odd)).isqrt() as u32;
        let half = (exponent - shift + odd) / 2;
        let rounded = (root + 1) >> 1;
        let biased = (half + 1 + 23 + 127 - 1) as u32;
        f32::from_bits((biased << 23) + rounded)
    }
}
