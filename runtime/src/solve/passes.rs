//! Following the branches again with a free joint elsewhere.

use super::place::{NODES, PLACES, Roots, Samples, stroke, turn};
use super::stage::Level;
use super::{Facts, Search, Tolerances, Trail};
use crate::math::wrap;
use crate::{Branch, JointMask, Solution};

/// A slide is sampled at home and this many reaches either way.
const STROKE: f64 = 2.0 / 3.0;
/// Where other members of crossing families are looked for, in turns from home: odd sixteenths, because families cross
/// at quarters and eighths.
const CROSSINGS: [f64; 2] = [1.0 / 16.0, 9.0 / 16.0];

/// What a further run of the nest is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// The level at one of three or five places of the first or second free joint; nothing is listed.
    Sample { second: bool, place: usize },
    /// The place of one open branch; again, with a stage after the one that misses.
    Open { index: usize, again: bool },
    /// The level of that stage at one of five nodes; nothing is listed.
    Node { index: usize, node: usize },
    /// One more member of crossing families.
    Cross(usize),
}

/// A branch that is still to be met.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Open<T> {
    branch: Branch,
    /// Where families of solutions cross: the joints that are free or nearly so there.
    crossing: Option<JointMask>,
    /// The first joint that is free or nearly so, and another one.
    joints: [JointMask; 2],
    /// The levels of the stage that misses.
    samples: Samples<T>,
    /// Those of the stage after that, and the interval in which the first one has roots.
    roots: Roots<T>,
    span: [T; 2],
    /// How far the free joints are from home at the branch's place, in turns or strokes.
    steps: [T; 2],
    /// Whether that place is known, and whether the stage has roots there.
    known: bool,
    feasible: bool,
    /// Whether a solution has been found there.
    met: bool,
    /// Where a joint that is nearly free has been, and how far it may move from there without moving the tool; infinite
    /// for a joint that is free.
    value: T,
    slack: T,
}

impl<T: Tolerances> Open<T> {
    /// Goes to a place of the interval: its middle and a share of half its width.
    fn go(&mut self, share: T) {
        let [middle, half] = self.span;
        let [first, _] = &mut self.steps;
        *first = (middle + half * share) / T::TAU;
    }

    /// Whether the stage that misses has roots in an interval.
    fn spans(&self) -> bool {
        let [_, half] = self.span;
        half > T::COINCIDENT
    }

    /// Whether two joints may move.
    fn two(&self) -> bool {
        let [_, second] = self.joints;
        !second.is_empty()
    }

    const NONE: Self = Self {
        branch: Branch::NONE,
        crossing: None,
        joints: [JointMask::NONE; 2],
        samples: Samples::NONE,
        roots: Roots::NONE,
        span: [T::ZERO; 2],
        steps: [T::ZERO; 2],
        known: false,
        feasible: false,
        met: false,
        value: T::ZERO,
        slack: T::INFINITY,
    };
}

/// The branches on which a joint is free or nearly so, and which are missed with that joint at home. Such a branch has
/// roots for an interval of the joint, or at one place alone: a stretched elbow that every other place of the joint
/// would have to stretch more. Three runs of the nest tell the level of the stage that misses, and with that the place.
/// Behind a slide the level is of degree 2, and five runs tell it. Five more tell the level of a second stage, where the
/// first one alone does not lead to a solution.
///
/// A branch may also be met at home just where another stage is singular: there families of solutions cross, and the one
/// at home does not tell which joints move together on the other. A second member is looked for elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passes<T, const N: usize, const M: usize> {
    pass: Option<Pass>,
    /// How far the free joints are from home in this pass, in turns or strokes.
    steps: [T; 2],
    /// The joints that are free or nearly so on open branches.
    free: JointMask,
    /// Of these the first ones, and others: those that either step moves.
    moving: [JointMask; 2],
    /// The joints that are free on crossings.
    crossed: JointMask,
    /// Whether every level that misses is of degree 1 in its joint: no slide follows the joint.
    simple: bool,
    /// Open branches, the first `len`.
    open: [Open<T>; M],
    len: usize,
    /// Where joints stay with the free joints at home.
    homes: [T; N],
    /// The number of solutions after the pass at home, and of exact ones after the last pass.
    at_home: usize,
    exact: usize,
}

