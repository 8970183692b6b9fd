//! How the inverse of an arm is solved.

use super::deciding_axes::DecidingAxes;
use super::held_joint::HeldJointPlan;
use super::plan::Plan;
use super::task::Outline;

/// How the inverse of an arm is solved.
#[derive(Debug, Clone)]
pub enum InversePlan {
    /// Stage by stage, in closed form, around three consecutive axes that meet or are parallel.
    Stages(Box<Plan>),
    /// One joint is held at the real roots of a polynomial; the others follow.
    HeldJoint(Box<HeldJointPlan>),
}

impl InversePlan {
    /// Task, joints, capacity and reach.
    pub fn outline(&self) -> Outline<'_> {
        match self {
            InversePlan::Stages(plan) => plan.outline(),
            InversePlan::HeldJoint(plan) => plan.outline(),
        }
    }

    /// The axes that decide the inverse: the triple of stages, or the pairs of a joint that is held. Empty where the plan
    /// rests on no relation of axes. [`describe`](super::describe) and [`HeldJointPlan::describe`] have their words.
    pub fn deciding_axes(&self) -> Vec<DecidingAxes> {
        match self {
            InversePlan::Stages(plan) => vec![DecidingAxes::of_triple(plan)],
            InversePlan::HeldJoint(plan) => plan.deciding_axes(),
        }
    }

    /// The plan of stages, where there is one.
    pub fn stages(&self) -> Option<&Plan> {
        match self {
            InversePlan::Stages(plan) => Some(plan),
            InversePlan::HeldJoint(_) => None,
        }
    }
}
