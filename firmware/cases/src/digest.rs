//! Digests of results: equal for equal bits.
//!
//! A number that is none counts as one value. Processors make such numbers with different signs and payloads, and no
//! function promises any.

use denhart::numeric::NumericSolution;
use denhart::{
    Acceleration, AnalyticJacobian, AxisAngle, Branch, Euler, Flags, Jacobian, JointMask, Margin, PlanarPose,
    PointAngle, PointAxis, Pose, Quantized, Residual, Solution, Solutions, Status, Twist,
};

/// FNV-1a over words of 32 bits (Fowler, Noll, Vo), with a shift, since that hash leaves low bits to low bits.
#[derive(Debug, Clone, Copy)]
pub struct Digest(u64);

impl Digest {
    /// Of nothing.
    #[must_use]
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds a result.
    pub fn add<B: Bits + ?Sized>(&mut self, value: &B) {
        value.add_to(self);
    }

    fn word(&mut self, word: u32) {
        self.0 = (self.0 ^ u64::from(word)).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 ^= self.0 >> 29;
    }

    /// 32 bits of it.
    #[must_use]
    pub const fn value(self) -> u32 {
        (self.0 ^ (self.0 >> 32)) as u32
    }
}

impl Default for Digest {
    fn default() -> Self {
        Self::new()
    }
}

/// Values that are digested bit by bit.
pub trait Bits {
    /// Adds every bit of the value.
    fn add_to(&self, digest: &mut Digest);
}

impl Bits for f32 {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(if self.is_nan() { f32::NAN.to_bits() } else { self.to_bits() });
    }
}

impl Bits for f64 {
    fn add_to(&self, digest: &mut Digest) {
        let bits = if self.is_nan() { f64::NAN.to_bits() } else { self.to_bits() };
        digest.word(bits as u32);
        digest.word((bits >> 32) as u32);
    }
}

impl Bits for i32 {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(*self as u32);
    }
}

impl Bits for usize {
    fn add_to(&self, digest: &mut Digest) {
        // No count reaches 2^32.
        digest.word(*self as u32);
    }
}

impl Bits for bool {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(u32::from(*self));
    }
}

impl<B: Bits> Bits for [B] {
    fn add_to(&self, digest: &mut Digest) {
        self.len().add_to(digest);
        for value in self {
            value.add_to(digest);
        }
    }
}

impl<B: Bits, const N: usize> Bits for [B; N] {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

impl<B: Bits> Bits for Option<B> {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

/// The fields of a struct, and a tuple, in order.
macro_rules! fields {
    ($([$($generics:tt)*] $type:ty { $($field:tt)* })*) => {
        $(impl<$($generics)*> Bits for $type {
            fn add_to(&self, digest: &mut Digest) {
                $(self.$field.add_to(digest);)*
            }
        })*
    };
}

fields! {
    [A: Bits, B: Bits] (A, B) { 0 1 }
    [T: Bits] Pose<T> { rotation translation }
    [T: Bits, const N: usize] Jacobian<T, N> { rows }
    [T: Bits, const M: usize, const N: usize] AnalyticJacobian<T, M, N> { position orientation margin singular }
    [T: Bits] PointAxis<T> { point axis }
    [T: Bits] PointAngle<T> { point angle }
    [T: Bits] PlanarPose<T> { x y phi }
    [T: Bits] Twist<T> { linear angular }
    [T: Bits] Acceleration<T> { linear angular }
    [T: Bits] Residual<T> { position orientation }
    [T: Bits] Margin<T> { value }
    [T: Bits] Euler<T> { angles singular }
    [T: Bits] AxisAngle<T> { axis angle }
    [T: Bits, const N: usize] Quantized<T, N> { pulses saturated q pose residual }
    [T: Bits, const N: usize] Solution<T, N> { q flags free branch residual }
    [T: Bits, Q: Bits] NumericSolution<T, Q> { q iterations restarts residual }
}

impl Bits for Flags {
    fn add_to(&self, digest: &mut Digest) {
        let all = [Self::EXACT, Self::BOUNDARY, Self::FREE, Self::APPROXIMATE, Self::OUT_OF_LIMITS];
        digest.add(&all.map(|flag| self.contains(flag)));
    }
}

impl Bits for JointMask {
    fn add_to(&self, digest: &mut Digest) {
        for joint in self.iter() {
            joint.add_to(digest);
        }
        self.len().add_to(digest);
    }
}

impl Bits for Branch {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&self.shoulder().map(|part| part as usize));
        digest.add(&self.elbow().map(|part| part as usize));
        digest.add(&self.wrist().map(|part| part as usize));
        digest.add(&self.root().map(usize::from));
    }
}

impl<T: Bits> Bits for Status<T> {
    fn add_to(&self, digest: &mut Digest) {
        match self {
            Self::Reachable => digest.word(1),
            Self::Unreachable { residual } => {
                digest.word(2);
                residual.add_to(digest);
            }
            Self::BadTarget => digest.word(3),
        }
    }
}

impl<T: Bits + Copy, const N: usize, const M: usize> Bits for Solutions<T, N, M> {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
        self.status().add_to(digest);
        self.deviation().add_to(digest);
    }
}

impl<A: Bits, B: Bits> Bits for Result<A, B> {
    fn add_to(&self, digest: &mut Digest) {
        match self {
            Ok(value) => value.add_to(digest),
            Err(error) => error.add_to(digest),
        }
    }
}