impl<T: Tolerances, const N: usize, const M: usize> Passes<T, N, M> {
    fn new(homes: [T; N]) -> Self {
        let (steps, free) = ([T::ZERO; 2], JointMask::NONE);
        Self {
            pass: None,
            steps,
            free,
            moving: [free; 2],
            crossed: free,
            simple: true,
            open: [Open::NONE; M],
            len: 0,
            homes,
            at_home: 0,
            exact: 0,
        }
    }

    /// Whether this is not the first pass.
    pub(super) fn again(&self) -> bool {
        self.pass.is_some()
    }

    fn open(&self) -> &[Open<T>] {
        self.open.get(..self.len).unwrap_or(&[])
    }

    fn open_mut(&mut self) -> &mut [Open<T>] {
        self.open.get_mut(..self.len).unwrap_or(&mut [])
    }

    /// Below which amplitude a joint is free: on the way to an open branch, also if it is nearly free.
    #[cold]
    #[inline(never)]
    pub(super) fn free_below(&self, joint: usize) -> T {
        if self.free.contains(joint) && self.pass.is_some() { T::WEAK } else { T::VANISHING }
    }

    /// Where a joint stays in this pass, given its home.
    #[cold]
    #[inline(never)]
    pub(super) fn away(&self, facts: &Facts<T, N>, joint: usize, home: T) -> T {
        if let (Some(Pass::Cross(_)), [step, _]) = (self.pass, self.steps) {
            // Each of the free joints at another place.
            let before = self.crossed.iter().filter(|other| *other < joint).count();
            let moves = self.crossed.contains(joint) && !facts.prismatic.contains(joint);
            return if moves { wrap(home + T::TAU * step * T::from_i32(2 * before as i32 + 1)) } else { home };
        }
        let moved = self.moving.iter().zip(self.steps).find(|(moving, _)| moving.contains(joint));
        let step = moved.map_or(T::ZERO, |(_, step)| step);
        let step = match self.pass {
            Some(Pass::Sample { second, place }) if !step.is_finite() => {
                if facts.prismatic.contains(joint) {
                    stroke(place)
                } else {
                    turn::<T>(self.places(second), place) / T::TAU
                }
            }
            _ => step,
        };
        if facts.prismatic.contains(joint) {
            home + facts.reach * T::from_f64(STROKE) * step
        } else {
            wrap(home + T::TAU * step)
        }
    }

    /// Remembers a branch that is missed at home, or on a crossing there.
    fn remember(&mut self, open: Open<T>, free: JointMask, crossed: JointMask) {
        let known = |other: &Open<T>| match (other.crossing, open.crossing) {
            (None, None) => same(other.branch, open.branch, true),
            (Some(_), Some(_)) => other.branch == open.branch,
            _ => false,
        };
        if self.open().iter().any(known) {
            return;
        }
        if let Some(slot) = self.open.get_mut(self.len) {
            *slot = open;
            self.len += 1;
            if open.crossing.is_some() {
                self.free |= crossed;
                self.crossed |= crossed;
                return;
            }
            self.free |= free;
            for (moving, joint) in self.moving.iter_mut().zip(open.joints) {
                *moving |= joint;
            }
        }
    }

    /// The number of places at which a joint is sampled: three for levels of degree 1, and for the second joint, so that
    /// all passes together keep to their bound.
    fn places(&self, second: bool) -> usize {
        if second || self.simple { 3 } else { PLACES }
    }

    /// The place of every open branch from the levels at the sampled places of a free joint.
    #[inline(never)]
    fn locate(&mut self, facts: &Facts<T, N>, second: bool) {
        let (steps, homes, count) = (self.steps, self.homes, self.places(second));
        for open in self.open_mut().iter_mut().filter(|open| !open.feasible && open.crossing.is_none()) {
            let [one, other] = open.joints;
            let Some(joint) = (if second { other } else { one }).iter().next() else { continue };
            let home = homes.get(joint).copied().unwrap_or(T::ZERO);
            let now = if open.slack < T::INFINITY && !second { open.value } else { home };
            let place = if facts.prismatic.contains(joint) {
                open.samples.sliding((now - home) / (facts.reach * T::from_f64(STROKE)))
            } else {
                open.samples.turning(count, wrap(now - home), open.slack)
            };
            if second || place.is_none() {
                open.samples = Samples::NONE;
            }
            let Some(place) = place else { continue };
            let [first, _] = steps;
            open.steps = if second { [first, place.step] } else { [place.step, T::ZERO] };
            (open.known, open.span) = (true, place.span);
            open.feasible = place.feasible;
        }
    }

