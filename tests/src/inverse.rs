//! The inverse functions of an arm under test: generated, or evaluated from its file at run time.

use std::fmt::{self, Debug};

use denhart::{Branch, InverseBranch, InverseKinematics, OneSolution, Residual, Solution, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolution, DynamicSolutions, DynamicTarget};

use crate::effort;
use crate::task::{Asked, Given, Goal, Kind};

/// Result of a call of an inverse.
#[derive(Debug, Clone)]
pub struct Answer<const N: usize> {
    pub solutions: Vec<Solution<f64, N>>,
    pub status: Status<f64>,
}

impl<const N: usize> Answer<N> {
    /// The solutions that claim to reach the target.
    pub fn exact(&self) -> impl Iterator<Item = &Solution<f64, N>> {
        self.solutions.iter().filter(|solution| solution.is_exact())
    }
}

/// One solution a line: joint values, flags, free joints, branch, residual.
impl<const N: usize> fmt::Display for Answer<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} solutions, {:?}", self.solutions.len(), self.status)?;
        for s in &self.solutions {
            write!(f, "\n      {:?} {} {} ({}) {}", s.q, s.flags, s.free, s.branch, s.residual)?;
        }
        Ok(())
    }
}

/// The inverse functions of an arm.
pub trait Inverse<const N: usize>: Send + Sync {
    /// Argument of the functions: the target of the task, and the values of given joints.
    type Target: Debug + Clone;

    /// The part of a goal that the task looks at.
    fn target(&self, goal: &Goal) -> Self::Target;
    /// Every branch.
    fn all(&self, target: &Self::Target) -> Answer<N>;
    /// Every branch next to a reference.
    fn near(&self, target: &Self::Target, q_ref: &[f64; N]) -> Answer<N>;
    /// [`near`](Self::near) and [`all`](Self::all) into one list, one after the other.
    fn kept(&self, target: &Self::Target, q_ref: &[f64; N]) -> [Answer<N>; 2];
    /// The solution on one branch; `None` where branches have no names that last.
    fn branch(&self, target: &Self::Target, branch: Branch) -> Option<OneSolution<f64, N>>;
    /// Residual of a joint vector.
    fn residual(&self, target: &Self::Target, q: &[f64; N]) -> Residual<f64>;
    /// The target at a joint vector.
    fn target_at(&self, q: &[f64; N]) -> Self::Target;
}

/// The functions behind a pointer, so that the rules compile once and not once an arm. Each keeps to the bound on a call.
pub(crate) trait Solver<const N: usize>: Send + Sync {
    fn inverse(&self, goal: &Goal) -> Answer<N>;
    fn inverse_near(&self, goal: &Goal, q_ref: &[f64; N]) -> Answer<N>;
}

impl<I: Inverse<N>, const N: usize> Solver<N> for I {
    fn inverse(&self, goal: &Goal) -> Answer<N> {
        let target = self.target(goal);
        effort::bounded(|| self.all(&target))
    }

    fn inverse_near(&self, goal: &Goal, q_ref: &[f64; N]) -> Answer<N> {
        let target = self.target(goal);
        effort::bounded(|| self.near(&target, q_ref))
    }
}

/// The function `inverse_branch` of an arm `A`.
pub type OneBranch<A, const N: usize> =
    fn(&A, &<A as InverseKinematics<f64, N>>::Target, Branch) -> OneSolution<f64, N>;

/// An arm whose branches have names: preferred to [`Unnamed`] by [`branch_of`](crate::branch_of).
pub trait Named<const N: usize>: InverseBranch<f64, N> + Sized {
    fn one_branch(&self) -> Option<OneBranch<Self, N>> {
        Some(Self::inverse_branch)
    }
}

impl<A: InverseBranch<f64, N>, const N: usize> Named<N> for A {}

/// An arm whose solutions have numbers.
pub trait Unnamed<const N: usize> {
    type Arm: InverseKinematics<f64, N>;

    fn one_branch(&self) -> Option<OneBranch<Self::Arm, N>> {
        None
    }
}

impl<A: InverseKinematics<f64, N>, const N: usize> Unnamed<N> for &A {
    type Arm = A;
}

/// The function `inverse_branch` of an arm by its type, where it has one.
#[macro_export]
macro_rules! branch_of {
    ($Type:ty) => {{
        #[allow(unused_imports)]
        use $crate::inverse::{Named as _, Unnamed as _};
        (&<$Type>::default()).one_branch()
    }};
}

