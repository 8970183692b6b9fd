//! Families of cases.

use denhart::{Branch, JointKind, Scalar, Status};

use crate::aim::Aim;
use crate::{Case, CaseOf, Random, Subject};

/// Family of a case: the kind of its target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Joint values uniform within the limits.
    Random,
    /// All joint values multiples of 90 degrees.
    Grid,
    /// Each joint value with even odds a multiple of 90 degrees: most such poses are singular.
    Singular,
    /// Pushed out from a random pose, by 1e-6 to 10 times its distance; some to just inside the edge.
    OutOfReach,
    /// A rotation that is off, by 1e-7 to 1e-2.
    Drifted,
    /// Any bits in any number: not a number, infinite, huge.
    Absurd,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Random, Self::Grid, Self::Singular, Self::OutOfReach, Self::Drifted, Self::Absurd];

    /// In tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Grid => "grid",
            Self::Singular => "singular",
            Self::OutOfReach => "out-of-reach",
            Self::Drifted => "drifted",
            Self::Absurd => "nan",
        }
    }
}

/// Makes the cases of an arm, always the same ones.
#[derive(Debug, Clone)]
pub struct Maker {
    random: Random,
}

impl Maker {
    /// Of a `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { random: Random::new(seed) }
    }

    /// The next case of a family.
    pub fn case<S, T, const N: usize>(&mut self, arm: &S, family: Family) -> CaseOf<S, T, N>
    where
        S: Subject<T, N>,
        S::Target: Aim<T>,
        T: Scalar,
    {
        let mut q = [T::ZERO; N];
        for ((q, limits), kind) in q.iter_mut().zip(S::LIMITS).zip(S::JOINT_KINDS) {
            let right = match family {
                Family::Grid => true,
                Family::Singular => self.random.below(2) == 0,
                _ => false,
            };
            *q = self.joint(limits, kind, right);
        }
        let pose = arm.forward(&q);
        let target = aim(arm, &q, S::GIVEN);
        let mut case = Case {
            q,
            target,
            pose,
            qd: [T::ZERO; N].map(|_| self.random.between(-T::ONE, T::ONE)),
            qdd: [T::ZERO; N].map(|_| self.random.between(-T::ONE, T::ONE)),
            q_ref: q.map(|q| q + self.random.between(-T::HALF, T::HALF)),
            branch: Branch::NONE,
            samples: 3,
            pulses: [0; N].map(|_| (self.random.bits() >> 32) as i32),
            motor: q,
        };
        let solutions = arm.inverse(&target);
        let (solutions, which) = (solutions.as_ref(), self.random.below(8) as usize);
        case.branch = solutions.get(which).or(solutions.first()).map_or(Branch::NONE, |solution| solution.branch);
        match family {
            Family::OutOfReach => case.target = self.out_of_reach(arm, target),
            Family::Drifted => {
                let size: T = self.power(-7, 5);
                let random = &mut self.random;
                case.target = target.changed(&mut |x| x + random.between(-size, size));
            }
            Family::Absurd => self.absurd(&mut case),
            Family::Random | Family::Grid | Family::Singular => {}
        }
        case
    }

    /// A value of one joint, `right`: a multiple of 90 degrees, or of a slide one of its ends.
    fn joint<T: Scalar>(&mut self, [low, high]: [T; 2], kind: JointKind, right: bool) -> T {
        let low = if low.is_finite() { low } else { -T::PI };
        let high = if high.is_finite() { high } else { T::PI };
        let value = self.random.between(low, high);
        match (right, kind) {
            (false, _) => value,
            (true, JointKind::Revolute) => (value / T::FRAC_PI_2).round_ties_even() * T::FRAC_PI_2,
            (true, _) => low,
        }
    }

    /// 10 to the power `first` + n, n below `count`.
    fn power<T: Scalar>(&mut self, first: i32, count: u32) -> T {
        let mut power = T::ONE;
        for _ in 0..first.unsigned_abs() {
            power *= T::from_f64(if first < 0 { 0.1 } else { 10.0 });
        }
        for _ in 0..self.random.below(count) {
            power *= T::from_f64(10.0);
        }
        power
    }

    /// Away from the base's origin until the arm ends, found by halving; then just inside, or on.
    fn out_of_reach<S, T, const N: usize>(&mut self, arm: &S, target: S::Target) -> S::Target
    where
        S: Subject<T, N>,
        S::Target: Aim<T>,
        T: Scalar,
    {
        let reached = |factor| !matches!(S::status(&arm.inverse(&target.pushed(factor))), Status::Unreachable { .. });
        let (mut inside, mut outside) = (T::ONE, T::from_f64(16.0));
        for _ in 0..20 {
            let middle = (inside + outside) * T::HALF;
            if reached(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        match self.random.below(8) {
            0 => target.pushed(inside),
            _ => target.pushed(outside * (T::ONE + self.power(-6, 8))),
        }
    }

    /// Any bits in one number of the target, in all of them, or in a joint value and the reference.
    fn absurd<T: Scalar, G: Aim<T>, const N: usize>(&mut self, case: &mut Case<T, G, N>) {
        let random = &mut self.random;
        let odds = 1 << random.below(4);
        match random.below(4) {
            0 => {
                let joint = random.below(N as u32) as usize;
                for q in [&mut case.q, &mut case.qd, &mut case.qdd, &mut case.q_ref, &mut case.motor] {
                    if let Some(q) = q.get_mut(joint) {
                        *q = random.any();
                    }
                }
            }
            1 => case.target = case.target.changed(&mut |x| x * T::from_f64(1e3)),
            _ => {
                case.target = case.target.changed(&mut |x| if random.below(odds) == 0 { random.any() } else { x });
                case.pose = case.pose.changed(&mut |x| if random.below(odds) == 0 { random.any() } else { x });
            }
        }
    }
}

/// The target at joint values `q`.
fn aim<S, T, const N: usize>(arm: &S, q: &[T; N], given: usize) -> S::Target
where
    S: Subject<T, N>,
    S::Target: Aim<T>,
    T: Scalar,
{
    let pose = arm.forward(q);
    let given = q.get(given).copied().unwrap_or(T::ZERO);
    let mut best = S::Target::at(&pose, 0, T::ZERO, given);
    let mut missed = arm.residual(q, &best).orientation;
    let angle = missed;
    for candidate in 1..S::Target::CANDIDATES {
        let next = S::Target::at(&pose, candidate, angle, given);
        let by = arm.residual(q, &next).orientation;
        if by < missed {
            (best, missed) = (next, by);
        }
    }
    best
}
