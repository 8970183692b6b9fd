//! All branches of one inverse, of an arm known at run time.

use std::ops::Deref;

use denhart::{Branch, Flags, JointMask, Residual, Solution, Solutions, Status};

use crate::Joints;

/// One joint vector that answers a target: [`Solution`] without the number of joints in its type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicSolution {
    /// Joint values: rad for revolute joints, the length unit for prismatic ones.
    pub q: Joints,
    /// Facts about the solution: exact or approximate, singular, outside the limits.
    pub flags: Flags,
    /// The joints whose value the solver chose because the target does not determine it.
    pub free: JointMask,
    /// The branch that the solution lies on.
    pub branch: Branch,
    /// Error of the solution against the target; zero for a solution that the closed form gives to rounding.
    pub residual: Residual<f64>,
}

impl DynamicSolution {
    /// Returns true if the solution reaches the target up to rounding.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.flags.contains(Flags::EXACT)
    }

    /// Returns true if every joint is within the arm's limits.
    #[must_use]
    pub const fn is_within_limits(&self) -> bool {
        !self.flags.contains(Flags::OUT_OF_LIMITS)
    }
}

impl<const N: usize> From<&Solution<f64, N>> for DynamicSolution {
    fn from(solution: &Solution<f64, N>) -> Self {
        let Solution { q, flags, free, branch, residual } = *solution;
        DynamicSolution { q: Joints::new(q), flags, free, branch, residual }
    }
}

/// The solutions of one call and its status; derefs to a slice. The order is that of [`Solutions`].
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicSolutions {
    solutions: Vec<DynamicSolution>,
    status: Status<f64>,
    deviation: f64,
    is_complete: bool,
}

impl DynamicSolutions {
    /// Returns false if further solutions may exist, see [`Solutions::is_complete`].
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Outcome of the call.
    #[must_use]
    pub const fn status(&self) -> Status<f64> {
        self.status
    }

    /// Deviation of the target's matrix from a rotation, see [`Solutions::deviation`].
    #[must_use]
    pub const fn deviation(&self) -> f64 {
        self.deviation
    }

    /// Takes the solutions of a call in place of its own.
    pub(crate) fn set<const N: usize, const M: usize>(&mut self, solutions: &Solutions<f64, N, M>) {
        self.solutions.clear();
        self.solutions.extend(solutions.iter().map(DynamicSolution::from));
        (self.status, self.deviation) = (solutions.status(), solutions.deviation());
        self.is_complete = solutions.is_complete();
    }

    /// The solutions with every joint within the arm's limits.
    pub fn within_limits(&self) -> impl Iterator<Item = &DynamicSolution> {
        self.solutions.iter().filter(|solution| solution.is_within_limits())
    }
}

/// An empty list, for [`inverse_into`](crate::DynamicArm::inverse_into). It is the answer to no target.
impl Default for DynamicSolutions {
    fn default() -> Self {
        Self { solutions: Vec::new(), status: Status::BadTarget, deviation: 0.0, is_complete: true }
    }
}

impl Deref for DynamicSolutions {
    type Target = [DynamicSolution];

    fn deref(&self) -> &[DynamicSolution] {
        &self.solutions
    }
}
