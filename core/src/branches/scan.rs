//! The branches looked at all around: the search in `f32`, and families of solutions.

use core::ops::ControlFlow;

use super::beside::Turn;
use super::{Branches, COUNT, Stream, bit};
use crate::held_joint::Outcome;
use crate::math::{Scalar, sin_cos};

/// Angles of the held joint at which the branches are looked at.
const PLACES: u16 = 96;
/// Angles at which a branch has to close to be a family.
const FAMILY_PLACES: u16 = 12;
/// The first angle, rad: no round one.
const FIRST: f64 = 0.2718;
/// A branch that misses by no more, where it turns or ends, may close there.
const TOUCH: f64 = 0.02;

impl<T: Scalar, B: Branches<T>> Stream<'_, '_, T, B> {
    /// All candidates without the polynomial.
    pub fn scan(&mut self) -> Outcome {
        Outcome { is_complete: self.families().is_continue() }
    }

    /// Families, in which the held joint is free, at its reference; then all roots of the other branches.
    pub fn families(&mut self) -> ControlFlow<()> {
        let held = self.branches.held();
        let reference = self.reference_of(held);
        // The angle at which a branch is listed: the reference, or the first one at which it is real.
        let mut listed = [None; COUNT];
        let mut greatest = [T::ZERO; COUNT];
        for place in 0..=FAMILY_PLACES {
            let t = reference + T::TAU * number(place) / number(FAMILY_PLACES);
            for ((branch, listed), greatest) in self.branches.all(sin_cos(t)).iter().zip(&mut listed).zip(&mut greatest)
            {
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
            self.offer_joints(self.branches.joints(branch, t), branch, bit(held), true)?;
            self.root = self.root.saturating_add(1);
        }
        B::singular(self, reference, sin_cos(reference))?;
        self.around(listed.map(|family| family.is_some()))
    }

    /// The roots of each branch that is not a family.
    fn around(&mut self, is_family: [bool; COUNT]) -> ControlFlow<()> {
        let step = T::TAU / number(PLACES);
        let angle = |place: u16| T::from_f64(FIRST) + step * number(place);
        let mut before = self.branches.all(sin_cos(angle(0) - step));
        let mut here = self.branches.all(sin_cos(angle(0)));
        for place in 0..PLACES {
            let (t, next) = (angle(place), angle(place + 1));
            let after = self.branches.all(sin_cos(next));
            let trios = before.iter().zip(&here).zip(&after).zip(is_family).enumerate();
            for (branch, (((a, b), c), is_family)) in trios {
                if is_family {
                    continue;
                }
                self.between(branch, (t, *b), (next, *c), T::from_f64(TOUCH))?;
                if let Turn::Misses(at, miss) = self.turning(branch, [(t - step, *a), (t, *b), (next, *c)])?
                    && miss.abs() <= T::from_f64(TOUCH)
                {
                    let aside = T::from_f64(0.3) * step;
                    self.offer(at - aside, branch, true)?;
                    self.offer(at + aside, branch, true)?;
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
