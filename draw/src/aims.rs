//! Places that the tool reaches, its singular curves, and a target.

use crate::canvas::{Canvas, FRAME};
use crate::picture::{Command, Dash, Paint, Role, Shape};
use crate::scene::Scene;
use crate::section::Curves;
use crate::skeleton::column;
use crate::vector::{add, scaled};

/// The region that the tool reaches.
pub fn region(canvas: &mut Canvas, scene: &Scene) {
    let Some(section) = &scene.section else { return };
    let mut commands = Vec::new();
    for line in &section.region {
        let mut points = line.iter().map(|point| canvas.camera.place(*point));
        commands.extend(points.next().map(Command::Move));
        commands.extend(points.map(Command::Line));
        commands.push(Command::Close);
    }
    canvas.picture.shapes.push(Shape::Path(commands, Paint::both(Role::Region, Role::Muted, 0.8)));
    let what = if section.region.is_empty() { "reaches no point of" } else { "shaded: reached within limits in" };
    canvas.notes.push(format!("{what} the {}", section.plane));
}

/// Singular curves, each kind in a color of its own with its name.
pub fn curves(canvas: &mut Canvas, scene: &Scene) {
    let Some(section) = &scene.section else { return };
    for (number, Curves { margin, lines }) in (0..).zip(&section.singular) {
        let role = Role::Solution(number);
        for line in lines {
            canvas.line(line, Paint::line(role, 1.8), 0.3);
        }
        let longest = lines.iter().max_by_key(|line| line.len());
        if let Some(point) = longest.and_then(|line| line.get(line.len() / 3)) {
            canvas.label(canvas.camera.place(*point), 5.0, format!("{margin} singular"), role);
        }
    }
    if !section.singular.is_empty() {
        canvas.notes.push("singular curves: with the joints of the wrist as drawn".to_owned());
    }
}

/// The target, and by how much it is missed.
pub fn aim(canvas: &mut Canvas, scene: &Scene) {
    let Some(target) = scene.target else { return };
    let point = canvas.camera.place(target.translation);
    for (index, (name, role)) in [("x", Role::X), ("y", Role::Y), ("z", Role::Z)].into_iter().enumerate() {
        let end = canvas.axis(target.translation, column(&target, index), 0.9 * FRAME, role);
        canvas.label(end, if end == point { 9.0 } else { 3.0 }, name, role);
    }
    canvas.picture.circle(point, 4.0, Paint::both(Role::Background, Role::Target, 2.0));
    if !canvas.small {
        canvas.label(point, 7.0, "target", Role::Target);
    }
    if let Some(miss) = &scene.miss {
        canvas.line(&[miss.from, miss.to], Paint::line(Role::Target, 1.6).dashed(Dash::Dashed), 0.8);
        let middle = scaled(add(canvas.camera.place(miss.from), canvas.camera.place(miss.to)), 0.5);
        canvas.label(middle, 5.0, miss.text.clone(), Role::Target);
    }
}
