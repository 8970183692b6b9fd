//! A picture: shapes in the plane, each with the part that its color plays.

use crate::vector::Flat;

/// A step along an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command {
    /// Begins at a point.
    Move(Flat),
    /// A straight line to a point.
    Line(Flat),
    /// A quadratic curve: control point and end.
    Quadratic(Flat, Flat),
    /// Back to the beginning.
    Close,
}

/// The part that a color plays. The theme has the color.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// Behind everything, and in the gaps around texts.
    Background,
    /// Texts and outlines.
    Ink,
    /// Second texts, the ground, thin lines.
    Muted,
    /// Links of an arm alone.
    Link,
    /// Faces of joints.
    Face,
    /// The x axis of a frame.
    X,
    /// The y axis of a frame.
    Y,
    /// The z axis of a frame.
    Z,
    /// Lengths.
    Measure,
    /// A region that the tool reaches.
    Region,
    /// Axes that decide the inverse.
    Deciding,
    /// A target, and by how much it is missed.
    Target,
    /// A solution, by its number from 0; colors repeat after eight.
    Solution(u8),
}

/// Kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dash {
    /// Without gaps.
    #[default]
    Solid,
    /// Dashes: out of limits.
    Dashed,
    /// Dash and dot: an axis.
    Axis,
    /// Short dashes: a thin line beside others.
    Dotted,
}

/// Fill and line of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Paint {
    /// Color of the inside.
    pub fill: Option<Role>,
    /// Color and width of the line, px.
    pub stroke: Option<(Role, f64)>,
    /// Kind of the line.
    pub dash: Dash,
}

impl Paint {
    /// A line.
    pub fn line(role: Role, width: f64) -> Self {
        Paint { stroke: Some((role, width)), ..Paint::default() }
    }

    /// A filled shape.
    pub fn fill(role: Role) -> Self {
        Paint { fill: Some(role), ..Paint::default() }
    }

    /// A filled shape with a line around it.
    pub fn both(fill: Role, line: Role, width: f64) -> Self {
        Paint { fill: Some(fill), stroke: Some((line, width)), dash: Dash::Solid }
    }

    /// This paint with another kind of line.
    pub fn dashed(self, dash: Dash) -> Self {
        Paint { dash, ..self }
    }
}

/// A shape.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// An outline.
    Path(Vec<Command>, Paint),
    /// An ellipse: center, radii, turn of the first radius clockwise as seen, degrees.
    Ellipse(Flat, Flat, f64, Paint),
    /// A text that begins at a point of its line.
    Text(Text),
}

/// A text.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// Beginning of the line that the letters stand on.
    pub at: Flat,
    /// The letters.
    pub text: String,
    /// Font size, px.
    pub size: f64,
    /// Width with the shipped font, px.
    pub width: f64,
    /// Color.
    pub role: Role,
}

/// Shapes, the first one at the back.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width and height, px.
    pub size: Flat,
    /// A sentence for those who do not see the picture.
    pub description: String,
    /// The shapes.
    pub shapes: Vec<Shape>,
}

impl Picture {
    /// A line through points.
    pub fn line(&mut self, points: &[Flat], paint: Paint) {
        let mut commands: Vec<Command> = points.iter().map(|point| Command::Line(*point)).collect();
        if let (Some(first), Some(point)) = (commands.first_mut(), points.first()) {
            *first = Command::Move(*point);
            self.shapes.push(Shape::Path(commands, paint));
        }
    }

    /// A polygon.
    pub fn polygon(&mut self, points: &[Flat], paint: Paint) {
        self.line(points, paint);
        if let Some(Shape::Path(commands, _)) = self.shapes.last_mut().filter(|_| !points.is_empty()) {
            commands.push(Command::Close);
        }
    }

    /// A circle.
    pub fn circle(&mut self, center: Flat, radius: f64, paint: Paint) {
        self.shapes.push(Shape::Ellipse(center, [radius; 2], 0.0, paint));
    }
}
