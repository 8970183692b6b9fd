//! Where the branches of an inverse end.

use std::cell::RefCell;

use denhart::Branch;
use denhart::solve::{BranchState, DefaultValue, Measure};
use denhart_codegen::model::MOST_JOINTS;

use crate::branches::Branches;
use crate::kernel::{AnyRoots, with_roots};

/// The stage without a root that lies farthest along any branch; of several branches that end there the one with the least gap.
#[derive(Debug, Clone, Copy, Default)]
pub struct Trace {
    /// Its place among the stages, and how far its equation is from having a root where that is known.
    pub ended: Option<(usize, Option<f64>)>,
}

impl Trace {
    fn note(&mut self, stage: usize, gap: Option<f64>) {
        let size = |gap: Option<f64>| gap.unwrap_or(f64::INFINITY);
        let is_farther =
            |(before, least): (usize, Option<f64>)| stage > before || stage == before && size(gap) < size(least);
        if self.ended.is_none_or(is_farther) {
            self.ended = Some((stage, gap));
        }
    }
}

/// A search whose branches are traced.
pub struct Traced<'a> {
    pub search: &'a mut dyn Branches,
    pub trace: &'a RefCell<Trace>,
}

impl Branches for Traced<'_> {
    fn default(&self, joint: usize) -> DefaultValue<f64> {
        self.search.default(joint)
    }

    fn virtual_default(&self) -> DefaultValue<f64> {
        self.search.virtual_default()
    }

    fn follow(&mut self, stage: usize, before: &BranchState, roots: &AnyRoots) -> BranchState {
        let after = self.search.follow(stage, before, roots);
        let gap = with_roots!(roots, stage => stage.gap());
        if !before.ended() && (after.ended() || gap.is_none()) {
            self.trace.borrow_mut().note(stage, gap);
        }
        after
    }

    fn agree(&self, state: &BranchState, measure: Measure<f64>, miss: f64) -> BranchState {
        self.search.agree(state, measure, miss)
    }

    fn directed(
        &mut self,
        state: &BranchState,
        measure: Measure<f64>,
        vector: [f64; 3],
        defaults: [DefaultValue<f64>; 2],
    ) -> BranchState {
        self.search.directed(state, measure, vector, defaults)
    }

    fn push(&mut self, state: &BranchState, q: &[f64; MOST_JOINTS], branch: Branch) {
        self.search.push(state, q, branch);
    }
}
