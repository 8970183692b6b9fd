//! Solutions side by side, each in its color. Where several lie on each other all colors are seen, the first one widest.

use crate::canvas::Canvas;
use crate::labels::Area;
use crate::picture::{Dash, Paint, Role};
use crate::scene::{Figure, Scene};
use crate::vector::{Flat, distance, off_line};

/// Width of a solution's link that lies alone, and by how much it grows for each one that lies on it, px.
const ALONE: f64 = 3.2;
const WIDER: f64 = 2.8;
/// Corners closer than this in the picture are one, px.
const SAME: f64 = 0.7;

/// The color of a solution, by its number from 1.
pub fn role(number: usize) -> Role {
    Role::Solution(u8::try_from(number.saturating_sub(1) % 8).unwrap_or(0))
}

struct Line<'a> {
    from: Flat,
    to: Flat,
    figure: &'a Figure,
    number: usize,
}

/// Draws all solutions of a scene.
pub fn solutions(canvas: &mut Canvas, scene: &Scene) {
    let mut lines: Vec<Line> = Vec::new();
    let numbered = scene.figures.iter().filter_map(|figure| Some((figure, figure.solution?)));
    for (figure, number) in numbered.clone() {
        for link in &figure.skeleton.links {
            let flat: Vec<Flat> = link.iter().map(|point| canvas.camera.place(*point)).collect();
            for (from, to) in flat.iter().zip(flat.iter().skip(1)).filter(|(from, to)| distance(**from, **to) > SAME) {
                lines.push(Line { from: *from, to: *to, figure, number });
            }
        }
    }
    let same = |a: &Line, b: &Line| {
        let ends = |p: Flat, q: Flat| distance(a.from, p) < SAME && distance(a.to, q) < SAME;
        ends(b.from, b.to) || ends(b.to, b.from)
    };
    let count = numbered.clone().count();
    for (index, line) in lines.iter().enumerate() {
        // A link that no solution moves has no color.
        if count > 1 && lines.iter().filter(|other| same(line, other)).count() == count {
            canvas.picture.line(&[line.from, line.to], Paint::line(Role::Link, 5.0));
            canvas.obstacles.line(line.from, line.to, 0.5);
            continue;
        }
        // Those drawn later on the same place leave a rim of this one.
        let above = lines.iter().skip(index + 1).filter(|other| same(line, other)).count();
        let width = ALONE + WIDER * above.min(8) as f64;
        let dash = if line.figure.out_of_limits { Dash::Dashed } else { Dash::Solid };
        canvas.picture.line(&[line.from, line.to], Paint::line(role(line.number), width).dashed(dash));
        canvas.obstacles.line(line.from, line.to, 0.5);
    }
    let mut marked: Vec<Flat> = Vec::new();
    for (figure, number) in numbered.clone() {
        for joint in &figure.skeleton.joints {
            let at = canvas.camera.place(joint.point);
            if marked.iter().any(|other| distance(*other, at) < SAME) {
                continue;
            }
            marked.push(at);
            let paint = Paint::both(Role::Background, role(number), 1.8);
            if joint.kind == denhart::JointKind::Prismatic {
                let [x, y] = at;
                let corners = [[x - 4.5, y - 4.5], [x + 4.5, y - 4.5], [x + 4.5, y + 4.5], [x - 4.5, y + 4.5]];
                canvas.picture.polygon(&corners, paint);
            } else {
                canvas.picture.circle(at, 4.2, paint);
            }
            canvas.obstacles.area(Area::around(at, 5.5), 0.8);
        }
    }
    numbers(canvas, &numbered.collect::<Vec<_>>());
}

/// The numbers of the solutions, each where its line is farthest from the others; solutions on one place share a label.
fn numbers(canvas: &mut Canvas, figures: &[(&Figure, usize)]) {
    let corners =
        |figure: &Figure| -> Vec<Flat> { figure.skeleton.points().map(|point| canvas.camera.place(*point)).collect() };
    let all: Vec<(Vec<Flat>, usize)> = figures.iter().map(|(figure, number)| (corners(figure), *number)).collect();
    let mut named: Vec<(Flat, Vec<usize>)> = Vec::new();
    for (own, number) in &all {
        let middles = own.iter().zip(own.iter().skip(1)).map(|([a, b], [c, d])| [0.5 * (a + c), 0.5 * (b + d)]);
        let apart = |point: &Flat| {
            let others = all.iter().filter(|(_, other)| other != number).map(|(corners, _)| corners);
            let lines = others.flat_map(|corners| corners.iter().zip(corners.iter().skip(1)));
            lines.map(|(from, to)| off_line(*point, *from, *to)).filter(|gap| *gap > SAME).fold(1e9, f64::min)
        };
        let shared = |point: &Flat| {
            let on = |corners: &Vec<Flat>| {
                corners.iter().zip(corners.iter().skip(1)).any(|(from, to)| off_line(*point, *from, *to) < SAME)
            };
            all.iter().filter(|(corners, _)| on(corners)).count()
        };
        let candidates = own.iter().copied().chain(middles);
        // On as few others as can be, and away from the rest.
        let best = candidates.map(|point| (apart(&point).min(999.0) - 1000.0 * shared(&point) as f64, point));
        let Some((_, at)) = best.max_by(|(a, _), (b, _)| a.total_cmp(b)) else { continue };
        match named.iter_mut().find(|(other, _)| distance(*other, at) < SAME) {
            Some((_, numbers)) => numbers.push(*number),
            None => named.push((at, vec![*number])),
        }
    }
    for (at, numbers) in named {
        let text: Vec<String> = numbers.iter().map(ToString::to_string).collect();
        let color =
            numbers.first().map_or(Role::Ink, |number| if numbers.len() == 1 { role(*number) } else { Role::Ink });
        // A number reads in ink where its color is pale.
        let color = if matches!(color, Role::Solution(3 | 5 | 6)) { Role::Ink } else { color };
        canvas.label(at, 7.0, text.join(", "), color);
    }
}
