//! Which joint is held, and the search.

use super::branch::Posed;
use crate::Transform;
use crate::branches::Stream;
use crate::chain::Chain;
use crate::held_joint::{Outcome, Visitor};
use crate::math::{Scalar, hypot};

/// A chain with four turning joints and two prismatic ones: see [`slides`](crate::slides).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slides<T> {
    /// The links C0 to C6 of the chain.
    pub links: [Transform<T>; 7],
    /// The turning joints t, x, y, z in the order of the ring, numbered from 0 as in the chain. The first one is held.
    pub turning: [usize; 4],
    /// The prismatic joints in the order of the ring from the held joint on.
    pub prismatic: [usize; 2],
}

/// A product of sines of the angles between neighboring axes that is 0.
const ZERO: f64 = 1e-6;

impl Slides<f64> {
    /// The structure of a chain; `None` if it has not exactly two prismatic joints, or if it is singular everywhere.
    ///
    /// Of the four turning joints that one is held with which the rotation fixes the others best: the product of the sines
    /// of the angles between the axes of x and y, and of y and z, is greatest. An angle that depends on the target counts
    /// as 30 degrees, and the first of equal ones is taken.
    #[must_use]
    pub fn of(chain: &Chain<f64>) -> Option<Self> {
        let mut best: Option<(f64, Self)> = None;
        for held in 0..6 {
            let Some(slides) = Self::holding(chain, held) else { continue };
            let quality = slides.quality();
            if best.is_none_or(|(most, _)| quality > most * (1.0 + 1e-9)) {
                best = Some((quality, slides));
            }
        }
        let (quality, slides) = best?;
        (quality > ZERO).then_some(slides)
    }

    /// The structure with a given turning joint held, numbered from 0; `None` if that joint is prismatic, or if not exactly
    /// two joints are.
    #[must_use]
    pub fn holding(chain: &Chain<f64>, held: usize) -> Option<Self> {
        let is_prismatic = |joint: &usize| chain.is_prismatic.get(*joint).is_some_and(|is_prismatic| *is_prismatic);
        let ring = || (held..held + 6).map(|joint| joint % 6);
        let mut turning = ring().filter(|joint| !is_prismatic(joint));
        let mut prismatic = ring().filter(is_prismatic);
        let slides = Self {
            links: chain.links,
            turning: [turning.next()?, turning.next()?, turning.next()?, turning.next()?],
            prismatic: [prismatic.next()?, prismatic.next()?],
        };
        let [first, ..] = slides.turning;
        (first == held && turning.next().is_none()).then_some(slides)
    }

    /// The product of the sines of the angles between x and y and between y and z.
    fn quality(&self) -> f64 {
        let [_, x, y, z] = self.turning;
        // The links between joints, each with the number of the joint before it; the last one has the target.
        let sine = |from: usize, to: usize| {
            let between = (from..from + 6).map(|joint| joint % 6).take_while(|joint| *joint != to);
            let mut rotation = Transform::IDENTITY;
            for joint in between {
                if joint == 5 {
                    return 0.5;
                }
                rotation = rotation * self.links.get(joint + 1).copied().unwrap_or(Transform::IDENTITY);
            }
            let [x, y, _] = rotation.z();
            hypot(x, y)
        };
        sine(x, y) * sine(y, z)
    }

    /// Streams the candidates for a target: every joint vector that may reach it.
    ///
    /// `reference`: the joint vector whose entries free joints take. Joints are in the order of the chain, rad or units of
    /// length. A sure candidate reaches the target to rounding, a doubtful one is the start of a refinement. No candidate
    /// has a joint that is not finite; a target that is not finite has no candidates.
    pub fn search(&self, target: &Transform<f64>, reference: &[f64; 6], visit: &mut Visitor<'_, f64>) -> Outcome {
        match Posed::of(self, target) {
            Some(posed) => Stream::new(&posed, reference, visit).search(),
            None => Outcome { is_complete: true },
        }
    }
}

impl Slides<f32> {
    /// Streams the candidates for a target, as the search in `f64` does, without any `f64`. Each branch is looked at by
    /// itself at 96 angles: two roots between two neighboring angles may be missed.
    pub fn search(&self, target: &Transform<f32>, reference: &[f32; 6], visit: &mut Visitor<'_, f32>) -> Outcome {
        match Posed::of(self, target) {
            Some(posed) => Stream::new(&posed, reference, visit).scan(),
            None => Outcome { is_complete: true },
        }
    }
}

impl<T: Scalar> Slides<T> {
    /// The link after a joint, of the ring; that after the last joint has the target.
    pub(super) fn link(&self, joint: usize, closing: &Transform<T>) -> Transform<T> {
        self.links.get(joint + 1).copied().filter(|_| joint < 5).unwrap_or(*closing)
    }
}
