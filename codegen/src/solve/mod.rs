//! The inverse plan: which equations give which joints, in which order.
//!
//! Method (Pieper 1968): a chain of six joints closes cyclically with the target inside. Three consecutive axes that
//! intersect in a point or are parallel leave two equations in two of the other joints. The third one turns one vector
//! onto another; then the triple follows. Structure is decided here, on exact constants, so that scalar equations are
//! left, each with its own kernel. A smaller task closes the same loop, with virtual joints for what it leaves open; a
//! given joint becomes part of its link.
//!
//! One way: `task`, `loop_chain`, `structure` (with `loop_closure`), `plan`, `description`.

mod chain_axes;
mod commuted;
mod deciding_axes;
mod description;
mod generic_samples;
mod held_joint;
mod intersecting_axes;
mod intersection_point;
mod inverse_plan;
pub mod kernel;
mod loop_chain;
mod loop_closure;
mod margins;
mod parallel_axes;
mod plan;
mod planar;
mod prismatic_pair;
mod rank;
mod sides;
mod sinusoid;
mod structure;
mod swivel;
mod task;
mod tasks;
mod three_prismatic;
mod triple;
mod unsupported;

pub use deciding_axes::{AxesRelation, DecidingAxes};
pub use description::describe;
pub use held_joint::{HeldJointPlan, Link, Method, SixJoints};
pub use inverse_plan::InversePlan;
pub use kernel::{Kernel, Unit};
pub use margins::{Factor, margins, naming_table};
pub use plan::{Branching, Plan, PlanStep, Stage};
pub use task::{Given, GivenValues, Goal, Outline, PlanTask, SwivelConstants};
pub use tasks::{Choice, Way, by_the_table, choices, plan, takes_a_choice};
pub use unsupported::Unsupported;
