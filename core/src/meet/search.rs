//! From the polynomial to candidates, in `f64`.

use core::ops::ControlFlow;

use super::Meet;
use super::branch::{BRANCHES, Posed};
use crate::Transform;
use crate::held_joint::{Candidate, Outcome, Visitor};
use crate::math::{Scalar, sin_cos, wrap};
use crate::trig_polynomial::{Fit, MOST_SAMPLES, Root};

/// A polynomial whose greatest sample is below this share of its usual size is zero everywhere.
const FREE: f64 = 1e-11;
/// A branch that misses by no more has a root at a simple root of the polynomial.
const OPEN: f64 = 1e-3;
/// The same at a doubtful root, which is known to some 1e-4 rad only.
const DOUBTFUL_OPEN: f64 = 0.05;
/// A branch that misses by more after its steps has no simple root here.
const SURE: f64 = 1e-11;
/// Another branch that misses so little may have a root beside.
const BESIDE: f64 = 5e-3;

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
        let mut stream = Stream::new(&posed, reference, visit);
        let mut is_complete = true;
        let flow = stream.run(&mut is_complete);
        Outcome { is_complete: is_complete && flow.is_continue() }
    }
}

/// The candidates on their way to the visitor.
pub(super) struct Stream<'a, 'v, T> {
    pub posed: &'a Posed<'a, T>,
    pub reference: &'a [T; 6],
    pub visit: &'a mut Visitor<'v, T>,
    /// The number of the held joint's root.
    pub root: u8,
    /// The last angles and branches that were offered: the neighborhoods of several roots overlap.
    pub offered: [(T, usize); REPEATS],
    /// How many there were.
    pub count: usize,
}

/// Offers that are remembered.
const REPEATS: usize = 24;
/// Offers nearer than this are repeats, rad.
const REPEATED: f64 = 1e-13;

impl<'a, 'v, T: Scalar> Stream<'a, 'v, T> {
    pub fn new(posed: &'a Posed<'a, T>, reference: &'a [T; 6], visit: &'a mut Visitor<'v, T>) -> Self {
        Self { posed, reference, visit, root: 0, offered: [(T::NAN, 0); REPEATS], count: 0 }
    }

    /// Branch `number` at an angle.
    pub fn offer(&mut self, t: T, number: usize, is_doubtful: bool) -> ControlFlow<()> {
        let least = T::from_f64(REPEATED);
        if self.offered.iter().any(|(other, branch)| *branch == number && (t - *other).abs() <= least) {
            return ControlFlow::Continue(());
        }
        if let Some(slot) = self.offered.get_mut(self.count % REPEATS) {
            *slot = (t, number);
        }
        self.count += 1;
        let parts = self.posed.parts(sin_cos(t));
        let joints = self.posed.joints(t, &parts, &self.posed.branch(&parts, number));
        self.offer_joints(joints, number, 0, is_doubtful)
    }

    /// A joint vector of branch `number`.
    pub fn offer_joints(&mut self, joints: [T; 6], number: usize, free: u8, is_doubtful: bool) -> ControlFlow<()> {
        let candidate = Candidate {
            joints: joints.map(wrap),
            root: self.root,
            signs: Some((number & 1 == 0, number & 2 == 0)),
            free,
            is_doubtful,
        };
        if candidate.is_finite() { (self.visit)(&candidate) } else { ControlFlow::Continue(()) }
    }
}

impl Stream<'_, '_, f64> {
    fn run(&mut self, is_complete: &mut bool) -> ControlFlow<()> {
        let mut size = 0.0;
        let mut samples = 0_u32;
        let fit = Fit::sampled(|turn| {
            let (value, scale) = self.posed.product(turn);
            size += scale;
            samples += 1;
            value
        });
        debug_assert!(samples as usize <= MOST_SAMPLES);
        // Not a number counts as zero: W is on an axis for every angle then.
        let is_polynomial = fit.greatest > FREE * size / f64::from(samples);
        if !is_polynomial {
            return self.families();
        }
        let roots = fit.roots();
        *is_complete &= roots.is_complete;
        for root in roots.as_slice() {
            self.at(root)?;
            self.root = self.root.saturating_add(1);
        }
        ControlFlow::Continue(())
    }

    /// All branches that close at a root.
    fn at(&mut self, root: &Root) -> ControlFlow<()> {
        let parts = self.posed.parts(root.sin_cos);
        let branches: [_; BRANCHES] = core::array::from_fn(|number| self.posed.branch(&parts, number));
        let misses = branches.map(|branch| branch.miss.abs());
        let least = misses.iter().fold(f64::MAX, |least, miss| least.min(*miss));
        // A twin that is the same branch, or nearly, is no other one.
        let is_beside = |miss: &f64| *miss < BESIDE && *miss > 1e3 * least + 1e-9;
        let is_doubtful = root.is_double || root.is_doubtful || misses.iter().any(is_beside);
        let limit = if is_doubtful { DOUBTFUL_OPEN } else { OPEN }.max(least);
        let found = if is_doubtful { self.about(root.angle)? } else { [false; BRANCHES] };
        for ((number, branch), is_found) in branches.iter().enumerate().zip(found) {
            // A root that is imaginary is 0 for both signs.
            let is_repeated = (number & 1 == 1 && branch.v == 0.0) || (number & 2 == 2 && branch.w == 0.0);
            let is_open = branch.miss.abs() <= limit;
            if is_repeated || is_found || !is_open {
                continue;
            }
            if is_doubtful {
                let joints = self.posed.joints(root.angle, &parts, branch);
                self.offer_joints(joints, number, 0, true)?;
            } else {
                let (t, miss) = self.posed.sharpened(number, root.angle, branch.miss);
                self.offer(t, number, miss.abs() > SURE)?;
            }
        }
        self.on_axes(root.angle, &parts)
    }
}

impl Posed<'_, f64> {
    /// A simple root of a branch that is nearly known: two steps of the secant method on the branch, which has all its
    /// digits where the polynomial, a product of small numbers, has few.
    ///
    /// Gives the root and what the branch misses there.
    fn sharpened(&self, number: usize, start: f64, miss: f64) -> (f64, f64) {
        const STEP: f64 = 1e-6;
        let (mut near, mut near_miss) = (start, miss);
        let (mut far, mut far_miss) = (start + STEP, self.miss(number, start + STEP));
        for _ in 0..2 {
            let t = near - near_miss * (far - near) / (far_miss - near_miss);
            // False for a quotient that is not a number, too.
            let is_near = (t - start).abs() < 1e-3;
            if !is_near {
                break;
            }
            (far, far_miss) = (near, near_miss);
            (near, near_miss) = (t, self.miss(number, t));
        }
        (near, near_miss)
    }
}
