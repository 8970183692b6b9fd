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
pub(super) mod integer;
