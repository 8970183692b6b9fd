//! Following the branches again with free joints elsewhere.

use super::arm_constants::ArmConstants;
use super::doubts::Doubts;
use super::kernel::branch_state::BranchState;
use super::kernel::tolerances::Tolerances;
use super::levels::{self, Levels};
use super::search::{Search, VIRTUAL};
use crate::math::wrap;
use crate::{Branch, JointMask, Solution};

/// Another member of crossing families is looked for at 1/16 of a turn from its default. If there is one, a further
/// member is looked for at 9/16. Both are odd sixteenths, because families cross at quarters and eighths.
const CROSSINGS: i32 = 2;

/// The purpose of a further run of the cascade.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// A branch that is missed with a free joint at its default.
    Level(levels::Pass),
    /// One more member of crossing families.
    Cross(i32),
}

/// Memory of a search for branches that are missed with a free joint at its default: [`Levels`], or [`Decoupled`] for
/// an arm that has no such branches.
pub trait Missed<T, const M: usize>: Copy {
    /// Nothing yet.
    const NONE: Self;

    /// The remembered branches; `None` for an arm that needs no such passes.
    fn levels(&self) -> Option<&Levels<T, M>>;

    /// The remembered branches, mutable.
    fn levels_mut(&mut self) -> Option<&mut Levels<T, M>>;
}

impl<T: Tolerances, const M: usize> Missed<T, M> for Levels<T, M> {
    const NONE: Self = Levels::NONE;

    #[inline(always)]
    fn levels(&self) -> Option<&Levels<T, M>> {
        Some(self)
    }

    #[inline(always)]
    fn levels_mut(&mut self) -> Option<&mut Levels<T, M>> {
        Some(self)
    }
}

/// An arm on which every stage after a free joint has its roots wherever that joint is. Three joints that follow one
/// another bring a point to its place, one equation each, before a spherical wrist or nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decoupled;

impl<T: Tolerances, const M: usize> Missed<T, M> for Decoupled {
    const NONE: Self = Decoupled;

    #[inline(always)]
    fn levels(&self) -> Option<&Levels<T, M>> {
        None
    }

    #[inline(always)]
    fn levels_mut(&mut self) -> Option<&mut Levels<T, M>> {
        None
    }
}

/// The branches remembered at a pose that needs further passes. Some branches are missed with a free joint at its
/// default, the others have two joints free. Where two joints are free, families of solutions cross. The solution at
/// the defaults does not tell which joints move together on the other family. A second member is looked for elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passes<T, const N: usize, const M: usize, P> {
    pass: Option<Pass>,
    missed: P,
    /// Branches where families cross, with the joints that are free or nearly so there; the first `len`.
    crossings: [(Branch, JointMask); M],
    len: usize,
    /// The joints that are free on crossings.
    crossed: JointMask,
    /// Where joints stay with the free joints at their defaults.
    defaults: [T; N],
    /// The number of solutions after the pass at the defaults, and of exact ones after the last pass.
    at_defaults: usize,
    exact: usize,
}

impl<T: Tolerances, const N: usize, const M: usize, P: Missed<T, M>> Passes<T, N, M, P> {
    fn new(defaults: [T; N]) -> Self {
        Self {
            pass: None,
            missed: P::NONE,
            crossings: [(Branch::NONE, JointMask::NONE); M],
            len: 0,
            crossed: JointMask::NONE,
            defaults,
            at_defaults: 0,
            exact: 0,
        }
    }

    /// Returns true in every pass but the first.
    pub(super) fn again(&self) -> bool {
        self.pass.is_some()
    }

    fn crossings(&self) -> &[(Branch, JointMask)] {
        self.crossings.get(..self.len).unwrap_or(&[])
    }

    /// The joints that are free or nearly so where a branch is missed or two families cross.
    fn free(&self) -> JointMask {
        self.crossed | self.missed.levels().map_or(JointMask::NONE, |levels| levels.free)
    }

    /// Where a joint stays in this pass, given its default value.
    #[cold]
    #[inline(never)]
    pub(super) fn held_at(&self, constants: &ArmConstants<T, N>, joint: usize, default: T) -> T {
        match (self.pass, self.missed.levels()) {
            (Some(Pass::Cross(k)), _) if self.crossed.contains(joint) && !constants.prismatic.contains(joint) => {
                // Each of the free joints at another place.
                let before = self.crossed.iter().filter(|other| *other < joint).count();
                let sixteenths = T::from_i32((1 + 8 * k) * (1 + 2 * before as i32));
                wrap(default + T::TAU * T::from_f64(0.0625) * sixteenths)
            }
            (Some(Pass::Level(pass)), Some(levels)) => levels.held_at(constants, pass, joint, default),
            _ => default,
        }
    }

