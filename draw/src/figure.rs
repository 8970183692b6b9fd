//! The arm itself, on its ground.

use denhart::JointKind;

use crate::canvas::Canvas;
use crate::labels::Area;
use crate::picture::{Dash, Paint, Role};
use crate::scene::Figure;
use crate::symbols::{END_ON, HALF, RADIUS, arrow, joint, places};
use crate::vector::{Vector, add, cross, dot, length, moved, off_line, scaled, sub, unit};

/// Width of a link, px.
const LINK: f64 = 6.5;

/// The ground: a plate in the base frame's xy plane, hatched where it is seen from its edge. It hides no section.
pub fn ground(canvas: &mut Canvas, has_section: bool) {
    let half = 24.0 / canvas.camera.scale;
    let corner = |x: f64, y: f64| canvas.camera.place([x * half, y * half, 0.0]);
    let corners = [corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0), corner(-1.0, 1.0)];
    let [left, middle] = [canvas.camera.place([0.0; 3])[0] - 24.0, canvas.camera.place([0.0; 3])[1]];
    let seen = length(canvas.camera.direction([0.0, 0.0, 1.0]));
    if seen > 0.999 {
        canvas.picture.line(&[[left, middle], [left + 48.0, middle]], Paint::line(Role::Muted, 1.8));
        for step in 0..6 {
            let x = left + 8.0 * f64::from(step) + 6.0;
            canvas.picture.line(&[[x, middle], [x - 6.0, middle + 7.0]], Paint::line(Role::Muted, 1.2));
        }
    } else {
        let outline = Paint::line(Role::Muted, 1.2);
        canvas.picture.polygon(&corners, if has_section { outline } else { Paint::both(Role::Face, Role::Muted, 1.2) });
    }
    canvas.obstacles.area(Area { left, top: middle - 6.0, right: left + 48.0, bottom: middle + 8.0 }, 0.8);
}

/// The arm itself: links, signs of joints with their names, and axes where no frames show them.
pub fn arm(canvas: &mut Canvas, figure: &Figure, axes: bool) {
    let skeleton = &figure.skeleton;
    let centers = places(skeleton, &canvas.camera);
    let reach = [HALF + 10.0, HALF + 32.0].map(|pixels| pixels / canvas.camera.scale);
    // Parts at their depth, the far ones first: links, then signs.
    let mut parts: Vec<(f64, Part)> = Vec::new();
    for link in &skeleton.links {
        for (from, to) in link.iter().zip(link.iter().skip(1)) {
            parts.push((canvas.camera.depth(scaled(add(*from, *to), 0.5)), Part::Link(*from, *to)));
        }
    }
    let ends: Vec<(f64, Vector, Vector)> = parts
        .iter()
        .filter_map(|(depth, part)| if let Part::Link(from, to) = part { Some((*depth, *from, *to)) } else { None })
        .collect();
    for (center, joint) in centers.iter().zip(&skeleton.joints) {
        // A sign covers the links that it joins.
        let touch = |point: Vector, from: Vector, to: Vector| {
            off_line(canvas.camera.place(point), canvas.camera.place(from), canvas.camera.place(to)) < 1.0
        };
        let joined = ends.iter().filter(|(_, from, to)| touch(*center, *from, *to));
        let depth = joined.map(|(depth, ..)| *depth).fold(canvas.camera.depth(*center), f64::max);
        // A sign that stands beside its point hangs on a short link.
        parts.push((canvas.camera.depth(*center), Part::Link(joint.point, *center)));
        parts.push((depth + 1e-3 * RADIUS / canvas.camera.scale, Part::Joint(*center, joint.kind, joint.axis)));
        let [back, front] = reach;
        let (from, to) = (moved(*center, joint.axis, -back), moved(*center, joint.axis, front));
        if axes && length(canvas.camera.direction(joint.axis)) >= END_ON {
            canvas.line(&[from, to], Paint::line(Role::Z, 1.1).dashed(Dash::Axis), 0.5);
        }
    }
    parts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    for (_, part) in parts {
        match part {
            Part::Link(from, to) => {
                canvas.line(&[from, to], Paint::line(Role::Link, LINK), 3.0);
            }
            Part::Joint(center, kind, axis) => {
                joint(&mut canvas.picture, &canvas.camera, kind, center, axis);
                emerging(canvas, kind, center, axis, &ends);
                canvas.obstacles.area(Area::around(canvas.camera.place(center), RADIUS + 2.0), 5.0);
            }
        }
    }
    for (number, (center, joint)) in (1..).zip(centers.iter().zip(&skeleton.joints)) {
        let flat = canvas.camera.direction(joint.axis);
        if axes && length(flat) >= END_ON {
            let [_, front] = reach;
            let tip = canvas.camera.place(moved(*center, joint.axis, front));
            let back = canvas.camera.place(moved(*center, joint.axis, 0.6 * front));
            arrow(&mut canvas.picture, back, tip, Role::Z, 1.2);
        }
        let own = format!("q{number}");
        let named = joint.name != own && !canvas.small;
        let text = if named { format!("{own} {}", joint.name) } else { own };
        canvas.label(canvas.camera.place(*center), RADIUS + 4.0, text, Role::Ink);
    }
}

/// The piece of a link that comes out of the near end of a joint's sign.
fn emerging(canvas: &mut Canvas, kind: JointKind, center: Vector, axis: Vector, links: &[(f64, Vector, Vector)]) {
    let toward = dot(axis, canvas.camera.toward);
    let flat = canvas.camera.direction(axis);
    if toward.abs() < 0.02 || length(flat) < END_ON || kind == JointKind::Prismatic {
        return;
    }
    let side = toward.signum();
    let outward = scaled(axis, side);
    // How far a link leads from the sign to its near side, along the axis.
    let leads = |(_, from, to): &(f64, Vector, Vector)| {
        let along = unit(sub(*to, *from)).is_some_and(|link| length(cross(link, axis)) < 1e-6);
        let off = length(cross(sub(*from, center), axis)) * canvas.camera.scale;
        let farthest = dot(sub(*from, center), outward).max(dot(sub(*to, center), outward));
        let nearest = dot(sub(*from, center), outward).min(dot(sub(*to, center), outward));
        (along && off < 1.0 && nearest * canvas.camera.scale < HALF) && farthest * canvas.camera.scale > HALF
    };
    if links.iter().any(leads) {
        let cap = moved(canvas.camera.place(center), flat, side * HALF);
        let end = moved(cap, unit(flat).unwrap_or(flat), side * (RADIUS * toward.abs() + 1.0));
        canvas.picture.line(&[cap, end], Paint::line(Role::Link, LINK));
    }
}

enum Part {
    Link(Vector, Vector),
    Joint(Vector, JointKind, Vector),
}
