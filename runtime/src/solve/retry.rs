//! Further runs of the cascade, with free joints at other places, and iterations from where these come near.
//!
//! A singular target is a regular one with the free joint given. With that joint at a wrong place a later stage of the
//! branch has no root, and the closed form misses by a gap. So the cascade runs again with the free joints at a few
//! places. The joint vectors that miss by least are starts. Steps from these tell where the free joints are to be next, and
//! an iteration finishes.

use super::doubts::Doubts;
use super::kernel::tolerances::Tolerances;
use super::least_squares::Iterate;
use super::search::{Search, VIRTUAL};
use super::verify::{Found, RESERVED};
use crate::effort::MOST_CASCADES;
use crate::math::{atan2, sin_cos, wrap};
use crate::{Branch, Flags, JointMask, Solution};

/// The increments of the free joints, rad. In turns that of the k-th one is the inverse root of `x^(k + 1) = x + 1`, of the
/// first the golden number: multiples of the first few fill a torus evenly. A fifth joint moves as the first one does.
fn increments<T: Tolerances>() -> [T; 4] {
    let [a, b, c, d] = [0.618_033_988_749_895, 0.754_877_666_246_693, 0.819_172_513_396_164, 0.856_674_883_854_503];
    [T::from_f64(a), T::from_f64(b), T::from_f64(c), T::from_f64(d)].map(|turns| T::TAU * turns)
}

/// So many runs hold the joints at multiples of their increments, before steps from starts tell their places.
const MULTIPLES: u8 = 3;

/// So many runs in a row may be without a step. Instead of a further one the call ends.
const MOST_IDLE: u8 = 1;

/// A slide is moved by up to half of so many reaches either way.
const STROKE: f64 = 1.75;

/// A branch is refined again only from a start whose miss is less than this part of the miss refined last.
const MUCH_NEARER: f64 = 1.0 / 64.0;

/// A branch that has no solution with the joints at their defaults.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Open<T, const N: usize> {
    branch: Branch,
    flags: Flags,
    free: JointMask,
    /// The order of the root of its missed stage, see [`Doubts::missed_order`]; 2 without such a stage or if a step has led half
    /// of the way; 0 in an entry that is not used.
    order: u8,
    /// The joints that are free or weak before that stage.
    missed_for: JointMask,
    /// The start: the joint vector of the closed form of least miss so far.
    start: [T; N],
    /// Its miss, relative to reach or rad; infinite without a start.
    miss: T,
    /// True if the second root of the missed stage has been asked for.
    asked: bool,
    /// True if a step has been taken from the start.
    stepped: bool,
    /// A start that misses by less than this is refined. Before the first refinement in a further run every miss is less.
    refine_below: T,
}

