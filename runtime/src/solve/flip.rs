//! Wrist flips: the solution that differs by a flip follows from the one that has been verified.

use core::slice;

use super::kernel::tolerances::Tolerances;
use super::least_squares::wrap_angles;
use crate::{JointMask, Residual};

/// A candidate that has been verified, and what it has become.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Verified<T, const N: usize> {
    /// The joint vector of the closed form, and its residual.
    pub(super) start: [T; N],
    pub(super) start_residual: Residual<T>,
    /// The joint vector after its steps, and its residual.
    pub(super) q: [T; N],
    pub(super) residual: Residual<T>,
}

impl<T: Tolerances, const N: usize> Verified<T, N> {
    /// Becomes its own wrist flip, which starts at `start`: the other root of the same stage. Angles are in (-pi, pi].
    ///
    /// Axes at right angles in a point: joints `(a + pi, -b, c + pi)` turn the tool as `(a, b, c)` do. The Jacobian of
    /// the flip differs in the sign of the column of b alone. So each step from the flip differs in the sign of b alone,
    /// and its residual is the same.
    pub(super) fn flip_to(&mut self, start: &[T; N], [a, b, c]: [usize; 3]) {
        for (joint, side) in [(a, T::ONE), (b, T::MINUS_ONE), (c, T::ONE)] {
            let known = self.q.get_mut(joint).zip(self.start.get(joint).zip(start.get(joint)));
            if let Some((angle, (before, now))) = known {
                *angle = *now + side * (*angle - *before);
                wrap_angles(slice::from_mut(angle), JointMask::NONE, JointMask::NONE);
            }
        }
        self.start = *start;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_a_flip_are_mirrored() {
        let known = Verified {
            start: [0.5, 1.0, 0.25, -2.0],
            start_residual: Residual { position: 1e-6, orientation: 1e-5 },
            q: [0.75, 1.5, 0.375, -2.25],
            residual: Residual { position: 1e-9, orientation: 2e-9 },
        };
        let mut flip = known;
        let start = [0.5, 1.0 - 3.0, -0.25, -2.0 + 3.0];
        flip.flip_to(&start, [1, 2, 3]);
        assert_eq!(flip, Verified { start, q: [0.75, -1.5, -0.375, 0.75], ..known });
        // And back.
        flip.flip_to(&known.start, [1, 2, 3]);
        assert_eq!(flip, known);
    }
}
