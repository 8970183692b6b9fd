//! A small seeded generator: the same numbers at every run and on every platform.

/// The FNV-1a hash of a text (Fowler, Noll, Vo).
pub fn digest(text: &str) -> u64 {
    let hash = |h: u64, byte: u8| (h ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, hash)
}

/// xoshiro256++ (Blackman and Vigna 2019), seeded by splitmix64.
#[derive(Debug, Clone)]
pub struct Random([u64; 4]);

impl Random {
    /// A generator that starts at `seed`.
    pub fn new(seed: u64) -> Self {
        let mut state = seed;
        Self(std::array::from_fn(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }))
    }

    /// A generator whose seed is the [`digest`] of a text, such as the name of an arm and of a family.
    pub fn named(text: &str) -> Self {
        Self::new(digest(text))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        let s = &mut self.0;
        let result = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = s[3].rotate_left(45);
        result
    }

    /// Uniform in `low .. high`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 * (0.5_f64).powi(53)
    }

    /// Uniform in `0 .. n`; `n` must be far below 2^64, as the tiny bias of the remainder is left in.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// One of the values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A unit vector, uniform on the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        let z = self.uniform(-1.0, 1.0);
        let (s, c) = self.uniform(-std::f64::consts::PI, std::f64::consts::PI).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * c, r * s, z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_never_change() {
        // First outputs of splitmix64 from seed 0, published with the reference implementation.
        assert_eq!(Random::new(0).0[..2], [0xe220_a839_7b1d_cdaf, 0x6e78_9e6a_a1b9_65f4]);
        let mut random = Random::named("ur5");
        let mut mean = 0.0;
        for _ in 0..10_000 {
            let x = random.uniform(-1.0, 1.0);
            assert!((-1.0..1.0).contains(&x));
            mean += x / 10_000.0;
        }
        assert!(mean.abs() < 0.03, "{mean}");
        assert_ne!(Random::named("ur5").bits(), Random::named("ur3").bits());
    }
}
