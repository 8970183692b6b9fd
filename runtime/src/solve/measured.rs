//! Measured arms: the stages are those of a table, and the links are a little off it.

use super::arm_constants::ArmConstants;
use super::kernel::branch_state::BranchState;
use super::kernel::tolerances::Tolerances;
use super::search::Search;
use crate::Branch;

/// The reference of a measured arm leads to a solution if the target is no farther from it, relative to reach and in rad: a
/// tick of 10 ms at 10 rad/s.
pub(super) const ONE_TICK: f64 = 0.1;

/// A measured arm misses an equation of its table by at most so many times what one of its links is off: there are seven
/// links.
pub(super) const SLACK: f64 = 8.0;

impl<T: Tolerances, const N: usize, const M: usize, const S: usize> Search<'_, T, N, M, S> {
    /// As [`run`](Self::run) for a measured arm, whose stages are those of its table: every solution is verified. Solutions
    /// beyond folds of the table's arm, and the one that the reference leads to, are looked for. `off`: how far its links
    /// are off the table, relative to reach and in rad. `name` may change the name of each solution: the branch of the table
    /// that leads to a solution may be another than that on which it lies.
    #[inline(always)]
    pub fn run_measured(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        off: T,
        name: impl Fn(&[T; N], &mut Branch),
        nest: impl FnMut(&mut Self, BranchState),
    ) {
        (self.doubt, self.slack) = (true, off);
        self.cascades(nest);
        self.unfold();
        self.finish_measured(constants, near, name);
    }

    /// Lists the solutions of a measured arm to which the stages of its table lead, in one run of the nest. `off`: how far its
    /// links are off the table, relative to reach and in rad. The call goes on with [`run_named`](Self::run_named), where the
    /// arm's own equation has too few digits for some of its roots.
    #[inline(always)]
    pub fn start_from_table(&mut self, off: T, mut nest: impl FnMut(&mut Self, BranchState)) {
        (self.doubt, self.slack) = (true, off);
        crate::effort::cascade();
        nest(self, BranchState::start(true));
        self.retry = None;
    }

    /// Like [`finish`](Self::finish) for a measured arm: the solution that the reference leads to is listed, `name` may
    /// change the name of each, and names that are shared get numbers.
    #[inline]
    pub(super) fn finish_measured(
        &mut self,
        constants: &ArmConstants<'_, T, N>,
        near: Option<&[T; N]>,
        name: impl Fn(&[T; N], &mut Branch),
    ) {
        if let Some(near) = near {
            self.hold(near, T::from_f64(ONE_TICK));
        }
        for solution in self.solutions.as_mut_slice() {
            name(&solution.q, &mut solution.branch);
        }
        self.number_shared();
        if let Some(near) = near {
            self.unwind(near);
        }
        self.conclude(constants);
    }

    /// Returns true for a gap of the table's equations that is too wide for the arm that was measured. That arm reaches what
    /// its table's misses by about as much as its links are off.
    #[cold]
    #[inline(never)]
    pub(super) fn is_beyond_slack(&mut self, gap: T, angular: bool) -> bool {
        let unit = if angular { T::ONE } else { self.constants.reach };
        self.is_nearly_missed |= gap <= self.least_slope() * unit;
        gap > self.slack * T::from_f64(SLACK) * unit
    }

    /// The slope above which a measured arm keeps both solutions of a fold of its table. The fold `slope x + bend x^2 / 2` has
    /// two roots while it is missed by less than `slope^2 / (2 bend)`. The bend is at most about 2, and the miss `SLACK slack`.
    pub(super) fn least_slope(&self) -> T {
        (self.slack * T::from_f64(4.0 * SLACK)).sqrt()
    }
}
