//! From the polynomial to candidates.

use core::ops::ControlFlow::{self, Continue};

use super::elimination::{Closed, Elimination};
use super::equations::{Equations, Position};
use crate::held_joint::{Candidate, MOST_CANDIDATES, Visitor};
use crate::math::sin_cos;
use crate::trig_polynomial::{Fit, Root};
use crate::{Outcome, Transform};

/// A polynomial below this share of its usual size is zero everywhere.
const FREE: f64 = 1e-11;
/// Samples that are farther from a polynomial than this, as a share of the greatest, tell nothing.
pub(super) const USELESS: f64 = 1e-5;
/// Beside a doubtful root the function is looked at on either side, at distances from the first of these, rad, ..
const CLOSE: f64 = 3e-7;
/// .. each four times the one before.
const LOOKS: usize = 10;
/// Steps of regula falsi.
const STEPS: usize = 16;
/// A pair of roots that has become complex has its solutions this far beside, rad: no more than two steps away.
const BESIDE: f64 = 2e-4;
/// Where a free joint's reference has no member of the family, these are tried, rad beside it.
const ELSEWHERE: [f64; 8] = [0.0, 2.1, -2.1, 0.7, -0.7, 1.4, -1.4, 2.8];
/// A candidate that closes to this belongs to a family.
const CLOSES: f64 = 1e-4;

/// The search along one cut.
struct Search<'a, 'v> {
    closed: Closed<'a>,
    /// The function with f eliminated first.
    other: Option<Equations>,
    reference: &'a [f64; 6],
    visit: &'a mut Visitor<'v, f64>,
    root: u8,
    is_doubtful: bool,
    /// Joints that are free.
    free: u8,
    /// The least distance from closing of the members of a family.
    least: f64,
}

/// What a cut leaves open.
#[derive(Clone, Copy)]
pub(crate) struct Rest {
    /// Some root is doubtful, or the polynomial could not be found: another cut may find more.
    pub(crate) is_doubtful: bool,
    /// No list was full and no bound was reached.
    pub(crate) is_complete: bool,
    /// The visitor ended the search.
    pub(crate) is_ended: bool,
    /// Of the samples, see [`Fit`].
    pub(crate) greatest: f64,
    pub(crate) wrong: f64,
}

impl Elimination {
    /// The candidates of this cut. A second one leaves out families, which the first has listed.
    pub(crate) fn search(
        &self,
        target: &Transform<f64>,
        reference: &[f64; 6],
        is_second: bool,
        visit: &mut Visitor<'_, f64>,
    ) -> Rest {
        let closed = self.closed(target);
        let fit = Fit::sampled(|held| closed.equations.value(held));
        let Fit { greatest, wrong, .. } = fit;
        let mut rest = Rest { is_doubtful: true, is_complete: true, is_ended: false, greatest, wrong };
        let is_known = wrong.is_finite();
        if !is_known || (is_second && wrong > USELESS) {
            return rest;
        }
        let first = if is_second { MOST_CANDIDATES } else { 0 };
        let mut search = Search {
            closed,
            other: None,
            reference,
            visit,
            root: first as u8,
            is_doubtful: false,
            free: 0,
            least: f64::MAX,
        };
        let is_somewhere = fit.polynomial.size() > FREE * self.scale;
        if !is_somewhere {
            rest.is_ended = !is_second && search.family().is_break();
            return rest;
        }
        let roots = fit.roots();
        rest.is_complete = roots.is_complete;
        rest.is_doubtful = false;
        for (number, root) in roots.as_slice().iter().enumerate() {
            rest.is_doubtful |= root.is_doubtful;
            search.root = (first + number) as u8;
            search.is_doubtful = root.is_doubtful;
            let flow = if root.is_doubtful { search.doubtful(root) } else { search.at(root.sin_cos) };
            if flow.is_break() {
                rest.is_ended = true;
                break;
            }
        }
        rest
    }
}

impl Search<'_, '_> {
    /// Solutions with the held joint at this angle.
    fn at(&mut self, held: (f64, f64)) -> ControlFlow<()> {
        let [e, f] = if self.closed.elimination.cut.is_swapped { [5, 4] } else { [4, 5] };
        let pairs = self.closed.equations.pairs(held, self.reference_of(f));
        let free = if pairs.is_free { self.bit(f) } else { 0 };
        for (first, second) in pairs.list.into_iter().take(pairs.len) {
            self.visit(held, first, second, e < f, free)?;
        }
        Continue(())
    }

