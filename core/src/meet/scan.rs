//! The branches looked at all around: the search in `f32`, and families of solutions.

use core::ops::ControlFlow;

use super::Meet;
use super::beside::Turn;
use super::branch::{BRANCHES, Posed};
use super::search::Stream;
use crate::Transform;
use crate::held_joint::{Outcome, Visitor};
use crate::math::{Scalar, sin_cos};

/// Angles of the held joint at which the branches are looked at.
const PLACES: u16 = 96;
/// Angles at which a branch has to close to be a family.
const FAMILY_PLACES: u16 = 12;
/// The first angle, rad: no round one.
const FIRST: f64 = 0.2718;
/// A branch that misses by no more, where it turns or ends, may close there.
const TOUCH: f64 = 0.02;

impl Meet<f32> {
    /// Streams the candidates for a target, as [`Meet::search`] of `f64` does.
    ///
    /// The product of four branches has too few digits in `f32`. So each branch is looked at by itself at 96 angles:
    /// changes of its sign, its ends, and places where it nearly touches 0. Two roots between two neighboring angles may
    /// be missed: 0.3 to 0.8 percent of all joint vectors are, of arms in `tests`.
    pub fn search(&self, k1: &Transform<f32>, reference: &[f32; 6], visit: &mut Visitor<'_, f32>) -> Outcome {
        let posed = Posed::of(self, k1);
        if !posed.is_finite() {
            return Outcome { is_complete: true };
        }
        let mut stream = Stream::new(&posed, reference, visit);
        Outcome { is_complete: stream.families().is_continue() }
    }
}

impl<T: Scalar> Stream<'_, '_, T> {
    /// Families, in which the held joint is free, at its reference; then all roots of the other branches.
    pub fn families(&mut self) -> ControlFlow<()> {
        let [held, ..] = self.posed.meet.joints;
        let reference = self.reference_of(held);
        // The angle at which a branch is listed: the reference, or the first one at which it is real.
        let mut listed = [None; BRANCHES];
        let mut greatest = [T::ZERO; BRANCHES];
        for place in 0..=FAMILY_PLACES {
            let t = reference + T::TAU * number(place) / number(FAMILY_PLACES);
            for ((branch, listed), greatest) in self.posed.branches(t).iter().zip(&mut listed).zip(&mut greatest) {
                if branch.is_real() {
                    listed.get_or_insert(t);
                    *greatest = greatest.max(branch.miss.abs());
                }
            }
        }
        let zero = T::from_f64(64.0) * T::EPSILON;
        for (branch, (listed, greatest)) in listed.iter_mut().zip(greatest).enumerate() {
            let Some(t) = listed.filter(|_| greatest <= zero) else {
                *listed = None;
                continue;
            };
            let parts = self.posed.parts(sin_cos(t));
            let joints = self.posed.joints(t, &parts, &self.posed.branch(&parts, branch));
            self.offer_joints(joints, branch, 1 << held, true)?;
            self.root = self.root.saturating_add(1);
        }
        let parts = self.posed.parts(sin_cos(reference));
        self.on_axes(reference, &parts)?;
        self.scan(listed.map(|family| family.is_some()))
    }

    /// The roots of each branch that is not a family.
    fn scan(&mut self, is_family: [bool; BRANCHES]) -> ControlFlow<()> {
        let step = T::TAU / number(PLACES);
        let angle = |place: u16| T::from_f64(FIRST) + step * number(place);
        let mut before = self.posed.branches(angle(0) - step);
        let mut here = self.posed.branches(angle(0));
        for place in 0..PLACES {
            let (t, next) = (angle(place), angle(place + 1));
            let after = self.posed.branches(next);
            let trios = before.iter().zip(&here).zip(&after).zip(is_family).enumerate();
            for (branch, (((a, b), c), is_family)) in trios {
                if is_family {
                    continue;
                }
                self.between(branch, (t, *b), (next, *c), T::from_f64(TOUCH))?;
                if let Turn::Misses(at, miss) = self.turning(branch, [(t - step, *a), (t, *b), (next, *c)])?
                    && miss.abs() <= T::from_f64(TOUCH)
                {
                    for side in [-0.3, 0.3] {
                        self.offer(at + T::from_f64(side) * step, branch, true)?;
                    }
                }
            }
            (before, here) = (here, after);
        }
        ControlFlow::Continue(())
    }
}

/// A small number as a scalar.
fn number<T: Scalar>(value: u16) -> T {
    T::from_i32(i32::from(value))
}
