//! How far an arm is from a singularity of one kind.

use core::fmt;

/// One factor of the determinant of an arm's Jacobian, as the arm's `margins` gives them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin<T> {
    /// `shoulder`, `elbow`, `wrist`, or the joints (`q1 q3`) of equations that have no such name.
    pub name: &'static str,
    /// Zero exactly at that singularity, of opposite signs on the two branches that meet there, without a unit.
    pub value: T,
}

impl<T> Margin<T> {
    /// A value under its name.
    #[must_use]
    pub const fn new(name: &'static str, value: T) -> Self {
        Self { name, value }
    }
}

impl<T: Copy> Margin<T> {
    /// Writes the values of margins, as far as there is room; gives their number.
    #[doc(hidden)]
    #[inline]
    pub fn write<const K: usize>(margins: &[Self; K], factors: &mut [T]) -> usize {
        for (factor, margin) in factors.iter_mut().zip(margins) {
            *factor = margin.value;
        }
        K
    }
}

/// As in `elbow 0.125`.
impl<T: fmt::Display> fmt::Display for Margin<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ", self.name)?;
        self.value.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    #[test]
    fn display_has_name_and_value() {
        assert_eq!(format!("{:.2}", Margin::new("elbow", 0.125_f64)), "elbow 0.12");
    }
}
