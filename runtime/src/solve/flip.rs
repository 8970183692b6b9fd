//! Wrist flips: a solution that has been verified tells another one.

use core::slice;

use super::Tolerances;
use super::least_squares::wrap_angles;
use crate::{JointMask, Residual};

/// A candidate that has been verified, and what it has become.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Verified<T, const N: usize> {
    /// The joint vector of the closed form.
    pub(super) start: [T; N],
    /// The joint vector after its steps, and what it misses the target by.
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
    /// Whether the joint vector of the closed form was within the tolerance.
    pub(super) close: bool,
    /// Whether there is a flip: there is none with axes a and c in line, where a is free.
    pub(super) has_flip: bool,
}

impl<T: Tolerances, const N: usize> Verified<T, N> {
    /// Becomes the wrist flip of itself if `start` is where that starts. Returns whether it is.
    ///
    /// Axes at right angles in a point: joints `(a + pi, -b, c + pi)` turn the tool as `(a, b, c)` do. The Jacobian of
    /// the flip differs in the sign of the column of b alone. So each step from the flip differs in the sign of b alone,
    /// and its residual is the same. Where all other joints agree, the target leaves two values of b. Two values that
    /// are not equal belong to a flip.
    pub(super) fn flip_to(&mut self, start: &[T; N], [a, b, c]: [usize; 3]) -> bool {
        let mut joints = self.start.iter().zip(start).enumerate();
        let is_flip = joints.all(|(joint, (before, now))| joint == a || joint == c || (joint == b) != (before == now));
        if self.has_flip && is_flip {
            for (joint, side) in [(a, T::ONE), (b, T::MINUS_ONE), (c, T::ONE)] {
                let known = self.q.get_mut(joint).zip(self.start.get(joint).zip(start.get(joint)));
                if let Some((angle, (before, now))) = known {
                    *angle = *now + side * (*angle - *before);
                    wrap_angles(slice::from_mut(angle), JointMask::NONE, JointMask::NONE);
                }
            }
            self.start = *start;
        }
        self.has_flip && is_flip
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOWN: Verified<f64, 4> = Verified {
        start: [0.5, 1.0, 0.25, -2.0],
        q: [0.75, 1.5, 0.375, -2.25],
        residual: Residual { position: 1e-9, orientation: 2e-9 },
        close: true,
        has_flip: true,
    };

    fn flipped(start: [f64; 4]) -> Option<Verified<f64, 4>> {
        let mut verified = KNOWN;
        verified.flip_to(&start, [1, 2, 3]).then_some(verified)
    }

    #[test]
    fn steps_of_a_flip_are_mirrored() {
        let start = [0.5, 1.0 - 3.0, -0.25, -2.0 + 3.0];
        let flip = flipped(start);
        assert_eq!(flip, Some(Verified { start, q: [0.75, -1.5, -0.375, 0.75], ..KNOWN }));
        // And back.
        let mut back = flip.unwrap_or(KNOWN);
        assert!(back.flip_to(&KNOWN.start, [1, 2, 3]));
        assert_eq!(back, KNOWN);
    }

    #[test]
    fn what_is_no_flip_is_not_known() {
        // The middle joint at the same place: both are of one family where axes a and c are in line.
        assert_eq!(flipped([0.5, 0.0, 0.25, -1.0]), None);
        // Another branch of the joints before.
        assert_eq!(flipped([0.625, -2.0, -0.25, 1.0]), None);
        assert_eq!(flipped([f64::NAN, -2.0, -0.25, 1.0]), None);
    }
}
