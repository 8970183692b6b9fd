//! A scene as a picture: the arm alone, with the signs of its joints, frames and lengths.

use denhart::JointKind;

use crate::font::Font;
use crate::furniture::{Frame, footer, header};
use crate::labels::{Area, Label, Obstacles, best, place};
use crate::number::short;
use crate::picture::{Dash, Paint, Picture, Role};
use crate::scene::{Figure, Scene};
use crate::skeleton::{Measure, column};
use crate::solutions::solutions;
use crate::symbols::{END_ON, HALF, RADIUS, arrow, end_on, joint, places};
use crate::vector::{Flat, Vector, add, cross, distance, dot, left_of, length, moved, off_line, scaled, sub, unit};
use crate::view::{Camera, View};

/// Width of a link, px.
const LINK: f64 = 6.5;
/// Length of the axes of a frame, px.
const FRAME: f64 = 34.0;
/// A length of the table that is drawn shorter than this is told in a note, px.
const SHORTEST: f64 = 10.0;
/// How much labels keep away from each pixel of a dimension line.
const DIMENSION: f64 = 1.5;
/// Distances of a dimension line from its length that are tried, px.
const OFFSETS: [f64; 6] = [20.0, 34.0, 48.0, 64.0, 82.0, 104.0];

/// Everything that the parts of a picture share while it is painted.
pub struct Canvas<'a> {
    pub picture: Picture,
    pub camera: Camera,
    pub font: &'a Font,
    pub obstacles: Obstacles,
    pub labels: Vec<Label>,
    pub notes: Vec<String>,
    /// Font size of labels, px.
    pub text: f64,
    /// A picture too small for long names.
    pub small: bool,
}

impl Canvas<'_> {
    /// Adds a label, to be placed at the end.
    pub fn label(&mut self, at: Flat, clear: f64, text: impl Into<String>, role: Role) {
        self.labels.push(Label { at, clear, text: text.into(), size: self.text, role });
    }

    /// A line in space, which labels keep away from.
    pub fn line(&mut self, points: &[Vector], paint: Paint, weight: f64) {
        let points: Vec<Flat> = points.iter().map(|point| self.camera.place(*point)).collect();
        self.picture.line(&points, paint);
        for (from, to) in points.iter().zip(points.iter().skip(1)) {
            self.obstacles.line(*from, *to, weight);
        }
    }

    /// An arrow of a length in pixels along a direction in space: a dot or a cross where it points at the viewer or away.
    fn axis(&mut self, from: Vector, direction: Vector, pixels: f64, role: Role) -> Flat {
        let start = self.camera.place(from);
        let flat = self.camera.direction(direction);
        if length(flat) < END_ON {
            let toward = dot(direction, self.camera.toward) > 0.0;
            self.picture.circle(start, 6.0, Paint::both(Role::Background, role, 1.6));
            end_on(&mut self.picture, start, toward, 6.0, role);
            self.obstacles.area(Area::around(start, 7.0), 1.0);
            return start;
        }
        let end = moved(start, flat, pixels);
        arrow(&mut self.picture, start, end, role, 2.0);
        self.obstacles.line(start, end, 2.5);
        end
    }
}

