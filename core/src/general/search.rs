//! From the polynomial to candidates.

use core::ops::ControlFlow::{self, Continue};

use super::elimination::{Closed, Elimination};
use super::equations::{Equations, Pairs, Position};
use super::lanes::Two;
use crate::Transform;
use crate::held_joint::{Candidate, MOST_CANDIDATES, Visitor};
use crate::math::{sin_cos, sqrt, wrap};
use crate::trig_polynomial::{Fit, Local, Root, Roots};

/// Samples that are farther from a polynomial than this, as a share of the greatest, tell nothing.
pub(super) const USELESS: f64 = 1e-5;
/// Samples that are farther from a polynomial than this, as a share of the greatest, leave few digits.
const ROUGH: f64 = 1e-9;
/// Below this the rounding of the equations may be all that a polynomial tells.
const SMALL: f64 = 1e-15;
/// About a doubtful root the function is sampled anew, on an arc that ends at these half-angle tangents. If the root is
/// doubtful there as well, the next arc is shorter.
const ARCS: [f64; 4] = [0.12, 1.5e-2, 7e-4, 3e-5];
/// An arc about a root that is somewhere on a piece is longer than the piece.
const WIDER: f64 = 1.2;
/// Roots within this part of an arc are known from its samples.
const INNER: f64 = 0.9;
/// A root that is not doubtful is known so far, rad.
const KNOWN: f64 = 3e-7;
/// Joints are left out unless the ring closes to this ..
const NEAR: f64 = 0.1;
/// .. and to this many square roots of what the root is off by, as beside a fold a joint is off by the square root ..
const ROOTS: f64 = 0.1;
/// .. and so many times what the ring is moved by.
const TIMES: f64 = 20.0;
/// A root is known to this, rad, at best.
const OFF: f64 = 1e-7;
/// The values on a shorter arc have to be better by this factor.
const BETTER: f64 = 0.3;
/// An arc has no root if its values are nowhere less than so many times their rounding.
const CLEAR: f64 = 100.0;
/// The most arcs of one cut.
const MOST_ARCS: usize = 32;
/// Where a free joint's reference has no member of the family, these are tried, rad beside it.
const ELSEWHERE: [f64; 8] = [0.0, 2.1, -2.1, 0.7, -0.7, 1.4, -1.4, 2.8];
/// A joint is free if the ring closes to this ..
const CLOSES: f64 = 1e-5;
/// .. at an angle and so far beside it, rad.
const ASIDE: f64 = 0.01;

/// The most joint vectors that follow from a root without elimination: six of f, two of e at each.
const MOST_NEAR: usize = 12;
/// Joint vectors that differ by less are one, rad or units of length.
const SAME: f64 = 1e-6;

/// Further cuts share the numbers of their roots.
const MOST_NUMBERED: usize = 8;
/// The place of the held joint in the order of the cut.
const HELD: usize = 3;

/// The search along one cut.
struct Search<'a, 'v> {
    closed: Closed<'a>,
    /// The function with f eliminated first.
    other: Option<Equations>,
    /// Arcs that were sampled, at most [`MOST_ARCS`].
    arcs: usize,
    /// A list was full or a bound was reached.
    is_full: bool,
    /// At a root no other joints close the ring.
    is_unsound: bool,
    reference: &'a [f64; 6],
    visit: &'a mut Visitor<'v, f64>,
    root: u8,
    /// The ring differs from the arm's own by this, see [`Part::moved`].
    moved: f64,
    /// Joints that miss to close the ring by more are left out.
    near: f64,
    is_doubtful: bool,
    /// Joint vectors are not visited, only the least distance from closing the ring is kept.
    is_probe: bool,
    least: f64,
    /// The held joint is free.
    has_members: bool,
}

