//! A Denavit-Hartenberg table, standard convention, for axes given as lines.

use super::axes::{Axes, Axis};
use super::rigid::{ROUNDING, Transform, V, cross, dot, length, rounded, scale, sub, unit};

/// Axes nearer to parallel than this, as the sine of their angle, get a row for the distance and a fixed one for the
/// tilt. Their common normal is far away.
const NEARLY_PARALLEL: f64 = 1e-3;

/// Up to this sine, axes get the same two rows where their common normal is farther away than the arm is long.
const TILTED: f64 = 0.5;

/// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row {
    pub a: f64,
    pub alpha: f64,
    pub d: f64,
    pub theta: f64,
    /// Which axis it is of; none of a fixed row.
    pub axis: Option<usize>,
}

/// `base . rows . tool`
#[derive(Debug, Clone)]
pub struct Table {
    pub base: Transform,
    pub rows: Vec<Row>,
    pub tool: Transform,
    /// The size of the arm, m; not 0.
    pub size: f64,
}

/// The table of the axes.
pub fn table(axes: &Axes) -> Table {
    let points = axes.axes.iter().map(|axis| axis.point).chain([axes.tool.p]);
    let size = points.map(length).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let Some(first) = axes.axes.first() else {
        return Table { base: axes.tool, rows: Vec::new(), tool: Transform::IDENTITY, size };
    };
    let base = base(first);
    let mut frame = base;
    let mut rows = Vec::new();
    let long = arm_length(axes);
    for (index, pair) in axes.axes.windows(2).enumerate() {
        let [here, next] = pair else { continue };
        let pair = between(&frame, here, next, size, long);
        for (fixed, row) in pair.iter().enumerate() {
            frame = frame.then(&constant(row));
            rows.push(Row { axis: (fixed == 0).then_some(index), ..*row });
        }
    }
    let (last, tool) = end(&frame.inverse().then(&axes.tool), size);
    rows.push(Row { axis: Some(axes.axes.len() - 1), ..last });
    Table { base, rows, tool, size }
}

/// The row with its joint at zero.
fn constant(row: &Row) -> Transform {
    let [theta, alpha] = [row.theta, row.alpha].map(rounded);
    Transform::rotate_z(theta.sin(), theta.cos())
        .then(&Transform::shift([row.a, 0.0, row.d]))
        .then(&Transform::rotate_x(alpha.sin(), alpha.cos()))
}

/// A frame with z along the first axis: the base link's own, if that is its z axis.
fn base(first: &Axis) -> Transform {
    let z = first.direction;
    // The point of the line that is next to the origin; a slide is along any line of its direction.
    let p = if first.turns { sub(first.point, scale(z, dot(first.point, z))) } else { [0.0; 3] };
    let own = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let across = own.map(|x| sub(x, scale(z, dot(x, z))));
    let chosen = across.iter().find(|x| length(**x) > 0.8).copied().and_then(unit).unwrap_or([1.0, 0.0, 0.0]);
    Transform::of_columns([chosen, cross(z, chosen), z], p)
}

/// The length of the way from the base by a point of each axis to the tool, m.
fn arm_length(axes: &Axes) -> f64 {
    let points = || axes.axes.iter().map(|axis| axis.point);
    let from = [[0.0; 3]].into_iter().chain(points());
    from.zip(points().chain([axes.tool.p])).map(|(from, to)| length(sub(to, from))).sum()
}

/// The rows from a frame on the axis `here` to a frame on the next, in an arm of length `long`.
fn between(frame: &Transform, here: &Axis, next: &Axis, size: f64, long: f64) -> Vec<Row> {
    let (x, y, z, o) = (frame.axis(0), frame.axis(1), frame.axis(2), frame.p);
    let (w, p) = (next.direction, next.point);
    let normal = cross(z, w);
    let sine = length(normal);
    let from_x = |v: V| dot(v, y).atan2(dot(v, x));
    if sine < NEARLY_PARALLEL {
        return parallel(frame, next, size);
    }
    let normal = scale(normal, 1.0 / sine);
    let apart = sub(p, o);
    let reach = dot(apart, normal);
    let d = dot(cross(apart, w), normal) / sine;
    // A frame may stand anywhere on its joint's axis: how far the normal is from the joint does not depend on it.
    let away = d - dot(sub(here.point, o), z);
    if sine < TILTED && away.abs() > long {
        return parallel(frame, next, size);
    }
    // Either direction of the normal: the one that leaves theta in -90 to 90 degrees, best at 0.
    let (theta, sign) = within_half_turn(from_x(normal));
    let a = if reach.abs() < ROUNDING * size { 0.0 } else { sign * reach };
    vec![Row { a, alpha: sign * sine.atan2(dot(z, w)), d, theta, axis: None }]
}

