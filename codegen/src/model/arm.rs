//! The checked arm: table, joints, frames, and the task of its inverse.

use super::actuator::Actuator;
use super::angle::Angle;
use super::combined_limits::CombinedLimit;
use super::coupling::Coupling;
use super::joint::Joint;
use super::redundant::Redundant;
use crate::error::Location;
use crate::spec::{Axis, Convention, Length, LengthUnit, RowKind, Task};

/// Most moving joints an arm may have.
pub const MOST_JOINTS: usize = 10;

/// A checked arm. Lengths are in `length_unit`, joints count from 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Free text, not empty.
    pub name: String,
    /// The leading comment lines of the file.
    pub source: Option<String>,
    /// Which frame a row belongs to.
    pub convention: Convention,
    /// The unit of all lengths.
    pub length_unit: LengthUnit,
    /// All rows, the fixed ones too.
    pub rows: Vec<Row>,
    /// The constant frame before the first row.
    pub base: Frame,
    /// The constant frame after the last row.
    pub tool: Frame,
    /// The moving joints in order, 1 to [`MOST_JOINTS`].
    pub joints: Vec<Joint>,
    /// The names for lengths, in the order of the file.
    pub parameters: Vec<Parameter>,
    /// How far the arm is from its table, where it was measured. The rows are those of the arm that was measured.
    pub calibration: Option<Calibration>,
    /// The task of the inverse, and what belongs to it.
    pub inverse: InverseRequest,
    /// How motors move joints, where they are linked.
    pub coupling: Option<Coupling>,
    /// Ranges of sums of joint values.
    pub combined_limits: Vec<CombinedLimit>,
    /// Pulse scales and zero positions of the motors, one for each joint, where the file has them.
    pub actuators: Option<Vec<Actuator>>,
}

/// How far the links of the calibrated arm are from those of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The joint from 0 and the numbers that are added to its row: a, alpha, d, theta, in the file's length unit and in rad.
    pub deltas: Vec<(usize, [f64; 4])>,
    /// The largest displacement of a link, in the file's length unit.
    pub displaced: f64,
    /// The largest turn of a link, rad.
    pub turned: f64,
    /// The link that is most off its table.
    pub farthest: FarthestLink,
    /// The rows of the table alone.
    pub table: Vec<Row>,
}

/// The link of a measured arm that is most off its table, as a share of what is accepted.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FarthestLink {
    /// The joint before the link, from 0.
    pub joint: usize,
    /// 1 is the most that is accepted.
    pub share: f64,
    /// In the file's length unit.
    pub displaced: f64,
    /// In rad.
    pub turned: f64,
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Kind of the row's joint.
    pub kind: RowKind,
    /// Length.
    pub a: Length,
    /// Angle between the axes.
    pub alpha: Angle,
    /// Length; the joint's offset where it is prismatic.
    pub d: Length,
    /// Angle; the joint's offset where it is revolute.
    pub theta: Angle,
    /// The name in the file, if there is one.
    pub name: Option<String>,
    /// The index of the row's joint in [`Model::joints`]; `None` for a fixed row.
    pub joint: Option<usize>,
}

/// A constant frame: translation `xyz`, rotation `Rz(yaw) Ry(pitch) Rx(roll)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Length.
    pub xyz: [Length; 3],
    /// Roll, pitch, yaw.
    pub rpy: [Angle; 3],
}

/// A name for lengths of the arm.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its name, also that of the field that binds it.
    pub name: String,
    /// Its value in the file, length unit.
    pub default: f64,
}

/// The task of the inverse, and what belongs to it.
#[derive(Debug, Clone, PartialEq)]
pub struct InverseRequest {
    /// The task, where one is named.
    pub task: Option<Task>,
    /// True if an arm without an inverse is a mistake.
    pub require: bool,
    /// Values that are given beside the target.
    pub redundant: Redundant,
    /// The tool's axis for [`Task::PositionAxis`], where one is named.
    pub axis: Option<Axis>,
    /// Greatest position residual of an exact solution, length.
    pub tolerance_length: Option<f64>,
    /// Greatest orientation residual of an exact solution, rad.
    pub tolerance_angle: Option<f64>,
    /// How much each joint counts in the distance from a reference; `None` if all count the same.
    pub weights: Option<Vec<f64>>,
    /// Where a list at `redundant` stands in the file; else `inverse.task`, or `inverse`.
    pub at: Option<Location>,
    /// True if the file has `inverse` at all.
    pub present: bool,
}

/// Largest residual of a listed solution where the file names none: of a position relative to the reach, of an
/// orientation in rad.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;
