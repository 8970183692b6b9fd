//! Further runs of the cascade, with free joints at other places, and iterations from where these come near.
//!
//! A singular target is a regular one with the free joint given. With that joint at a wrong place a later stage of the
//! branch has no root, and the closed form misses by a gap. So the cascade runs again with the free joints at a few
//! places. The joint vectors that miss by least are the starts of an iteration.

use super::doubts::Doubts;
use super::kernel::tolerances::Tolerances;
use super::least_squares::Iterate;
use super::open_branch::{Open, Place, SAMPLES, Start};
use super::search::{Search, VIRTUAL};
use super::verify::RESERVED;
use crate::effort::MOST_CASCADES;
use crate::math::wrap;
use crate::{Branch, Flags, JointMask, Solution};

/// The step of a free joint, rad, if so many `before` it move too. In turns it is the inverse root of `x^k = x + 1`, for
/// k = 2 the golden number: multiples of the first few fill a torus evenly.
fn step<T: Tolerances>(before: usize) -> T {
    T::TAU
        * match before {
            0 => T::from_f64(0.618_033_988_749_895),
            1 => T::from_f64(0.754_877_666_246_693),
            2 => T::from_f64(0.819_172_513_396_164),
            _ => T::from_f64(0.856_674_883_854_503),
        }
}

/// So many runs after the first one hold the joints at multiples of their steps, before steps from starts tell their places.
const MULTIPLES: u8 = 5;

/// A slide is moved by up to half of so many reaches either way.
const STROKE: f64 = 1.75;

/// Where the free joints are in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Held<T> {
    /// At multiples of their steps from the defaults.
    Multiple,
    /// The joint of the open branch `index` at the place that its levels tell. `expected`: the level there; `level`: that of the
    /// run, NaN before.
    Told { index: usize, expected: T, level: T },
    /// Where a step from a start leads, or one joint alone off its default.
    Other,
}

/// Memory of a call whose target needs further runs: at most `S` open branches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Retry<T, const N: usize, const M: usize, const S: usize> {
    /// Index of this run; 0 with every joint at its default.
    run: u8,
    /// The free joints are moved by so many steps.
    multiple: u8,
    /// The joints that move.
    moving: JointMask,
    /// The open branches, the first `len`.
    opens: [Open<T, N>; S],
    len: usize,
    held: Held<T>,
    /// Branches on which two families of solutions may cross, and the joints that are free or weak there: two at least, none of an
    /// entry that is not used.
    crossings: [(Branch, JointMask); M],
    /// The number of solutions after the run at the defaults.
    at_defaults: usize,
}

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Retry<T, N, M, S> {
    fn opens(&mut self) -> &mut [Open<T, N>] {
        self.opens.get_mut(..self.len).unwrap_or(&mut [])
    }
}

