//! Programs as data: computations in their order, from which code is emitted and which can be run as they are.
//!
//! A program is a list of typed statements over slots. A slot is an expression of the program's [`Graph`]: a leaf that
//! a statement gives a value, or a computation from other slots. Names are for the emitted code alone; nothing here is
//! looked up by name.
//!
//! Two visitors exist: `emit` writes a program as Rust, the crate `denhart-dynamic` evaluates it. Both follow the same
//! statements, so equal programs give equal results.

mod arm_constants;
mod block;
mod call;
mod coupling;
mod function;
mod margins;
mod nest;
mod program;
mod stage;
mod straight;
mod task_motion;
#[cfg(test)]
mod tests;

pub use arm_constants::{ArmConstants, limits};
pub use block::{Block, Names};
pub use call::{Call, Counted, DefaultValue, RootRange};
pub use coupling::{Linear, Linked, linked};
pub use function::{Function, Functions};
pub use margins::{Margins, Plane, Variable, constant, margins};
pub use nest::{held_joint, inverse, stages};
pub use program::{BranchState, Each, Inverse, NestLevel, Root, Statement};
pub use straight::Straight;
pub use task_motion::{TaskMotion, task_motion};

pub use crate::solve::kernel::{self, Kernel, Unit};
pub use crate::solve::{
    Branching, Factor, Given, GivenValues, Goal, HeldJointPlan, Link, Method, SixJoints, SwivelConstants,
};
pub use crate::symbolic::{AngleSum, BoundAngle, Dimension, Expr, Graph, Input, Node, Part};

/// A value of a program: a leaf or an expression of its graph.
pub type Slot = Expr;
