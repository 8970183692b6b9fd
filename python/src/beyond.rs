//! Parts that denhart-dynamic leaves to others: iteration, manipulability, values of a redundant joint.

use std::f64::consts::{PI, TAU};

use denhart::numeric::Task;
use denhart::{Jacobian, Pose};
use denhart_codegen::lower::{Given, Goal};
use denhart_dynamic::{DynamicArm, DynamicJacobian, DynamicTarget};
use denhart_tools::closest::pose_of;

/// A pose that meets a target, and the components of it that count. `None` for `position_angle`, which is no task of the
/// iteration.
pub fn task(arm: &DynamicArm, target: &DynamicTarget) -> Option<(Pose<f64>, Task<f64>)> {
    let task = match target {
        DynamicTarget::Pose(_) => Task::Pose,
        DynamicTarget::Position(_) => Task::POSITION,
        DynamicTarget::PositionAxis(_) => match arm.program().inverse.as_ref().ok()?.goal {
            Goal::PositionAxis { column: 0 } => Task::PositionAxis([1.0, 0.0, 0.0]),
            Goal::PositionAxis { column: 1 } => Task::PositionAxis([0.0, 1.0, 0.0]),
            _ => Task::PositionAxis([0.0, 0.0, 1.0]),
        },
        DynamicTarget::PositionAngle(_) => return None,
        DynamicTarget::PlanarPose(_) => Task::Components([true, true, false, false, false, true]),
        DynamicTarget::PlanarPosition(_) => Task::Components([true, true, false, false, false, false]),
    };
    Some((pose_of(arm, target), task))
}

/// Manipulability over the rows that count, see [`Jacobian::manipulability_of`](denhart::Jacobian::manipulability_of).
pub fn manipulability(rows: &DynamicJacobian, counts: [bool; 6]) -> f64 {
    macro_rules! by_size {
        ($($joints:literal)*) => {
            match rows.first().map_or(0, |row| row.len()) {
                $($joints => {
                    let mut jacobian = Jacobian::<f64, $joints>::zero();
                    for (to, row) in jacobian.rows.iter_mut().flatten().zip(rows.iter().flat_map(|row| row.iter())) {
                        *to = *row;
                    }
                    jacobian.manipulability_of(counts)
                })*
                _ => f64::NAN,
            }
        };
    }
    by_size!(1 2 3 4 5 6 7 8 9 10)
}

/// So many values of the redundant joint, evenly over its limits, or over a turn.
///
/// # Errors
/// The message: no value, or several of them, is free.
pub fn sweep(arm: &DynamicArm, values: usize) -> Result<Vec<f64>, String> {
    let Ok(inverse) = &arm.program().inverse else { return Err("the arm has no inverse in closed form".to_owned()) };
    let [given] = inverse.given.values.as_slice() else {
        let count = inverse.given.values.len();
        return Err(format!("it needs an arm with one redundant joint; the inverse of this one takes {count} values"));
    };
    let limits = match *given {
        Given::Joint { joint, revolute, .. } => {
            let limits = arm.limits().get(joint).copied().unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            match limits.iter().all(|limit| limit.is_finite()) {
                true => Some(limits),
                false if revolute => None,
                false => return Err("the redundant joint slides and has no limits".to_owned()),
            }
        }
        Given::ArmAngle => None,
    };
    // Over a turn the end is the beginning.
    #[allow(clippy::cast_precision_loss)]
    let at = |index: usize, steps: usize| index as f64 / steps.max(1) as f64;
    Ok((0..values)
        .map(|index| match limits {
            Some([low, high]) => low + at(index, values.saturating_sub(1)) * (high - low),
            None => -PI + TAU * at(index + 1, values),
        })
        .collect())
}
