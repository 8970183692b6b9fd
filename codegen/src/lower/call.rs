//! A call of a kernel, as data.

use super::Slot;
use crate::model::Angle;
use crate::solve::{Kernel, Unit};

/// A call of a kernel.
#[derive(Debug, Clone, PartialEq)]
pub struct Call {
    /// The stage, by its place among the plan's stages.
    pub stage: usize,
    /// The joints that it gives, as a report names them: `1`, `v1`.
    pub labels: Vec<String>,
    /// The equation.
    pub kernel: Kernel,
    /// Unit of the equation's numbers.
    pub unit: Unit,
    /// The default values of the joints that it may leave free.
    pub defaults: [DefaultValue; 2],
    /// The range of a distance or a component.
    pub range: RootRange,
    /// Where the angle is counted from.
    pub counted: Counted,
}

/// The value that a joint has if it is free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DefaultValue {
    /// The arm's joint, from 0; `None` for a virtual one.
    pub joint: Option<usize>,
    /// Angle added to the joint value to give the kernel's variable.
    pub shift: Angle,
}

/// The range of a distance or a component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RootRange {
    /// The kernel has none.
    None,
    /// Of a distance, constant.
    Elbow {
        /// The links' lengths.
        links: [f64; 2],
        /// Largest distance.
        max: f64,
        /// Smallest distance.
        min: f64,
    },
    /// Of a component, constant: each end with the component across.
    Cone {
        /// Largest component.
        max: [f64; 2],
        /// Smallest component.
        min: [f64; 2],
    },
    /// A range that a statement before has computed.
    Prepared,
}

/// Where an angle is counted from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Counted {
    /// From 0.
    FromZero,
    /// From half a turn where this is negative.
    TurnedBack(Slot),
    /// From the direction that a statement before has worked out.
    FromPhase,
}
