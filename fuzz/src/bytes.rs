//! Values from bytes: whatever the bytes are, there is one; after the last byte all are zero.

/// Bytes that are not read yet.
#[derive(Debug, Clone)]
pub struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    /// Bytes from the start of `data`.
    pub fn new(data: &'a [u8]) -> Self {
        Self(data)
    }

    /// Returns true if no byte is left.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// A number below `n`, which is at most 256.
    pub fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n
    }

    /// A number of any eight bytes.
    pub fn bits(&mut self) -> f64 {
        f64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    /// A number of 16 bits in `(-1, 1)`.
    pub fn fraction(&mut self) -> f64 {
        f64::from(i16::from_le_bytes([self.byte(), self.byte()])) / 32_768.0
    }

    /// Bytes that are left.
    pub fn rest(&self) -> &'a [u8] {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn after_the_last_byte_all_are_zero() {
        let mut bytes = Bytes::new(&[7, 0, 64]);
        assert_eq!((bytes.below(4), bytes.fraction()), (3, 0.5));
        assert!(bytes.is_empty());
        assert_eq!((bytes.byte(), bytes.bits()), (0, 0.0));
    }
}
