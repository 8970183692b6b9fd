//! The solution on one branch.

use crate::math::Scalar;
use crate::{Branch, Flags, OneSolution, Solution, Solutions, Status};

/// What the search of one branch has found. At an awkward pose, where branches meet or a joint is free, it is the
/// solution that the search of all of them lists under that name, so that both always agree.
#[inline]
pub fn one_branch<T: Scalar, const N: usize, const M: usize>(
    branch: Branch,
    alone: &Solutions<T, N, M>,
    all: impl FnOnce() -> Solutions<T, N, M>,
) -> OneSolution<T, N> {
    if alone.is_awkward() { among_all(branch, alone, &all()) } else { alone.first_or_status() }
}

#[cold]
#[inline(never)]
fn among_all<T: Scalar, const N: usize, const M: usize>(
    branch: Branch,
    alone: &Solutions<T, N, M>,
    all: &Solutions<T, N, M>,
) -> OneSolution<T, N> {
    let wanted = |solution: &&Solution<T, N>| solution.branch.is_part_of(branch);
    if let Some(listed) = all.exact().find(wanted).or_else(|| all.as_slice().iter().find(wanted)) {
        return Ok(*listed);
    }
    let found = alone.first_or_status()?;
    if !found.branch.is_part_of(branch) {
        // Found by iteration, whichever branch it is on: this one has none.
        let residual = found.residual.position.max(found.residual.orientation).max(T::EPSILON);
        return Err(Status::Unreachable { residual });
    }
    // It is not listed because it is the same as that of another branch.
    Ok(Solution { flags: found.flags | Flags::BOUNDARY, ..found })
}
