//! Random numbers: the same on every machine.

use denhart::Scalar;

/// Marsaglia's xorshift with 64 bits (2003, "Xorshift RNGs", J. Stat. Software 8(14)).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// Of a `seed`; each gives another sequence.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        // Never 0, where the sequence would stay.
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number from 0 to `n` - 1; 0 for `n` = 0.
    pub fn below(&mut self, n: u32) -> u32 {
        ((u64::from((self.bits() >> 32) as u32) * u64::from(n)) >> 32) as u32
    }

    /// Uniform in [0, 1), in steps of 2^-24.
    pub fn unit<T: Scalar>(&mut self) -> T {
        T::from_f64((self.bits() >> 40) as f64 / f64::from(1u32 << 24))
    }

    /// Uniform between `low` and `high`.
    pub fn between<T: Scalar>(&mut self, low: T, high: T) -> T {
        low + (high - low) * self.unit()
    }

    /// Any bits at all as a number: subnormal, infinite, not a number.
    pub fn any<T: Scalar>(&mut self) -> T {
        let bits = self.bits();
        match bits & 7 {
            0 => T::NAN,
            1 => T::INFINITY,
            2 => -T::INFINITY,
            3 => T::MAX,
            4 => T::ZERO,
            // Through single precision, so that either scalar has the same value.
            _ => T::from_f64(f64::from(f32::from_bits((bits >> 32) as u32))),
        }
    }
}
