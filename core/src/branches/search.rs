//! From the roots of the polynomial to candidates, in `f64`.

use core::ops::ControlFlow;

use super::{Branch, Branches, COUNT, Stream};
use crate::held_joint::Outcome;
use crate::trig_polynomial::{Fit, Root, Roots};

/// A polynomial whose greatest sample is below this share of its usual size is zero everywhere.
const FREE: f64 = 1e-11;
/// A branch that misses by no more has a root at a simple root of the polynomial.
const OPEN: f64 = 1e-5;
/// A branch that misses by no more may have one at a doubtful root, which is known to some 1e-4 rad only.
const DOUBTFUL_OPEN: f64 = 0.05;
/// A branch that misses by no more has no use for another step.
const CLOSED: f64 = 1e-15;
/// A branch that misses by more after its steps has no simple root here.
const SURE: f64 = 1e-11;
/// A branch whose squares are less is near its end.
const NEAR_END: f64 = 1e-6;
/// Another branch that misses so little may have a root beside.
const BESIDE: f64 = 1e-4;

impl<B: Branches<f64>> Stream<'_, '_, f64, B> {
    /// All candidates.
    pub fn search(&mut self) -> Outcome {
        let mut roots = Roots::default();
        if !self.find_roots(&mut roots) {
            return Outcome { is_complete: self.families().is_continue() };
        }
        let flow = roots.as_slice().iter().try_for_each(|root| {
            self.at(root)?;
            self.root = self.root.saturating_add(1);
            ControlFlow::Continue(())
        });
        Outcome { is_complete: roots.is_complete && flow.is_continue() }
    }

    /// Lists the roots of the polynomial; false if it is zero everywhere. Out of line, as its parts are: samples and pieces are on
    /// the stack for as long as they take.
    #[inline(never)]
    fn find_roots(&self, roots: &mut Roots) -> bool {
        let fit = self.fit();
        if let Some(fit) = &fit {
            fit.find_roots(roots);
        }
        fit.is_some()
    }

    /// The polynomial; `None` if it is zero everywhere.
    #[inline(never)]
    fn fit(&self) -> Option<Fit> {
        let (mut size, mut samples) = (0.0, 0.0);
        let fit = Fit::sampled(|turn| {
            let (value, scale) = self.branches.product(turn);
            size += scale;
            samples += 1.0;
            value
        });
        // Not a number counts as zero: the closed form is singular at every angle then.
        (fit.greatest > FREE * size / samples).then_some(fit)
    }

    /// All branches that close at a root.
    fn at(&mut self, root: &Root) -> ControlFlow<()> {
        let (branches, scale) = self.branches.all_scaled(root.sin_cos);
        let misses = branches.map(|branch| branch.miss.abs());
        let least = misses.iter().fold(f64::MAX, |least, miss| least.min(*miss));
        // A twin that is the same branch, or nearly, is no other one.
        let is_beside = |miss: &f64| *miss < BESIDE && *miss > 1e3 * least + 1e-9;
        let is_doubtful = root.is_double || root.is_doubtful || misses.iter().any(is_beside);
        let limit = if is_doubtful { DOUBTFUL_OPEN } else { OPEN }.max(least);
        let singular = B::singular(self, root.angle, root.sin_cos)?;
        self.is_covered = singular.is_some_and(|(_, is_complete)| is_complete);
        let mut found = [false; COUNT];
        if is_doubtful {
            found = self.about(root.angle, singular.map(|(place, _)| place))?;
            if self.is_covered {
                return ControlFlow::Continue(());
            }
        }
        for ((number, branch), is_found) in branches.iter().enumerate().zip(found) {
            let is_open = branch.miss.abs() <= limit;
            if branch.is_repeated(number) || is_found || !is_open {
                continue;
            }
            if is_doubtful {
                self.offer(root.angle, number, true)?;
            } else {
                // The polynomial is the product of the branches: its slope tells that of the one that vanishes.
                let partners = self.branches.partners(number).iter();
                let others =
                    partners.filter_map(|other| branches.get(*other)).fold(scale, |all, other| all * other.miss);
                let (t, branch) = self.sharpened(number, root.angle, branch, root.slope / others);
                // A root near 0 has fewer digits than its square.
                let is_sure = branch.miss.abs() <= SURE && branch.squares.iter().all(|square| *square >= NEAR_END);
                self.offer(t, number, !is_sure)?;
            }
        }
        ControlFlow::Continue(())
    }

    /// A simple root of a branch that is nearly known: a step of Newton's method and up to two of the secant method on the
    /// branch, which has all its digits where the polynomial, a product of small numbers, has few.
    ///
    /// Gives the root and the branch there.
    fn sharpened(&self, number: usize, start: f64, branch: &Branch<f64>, slope: f64) -> (f64, Branch<f64>) {
        // False for a quotient that is not a number, too.
        let is_near = |t: f64| (t - start).abs() < 1e-3;
        let at = |t: f64| (t, self.branches.branch(number, t));
        let (mut far, newton) = ((start, *branch), start - branch.miss / slope);
        let mut near = at(if is_near(newton) { newton } else { start + 1e-6 });
        for _ in 0..2 {
            if near.1.miss.abs() <= CLOSED {
                break;
            }
            let t = near.0 - near.1.miss * (far.0 - near.0) / (far.1.miss - near.1.miss);
            if !is_near(t) {
                break;
            }
            (far, near) = (near, at(t));
        }
        if near.1.miss.abs() <= far.1.miss.abs() { near } else { far }
    }
}