/// The rest that a cut leaves open.
#[derive(Clone, Copy)]
pub(crate) struct Rest {
    /// Some root is doubtful, or the polynomial tells nothing: another cut may find more.
    pub(crate) is_doubtful: bool,
    /// The polynomial is not known, or zero everywhere.
    pub(crate) is_useless: bool,
    /// The polynomial is known to few digits: roots that are near to each other may be gone.
    pub(crate) is_rough: bool,
    /// At some root no other joints close the ring.
    pub(crate) is_unsound: bool,
    /// Members of a family have been listed.
    pub(crate) has_families: bool,
    /// No list was full and no bound was reached.
    pub(crate) is_complete: bool,
    /// The visitor ended the search.
    pub(crate) is_ended: bool,
}

impl Rest {
    /// Of a cut that tells nothing.
    pub(crate) const USELESS: Self = Self {
        is_doubtful: true,
        is_useless: true,
        is_rough: false,
        is_unsound: false,
        has_families: false,
        is_complete: true,
        is_ended: false,
    };
}

/// The part that a cut has in a search.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    /// The number of the cut: its roots are numbered from 24 times this.
    pub(crate) number: usize,
    /// A polynomial that is zero everywhere lists members of a family.
    pub(crate) has_families: bool,
    /// If not 0, a ring beside the arm's own is solved, see [`Elimination::moved`]: no cut serves.
    pub(crate) moved: f64,
}

impl Elimination {
    /// The candidates of this cut.
    pub(crate) fn search(
        &self,
        target: &Transform<f64>,
        reference: &[f64; 6],
        part: Part,
        visit: &mut Visitor<'_, f64>,
    ) -> Rest {
        let moved = if part.moved == 0.0 { None } else { self.moved(part.moved) };
        let closed = moved.as_ref().unwrap_or(self).closed(target);
        let fit = Fit::sampled_in_pairs(|sin, cos| values(&closed.equations, sin, cos));
        let mut rest = Rest { is_rough: fit.wrong > ROUGH, ..Rest::USELESS };
        if !closed.equations.is_finite() {
            return rest;
        }
        let mut search = Search {
            closed,
            other: None,
            arcs: 0,
            is_full: false,
            is_unsound: false,
            reference,
            visit,
            root: (part.number.min(MOST_NUMBERED) * MOST_CANDIDATES) as u8,
            moved: part.moved.abs(),
            near: NEAR,
            is_doubtful: false,
            is_probe: false,
            least: f64::INFINITY,
            has_members: false,
        };
        let is_known = fit.greatest > 0.0 && fit.wrong <= USELESS;
        // The equations are normalized: a polynomial this small may be that of their rounding.
        let is_small = fit.polynomial.size() < SMALL;
        if !is_known || is_small {
            rest.is_ended = part.has_families && search.family().is_break();
            rest.has_families = search.has_members;
            if !is_known || rest.is_ended {
                return rest;
            }
        }
        let roots = fit.roots();
        rest.is_useless = is_small;
        rest.is_ended = search.all(&roots, None, &ARCS).is_break();
        let has_doubts = roots.as_slice().iter().any(|root| is_doubtful(&roots, root));
        rest.is_doubtful = has_doubts || search.is_unsound || is_small;
        rest.is_unsound = search.is_unsound;
        rest.is_complete = !search.is_full;
        rest
    }
}

impl Search<'_, '_> {
    /// Solutions with the held joint at this angle, by elimination. Returns true if all of them close the ring.
    fn at(&mut self, held: (f64, f64)) -> ControlFlow<(), bool> {
        let [e, f] = if self.closed.elimination.cut.is_swapped { [5, 4] } else { [4, 5] };
        let pairs = self.closed.equations.pairs(held, || self.reference_of(f));
        self.visit_pairs(held, &pairs, e, f)
    }

