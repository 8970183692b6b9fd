//! The checked chain: a file whose values make sense together.

mod actuator;
pub mod angle;
mod arm;
mod calibration;
pub mod chain;
mod check;
mod combined_limits;
mod coupling;
mod far_frames;
pub mod geometry;
mod joint;
mod joint_names;
pub mod numeric;
mod parameter;
mod plausibility;
pub mod rational;
mod reach;
mod redundant;
#[cfg(test)]
mod tests;
mod weights;

pub use actuator::Actuator;
pub use angle::Angle;
pub use arm::{
    Calibration, DEFAULT_TOLERANCE, FarthestLink, Frame, InverseRequest, MOST_JOINTS, Model, Parameter, Row,
};
pub use check::check;
pub use combined_limits::CombinedLimit;
pub use coupling::Coupling;
pub use joint::{Joint, JointKind, joint_sum};
pub use parameter::Bound;
pub use plausibility::{in_words, plausibility_warnings};
pub use reach::{ReachTerm, Sizes, reach_terms};
pub use redundant::{Redundant, RedundantValue};

pub use crate::spec::{Axis, Convention, Length, LengthUnit, RowKind, Task};
