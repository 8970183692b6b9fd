//! The runtime's search without the numbers of joints and solutions in its type.

use denhart::Branch;
use denhart::solve::{BranchState, DefaultValue, Measure, Search};
use denhart_codegen::model::MOST_JOINTS;

use crate::kernel::{AnyRoots, with_roots};

/// The functions of [`Search`] that a [`Run`](crate::run::Run) calls. A run is compiled once, and not for each pair of
/// numbers of joints and solutions: the crate compiles in two thirds of the time.
pub trait Branches {
    /// The place of a free joint.
    fn default(&self, joint: usize) -> DefaultValue<f64>;
    /// The place of a virtual joint.
    fn virtual_default(&self) -> DefaultValue<f64>;
    /// The state after a stage, which has this place among the stages.
    fn follow(&mut self, stage: usize, before: &BranchState, roots: &AnyRoots) -> BranchState;
    /// The state after an equation without a joint to meet it.
    fn agree(&self, state: &BranchState, measure: Measure<f64>, miss: f64) -> BranchState;
    /// The state after a vector whose direction tells where two joints turn.
    fn directed(
        &mut self,
        state: &BranchState,
        measure: Measure<f64>,
        vector: [f64; 3],
        defaults: [DefaultValue<f64>; 2],
    ) -> BranchState;
    /// Adds a solution. The first entries of `q`, as many as the arm has joints, are its joint values.
    fn push(&mut self, state: &BranchState, q: &[f64; MOST_JOINTS], branch: Branch);
}

impl<const N: usize, const M: usize, const S: usize> Branches for Search<'_, f64, N, M, S> {
    fn default(&self, joint: usize) -> DefaultValue<f64> {
        Search::default(self, joint)
    }

    fn virtual_default(&self) -> DefaultValue<f64> {
        Search::virtual_default(self)
    }

    fn follow(&mut self, _stage: usize, before: &BranchState, roots: &AnyRoots) -> BranchState {
        with_roots!(roots, stage => Search::follow(self, before, stage))
    }

    fn agree(&self, state: &BranchState, measure: Measure<f64>, miss: f64) -> BranchState {
        Search::agree(self, state, measure, [miss])
    }

    fn directed(
        &mut self,
        state: &BranchState,
        measure: Measure<f64>,
        vector: [f64; 3],
        defaults: [DefaultValue<f64>; 2],
    ) -> BranchState {
        Search::directed(self, state, measure, vector, defaults)
    }

    #[inline]
    fn push(&mut self, state: &BranchState, q: &[f64; MOST_JOINTS], branch: Branch) {
        let mut values = [f64::NAN; N];
        for (value, q) in values.iter_mut().zip(q) {
            *value = *q;
        }
        Search::push(self, state, values, branch);
    }
}
