//! Targets of a batch: rows of numbers.

use denhart::batch::{BLOCK, FAR, Lanes, Row};
use denhart::solve::{Goal, Pointing};
use denhart::{PlanarPose, PointAngle, PointAxis, Pose, math};
use denhart_codegen::lower::{self, Given, Input, Inverse};

use super::rows::first;
use super::run::Run;
use crate::DynamicTarget;
use crate::solver::{component, entry};

/// How many numbers a target of a task is.
pub fn width(goal: &lower::Goal) -> usize {
    match goal {
        lower::Goal::Pose => 12,
        lower::Goal::Position => 3,
        lower::Goal::PositionAxis { .. } => 6,
        lower::Goal::PositionAngle { .. } => 4,
        lower::Goal::PlanarPose => 3,
        lower::Goal::PlanarPosition => 2,
    }
}

/// The target of some numbers; `None` if they are too many or too few.
pub fn target(goal: &lower::Goal, numbers: &[f64]) -> Option<DynamicTarget> {
    Some(match (goal, numbers) {
        (lower::Goal::Pose, &[a, b, c, d, e, f, g, h, i, x, y, z]) => {
            DynamicTarget::Pose(Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] })
        }
        (lower::Goal::Position, &[x, y, z]) => DynamicTarget::Position([x, y, z]),
        (lower::Goal::PositionAxis { .. }, &[x, y, z, u, v, w]) => {
            DynamicTarget::PositionAxis(PointAxis::new([x, y, z], [u, v, w]))
        }
        (lower::Goal::PositionAngle { .. }, &[x, y, z, angle]) => {
            DynamicTarget::PositionAngle(PointAngle::new([x, y, z], angle))
        }
        (lower::Goal::PlanarPose, &[x, y, phi]) => DynamicTarget::PlanarPose(PlanarPose::new(x, y, phi)),
        (lower::Goal::PlanarPosition, &[x, y]) => DynamicTarget::PlanarPosition([x, y]),
        _ => return None,
    })
}

/// Values beside the targets of a block.
pub struct Beside<'a> {
    pub program: &'a Inverse,
    /// Values of a target.
    pub values: &'a dyn Fn(usize, &Given) -> f64,
}

impl Run<'_> {
    /// Puts the targets of a block to their registers. Returns the lanes whose target is ordinary.
    #[inline(always)]
    pub fn read<L: Lanes>(&mut self, set: L::Set, targets: &[f64], width: usize, beside: &Beside<'_>) -> u32 {
        let lanes = targets.len() / width.max(1);
        let mut strokes = Row::all(0.0);
        if !beside.program.given.values.is_empty() {
            given(self, beside, lanes, &mut strokes);
        }
        let ordinary = match &beside.program.goal {
            lower::Goal::Pose => {
                for (lane, numbers) in targets.as_chunks::<12>().0.iter().take(BLOCK).enumerate() {
                    for (column, number) in self.columns.iter_mut().zip(numbers) {
                        if let Some(place) = column.0.get_mut(lane % BLOCK) {
                            *place = *number;
                        }
                    }
                }
                for (register, input) in self.inputs() {
                    let place = match *input {
                        Input::Rotation(row, column) => 3 * row + column,
                        Input::Position(component) => 9 + component,
                        _ => continue,
                    };
                    if let Some(column) = self.columns.get(place) {
                        self.rows.put(*register, column);
                    }
                }
                self.ordinary::<L>(set, &strokes)
            }
            goal => self.others(goal, targets, width, &strokes),
        };
        ordinary & first(lanes)
    }

    /// Targets of smaller tasks, one by one.
    #[inline(never)]
    fn others(&mut self, goal: &lower::Goal, targets: &[f64], width: usize, strokes: &Row) -> u32 {
        let (far, inputs) = (self.reach() * FAR, self.inputs());
        let mut ordinary = 0;
        for (lane, (numbers, strokes)) in targets.chunks_exact(width.max(1)).zip(&strokes.0).enumerate() {
            let Some(target) = target(goal, numbers) else { continue };
            let mut known = |point: &[f64], finite: bool, number: &dyn Fn(Input) -> f64| {
                let size = point.iter().fold(0.0, |size, x| size + x.abs()) + strokes;
                ordinary |= u32::from(finite && size <= far) << lane;
                for (register, input) in inputs {
                    if !matches!(input, Input::Given(_) | Input::SinGiven(_) | Input::CosGiven(_)) {
                        self.rows.set(*register, lane, number(*input));
                    }
                }
            };
            match (&target, goal) {
                (DynamicTarget::Position(point), _) => known(point, true, &|input| component(point, input)),
                (DynamicTarget::PositionAxis(asked), lower::Goal::PositionAxis { column }) => {
                    let pointing = Pointing::new(asked, *column);
                    let frame = pointing.frame();
                    let finite = Goal::<f64, 1>::is_finite(&pointing);
                    known(&asked.point, finite, &|input| entry(&frame, input));
                }
                (DynamicTarget::PositionAngle(asked), _) => {
                    let angle = asked.wrapped().angle;
                    let (sin, cos) = math::sin_cos(angle);
                    known(&asked.point, angle.is_finite(), &|input| match input {
                        Input::Angle => angle,
                        Input::SinAngle => sin,
                        Input::CosAngle => cos,
                        other => component(&asked.point, other),
                    });
                }
                (DynamicTarget::PlanarPose(asked), _) => {
                    let phi = asked.wrapped().phi;
                    let (sin, cos) = math::sin_cos(phi);
                    let point = [asked.x, asked.y];
                    known(&point, phi.is_finite(), &|input| match input {
                        Input::Phi => phi,
                        Input::SinPhi => sin,
                        Input::CosPhi => cos,
                        other => component(&point, other),
                    });
                }
                (DynamicTarget::PlanarPosition(point), _) => known(point, true, &|input| component(point, input)),
                _ => {}
            }
        }
        ordinary
    }
}

/// Values beside the targets of a block, and the sum of the strokes among them; not a number where a value is none.
#[inline(never)]
fn given(run: &mut Run<'_>, beside: &Beside<'_>, lanes: usize, strokes: &mut Row) {
    let inputs = run.inputs();
    for (lane, stroke) in strokes.0.iter_mut().enumerate().take(lanes) {
        for kind in &beside.program.given.values {
            let value = (beside.values)(lane, kind);
            let Given::Joint { joint, revolute } = *kind else { continue };
            *stroke += match (value.is_finite(), revolute) {
                (false, _) => f64::NAN,
                (true, false) => value.abs(),
                (true, true) => 0.0,
            };
            let (sin, cos) = if revolute { math::sin_cos(value) } else { (f64::NAN, f64::NAN) };
            for (register, input) in inputs {
                match *input {
                    Input::Given(of) if of == joint => run.rows.set(*register, lane, value),
                    Input::SinGiven(of) if of == joint => run.rows.set(*register, lane, sin),
                    Input::CosGiven(of) if of == joint => run.rows.set(*register, lane, cos),
                    _ => {}
                }
            }
        }
    }
}