/// The picture of a scene in a view. `size` is that of the drawing, px; lines of text below make the picture higher.
pub fn picture(scene: &Scene, view: View, size: Flat, font: &Font) -> Picture {
    let frame = Frame::of(size);
    let points = scene.figures.iter().flat_map(|figure| figure.skeleton.points().copied());
    let section = scene.section.iter().flat_map(|section| {
        section.region.iter().chain(section.singular.iter().flat_map(|(_, lines)| lines)).flatten().copied()
    });
    let target = scene.target.iter().map(|pose| pose.translation);
    let camera = Camera::fit(view, points.chain(section).chain(target), frame.inside(scene.dimensions));
    let mut canvas = Canvas {
        picture: Picture { size, description: String::new(), shapes: Vec::new() },
        camera,
        font,
        obstacles: Obstacles::default(),
        labels: Vec::new(),
        notes: scene.notes.clone(),
        text: frame.text,
        small: frame.small,
    };
    region(&mut canvas, scene);
    ground(&mut canvas);
    solutions(&mut canvas, scene);
    for figure in scene.figures.iter().filter(|figure| figure.solution.is_none()) {
        arm(&mut canvas, figure, !scene.frames);
    }
    if let Some(figure) = scene.figures.first() {
        if scene.dimensions {
            dimensions(&mut canvas, figure, &scene.length_unit, frame.bounds());
        }
        if scene.frames {
            frames(&mut canvas, figure);
        } else if figure.solution.is_none() {
            tool(&mut canvas, figure);
        }
        let asked = scene.frames || scene.dimensions;
        if asked && !figure.skeleton.far.is_empty() {
            canvas.notes.push(format!("far outside the picture: {}", figure.skeleton.far.join(", ")));
        }
    }
    curves(&mut canvas, scene);
    aim(&mut canvas, scene);
    let mut lost = Vec::new();
    let Canvas { picture, obstacles, labels, notes, .. } = &mut canvas;
    for label in place(picture, font, labels, obstacles, frame.bounds()) {
        lost.push(label.text);
    }
    if !lost.is_empty() {
        notes.push(format!("no room for: {}", lost.join("; ")));
    }
    header(&mut canvas, scene, view, &frame);
    footer(&mut canvas, scene, view, &frame);
    canvas.picture
}

/// The ground: a plate in the base frame's xy plane, hatched where it is seen from its edge.
fn ground(canvas: &mut Canvas) {
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
        canvas.picture.polygon(&corners, Paint::both(Role::Face, Role::Muted, 1.2));
    }
    canvas.obstacles.area(Area { left, top: middle - 6.0, right: left + 48.0, bottom: middle + 8.0 }, 0.8);
}

/// The arm itself: links, signs of joints with their names, and axes where no frames show them.
fn arm(canvas: &mut Canvas, figure: &Figure, axes: bool) {
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

/// The tool frame.
fn tool(canvas: &mut Canvas, figure: &Figure) {
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
fn frames(canvas: &mut Canvas, figure: &Figure) {
    let tool = crate::skeleton::NamedFrame { name: "t".to_owned(), pose: figure.skeleton.tool };
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
fn dimensions(canvas: &mut Canvas, figure: &Figure, unit_name: &str, bounds: Area) {
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
                let written = best(&text, canvas.font, &canvas.obstacles, bounds).map_or(200.0, |(cost, _)| cost);
                canvas.obstacles.without_last_line();
                let outside = if [a, b].iter().all(|end| bounds.holds(&Area::around(*end, 4.0))) { 0.0 } else { 500.0 };
                let cost = line + 0.5 * offset.abs() + extra + written + outside;
                (cost, offset)
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

/// The region that the tool reaches.
fn region(canvas: &mut Canvas, scene: &Scene) {
    let Some(section) = &scene.section else { return };
    let mut commands = Vec::new();
    for line in &section.region {
        let mut points = line.iter().map(|point| canvas.camera.place(*point));
        commands.extend(points.next().map(crate::picture::Command::Move));
        commands.extend(points.map(crate::picture::Command::Line));
        commands.push(crate::picture::Command::Close);
    }
    canvas.picture.shapes.push(crate::picture::Shape::Path(commands, Paint::both(Role::Region, Role::Muted, 0.8)));
    let what = if section.region.is_empty() { "reaches no point of" } else { "shaded: reached within limits in" };
    canvas.notes.push(format!("{what} the {}", section.plane));
}

/// Singular curves, each kind in a color of its own with its name.
fn curves(canvas: &mut Canvas, scene: &Scene) {
    let Some(section) = &scene.section else { return };
    for (number, (name, lines)) in (0..).zip(&section.singular) {
        let role = Role::Solution(number);
        for line in lines {
            canvas.line(line, Paint::line(role, 1.8), 0.3);
        }
        let longest = lines.iter().max_by_key(|line| line.len());
        if let Some(point) = longest.and_then(|line| line.get(line.len() / 3)) {
            canvas.label(canvas.camera.place(*point), 5.0, format!("{name} singular"), role);
        }
    }
    if !section.singular.is_empty() {
        canvas.notes.push("singular curves: with the joints of the wrist as drawn".to_owned());
    }
}

/// The target, and by how much it is missed.
fn aim(canvas: &mut Canvas, scene: &Scene) {
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