    /// The pass after this one; `found`: it has found a solution.
    fn following(&self, found: bool) -> Option<Pass> {
        let next = match self.pass {
            Some(Pass::Cross(k)) => return (k + 1 < CROSSINGS && found).then_some(Pass::Cross(k + 1)),
            Some(Pass::Level(pass)) => self.missed.levels().and_then(|levels| levels.after(Some(pass))),
            None => self.missed.levels().and_then(|levels| levels.after(None)),
        };
        next.map(Pass::Level).or((self.len > 0).then_some(Pass::Cross(0)))
    }
}

impl<T: Tolerances, const N: usize, const M: usize, const D: usize, P: Missed<T, M>> Search<'_, T, N, M, D, P> {
    #[inline(never)]
    fn passes(&mut self) -> &mut Passes<T, N, M, P> {
        let defaults = self.defaults;
        self.passes.get_or_insert_with(|| Passes::new(defaults))
    }

    /// Returns true if the solution at the end of a doubtful branch is to be verified in this pass. The solution gets
    /// the name of the open branch that it stands for. A branch that is missed is remembered.
    pub(super) fn is_candidate(
        &mut self,
        state: BranchState,
        doubts: &Doubts<T>,
        solution: &mut Solution<T, N>,
    ) -> bool {
        let branch = solution.branch;
        let pass = self.passes.as_ref().and_then(|passes| passes.pass);
        let samples = matches!(pass, Some(Pass::Level(levels::Pass::Sample { .. } | levels::Pass::Node { .. })));
        if doubts.missed && !samples {
            self.misses_by(&doubts.gap);
        }
        match pass {
            None => {
                if doubts.missed {
                    self.seek(state, doubts, solution, T::INFINITY);
                } else if !doubts.free.is_empty() && doubts.free_or_weak().len() > 1 {
                    // Beside a free joint another one is free, or nearly so.
                    self.cross(doubts, branch);
                }
                !doubts.missed
            }
            Some(Pass::Level(pass)) => {
                let behind = self.levels(state);
                let Some(levels) = self.passes.as_mut().and_then(|passes| passes.missed.levels_mut()) else {
                    return false;
                };
                let listed = |name: Branch| self.solutions.exact().any(|listed| listed.branch == name);
                let name = levels.candidate_name(pass, doubts, &behind, branch, listed);
                solution.branch = name.unwrap_or(branch);
                name.is_some()
            }
            Some(Pass::Cross(_)) => {
                let free_or_weak = doubts.free_or_weak();
                let passes = self.passes();
                let crosses = passes
                    .crossings()
                    .iter()
                    .any(|(name, at_defaults)| *name == branch && *at_defaults != free_or_weak);
                let at_defaults = passes.at_defaults;
                let listed = |s: &Solution<T, N>| s.branch == branch && s.free == doubts.free && s.is_exact();
                !doubts.missed && crosses && !self.solutions.iter().skip(at_defaults).any(listed)
            }
        }
    }

    /// A branch is to be followed again with its free joint elsewhere. With that joint at its default a later stage has
    /// no root, or the solution does not close. `slack`: by how much a joint that is nearly free may move.
    pub(super) fn seek(&mut self, state: BranchState, doubts: &Doubts<T>, solution: &Solution<T, N>, slack: T) {
        if P::NONE.levels().is_none() || self.passes().again() {
            return;
        }
        let behind = self.levels(state);
        if let Some(levels) = self.passes().missed.levels_mut() {
            levels.remember(doubts, &behind, solution.branch, &solution.q, slack);
        }
    }

    /// A branch on which families cross is remembered.
    fn cross(&mut self, doubts: &Doubts<T>, branch: Branch) {
        let passes = self.passes();
        let known = passes.crossings().iter().any(|(name, _)| *name == branch);
        if let Some(slot) = passes.crossings.get_mut(passes.len).filter(|_| !known) {
            *slot = (branch, doubts.free_or_weak());
            passes.len += 1;
            passes.crossed |= doubts.free;
        }
    }

    /// Goes on to the next pass. False if there is none.
    #[cold]
    #[inline(never)]
    pub(super) fn next_pass(&mut self) -> bool {
        let (constants, listed, exact) = (self.constants, self.solutions.len(), self.solutions.exact().count());
        let Some(passes) = &mut self.passes else { return false };
        let found = passes.exact < exact;
        passes.exact = exact;
        match (passes.pass, passes.missed.levels_mut()) {
            (None, _) => passes.at_defaults = listed,
            (Some(Pass::Level(pass)), Some(levels)) => levels.end_pass(constants, &passes.defaults, pass, found),
            _ => {}
        }
        let Some(pass) = passes.following(found) else { return false };
        passes.pass = Some(pass);
        if let (Pass::Level(pass), Some(levels)) = (pass, passes.missed.levels_mut()) {
            levels.start_pass(pass);
        }
        self.nearly_free = passes.free();
        self.virtual_default = passes.held_at(constants, VIRTUAL, T::ZERO);
        for (joint, (slot, default)) in self.defaults.iter_mut().zip(passes.defaults).enumerate() {
            *slot = passes.held_at(constants, joint, default);
        }
        true
    }
}