    /// The pass after this one.
    #[inline(never)]
    fn following(&self) -> Option<Pass> {
        let place = |from: usize| {
            let mut rest = self.open().iter().enumerate().skip(from);
            rest.find(|(_, open)| open.known && open.crossing.is_none())
                .map(|(index, _)| Pass::Open { index, again: false })
        };
        let after = |from: usize| {
            let mut rest = self.open().iter().enumerate().skip(from);
            rest.find(|(_, open)| !open.met && open.spans()).map(|(index, _)| Pass::Node { index, node: 0 })
        };
        let crossing = self.open().iter().any(|open| open.crossing.is_some()).then_some(Pass::Cross(0));
        let seek = self.open().iter().any(|open| open.crossing.is_none());
        match self.pass {
            None if seek => Some(Pass::Sample { second: false, place: 0 }),
            None => crossing,
            Some(Pass::Sample { second, place }) if place + 1 < self.places(second) => {
                Some(Pass::Sample { second, place: place + 1 })
            }
            Some(Pass::Sample { second: false, .. })
                if self.open().iter().any(|open| open.crossing.is_none() && !open.feasible && open.two()) =>
            {
                Some(Pass::Sample { second: true, place: 0 })
            }
            Some(Pass::Sample { .. }) => place(0).or(crossing),
            Some(Pass::Open { index, again: false }) => place(index + 1).or(after(0)).or(crossing),
            Some(Pass::Node { index, node }) if node + 1 < NODES.len() => Some(Pass::Node { index, node: node + 1 }),
            Some(Pass::Node { index, .. }) => Some(Pass::Open { index, again: true }),
            Some(Pass::Open { index, again: true }) => after(index + 1).or(crossing),
            Some(Pass::Cross(k)) => (k + 1 < CROSSINGS.len()).then_some(Pass::Cross(k + 1)),
        }
    }
}

/// Whether two names are those of one branch, whichever way the elbow bends, and without `wrist` whichever way the
/// wrist does.
fn same(a: Branch, b: Branch, wrist: bool) -> bool {
    a.shoulder() == b.shoulder() && a.root() == b.root() && (!wrist || a.wrist() == b.wrist())
}

