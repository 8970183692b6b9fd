//! How the inverse of an arm is solved.

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

    /// The plan of stages, where there is one.
    pub fn stages(&self) -> Option<&Plan> {
        match self {
            InversePlan::Stages(plan) => Some(plan),
            InversePlan::HeldJoint(_) => None,
        }
    }
}
