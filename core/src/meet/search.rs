//! The search of [`Meet`] in `f64` and in `f32`.

use core::ops::ControlFlow;

use super::Meet;
use super::branch::Posed;
use crate::Transform;
use crate::branches::{Branch, Branches, COUNT, Stream};
use crate::held_joint::{Outcome, Visitor};
use crate::math::{Scalar, sin_cos};

impl Meet<f64> {
    /// Streams the candidates for a target: every joint vector that may close the ring.
    ///
    /// `k1`: the constant of the ring that holds the target, as [`Structure::ring`](super::Structure::ring) gives it.
    /// `reference`: the joint vector whose entries free joints take, in the order of the chain.
    ///
    /// Candidates come in the order of the roots of the held joint. A sure one closes the chain to rounding. A doubtful
    /// one is the start of a refinement and may lead nowhere, or to a solution that another one gave. No candidate has a
    /// joint that is not finite; a target that is not finite has no candidates.
    pub fn search(&self, k1: &Transform<f64>, reference: &[f64; 6], visit: &mut Visitor<'_, f64>) -> Outcome {
        let posed = Posed::of(self, k1);
        if !posed.is_finite() {
            return Outcome { is_complete: true };
        }
        Stream::new(&posed, reference, visit).search()
    }
}

impl Meet<f32> {
    /// Streams the candidates for a target, as the search in `f64` does, without any `f64`.
    ///
    /// The product of four branches has too few digits in `f32`. So each branch is looked at by itself at 96 angles:
    /// changes of its sign, its ends, and places where it nearly touches 0. Two roots between two neighboring angles may
    /// be missed.
    pub fn search(&self, k1: &Transform<f32>, reference: &[f32; 6], visit: &mut Visitor<'_, f32>) -> Outcome {
        let posed = Posed::of(self, k1);
        if !posed.is_finite() {
            return Outcome { is_complete: true };
        }
        Stream::new(&posed, reference, visit).scan()
    }
}

impl<T: Scalar> Branches<T> for Posed<'_, T> {
    const NARROW: &'static [(usize, usize)] = &[(0, 0), (0, 1), (1, 1)];

    fn held(&self) -> usize {
        let [held, ..] = self.meet.joints;
        held
    }

    #[inline(always)]
    fn product(&self, turn: (T, T)) -> (T, T) {
        self.product_at(turn)
    }

    fn all_scaled(&self, turn: (T, T)) -> ([Branch<T>; COUNT], T) {
        let parts = self.parts(turn);
        (core::array::from_fn(|number| self.signed(&parts, number).branch), self.cleared(&parts))
    }

    fn partners(&self, number: usize) -> &'static [usize] {
        match (self.meet.has_equal_pairs, number) {
            // The branch with the other sign of w; those with the other sign of v are the same.
            (true, 0) => &[2],
            (true, 1) => &[3],
            (true, 2) => &[0],
            (true, _) => &[1],
            (false, 0) => &[1, 2, 3],
            (false, 1) => &[0, 2, 3],
            (false, 2) => &[0, 1, 3],
            (false, _) => &[0, 1, 2],
        }
    }

    fn branch(&self, number: usize, t: T) -> Branch<T> {
        self.signed(&self.parts(sin_cos(t)), number).branch
    }

    fn joints(&self, number: usize, t: T) -> [T; 6] {
        let turn = sin_cos(t);
        let parts = self.parts(turn);
        let signed = self.signed(&parts, number);
        self.joints_about(t, turn, &parts, &signed, self.x2(turn, &parts, signed.v))
    }

    fn signs(number: usize) -> Option<(bool, bool)> {
        Some((number & 1 == 0, number & 2 == 0))
    }

    fn is_singular(&self, t: T) -> bool {
        super::axis::is_on_x2(self, t)
    }

    fn singular(stream: &mut Stream<'_, '_, T, Self>, t: T, turn: (T, T)) -> ControlFlow<(), Option<(T, bool)>> {
        super::axis::on_axes(stream, t, turn)
    }
}