impl<T: Tolerances, const N: usize, const M: usize, const D: usize, const S: usize> Search<'_, T, N, M, D, S> {
    #[inline(never)]
    #[allow(clippy::unnecessary_lazy_evaluations, reason = "the memory is large, and most calls find it made")]
    fn retry(&mut self) -> &mut Retry<T, N, M, S> {
        self.retry.get_or_insert_with(|| Retry {
            run: 0,
            multiple: 0,
            moving: JointMask::NONE,
            opens: [Open::NONE; S],
            len: 0,
            held: Held::Multiple,
            crossings: [(Branch::NONE, JointMask::NONE); M],
            at_defaults: 0,
        })
    }

    /// Returns true in every run but the first.
    pub(super) fn is_again(&self) -> bool {
        self.retry.as_ref().is_some_and(|retry| retry.run > 0)
    }

    /// Returns true if the solution at the end of a doubtful branch is to be verified in this run. A branch that is
    /// missed is remembered, and so is one on which families of solutions may cross.
    pub(super) fn is_candidate(&mut self, doubts: &Doubts<T>, solution: &Solution<T, N>) -> bool {
        let (again, free_or_weak) = (self.is_again(), doubts.free_or_weak());
        if doubts.is_missed() {
            self.misses_by(&doubts.gap);
        } else if !again && !doubts.free.is_empty() && free_or_weak.len() > 1 {
            self.cross(doubts, solution.branch);
        }
        if again {
            let crosses = !doubts.is_missed() && self.crosses(doubts, solution);
            if crosses
                || free_or_weak.is_empty()
                || self.lists(solution.branch) && !self.is_at_second_place(solution.branch)
            {
                return crosses;
            }
        }
        if S > 0 && doubts.is_missed() {
            let miss = if again { self.constants.relative(&doubts.gap) } else { T::MAX };
            self.open(doubts, solution.branch, miss, &solution.q);
        }
        !doubts.is_missed()
    }

    /// Returns true if this run is at the second place of an equation without a joint of its own.
    fn is_at_second_place(&self, branch: Branch) -> bool {
        let Some(Retry { held: Held::Told { index, .. }, opens, .. }) = &self.retry else { return false };
        opens.get(*index).is_some_and(|open| open.branch == branch && open.place == Place::ToldTwice)
    }

    /// Returns true if a branch has an exact solution.
    #[inline(never)]
    fn lists(&self, branch: Branch) -> bool {
        self.solutions.exact().any(|solution| solution.branch == branch)
    }

    /// Drops the solution of a branch that closes only within the tolerance with its free joint at the default.
    pub(super) fn drop_near_miss(&mut self, branch: Branch) {
        let listed = self.solutions.len();
        let near_miss = Flags::APPROXIMATE | Flags::FREE;
        self.solutions.retain(|other| !(other.branch == branch && other.flags.contains(near_miss)));
        let dropped = listed - self.solutions.len();
        if let Some(retry) = &mut self.retry {
            retry.at_defaults = retry.at_defaults.saturating_sub(dropped);
        }
    }

    /// Remembers a branch that is missed, and a joint vector on it. At the defaults the miss is often stationary: any
    /// other start is a better one, and `miss` is the largest number.
    #[inline(never)]
    pub(super) fn open(&mut self, doubts: &Doubts<T>, branch: Branch, miss: T, q: &[T; N]) {
        let prismatic = self.constants.prismatic;
        let retry = self.retry();
        let len = retry.len;
        let index = retry.opens().iter().position(|open| open.branch == branch).unwrap_or(len);
        let Some(open) = retry.opens.get_mut(index) else { return };
        if index == len {
            *open = Open { branch, flags: doubts.flags, free: doubts.free, ..Open::NONE };
            if retry.run == 0 {
                retry.moving |= doubts.free_or_weak();
            }
            retry.len += 1;
        }
        if open.place == Place::Untold {
            open.joint = if doubts.is_missed() { doubts.missed_for } else { doubts.free_or_weak() };
            if open.joint.len() == 1 && !open.joint.meets(prismatic) {
                open.place = Place::Sampled;
            }
        }
        // Where a slide is free too, the equation that is missed may be another one: a sample of its level lacks.
        let lacks = retry.held == Held::Multiple
            && open.place == Place::Sampled
            && open.sample(retry.multiple).is_some_and(|level| !level.is_finite());
        if open.place != Place::Untold && doubts.is_missed() && (open.way == 0 || lacks) {
            open.way = doubts.missed_at;
            open.is_jointless = doubts.is_jointless;
            (open.first, open.levels) = (retry.multiple, [T::NAN; SAMPLES]);
            open.levels[0] = doubts.level;
        }
        open.keep(Start { miss, q: *q });
    }

    /// Notes the level of a stage, by the way there, on the open branches that miss this stage.
    #[cold]
    #[inline(never)]
    pub(super) fn sample(&mut self, way: u32, level: T) {
        let Some(retry) = &mut self.retry else { return };
        let multiple = retry.multiple;
        match &mut retry.held {
            Held::Multiple => {
                let samples = retry.opens().iter_mut().filter(|open| open.way == way);
                samples.filter_map(|open| open.sample(multiple)).for_each(|sample| *sample = level);
            }
            Held::Told { index, level: of_run, .. } => {
                if retry.opens.get(*index).is_some_and(|open| open.way == way) {
                    *of_run = level;
                }
            }
            Held::Other => {}
        }
    }

    /// Remembers a branch on which families may cross.
    fn cross(&mut self, doubts: &Doubts<T>, branch: Branch) {
        let retry = self.retry();
        let entry = retry.crossings.iter_mut().find(|(name, joints)| *name == branch || joints.is_empty());
        if let Some((name, joints)) = entry
            && joints.is_empty()
        {
            (*name, *joints) = (branch, doubts.free_or_weak());
            retry.moving |= doubts.free;
        }
    }

    /// Returns true if a solution is of another family than the one at the defaults, and is not listed yet.
    fn crosses(&self, doubts: &Doubts<T>, solution: &Solution<T, N>) -> bool {
        let branch = solution.branch;
        let listed = |s: &Solution<T, N>| s.branch == branch && s.free == doubts.free && s.is_exact();
        let Some(retry) = &self.retry else { return false };
        let of_branch = |(name, joints): &(Branch, JointMask)| *name == branch && !joints.is_empty();
        let at_defaults = retry.crossings.iter().find(|crossing| of_branch(crossing));
        at_defaults.is_some_and(|(_, joints)| *joints != doubts.free_or_weak())
            && !self.solutions.iter().skip(retry.at_defaults).any(listed)
    }

    /// Moves the free joints to their places in the next run. False if there is none; then what is still open has been
    /// iterated on.
    #[cold]
    #[inline(never)]
    pub(super) fn next_run(&mut self) -> bool {
        let listed = self.solutions.len();
        let Some(retry) = &mut self.retry else { return false };
        if retry.run == 0 {
            retry.at_defaults = listed;
            // A weak joint stays at its default in a run of its own.
            let weak = retry.opens().iter().any(|open| open.joint.iter().any(|joint| !open.free.contains(joint)));
            retry.multiple = u8::from(!weak);
        } else if retry.held == Held::Multiple {
            retry.multiple += 1;
        }
        // A second run looks for a third family only if the first has found a second one.
        let crosses = retry.crossings.iter().any(|(_, joints)| !joints.is_empty());
        let crosses = crosses && (retry.run == 0 || retry.run == 1 && listed > retry.at_defaults);
        if S > 0
            && let Held::Told { index, expected, level } = retry.held
            && let Some(open) = retry.opens.get_mut(index)
        {
            if open.is_beyond(expected, level) {
                open.place = Place::Nowhere;
            }
            self.iterate(Some(index));
        }
        let any = self.next_open(None, false).is_some();
        let Some(retry) = &mut self.retry else { return false };
        // An equation that determines the free joint of a branch has a second root.
        let any = any || retry.opens().iter().any(|open| open.has_second_place());
        retry.run += 1;
        if usize::from(retry.run) == MOST_CASCADES || !(any || crosses) {
            self.iterate(None);
            return false;
        }
        self.doubts = None;
        self.place();
        true
    }

    /// The index of the open branch whose start misses by least. `only`: of this one. `unstepped`: of those whose first start has not
    /// been stepped from.
    #[inline(never)]
    fn next_open(&self, only: Option<usize>, unstepped: bool) -> Option<usize> {
        let (mut next, mut least) = (None, T::INFINITY);
        for (index, open) in self.retry.as_ref()?.opens.iter().enumerate() {
            let [Start { miss, .. }, _] = open.starts;
            let asked = only.is_none_or(|only| only == index) && !(unstepped && open.stepped);
            if asked && miss < least && open.place != Place::Nowhere && !self.lists(open.branch) {
                (next, least) = (Some(index), miss);
            }
        }
        next
    }

    /// Moves the free joints to their places in the next run.
    fn place(&mut self) {
        // Without open branches only families that cross need further runs.
        let told = if S > 0 { self.told() } else { None };
        let stepped = if S > 0 && told.is_none() { self.stepped() } else { None };
        let (constants, defaults) = (self.constants, self.constants.defaults(self.near));
        let Some(retry) = &mut self.retry else { return };
        self.nearly_free = retry.moving;
        // Where no step leads on, one of several joints moves alone: a family may need the others at their defaults.
        let ends = S > 0 && retry.run > MULTIPLES && stepped.is_none() && retry.moving.len() > 1;
        let alone = if ends { usize::from(retry.run).checked_rem(retry.moving.len()) } else { None };
        let is_multiple = stepped.is_none() && alone.is_none();
        // A step does not tell where a virtual joint is to be.
        let multiple = T::from_i32(if is_multiple { retry.multiple } else { retry.run }.into());
        for (before, joint) in retry.moving.iter().enumerate() {
            let turn = match told {
                None if alone.is_some_and(|alone| alone != before) => T::ZERO,
                None => wrap(step::<T>(before) * multiple),
                Some((turned, x)) if turned.contains(joint) => x,
                Some(_) => T::ZERO,
            };
            if joint == VIRTUAL {
                self.virtual_default = turn;
            } else if let Some((slot, default)) = self.defaults.get_mut(joint).zip(defaults.get(joint)) {
                *slot = if let Some(q) = stepped {
                    q.get(joint).copied().unwrap_or(*default)
                } else if constants.prismatic.contains(joint) {
                    *default + constants.reach * T::from_f64(STROKE) * turn / T::TAU
                } else {
                    wrap(*default + turn)
                };
            }
        }
        if told.is_none() {
            retry.held = if is_multiple { Held::Multiple } else { Held::Other };
        }
    }

    /// The joint that an open branch's levels tell next, and its place, rad from the default.
    fn told(&mut self) -> Option<(JointMask, T)> {
        let retry = self.retry.as_mut()?;
        for (index, open) in retry.opens.iter_mut().take(retry.len).enumerate() {
            let listed = self.solutions.exact().any(|solution| solution.branch == open.branch);
            let before = retry.moving.iter().position(|joint| open.joint.contains(joint)).unwrap_or(0);
            if let Some([x, expected]) = open.next_place(step(before), retry.multiple, listed) {
                retry.held = Held::Told { index, expected, level: T::NAN };
                return Some((open.joint, x));
            }
        }
        None
    }

    /// The joint vector to which a step from the start of least miss leads that has not been stepped from. The stages that the branch
    /// does not miss hold at a start, so the next run needs of the step the places of the free joints alone. There the missed
    /// stage has a double root, as an elbow that just reaches. A step goes half of the way to such a root, so it is made twice as long.
    #[inline(never)]
    fn stepped(&mut self) -> Option<[T; N]> {
        let retry = self.retry.as_ref()?;
        let begins = retry.run > MULTIPLES && self.evaluations_left > RESERVED;
        let index = if begins { self.next_open(None, true)? } else { return None };
        let open = self.retry.as_mut()?.opens.get_mut(index)?;
        open.stepped = true;
        let [Start { q, .. }, _] = open.starts;
        let times = if open.is_jointless { T::ONE } else { T::TWO };
        let mut iterate = Iterate::at(q);
        iterate.evaluate(self.constants, self.goal, self.arm);
        self.evaluations_left -= 1;
        iterate.step(self.constants, self.goal.given(), times)
    }

    /// Iterates from the start of an open branch, or from those of all of them: those of least miss first.
    fn iterate(&mut self, only: Option<usize>) {
        for _ in 0..2 * S {
            let next = self.next_open(only, false);
            let Some(open) = next.and_then(|index| self.retry.as_mut()?.opens.get_mut(index)) else { return };
            let [first, second] = &mut open.starts;
            let mut solution = Solution::exact(first.q, open.branch);
            solution.flags |= open.flags;
            solution.free = open.free;
            (*first, second.miss) = (*second, T::INFINITY);
            open.stepped = false;
            self.iterated(&mut solution);
            if only.is_some() {
                return;
            }
        }
    }
}
