//! The follower that keeps the time.

use super::aspect::Aspect;
use super::bounds::{Bounds, Interval, rounding};
use super::choice::{Candidate, Choice};
use super::deviate::{Aim, TURN, Weights};
use super::settings::{Crossing, FollowError, FollowSettings};
use super::signs::{Factors, Signs, change_of_factors};
use super::step::{Step, Tracking};
use crate::arm::{InverseBranch, InverseKinematics};
use crate::branch::Branch;
use crate::deviation::Deviation;
use crate::dh::JointKind;
use crate::flags::JointMask;
use crate::jacobian::Jacobian;
use crate::math::Scalar;
use crate::pose::Pose;
use crate::solution::{Residual, Solution, Status};
use crate::vector::norm;

/// Follows a target that moves, one step a tick: exact where the rates of the joints allow, else with a deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Follower<T, const N: usize> {
    period: T,
    crossing: Crossing,
    /// Values that come with the target do not count.
    held: bool,
    pub(super) bounds: Bounds<T, N>,
    pub(super) weights: Weights<T, N>,
    /// The arm has factors: each solution of a target has signs of its own.
    has_factors: bool,
    pub(super) q: [T; N],
    /// Pose and Jacobian there, if they have been asked for.
    evaluated: Option<(Pose<T>, Jacobian<T, N>)>,
    /// The size of the smallest factor there, but for that of the wrist, if the last tick was not exact.
    clear: T,
    /// Ticks for which solutions beyond other singularities than that of the wrist are too far to be looked for.
    others_in: T,
    /// The last step, of the motors.
    pub(super) step: [T; N],
    /// The goal of the last tick, if it is on the branch that is followed.
    pub(super) goal: Option<[T; N]>,
    /// The twist that the last tick left to its target.
    pub(super) left: Option<[T; 6]>,
    /// Ticks for which the arm has been on the way to a goal that it can follow, and for which it may be.
    pub(super) under_way: T,
    pub(super) allowed: T,
    /// The branch that is followed.
    wanted: Aspect,
    /// The branch that the joint values are on.
    here: Aspect,
    /// The branch that the arm is sent to, until it is there.
    sent: Option<Branch>,
    /// The branch that was followed before the arm strayed from it, until a solution is reached.
    strayed_from: Option<Aspect>,
    /// Ticks since the last exact one, and on this branch, in which limits or reach have kept the arm from its target.
    stuck: T,
}

/// The branches on which the solution of a tick is looked for first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sought {
    /// All.
    All,
    /// The branch that is followed: an exact tick goes on there.
    Followed(Branch),
    /// The branch that is followed, and the one beyond the singularity of the wrist: others are beyond a step and not allowed,
    /// or they were far when all were looked at.
    EitherWrist(Branch),
}

impl Sought {
    /// The name that the branches share.
    const fn branch(self) -> Branch {
        match self {
            Self::All => Branch::NONE,
            Self::Followed(branch) | Self::EitherWrist(branch) => branch,
        }
    }
}

/// The solutions of a target, as the arm sees them.
enum Seen<T, const N: usize> {
    /// One is reached in this tick.
    Reached(Solution<T, N>, Signs),
    /// None is.
    Apart(Choice<T, N>),
}

/// A way from here on is about half a turn, rad.
const HALF_TURN: f64 = 2.9;

/// Time after which an arm leaves a branch on which limits or reach keep it from its target, s. A goal that is out of
/// limits for half as long comes back where the arm follows a path past a shoulder singularity: to leave earlier costs more way.
const STUCK: f64 = 1.0;

/// Solutions beyond other singularities than that of the wrist are looked for again after this part of the time that the arm
/// takes to the nearest at full rates, and after so many ticks at most.
const APART: f64 = 0.125;
const MOST_UNSEEN: f64 = 15.0;

