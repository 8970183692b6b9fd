//! Square root. With `std` the root is the processor's, with `fpu` too, where the processor has one. Else the root is
//! that of `libm` with the feature of that name, or one in integers. All are correctly rounded, so they agree in every
//! bit.

/// Square root of an `f64`.
#[inline]
pub(super) fn double(x: f64) -> f64 {
    #[cfg(feature = "std")]
    {
        x.sqrt()
    }
    #[cfg(all(not(feature = "std"), feature = "fpu"))]
    {
        denhart_fpu::double(x).unwrap_or_else(|| software::double(x))
    }
    #[cfg(not(any(feature = "std", feature = "fpu")))]
    {
        software::double(x)
    }
}

/// Square root of an `f32`.
#[inline]
pub(super) fn single(x: f32) -> f32 {
    #[cfg(feature = "std")]
    {
        x.sqrt()
    }
    #[cfg(all(not(feature = "std"), feature = "fpu"))]
    {
        denhart_fpu::single(x).unwrap_or_else(|| software::single(x))
    }
    #[cfg(not(any(feature = "std", feature = "fpu")))]
    {
        software::single(x)
    }
}

#[cfg(all(not(feature = "std"), feature = "libm"))]
use libm_root as software;

#[cfg(all(not(feature = "std"), not(feature = "libm")))]
use integer as software;

#[cfg(all(not(feature = "std"), feature = "libm"))]
mod libm_root {
    #[inline]
    pub(super) fn double(x: f64) -> f64 {
        libm::sqrt(x)
    }

    #[inline]
    pub(super) fn single(x: f32) -> f32 {
        libm::sqrtf(x)
    }
}

#[cfg(any(test, not(any(feature = "std", feature = "libm"))))]
pub(super) mod integer;
