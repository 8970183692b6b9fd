//! Reproducible random numbers (xorshift; Marsaglia, Journal of Statistical Software 8, 2003).

pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Uniform in [-1, 1).
    pub(super) fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Any finite `f64`, every exponent alike.
    pub(super) fn finite(&mut self) -> f64 {
        loop {
            let value = f64::from_bits(self.bits());
            if value.is_finite() {
                return value;
            }
        }
    }

    /// Any finite `f32`, every exponent alike.
    pub(super) fn finite_single(&mut self) -> f32 {
        loop {
            let value = f32::from_bits((self.bits() >> 32) as u32);
            if value.is_finite() {
                return value;
            }
        }
    }
}