/// The generated inverse of the arm `A`.
pub struct Derived<A: InverseKinematics<f64, N>, const N: usize> {
    pub arm: A,
    pub kind: Kind,
    pub one_branch: Option<OneBranch<A, N>>,
}

impl<A, const N: usize> Inverse<N> for Derived<A, N>
where
    A: InverseKinematics<f64, N, Target: Asked> + Send + Sync,
{
    type Target = A::Target;

    fn target(&self, goal: &Goal) -> A::Target {
        A::Target::of(self.kind, goal)
    }

    fn all(&self, target: &A::Target) -> Answer<N> {
        listed::<A, N>(&self.arm.inverse(target))
    }

    fn near(&self, target: &A::Target, q_ref: &[f64; N]) -> Answer<N> {
        listed::<A, N>(&self.arm.inverse_near(target, q_ref))
    }

    fn kept(&self, target: &A::Target, q_ref: &[f64; N]) -> [Answer<N>; 2] {
        // The list holds an answer already.
        let mut solutions = self.arm.inverse(target);
        self.arm.inverse_near_into(target, q_ref, &mut solutions);
        let near = listed::<A, N>(&solutions);
        self.arm.inverse_into(target, &mut solutions);
        [near, listed::<A, N>(&solutions)]
    }

    fn branch(&self, target: &A::Target, branch: Branch) -> Option<OneSolution<f64, N>> {
        self.one_branch.map(|one| one(&self.arm, target, branch))
    }

    fn residual(&self, target: &A::Target, q: &[f64; N]) -> Residual<f64> {
        self.arm.residual(q, target)
    }

    fn target_at(&self, q: &[f64; N]) -> A::Target {
        self.arm.target_at(q)
    }
}

fn listed<A: InverseKinematics<f64, N>, const N: usize>(solutions: &A::Solutions) -> Answer<N> {
    Answer { solutions: solutions.as_ref().to_vec(), status: A::status(solutions) }
}

/// The inverse of an arm that is evaluated.
#[derive(Debug)]
pub struct Evaluated {
    arm: DynamicArm,
    kind: Kind,
}

/// Argument of an evaluated inverse: the target, and the given values.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    pub target: DynamicTarget,
    pub given: Given<f64>,
}

impl Evaluated {
    /// The inverse of `arm`, which has one.
    pub fn new(arm: DynamicArm, kind: Kind) -> Result<Self, DynamicError> {
        arm.given()?;
        Ok(Self { arm, kind })
    }
}

/// An answer of the arm, which has `N` joints and the task that is asked for.
fn answer<const N: usize>(solutions: Result<DynamicSolutions, DynamicError>) -> Answer<N> {
    let solutions = solutions.expect("a target of the arm's task, and a number for each joint");
    Answer { solutions: solutions.iter().map(sized).collect(), status: solutions.status() }
}

fn sized<const N: usize>(solution: &DynamicSolution) -> Solution<f64, N> {
    let DynamicSolution { q, flags, free, branch, residual } = *solution;
    let q = <[f64; N]>::try_from(&*q).expect("a value a joint");
    Solution { q, flags, free, branch, residual }
}

impl<const N: usize> Inverse<N> for Evaluated {
    type Target = Request;

    fn target(&self, goal: &Goal) -> Request {
        Request { target: DynamicTarget::of(self.kind, goal), given: goal.given }
    }

    fn all(&self, Request { target, given }: &Request) -> Answer<N> {
        answer(self.arm.inverse(target, given.as_slice()))
    }

    /// As the trait of generated arms has it, the reference says where the given joint is.
    fn near(&self, Request { target, .. }: &Request, q_ref: &[f64; N]) -> Answer<N> {
        answer(self.arm.inverse_near(target, q_ref))
    }

    /// This arm has no list of fixed capacity to keep.
    fn kept(&self, request: &Request, q_ref: &[f64; N]) -> [Answer<N>; 2] {
        [self.near(request, q_ref), self.all(request)]
    }

    fn branch(&self, Request { target, given }: &Request, branch: Branch) -> Option<OneSolution<f64, N>> {
        let one = self.arm.inverse_branch(target, given.as_slice(), branch).ok()?;
        Some(one.map(|solution| sized(&solution)))
    }

    fn residual(&self, Request { target, .. }: &Request, q: &[f64; N]) -> Residual<f64> {
        self.arm.residual(q, target).expect("as above")
    }

    fn target_at(&self, q: &[f64; N]) -> Request {
        let target = self.arm.target_at(q).expect("a number for each joint");
        Request { target, given: Given::of(self.arm.held(q).expect("as above"), 0.0) }
    }
}