    /// As [`Search::at`] with the roles of e and f exchanged: two solutions may share c and f.
    fn at_other(&mut self, held: (f64, f64)) -> ControlFlow<(), bool> {
        let [e, f] = if self.closed.elimination.cut.is_swapped { [4, 5] } else { [5, 4] };
        let other = self.other.unwrap_or_else(|| self.closed.equations.swapped());
        self.other = Some(other);
        let pairs = other.pairs(held, || self.reference_of(f));
        self.visit_pairs(held, &pairs, e, f)
    }

    /// As [`Search::at`] without elimination. Returns true if a joint vector closes the ring.
    fn without_elimination(&mut self, held: (f64, f64)) -> ControlFlow<(), bool> {
        let [e, f] = if self.closed.elimination.cut.is_swapped { [5, 4] } else { [4, 5] };
        let system = self.closed.equations.held(held);
        let Some(roots) = system.roots() else {
            let close = self.at(held)?;
            return self.at_other(held).map_continue(|others| close || others);
        };
        // The nearest first: one that does not close costs the visitor much.
        let mut found = [Near { miss: self.near, joints: [0.0; 6], free: 0 }; MOST_NEAR];
        for root in roots.as_slice() {
            let at = system.at(root.sin_cos);
            let with = |first: Position, free: u8| {
                let (e, f) = if e < f { (first, at.f) } else { (at.f, first) };
                let joints = self.closed.joints(held, e, f);
                Near { miss: self.closed.residual(&joints), joints, free }
            };
            let one = if at.is_free { with(self.reference_of(e), self.bit(e)) } else { with(at.one, 0) };
            let [second, third] = at.two.map(|e| with(e, 0));
            let are_two = !at.is_free && at.may_be_two && (second.miss < one.miss || third.miss < one.miss);
            let these: &[Near] = if are_two { &[second, third] } else { &[one] };
            these.iter().for_each(|near| insert(&mut found, *near));
        }
        let (near, mut closes) = (self.near, false);
        for Near { joints, free, .. } in found.into_iter().take_while(|found| found.miss < near) {
            closes = true;
            self.pass_on(joints, free)?;
        }
        Continue(closes)
    }

    /// Visits pairs of the joints at places e and f of the cut. Returns true if each of them closes the ring.
    fn visit_pairs(&mut self, held: (f64, f64), pairs: &Pairs, e: usize, f: usize) -> ControlFlow<(), bool> {
        let free = if pairs.is_free { self.bit(f) } else { 0 };
        let mut close = true;
        for (first, second) in pairs.list.into_iter().take(pairs.len) {
            let (e, f) = if e < f { (first, second) } else { (second, first) };
            let joints = self.closed.joints(held, e, f);
            let miss = self.closed.residual(&joints);
            if self.is_probe {
                self.least = self.least.min(miss);
            } else if miss < self.near {
                self.pass_on(joints, free)?;
            } else {
                close = false;
            }
        }
        Continue(close)
    }

    /// Gives the visitor a candidate.
    fn pass_on(&mut self, joints: [f64; 6], free: u8) -> ControlFlow<()> {
        let free = if self.has_members { free | 1 << self.closed.elimination.cut.held() } else { free };
        let candidate = Candidate { joints, root: self.root, signs: None, free, is_doubtful: self.is_doubtful };
        if candidate.is_finite() { (self.visit)(&candidate) } else { Continue(()) }
    }

