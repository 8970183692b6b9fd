//! Frames and lengths of the table.

use crate::canvas::{Canvas, FRAME};
use crate::labels::{Area, Label, best};
use crate::number::short;
use crate::picture::{Paint, Role};
use crate::scene::Figure;
use crate::skeleton::{Measure, NamedFrame, column};
use crate::symbols::arrow;
use crate::vector::{Flat, Vector, add, distance, dot, left_of, moved, scaled, sub, unit};

/// A length of the table that is drawn shorter than this is told in a note, px.
const SHORTEST: f64 = 10.0;
/// How much labels keep away from each pixel of a dimension line.
const DIMENSION: f64 = 1.5;
/// Distances of a dimension line from its length that are tried, px.
const OFFSETS: [f64; 6] = [20.0, 34.0, 48.0, 64.0, 82.0, 104.0];

/// The tool frame.
pub fn tool(canvas: &mut Canvas, figure: &Figure) {
    let pose = figure.skeleton.tool;
    let point = canvas.camera.place(pose.translation);
    for (index, (name, role)) in [("x", Role::X), ("y", Role::Y), ("z", Role::Z)].into_iter().enumerate() {
        let end = canvas.axis(pose.translation, column(&pose, index), 0.85 * FRAME, role);
        canvas.label(end, if end == point { 8.0 } else { 3.0 }, name, role);
    }
    canvas.picture.circle(point, 3.0, Paint::fill(Role::Ink));
    if !canvas.small {
        canvas.label(point, 5.0, "tool", Role::Ink);
    }
}

/// Frames of the table: x and z of each; axes that lie on each other have one arrow and one label.
pub fn frames(canvas: &mut Canvas, figure: &Figure) {
    let tool = NamedFrame { name: "t".to_owned(), pose: figure.skeleton.tool };
    let mut axes: Vec<(Vector, Vector, usize, Vec<&str>)> = Vec::new();
    let same = 0.5 / canvas.camera.scale;
    for frame in figure.skeleton.frames.iter().chain([&tool]) {
        for index in [0, 2] {
            let (origin, direction) = (frame.pose.translation, column(&frame.pose, index));
            let found = axes.iter_mut().find(|(at, along, other, _)| {
                *other == index && distance(*at, origin) < same && distance(*along, direction) < 1e-3
            });
            match found {
                Some((_, _, _, names)) => names.push(&frame.name),
                None => axes.push((origin, direction, index, vec![&frame.name])),
            }
        }
    }
    for (origin, direction, index, names) in axes {
        let (name, role, pixels) = if index == 0 { ("x", Role::X, FRAME) } else { ("z", Role::Z, 1.15 * FRAME) };
        let end = canvas.axis(origin, direction, pixels, role);
        let start = canvas.camera.place(origin);
        canvas.picture.circle(start, 2.6, Paint::fill(Role::Ink));
        canvas.label(end, if end == start { 9.0 } else { 3.0 }, format!("{name}{}", names.join(",")), role);
    }
    canvas.notes.push("frames: x and z of each, numbered by its row; t: the tool".to_owned());
}

/// Dimension lines, each beside its length: from the dot to the arrow the length is positive.
pub fn dimensions(canvas: &mut Canvas, figure: &Figure, unit_name: &str, bounds: Area) {
    let mut hidden = Vec::new();
    let points: Vec<Flat> = figure.skeleton.points().map(|point| canvas.camera.place(*point)).collect();
    let middle = scaled(points.iter().fold([0.0; 2], |sum, point| add(sum, *point)), 1.0 / points.len().max(1) as f64);
    for measure in &figure.skeleton.measures {
        let Measure { name, value, from, to } = measure;
        let text = format!("{name} {} {unit_name}", short(*value));
        // A negative length leads against its axis: the arrow goes the way of the axis.
        let (from, to) = (canvas.camera.place(*from), canvas.camera.place(*to));
        let Some(direction) = unit(sub(to, from)).filter(|_| distance(from, to) >= SHORTEST) else {
            hidden.push(text);
            continue;
        };
        let side = left_of(direction);
        let center = scaled(add(from, to), 0.5);
        let outward = if dot(sub(center, middle), side) >= 0.0 { 1.0 } else { -1.0 };
        let choice = OFFSETS
            .iter()
            .flat_map(|offset| [(outward * offset, 0.0), (-outward * offset, 8.0)])
            .map(|(offset, extra)| {
                let (a, b) = (moved(from, side, offset), moved(to, side, offset));
                let text = Label {
                    at: scaled(add(a, b), 0.5),
                    clear: 4.0,
                    text: text.clone(),
                    size: canvas.text,
                    role: Role::Measure,
                };
                let line = canvas.obstacles.cost_of_line(a, b);
                canvas.obstacles.line(a, b, DIMENSION);
                let written =
                    best(&text, canvas.font, &canvas.obstacles, bounds, false).map_or(200.0, |(cost, _)| cost);
                canvas.obstacles.without_last_line();
                let outside = if [a, b].iter().all(|end| bounds.holds(&Area::around(*end, 4.0))) { 0.0 } else { 500.0 };
                let cost = line + 0.5 * offset.abs() + extra + written + outside;
                ((cost * 100.0).round(), offset)
            })
            .min_by(|(a, _), (b, _)| a.total_cmp(b));
        let offset = choice.map_or(OFFSETS[0], |(_, offset)| offset);
        let (a, b) = (moved(from, side, offset), moved(to, side, offset));
        for (foot, end) in [(from, a), (to, b)] {
            let beyond = moved(end, side, 4.0 * offset.signum());
            let start = moved(foot, side, 5.0 * offset.signum());
            canvas.picture.line(&[start, beyond], Paint::line(Role::Measure, 0.7));
            canvas.obstacles.line(start, beyond, 0.4);
        }
        arrow(&mut canvas.picture, a, b, Role::Measure, 1.1);
        canvas.picture.circle(a, 2.1, Paint::fill(Role::Measure));
        canvas.obstacles.line(a, b, DIMENSION);
        canvas.label(scaled(add(a, b), 0.5), 4.0, text, Role::Measure);
    }
    if !hidden.is_empty() {
        canvas.notes.push(format!("too short to be seen here: {}", hidden.join("; ")));
    }
}