impl<T: Tolerances, const N: usize, const M: usize> Search<'_, T, N, M> {
    fn passes(&mut self) -> &mut Passes<T, N, M> {
        let homes = self.homes;
        self.passes.get_or_insert_with(|| Passes::new(homes))
    }

    /// The first pass, with every free joint at home.
    fn at_home(&self) -> bool {
        self.passes.as_ref().is_none_or(|passes| passes.pass.is_none())
    }

    /// Whether the solution at the end of a doubtful branch is to be verified in this pass. Its branch gets the name of
    /// the open branch that it stands for. A branch that is missed is remembered.
    pub(super) fn takes(&mut self, trail: &Trail<T>, solution: &mut Solution<T, N>) -> bool {
        let branch = solution.branch;
        if trail.missed && !matches!(self.pass(), Some(Pass::Sample { .. })) {
            self.misses(trail.gap.position.max(trail.gap.orientation));
        }
        match self.pass() {
            None => {
                if trail.missed {
                    self.seek(trail, solution, T::INFINITY);
                } else if !trail.free.is_empty() && trail.loose().len() > 1 {
                    // Beside a free joint another one is free, or nearly so.
                    self.remember(trail, solution, T::INFINITY, Some(trail.loose()));
                }
                !trail.missed
            }
            Some(Pass::Sample { place, .. }) => {
                for exact in [true, false] {
                    for open in self.passes().open_mut().iter_mut().filter(|open| same(open.branch, branch, exact)) {
                        open.samples.keep(place, &trail.level, exact);
                    }
                }
                false
            }
            Some(Pass::Node { index, node }) => {
                let open = self.passes().open_mut().get_mut(index);
                if let Some(open) = open.filter(|open| open.joints.contains(&trail.first)) {
                    open.roots.keep(node, &trail.then);
                }
                false
            }
            Some(Pass::Open { index, again }) => {
                let Some(open) = self.passes().open().get(index).copied() else { return false };
                if !(again && open.joints.contains(&trail.first) || same(open.branch, branch, false)) {
                    return false;
                }
                if let Some(wrist) = open.branch.wrist() {
                    solution.branch = branch.with_wrist(wrist);
                }
                !self.solutions.exact().any(|listed| listed.branch == solution.branch)
            }
            Some(Pass::Cross(_)) => {
                let loose = trail.loose();
                let crosses =
                    |open: &Open<T>| open.branch == branch && open.crossing.is_some_and(|at_home| at_home != loose);
                let passes = self.passes();
                let (crosses, at_home) = (passes.open().iter().any(crosses), passes.at_home);
                let listed = |s: &Solution<T, N>| s.branch == branch && s.free == trail.free && s.is_exact();
                !trail.missed && crosses && !self.solutions.iter().skip(at_home).any(listed)
            }
        }
    }

    fn pass(&self) -> Option<Pass> {
        self.passes.as_ref().and_then(|passes| passes.pass)
    }

    /// A branch is to be followed again with its free joint elsewhere: a later stage has no root with that joint at home,
    /// or the solution does not close there. `slack`: by how much a joint that is nearly free may move.
    pub(super) fn seek(&mut self, trail: &Trail<T>, solution: &Solution<T, N>, slack: T) {
        if self.at_home() {
            self.remember(trail, solution, slack, None);
        }
    }

    fn remember(&mut self, trail: &Trail<T>, solution: &Solution<T, N>, slack: T, crossing: Option<JointMask>) {
        let (first, loose) = (trail.first.iter().next(), trail.loose());
        let value = first.and_then(|joint| solution.q.get(joint)).copied().unwrap_or(T::ZERO);
        let single = |joint: Option<usize>| joint.map_or(JointMask::NONE, JointMask::single);
        let joints = [single(first), single(loose.iter().find(|joint| Some(*joint) != first))];
        let open = Open { branch: solution.branch, crossing, joints, value, slack, ..Open::NONE };
        let Level { low, high, pole, .. } = trail.level;
        let simple = crossing.is_some() || low < T::ZERO && high < T::MAX && pole == T::ONE;
        self.passes().simple &= simple;
        self.passes().remember(open, loose, trail.free);
    }

    /// Goes on to the next pass. False if there is none.
    #[cold]
    #[inline(never)]
    pub(super) fn next_pass(&mut self) -> bool {
        let (facts, listed, exact) = (self.facts, self.solutions.len(), self.solutions.exact().count());
        let Some(passes) = &mut self.passes else { return false };
        let met = passes.exact < exact;
        passes.exact = exact;
        match passes.pass {
            None => passes.at_home = listed,
            Some(Pass::Open { index, .. }) => {
                if let Some(open) = passes.open_mut().get_mut(index) {
                    open.met |= met;
                }
            }
            Some(Pass::Sample { second, place }) if place + 1 == passes.places(second) => {
                passes.locate(facts, second);
            }
            Some(Pass::Node { index, node }) if node + 1 == NODES.len() => {
                if let Some(open) = passes.open_mut().get_mut(index)
                    && let Some(cosine) = open.roots.place(&open.samples, open.span)
                {
                    open.go(cosine);
                }
            }
            _ => {}
        }
        let Some(pass) = passes.following() else { return false };
        passes.pass = Some(pass);
        passes.steps = match pass {
            Pass::Sample { second, .. } => {
                // The second joint, with the first one where the first open branch has it.
                let open = passes.open().iter().find(|open| !open.feasible && open.crossing.is_none() && open.two());
                let [first, _] = open.map_or([T::ZERO; 2], |open| open.steps);
                if second { [first, T::NAN] } else { [T::NAN, T::ZERO] }
            }
            Pass::Node { index, node } => {
                let cosine = T::from_f64(NODES.get(node).copied().unwrap_or(0.0));
                if let Some(open) = passes.open_mut().get_mut(index) {
                    open.go(cosine);
                }
                passes.open().get(index).map_or([T::ZERO; 2], |open| open.steps)
            }
            Pass::Open { index, .. } => passes.open().get(index).map_or([T::ZERO; 2], |open| open.steps),
            Pass::Cross(k) => {
                let step = T::from_f64(CROSSINGS.get(k).copied().unwrap_or(0.0));
                [step, T::ZERO]
            }
        };
        let passes = *passes;
        for (joint, (slot, home)) in self.homes.iter_mut().zip(passes.homes).enumerate() {
            *slot = passes.away(facts, joint, home);
        }
        true
    }
}
