//! Many poses at a time, at the speed of the vector unit.
//!
//! A target that is ordinary takes the same operations as every other one, so that several targets fit into the lanes
//! of a vector register. A target near a singularity, at the edge of reach, drifted or not finite puts its lane in
//! doubt, and goes to the ordinary inverse. Either way the results have the bits of single calls.
//!
//! Nothing here takes a thread: split the slices.

mod arm;
mod branches;
mod drivers;
mod found;
mod left_out;
mod nearest;
mod ordinary;
mod rows;

pub use denhart_core::lanes::{BLOCK, InstructionSet, Lanes, Row, Work};

pub use crate::limits::within_lanes;
pub use crate::math::lanes as math;
pub use crate::solve::{
    LaneMeasure, LaneRoots, align_lanes, cone_lanes, distance_lanes, flip_lanes, offset_lanes, offset_of_two_lanes,
    slide_lanes, slide_to_lanes, wrist_lanes,
};
pub use crate::windings::step_lanes;
pub use arm::{BatchArm, BatchInverse};
pub use branches::Branches;
pub use drivers::{
    Lengths, forward, forward_and_jacobian, forward_and_jacobian_with, forward_with, inverse, inverse_with,
};
pub use found::{Found, MOST_SOLUTIONS, Summary};
pub use left_out::LeftOut;
pub use nearest::{inverse_near, inverse_near_with};
pub use ordinary::{FAR, ordinary};