    /// As [`Search::at`] with the roles of e and f exchanged: two solutions may share c and f.
    fn at_other(&mut self, held: (f64, f64)) -> ControlFlow<()> {
        let f = if self.closed.elimination.cut.is_swapped { 5 } else { 4 };
        let reference = self.reference_of(f);
        let other = self.other.get_or_insert_with(|| self.closed.equations.swapped());
        let pairs = other.pairs(held, reference);
        let free = if pairs.is_free { self.bit(f) } else { 0 };
        for (first, second) in pairs.list.into_iter().take(pairs.len) {
            self.visit(held, first, second, f == 5, free)?;
        }
        Continue(())
    }

    /// Visits the joints, with e and f or f and e.
    fn visit(
        &mut self,
        held: (f64, f64),
        first: Position,
        second: Position,
        is_in_order: bool,
        free: u8,
    ) -> ControlFlow<()> {
        let (e, f) = if is_in_order { (first, second) } else { (second, first) };
        let joints = self.closed.joints(held, e, f);
        if self.free != 0 {
            self.least = self.least.min(self.closed.residual(&joints));
        }
        let free = free | self.free;
        let candidate = Candidate { joints, root: self.root, signs: None, free, is_doubtful: self.is_doubtful };
        if candidate.is_finite() { (self.visit)(&candidate) } else { Continue(()) }
    }

    /// A root that is double or nearly so. Each value of the function is known far better than its polynomial: the
    /// function itself is looked at on both sides.
    fn doubtful(&mut self, root: &Root) -> ControlFlow<()> {
        self.at(root.sin_cos)?;
        self.at_other(root.sin_cos)?;
        let here = self.value(root.angle);
        for side in [1.0, -1.0] {
            let (mut last, mut distance) = ((root.angle, here), CLOSE);
            for _ in 0..LOOKS {
                let angle = root.angle + side * distance;
                let now = (angle, self.value(angle));
                if last.1 * now.1 <= 0.0 {
                    let zero = between(|angle| self.value(angle), last, now);
                    self.at(sin_cos(zero))?;
                }
                last = now;
                distance *= 4.0;
            }
        }
        self.at(sin_cos(root.angle + BESIDE))?;
        self.at(sin_cos(root.angle - BESIDE))
    }

    fn value(&self, angle: f64) -> f64 {
        self.closed.equations.value(sin_cos(angle))
    }

    /// The polynomial is zero: the held joint is free. Members of the family at the joint's reference, or beside it
    /// where the family has none.
    fn family(&mut self) -> ControlFlow<()> {
        let held = self.closed.elimination.cut.held();
        let reference = self.reference.get(held).copied().unwrap_or(0.0);
        (self.is_doubtful, self.free) = (true, 1 << held);
        for distance in ELSEWHERE {
            let place = sin_cos(reference + distance);
            self.at(place)?;
            self.at_other(place)?;
            if self.least < CLOSES {
                break;
            }
        }
        Continue(())
    }

    /// The joint's reference, in the sense of the cut.
    fn reference_of(&self, place: usize) -> Position {
        let elimination = self.closed.elimination;
        let joint = elimination.cut.order().get(place).copied().unwrap_or(0);
        let value = self.reference.get(joint).copied().unwrap_or(0.0);
        let value = if elimination.cut.is_backward { -value } else { value };
        if elimination.is_prismatic.get(place).copied().unwrap_or(false) {
            Position::Slide(value / elimination.unit)
        } else {
            let (sin, cos) = sin_cos(value);
            Position::Turn(sin, cos)
        }
    }

    fn bit(&self, place: usize) -> u8 {
        1 << self.closed.elimination.cut.order().get(place).copied().unwrap_or(0)
    }
}

/// A zero between two places of different sign: regula falsi, with the older value halved where one end stays.
fn between(value: impl Fn(f64) -> f64, (mut a, mut at_a): (f64, f64), (mut b, mut at_b): (f64, f64)) -> f64 {
    let small = 1e-12 * at_a.abs().max(at_b.abs());
    for _ in 0..STEPS {
        if at_a == at_b {
            break;
        }
        let x = (a * at_b - b * at_a) / (at_b - at_a);
        let at_x = value(x);
        if at_x * at_b <= 0.0 {
            (a, at_a) = (b, at_b);
        } else {
            at_a *= 0.5;
        }
        (b, at_b) = (x, at_x);
        if at_x.abs() < small || (a - b).abs() < 1e-10 {
            break;
        }
    }
    b
}

impl Rest {
    /// The end of a search along one or two cuts.
    pub(super) fn and(self, other: Self) -> Outcome {
        Outcome { is_complete: self.outcome().is_complete && other.outcome().is_complete }
    }

    pub(super) fn outcome(self) -> Outcome {
        Outcome { is_complete: self.is_complete && !self.is_ended }
    }
}