    /// Solutions at a list of roots. Each value of the function is known far better than its polynomial where several
    /// roots are near: about a doubtful root the function is sampled anew, on the first of `arcs`. `outer` has the roots on
    /// the arc before.
    fn all(&mut self, roots: &Roots, outer: Option<&Roots>, arcs: &[f64]) -> ControlFlow<()> {
        self.is_full |= !roots.is_complete;
        let [half, shorter @ ..] = arcs else {
            return roots.as_slice().iter().try_for_each(|root| self.one(root, roots.off(root)));
        };
        // Those that are known come first: what a doubtful root gives may cost the visitor much.
        for root in roots.as_slice().iter().filter(|root| !is_doubtful(roots, root)) {
            let is_new = outer.is_none_or(|outer| !outer.as_slice().iter().any(|other| is_same(outer, other, root)));
            if is_new {
                self.one(root, roots.off(root))?;
            }
        }
        // The middles of the arcs, and what is known about them, rad.
        let (mut known, mut len) = ([(0.0, 0.0); MOST_ARCS], 0);
        for root in roots.as_slice().iter().filter(|root| is_doubtful(roots, root)) {
            if is_near(root, known.get(..len)) {
                continue;
            }
            self.is_full |= self.arcs >= MOST_ARCS;
            let half = half.max(WIDER * root.spread);
            let inner = if self.arcs < MOST_ARCS { self.sampled_about(root, half, roots.rounding) } else { None };
            match (inner, known.get_mut(len)) {
                (Some(inner), Some(place)) => {
                    *place = (root.angle, INNER * 2.0 * half);
                    len += 1;
                    self.all(&inner, Some(roots), shorter)?;
                }
                _ => self.one(root, roots.off(root))?,
            }
        }
        Continue(())
    }

    /// The roots on an arc about a root; there may be none. None if the samples tell no more than those before, whose values
    /// are `rounding` off, or too little more to tell that there is no root.
    fn sampled_about(&mut self, root: &Root, half: f64, rounding: f64) -> Option<Roots> {
        self.arcs += 1;
        let equations = &self.closed.equations;
        let local = Local::sampled_in_pairs(root.sin_cos, half, |sin, cos| values(equations, sin, cos));
        if local.wrong > USELESS || local.rounding > BETTER * rounding {
            return None;
        }
        let roots = local.roots();
        let tells = !roots.as_slice().is_empty() || local.least > CLEAR * local.rounding;
        tells.then_some(roots)
    }

    /// Solutions at one root, which may be `off` by so much.
    fn one(&mut self, root: &Root, off: f64) -> ControlFlow<()> {
        // Of a ring beside the arm's own the joints are off anyway.
        self.is_doubtful = root.is_doubtful || self.moved > 0.0;
        let near = ROOTS * sqrt(OFF + off) + TIMES * self.moved;
        self.near = if near < NEAR { near } else { NEAR };
        if root.is_doubtful || !self.at(root.sin_cos)? {
            self.is_unsound |= !self.without_elimination(root.sin_cos)?;
        }
        self.root = self.root.saturating_add(1);
        Continue(())
    }

    /// The polynomial is zero, so that its samples are rounding. If the held joint is free, members of the family at its
    /// reference are visited, or beside it where the family has none. Where two axes fall together the polynomial may be
    /// zero without that: then the ring closes nowhere, and nothing is visited.
    fn family(&mut self) -> ControlFlow<()> {
        let reference = self.value_of(HELD);
        (self.is_doubtful, self.near) = (true, NEAR);
        for distance in ELSEWHERE {
            let angle = reference + distance;
            self.has_members = self.least_at(angle) < CLOSES && self.least_at(angle + ASIDE) < CLOSES;
            if self.has_members {
                self.at(sin_cos(angle))?;
                self.at_other(sin_cos(angle))?;
                break;
            }
        }
        Continue(())
    }

    /// The least distance from closing the ring, over the joint vectors with the held joint at this angle.
    fn least_at(&mut self, angle: f64) -> f64 {
        (self.is_probe, self.least) = (true, f64::INFINITY);
        // A probe visits nothing, so nothing ends it.
        let _ = self.at(sin_cos(angle));
        let _ = self.at_other(sin_cos(angle));
        self.is_probe = false;
        self.least
    }

    /// The value of a joint's reference, in the sense of the cut.
    fn value_of(&self, place: usize) -> f64 {
        let cut = self.closed.elimination.cut;
        let value = cut.order().get(place).and_then(|joint| self.reference.get(*joint)).copied().unwrap_or(0.0);
        if cut.is_backward { -value } else { value }
    }