impl<T: Scalar, const N: usize> Follower<T, N> {
    /// An arm at rest at `q`.
    ///
    /// # Errors
    /// Settings or a start with which no tick is possible.
    pub fn new<A: InverseKinematics<T, N>>(
        arm: &A,
        settings: FollowSettings<T, N>,
        q: &[T; N],
    ) -> Result<Self, FollowError> {
        settings.check(arm, q)?;
        if let Some(limit) = arm.combined_limits().iter().position(|limit| !limit.holds(q)) {
            return Err(FollowError::Combined(limit));
        }
        let here = Aspect::at(arm, q, &mut A::Solutions::default());
        Ok(Self {
            period: settings.period,
            crossing: settings.crossing,
            held: settings.held,
            bounds: Bounds::new(arm, &settings),
            weights: Weights::new(arm, &settings, q),
            has_factors: arm.factors(q, &mut []) > 0,
            q: *q,
            evaluated: None,
            clear: T::ZERO,
            others_in: T::ZERO,
            step: [T::ZERO; N],
            goal: Some(*q),
            left: Some([T::ZERO; 6]),
            under_way: T::ZERO,
            allowed: T::ZERO,
            wanted: here,
            here,
            sent: None,
            strayed_from: None,
            stuck: T::ZERO,
        })
    }

