//! The arm constants of the search.

use crate::model::{DEFAULT_TOLERANCE, JointKind, Model};

/// The numbers of the runtime's `ArmConstants`, of the arm with the lengths of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmConstants {
    /// Lower and upper limit of every joint, infinite where there is none.
    pub limits: Vec<[f64; 2]>,
    /// True if any joint has limits.
    pub limited: bool,
    /// Limits of sums of joint values: factors, and the range.
    pub combined: Vec<(Vec<f64>, [f64; 2])>,
    /// How much each joint counts in the distance from a reference.
    pub weights: Vec<f64>,
    /// The prismatic joints.
    pub prismatic: Vec<usize>,
    /// The joint that is named where a virtual one is free.
    pub stands_for: Option<usize>,
    /// The joints whose two roots differ by a wrist flip, see `Plan::flip`.
    pub wrist: Option<[usize; 3]>,
    /// Reach, length unit.
    pub reach: f64,
    /// Position residual up to which a solution is listed, length unit.
    pub length: f64,
    /// Orientation residual up to which a solution is listed, rad.
    pub angle: f64,
}

impl ArmConstants {
    /// Arm constants of an arm without virtual joints and wrist flips.
    pub fn of(model: &Model, reach: f64) -> ArmConstants {
        let joints = || model.joints.iter();
        ArmConstants {
            limits: limits(model),
            limited: joints().any(|joint| joint.limits.is_some()),
            combined: model.combined_limits.iter().map(|limit| (limit.factors.clone(), limit.limits)).collect(),
            weights: model.inverse.weights.clone().unwrap_or_else(|| vec![1.0; model.joints.len()]),
            prismatic: (0..)
                .zip(joints())
                .filter(|(_, joint)| joint.kind == JointKind::Prismatic)
                .map(|(i, _)| i)
                .collect(),
            stands_for: None,
            wrist: None,
            reach,
            length: model.inverse.tolerance_length.unwrap_or(DEFAULT_TOLERANCE * reach),
            angle: model.inverse.tolerance_angle.unwrap_or(DEFAULT_TOLERANCE),
        }
    }
}

/// Lower and upper limit of every joint, infinite where there is none.
pub fn limits(model: &Model) -> Vec<[f64; 2]> {
    model.joints.iter().map(|joint| joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY])).collect()
}
