//! The kernels that generated inverse kinematics calls.
//!
//! A generated `inverse` is a cascade of stages. Each stage is one scalar equation, or two equations in two joints,
//! solved in closed form by one of the kernels here. A stage has at most two roots, [`aim`] three, the three kernels of
//! pairs four. The next stage is solved for each of them. No kernel divides by something that vanishes at an ordinary
//! pose. No kernel uses `acos` or `asin`: an angle is never taken from its stationary component.
//!
//! | kernel | equation |
//! |---|---|
//! | [`offset`] | `a cos + b sin = d` |
//! | [`offset_of_two`] | the same twice, for arms with fewer freedoms than a pose |
//! | [`distance`] | two points on links, one turned about an axis, are a given distance apart |
//! | [`cone`] | a direction or point, turned about an axis, has a given component along another axis |
//! | [`align`] | turn one plane vector onto another |
//! | [`flip`], [`wrist`] | an orthogonal pair or triple of axes: two roots half a turn apart |
//! | [`slide`], [`slide_to`], [`quadratic`] | a sliding joint reaches a given distance |
//! | [`slide_turning`] | the same and an angle, from two components across another slide |
//! | [`aim`] | one direction seen over a sliding joint |
//! | [`pair`], [`pair_turning`], [`pair_sliding`] | two equations in two joints no other kernel separates (quartic) |
//!
//! [`Search`] follows the branches and collects the solutions. A doubtful solution, near a singularity or at the edge
//! of reach, gets an evaluation of the arm. If needed, the solution also gets a few damped least-squares steps.

#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "a value that is not a number must take the safe branch")]

mod arm_constants;
mod damped_step;
mod doubts;
mod drift;
mod flip;
mod folds;
mod goal;
mod held_joint;
mod kernel;
mod least_squares;
mod locked;
mod measured;
mod retry;
mod search;
mod select;
mod smallest_pivot;
mod verify;

#[cfg(feature = "batch")]
pub use kernel::{
    align::align_lanes,
    cone::cone_lanes,
    distance::distance_lanes,
    lanes::{LaneMeasure, LaneRoots},
    offset::offset_lanes,
    offset_of_two::offset_of_two_lanes,
    slide::{slide_lanes, slide_to_lanes},
    wrist::{flip_lanes, wrist_lanes},
};

pub use arm_constants::{ArmConstants, Evaluate};
pub(crate) use drift::as_rotation;
pub use drift::nearest_rotation;
pub use goal::{Goal, InPlane, Pointing};
pub use held_joint::HeldJointSearch;
pub use kernel::aim::{Sight, aim};
pub use kernel::align::align;
pub use kernel::branch_state::BranchState;
pub use kernel::cone::{Cone, cone};
pub use kernel::distance::{Elbow, distance};
pub use kernel::offset::offset;
pub use kernel::offset_of_two::offset_of_two;
pub use kernel::pair::{pair, pair_turning};
pub use kernel::pair_sliding::pair_sliding;
pub use kernel::roots::{Measure, Roots};
pub use kernel::slide::{quadratic, slide, slide_to};
pub use kernel::slide_turning::slide_turning;
pub use kernel::steps::{grid, steps};
pub use kernel::swivel::{Swivel, swivel};
pub use kernel::tolerances::Tolerances;
pub use kernel::turn::{DefaultValue, Turn};
pub use kernel::wrist::{flip, wrist};
pub use locked::{AllLocked, Locked};
pub use search::{MOST_DOUBTS, Search};
pub use select::{Every, Select};

pub use crate::effort::MOST_CASCADES;
pub use crate::math::wrap;
