//! Types shared by the solvers that hold one joint of six: a candidate, its visitor, the bounds.
//!
//! A solver finds the angles of the held joint at which the others can close the chain, and the other five joints at
//! each of them. Every joint vector goes to a visitor, which refines it on the arm's own chain, drops repeats and ends
//! the search when its own bound is reached.

use core::ops::ControlFlow;

use crate::Scalar;

/// The most angles of the held joint at which one cut takes the equation `f(t) = 0` to find its polynomial.
pub const MOST_PLACES: usize = crate::trig_polynomial::MOST_SAMPLES;

/// The most roots of one cut.
pub const MOST_CANDIDATES: usize = crate::trig_polynomial::MOST_ROOTS;

/// A joint vector that may close the chain. Nothing is certain before it is refined and verified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<T> {
    /// Joints in the order of the chain: rad in (-pi, pi] or units of length.
    pub joints: [T; 6],
    /// The number of the held joint's root, counted in the order of the search. Not the number of the solution: a root
    /// may have several or none.
    pub root: u8,
    /// Signs of v and w, true for positive, where the solver is `meet`: of the two square roots of a branch.
    pub signs: Option<(bool, bool)>,
    /// Joints that may take any value here, as bits: bit i for joint i of the chain, 0 for the first.
    pub free: u8,
    /// A root that is double, or nearly so: the joints may be off by more than rounding, or close the chain not at all.
    pub is_doubtful: bool,
}

/// Takes the candidates of a search one by one. `Break` ends the search.
pub type Visitor<'a, T> = dyn FnMut(&Candidate<T>) -> ControlFlow<()> + 'a;

/// The end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// False if a list was full, a bound was reached, or no equation has digits enough at this target, so that solutions
    /// may be missing. A search that the visitor ended is not complete either.
    pub is_complete: bool,
}

impl<T: Scalar> Candidate<T> {
    /// Returns true if every joint is a finite number.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.joints.iter().all(|joint| joint.is_finite())
    }
}