/// The rows to an axis that is parallel but for a tilt: to where it meets the plane across this one, then the tilt.
fn parallel(frame: &Transform, next: &Axis, size: f64) -> Vec<Row> {
    let (x, y, z, o) = (frame.axis(0), frame.axis(1), frame.axis(2), frame.p);
    let (w, p) = (next.direction, next.point);
    let against = dot(z, w) < 0.0;
    // Where the next axis goes through the plane across this one; a slide is along any line of its direction.
    let apart = if next.turns { sub(p, scale(w, dot(sub(p, o), z) / dot(w, z))) } else { o };
    let apart = sub(apart, o);
    let distance = length(apart);
    let (theta, a) = if distance < ROUNDING * size {
        (0.0, 0.0)
    } else {
        let (theta, sign) = within_half_turn(dot(apart, y).atan2(dot(apart, x)));
        (theta, sign * distance)
    };
    let row = Row { a, alpha: if against { std::f64::consts::PI } else { 0.0 }, d: 0.0, theta, axis: None };
    let there = frame.then(&constant(&row));
    let tilt = cross(there.axis(2), w);
    let sine = length(tilt);
    if sine < ROUNDING {
        return vec![row];
    }
    let theta = dot(tilt, there.axis(1)).atan2(dot(tilt, there.axis(0)));
    vec![row, Row { theta, alpha: sine.atan2(dot(there.axis(2), w)), ..Row::default() }]
}

/// An angle of a line without direction, in -90 to 90 degrees, and -1 where that turned the line round.
fn within_half_turn(angle: f64) -> (f64, f64) {
    use std::f64::consts::{FRAC_PI_2, PI};
    if angle > FRAC_PI_2 + ROUNDING {
        (angle - PI, -1.0)
    } else if angle < -FRAC_PI_2 - ROUNDING {
        (angle + PI, -1.0)
    } else {
        (angle, 1.0)
    }
}

/// The last row and the tool, for the tool link's frame seen from the last axis. A row alone reaches a frame whose x
/// axis meets the joint's axis at a right angle.
fn end(tool: &Transform, size: f64) -> (Row, Transform) {
    let [px, py, d] = tool.p;
    let [x0, x1, x2] = tool.axis(0);
    let level = x2.abs() < ROUNDING;
    // The part of the position across the axis is along x.
    let along = x0 * px + x1 * py;
    let aside = x0 * py - x1 * px;
    if level && aside.abs() < ROUNDING * size {
        let [z0, z1, z2] = tool.axis(2);
        let alpha = (x1 * z0 - x0 * z1).atan2(z2);
        let a = if along.abs() < ROUNDING * size { 0.0 } else { along };
        return (Row { a, alpha, d, theta: x1.atan2(x0), axis: None }, Transform::IDENTITY);
    }
    (Row { d, ..Row::default() }, Transform { p: [px, py, 0.0], ..*tool })
}

impl Table {
    /// The tool's frame, a value for each axis.
    pub fn pose(&self, values: &[f64], turns: &[bool]) -> Transform {
        let rows = self.rows.iter().map(|row| {
            let moved = row.axis.map(|axis| {
                let value = values.get(axis).copied().unwrap_or(0.0);
                if turns.get(axis).copied().unwrap_or(true) {
                    Row { theta: row.theta + value, ..*row }
                } else {
                    Row { d: row.d + value, ..*row }
                }
            });
            constant(&moved.unwrap_or(*row))
        });
        rows.fold(self.base, |pose, row| pose.then(&row)).then(&self.tool)
    }
}

#[cfg(test)]
mod tests {
    use denhart_codegen::model::numeric::scaled;

    use super::super::rigid::{about, difference, of_origin};
    use super::*;

