//! The table of an arm as a chain: for what denhart-dynamic leaves to iteration.

use std::f64::consts::{PI, TAU};

use denhart::numeric::{NumericInverse, NumericSolution, Task};
use denhart::{Chain, Convention, DhFrame, DhRow, Jacobian, JointKind, PointAxis, Pose, Residual};
use denhart_codegen::lower::{Given, Goal};
use denhart_codegen::model::{self, Frame, Length, Model, RowKind};
use denhart_dynamic::{DynamicArm, DynamicJacobian, DynamicTarget};

/// Starts and steps of the search for the closest approach.
const RESTARTS: usize = 20;
const STEPS: usize = 300;

/// The chain of a checked arm.
pub fn of(model: &Model) -> Chain {
    let convention = match model.convention {
        model::Convention::Standard => Convention::Standard,
        model::Convention::Modified => Convention::Modified,
    };
    let row = |row: &model::Row| DhRow {
        kind: match row.kind {
            RowKind::Revolute => JointKind::Revolute,
            RowKind::Prismatic => JointKind::Prismatic,
            RowKind::Fixed => JointKind::Fixed,
        },
        a: row.a.default_value(),
        alpha: row.alpha.rad(),
        d: row.d.default_value(),
        theta: row.theta.rad(),
    };
    let rows: Vec<DhRow> = model.rows.iter().map(row).collect();
    let frame = |frame: &Frame| DhFrame {
        xyz: frame.xyz.each_ref().map(Length::default_value),
        rpy: frame.rpy.map(|angle| angle.rad()),
    };
    Chain::new(convention, &rows).with_base(frame(&model.base)).with_tool(frame(&model.tool))
}

/// A pose that meets a target, and the components that count. `None` for `position_angle`: no task of the iteration.
pub fn task(target: &DynamicTarget) -> Option<(Pose<f64>, Task<f64>)> {
    let plane = |x: f64, y: f64, phi: f64| Pose::from_xyz_rpy([x, y, 0.0], [0.0, 0.0, phi]);
    let point = |point: [f64; 3]| Pose { translation: point, ..Pose::identity() };
    Some(match target {
        DynamicTarget::Pose(pose) => (*pose, Task::Pose),
        DynamicTarget::Position(at) => (point(*at), Task::POSITION),
        DynamicTarget::PositionAxis(_) | DynamicTarget::PositionAngle(_) => return None,
        DynamicTarget::PlanarPose(asked) => {
            (plane(asked.x, asked.y, asked.phi), Task::Components([true, true, false, false, false, true]))
        }
        DynamicTarget::PlanarPosition([x, y]) => {
            (plane(*x, *y, 0.0), Task::Components([true, true, false, false, false, false]))
        }
    })
}

/// As [`task`], with the axis of the tool that an arm's task points.
pub fn task_of(target: &DynamicTarget, column: Option<usize>) -> Option<(Pose<f64>, Task<f64>)> {
    match (target, column) {
        (DynamicTarget::PositionAxis(asked), Some(column)) => {
            let axis = [0, 1, 2].map(|index| if index == column { 1.0 } else { 0.0 });
            Some((pointing(asked, column), Task::PositionAxis(axis)))
        }
        _ => task(target),
    }
}

/// A pose whose axis `column` has the asked direction.
fn pointing(asked: &PointAxis<f64>, column: usize) -> Pose<f64> {
    let [u, v, w] = asked.axis;
    let length = u.hypot(v).hypot(w);
    let along = [u / length, v / length, w / length];
    // The axis of the base that is farthest from it gives the other two.
    let least =
        along.iter().map(|x| x.abs()).enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index);
    let other = [0, 1, 2].map(|index| if index == least { 1.0 } else { 0.0 });
    let cross = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
    let side = cross(along, other);
    let [x, y, z] = side;
    let size = x.hypot(y).hypot(z);
    let side = side.map(|x| x / size);
    let third = cross(along, side);
    let columns = match column {
        0 => [along, side, third],
        1 => [third, along, side],
        _ => [side, third, along],
    };
    let rotation = [0, 1, 2].map(|row| columns.map(|column| column.get(row).copied().unwrap_or(f64::NAN)));
    Pose { rotation, translation: asked.point }
}

/// The tool's axis of the task `position_axis` of an arm.
pub fn column(arm: &DynamicArm) -> Option<usize> {
    match arm.program().inverse.as_ref().ok()?.goal {
        Goal::PositionAxis { column } => Some(column),
        _ => None,
    }
}

/// The part of a target that an arm misses.
pub enum Missed {
    /// The tool point comes as close as this, length unit.
    Distance(f64),
    /// The tool point can be there, but not in this direction: this is left.
    Direction(Residual<f64>),
}

/// What of a target the arm misses, by iteration. `None` where none can tell.
pub fn missed(arm: &DynamicArm, target: &DynamicTarget) -> Option<Missed> {
    let (pose, whole) = task_of(target, column(arm))?;
    let chain = of(arm.model());
    let planar = matches!(target, DynamicTarget::PlanarPose(_) | DynamicTarget::PlanarPosition(_));
    let point = Task::Components([true, true, !planar, false, false, false]);
    let solve = |task, start: &[f64]| {
        let numeric = NumericInverse::new().task(task).max_iterations(STEPS).restarts(RESTARTS);
        numeric.solve_chain(&chain, &pose.into(), start, None).ok()
    };
    let at_point: NumericSolution<f64, Vec<f64>> = solve(point, &vec![0.0; arm.joints()])?;
    if !at_point.converged() {
        let distance = at_point.residual.position;
        return distance.is_finite().then_some(Missed::Distance(distance));
    }
    let whole = solve(whole, &at_point.q)?;
    (!whole.converged()).then_some(Missed::Direction(whole.residual))
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