/// Memory of a call whose target needs further runs: at most `S` open branches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Retry<T, const N: usize, const M: usize, const S: usize> {
    /// Index of this run; 0 with every joint at its default.
    run: u8,
    /// The multiple of the next run that holds the free joints at multiples of their increments.
    multiple: u8,
    /// The joints that move.
    moving: JointMask,
    /// The open branches first, then entries of order 0 that are not used.
    opens: [Open<T, N>; S],
    /// The branch of which this run is at the second root, see [`other_root`](Search::other_root).
    other: Option<Branch>,
    /// Branches on which two families of solutions may cross at the defaults, and the joints that are free or weak in the family
    /// found last: none of an entry that is not used.
    crossings: [(Branch, JointMask); M],
    /// True if a further run has found another family.
    crossed: bool,
    /// The number of runs in a row that came after a step from every start.
    without_step: u8,
}

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'_, T, N, M, S> {
    #[inline(never)]
    #[allow(clippy::unnecessary_lazy_evaluations, reason = "the memory is large, and most calls find it made")]
    fn retry(&mut self) -> &mut Retry<T, N, M, S> {
        self.retry.get_or_insert_with(|| Retry {
            run: 0,
            multiple: 1,
            moving: JointMask::NONE,
            opens: [Open {
                branch: Branch::NONE,
                flags: Flags::NONE,
                free: JointMask::NONE,
                order: 0,
                missed_for: JointMask::NONE,
                start: [T::ZERO; N],
                miss: T::INFINITY,
                asked: false,
                stepped: false,
                refine_below: T::INFINITY,
            }; S],
            other: None,
            crossings: [(Branch::NONE, JointMask::NONE); M],
            crossed: false,
            without_step: 0,
        })
    }

    /// Returns true in every run but the first.
    pub(super) fn is_again(&self) -> bool {
        self.retry.as_ref().is_some_and(|retry| retry.run > 0)
    }

    /// Returns true if the end of a doubtful branch may lead to a solution that is not listed. A branch on which families of
    /// solutions may cross is remembered.
    pub(super) fn admits(&mut self, doubts: &Doubts<T>, branch: Branch) -> bool {
        let (again, free_or_weak) = (self.is_again(), doubts.free_or_weak());
        if !doubts.is_missed() && self.crosses(branch, doubts.free, free_or_weak) {
            return true;
        }
        let is_other = S > 0 && self.retry.as_ref().is_some_and(|retry| retry.other == Some(branch));
        !(again && (free_or_weak.is_empty() || self.lists(branch) && !is_other))
    }

    /// Returns true if a solution of the second or third run is of another family than the one found last on its branch. The
    /// first run remembers a branch on which two joints are free or weak.
    fn crosses(&mut self, branch: Branch, free: JointMask, free_or_weak: JointMask) -> bool {
        let run = self.retry.as_ref().map_or(0, |retry| retry.run);
        let again = run > 0;
        if run > 2 || !again && (free.is_empty() || free_or_weak.len() < 2) {
            return false;
        }
        let retry = self.retry();
        let mut crossings = retry.crossings.iter_mut();
        let entry = crossings.find(|(name, last)| if last.is_empty() { !again } else { *name == branch });
        let Some((name, last)) = entry.filter(|(_, last)| *last != free_or_weak) else { return false };
        (*name, *last) = (branch, free_or_weak);
        retry.moving |= if again { JointMask::NONE } else { free };
        retry.crossed |= again;
        again
    }

    /// Returns true if a branch has an exact solution.
    #[inline(never)]
    fn lists(&self, branch: Branch) -> bool {
        self.solutions.exact().any(|solution| solution.branch == branch)
    }

    /// The miss below which a branch is refined.
    #[inline(never)]
    pub(super) fn refine_below(&self, branch: Branch) -> T {
        let mut opens = self.retry.iter().flat_map(|retry| &retry.opens);
        opens.find(|open| open.branch == branch).map_or(T::INFINITY, |open| open.refine_below)
    }

    /// Remembers a branch that is missed, and a joint vector on it, which may have been refined.
    #[inline(never)]
    pub(super) fn open(&mut self, doubts: &Doubts<T>, branch: Branch, refined: bool, q: &[T; N]) {
        // At the defaults a miss is often stationary: any other start is preferred.
        let miss = if self.is_again() { self.constants.relative(&doubts.gap) } else { T::MAX };
        let retry = self.retry();
        let entry = retry.opens.iter_mut().find(|open| open.branch == branch || open.order == 0);
        let Some(open) = entry else { return };
        if open.order == 0 {
            (open.branch, open.flags, open.free, open.order) = (branch, doubts.flags, doubts.free, 2);
            if retry.run == 0 {
                retry.moving |= doubts.free_or_weak();
                // A weak joint stays at its default in a run of its own.
                if doubts.weak.iter().any(|joint| !doubts.free.contains(joint)) {
                    retry.multiple = 0;
                }
            }
        }
        if miss < open.miss {
            // A step half of the way to a double root leaves a quarter of the miss, one to a simple root next to nothing.
            let halfway = open.stepped && miss > open.miss * T::from_f64(0.125);
            open.order = if halfway || !doubts.is_missed() { 2 } else { doubts.missed_order };
            open.missed_for = doubts.missed_for;
            (open.start, open.miss, open.stepped) = (*q, miss, false);
            open.refine_below = if refined { miss * T::from_f64(MUCH_NEARER) } else { open.refine_below };
        }
    }

    /// Decides whether another run follows. True: the free joints are at their places. False: what is still open has been
    /// iterated on.
    #[cold]
    #[inline(never)]
    pub(super) fn next_run(&mut self) -> bool {
        let Some(Retry { run, crossings, crossed, .. }) = self.retry else { return false };
        // A second run looks for a third family only if the first has found a second one.
        let crosses = (run == 0 || run == 1 && crossed) && crossings.iter().any(|(_, joints)| !joints.is_empty());
        // Where no step leads on, iteration may lead to the first of two roots.
        let all_stepped = S > 0 && run > MULTIPLES && self.least_missed(|open| !open.stepped).is_none();
        if all_stepped && self.least_missed(|open| open.miss < open.refine_below).is_some_and(|open| open.order == 1) {
            self.iterate(1);
        }
        let is_left = |open: &Open<T, N>| !open.stepped || open.miss < open.refine_below;
        let any = S > 0 && (self.least_missed(is_left).is_some() || self.half_listed().is_some());
        let Some(retry) = &mut self.retry else { return false };
        (retry.run, retry.other) = (run + 1, None);
        retry.without_step = if all_stepped { retry.without_step + 1 } else { 0 };
        if usize::from(retry.run) == MOST_CASCADES || retry.without_step > MOST_IDLE || !(any || crosses) {
            self.iterate(S);
            return false;
        }
        self.place();
        true
    }

    /// The open branch without a solution whose start misses by least, of those for which `counts` is true.
    #[inline(never)]
    fn least_missed(&mut self, counts: fn(&Open<T, N>) -> bool) -> Option<&mut Open<T, N>> {
        let (mut next, mut least) = (None, T::INFINITY);
        for (index, open) in self.retry.as_ref()?.opens.iter().enumerate() {
            if open.miss < least && counts(open) && !self.lists(open.branch) {
                (next, least) = (Some(index), open.miss);
            }
        }
        self.retry.as_mut()?.opens.get_mut(next?)
    }

    /// Moves the free joints to their places in the next run.
    fn place(&mut self) {
        // Without open branches only families that cross need further runs.
        let stepped = if S > 0 { self.other_root().map(|q| (q, None)).or_else(|| self.after_step()) } else { None };
        let (constants, defaults) = (self.constants, self.constants.defaults(self.near));
        let Some(retry) = &mut self.retry else { return };
        self.elsewhere = retry.moving;
        // Where no step leads on, one of several joints moves alone: a family may need the others at their defaults.
        let no_step = S > 0 && retry.run > MULTIPLES && stepped.is_none() && retry.moving.len() > 1;
        let alone = if no_step { usize::from(retry.run).checked_rem(retry.moving.len()) } else { None };
        let is_multiple = stepped.is_none() && alone.is_none();
        let multiple = T::from_i32(if is_multiple { retry.multiple } else { retry.run }.into());
        for ((before, joint), increment) in retry.moving.iter().enumerate().zip(increments::<T>().iter().cycle()) {
            let moves = alone.is_none_or(|alone| alone == before);
            let turn = if moves { wrap(*increment * multiple) } else { T::ZERO };
            if joint == VIRTUAL {
                self.virtual_default = stepped.and_then(|(_, value)| value).unwrap_or(turn);
            } else if let Some((slot, default)) = self.defaults.get_mut(joint).zip(defaults.get(joint)) {
                let slides = constants.prismatic.contains(joint);
                let change = if slides { constants.reach * T::from_f64(STROKE) * turn / T::TAU } else { turn };
                let place = stepped.and_then(|(q, _)| q.get(joint).copied()).unwrap_or(*default + change);
                *slot = if slides { place } else { wrap(place) };
            }
        }
        retry.multiple += u8::from(is_multiple);
    }

    /// The joint vector to which a step leads from the start of least miss that has not been stepped from, and the value of a
    /// virtual joint there. All stages but the missed one hold at a start, and the next run makes them hold again. So that run
    /// takes only the free joints from this vector.
    #[inline(never)]
    fn after_step(&mut self) -> Option<([T; N], Option<T>)> {
        let moving = self.retry.as_ref().filter(|retry| retry.run > MULTIPLES)?.moving;
        if self.evaluations_left <= RESERVED + 1 {
            return None;
        }
        let open = *self.least_missed(|open| !open.stepped)?;
        // Starts of a flip, of roots that fall together, and all at the defaults, miss by as much: one step is enough.
        let opens = &mut self.retry.as_mut()?.opens;
        opens.iter_mut().filter(|same| same.miss == open.miss).for_each(|same| same.stepped = true);
        // To a root of order m a step leads `1 / m` of the way.
        let problem = self.problem();
        let mut iterate = Iterate::at(open.start);
        problem.evaluate(&mut iterate);
        self.evaluations_left -= 1;
        let q = problem.step(&iterate, T::from_i32(open.order.into()), true)?;
        let mut of_virtual = None;
        if moving.contains(VIRTUAL) {
            of_virtual = self.goal.virtual_value(&self.arm.evaluate(&q).0);
            self.evaluations_left -= 1;
        }
        Some((q, of_virtual))
    }

    /// The index of an open branch of which one of two solutions is listed. Such a branch is missed by an equation without a
    /// joint of its own, which has two roots in the one free joint before it.
    fn half_listed(&self) -> Option<usize> {
        let others = self.constants.prismatic | JointMask::single(VIRTUAL);
        let counts = |open: &Open<T, N>| {
            let is_simple = open.order == 1 && open.missed_for.len() == 1 && !open.missed_for.meets(others);
            is_simple && !open.asked && self.lists(open.branch)
        };
        self.retry.as_ref()?.opens.iter().position(counts)
    }

    /// The joint vector with that free joint at the second root `x2`; its value at the listed solution is `x1`.
    ///
    /// A joint that turns moves points on circles, so the equation is `c sin((x - x1) / 2) sin((x - x2) / 2)`. A step from a
    /// start leads from x to `x + d`, and by the derivative of the logarithm `-2 / d = cot((x - x1) / 2) + cot((x - x2) / 2)`.
    #[inline(never)]
    fn other_root(&mut self) -> Option<[T; N]> {
        let (index, problem) = (self.half_listed()?, self.problem());
        let retry = self.retry.as_mut()?;
        let open = retry.opens.get_mut(index)?;
        let Open { branch, start, miss, missed_for, .. } = *open;
        open.asked = true;
        let joint = missed_for.iter().next()?;
        let mut solutions = self.solutions.exact().filter(|solution| solution.branch == branch);
        let (x, first) = (*start.get(joint)?, *solutions.next()?.q.get(joint)?);
        if miss == T::INFINITY || self.evaluations_left <= RESERVED {
            return None;
        }
        let mut iterate = Iterate::at(start);
        problem.evaluate(&mut iterate);
        self.evaluations_left -= 1;
        let mut q = problem.step(&iterate, T::ONE, false)?;
        let (sin, cos) = sin_cos((x - first) * T::HALF);
        let d = *q.get(joint)? - x;
        let way = atan2(T::ONE, -T::TWO / d - cos / sin) * -T::TWO;
        if !way.is_finite() {
            return None;
        }
        retry.other = Some(branch);
        *q.get_mut(joint)? = x + way;
        Some(q)
    }

    /// Iterates from the starts of the open branches, that of least miss first. The solutions that are found are listed; such a
    /// solution may be that of another branch.
    fn iterate(&mut self, most: usize) {
        for _ in 0..most {
            let Some(open) = self.least_missed(|open| open.miss < open.refine_below) else { return };
            open.refine_below = open.miss * T::from_f64(MUCH_NEARER);
            let mut solution = Solution { free: open.free, ..Solution::exact(open.start, open.branch) };
            solution.flags |= open.flags;
            self.verified = None;
            if self.verify(true, true, &mut solution) != Found::Nothing && solution.is_exact() {
                self.list(solution, Found::Guess);
            }
        }
    }
}