    fn axis(turns: bool, point: V, direction: V) -> Axis {
        let direction = unit(direction).unwrap_or([0.0, 0.0, 1.0]);
        Axis { name: String::new(), turns, point, direction }
    }

    /// `exp(S1 q1) exp(S2 q2) .. T(0)`
    fn product(axes: &Axes, values: &[f64]) -> Transform {
        let motions = axes.axes.iter().zip(values).map(|(axis, value)| {
            if axis.turns {
                let turn = about(axis.direction, *value);
                Transform { p: sub(axis.point, turn.turn(axis.point)), ..turn }
            } else {
                Transform::shift(scale(axis.direction, *value))
            }
        });
        motions.fold(Transform::IDENTITY, |pose, motion| pose.then(&motion)).then(&axes.tool)
    }

    #[test]
    fn a_common_normal_within_the_arm_s_length_is_kept() {
        // The next axis, 0.4 m to the side, leans by 0.3 rad along it; the normal is 0.4 / tan(0.3) = 1.29 m away.
        let lean: f64 = 0.3;
        let axes = |tool: f64| Axes {
            axes: vec![
                axis(true, [0.0; 3], [0.0, 0.0, 1.0]),
                axis(true, [0.4, 0.0, 0.0], [lean.sin(), 0.0, lean.cos()]),
            ],
            tool: Transform::shift([0.4, 0.0, tool]),
        };
        let near = table(&axes(1.0)).rows;
        assert!(near.len() == 2 && near[0].a == 0.0 && (near[0].d + 0.4 / lean.tan()).abs() < 1e-14, "{near:?}");
        let far = table(&axes(0.8)).rows;
        assert!(far.len() == 3 && (far[0].a, far[0].d, far[1].axis) == (0.4, 0.0, None), "{far:?}");
        assert!((far[1].alpha - lean).abs() < 1e-15, "{far:?}");
    }

    #[test]
    fn any_two_axes_in_a_row_come_out_as_they_are() {
        let next = [
            ([0.0, 0.0, 1.0], [0.4, 0.3, 0.2]),
            ([0.0, 0.0, -1.0], [0.4, -0.3, 0.2]),
            ([0.0, 0.0, 1.0], [0.0, 0.0, 0.7]),
            ([1e-5, -2e-6, 1.0], [0.4, 0.3, 0.2]),
            ([0.0, 3e-9, -1.0], [0.4, 0.3, 0.2]),
            ([1.0, 0.0, 0.0], [0.0, 0.0, 0.5]),
            ([1.0, 2.0, -0.5], [0.4, 0.3, 0.2]),
            ([0.0, 0.02, 1.0], [-0.4, 0.3, 0.2]),
            ([0.05, -0.02, -1.0], [0.4, 0.3, 0.2]),
            ([0.2, 0.3, 1.0], [0.4, 0.3, 0.2]),
        ];
        let tools =
            [of_origin([0.1, 0.2, 0.9], [0.2, -0.4, 1.0]), of_origin([0.0, 0.0, 0.3], [0.0; 3]), Transform::IDENTITY];
        for turns in [[true, true, true], [true, false, true], [false, true, true], [false, false, true]] {
            for (direction, point) in next {
                for tool in tools {
                    let [first, second, third] = turns;
                    let axes = Axes {
                        axes: vec![
                            axis(first, [0.1, 0.0, 0.2], [0.0, 0.6, 0.8]),
                            axis(second, scaled([0.3, 0.1, 0.0], point, 1.0), direction),
                            axis(third, [0.5, 0.5, 0.1], [0.0, 0.0, 1.0]),
                        ],
                        tool,
                    };
                    let table = table(&axes);
                    for values in [[0.0; 3], [0.3, -0.7, 1.9], [-2.5, 1.1, 0.4]] {
                        let (position, angle) = difference(&table.pose(&values, &turns), &product(&axes, &values));
                        assert!(position < 1e-13 && angle < 1e-13, "{turns:?} {direction:?}: {position:e}, {angle:e}");
                    }
                    let long = arm_length(&axes);
                    assert!(table.rows.iter().all(|row| row.d.abs() < 2.0 * long), "{direction:?}: {:?}", table.rows);
                }
            }
        }
    }
}
