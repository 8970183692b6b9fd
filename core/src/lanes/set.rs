//! The instruction sets that lanes are compiled for, and the choice among them while the program runs.

use core::fmt;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::{Avx2, Avx512, Level, Simd, Sse2, f64x2, f64x4, f64x8};

use super::{Four, Lanes};

/// An instruction set that the processor has.
#[derive(Debug, Clone, Copy)]
pub struct InstructionSet(Kind);

#[derive(Debug, Clone, Copy)]
enum Kind {
    /// Four numbers in an array, by the instructions that the target is compiled for.
    Array,
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    Sse2(Sse2),
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    Avx2(Avx2),
    /// That of Ice Lake; older processors with AVX-512 run AVX2.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    Avx512(Avx512),
}

/// A computation over lanes. Its function is `#[inline(always)]`, as everything that it calls.
pub trait Work {
    /// Result of the computation.
    type Output;
    /// Computes it with lanes of one instruction set.
    fn run<L: Lanes>(self, set: L::Set) -> Self::Output;
}

impl InstructionSet {
    /// The widest set of the processor.
    #[must_use]
    pub fn best() -> Self {
        Self::available().into_iter().flatten().last().unwrap_or(Self(Kind::Array))
    }

    /// Every set of the processor, the narrowest first; none in the place of those that it lacks.
    #[must_use]
    pub fn available() -> [Option<Self>; 4] {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            let level = Level::new();
            [
                Some(Self(Kind::Array)),
                level.as_sse2().map(|set| Self(Kind::Sse2(set))),
                level.as_avx2().map(|set| Self(Kind::Avx2(set))),
                level.as_avx512().map(|set| Self(Kind::Avx512(set))),
            ]
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        [Some(Self(Kind::Array)), None, None, None]
    }

    /// Runs a computation with the instructions of the set.
    #[inline]
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self.0 {
            Kind::Array => work.run::<Four>(()),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Sse2(set) => set.vectorize(
                #[inline(always)]
                || work.run::<f64x2<_>>(set),
            ),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Avx2(set) => set.vectorize(
                #[inline(always)]
                || work.run::<f64x4<_>>(set),
            ),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Avx512(set) => set.vectorize(
                #[inline(always)]
                || work.run::<f64x8<_>>(set),
            ),
        }
    }
}

/// As in `AVX2`.
impl fmt::Display for InstructionSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.0 {
            Kind::Array => "array",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Sse2(_) => "SSE2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Avx2(_) => "AVX2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Kind::Avx512(_) => "AVX-512",
        })
    }
}