    /// The step towards a target. `found` is overwritten, with the solutions of the branches that the tick has asked for.
    ///
    /// # The longest tick
    /// An exact tick takes the inverse of the branch that is followed. Else two `inverse_near` are the most, and one more where
    /// the branch gets another name. Besides, at most seven evaluations of `factors` for each solution and five more, two of
    /// `deviation`, and `8 N` linear systems of `N` equations.
    pub fn step<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        target: &A::Target,
        found: &mut A::Solutions,
    ) -> Step<T, N> {
        let interval = self.bounds.interval(&self.q, &self.step);
        let mut sought = self.sought::<A>(&interval);
        let mut seen = self.look(arm, target, sought, &self.q, &interval, found);
        if !self.suffices(sought, &seen) {
            sought = Sought::All;
            let from = if self.was_exact() { self.expected() } else { self.q };
            seen = self.look(arm, target, sought, &from, &interval, found);
        }
        if matches!(A::status(found), Status::BadTarget) {
            return self.stop(arm);
        }
        let choice = match seen {
            Seen::Reached(solution, signs) => return self.arrive(arm, &interval, &solution, signs),
            Seen::Apart(choice) => choice,
        };
        self.others_in = match sought {
            Sought::All => self.until_others(found.as_ref()),
            _ => self.others_in - T::ONE,
        };
        let aim = self.choose(arm, target, &choice);
        let mut held = aim.held;
        if let (Tracking::Rates, Some(goal)) = (aim.tracking, &aim.goal) {
            for (joint, (q, way)) in goal.iter().zip(&self.way(goal)).enumerate() {
                if !interval.allows(joint, *q, *way) {
                    held.insert(JointMask::single(joint));
                }
            }
        }
        let step = self.deviate(arm, target, &aim, &interval);
        let step = self.bounds.within_sums(arm, &self.q, &self.step, &interval, step);
        self.advance(step);
        self.goal = aim.goal;
        let crossed = self.note_crossing(arm, Some(target), found);
        let twist = self.deviation(arm, target).twist;
        self.left = Some(twist);
        Step { held, remaining: aim.ticks * self.period, ..self.state(aim.tracking, twist, crossed) }
    }

    /// A step in a tick that has no target: every joint brakes. In a tick that has one, call [`step`](Self::step) alone:
    /// each call is a step of its own.
    pub fn stop<A: InverseKinematics<T, N>>(&mut self, arm: &A) -> Step<T, N> {
        let interval = self.bounds.interval(&self.q, &self.step);
        let rest = interval.rest();
        let step = self.bounds.within_sums(arm, &self.q, &self.step, &interval, rest);
        self.advance(step);
        (self.goal, self.left) = (None, None);
        (self.under_way, self.allowed) = (T::ZERO, T::ZERO);
        let factors = Factors::at(arm, &self.q);
        let signs = factors.signs(arm, &self.q, Some(&arm.target_at(&self.q)));
        self.clear = factors.least(arm.wrist_factor());
        let crossed = self.here.go(arm, signs, |_| Aspect::at(arm, &self.q, &mut A::Solutions::default()));
        Step { remaining: T::INFINITY, ..self.state(Tracking::Target, [T::ZERO; 6], crossed) }
    }

    /// Sends the arm to another branch. From the next tick on the solution there is the goal, through whatever
    /// singularities lie between; it is the only way to a branch that is far. Components unset in `branch` match any.
    pub fn go_to_branch<A: InverseBranch<T, N>>(&mut self, _arm: &A, branch: Branch) {
        self.sent = Some(branch);
    }

    /// The joint values now, rad or length unit.
    #[must_use]
    pub const fn q(&self) -> &[T; N] {
        &self.q
    }

    /// A second, in ticks.
    pub(super) fn second(&self) -> T {
        T::ONE / self.period
    }

    /// The way of the motors to joint values.
    pub(super) fn way(&self, to: &[T; N]) -> [T; N] {
        self.bounds.way(&self.q, to)
    }

    /// Returns true if the last tick was exact.
    fn was_exact(&self) -> bool {
        self.left == Some([T::ZERO; 6])
    }

    /// Returns true if the arm may be at a solution: the last tick left no more than one may miss by, 1e-12 in `f64` and 2e-5 in
    /// `f32`, relative to reach and in rad, or it had no target.
    fn is_on_target(&self) -> bool {
        let exact = if T::EPSILON < T::from_f64(1e-10) { T::from_f64(1e-12) } else { T::from_f64(2e-5) };
        self.left.is_none_or(|left| self.weights.largest(left) <= exact)
    }

    /// Where the joints would be if they went on as they go. Of a family of solutions the accelerations reach the member that is
    /// nearest to it, and not the one at which a free joint stands still.
    fn expected(&self) -> [T; N] {
        self.bounds.after(&self.q, self.step)
    }

    /// The branches on which the solution of this tick is looked for first.
    ///
    /// The names of an arm without `factors` may change on the way, so that another name stands for the branch.
    fn sought<A: InverseKinematics<T, N>>(&self, interval: &Interval<T, N>) -> Sought {
        let takes_held_values = A::TAKES_VALUES && self.held;
        if !self.has_factors || takes_held_values || self.sent.is_some() {
            return Sought::All;
        }
        let followed = self.wanted.branch;
        if self.was_exact() {
            return Sought::Followed(followed);
        }
        let leaves_the_branch = self.here.signs.differ(self.wanted.signs) || self.has_waited();
        let none_is_known = self.goal.is_none() || followed == Branch::NONE;
        if leaves_the_branch || none_is_known || self.bounds.are_linked() {
            return Sought::All;
        }
        let are_beyond = || self.clear > change_of_factors(interval.longest(self.weights.units()));
        if self.others_in >= T::ONE || self.crossing != Crossing::Any && are_beyond() {
            Sought::EitherWrist(followed.with_any_wrist())
        } else {
            Sought::All
        }
    }

    /// The solutions on some branches, next to joint values, as the arm sees them.
    fn look<A: InverseKinematics<T, N>>(
        &self,
        arm: &A,
        target: &A::Target,
        sought: Sought,
        from: &[T; N],
        interval: &Interval<T, N>,
        found: &mut A::Solutions,
    ) -> Seen<T, N> {
        if A::TAKES_VALUES && self.held {
            arm.inverse_near_into(target, from, found);
        } else {
            arm.inverse_branch_near_into(target, sought.branch(), from, self.is_on_target(), found);
        }
        match (self.exact(arm, target, found.as_ref(), interval), sought) {
            (Some((solution, signs)), _) => Seen::Reached(solution, signs),
            (None, Sought::Followed(_)) => Seen::Apart(Choice::NONE),
            (None, _) => Seen::Apart(self.choice(arm, target, found.as_ref())),
        }
    }

    /// Ticks for which solutions beyond other singularities than that of the wrist need no look, after a look at all.
    fn until_others(&self, solutions: &[Solution<T, N>]) -> T {
        let sides = self.wanted.branch.with_any_wrist();
        let nearest = solutions.iter().find(|other| other.is_exact() && !sides.agrees_with(other.branch));
        let ticks = nearest.map_or(T::ZERO, |nearest| self.bounds.ticks(&self.way(&nearest.q)));
        (ticks * T::from_f64(APART)).min(T::from_f64(MOST_UNSEEN))
    }

    /// Returns true if no solution beside those that were sought matters.
    fn suffices(&self, sought: Sought, seen: &Seen<T, N>) -> bool {
        match (sought, seen) {
            (Sought::All | Sought::EitherWrist(_), Seen::Reached(..)) => true,
            (Sought::All, Seen::Apart(_)) => !self.was_exact(),
            (Sought::EitherWrist(_), Seen::Apart(choice)) => choice.own.is_some(),
            (Sought::Followed(_), Seen::Reached(_, signs)) => !signs.differ(self.wanted.signs),
            (Sought::Followed(_), Seen::Apart(_)) => false,
        }
    }

    /// The solution that is reached in this tick: one of the branch that is followed; else any, as two branches meet there.
    fn exact<A: InverseKinematics<T, N>>(
        &self,
        arm: &A,
        target: &A::Target,
        solutions: &[Solution<T, N>],
        interval: &Interval<T, N>,
    ) -> Option<(Solution<T, N>, Signs)> {
        let mut meeting = None;
        let mut own_fits = false;
        for solution in solutions.iter().filter(|solution| solution.is_exact() && solution.is_within_limits()) {
            let way = self.way(&solution.q);
            if !self.fits(arm, &solution.q, &way, interval) {
                continue;
            }
            let signs = Signs::at(arm, &solution.q, Some(target));
            let is_followed = || !signs.differ(self.wanted.signs);
            let own = self.sent.map_or_else(is_followed, |sent| sent.agrees_with(solution.branch));
            own_fits |= own;
            if own && self.follows_on() {
                return Some((*solution, signs));
            }
            if !own && self.sent.is_none() && meeting.is_none() {
                meeting = Some((*solution, signs));
            }
        }
        meeting.filter(|_| !own_fits)
    }

    /// Returns true if the way to a solution is a step that the limits allow, up to rounding.
    fn fits<A: InverseKinematics<T, N>>(&self, arm: &A, q: &[T; N], way: &[T; N], interval: &Interval<T, N>) -> bool {
        let mut joints = q.iter().zip(way).enumerate();
        joints.all(|(joint, (q, way))| interval.allows(joint, *q, *way)) && self.bounds.sums_hold(arm, &self.q, way)
    }

    /// Returns true if the arm is so near to the goal of the last tick that it can go on with the goal's own rate.
    fn follows_on(&self) -> bool {
        let Some(goal) = self.goal else { return self.bounds.change.iter().all(|change| !change.is_finite()) };
        let ways = self.way(&goal);
        ways.iter().zip(&self.bounds.change).zip(&goal).all(|((way, change), q)| way.abs() <= *change + rounding(*q))
    }

    /// Takes the step to a solution.
    fn arrive<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        interval: &Interval<T, N>,
        solution: &Solution<T, N>,
        signs: Signs,
    ) -> Step<T, N> {
        let q = &solution.q;
        self.step = interval.cut(self.way(q));
        (self.q, self.evaluated) = (*q, None);
        self.goal = Some(*q);
        self.left = Some([T::ZERO; 6]);
        (self.under_way, self.allowed) = (T::ZERO, T::ZERO);
        (self.sent, self.strayed_from, self.stuck) = (None, None, T::ZERO);
        let crossed = self.here.arrive(arm, signs, solution);
        self.wanted = self.here;
        self.state(Tracking::Exact, [T::ZERO; 6], crossed)
    }

    /// The goal of this tick.
    fn choose<A: InverseKinematics<T, N>>(&mut self, arm: &A, target: &A::Target, choice: &Choice<T, N>) -> Aim<T, N> {
        let second = self.second();
        let made = choice.made(second);
        let aim =
            made.map_or_else(Aim::out_of_reach, |(candidate, _)| Aim::at(arm, candidate, &self.q, self.goal.as_ref()));
        match made {
            Some((candidate, true)) => self.follow(arm, target, candidate),
            _ if self.is_stuck(&aim) => self.leave(arm, target, choice.other.as_ref()),
            _ => {}
        }
        aim
    }

    /// Follows the branch of a candidate from now on.
    fn follow<A: InverseKinematics<T, N>>(&mut self, arm: &A, target: &A::Target, candidate: &Candidate<T, N>) {
        let signs = Signs::at(arm, &candidate.q, Some(target));
        let named = |signs| Aspect::of(arm, signs, &candidate.q, candidate.branch);
        if self.wanted.go(arm, signs, named).is_none() {
            self.wanted = named(signs);
        }
        self.others_in = T::ZERO;
        self.goal = None;
    }

    /// The nearest solutions on the branch that is followed and on others.
    ///
    /// Of those with its name the one beyond no singularity is on the branch. Names may change on the way; where none has
    /// both, the signs decide.
    fn choice<A: InverseKinematics<T, N>>(
        &self,
        arm: &A,
        target: &A::Target,
        solutions: &[Solution<T, N>],
    ) -> Choice<T, N> {
        let followed = self.wanted.branch;
        let mut choice = Choice::NONE;
        let has_name = self.sent.is_none() && followed != Branch::NONE;
        let ways: &[bool] = if has_name { &[true, false] } else { &[false] };
        for by_name in ways.iter().copied() {
            choice = Choice::NONE;
            for solution in solutions.iter().filter(|solution| solution.is_exact()) {
                let asked = match self.sent {
                    Some(sent) => sent.agrees_with(solution.branch),
                    None => !by_name || solution.branch.with_root(0) == followed,
                };
                let allowed = self.crossing.allows(self.wanted.branch, solution.branch);
                let may_be_other = self.sent.is_none() && solution.is_within_limits() && (allowed || self.has_waited());
                if !asked && !may_be_other {
                    continue;
                }
                let q = self.on_the_turn_of_the_goal(arm, &solution.q);
                let ticks = self.bounds.ticks(&self.way(&q));
                if !choice.takes(ticks) {
                    continue;
                }
                let signs = || Signs::at(arm, &solution.q, Some(target));
                let own = asked && (self.sent.is_some() || !signs().differ(self.wanted.signs));
                // An arm that is beyond a singularity against its settings may stay there rather than wait for ever.
                if own || may_be_other && (allowed || !signs().differ(self.here.signs)) {
                    choice.note(solution, &q, ticks, own);
                }
            }
            if choice.own.is_some() {
                break;
            }
        }
        choice
    }

    /// A solution with each joint that is about half a turn away on the turn of the last goal, if that is inside the limits:
    /// the nearest turn is one or the other there, and an arm that followed it would go back and forth.
    fn on_the_turn_of_the_goal<A: InverseKinematics<T, N>>(&self, arm: &A, solution: &[T; N]) -> [T; N] {
        let (Some(goal), mut q) = (&self.goal, *solution) else { return *solution };
        let now = self.q.iter().zip(goal);
        let joints = arm.limits().into_iter().zip(arm.joint_kinds());
        for ((q, (at, goal)), ([low, high], kind)) in q.iter_mut().zip(now).zip(joints) {
            let way = *q - *at;
            if kind != JointKind::Revolute || way.abs() < T::from_f64(HALF_TURN) {
                continue;
            }
            let turned = *q - T::TAU.copysign(way);
            let nearer = (turned - *goal).abs() < (*q - *goal).abs();
            if nearer && turned >= low && turned <= high && (turned - *at).abs() <= T::from_f64(TURN) {
                *q = turned;
            }
        }
        q
    }

    /// Counts a tick that is not exact. Returns true if limits or reach keep the arm from its target, and have for too long.
    ///
    /// Where a goal is about half a turn away, rates and limits may alternate: ticks of rates do not count.
    fn is_stuck(&mut self, aim: &Aim<T, N>) -> bool {
        if aim.tracking == Tracking::Rates {
            return false;
        }
        self.stuck += T::ONE;
        self.has_waited()
    }

    /// Returns true if the branch that is followed has kept the arm from its target for too long.
    fn has_waited(&self) -> bool {
        self.stuck > T::from_f64(STUCK) * self.second()
    }

    /// Leaves the branch that is followed: for the one from which the arm has strayed, else for that of a solution that
    /// no limit keeps the arm from.
    fn leave<A: InverseKinematics<T, N>>(&mut self, arm: &A, target: &A::Target, other: Option<&Candidate<T, N>>) {
        if let Some(origin) = self.strayed_from.take() {
            (self.wanted, self.stuck) = (origin, T::ZERO);
        } else if let Some(other) = other.filter(|other| Aim::at(arm, other, &self.q, None).tracking == Tracking::Rates)
        {
            self.follow(arm, target, other);
            self.stuck = T::ZERO;
        }
    }

    /// The deviation from a target at the joint values now, which are evaluated once for all targets.
    pub(super) fn deviation<A: InverseKinematics<T, N>>(&mut self, arm: &A, target: &A::Target) -> Deviation<T, N> {
        let Self { evaluated, q, .. } = self;
        arm.deviation(q, target, evaluated.get_or_insert_with(|| arm.forward_and_jacobian(q)))
    }

    /// Moves the joints by a step of the motors.
    fn advance(&mut self, step: [T; N]) {
        self.evaluated = None;
        self.q = self.bounds.after(&self.q, step);
        self.step = step;
    }

    /// The branch that was left, if the last step led through a singularity.
    fn note_crossing<A: InverseKinematics<T, N>>(
        &mut self,
        arm: &A,
        target: Option<&A::Target>,
        found: &mut A::Solutions,
    ) -> Option<Branch> {
        let left = self.here;
        let factors = Factors::at(arm, &self.q);
        self.clear = factors.least(arm.wrist_factor());
        let signs = factors.signs(arm, &self.q, target);
        let crossed = self.here.go(arm, signs, |signs| match signs.differ(self.wanted.signs) {
            true => Aspect::at(arm, &self.q, found),
            false => self.wanted,
        });
        if crossed.is_none() && self.here.may_be_completed(&factors) {
            self.here.complete(&Aspect::at(arm, &self.q, found));
            if !self.here.signs.differ(self.wanted.signs) {
                self.wanted = self.here;
            }
        }
        let crossed = crossed?;
        let signs = self.here.signs;
        // Who left the branch that was followed, while its solution fled, follows the one that was entered.
        let strayed = !left.signs.differ(self.wanted.signs) && signs.differ(self.wanted.signs);
        if strayed && self.sent.is_none() && self.crossing.allows(self.wanted.branch, self.here.branch) {
            (self.strayed_from, self.stuck) = (Some(self.wanted), T::ZERO);
            self.wanted = self.here;
            self.goal = None;
        }
        Some(crossed)
    }

    /// The answer to a tick, without what a deviation has besides.
    fn state(&self, tracking: Tracking, twist: [T; 6], crossed: Option<Branch>) -> Step<T, N> {
        let [x, y, z, turns @ ..] = twist;
        let period = self.period;
        Step {
            q: self.q,
            velocity: self.bounds.to_joints(self.step).map(|step| step / period),
            tracking,
            deviation: twist,
            residual: Residual { position: norm([x, y, z]), orientation: norm(turns) },
            branch: self.here.branch,
            crossed: crossed
                .filter(|left| self.has_factors || *left != Branch::NONE || self.here.branch != Branch::NONE),
            held: JointMask::NONE,
            remaining: T::ZERO,
        }
    }
}