    /// The reference as a position.
    fn reference_of(&self, place: usize) -> Position {
        let (elimination, value) = (self.closed.elimination, self.value_of(place));
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

/// A joint vector near a solution.
#[derive(Clone, Copy)]
struct Near {
    /// The ring misses to close by this.
    miss: f64,
    joints: [f64; 6],
    /// Joints that may take any value, as bits.
    free: u8,
}

/// Inserts a joint vector by its miss. A full list loses its last one. Of two that are one the better stays.
fn insert(list: &mut [Near; MOST_NEAR], mut near: Near) {
    for place in list {
        let is_same = place.joints.iter().zip(near.joints).all(|(x, y)| wrap(x - y).abs() < SAME);
        if near.miss < place.miss {
            core::mem::swap(place, &mut near);
        }
        if is_same {
            return;
        }
    }
}

/// Returns true for a root that is not known, or not known apart from the others.
fn is_doubtful(roots: &Roots, root: &Root) -> bool {
    root.is_doubtful && !roots.is_apart(root)
}

/// Returns true if a root is one that was known from the samples before.
fn is_same(outer: &Roots, other: &Root, root: &Root) -> bool {
    !is_doubtful(outer, other) && wrap(other.angle - root.angle).abs() < KNOWN
}

/// Two values of the function.
#[inline]
fn values(equations: &Equations, sin: [f64; 2], cos: [f64; 2]) -> [f64; 2] {
    let Two(values) = equations.value((Two(sin), Two(cos)));
    values
}

/// Returns true if a root is on one of the arcs, given by their middles and half lengths, rad.
fn is_near(root: &Root, arcs: Option<&[(f64, f64)]>) -> bool {
    arcs.is_some_and(|arcs| arcs.iter().any(|(middle, reach)| wrap(root.angle - middle).abs() <= *reach))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Chain;
    use crate::chain::tests::tilted;
    use crate::general::Cut;

    /// The function of every cut is a polynomial of degree 8: 17 samples tell all others, and the joint vector that
    /// made the target is a root.
    #[test]
    fn the_function_has_no_harmonics_above_eight() {
        let links = [0.3, -1.0, 0.7, 1.5, -0.4, 0.9, 2.0].map(|x| tilted(x, [0.2 * x, 0.1, 0.3 - x]));
        for slide in [None, Some(0), Some(2), Some(5)] {
            let chain = Chain::new(links, core::array::from_fn(|joint| Some(joint) == slide)).gathered();
            let joints = [0.3, -0.8, 0.25, 2.0, -0.1, 1.2];
            let target = chain.pose(&joints);
            let mut count = 0;
            for cut in Cut::OF_ARM.into_iter().chain(Cut::OF_TARGET) {
                let Some(elimination) = Elimination::at(&chain, cut, &target) else {
                    assert!(slide.is_some());
                    continue;
                };
                let closed = elimination.closed(&target);
                let fit = Fit::sampled_in_pairs(|sin, cos| values(&closed.equations, sin, cos));
                // A cut that is badly conditioned here says so at the two checks.
                if fit.wrong > USELESS {
                    continue;
                }
                count += 1;
                let is_off = |i: &i32| {
                    let place = sin_cos(f64::from(*i) * 0.1 + 0.03);
                    (fit.polynomial.at(place).0 - closed.equations.value(place)).abs() > 1e-5 * fit.greatest
                };
                // A further harmonic would show at most angles, a singular elimination near few.
                assert!((0..64).filter(is_off).count() < 4, "{cut:?} {slide:?}");
                let held = if cut.is_backward { -joints[cut.held()] } else { joints[cut.held()] };
                let at_joint = closed.equations.value(sin_cos(held));
                assert!(at_joint.abs() < 1e-6 * fit.greatest, "{cut:?} {slide:?} {at_joint}");
            }
            assert!(count >= 12, "{count}");
        }
    }
}
