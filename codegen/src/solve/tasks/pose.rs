//! A pose for six joints.

use crate::model::Model;
use crate::model::geometry::Geometry;
use crate::solve::loop_chain::LoopChain;
use crate::solve::plan::Plan;
use crate::solve::structure;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::{self, Unsupported};

/// The plan of least effort.
///
/// # Errors
/// If no three consecutive joints make a closed form.
pub fn plan(model: &Model, geometry: &Geometry, chain: LoopChain) -> Result<Plan, Unsupported> {
    let task = PlanTask::new(Goal::Pose, chain.given.clone());
    structure::cheapest(&chain, &task)?.ok_or_else(|| unsupported::no_triple(model, geometry))
}
