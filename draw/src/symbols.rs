//! Signs of joints: a cylinder about the axis of a revolute joint, a box along that of a sliding one.

use denhart::JointKind;

use crate::picture::{Paint, Picture, Role, Shape};
use crate::skeleton::Skeleton;
use crate::vector::{Flat, Vector, across, add, cross, distance, dot, left_of, length, moved, scaled, sub, unit};
use crate::view::Camera;

/// Radius of a joint's sign, px.
pub const RADIUS: f64 = 9.0;
/// Half the length of a joint's sign along its axis, px.
pub const HALF: f64 = 12.0;
/// Half the width of the box of a sliding joint, px.
const HALF_WIDTH: f64 = 7.5;
/// Signs keep this distance from each other, px.
const APART: f64 = 25.0;
/// An axis that is seen this much shortened points at the viewer or away.
pub const END_ON: f64 = 0.2;

/// The place of each joint's sign on its axis: in the link along the axis where there is one, and clear of the others.
pub fn places(skeleton: &Skeleton, camera: &Camera) -> Vec<Vector> {
    let pixels = |from: Vector, to: Vector| camera.scale * distance(from, to);
    let mut places: Vec<Vector> = Vec::new();
    for (index, joint) in skeleton.joints.iter().enumerate() {
        let along = |from: Vector, to: Vector| {
            unit(sub(to, from)).is_some_and(|direction| length(cross(direction, joint.axis)) < 1e-6)
        };
        let before = skeleton.links.get(index).and_then(|link| match link.as_slice() {
            [.., from, to] => Some((*from, *to)),
            _ => None,
        });
        let after = skeleton.links.get(index + 1).and_then(|link| match link.as_slice() {
            [from, to, ..] if along(*from, *to) => Some((*from, *to)),
            _ => None,
        });
        // A link that comes along the axis, or none, leaves the joint free to stand in the link that follows.
        let turns_here = before.is_some_and(|(from, to)| !along(from, to) && pixels(from, to) > APART);
        let along_link = after.filter(|(from, to)| pixels(*from, *to) > APART);
        let middle =
            along_link.into_iter().flat_map(|(from, to)| [0.5, 0.7, 0.85].map(|part| moved(from, sub(to, from), part)));
        let shift = |pixels: f64| moved(joint.point, joint.axis, pixels / camera.scale);
        let mut candidates = Vec::new();
        if joint.kind == JointKind::Prismatic || turns_here {
            candidates.push(joint.point);
            candidates.extend(middle);
        } else {
            candidates.extend(middle);
            candidates.push(joint.point);
        }
        candidates
            .extend((1..=12).flat_map(|step| [1.0, -1.0].map(|sign| shift(sign * 0.5 * APART * f64::from(step)))));
        let free = |place: &&Vector| places.iter().all(|other| pixels(**place, *other) >= 0.98 * APART);
        places.push(candidates.iter().find(free).or(candidates.first()).copied().unwrap_or(joint.point));
    }
    places
}

/// Draws the sign of a joint.
pub fn joint(picture: &mut Picture, camera: &Camera, kind: JointKind, center: Vector, axis: Vector) {
    match kind {
        JointKind::Prismatic => slider(picture, camera, center, axis),
        _ => cylinder(picture, camera, center, axis),
    }
}

const LINE: f64 = 1.5;

fn cylinder(picture: &mut Picture, camera: &Camera, center: Vector, axis: Vector) {
    let paint = Paint::both(Role::Face, Role::Ink, LINE);
    let flat = camera.direction(axis);
    let shortened = length(flat);
    let toward = dot(axis, camera.toward);
    let place = camera.place(center);
    let Some(direction) = unit(flat).filter(|_| shortened >= END_ON) else {
        picture.circle(place, RADIUS, paint);
        end_on(picture, place, toward > 0.0, 0.62 * RADIUS, Role::Ink);
        return;
    };
    let [near, far] = if toward >= 0.0 { [1.0, -1.0] } else { [-1.0, 1.0] };
    let end = |side: f64| moved(place, flat, side * HALF);
    let side = scaled(left_of(direction), RADIUS);
    let turn = direction[1].atan2(direction[0]).to_degrees();
    let cap = |picture: &mut Picture, at: Flat| {
        if toward.abs() < 0.02 {
            picture.line(&[add(at, side), sub(at, side)], Paint::line(Role::Ink, LINE));
        } else {
            picture.shapes.push(Shape::Ellipse(at, [RADIUS * toward.abs(), RADIUS], turn, paint));
        }
    };
    cap(picture, end(far));
    let corners = [add(end(far), side), add(end(near), side), sub(end(near), side), sub(end(far), side)];
    picture.polygon(&corners, Paint::fill(Role::Face));
    let [a, b, c, d] = corners;
    picture.line(&[a, b], Paint::line(Role::Ink, LINE));
    picture.line(&[c, d], Paint::line(Role::Ink, LINE));
    cap(picture, end(near));
}

/// A dot for an arrow that comes at the viewer, a cross for one that goes away.
pub fn end_on(picture: &mut Picture, [x, y]: Flat, toward: bool, radius: f64, role: Role) {
    if toward {
        picture.circle([x, y], 0.36 * radius, Paint::fill(role));
    } else {
        let r = 0.7 * radius;
        picture.line(&[[x - r, y - r], [x + r, y + r]], Paint::line(role, LINE));
        picture.line(&[[x - r, y + r], [x + r, y - r]], Paint::line(role, LINE));
    }
}

fn slider(picture: &mut Picture, camera: &Camera, center: Vector, axis: Vector) {
    let b = across(axis);
    let c = cross(axis, b);
    let halves = [(axis, HALF), (b, HALF_WIDTH), (c, HALF_WIDTH)]
        .map(|(direction, half)| scaled(direction, half / camera.scale));
    for (index, normal) in halves.iter().enumerate() {
        let facing = dot(*normal, camera.toward);
        let (Some(u), Some(v)) = (halves.get((index + 1) % 3), halves.get((index + 2) % 3)) else { continue };
        // A face that is seen from its edge is no more than a line of its neighbors.
        if facing.abs() < 1e-3 * length(*normal) {
            continue;
        }
        let middle = moved(center, *normal, facing.signum());
        let corner = |i: f64, j: f64| camera.place(moved(moved(middle, *u, i), *v, j));
        let corners = [corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0), corner(-1.0, 1.0)];
        picture.polygon(&corners, Paint::both(Role::Face, Role::Ink, LINE));
    }
    let toward = dot(axis, camera.toward);
    if length(camera.direction(axis)) < END_ON {
        end_on(
            picture,
            camera.place(moved(center, axis, toward.signum() * HALF / camera.scale)),
            toward > 0.0,
            HALF_WIDTH,
            Role::Ink,
        );
    }
}

/// A line with an arrow head at its end.
pub fn arrow(picture: &mut Picture, from: Flat, to: Flat, role: Role, width: f64) {
    let Some(direction) = unit(sub(to, from)) else { return };
    let size = (3.0 + 2.2 * width).min(0.8 * distance(from, to));
    let neck = moved(to, direction, -size);
    let side = scaled(left_of(direction), 0.42 * size);
    picture.line(&[from, moved(to, direction, -0.8 * size)], Paint::line(role, width));
    picture.polygon(&[to, add(neck, side), sub(neck, side)], Paint::fill(role));
}
