//! The picture while it is painted.

use crate::font::Font;
use crate::labels::{Area, Label, Obstacles};
use crate::picture::{Paint, Picture, Role};
use crate::symbols::{END_ON, arrow, end_on};
use crate::vector::{Flat, Vector, dot, length, moved};
use crate::view::Camera;

/// Length of the axes of a frame, px.
pub const FRAME: f64 = 34.0;

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
    pub fn axis(&mut self, from: Vector, direction: Vector, pixels: f64, role: Role) -> Flat {
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
